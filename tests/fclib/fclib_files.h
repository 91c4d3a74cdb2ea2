// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "../check.h"

#include <Eigen/Dense>
#include <Eigen/SparseCore>

extern "C" {
#include <fclib.h>
}

#include <filesystem>
#include <functional>
#include <vector>

/// Contact problems to and from files, by FCLIB's own library.
namespace fclib_files {

namespace fs = std::filesystem;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Problem {
  int dimension = 3;
  MatrixXd W;
  VectorXd q, mu;
};

/// A matrix as FCLIB keeps it: nz = -2 rows, -1 columns, 0 triplets.
struct StoredMatrix {
  StoredMatrix(const MatrixXd &matrix, const int kind) {
    const Eigen::SparseMatrix<double> by_columns = matrix.sparseView();
    const Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows = by_columns;
    const int n = by_columns.nonZeros();
    if (kind == -1)
      take(by_columns.outerIndexPtr(), matrix.cols() + 1, by_columns.innerIndexPtr(),
           by_columns.valuePtr(), n);
    else
      take(by_rows.outerIndexPtr(), matrix.rows() + 1, by_rows.innerIndexPtr(), by_rows.valuePtr(),
           n);
    if (kind == 0) {
      p.clear();
      for (int row = 0; row < matrix.rows(); ++row)
        p.insert(p.end(), by_rows.outerIndexPtr()[row + 1] - by_rows.outerIndexPtr()[row], row);
    }
    stored = {n,
              static_cast<int>(matrix.rows()),
              static_cast<int>(matrix.cols()),
              p.data(),
              i.data(),
              x.data(),
              kind == 0 ? n : kind,
              nullptr};
  }

  std::vector<int> p, i;
  std::vector<double> x;
  fclib_matrix stored;

private:
  void take(const int *outer, const int n_outer, const int *inner, const double *values,
            const int n) {
    p.assign(outer, outer + n_outer);
    i.assign(inner, inner + n);
    x.assign(values, values + n);
  }
};

/// @param spoil may change the matrix before it is written
inline void write(const fs::path &path, Problem problem, const int kind = -1,
                  const std::function<void(StoredMatrix &)> &spoil = {}) {
  StoredMatrix W(problem.W, kind);
  if (spoil)
    spoil(W);
  fclib_local local{};
  local.W = &W.stored;
  local.q = problem.q.data();
  local.mu = problem.mu.data();
  local.spacedim = problem.dimension;
  CHECK(fclib_write_local(&local, path.c_str()) == 1);
}

inline MatrixXd dense(const fclib_matrix &matrix) {
  CHECK(matrix.nz == -1); // what the program writes
  MatrixXd result = MatrixXd::Zero(matrix.m, matrix.n);
  for (int column = 0; column < matrix.n; ++column)
    for (int t = matrix.p[column]; t < matrix.p[column + 1]; ++t)
      result(matrix.i[t], column) = matrix.x[t];
  return result;
}

inline VectorXd vector(const double *values, const int n) {
  return Eigen::Map<const VectorXd>(values, n);
}

struct Solution {
  VectorXd u, r;
};

inline Solution read_solution(const fs::path &path, const int n) {
  fclib_solution *const solution = fclib_read_solution(path.c_str());
  const Solution result{vector(solution->u, n), vector(solution->r, n)};
  fclib_delete_solutions(solution, 1);
  return result;
}

} // namespace fclib_files
