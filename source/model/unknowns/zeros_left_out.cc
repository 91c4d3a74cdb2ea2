// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/unknowns/zeros_left_out.h"

#include <algorithm>

namespace frictionbeam {

ZerosLeftOut::ZerosLeftOut(SparseMatrix &matrix) {
  const int n = matrix.rows(), *const outer = matrix.outerIndexPtr(),
            *const inner = matrix.innerIndexPtr();
  const double *const values = matrix.valuePtr();
  const auto n_left = std::count_if(values, values + matrix.nonZeros(),
                                    [](const double value) { return value != 0.; });
  SparseMatrix left(n, matrix.cols());
  left.resizeNonZeros(n_left);
  at_even_place.reserve(n_left);
  int next = 0;
  for (int i = 0; i < n; ++i) {
    const int begin = outer[i], end = outer[i + 1];
    if (i == 0 || !std::equal(inner + begin, inner + end, inner + outer[i - 1], inner + begin)) {
      rows.push_back({i, static_cast<std::uint32_t>(runs.size())});
      for (int p = begin; p < end; ++p)
        if (p > begin && inner[p] == runs.back().end)
          ++runs.back().end;
        else
          runs.push_back({inner[p], inner[p] + 1});
    }
    for (int p = begin; p < end; ++p)
      if (values[p] != 0.) {
        left.innerIndexPtr()[next] = inner[p];
        left.valuePtr()[next++] = values[p];
        at_even_place.push_back((p - begin) % 2 == 1);
      }
    left.outerIndexPtr()[i + 1] = next;
  }
  runs.shrink_to_fit();
  rows.shrink_to_fit();
  matrix.swap(left);
}

SparseMatrix ZerosLeftOut::restored(const SparseMatrix &matrix) const {
  const int n = matrix.rows();
  SparseMatrix result(n, matrix.cols());
  const auto for_each_rows = [&](const auto &use) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const bool is_last = k + 1 == rows.size();
      const auto begin = runs.begin() + rows[k].first,
                 end = is_last ? runs.end() : runs.begin() + rows[k + 1].first;
      for (int i = rows[k].begin; i < (is_last ? n : rows[k + 1].begin); ++i)
        use(i, begin, end);
    }
  };
  int *const outer = result.outerIndexPtr();
  for_each_rows([&](const int i, auto run, const auto end) {
    outer[i + 1] = outer[i];
    for (; run != end; ++run)
      outer[i + 1] += run->end - run->begin;
  });
  result.resizeNonZeros(outer[n]);
  for_each_rows([&](const int i, auto run, const auto end) {
    int place = outer[i], p = matrix.outerIndexPtr()[i];
    for (; run != end; ++run)
      for (int column = run->begin; column < run->end; ++column, ++place) {
        const bool is_left =
            p < matrix.outerIndexPtr()[i + 1] && matrix.innerIndexPtr()[p] == column;
        result.innerIndexPtr()[place] = column;
        result.valuePtr()[place] = is_left ? matrix.valuePtr()[p++] : 0.;
      }
  });
  return result;
}

Vector ZerosLeftOut::unbalanced(const SparseMatrix &matrix, const Vector &right_hand_side,
                                const Vector &unknowns, const Vector &low) const {
  const int *const outer = matrix.outerIndexPtr(), *const inner = matrix.innerIndexPtr();
  const double *const values = matrix.valuePtr();
  Vector forces(unknowns.size());
  for (int i = 0; i < matrix.rows(); ++i) {
    long double sum = right_hand_side[i], other = 0.; // as the whole matrix is summed up
    for (int p = outer[i]; p < outer[i + 1]; ++p) {
      const long double motion = static_cast<long double>(unknowns[inner[p]]) + low[inner[p]];
      if (at_even_place[p])
        other += values[p] * motion;
      else
        sum -= values[p] * motion;
    }
    forces[i] = static_cast<double>(sum - other);
  }
  return forces;
}

} // namespace frictionbeam
