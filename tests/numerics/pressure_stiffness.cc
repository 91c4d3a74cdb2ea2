// SPDX-License-Identifier: LGPL-2.1-or-later
// What pressure adds to a wall's stiffness shall be symmetric, need no force for a motion or a turn
// of the whole, though stress and volume alone would, and be (n^2 - 1) pi w^2/2 per length of a
// tube whose section moves by w cos n phi without stretch: three times that for an oval, nothing
// for n = 1.
#include "../check.h"
#include "line_from.h"

#include "analysis/substructure/free_pressed_wall.h"
#include "mesh/solid/held_points.h"
#include "mesh/solid/wall_layout.h"

#include <deal.II/dofs/dof_tools.h>

using namespace frictionbeam;

namespace {

std::string pipe(const std::string &route, const unsigned int degree, const unsigned int n_around) {
  return "set Model = solid\nsubsection Material steel\n  set Young's modulus = 2e11\n"
         "  set Poisson's ratio = 0.3\nend\nsubsection Section thin\n"
         "  set Outer diameter = 0.204\n  set Wall = 0.004\nend\nsubsection Pipe line\n"
         "  set Route = " +
         route +
         "\nend\nsubsection Support anchor\n  set Kind = anchor\n  set At = A\nend\n"
         "subsection Load inside\n  set Kind = pressure\n  set Pressure = 1\nend\n"
         "subsection Step one\n  set Loads = inside\nend\nsubsection Solid\n  set Degree = " +
         std::to_string(degree) + "\n  set Cells around = " + std::to_string(n_around) + "\nend\n";
}

/// The wall of a line that nothing holds.
class FreeWall {
public:
  explicit FreeWall(const LineFrom &of)
      : wall(with_held_points(build_pipe_wall(of.scene, of.model.mesh))), scene(body_scene(of)),
        body(scene, wall.mesh) {
    body.distribute();
    PressureStiffness{wall, body, free_pressed_wall(scene, wall)}.assemble(
        [&](const dealii::FullMatrix<double> &matrix, const auto &dofs) {
          parts.emplace_back(matrix, dofs);
        });
  }

  /// S u.
  ContinuumVector times(const ContinuumVector &u) const {
    ContinuumVector result;
    body.reinit(result);
    for (const auto &[matrix, dofs] : parts) {
      dealii::Vector<double> of_part(dofs.size()), forces(dofs.size());
      for (unsigned int i = 0; i < dofs.size(); ++i)
        of_part[i] = u(dofs[i]);
      matrix.vmult(forces, of_part);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        result(dofs[i]) += forces[i];
    }
    return result;
  }

  /// Displacements at the nodes.
  template <typename Field>
  ContinuumVector field(const Field &at) const {
    std::map<dealii::types::global_dof_index, Point3> places;
    dealii::DoFTools::map_dofs_to_support_points(body.mapping, body.dof_handler, places);
    ContinuumVector u;
    body.reinit(u);
    std::vector<dealii::types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
    for (const auto &cell : body.dof_handler.active_cell_iterators()) {
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        u(dofs[i]) = at(places.at(dofs[i]))[body.fe.system_to_component_index(i).first];
    }
    return u;
  }

  const PipeWall wall;

private:
  static Scene body_scene(const LineFrom &of) {
    ContinuumScene body;
    body.dimension = 3;
    body.materials.push_back({2e11, 0.3});
    Scene result = of.scene;
    result.continuum = body;
    result.continuum_settings.degree = of.scene.solid.degree;
    result.continuum_settings.linear_solver = ContinuumSettings::LinearSolver::direct;
    return result;
  }

  const Scene scene;
  ContinuumBody<3> body;
  /// S, as it is handed on.
  std::vector<std::pair<dealii::FullMatrix<double>, std::vector<dealii::types::global_dof_index>>>
      parts;
};

void move_as_a_whole(const unsigned int degree) {
  const LineFrom line(pipe("A 0 0 0; C 0.4 0 0 bend 0.3; B 0.4 0.4 0.2", degree, 8));
  const FreeWall wall(line);
  constexpr double size = 0.1 * 0.1 * 3.14; // of the force of 1 Pa on a cap that turns by 1
  for (unsigned int d = 0; d < 3; ++d) {
    Vector3 axis;
    axis[d] = 1.;
    CHECK(wall.times(wall.field([&](const Point3 &) { return axis; })).linfty_norm() < 1e-9 * size);
    CHECK(wall.times(wall.field([&](const Point3 &at) {
                return dealii::cross_product_3d(axis, Vector3(at));
              }))
              .linfty_norm() < 1e-8 * size);
  }
  const auto wave = [](const double k) {
    return [k](const Point3 &at) {
      return Vector3({std::sin(k * at[0] + at[1]), std::cos(k * at[1] * at[2]), at[0] * k * at[2]});
    };
  };
  const ContinuumVector a = wall.field(wave(3.)), b = wall.field(wave(5.));
  CHECK(std::abs(wall.times(a) * b - wall.times(b) * a) <
        1e-10 * wall.times(a).l2_norm() * b.l2_norm());
}

constexpr double length = 0.2;

void become_oval(const FreeWall &wall, const unsigned int n, const double tolerance) {
  const ContinuumVector u = wall.field([&](const Point3 &at) {
    const double angle = std::atan2(at[2], at[1]);
    const Vector3 out({0., std::cos(angle), std::sin(angle)}),
        around({0., -std::sin(angle), std::cos(angle)});
    return std::cos(n * angle) * out - std::sin(n * angle) / n * around;
  });
  constexpr double pi = 3.14159265358979323846;
  CHECK(std::abs(0.5 * (wall.times(u) * u) / length - (n * n - 1.) * pi / 2.) < tolerance);
}

} // namespace

int pressure_stiffness(int, char **) {
  move_as_a_whole(2);
  const LineFrom tube(pipe("A 0 0 0; B 0.2 0 0", 3, 16));
  const FreeWall wall(tube);
  become_oval(wall, 1, 1e-6);
  become_oval(wall, 2, 0.02 * 3. * 1.57);
  become_oval(wall, 3, 0.02 * 8. * 1.57);
  return check::report();
}
