// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/substructure/wall_fields.h"

#include "base/algebra/dense_algebra.h"

#include <algorithm>
#include <random>

namespace frictionbeam {

using namespace dealii;

namespace {

Eigen::MatrixXd as_columns(const std::vector<ContinuumVector> &vectors) {
  Eigen::MatrixXd result(vectors.front().size(), vectors.size());
  for (std::size_t k = 0; k < vectors.size(); ++k)
    result.col(k) = Eigen::Map<const Eigen::VectorXd>(vectors[k].begin(), result.rows());
  return result;
}

} // namespace

WallFields::WallFields(const ContinuumBody<3> &body, std::vector<ContinuumVector> of_forces,
                       const PressureStiffness *const stiffness, std::vector<double> pressures)
    : body(body), forces(std::move(of_forces)) {
  Assert(stiffness != nullptr || pressures.empty(), ExcInternalError());
  const std::unique_ptr<ContinuumSystem> system =
      stiffness == nullptr
          ? make_condensed_system(body)
          : make_stiffened_system(body, [&](const AddMatrix &add) { stiffness->assemble(add); });
  const bool has_no_pressure = system->stiffen(0.);
  AssertThrow(has_no_pressure, ExcInternalError());
  add_fields(*system, 0.);
  std::sort(pressures.begin(), pressures.end());
  pressures.erase(std::unique(pressures.begin(), pressures.end()), pressures.end());
  const auto from_inside = std::upper_bound(pressures.begin(), pressures.end(), 0.),
             from_outside = std::lower_bound(pressures.begin(), pressures.end(), 0.);
  for (auto p = from_inside; p != pressures.end() && go_to(*system, *p, largest_stable);)
    ++p;
  for (auto p = std::make_reverse_iterator(from_outside);
       p != pressures.rend() && go_to(*system, *p, least_stable);)
    ++p;
  if (stiffness != nullptr)
    reduce(*stiffness);
  last.clear();
}

void WallFields::add_fields(ContinuumSystem &system, const double pressure) {
  std::vector<ContinuumVector> fields = forces;
  const bool is_solved = system.solve_all(fields);
  AssertThrow(is_solved, ExcInternalError());
  for (std::size_t k = 0; k < fields.size(); ++k) {
    body.constraints.distribute(fields[k]);
    spanning.push_back(fields[k]);
    if (!last.empty())
      spanning.back() -= last[k];
  }
  last = std::move(fields);
  solved.push_back(pressure);
}

bool WallFields::go_to(ContinuumSystem &system, const double pressure, double &stable) {
  if (!system.stiffen(pressure)) {
    stop_at_buckling(system, stable, pressure);
    return false;
  }
  add_fields(system, pressure);
  stable = pressure;
  return true;
}

void WallFields::stop_at_buckling(ContinuumSystem &system, double &stable, double beyond) {
  constexpr unsigned int n_halvings = 8, n_iterations = 4;
  constexpr double near_it = 0.9; // nearer fields are those of rounding, too
  const double from = stable;
  for (unsigned int i = 0; i < n_halvings; ++i) {
    const double middle = 0.5 * (stable + beyond);
    (system.stiffen(middle) ? stable : beyond) = middle;
  }
  const double near = from + near_it * (stable - from);
  const auto go_back_to = [&](const double pressure) {
    const bool is_stable_there = system.stiffen(pressure);
    AssertThrow(is_stable_there, ExcInternalError());
  };
  go_back_to(near);
  add_fields(system, near);

  go_back_to(stable); // whose inverse has hardly another field than that of buckling
  std::mt19937 engine;
  std::uniform_real_distribution<double> any(-1., 1.);
  Mode mode;
  mode.pressure = stable;
  body.reinit(mode.field);
  body.reinit(mode.force);
  for (double &value : mode.force)
    value = any(engine);
  for (unsigned int i = 0; i < n_iterations; ++i) {
    const bool is_solved = system.solve({}, true, mode.force, mode.field);
    AssertThrow(is_solved, ExcInternalError());
    if (i + 1 == n_iterations)
      break;
    mode.field /= mode.field.linfty_norm();
    system.multiply_stiffening(mode.field, mode.force);
  }
  body.constraints.distribute(mode.field);
  modes.push_back(std::move(mode));
}

void WallFields::reduce(const PressureStiffness &stiffness) {
  constexpr double rounding = 1e-10; // of squares of fields
  for (const Mode &mode : modes)
    spanning.push_back(mode.field);
  const Eigen::MatrixXd V = as_columns(spanning), work = V.transpose() * as_columns(forces),
                        S = reduced_stiffening(stiffness, V), K = reduced_stiffness(S, work);
  // Differences of fields count by the fields', as they are known.
  const int n_forces = forces.size(), n_fields = solved.size() * n_forces;
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(K.rows());
  for (int k = 0; k < scale.size(); ++k)
    if (const int of = k < n_fields ? k % n_forces : k; K(of, of) > 0.)
      scale[k] = 1. / std::sqrt(K(of, of));
  const SymmetricEigen of_K = symmetric_eigen(scale.asDiagonal() * K * scale.asDiagonal());
  const Eigen::VectorXd &sizes = of_K.values; // the largest one last
  const int n_left = (sizes.array() > rounding * sizes[sizes.size() - 1]).count();
  const Eigen::MatrixXd unit = scale.asDiagonal() * of_K.vectors.rightCols(n_left) *
                               sizes.tail(n_left).cwiseSqrt().cwiseInverse().asDiagonal();
  const SymmetricEigen of_S = symmetric_eigen(unit.transpose() * S * unit);
  theta = of_S.values;
  phi = unit * of_S.vectors;
  on_phi = phi.transpose() * work;
}

Eigen::MatrixXd WallFields::reduced_stiffening(const PressureStiffness &stiffness,
                                               const Eigen::MatrixXd &V) const {
  Eigen::MatrixXd SV = Eigen::MatrixXd::Zero(V.rows(), V.cols());
  stiffness.assemble(
      [&](const FullMatrix<double> &matrix, const std::vector<types::global_dof_index> &dofs) {
        Eigen::MatrixXd of_cell(dofs.size(), dofs.size()), motions(dofs.size(), V.cols());
        for (unsigned int i = 0; i < dofs.size(); ++i) {
          motions.row(i) = V.row(dofs[i]);
          for (unsigned int j = 0; j < dofs.size(); ++j)
            of_cell(i, j) = matrix(i, j);
        }
        const Eigen::MatrixXd needed = of_cell * motions;
        for (unsigned int i = 0; i < dofs.size(); ++i)
          SV.row(dofs[i]) += needed.row(i);
      });
  const Eigen::MatrixXd S = V.transpose() * SV;
  return 0.5 * (S + S.transpose());
}

Eigen::MatrixXd WallFields::reduced_stiffness(const Eigen::MatrixXd &S,
                                              const Eigen::MatrixXd &work) const {
  // K v = f - p S v of fields, and differences of this of their differences.
  const int n = forces.size();
  Eigen::MatrixXd K(S.rows(), S.cols()), sum = S.leftCols(n); // S v of the last pressure
  K.leftCols(n) = work;
  for (std::size_t k = 1; k < solved.size(); ++k) {
    const Eigen::MatrixXd before = sum;
    sum += S.middleCols(k * n, n);
    K.middleCols(k * n, n) = solved[k - 1] * before - solved[k] * sum;
  }
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const int column = solved.size() * n + k;
    K.col(column) = -modes[k].pressure * S.col(column);
    for (int i = 0; i < K.rows(); ++i)
      K(i, column) += spanning[i] * modes[k].force;
  }
  return 0.5 * (K + K.transpose());
}

Eigen::MatrixXd WallFields::coefficients(const double pressure) const {
  const auto found = std::find_if(solved.begin(), solved.end(), [&](const double one) {
    return std::abs(pressure - one) <= rounding_of_pressure();
  });
  if (found == solved.end())
    return phi * (1. + pressure * theta.array()).inverse().matrix().asDiagonal() * on_phi;
  const int n = forces.size();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(spanning.size(), n); // of differences until then
  for (std::ptrdiff_t k = 0; k <= found - solved.begin(); ++k)
    sum.middleRows(k * n, n).setIdentity();
  return sum;
}

unsigned int WallFields::n_negative(const double pressure) const {
  return (1. + pressure * theta.array() < 0.).count();
}

} // namespace frictionbeam
