// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace frictionbeam {

/**
 * Friction of contacts whose direction of slip turns, over a piece of a motion that is linear but
 * for it. With the normal force N, the velocity u relative to the ground and the shear stiffness k,
 *   tau = mu N s,   |s| = 1,   s x w = 0,   w = u - tau'/k   (u on a rigid surface),
 * where u and N depend on the friction tau of all such contacts linearly. tau is a polynomial in
 * time that satisfies these equations at Gauss' points of the piece (with its value at the start
 * given where k is finite); the responses of u and N to polynomials are exact. So the only error is
 * that of the equations between the points. It is measured there, and by the last Chebyshev
 * coefficients of tau; what it changes in velocities is of order 2m for m points (Hairer, Norsett,
 * Wanner, Solving Ordinary Differential Equations I, II.7). Being implicit the method can begin
 * where u is zero.
 */
class CurvedSlip {
public:
  /// One contact, over the whole piece: x = 1 is its end.
  struct Contact {
    double coefficient = 0.;   ///< mu
    double compliance = 0.;    ///< 1/k [m/N]
    Eigen::Vector2d direction; ///< at the start, s
    Eigen::Vector2d force;     ///< at the start, tau [N]; for contacts with a compliance
    Eigen::MatrixXd free;      ///< u_1, u_2 [m/s] and N [N] without the friction of all, by powers
  };
  /// To a constant force of size 1 along tau_d of contact l: column l, d of all contacts' u_1, u_2
  /// and N, by powers, 3 rows a contact.
  using Responses = std::vector<Eigen::MatrixXd>;

  /**
   * Find the friction.
   * @param length what x = 1 stands for [s]
   * @param response_length the same for the responses
   * @param longest,shortest parts of the length to be tried: the longest is halved as long as the
   * errors are too large
   * @param tolerance for the equations between the points, of the friction
   * @return the part of the length for which it was found, 0 if for none
   */
  double solve(const std::vector<Contact> &contacts, const Responses &responses,
               const double length, const double response_length, const double longest,
               const double shortest, const double tolerance = 1e-10);

  /// Of each contact, 2 rows by powers of x, x = 1 at the end of that part.
  std::vector<Eigen::MatrixXd> friction, direction;

private:
  bool solve_within(const std::vector<Contact> &contacts, const Responses &responses,
                    const double length, const double tolerance);
};

} // namespace frictionbeam
