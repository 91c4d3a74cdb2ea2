// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/wall_loads.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

WallLoads::WallLoads(const Scene &scene, const LineMesh &line, const PipeWall &wall,
                     const ContinuumBody<3> &body)
    : scene(scene), wall(wall), body(body), at_rings(scene.loads.size()),
      volume(scene.pipes.size(), 0.), first_moment(scene.pipes.size()) {
  measure();
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const Load &load = scene.loads[l];
    if (load.kind == Load::Kind::force)
      for (const Load::AtPoint &at : load.at)
        at_rings[l].emplace_back(wall.ring_at(line.points.at(at.point)), at.value);
    if (load.kind == Load::Kind::pressure)
      for (const bool at_end : {false, true}) {
        const unsigned int ring = at_end ? wall.rings.size() - 1 : 0;
        const Vector3 thrust =
            (at_end ? 1. : -1.) * load.value * wall.bore_area() * wall.rings[ring].tangent;
        at_rings[l].push_back({ring, {thrust[0], thrust[1], thrust[2], 0., 0., 0.}});
      }
  }
}

double WallLoads::free_strain(const unsigned int pipe, const std::vector<double> &factors) const {
  const Material &material = scene.materials[scene.pipes[pipe].material];
  double strain = 0.;
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const Load &load = scene.loads[l];
    if (load.kind == Load::Kind::temperature && load.is_on(scene.pipes[pipe].name))
      strain +=
          factors[l] * material.thermal_strain(load.installation, load.installation + load.value);
  }
  return strain;
}

double WallLoads::pressure(const std::vector<double> &factors) const {
  double sum = 0.;
  for (std::size_t l = 0; l < scene.loads.size(); ++l)
    if (scene.loads[l].kind == Load::Kind::pressure)
      sum += factors[l] * scene.loads[l].value;
  return sum;
}

Vector3 WallLoads::volume_force(const unsigned int pipe, const std::vector<double> &factors) const {
  const Section &section = scene.sections[scene.pipes[pipe].section];
  const double mass =
      scene.materials[scene.pipes[pipe].material].density * section.area + section.added_mass;
  Vector3 force;
  for (std::size_t l = 0; l < scene.loads.size(); ++l) {
    const Load &load = scene.loads[l];
    if (!load.is_on(scene.pipes[pipe].name))
      continue;
    if (load.kind == Load::Kind::weight)
      force += factors[l] * mass * load.vector;
    else if (load.kind == Load::Kind::line_force)
      force += factors[l] * load.vector;
  }
  return force / wall.area();
}

Motion WallLoads::section_load(const unsigned int ring, const std::vector<double> &factors) const {
  Motion sum{};
  for (std::size_t l = 0; l < scene.loads.size(); ++l)
    for (const auto &[place, load] : at_rings[l])
      if (place == ring)
        for (unsigned int c = 0; c < 6; ++c)
          sum[c] += factors[l] * load[c];
  return sum;
}

bool WallLoads::is_loaded(const unsigned int ring) const {
  return std::any_of(at_rings.begin(), at_rings.end(), [&](const auto &of_load) {
    return std::any_of(of_load.begin(), of_load.end(),
                       [&](const auto &at) { return at.first == ring; });
  });
}

SymmetricTensor<2, 3> WallLoads::stress(const LameConstants &lame, const Tensor<2, 3> &gradient,
                                        const double free_strain) {
  const SymmetricTensor<2, 3> strain =
      symmetrize(gradient) - free_strain * unit_symmetric_tensor<3>();
  return lame.lambda * trace(strain) * unit_symmetric_tensor<3>() + 2. * lame.mu * strain;
}

void WallLoads::add_volume(const std::vector<double> &factors, ContinuumVector &forces) const {
  const QGauss<3> rule(body.fe.degree + 1);
  FEValues<3> values(body.mapping, body.fe, rule,
                     update_values | update_gradients | update_JxW_values);
  Vector<double> local(body.fe.n_dofs_per_cell());
  std::vector<types::global_dof_index> dofs(local.size());
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const unsigned int pipe = cell->material_id();
    const LameConstants lame = lame_constants(body.continuum, pipe);
    const double swelling = (3. * lame.lambda + 2. * lame.mu) * free_strain(pipe, factors);
    const Vector3 force = volume_force(pipe, factors);
    if (swelling == 0. && force.norm() == 0.)
      continue;
    values.reinit(cell);
    local = 0.;
    for (unsigned int i = 0; i < local.size(); ++i) {
      const unsigned int d = body.fe.system_to_component_index(i).first;
      for (const unsigned int q : values.quadrature_point_indices())
        local[i] += values.JxW(q) *
                    (swelling * values.shape_grad(i, q)[d] + force[d] * values.shape_value(i, q));
    }
    cell->get_dof_indices(dofs);
    body.constraints.distribute_local_to_global(local, dofs, forces);
  }
}

namespace {

/// Add traction(place, normal) over the faces that @p face_of says (-1: none) of owned cells.
template <typename FaceOf, typename Traction>
void add_over_faces(const ContinuumBody<3> &body, const FaceOf &face_of, const Traction &traction,
                    ContinuumVector &forces) {
  const QGauss<2> rule(body.fe.degree + 2);
  FEFaceValues<3> values(body.mapping, body.fe, rule,
                         update_values | update_quadrature_points | update_normal_vectors |
                             update_JxW_values);
  Vector<double> local(body.fe.n_dofs_per_cell());
  std::vector<types::global_dof_index> dofs(local.size());
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    const int face = cell->is_locally_owned() ? face_of(cell->index()) : -1;
    if (face < 0)
      continue;
    values.reinit(cell, face);
    local = 0.;
    for (const unsigned int q : values.quadrature_point_indices()) {
      const Vector3 t =
          values.JxW(q) * traction(values.quadrature_point(q), values.normal_vector(q));
      for (unsigned int i = 0; i < local.size(); ++i)
        local[i] += t[body.fe.system_to_component_index(i).first] * values.shape_value(i, q);
    }
    cell->get_dof_indices(dofs);
    body.constraints.distribute_local_to_global(local, dofs, forces);
  }
}

} // namespace

void WallLoads::add_pressure(const double p, ContinuumVector &forces) const {
  add_over_faces(
      body, [&](const unsigned int cell) { return is_at_bore(cell) ? 0 : -1; },
      [&](const Point3 &, const Vector3 &normal) { return -p * normal; }, forces);
}

void WallLoads::add_section(const unsigned int ring, const Motion &load,
                            ContinuumVector &forces) const {
  const WallRing &at = wall.rings[ring];
  const Vector3 force({load[0], load[1], load[2]}), moment({load[3], load[4], load[5]});
  const double twist = moment * at.tangent, A = wall.area(), I = wall.inertia();
  const unsigned int layer = ring == 0 ? 0 : ring - 1;
  add_over_faces(
      body,
      [&](const unsigned int cell) {
        return wall.layer_of(cell) == layer ? (ring == 0 ? 4 : 5) : -1;
      },
      [&](const Point3 &place, const Vector3 &) {
        const Vector3 arm = place - at.centre;
        return force / A + moment * cross_product_3d(arm, at.tangent) / I * at.tangent +
               twist / (2. * I) * cross_product_3d(at.tangent, arm);
      },
      forces);
}

void WallLoads::measure() {
  const Point3 &middle = wall.rings.front().centre;
  FEValues<3> values(body.mapping, body.fe, QGauss<3>(body.fe.degree + 1),
                     update_quadrature_points | update_JxW_values);
  FEFaceValues<3> on_bore(body.mapping, body.fe, QGauss<2>(body.fe.degree + 2),
                          update_quadrature_points | update_normal_vectors | update_JxW_values);
  for (const auto &cell : body.triangulation->active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    values.reinit(cell);
    for (const unsigned int q : values.quadrature_point_indices()) {
      volume[cell->material_id()] += values.JxW(q);
      first_moment[cell->material_id()] += values.JxW(q) * (values.quadrature_point(q) - middle);
    }
    if (!is_at_bore(cell->index()))
      continue;
    on_bore.reinit(cell, 0);
    for (const unsigned int q : on_bore.quadrature_point_indices()) {
      const Vector3 normal = on_bore.JxW(q) * on_bore.normal_vector(q);
      bore += normal;
      turn_of_bore += cross_product_3d(Vector3(on_bore.quadrature_point(q) - middle), normal);
    }
  }
  Utilities::MPI::sum(volume, body.communicator, volume);
  for (Vector3 &moment : first_moment)
    moment = Utilities::MPI::sum(moment, body.communicator);
  bore = Utilities::MPI::sum(bore, body.communicator);
  turn_of_bore = Utilities::MPI::sum(turn_of_bore, body.communicator);
}

Motion WallLoads::resultant(const std::vector<double> &factors) const {
  const double p = pressure(factors);
  Vector3 force = -p * bore, moment = -p * turn_of_bore;
  for (unsigned int pipe = 0; pipe < volume.size(); ++pipe) {
    const Vector3 density = volume_force(pipe, factors);
    force += volume[pipe] * density;
    moment += cross_product_3d(first_moment[pipe], density);
  }
  for (std::size_t l = 0; l < scene.loads.size(); ++l)
    for (const auto &[ring, load] : at_rings[l]) {
      const Vector3 at_ring({load[0], load[1], load[2]}),
          arm = wall.rings[ring].centre - wall.rings.front().centre;
      force += factors[l] * at_ring;
      moment +=
          factors[l] * (cross_product_3d(arm, at_ring) + Vector3({load[3], load[4], load[5]}));
    }
  return {{force[0], force[1], force[2], moment[0], moment[1], moment[2]}};
}

std::vector<ContinuumVector> WallLoads::forces() const {
  std::vector<ContinuumVector> result(scene.loads.size());
  for (std::size_t l = 0; l < result.size(); ++l) {
    body.reinit(result[l]);
    std::vector<double> factors(scene.loads.size(), 0.);
    factors[l] = 1.;
    add_volume(factors, result[l]);
    if (const double p = pressure(factors); p != 0.)
      add_pressure(p, result[l]);
    for (const auto &[ring, load] : at_rings[l])
      add_section(ring, load, result[l]);
    result[l].compress(VectorOperation::add);
  }
  return result;
}

} // namespace frictionbeam
