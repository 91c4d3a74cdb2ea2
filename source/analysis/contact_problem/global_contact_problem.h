// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/local_solver.h>
#include "model/line_state.h"
#include "model/model.h"

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
  SparseMatrix M;                ///< [N/m], and N, N m by rotations
  Eigen::SparseMatrix<double> H; ///< unknowns x contact components
  Vector f, w;
  Vector friction; ///< mu, one for each contact
  Vector solution; ///< v as the line was solved
  Vector reactions;

  /// Why the problem cannot be said in this form; nothing else is set then.
  std::string obstacle;

  Vector motions(const Vector &v) const { return H.transpose() * v + w; }
};

/// The problem that leads from one committed state to the next, with its solution.
GlobalContactProblem global_contact_problem(const Model &model, const LineState &before,
                                            const LineState &after);

/**
 * W = H^T M^-1 H, q = H^T M^-1 f + w.
 * @return nothing if M is singular, or so near to it that no digit of W would be right: the line
 * rests on its contacts alone.
 */
std::optional<contact::LocalProblem> condense(const GlobalContactProblem &problem);

} // namespace frictionbeam
