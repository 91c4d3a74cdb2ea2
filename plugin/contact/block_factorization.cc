// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block_factorization.h"

#include <Eigen/OrderingMethods>

#include <cmath>
#include <numeric>

namespace frictionbeam::contact {

void BlockFactorization::analyze(const SparseMatrix &matrix) {
  const int n = matrix.rows();
  old_of_new.resize(n);
  std::iota(old_of_new.begin(), old_of_new.end(), 0);
  permuted.resize(0, 0);
  source.clear();
  std::vector<int> parent, below;
  fill = find_tree(matrix, parent, below);
  if (fill > 2 * static_cast<std::size_t>(matrix.nonZeros()))
    reorder(matrix, parent, below);
  const SparseMatrix &ordered = source.empty() ? matrix : permuted;
  find_blocks(parent, below);
  find_rows(ordered);
  diagonal.resize(n);
}

void BlockFactorization::reorder(const SparseMatrix &matrix, std::vector<int> &parent,
                                 std::vector<int> &below) {
  const int n = matrix.rows();
  Eigen::SparseMatrix<double, Eigen::ColMajor, int> pattern = matrix;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(pattern, permutation);
  const int *const old_indices = permutation.indices().data();
  std::vector<int> new_of_old(n);
  for (int k = 0; k < n; ++k)
    new_of_old[old_indices[k]] = k;
  std::vector<Eigen::Triplet<double>> places; // as numbers, which doubles hold exactly
  places.reserve(matrix.nonZeros());
  for (int row = 0; row < n; ++row)
    for (int p = matrix.outerIndexPtr()[row]; p < matrix.outerIndexPtr()[row + 1]; ++p)
      places.emplace_back(new_of_old[row], new_of_old[matrix.innerIndexPtr()[p]], p);
  SparseMatrix other(n, n);
  other.setFromTriplets(places.begin(), places.end());
  std::vector<int> other_parent, other_below;
  const std::size_t other_fill = find_tree(other, other_parent, other_below);
  if (other_fill >= fill)
    return;
  fill = other_fill;
  parent = std::move(other_parent);
  below = std::move(other_below);
  old_of_new.assign(old_indices, old_indices + n);
  permuted = std::move(other);
  source.assign(permuted.valuePtr(), permuted.valuePtr() + permuted.nonZeros());
}

std::size_t BlockFactorization::find_tree(const SparseMatrix &matrix, std::vector<int> &parent,
                                          std::vector<int> &below) {
  const int n = matrix.rows();
  std::vector<int> visited(n, -1);
  parent.assign(n, -1);
  below.assign(n, 0);
  for (int k = 0; k < n; ++k) {
    visited[k] = k;
    for (int p = matrix.outerIndexPtr()[k]; p < matrix.outerIndexPtr()[k + 1]; ++p)
      for (int i = matrix.innerIndexPtr()[p]; i < k && visited[i] != k; i = parent[i]) {
        if (parent[i] == -1)
          parent[i] = k;
        ++below[i];
        visited[i] = k;
      }
  }
  return std::accumulate(below.begin(), below.end(), std::size_t(0));
}

void BlockFactorization::find_blocks(const std::vector<int> &parent,
                                     const std::vector<int> &below) {
  constexpr int least_width = 6; // narrower ones are joined: zeros cost less than their overhead
  const int n = parent.size();
  blocks.clear();
  for (int k = 0; k < n;) {
    int end = k + 1;
    while (end < n && parent[end - 1] == end && below[end - 1] == below[end] + 1)
      ++end;
    if (k > 0 && parent[k - 1] == k && end - blocks.back().first <= least_width)
      blocks.back().width = end - blocks.back().first;
    else
      blocks.push_back({k, end - k});
    blocks.back().n_below = below[end - 1];
    k = end;
  }
  block_of.resize(n);
  std::size_t n_rows = 0, n_values = 0;
  for (Block &block : blocks) {
    std::fill_n(block_of.begin() + block.first, block.width, &block - blocks.data());
    block.rows = n_rows;
    block.values = n_values;
    n_rows += block.n_below;
    n_values += static_cast<std::size_t>(block.width) * block.stride();
  }
  rows.resize(n_rows);
  values.resize(n_values);
}

void BlockFactorization::find_rows(const SparseMatrix &matrix) {
  std::vector<int> first_child(blocks.size(), -1), next(blocks.size(), -1),
      taken(matrix.rows(), -1);
  for (int b = 0; b < static_cast<int>(blocks.size()); ++b) {
    Block &block = blocks[b];
    int *const begin = rows.data() + block.rows, *end = begin;
    const auto take = [&](const int row) {
      if (row >= block.end() && taken[row] != b) {
        taken[row] = b;
        *end++ = row;
      }
    };
    for (int p = matrix.outerIndexPtr()[block.first]; p < matrix.outerIndexPtr()[block.end()]; ++p)
      take(matrix.innerIndexPtr()[p]);
    for (int child = first_child[b]; child >= 0; child = next[child])
      std::for_each_n(rows.begin() + blocks[child].rows, blocks[child].n_below, take);
    block.in_one_run = true;
    if (end == begin)
      continue;
    std::sort(begin, end);
    block.in_one_run = end[-1] == block.end() + block.n_below - 1;
    int &siblings = first_child[block_of[*begin]];
    next[b] = siblings;
    siblings = b;
  }
}

const SparseMatrix &BlockFactorization::ordered(const SparseMatrix &matrix) {
  if (source.empty())
    return matrix;
  for (std::size_t p = 0; p < source.size(); ++p)
    permuted.valuePtr()[p] = matrix.valuePtr()[source[p]];
  return permuted;
}

bool BlockFactorization::factorize(const SparseMatrix &unordered) {
  const SparseMatrix &matrix = ordered(unordered);
  Work work(matrix.rows(), blocks.size());
  work.next_entry.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.rows());
  return factorize_with([&](const int b) { assemble(blocks[b], matrix, work); }, work);
}

bool BlockFactorization::factorize_changed(const std::vector<double> &changed) {
  Work work(diagonal.size(), blocks.size());
  return factorize_with([&](const int b) { assemble_changed(b, changed, work); }, work);
}

template <typename Assemble>
bool BlockFactorization::factorize_with(const Assemble &assemble, Work &work) {
  share = 1.;
  for (int b = 0; b < static_cast<int>(blocks.size()); ++b) {
    const Block &block = blocks[b];
    find_places(block, work);
    assemble(b);
    for (int earlier = work.first[b]; earlier >= 0;) {
      const int next = work.next[earlier];
      take_from(block, blocks[earlier], work.done[earlier], work);
      pass_on(earlier, work);
      earlier = next;
    }
    if (!eliminate(block, work))
      return false;
    pass_on(b, work);
  }
  return true;
}

BlockFactorization::Work::Work(const std::size_t n_rows, const std::size_t n_blocks)
    : place(n_rows), size(n_rows, 0.), first(n_blocks, -1), next(n_blocks, -1), done(n_blocks, 0) {}

void BlockFactorization::find_places(const Block &block, Work &work) const {
  std::iota(work.place.begin() + block.first, work.place.begin() + block.end(), 0);
  for (int k = 0; k < block.n_below; ++k)
    work.place[rows[block.rows + k]] = block.width + k;
}

std::size_t BlockFactorization::place_of(const int row, const int column) const {
  const auto [first, last] = std::minmax(row, column);
  const Block &block = blocks[block_of[first]];
  const int *const below = rows.data() + block.rows;
  const int place =
      last < block.end()
          ? last - block.first
          : block.width + std::lower_bound(below, below + block.n_below, last) - below;
  return 2 * (block.values + (first - block.first) * block.stride() + place) + (column < row);
}

void BlockFactorization::keep(const SparseMatrix &unordered, const std::vector<int> &changing) {
  const SparseMatrix &matrix = ordered(unordered);
  Work work(matrix.rows(), blocks.size());
  work.next_entry.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.rows());
  for (const Block &block : blocks) {
    find_places(block, work);
    assemble(block, matrix, work);
  }
  kept = values;
  std::vector<int> new_of_old(old_of_new.size());
  for (std::size_t k = 0; k < old_of_new.size(); ++k)
    new_of_old[old_of_new[k]] = k;
  const int *const outer = unordered.outerIndexPtr();
  changes.clear();
  for (std::size_t k = 0; k < changing.size(); ++k) {
    const int row = std::upper_bound(outer, outer + unordered.rows(), changing[k]) - outer - 1;
    changes.push_back(
        {static_cast<int>(k),
         place_of(new_of_old[row], new_of_old[unordered.innerIndexPtr()[changing[k]]])});
  }
  std::sort(changes.begin(), changes.end(),
            [](const Change &a, const Change &b) { return a.to < b.to; });
  first_change.assign(1, 0);
  for (const Block &block : blocks) {
    const std::size_t end =
        2 * (block.values + static_cast<std::size_t>(block.width) * block.stride());
    std::size_t k = first_change.back();
    while (k < changes.size() && changes[k].to < end)
      ++k;
    first_change.push_back(k);
  }
}

void BlockFactorization::assemble_changed(const int b, const std::vector<double> &changed,
                                          Work &work) {
  const Block &block = blocks[b];
  double *const numbers = values.front().data();
  std::copy_n(kept[block.values].data(), 2 * block.width * block.stride(),
              numbers + 2 * block.values);
  for (int k = first_change[b]; k < first_change[b + 1]; ++k)
    numbers[changes[k].to] = changed[changes[k].value];
  const Pair *row = &values[block.values];
  for (int j = 0; j < block.width; ++j, row += block.stride())
    work.size[block.first + j] = std::abs(row[j][0]);
}

void BlockFactorization::pass_on(const int b, Work &work) const {
  if (work.done[b] == blocks[b].n_below)
    return;
  int &first = work.first[block_of[rows[blocks[b].rows + work.done[b]]]];
  work.next[b] = first;
  first = b;
}

void BlockFactorization::assemble(const Block &block, const SparseMatrix &matrix, Work &work) {
  std::fill_n(values.begin() + block.values, block.width * block.stride(), Pair(0., 0.));
  const int *const inner = matrix.innerIndexPtr();
  const double *const entries = matrix.valuePtr();
  int *const next_entry = work.next_entry.data();
  for (int j = block.first; j < block.end(); ++j) {
    Pair *const row = &values[block.values + (j - block.first) * block.stride()];
    // Rows before j have had what is before it in its row.
    int p = next_entry[j];
    const int end = matrix.outerIndexPtr()[j + 1];
    if (p < end && inner[p] == j) {
      row[j - block.first][0] = entries[p];
      work.size[j] = std::abs(entries[p]);
      ++p;
    }
    // With each entry the mirrored one.
    if (block.in_one_run)
      for (; p < end; ++p) {
        const int column = inner[p];
        double *const pair = row[column - block.first].data();
        pair[0] = entries[p];
        pair[1] = entries[next_entry[column]++];
      }
    else
      for (; p < end; ++p) {
        const int column = inner[p];
        double *const pair = row[work.place[column]].data();
        pair[0] = entries[p];
        pair[1] = entries[next_entry[column]++];
      }
  }
}

void BlockFactorization::take_from(const Block &block, const Block &earlier, int &done,
                                   Work &work) {
  const int *const its_rows = rows.data() + earlier.rows;
  const int n = earlier.n_below, begin = done, place = work.place[its_rows[begin]];
  while (done < n && its_rows[done] < block.end())
    ++done;
  const Pair *const from = &values[earlier.values + earlier.width + begin];
  if (work.place[its_rows[n - 1]] - place == n - 1 - begin) {
    kernels.subtract(from->data(), earlier.stride(), earlier.width,
                     values[block.values + place * (block.stride() + 1)].data(), block.stride(),
                     done - begin, n - begin, &work.size[its_rows[begin]]);
    return;
  }
  for (int row = begin; row < done; ++row) {
    Pair *const to = &values[block.values + work.place[its_rows[row]] * block.stride()];
    double &size = work.size[its_rows[row]];
    const Pair *pivot = from + (row - begin);
    for (int p = 0; p < earlier.width; ++p, pivot += earlier.stride()) {
      const Pair factor = pivot->reverse();
      size = std::max(size, std::abs(pivot->prod()));
      for (int k = row; k < n; ++k)
        to[work.place[its_rows[k]]] -= factor * pivot[k - row];
    }
  }
}

bool BlockFactorization::eliminate(const Block &block, Work &work) {
  return kernels.eliminate(values[block.values].data(), block.stride(), block.width,
                           &work.size[block.first], &diagonal[block.first], share);
}

Vector BlockFactorization::solve(const Vector &right_hand_side) const {
  const int n = diagonal.size();
  Vector x = right_hand_side;
  if (!source.empty())
    for (int k = 0; k < n; ++k)
      x[k] = right_hand_side[old_of_new[k]];
  std::vector<double> copy; // of what a block couples that is not in one run
  const auto local = [&](const Block &block) {
    if (block.in_one_run)
      return x.data() + block.first;
    copy.resize(block.stride());
    std::copy_n(x.data() + block.first, block.width, copy.begin());
    for (int k = 0; k < block.n_below; ++k)
      copy[block.width + k] = x[rows[block.rows + k]];
    return copy.data();
  };
  for (const Block &block : blocks) {
    double *const at = local(block);
    kernels.solve_lower(values[block.values].data(), block.stride(), block.width, at);
    if (!block.in_one_run) {
      std::copy_n(copy.begin(), block.width, x.data() + block.first);
      for (int k = 0; k < block.n_below; ++k)
        x[rows[block.rows + k]] = copy[block.width + k];
    }
  }
  for (auto block = blocks.rbegin(); block != blocks.rend(); ++block) {
    double *const at = local(*block);
    kernels.solve_upper(values[block->values].data(), block->stride(), block->width,
                        &diagonal[block->first], at);
    if (!block->in_one_run)
      std::copy_n(copy.begin(), block->width, x.data() + block->first);
  }
  if (source.empty())
    return x;
  Vector result(n);
  for (int k = 0; k < n; ++k)
    result[old_of_new[k]] = x[k];
  return result;
}

} // namespace frictionbeam::contact
