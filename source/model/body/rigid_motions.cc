// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/body/rigid_motions.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_tools.h>

#include <Eigen/QR>
#include <Eigen/SVD>

namespace frictionbeam {

using namespace dealii;

namespace {

template <int dim>
constexpr int n_motions = dim *(dim + 1) / 2;

using Row = std::vector<double>;

/// Component @p c of all motions at a place: translations, and rotations in each pair of axes.
template <int dim>
Row motions_at(const Tensor<1, dim> &arm, const unsigned int c) {
  Row row(n_motions<dim>, 0.);
  row[c] = 1.;
  unsigned int k = dim;
  for (unsigned int a = 0; a < dim; ++a)
    for (unsigned int b = a + 1; b < dim; ++b, ++k)
      row[k] = c == a ? -arm[b] : c == b ? arm[a] : 0.;
  return row;
}

/// The triangular factor, which stands for rows of any number.
template <int n>
std::vector<double> factor_of(const std::vector<Row> &rows) {
  using Square = Eigen::Matrix<double, n, n>;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows.size() + n, n);
  for (std::size_t i = 0; i < rows.size(); ++i)
    all.row(i) = Eigen::Map<const Eigen::RowVectorXd>(rows[i].data(), n);
  const Square R = Eigen::HouseholderQR<Eigen::MatrixXd>(all)
                       .matrixQR()
                       .template topRows<n>()
                       .template triangularView<Eigen::Upper>();
  return {R.data(), R.data() + R.size()};
}

} // namespace

template <int dim>
std::vector<ContinuumVector> rigid_motions(const ContinuumBody<dim> &body) {
  constexpr int n = n_motions<dim>;
  constexpr double in_the_way = 1e-10; // of a displacement of one
  const auto box = GridTools::compute_bounding_box(*body.triangulation).get_boundary_points();
  Tensor<1, dim> middle;
  double size = 0.;
  for (unsigned int d = 0; d < dim; ++d) {
    const double low = Utilities::MPI::min(box.first[d], body.communicator),
                 high = Utilities::MPI::max(box.second[d], body.communicator);
    middle[d] = (low + high) / 2.;
    size = std::max(size, high - low);
  }

  std::map<types::global_dof_index, Point<dim>> places;
  DoFTools::map_dofs_to_support_points(body.mapping, body.dof_handler, places);
  std::map<types::global_dof_index, unsigned int> components;
  std::vector<types::global_dof_index> dofs(body.fe.n_dofs_per_cell());
  for (const auto &cell : body.dof_handler.active_cell_iterators())
    if (!cell->is_artificial()) {
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        components[dofs[i]] = body.fe.system_to_component_index(i).first;
    }
  const auto row_of = [&](const types::global_dof_index dof) {
    return motions_at<dim>((Tensor<1, dim>(places.at(dof)) - middle) / size, components.at(dof));
  };

  std::vector<Row> against; // what constraints have against the motions
  for (const auto &line : body.constraints.get_lines()) {
    if (!body.owned.is_element(line.index))
      continue;
    Row row = row_of(line.index);
    for (const auto &[dof, factor] : line.entries) {
      const Row other = row_of(dof);
      for (int k = 0; k < n; ++k)
        row[k] -= factor * other[k];
    }
    against.push_back(row);
  }
  const auto factors = Utilities::MPI::all_gather(body.communicator, factor_of<n>(against));
  Eigen::MatrixXd all(n * factors.size(), n);
  for (std::size_t p = 0; p < factors.size(); ++p)
    all.middleRows<n>(n * p) = Eigen::Map<const Eigen::Matrix<double, n, n>>(factors[p].data());
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(all, Eigen::ComputeFullV);

  std::vector<ContinuumVector> result;
  for (int m = 0; m < n; ++m) {
    if (svd.singularValues()[m] > in_the_way)
      continue;
    result.emplace_back();
    body.reinit(result.back());
    for (const auto dof : body.owned) {
      const Row row = row_of(dof);
      result.back()(dof) =
          svd.matrixV().col(m).dot(Eigen::Map<const Eigen::VectorXd>(row.data(), n));
    }
    result.back().update_ghost_values();
  }
  return result;
}

template std::vector<ContinuumVector> rigid_motions(const ContinuumBody<2> &);
template std::vector<ContinuumVector> rigid_motions(const ContinuumBody<3> &);

} // namespace frictionbeam
