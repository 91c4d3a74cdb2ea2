// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/mechanism.h"

#include "base/algebra/dense_algebra.h"
#include "base/joined.h"
#include "base/number_text.h"
#include "base/numbers.h"

#include "base/user_error.h"
#include "model/line_model.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace frictionbeam {

using namespace dealii;

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Rigid motions of one part about its centre and the directions in which it is held, as the sum of
/// row^T row; rotations are scaled by the part's size.
struct Part {
  Vector3 centre;
  double size = 0.;
  unsigned int n_vertices = 0;
  bool turns = false; ///< has rotations or more than one place
  unsigned int pipe = numbers::invalid_unsigned_int;
  unsigned int vertex = 0;
  Matrix6 held = Matrix6::Zero(), held_by_friction = Matrix6::Zero();
};

class MechanismCheck {
public:
  MechanismCheck(const Scene &scene, const LineMesh &mesh, const Discretization &discretization)
      : scene(scene), mesh(mesh), points(discretization.vertices()),
        n(discretization.n_line_vertices()), root(points.size()) {}

  void find_parts(const Contacts &contacts) {
    for (const MeshedPipe &pipe : mesh.pipes)
      for (unsigned int i = 0; i + 1 < pipe.vertices.size(); ++i)
        root.join(pipe.vertices[i], pipe.vertices[i + 1]);
    for (const Spring &spring : scene.springs)
      if (!spring.other.empty())
        root.join(mesh.points.at(spring.point), mesh.points.at(spring.other));
    for (unsigned int i = 0; i < contacts.size(); ++i)
      if (contacts[i].vertices[1] < n)
        root.join(contacts[i].vertices[0], contacts[i].vertices[1]);
    for (unsigned int v = 0; v < n; ++v) {
      Part &part = parts[root.find(v)];
      part.centre += points[v];
      part.vertex = v;
      ++part.n_vertices;
    }
    for (auto &[r, part] : parts)
      part.centre /= part.n_vertices;
    for (unsigned int v = 0; v < n; ++v) {
      Part &part = parts[root.find(v)];
      part.size = std::max(part.size, (points[v] - Point3(part.centre)).norm());
    }
    for (unsigned int p = 0; p < mesh.pipes.size(); ++p) {
      Part &part = parts[root.find(mesh.pipes[p].vertices.front())];
      part.pipe = p;
      part.turns = true;
    }
    for (auto &[r, part] : parts)
      part.turns = part.turns || part.size > 0.;
  }

  /// The motion @p direction is held at a vertex.
  void hold(const unsigned int vertex, const Tensor<1, 6> &direction, const bool friction) {
    if (vertex >= n)
      return;
    Part &part = parts.at(root.find(vertex));
    const Vector3 force({direction[0], direction[1], direction[2]});
    const Vector3 moment = Vector3({direction[3], direction[4], direction[5]}) +
                           cross_product_3d(Vector3(points[vertex] - Point3(part.centre)), force);
    Vector6 row;
    const double scale = part.size > 0. ? part.size : 1.;
    for (unsigned int d = 0; d < 3; ++d) {
      row[d] = force[d];
      row[3 + d] = moment[d] / scale;
    }
    (friction ? part.held_by_friction : part.held) += row * row.transpose();
  }

  std::vector<std::string> judge() const {
    std::vector<std::string> warnings;
    for (const auto &[r, part] : parts) {
      const int size = part.turns ? 6 : 3;
      const auto free_motion = [&](const Matrix6 &held) {
        const SymmetricEigen eigen = symmetric_eigen(held.topLeftCorner(size, size));
        const bool is_free = eigen.values[0] <= 1e-12 * std::max(eigen.values[size - 1], not_zero);
        Vector6 mode = Vector6::Zero();
        mode.head(size) = eigen.vectors.col(0);
        return std::make_pair(is_free, mode);
      };
      const auto [is_free, mode] = free_motion(part.held + part.held_by_friction);
      if (is_free && part.n_vertices == 1 && has_transient_step(scene))
        continue; // a block that stays where it is until it is let go
      if (is_free)
        throw UserError(name(part) + " is held by nothing against " + describe(part, mode) +
                        ". A static analysis needs every motion held: add an anchor, a restraint, "
                        "a spring or a support, or take the motion out with 'Free motions'.");
      const auto [slides, sliding] = free_motion(part.held);
      if (slides)
        warnings.push_back(name(part) + " is held by friction alone against " +
                           describe(part, sliding) + ".");
    }
    return warnings;
  }

private:
  std::string name(const Part &part) const {
    if (part.pipe != numbers::invalid_unsigned_int)
      return "The line with pipe '" + scene.pipes[part.pipe].name + "'";
    for (const auto &[point, vertex] : mesh.points)
      if (vertex == part.vertex)
        return "The point '" + point + "'";
    return "A part of the line";
  }

  static std::string text(const Vector3 &v) {
    std::ostringstream out;
    out.precision(3);
    out << '(';
    for (unsigned int d = 0; d < 3; ++d)
      out << (std::abs(v[d]) < no_direction * v.norm() ? 0. : v[d]) << (d < 2 ? ", " : ")");
    return out.str();
  }

  static std::string describe(const Part &part, const Vector6 &mode) {
    Vector3 shift, turn;
    for (unsigned int d = 0; d < 3; ++d) {
      shift[d] = mode[d];
      turn[d] = mode[3 + d];
    }
    if (turn.norm() < no_direction)
      return "moving along " + text(shift / shift.norm());
    Vector3 axis = turn / turn.norm();
    const Vector3 rate = turn / (part.size > 0. ? part.size : 1.);
    const Vector3 through = part.centre + cross_product_3d(rate, shift) / rate.norm_square();
    return "turning about the axis " + text(axis) + " through " + text(through);
  }

  const Scene &scene;
  const LineMesh &mesh;
  const std::vector<Point3> &points;
  const unsigned int n;
  Joined root;
  std::map<unsigned int, Part> parts;
};

Tensor<1, 6> along(const Vector3 &direction) {
  Tensor<1, 6> row;
  for (unsigned int d = 0; d < 3; ++d)
    row[d] = direction[d];
  return row;
}

struct Resists {
  bool pressing, sliding;
};

/// What a support resists in a static step: its law, pressed and sheared, answers with a force.
Resists resists(const Contact &contact) {
  const double e = 1e-6;
  const BoundLaw::Answer answer = contact.law.answer_at_rest(
      {-1. - e, e, 0., 0.}, contact.length, LawTangent::none, contact.installation_temperature);
  return {answer.stress[0] != 0., answer.stress[1] != 0.};
}

/// What restraints and Free motions hold of a vertex, as columns.
Eigen::MatrixXd held_without_loads(const Model &model, const unsigned int vertex) {
  Eigen::MatrixXd held(6, 0);
  const auto add = [&](const Vector6 &direction) {
    held.conservativeResize(6, held.cols() + 1);
    held.col(held.cols() - 1) = direction;
  };
  for (unsigned int i = 0; i < model.scene.restraints.size(); ++i)
    for (const Site &site : model.mesh.restraints[i])
      if (site.vertex == vertex)
        for (const Tensor<1, 6> &direction : held_directions(model.scene.restraints[i], site))
          add(Vector6(direction.begin_raw()));
  for (unsigned int c = 0; c < 6; ++c)
    if (!model.scene.free_motions[c])
      add(Vector6::Unit(c));
  return held;
}

constexpr const char *motion_names[] = {"ux", "uy", "uz", "rx", "ry", "rz"};

/// A motion that a load imposes is held in all steps, which is meant of anchors that move: remarks
/// on those that nothing else holds, where a step does not name the load.
std::vector<std::string> held_by_loads_alone(const Model &model) {
  std::vector<std::string> remarks;
  const std::vector<LoadStep> &steps = model.scene.steps;
  for (unsigned int l = 0; l < model.scene.loads.size(); ++l) {
    const Load &load = model.scene.loads[l];
    if (load.kind != Load::Kind::displacement ||
        std::all_of(steps.begin(), steps.end(), [&](const LoadStep &step) {
          return std::any_of(step.loads.begin(), step.loads.end(),
                             [&](const auto &one) { return one.first == l; });
        }))
      continue;
    for (const Load::AtPoint &at : load.at) {
      const Eigen::MatrixXd held = held_without_loads(model, model.mesh.points.at(at.point));
      for (unsigned int c = 0; c < 6; ++c) {
        const Vector6 axis(unit_motion(at.axes, c).data());
        Vector6 rest = axis;
        if (held.cols() > 0)
          rest -= held * LeastSquares(held).solve(axis);
        if (at.given[c] && rest.norm() > no_direction)
          remarks.push_back("Load " + load.name + ": " + motion_names[c] + " of point " + at.point +
                            ", which no anchor or restraint holds, is held in the steps that do "
                            "not name this load, too, and does not move there.");
      }
    }
  }
  return remarks;
}

} // namespace

std::vector<std::string> check_mechanisms(const Model &model) {
  const std::vector<LoadStep> &steps = model.scene.steps;
  std::vector<std::string> warnings = held_by_loads_alone(model);
  if (!steps.empty() &&
      std::all_of(steps.begin(), steps.end(), [](const LoadStep &step) { return step.transient; }))
    return warnings; // mass holds what nothing else does
  MechanismCheck check(model.scene, model.mesh, model.discretization);
  check.find_parts(model.contacts);
  for (const auto &held : model.space.held())
    check.hold(held.vertex, held.direction, false);
  for (const Spring &spring : model.scene.springs)
    for (unsigned int c = 0; c < 6; ++c)
      if (spring.stiffness[c] > 0. && spring.other.empty()) {
        Tensor<1, 6> row;
        for (unsigned int d = 0; d < 6; ++d)
          row[d] = spring.directions[c][d];
        check.hold(model.mesh.points.at(spring.point), row, false);
      }
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (contact.vertices[1] < model.discretization.n_line_vertices())
      continue; // joined above
    const Resists held = resists(contact);
    if (contact.platen_force == 0. && held.pressing)
      check.hold(contact.vertices[0], along(contact.axes.x), false);
    if (held.sliding) {
      check.hold(contact.vertices[0], along(contact.axes.y), true);
      check.hold(contact.vertices[0], along(contact.axes.z), true);
    }
  }
  const std::vector<std::string> of_parts = check.judge();
  warnings.insert(warnings.end(), of_parts.begin(), of_parts.end());
  return warnings;
}

std::string place_in_words(const Model &model, const unsigned int index, const double part) {
  const PipeCell &cell = model.discretization.pipe_cells()[index];
  const MeshedPipe &pipe = model.mesh.pipes[cell.pipe];
  const double along = cell.reversed ? 1. - part : part,
               s = (1. - along) * pipe.s[cell.position] + along * pipe.s[cell.position + 1];
  const UnitSystem &units = model.scene.units;
  return "pipe " + model.scene.pipes[cell.pipe].name +
         " at s = " + rounded_number(s / units.factor("m"), 3) + " " + units.name("m");
}

} // namespace frictionbeam
