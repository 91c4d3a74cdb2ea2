// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/solid/wall_state.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values_extractors.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

double WallStress::mises() const {
  const double x = axial - hoop, y = hoop - radial, z = radial - axial;
  return std::sqrt(0.5 * (x * x + y * y + z * z) +
                   3. * (shear * shear + axial_radial * axial_radial + hoop_radial * hoop_radial));
}

double RingState::ovality(const double outer_diameter) const {
  return 4. * std::hypot(mode2[0], mode2[1]) / outer_diameter;
}

double RingState::largest_mises(const unsigned int surface) const {
  double largest = 0.;
  for (const WallStress &point : stress[surface])
    largest = std::max(largest, point.mises());
  return largest;
}

namespace {

void add_force(const Vector3 &force, const Vector3 &arm, Motion &sum) {
  const Vector3 moment = cross_product_3d(arm, force);
  for (unsigned int d = 0; d < 3; ++d) {
    sum[d] += force[d];
    sum[3 + d] += moment[d];
  }
}

class WallReading {
public:
  WallReading(const PipeWall &wall, const WallLoads &loads, const ContinuumBody<3> &body,
              const ContinuumState &state, const PressureStiffness *const stiffness)
      : wall(wall), loads(loads), body(body), state(state), area(wall.area()),
        inertia(wall.inertia()), rings(wall.rings.size()), rule(body.fe.degree + 1),
        face_rule(body.fe.degree + 2), nodes(body.fe.base_element(0).get_unit_support_points()),
        values(body.mapping, body.fe, rule,
               update_values | update_gradients | update_quadrature_points | update_JxW_values),
        at_nodes(body.mapping, body.fe, nodes, update_quadrature_points),
        at_surface(body.mapping, body.fe, surface_points(),
                   update_gradients | update_quadrature_points),
        on_face(body.mapping, body.fe, face_rule,
                update_values | update_quadrature_points | update_normal_vectors |
                    update_JxW_values),
        counts(rings.size()) {
    if (stiffness != nullptr && loads.pressure(state.factors) != 0.) {
      by_pressure.emplace(*stiffness);
      moved = state.displacement;
      moved.add(-loads.pressure(state.factors), stiffness->free_field);
    }
    for (unsigned int i = 0; i < nodes.size(); ++i)
      first_dof.push_back(body.fe.component_to_system_index(0, i));
    for (unsigned int r = 0; r < rings.size(); ++r)
      for (unsigned int side = 0; side < 2; ++side) {
        rings[r].stress[side].resize(2 * wall.around);
        counts[r][side].assign(2 * wall.around, 0.);
      }
  }

  std::vector<RingState> read();

private:
  static Quadrature<3> surface_points() {
    std::vector<Point<3>> points;
    for (const double z : {0., 1.})
      for (const double x : {0., 1.})
        for (const double y : {0., 0.5, 1.})
          points.emplace_back(x, y, z);
    return Quadrature<3>(points);
  }

  void read_forces(const typename DoFHandler<3>::active_cell_iterator &cell);
  void read_motion(const typename DoFHandler<3>::active_cell_iterator &cell);
  void read_stress(const typename DoFHandler<3>::active_cell_iterator &cell);
  void add_up();
  /// What the pressure's stiffness makes the nodes of a cell need.
  void add_stiffening(const typename DoFHandler<3>::active_cell_iterator &cell,
                      std::vector<Vector3> &force);
  /// What the bore's cap has by its motion, on all rings, and as a load on the first and last.
  void read_thrust(const unsigned int ring);
  /// Of the contacts at the nodes of a ring, which the layers beside it need.
  Motion contact_force(const unsigned int ring) const;
  /// Call for each number of the rings.
  template <typename Call>
  void each_number(const Call &call);

  const PipeWall &wall;
  const WallLoads &loads;
  const ContinuumBody<3> &body;
  const ContinuumState &state;
  std::optional<PressureCells> by_pressure;
  ContinuumVector moved;      ///< displacement without that of the pressure by itself
  const double area, inertia; ///< of the mesh, which take a while to find
  std::vector<RingState> rings;
  const QGauss<3> rule;
  const QGauss<2> face_rule;
  const Quadrature<3> nodes;
  FEValues<3> values, at_nodes, at_surface;
  FEFaceValues<3> on_face;
  std::vector<std::array<std::vector<double>, 2>> counts; ///< of cells beside a stress
  std::vector<unsigned int> first_dof;                    ///< in a cell, of each node
  const FEValuesExtractors::Vector displacement{0};
};

void WallReading::read_forces(const typename DoFHandler<3>::active_cell_iterator &cell) {
  const unsigned int layer = wall.layer_of(cell->index()), pipe = cell->material_id();
  const LameConstants lame = lame_constants(body.continuum, pipe);
  const double free_strain = loads.free_strain(pipe, state.factors),
               p = loads.pressure(state.factors);
  const Vector3 weight = loads.volume_force(pipe, state.factors);
  std::vector<Tensor<2, 3>> gradients(rule.size());
  values.reinit(cell);
  at_nodes.reinit(cell);
  values[displacement].get_function_gradients(state.displacement, gradients);
  const bool has_bore = p != 0. && cell->index() / wall.around % wall.through == 0;
  std::vector<Vector3> force(nodes.size());
  for (unsigned int q = 0; q < rule.size(); ++q) {
    const SymmetricTensor<2, 3> stress = WallLoads::stress(lame, gradients[q], free_strain);
    for (unsigned int i = 0; i < nodes.size(); ++i) {
      const unsigned int k = first_dof[i];
      force[i] +=
          values.JxW(q) * (stress * values.shape_grad(k, q) - values.shape_value(k, q) * weight);
    }
  }
  if (has_bore) {
    on_face.reinit(cell, 0);
    for (unsigned int q = 0; q < face_rule.size(); ++q)
      for (unsigned int i = 0; i < nodes.size(); ++i)
        force[i] +=
            on_face.JxW(q) * p * on_face.shape_value(first_dof[i], q) * on_face.normal_vector(q);
  }
  if (by_pressure)
    add_stiffening(cell, force);
  constexpr double on_ring = 1e-9;
  for (unsigned int i = 0; i < nodes.size(); ++i) {
    const double z = nodes.point(i)[2];
    if (z > on_ring && z < 1. - on_ring)
      continue;
    const bool is_end = z > 0.5;
    const unsigned int ring = layer + (is_end ? 1 : 0);
    const Vector3 arm = at_nodes.quadrature_point(i) - wall.rings[ring].centre;
    // What a layer needs from outside: at its end it is what follows that pulls.
    add_force(is_end ? force[i] : -force[i], arm, rings[ring].cut[is_end ? 0 : 1]);
  }
}

void WallReading::add_stiffening(const typename DoFHandler<3>::active_cell_iterator &cell,
                                 std::vector<Vector3> &force) {
  const FullMatrix<double> matrix = by_pressure->of_cell(cell);
  dealii::Vector<double> u(matrix.n()), needed(matrix.m());
  cell->get_dof_values(moved, u);
  matrix.vmult(needed, u);
  for (unsigned int i = 0; i < force.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      force[i][d] +=
          loads.pressure(state.factors) * needed[body.fe.component_to_system_index(d, i)];
}

void WallReading::read_thrust(const unsigned int r) {
  const Motion per_pascal = BoreLoop(wall, body, r).moved_cap(moved);
  for (unsigned int c = 0; c < 6; ++c)
    rings[r].moved_thrust[c] = loads.pressure(state.factors) * per_pascal[c];
}

void WallReading::read_motion(const typename DoFHandler<3>::active_cell_iterator &cell) {
  const unsigned int layer = wall.layer_of(cell->index());
  for (const unsigned int face : {4u, 5u}) {
    if (face == 4 && layer > 0)
      continue;
    const unsigned int r = face == 4 ? layer : layer + 1;
    const WallRing &at = wall.rings[r];
    RingState &ring = rings[r];
    std::vector<Vector3> u(face_rule.size());
    on_face.reinit(cell, face);
    on_face[displacement].get_function_values(state.displacement, u);
    for (unsigned int q = 0; q < face_rule.size(); ++q) {
      const Vector3 arm = on_face.quadrature_point(q) - at.centre, out = arm / arm.norm();
      const double weight = on_face.JxW(q) / area, of_inertia = on_face.JxW(q) / inertia,
                   angle = std::atan2(arm * at.b, arm * at.a);
      const Vector3 about = cross_product_3d(arm, at.tangent);
      const Vector3 rotation =
          (u[q] * at.tangent) * of_inertia * about +
          0.5 * of_inertia * (cross_product_3d(arm, u[q]) * at.tangent) * at.tangent;
      for (unsigned int d = 0; d < 3; ++d) {
        ring.displacement[d] += weight * u[q][d];
        ring.displacement[3 + d] += rotation[d];
      }
      const double radial = u[q] * out;
      ring.widening += weight * radial;
      ring.mode2[0] += 2. * weight * radial * std::cos(2. * angle);
      ring.mode2[1] += 2. * weight * radial * std::sin(2. * angle);
      ring.mode3[0] += 2. * weight * radial * std::cos(3. * angle);
      ring.mode3[1] += 2. * weight * radial * std::sin(3. * angle);
    }
  }
}

void WallReading::read_stress(const typename DoFHandler<3>::active_cell_iterator &cell) {
  const unsigned int index = cell->index(), layer = wall.layer_of(index), i = index % wall.around,
                     j = index / wall.around % wall.through, pipe = cell->material_id();
  if (j > 0 && j + 1 < wall.through)
    return;
  const LameConstants lame = lame_constants(body.continuum, pipe);
  const double free_strain = loads.free_strain(pipe, state.factors);
  at_surface.reinit(cell);
  std::vector<Tensor<2, 3>> gradients(at_surface.n_quadrature_points);
  at_surface[displacement].get_function_gradients(state.displacement, gradients);
  unsigned int q = 0;
  for (const unsigned int behind : {0u, 1u})
    for (const unsigned int outside : {0u, 1u})
      for (const unsigned int half : {0u, 1u, 2u}) {
        const unsigned int r = layer + behind, point = (2 * i + half) % (2 * wall.around);
        const bool is_surface = outside == 1 ? j + 1 == wall.through : j == 0;
        const auto gradient = gradients[q];
        const Vector3 arm = at_surface.quadrature_point(q) - wall.rings[r].centre;
        ++q;
        if (!is_surface)
          continue;
        const Vector3 t = wall.rings[r].tangent, out = arm / arm.norm(),
                      around = cross_product_3d(t, out);
        const Tensor<2, 3> stress = WallLoads::stress(lame, gradient, free_strain);
        WallStress &sum = rings[r].stress[outside][point];
        sum.axial += t * stress * t;
        sum.hoop += around * stress * around;
        sum.radial += out * stress * out;
        sum.shear += t * stress * around;
        sum.axial_radial += t * stress * out;
        sum.hoop_radial += around * stress * out;
        counts[r][outside][point] += 1.;
      }
}

template <typename Call>
void WallReading::each_number(const Call &call) {
  for (RingState &ring : rings) {
    for (Motion *const motion : {&ring.displacement, &ring.cut[0], &ring.cut[1]})
      for (double &number : *motion)
        call(number);
    call(ring.widening);
    for (double *const number : {&ring.mode2[0], &ring.mode2[1], &ring.mode3[0], &ring.mode3[1]})
      call(*number);
    for (auto &surface : ring.stress)
      for (WallStress &point : surface)
        for (double *const number : {&point.axial, &point.hoop, &point.radial, &point.shear,
                                     &point.axial_radial, &point.hoop_radial})
          call(*number);
  }
  for (auto &ring : counts)
    for (auto &surface : ring)
      for (double &number : surface)
        call(number);
}

void WallReading::add_up() {
  std::vector<double> numbers;
  each_number([&](const double &number) { numbers.push_back(number); });
  Utilities::MPI::sum(numbers, body.communicator, numbers);
  std::size_t next = 0;
  each_number([&](double &number) { number = numbers[next++]; });
}

Motion WallReading::contact_force(const unsigned int ring) const {
  const WallRing &at = wall.rings[ring];
  Motion sum{};
  for (unsigned int i = 0; i < body.nodes.size(); ++i) {
    const ContinuumContactNode<3> &node = body.nodes[i];
    const Vector3 arm = node.position - at.centre;
    constexpr double on_ring = 1e-6, of_radius = 1.01;
    if (std::abs(arm * at.tangent) > on_ring * wall.outer || arm.norm() > of_radius * wall.outer)
      continue;
    Vector3 force;
    for (unsigned int a = 0; a < 3; ++a)
      force += node.weight * state.contacts.stress[i][a] * node.frame[a];
    add_force(force, arm, sum);
  }
  if (body.is_parallel)
    Utilities::MPI::sum(ArrayView<const double>(sum.data(), sum.size()), body.communicator,
                        ArrayView<double>(sum.data(), sum.size()));
  return sum;
}

std::vector<RingState> WallReading::read() {
  for (const auto &cell : body.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned()) {
      read_forces(cell);
      read_motion(cell);
      read_stress(cell);
    }
  if (body.is_parallel)
    add_up();
  for (unsigned int r = 0; r < rings.size(); ++r) {
    RingState &ring = rings[r];
    for (unsigned int side = 0; side < 2; ++side)
      for (unsigned int i = 0; i < ring.stress[side].size(); ++i) {
        WallStress &point = ring.stress[side][i];
        for (double *const number : {&point.axial, &point.hoop, &point.radial, &point.shear,
                                     &point.axial_radial, &point.hoop_radial})
          *number /= counts[r][side][i];
      }
    ring.pressure = loads.pressure(state.factors);
    for (const WallStress &point : ring.stress[0])
      ring.on_bore += point.radial / ring.stress[0].size();
    if (by_pressure)
      read_thrust(r);
    const Motion load = loads.section_load(r, state.factors), contact = contact_force(r);
    const double cap = r == 0 ? -1. : r + 1 == rings.size() ? 1. : 0.;
    for (unsigned int c = 0; c < 6; ++c)
      ring.held[c] =
          ring.cut[0][c] - ring.cut[1][c] - load[c] - cap * ring.moved_thrust[c] - contact[c];
  }
  return rings;
}

} // namespace

std::vector<RingState> wall_state(const PipeWall &wall, const WallLoads &loads,
                                  const ContinuumBody<3> &body, const ContinuumState &state,
                                  const PressureStiffness *const stiffness) {
  return WallReading(wall, loads, body, state, stiffness).read();
}

} // namespace frictionbeam
