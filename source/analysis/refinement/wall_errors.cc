// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/refinement/wall_errors.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <numeric>

namespace frictionbeam {

using namespace dealii;

double WallErrors::all_along() const { return std::accumulate(along.begin(), along.end(), 0.); }

namespace {

constexpr unsigned int next_around = 3, next_layer = 5; ///< faces of a cell

class WallEstimator {
public:
  WallEstimator(const PipeWall &wall, const WallLoads &loads, const ContinuumBody<3> &body,
                const std::vector<bool> &is_pushed)
      : wall(wall), loads(loads), body(body), is_pushed(is_pushed), rule(body.fe.degree + 1),
        in_cell(body.mapping, body.fe, QGauss<3>(body.fe.degree + 1),
                update_gradients | update_JxW_values),
        here(body.mapping, body.fe, rule,
             update_gradients | update_normal_vectors | update_JxW_values),
        there(body.mapping, body.fe, rule, update_gradients) {}

  /// Squared errors of a state [J].
  WallErrors errors(const ContinuumState &state);
  double energy(const ContinuumState &state); ///< of its strains [J]

private:
  using Cell = typename DoFHandler<3>::active_cell_iterator;
  /// Of the traction on a face that a cell shares with the next one, integral of the square.
  double jump(const ContinuumState &state, const Cell &cell, const unsigned int face);
  LameConstants lame(const Cell &cell) const {
    return lame_constants(body.continuum, cell->material_id());
  }
  double free_strain(const ContinuumState &state, const Cell &cell) const {
    return loads.free_strain(cell->material_id(), state.factors);
  }

  const PipeWall &wall;
  const WallLoads &loads;
  const ContinuumBody<3> &body;
  const std::vector<bool> &is_pushed;
  const QGauss<2> rule;
  FEValues<3> in_cell;
  FEFaceValues<3> here, there;
  const FEValuesExtractors::Vector displacement{0};
};

double WallEstimator::jump(const ContinuumState &state, const Cell &cell, const unsigned int face) {
  const Cell next = cell->neighbor(face);
  std::vector<Tensor<2, 3>> a(rule.size()), b(rule.size());
  here.reinit(cell, face);
  there.reinit(next, cell->neighbor_of_neighbor(face));
  here[displacement].get_function_gradients(state.displacement, a);
  there[displacement].get_function_gradients(state.displacement, b);
  double sum = 0.;
  for (unsigned int q = 0; q < rule.size(); ++q) {
    const SymmetricTensor<2, 3> difference =
        WallLoads::stress(lame(cell), a[q], free_strain(state, cell)) -
        WallLoads::stress(lame(next), b[q], free_strain(state, next));
    sum += here.JxW(q) * (difference * here.normal_vector(q)).norm_square();
  }
  return sum;
}

WallErrors WallEstimator::errors(const ContinuumState &state) {
  WallErrors result;
  result.along.assign(wall.n_layers(), 0.);
  const double factor =
      1. / (4. * body.fe.degree * body.continuum.materials.front().youngs_modulus);
  const auto length = [&](const unsigned int layer) {
    return wall.rings[layer + 1].s - wall.rings[layer].s;
  };
  const double around = 2. * numbers::PI * wall.mean_radius() / wall.around;
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    const unsigned int layer = wall.layer_of(cell->index());
    result.around += 2. * factor * around * jump(state, cell, next_around);
    if (layer + 1 == wall.n_layers() || is_pushed[layer + 1])
      continue;
    const double at_ring = factor * jump(state, cell, next_layer);
    result.along[layer] += length(layer) * at_ring;
    result.along[layer + 1] += length(layer + 1) * at_ring;
  }
  return result;
}

double WallEstimator::energy(const ContinuumState &state) {
  double sum = 0.;
  std::vector<Tensor<2, 3>> gradients(in_cell.get_quadrature().size());
  for (const auto &cell : body.dof_handler.active_cell_iterators()) {
    const double free = free_strain(state, cell);
    in_cell.reinit(cell);
    in_cell[displacement].get_function_gradients(state.displacement, gradients);
    for (unsigned int q = 0; q < gradients.size(); ++q)
      sum += 0.5 * in_cell.JxW(q) *
             (WallLoads::stress(lame(cell), gradients[q], free) *
              (symmetrize(gradients[q]) - free * unit_symmetric_tensor<3>()));
  }
  return sum;
}

} // namespace

WallErrors wall_errors(const PipeWall &wall, const WallLoads &loads, const ContinuumBody<3> &body,
                       const std::vector<ContinuumState> &states,
                       const std::vector<bool> &is_pushed) {
  constexpr double least_energy = 1e-6; // of the largest, that a state counts by
  WallEstimator estimator(wall, loads, body, is_pushed);
  WallErrors sum;
  sum.along.assign(wall.n_layers(), 0.);
  for (unsigned int k = 0; k < wall.n_layers(); ++k)
    sum.middles.push_back(0.5 * (wall.rings[k].s + wall.rings[k + 1].s));
  std::vector<double> energies;
  for (const ContinuumState &state : states)
    energies.push_back(estimator.energy(state));
  const double largest =
      energies.empty() ? 0. : *std::max_element(energies.begin(), energies.end());
  for (std::size_t i = 0; i < states.size() && largest > 0.; ++i) {
    const double energy = std::max(energies[i], least_energy * largest);
    const WallErrors errors = estimator.errors(states[i]);
    sum.around += errors.around / energy;
    for (unsigned int k = 0; k < sum.along.size(); ++k)
      sum.along[k] += errors.along[k] / energy;
  }
  return sum;
}

} // namespace frictionbeam
