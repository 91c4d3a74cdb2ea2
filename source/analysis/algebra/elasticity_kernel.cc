// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/elasticity_kernel.h"

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

// Lanes are handed by reference, and to nobody outside.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace frictionbeam {

using namespace dealii;

Polynomials1D polynomials_of_degree(const unsigned int degree) {
  Polynomials1D result;
  const unsigned int n = result.n = degree + 1;
  const QGauss<1> gauss(n);
  const auto nodal =
      Polynomials::generate_complete_Lagrange_basis(QGaussLobatto<1>(n).get_points());
  const auto at_points = Polynomials::generate_complete_Lagrange_basis(gauss.get_points());
  std::vector<double> value(2);
  for (unsigned int q = 0; q < n; ++q) {
    const double x = gauss.point(q)[0];
    result.weights.push_back(gauss.weight(q));
    for (unsigned int i = 0; i < n; ++i) {
      nodal[i].value(x, value);
      result.values.push_back(value[0]);
      result.gradients.push_back(value[1]);
      at_points[i].value(x, value);
      result.slopes.push_back(value[1]);
    }
  }
  return result;
}

namespace {

#define FRICTIONBEAM_INLINE inline __attribute__((always_inline))

/// out[q] (+)= sum_i matrix[q, i] in[i] along one direction of n^3 numbers; transposed: by columns.
template <int n, int direction, bool transposed, bool add>
FRICTIONBEAM_INLINE void sweep(const double *matrix, const Lanes *in, Lanes *out) {
  constexpr int step = direction == 0 ? 1 : direction == 1 ? n : n * n;
  constexpr int step_a = direction == 0 ? n : 1, step_b = direction == 2 ? n : n * n;
  for (int b = 0; b < n; ++b)
    for (int a = 0; a < n; ++a) {
      const Lanes *const line = in + a * step_a + b * step_b;
      Lanes *const result = out + a * step_a + b * step_b;
      Lanes kept[n];
      for (int i = 0; i < n; ++i)
        kept[i] = line[i * step];
      for (int q = 0; q < n; ++q) {
        Lanes sum = kept[0] * matrix[transposed ? q : q * n];
        for (int i = 1; i < n; ++i)
          sum += kept[i] * matrix[transposed ? i * n + q : q * n + i];
        if (add)
          result[q * step] += sum;
        else
          result[q * step] = sum;
      }
    }
}

/// At one point: derivatives by the cell's own coordinates, direction by direction, become the
/// stresses times the area that the derivatives of the test functions are multiplied by.
FRICTIONBEAM_INLINE void stresses(const StoredLanes *J, const Lanes &lambda, const Lanes &mu,
                                  Lanes *slope[3][3], const int q, const double weight) {
  Lanes H[3][3], S[3][3]; // du_c / dx_d
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d)
      H[c][d] = slope[c][0][q] * J[d].lanes + slope[c][1][q] * J[3 + d].lanes +
                slope[c][2][q] * J[6 + d].lanes;
  const Lanes area = J[9].lanes * weight, shear = area * mu,
              pressure = area * lambda * (H[0][0] + H[1][1] + H[2][2]);
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d)
      S[c][d] = shear * (H[c][d] + H[d][c]);
  for (int c = 0; c < 3; ++c)
    S[c][c] += pressure;
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k)
      slope[c][k][q] =
          S[c][0] * J[3 * k].lanes + S[c][1] * J[3 * k + 1].lanes + S[c][2] * J[3 * k + 2].lanes;
}

template <int n>
struct Workspace {
  Lanes nodes[n * n * n], points[n * n * n], slopes[3][3][n * n * n];
};

template <int n>
FRICTIONBEAM_INLINE void multiply_batch(const Polynomials1D &polynomials, const unsigned int *dofs,
                                        const StoredLanes *geometry, const unsigned int stride,
                                        const Lanes &lambda, const Lanes &mu, const double *x,
                                        double *y, Workspace<n> &work) {
  constexpr int n3 = n * n * n;
  const double *const values = polynomials.values.data(), *const slopes = polynomials.slopes.data();
  Lanes *slope[3][3];
  for (int c = 0; c < 3; ++c) {
    for (int k = 0; k < 3; ++k)
      slope[c][k] = work.slopes[c][k];
    const unsigned int *const own = dofs + c * n3 * n_lanes;
    for (int i = 0; i < n3; ++i)
      work.nodes[i] = Lanes{x[own[4 * i]], x[own[4 * i + 1]], x[own[4 * i + 2]], x[own[4 * i + 3]]};
    sweep<n, 0, false, false>(values, work.nodes, work.points);
    sweep<n, 1, false, false>(values, work.points, work.nodes);
    sweep<n, 2, false, false>(values, work.nodes, work.points);
    sweep<n, 0, false, false>(slopes, work.points, slope[c][0]);
    sweep<n, 1, false, false>(slopes, work.points, slope[c][1]);
    sweep<n, 2, false, false>(slopes, work.points, slope[c][2]);
  }
  const double *const weights = polynomials.weights.data();
  for (int k = 0, q = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i, ++q, geometry += stride)
        stresses(geometry, lambda, mu, slope, q, weights[i] * weights[j] * weights[k]);
  for (int c = 0; c < 3; ++c) {
    sweep<n, 0, true, false>(slopes, slope[c][0], work.points);
    sweep<n, 1, true, true>(slopes, slope[c][1], work.points);
    sweep<n, 2, true, true>(slopes, slope[c][2], work.points);
    sweep<n, 2, true, false>(values, work.points, work.nodes);
    sweep<n, 1, true, false>(values, work.nodes, work.points);
    sweep<n, 0, true, false>(values, work.points, work.nodes);
    const unsigned int *const own = dofs + c * n3 * n_lanes;
    for (int i = 0; i < n3; ++i)
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        y[own[n_lanes * i + lane]] += work.nodes[i][lane];
  }
}

/// What a product needs of the cells.
template <typename Batch>
struct Cells {
  const Polynomials1D &polynomials;
  const std::vector<Batch> &batches;
  const unsigned int *dofs;
  const StoredLanes *geometry;
};

template <int n, typename Batch>
FRICTIONBEAM_INLINE void multiply_all(const Cells<Batch> &cells, const double *x, double *y) {
  Workspace<n> work;
  const unsigned int *dofs = cells.dofs;
  for (const Batch &batch : cells.batches) {
    multiply_batch<n>(cells.polynomials, dofs, cells.geometry + batch.geometry, batch.stride,
                      batch.lambda, batch.mu, x, y, work);
    dofs += 3 * n * n * n * n_lanes;
  }
}

#if defined(__x86_64__)
template <int n, typename Batch>
__attribute__((target("avx2,fma"))) void multiply_with_avx2(const Cells<Batch> &cells,
                                                            const double *x, double *y) {
  multiply_all<n>(cells, x, y);
}
#endif

template <int n, typename Batch>
void multiply_cells(const Cells<Batch> &cells, const double *x, double *y) {
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (has_avx2)
    return multiply_with_avx2<n>(cells, x, y);
#endif
  multiply_all<n>(cells, x, y);
}

} // namespace

ElasticHexahedra::ElasticHexahedra(const unsigned int degree)
    : polynomials(polynomials_of_degree(degree)) {}

void ElasticHexahedra::add(const Cell &cell) {
  if (!waiting.empty() && waiting.front().geometry.size() != cell.geometry.size())
    flush();
  waiting.push_back(cell);
  if (waiting.size() == n_lanes)
    flush();
}

void ElasticHexahedra::flush() {
  if (waiting.empty())
    return;
  const std::size_t n_cells = waiting.size();
  while (waiting.size() < n_lanes) // cells without volume
    waiting.push_back(waiting.front());
  const std::size_t n_numbers = waiting.front().geometry.size();
  Batch batch;
  batch.geometry = geometry.size();
  batch.stride = n_numbers > 10 ? 10 : 0;
  for (std::size_t i = 0; i < n_numbers; ++i) {
    Lanes numbers;
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      numbers[lane] = lane >= n_cells && i % 10 == 9 ? 0. : waiting[lane].geometry[i];
    geometry.push_back({numbers});
  }
  for (unsigned int lane = 0; lane < n_lanes; ++lane) {
    batch.lambda[lane] = waiting[lane].lambda;
    batch.mu[lane] = waiting[lane].mu;
  }
  for (std::size_t i = 0; i < waiting.front().dofs.size(); ++i)
    for (const Cell &cell : waiting)
      dofs.push_back(cell.dofs[i]);
  batches.push_back(batch);
  waiting.clear();
}

void ElasticHexahedra::multiply_add(const double *x, double *y) const {
  const Cells<Batch> cells{polynomials, batches, dofs.data(), geometry.data()};
  switch (polynomials.n) {
  case 2:
    return multiply_cells<2>(cells, x, y);
  case 3:
    return multiply_cells<3>(cells, x, y);
  case 4:
    return multiply_cells<4>(cells, x, y);
  case 5:
    return multiply_cells<5>(cells, x, y);
  case 6:
    return multiply_cells<6>(cells, x, y);
  default:
    return multiply_cells<highest_degree + 1>(cells, x, y);
  }
}

void ElasticHexahedra::diagonal_add(double *d) const {
  const unsigned int n = polynomials.n, n3 = n * n * n;
  const unsigned int *batch_dofs = dofs.data();
  std::vector<StoredLanes> diagonal(3 * n3);
  for (const Batch &batch : batches) {
    for (StoredLanes &entry : diagonal)
      entry.lanes = Lanes{};
    for (unsigned int q = 0; q < n3; ++q) {
      const unsigned int q0 = q % n, q1 = q / n % n, q2 = q / (n * n);
      const StoredLanes *const J = geometry.data() + batch.geometry + q * batch.stride;
      const Lanes area = J[9].lanes * (polynomials.weights[q0] * polynomials.weights[q1] *
                                       polynomials.weights[q2]),
                  by_lambda = area * batch.lambda, by_mu = area * batch.mu;
      for (unsigned int i = 0; i < n3; ++i) {
        const unsigned int a = q0 * n + i % n, b = q1 * n + i / n % n, c = q2 * n + i / (n * n);
        const double *const N = polynomials.values.data(), *const dN = polynomials.gradients.data();
        const double by_x = dN[a] * N[b] * N[c], by_y = N[a] * dN[b] * N[c],
                     by_z = N[a] * N[b] * dN[c];
        Lanes squares[3], all{};
        for (unsigned int k = 0; k < 3; ++k) {
          const Lanes gradient = J[k].lanes * by_x + J[3 + k].lanes * by_y + J[6 + k].lanes * by_z;
          squares[k] = gradient * gradient;
          all += squares[k];
        }
        for (unsigned int k = 0; k < 3; ++k)
          diagonal[k * n3 + i].lanes += by_lambda * squares[k] + by_mu * (all + squares[k]);
      }
    }
    for (unsigned int i = 0; i < 3 * n3; ++i, batch_dofs += n_lanes)
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        d[batch_dofs[lane]] += diagonal[i].lanes[lane];
  }
}

} // namespace frictionbeam
