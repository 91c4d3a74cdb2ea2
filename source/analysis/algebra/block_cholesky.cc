// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/algebra/block_cholesky.h"

#include <Eigen/CholmodSupport>

#include <numeric>

namespace frictionbeam {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

cholmod_sparse view(const Sparse &lower) {
  return Eigen::viewAsCholmod(lower.selfadjointView<Eigen::Lower>());
}

} // namespace

struct BlockCholesky::Cholmod {
  Cholmod() { cholmod_start(&common); }
  ~Cholmod() {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Cholmod(const Cholmod &) = delete;

  /// In place, with a part of the factor.
  void solve(const int system, Eigen::MatrixXd &y) {
    cholmod_dense right = Eigen::viewAsCholmod(y);
    cholmod_dense *result = cholmod_solve(system, factor, &right, &common);
    y = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double *>(result->x), y.rows(),
                                          y.cols());
    cholmod_free_dense(&result, &common);
  }

  cholmod_common common;
  cholmod_factor *factor = nullptr;
};

BlockCholesky::BlockCholesky() : cholmod(std::make_unique<Cholmod>()) {}
BlockCholesky::~BlockCholesky() = default;

bool BlockCholesky::compute(const Sparse &lower, const int n_last) {
  cholmod_common &common = cholmod->common;
  cholmod_free_factor(&cholmod->factor, &common);
  common.print = 0; // what fails is in the status
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_NATURAL;
  const int n = lower.rows();
  cholmod_sparse matrix = view(lower);
  const auto leaves_the_last = [&]() {
    const int *const place = static_cast<const int *>(cholmod->factor->Perm);
    for (int i = n - n_last; i < n; ++i)
      if (place[i] != i)
        return false;
    return true;
  };
  common.postorder = 1; // which makes blocks larger, and moves no unknowns behind others they need
  cholmod->factor = cholmod_analyze(&matrix, &common);
  if (cholmod->factor != nullptr && !leaves_the_last()) {
    cholmod_free_factor(&cholmod->factor, &common);
    common.postorder = 0;
    cholmod->factor = cholmod_analyze(&matrix, &common);
  }
  if (cholmod->factor == nullptr)
    return false;
  cholmod_factorize(&matrix, cholmod->factor, &common);
  if (common.status != CHOLMOD_OK || cholmod->factor->minor < static_cast<std::size_t>(n))
    return false;
  read_last_block(n_last);
  return true;
}

void BlockCholesky::read_last_block(const int n_last) {
  const cholmod_factor &L = *cholmod->factor;
  const int *const first_column = static_cast<const int *>(L.super),
                   *const first_row = static_cast<const int *>(L.pi),
                   *const first_value = static_cast<const int *>(L.px),
                   *const rows = static_cast<const int *>(L.s);
  const double *const values = static_cast<const double *>(L.x);
  const int begin = static_cast<int>(L.n) - n_last;
  block = Eigen::MatrixXd::Zero(n_last, n_last);
  for (std::size_t s = 0; s < L.nsuper; ++s) {
    const int n_rows = first_row[s + 1] - first_row[s];
    for (int j = std::max(begin, first_column[s]); j < first_column[s + 1]; ++j) {
      const int k = j - first_column[s]; // the rows from k on are below the diagonal
      for (int i = k; i < n_rows; ++i)
        block(rows[first_row[s] + i] - begin, j - begin) =
            values[first_value[s] + k * static_cast<std::ptrdiff_t>(n_rows) + i];
    }
  }
}

void BlockCholesky::solve_lower(Eigen::MatrixXd &y) const {
  cholmod->solve(CHOLMOD_P, y);
  cholmod->solve(CHOLMOD_L, y);
}

void BlockCholesky::solve_upper(Eigen::MatrixXd &y) const {
  cholmod->solve(CHOLMOD_Lt, y);
  cholmod->solve(CHOLMOD_Pt, y);
}

Eigen::VectorXi sparse_order(const Sparse &lower, const int n_last) {
  cholmod_common common;
  cholmod_start(&common);
  cholmod_sparse matrix = view(lower);
  const int n = lower.rows();
  Eigen::VectorXi all(n), order(n);
  cholmod_amd(&matrix, nullptr, 0, all.data(), &common);
  int k = 0;
  for (const int i : all)
    if (i < n - n_last)
      order[k++] = i;
  std::iota(order.data() + k, order.data() + n, n - n_last);
  cholmod_finish(&common);
  return order;
}

Sparse in_order(const Sparse &lower, const Eigen::VectorXi &order) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> place(order.size());
  for (int i = 0; i < order.size(); ++i)
    place.indices()[order[i]] = i;
  Sparse ordered(lower.rows(), lower.cols());
  ordered.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(place);
  const Sparse sorted = ordered.transpose(); // which the permutation leaves unsorted
  return sorted.transpose();
}

} // namespace frictionbeam
