// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/local_problem.h>

#include <functional>

namespace frictionbeam::contact {

/// Contacts up to which all states of a planar problem are tried: 4096 systems of 12 equations.
constexpr unsigned int most_planar_contacts = 6;

/**
 * All combinations of what planar contacts may do, open, stick or slip to either side, one after
 * the other: each is a linear problem, u = 0 of those that stick, u_N = 0 and r_T = -+mu r_N of
 * those that slip, solved by least squares. A problem that has a solution has it here, unless W
 * lets several be.
 * @param takes the forces, and says whether they are a solution: then it ends
 * @return whether one was taken
 */
bool try_planar_states(const LocalProblem &problem,
                       const std::function<bool(const Eigen::VectorXd &)> &takes);

} // namespace frictionbeam::contact
