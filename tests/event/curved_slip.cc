// SPDX-License-Identifier: LGPL-2.1-or-later
// Slip along curves by collocation (CurvedSlip) shall meet the closed form of a block that slides
// on a rough floor while a force draws it aside, with an order far above one, and a fine
// integration where the normal force depends on the friction, from rest too.
//
// The block: m u' = F - mu N u/|u|, F along x. With a = F/m, k = mu N/F > 1, u(0) = v0 along y and
// w = tan(phi/2), phi the angle of u with x, dphi/dt = -a sin(phi)/|u| gives
//   |u| = v0/2 w^(k-1) (1 + w^2),   t = v0/(2a) [W(1) - W(w)],  W = w^(k-1)/(k-1) + w^(k+1)/(k+1),
// so that it stops at t = v0 k/(a (k^2 - 1)).
#include "../check.h"

#include "analysis/event/curved_slip.h"

#include <array>

using frictionbeam::CurvedSlip;

namespace {

/// m u' = F - tau and N = N0 + C tau_x: responses to friction and without it.
struct Block {
  double mass, friction, cross_force, normal, coupling;
  Eigen::Vector2d u;

  CurvedSlip::Contact contact(const double length, const Eigen::Vector2d &direction) const {
    CurvedSlip::Contact result;
    result.coefficient = friction;
    result.direction = direction;
    result.force = friction * normal * direction;
    result.free = Eigen::MatrixXd::Zero(3, 2);
    result.free.col(0) << u, normal;
    result.free(0, 1) = cross_force / mass * length;
    return result;
  }
  CurvedSlip::Responses responses(const double length) const {
    CurvedSlip::Responses result(2, Eigen::MatrixXd::Zero(3, 2));
    for (int d = 0; d < 2; ++d)
      result[d](d, 1) = -length / mass;
    result[0](2, 0) = coupling;
    return result;
  }
  /// Velocity after a friction force.
  void move(const Eigen::MatrixXd &tau, const double length) {
    u[0] += cross_force / mass * length;
    for (int k = 0; k < tau.cols(); ++k)
      u -= length / mass * tau.col(k) / (k + 1.);
  }
};

double integral_to(const double w, const double k) {
  return std::pow(w, k - 1.) / (k - 1.) + std::pow(w, k + 1.) / (k + 1.);
}

/// Velocity of the block at a time.
Eigen::Vector2d closed_form(const double a, const double k, const double v0, const double time) {
  double low = 0., high = 1.;
  const double wanted = integral_to(1., k) - 2. * a * time / v0;
  while (high - low > 1e-17 && (low + high) / 2. > low && (low + high) / 2. < high) {
    const double w = (low + high) / 2.;
    (integral_to(w, k) < wanted ? low : high) = w;
  }
  const double w = (low + high) / 2., speed = v0 / 2. * std::pow(w, k - 1.) * (1. + w * w);
  return speed * Eigen::Vector2d(1. - w * w, 2. * w) / (1. + w * w);
}

/// Error of the velocity at a part of the time until it stops, in so many pieces.
double error_with(const double part, const int n_pieces, const double tolerance) {
  Block block{2., 0.4, 5., 30., 0., {0., 3.}};
  const double a = block.cross_force / block.mass,
               k = block.friction * block.normal / block.cross_force,
               end = part * 3. * k / (a * (k * k - 1.)), length = end / n_pieces;
  CurvedSlip curved;
  Eigen::Vector2d direction(0., 1.);
  for (int i = 0; i < n_pieces; ++i) {
    CHECK(curved.solve({block.contact(length, direction)}, block.responses(1.), length, 1., 1., 1.,
                       tolerance) == 1.);
    block.move(curved.friction[0], length);
    direction = block.u.normalized();
  }
  return (block.u - closed_form(a, k, 3., end)).norm() / 3.;
}

/// u' by the law itself: the direction s is that of u, N = N0 + C mu N s_x.
Eigen::Vector2d rate(const Block &block, const Eigen::Vector2d &u) {
  const Eigen::Vector2d s = u.normalized();
  const double N = block.normal / (1. - block.coupling * block.friction * s[0]);
  return Eigen::Vector2d(block.cross_force, 0.) / block.mass - block.friction * N / block.mass * s;
}

void coupled_normal_force() {
  Block block{1., 0.3, 8., 20., 0.7, {-1., 2.}};
  Eigen::Vector2d fine = block.u;
  const double end = 0.3;
  constexpr int n = 20000; // Runge and Kutta's method of order 4
  for (int i = 0; i < n; ++i) {
    const double h = end / n;
    const Eigen::Vector2d k1 = rate(block, fine), k2 = rate(block, fine + h / 2. * k1),
                          k3 = rate(block, fine + h / 2. * k2), k4 = rate(block, fine + h * k3);
    fine += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
  }
  CurvedSlip curved;
  for (double at = 0.; at < end * (1. - 1e-12);) {
    const double length = end - at,
                 part = curved.solve({block.contact(length, block.u.normalized())},
                                     block.responses(0.01), length, 0.01, 1., 1e-6);
    CHECK(part > 0.);
    if (part == 0.)
      return;
    block.move(curved.friction[0], part * length);
    at += part * length;
  }
  CHECK_NEAR(block.u[0], fine[0], 1e-11);
  CHECK_NEAR(block.u[1], fine[1], 1e-11);
}

/// From rest, where the force that starts it is not along the slip that follows: it goes along F,
/// whatever direction is told.
void start_from_rest() {
  Block block{1., 0.3, 8., 20., 0., {0., 0.}};
  CurvedSlip curved;
  const double angle = 0.8;
  CHECK(curved.solve({block.contact(0.1, {std::cos(angle), std::sin(angle)})}, block.responses(1.),
                     0.1, 1., 1., 1.) == 1.);
  block.move(curved.friction[0], 0.1);
  CHECK_NEAR(block.u[0], 0.1 * (8. - 6.), 1e-12);
  CHECK_NEAR(block.u[1], 0., 1e-12);
}

} // namespace

int main() {
  CHECK(error_with(0.5, 2, 1e-10) < 1e-14);
  // Near the end, where the direction is singular, and in pieces so long that errors are seen.
  const std::array<double, 3> errors = {error_with(0.98, 1, 1.), error_with(0.98, 2, 1.),
                                        error_with(0.98, 4, 1.)};
  std::cout << "errors with 1, 2, 4 pieces: " << errors[0] << ", " << errors[1] << ", " << errors[2]
            << ", orders " << std::log2(errors[0] / errors[1]) << ", "
            << std::log2(errors[1] / errors[2]) << '\n';
  CHECK(errors[0] > 1e-10 && errors[1] > 1e-13); // or they say nothing
  CHECK(std::log2(errors[0] / errors[1]) > 4.);
  CHECK(std::log2(errors[1] / errors[2]) > 6.);
  coupled_normal_force();
  start_from_rest();
  return check::report();
}
