// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line/full_matrices.h"
#include "model/line_state.h"
#include "model/model.h"
#include <frictionbeam/contact/line_factorization.h>

#include <functional>

namespace frictionbeam {

/// One eigenfrequency with its shape.
struct Mode {
  double frequency = 0.; ///< [Hz]
  Vector unknowns;       ///< shape, q^T M q = 1 kg m2
  double residual = 0.;  ///< |K q - w^2 M q| / (w^2 |M q|)
};

/**
 * Free vibrations K q = w^2 M q of the line with the supports that hold in a given state: a contact
 * that is open does not, a closed one holds along its normal, one that sticks sideways too if
 * friction is to hold. A rigid contact is held as rigid_holds() says.
 *
 * Large problems go to ARPACK through deal.II, in shift-invert mode; small ones, and those that ask
 * for a large part of all modes, to Eigen's dense solver. Sylvester's law of inertia then counts
 * the eigenvalues below the last one, so that none is missed. See doc/theory.md, "Modes and
 * spectra".
 */
class ModalAnalysis {
public:
  /// @param state its contacts decide what holds.
  /// @throws UserError if the eigenvalues cannot be found.
  ModalAnalysis(const Model &model, const LineState &state, const ModalSettings &settings);

  const std::vector<Mode> &modes() const { return found; }
  const std::string &method() const { return how; }

  /// Motion of all degrees of freedom, at rest, when the supports called @p supports move by a unit
  /// in direction @p d; no names: all of them, and the line with them.
  Vector support_motion(const unsigned int d, const std::vector<std::string> &supports) const;
  /// Forces of inertia on the unknowns, up to sign, for a unit acceleration of such a motion.
  Vector inertia(const Vector &support_motion) const;
  /// r^T M r of such a motion [kg].
  double mass(const Vector &support_motion) const {
    return support_motion.dot(matrices.mass() * support_motion);
  }
  /// Mass that moves in direction @p d when everything does [kg].
  double total_mass(const unsigned int d) const;

  /// The line displaced, with the contact forces that this takes and no loads, and the
  /// accelerations of all degrees of freedom, those that are held included.
  struct Vibration {
    LineState state;
    Vector accelerations; ///< [m/s2, rad/s2]
  };
  Vibration at_rest() const;
  /// What mode @p k has where its motion is largest: M a = -K u.
  Vibration of_mode(const unsigned int k) const;
  /// The static answer to forces of inertia @p motion, of all degrees of freedom, has per unit
  /// acceleration of the ground.
  Vibration of_inertia(const Vector &motion) const;
  /// Motion of all degrees of freedom in mode @p k.
  Vector motion(const unsigned int k) const {
    return matrices.unknowns_to_dofs() * found[k].unknowns;
  }

private:
  LineState displaced(const Vector &unknowns) const;
  void hold_contacts(const LineState &state, const bool friction);
  void solve_dense(const unsigned int n);
  /// Motion of all that is held when the supports of these names move by a unit in direction @p d.
  Vector held_motion(const unsigned int d, const std::vector<std::string> &names) const;
  bool solve_sparse(const unsigned int n, const unsigned int n_vectors);
  void normalize();

  const Model &model;
  const LineState &start;
  const FullMatrices matrices;
  Eigen::SparseMatrix<double> M;
  SparseMatrix K;                     ///< with the contacts that hold
  const double shift;                 ///< (rad/s)^2 below zero: a line that floats can be factored
  ContactResponse held;               ///< its tangents are the contacts' stiffness
  contact::LineFactorization shifted; ///< of K + shift M
  contact::LineFactorization factors; ///< of K
  std::vector<Mode> found;
  std::string how;
};

} // namespace frictionbeam
