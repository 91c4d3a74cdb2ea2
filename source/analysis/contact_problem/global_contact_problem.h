// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line_state.h"
#include "model/model.h"
#include <frictionbeam/contact/local_solver.h>

#include <optional>

namespace frictionbeam {

/**
 * The friction-contact problem of one static increment, before it is condensed: find v, u and r
 * with M v = H r + f,   u = H^T v + w, and the laws of contact::LocalProblem between u and r. v are
 * the free unknowns of the line, followed by the elastic deflection of each contact component whose
 * element is not rigid; M is the line's stiffness without contacts, followed by the stiffness of
 * those elements. u are the gap and the slips of the increment [m], r the forces on the pipe, along
 * the normal into the pipe and against those slips [N].
 */
struct GlobalContactProblem {
  unsigned int dimension = 3;    ///< components of a contact; 2 in files of others only
  SparseMatrix M;                ///< [N/m], and N, N m by rotations
  Eigen::SparseMatrix<double> H; ///< unknowns x contact components
  Vector f, w;
  Vector friction; ///< mu, one for each contact
  Vector solution; ///< v as the line was solved
  Vector reactions;

  /// Why the problem cannot be said in this form; nothing else is set then.
  std::string obstacle;

  Vector motions(const Vector &v) const { return H.transpose() * v + w; }
  /// M v - H r - f.
  Vector unbalanced(const Vector &v, const Vector &r) const { return M * v - H * r - f; }
};

/// The problem that leads from one committed state to the next, with its solution.
GlobalContactProblem global_contact_problem(const Model &model, const LineState &before,
                                            const LineState &after);

/**
 * W = H^T M^-1 H, q = H^T M^-1 f + w.
 * @return nothing if M is not positive definite, or so near to singular that no digit of W would be
 * right: the line rests on its contacts alone.
 */
std::optional<contact::LocalProblem> condense(const GlobalContactProblem &problem);

/// v of M v = H r + f, of a problem that can be condensed.
Vector solve_for_motion(const GlobalContactProblem &problem, const Vector &reactions);

} // namespace frictionbeam
