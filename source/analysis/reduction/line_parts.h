// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/eigenpairs.h"

#include "model/line_state.h"
#include "model/model.h"

#include <memory>

namespace frictionbeam {

/**
 * A connected part of the inner unknowns i, with the kept unknowns b that it borders on: what a
 * run of pipe between two contacts does by itself. A straight run falls apart further, into
 * stretching, torsion and bending in two planes.
 */
struct PartOfLine {
  std::vector<int> inside, border;              ///< unknowns; places among the kept ones
  Eigen::SparseMatrix<double> K, M, C;          ///< inside
  Eigen::MatrixXd K_border, M_border, C_border; ///< rows inside, columns of the border
  std::unique_ptr<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> factors; ///< of K
  Eigen::MatrixXd constraint_modes; ///< -K^-1 K_border: statics of the border's motions
  bool has_mass = false;            ///< all of its unknowns have, or none has
  std::vector<Eigenpair> modes;     ///< with the border held: the lowest, as many as were needed
  bool has_all_modes = false;

  Vector inner(const Vector &unknowns) const; ///< of a vector on all unknowns
};

/**
 * The line cut at the nodes of its contacts: their unknowns are kept, and the rest falls apart into
 * parts, each with its constraint modes and fixed-interface modes as R. R. Craig and M. C. C.
 * Bampton have them (AIAA J. 6 (1968) 1313-1319). Where unknowns with and without mass meet, those
 * with mass are kept as well, so that a part without mass is condensed exactly (doc/dynamics.md,
 * "Reduction to contact nodes and modes").
 */
class LineParts {
public:
  /// @throws UserError if a part can move freely between its contacts.
  explicit LineParts(const Model &model);

  const std::vector<int> &kept() const { return kept_unknowns; } ///< ascending
  /// Among the kept; -1 of an inner one.
  int place(const int unknown) const { return place_of_kept[unknown]; }
  /// Part and place in it of an inner unknown.
  const std::pair<int, int> &home(const int unknown) const { return homes[unknown]; }
  unsigned int size() const { return list.size(); }
  const PartOfLine &operator[](const unsigned int p) const { return list[p]; }
  unsigned int n_inner() const { return homes.size() - kept_unknowns.size(); }
  unsigned int n_modes() const; ///< there are, of all parts together

  /// How many modes of each part are among the @p n lowest of all.
  struct Choice {
    std::vector<unsigned int> n_of_part;
    unsigned int n = 0;
    double highest = 0.,
           next = 0.; ///< w^2 of the last one taken and of the first left out; 0: none

    void transfer(Archive &archive) { archive(n_of_part, n, highest, next); }
  };
  Choice lowest(const unsigned int n);
  /// Likewise all modes below @p eigenvalue.
  Choice below(const double eigenvalue);

  /// The modes that were found, whose last digits depend on what was asked for before.
  void transfer(Archive &archive);

private:
  void keep(const Model &model);
  void find_parts(const Model &model);
  void fill(const Model &model, PartOfLine &part);
  /// Find more modes until the part has one above @p eigenvalue, or all.
  void find_modes(PartOfLine &part, const double eigenvalue);
  void find_more_modes(PartOfLine &part);

  std::vector<int> kept_unknowns, place_of_kept;
  std::vector<std::pair<int, int>> homes;
  std::vector<PartOfLine> list;
};

} // namespace frictionbeam
