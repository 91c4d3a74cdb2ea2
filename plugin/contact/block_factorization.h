// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "pivot_kernels.h"
#include <frictionbeam/contact/matrix.h>

#include <algorithm>

namespace frictionbeam::contact {

/**
 * L D U factorization of a matrix as LineFactorization takes it, for a matrix that is factored
 * again and again: half the instructions where nodes have six unknowns, and more to
 * prepare.
 *
 * Columns of L with the same rows, as those of a node's unknowns, are a block, and a block takes
 * from those before it what they subtract from it (E. G. Ng, B. W. Peyton, Block sparse Cholesky
 * algorithms on advanced uniprocessor computers, SIAM J. Sci. Comput. 14, 1993,
 * doi:10.1137/0914063), carried out for columns of L and rows of U at once. Where natural numbering
 * fills in (loops), minimum degree is used instead.
 */
class BlockFactorization {
public:
  /// Ordering and pattern of the factors; values are not read.
  void analyze(const SparseMatrix &matrix);

  /// Factor a matrix of the analyzed pattern. @return false if a pivot vanishes: no factors then.
  bool factorize(const SparseMatrix &matrix);

  /// Keep the values of a matrix of the analyzed pattern, from which others differ at these places
  /// alone (in the order of its values).
  void keep(const SparseMatrix &matrix, const std::vector<int> &changing);
  /// Factor the matrix that is kept, with these values at the places that change.
  bool factorize_changed(const std::vector<double> &changed);

  /// Solve with the last factors.
  Vector solve(const Vector &right_hand_side) const;

  /// Of the diagonal D; of a symmetric matrix it is positive just where the matrix is positive
  /// definite.
  double least_pivot() const { return *std::min_element(diagonal.begin(), diagonal.end()); }

  /// Least part of what a pivot is a sum of that is left of it: near rounding, something is free.
  double least_share() const { return share; }

  /// Of L below its diagonal.
  std::size_t n_nonzeros() const { return fill; }

private:
  using Pair = Eigen::Array2d; ///< an entry of U, and its mirror image in L

  /**
   * Columns of L, and rows of U, that have the same places below (beside) their own: values of its
   * own columns and of the places below are in one run for each.
   */
  struct Block {
    int first, width, n_below = 0;
    std::size_t rows = 0, values = 0; ///< where they begin
    bool in_one_run = false;          ///< the places below follow the columns

    int end() const { return first + width; }
    int stride() const { return width + n_below; }
  };
  /// Of one factorization.
  struct Work {
    Work(const std::size_t n_rows, const std::size_t n_blocks);

    std::vector<int> next_entry;  ///< of each row of a matrix, that no block has yet
    std::vector<int> place;       ///< of a row in the block at hand
    std::vector<double> size;     ///< of each pivot, the largest number that it is a sum of
    std::vector<int> first, next; ///< list of the blocks whose next rows are in a block
    std::vector<int> done;        ///< rows below of a block that have taken from it
  };

  /// Take minimum degree, if it fills in less.
  void reorder(const SparseMatrix &matrix, std::vector<int> &parent, std::vector<int> &below);
  /// Elimination tree, and numbers below the diagonal in each column of L. @return all of these
  static std::size_t find_tree(const SparseMatrix &matrix, std::vector<int> &parent,
                               std::vector<int> &below);
  void find_blocks(const std::vector<int> &parent, const std::vector<int> &below);
  void find_rows(const SparseMatrix &matrix);
  /// In the order of elimination.
  const SparseMatrix &ordered(const SparseMatrix &matrix);
  /// @param assemble puts the matrix into the values of a block
  template <typename Assemble>
  bool factorize_with(const Assemble &assemble, Work &work);
  void find_places(const Block &block, Work &work) const;
  void assemble(const Block &block, const SparseMatrix &matrix, Work &work);
  /// What the matrix that is kept has there, and what has changed of it.
  void assemble_changed(const int block, const std::vector<double> &changed, Work &work);
  /// Of the matrix: place of an entry among the numbers of all pairs.
  std::size_t place_of(const int row, const int column) const;
  /// Subtract what an earlier block makes of the rows that it has in this one.
  void take_from(const Block &block, const Block &earlier, int &done, Work &work);
  /// @return false if a pivot vanishes
  bool eliminate(const Block &block, Work &work);
  /// Put a block into the list of that which its next rows are in.
  void pass_on(const int block, Work &work) const;

  const PivotKernels &kernels = PivotKernels::best();
  std::vector<int> old_of_new;
  SparseMatrix permuted;   ///< where minimum degree is taken
  std::vector<int> source; ///< of its values among the matrix's; empty where it is not taken
  std::size_t fill = 0;
  double share = 1.; ///< of pivots, the least that is left
  std::vector<Block> blocks;
  std::vector<int> block_of;    ///< of each column
  std::vector<int> rows;        ///< below the blocks, in ascending order
  std::vector<Pair> values;     ///< U, and L divided by the pivots
  std::vector<double> diagonal; ///< D

  /// A value that changes.
  struct Change {
    int value;      ///< among these
    std::size_t to; ///< among the numbers of all pairs
  };
  std::vector<Pair> kept;      ///< the matrix that is kept, as values have it
  std::vector<Change> changes; ///< block by block
  std::vector<int> first_change;
};

} // namespace frictionbeam::contact
