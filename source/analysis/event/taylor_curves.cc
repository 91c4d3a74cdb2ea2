// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/taylor_motion.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {
/// Pieces of curves, of the time within which loads may do what they like.
constexpr double shortest_curve = 100.;
} // namespace

void TaylorMotion::make_responses(const double length, const std::vector<EventState> &states) {
  responses.clear();
  response_length = std::exp2(std::floor(std::log2(length))); // the same bits in any run
  for (const unsigned int l : curves)
    for (int d = 0; d < 2; ++d) {
      for (const unsigned int i : curves)
        curve_friction[i].setZero(2, 1);
      curve_friction[l](d, 0) = 1.;
      begin_series(nullptr, nullptr);
      expand_series(response_length, states, nullptr);
      responses.push_back(rates_and_normal_forces(response_length));
    }
}

Eigen::MatrixXd TaylorMotion::rates_and_normal_forces(const double length) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * curves.size(), order + 1);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (int k = 0; k < order; ++k)
      result.block<2, 1>(3 * c, k) = (k + 1.) / length * g[curves[c]].col(k + 1).tail<2>();
    result.row(3 * c + 2) = -r[curves[c]].row(0);
  }
  return result;
}

double TaylorMotion::find_friction(const double time, const double length,
                                   const std::vector<EventState> &states,
                                   const std::vector<Eigen::Vector3d> &forces) {
  Eigen::MatrixXd free = rates_and_normal_forces(length);
  bool begins = false;
  for (std::size_t c = 0; c < curves.size(); ++c)
    if (states[curves[c]].began == time) {
      begins = true;
      free.block<2, 1>(3 * c, 0).setZero(); // at rest: not the rounding that is left of it
    }
  if (responses.empty())
    make_responses(length, states);
  std::vector<CurvedSlip::Contact> contacts;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const EventContact &contact = model.contacts[curves[c]];
    const Eigen::Vector3d &r = forces[curves[c]];
    // What pieces before have missed its limit by would turn it at once, the faster the shorter the
    // piece.
    const Eigen::Vector2d tau =
        r.tail<2>().normalized() * contact.law.dynamic_friction * std::abs(r[0]);
    contacts.push_back({contact.law.dynamic_friction,
                        contact.rigid_shear ? 0. : 1. / contact.shear_stiffness,
                        states[curves[c]].direction, tau, free.middleRows<3>(3 * c)});
  }
  // From rest the direction of slip is as smooth as the forces, but rounding while it is slow.
  const double longest = curve_guess > 0. && !begins ? std::min(1., curve_guess / length) : 1.,
               part = curved_slip.solve(contacts, responses, length, response_length, longest,
                                        shortest_curve * least / length);
  if (part == 0.)
    return 0.;
  curve_guess = part < 1. ? 1.5 * part * length : std::max(curve_guess, 2. * length);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    curve_friction[curves[c]] = curved_slip.friction[c];
    s[curves[c]] = curved_slip.direction[c];
  }
  return part;
}

TaylorMotion::Beginning TaylorMotion::begin(const LoadCourse &course, const double time,
                                            const double longest, const Vector &unknowns,
                                            const Vector &velocity,
                                            const std::vector<EventState> &states,
                                            const std::vector<Eigen::Vector3d> &forces) {
  const double length = loads.expand(course, time, first_length(states, longest), longest);
  for (const unsigned int i : curves)
    curve_friction[i].setZero(2, 0);
  begin_series(&unknowns, &velocity);
  expand_series(length, states, &forces);
  Beginning result;
  result.contacts = curves;
  const auto at_once = [&](const Eigen::MatrixXd &powers, const double of_length) {
    Vector column = powers.col(0);
    for (std::size_t c = 0; c < curves.size(); ++c)
      column.segment<2>(3 * c) = powers.block<2, 1>(3 * c, 1) / of_length;
    return column;
  };
  result.free = at_once(rates_and_normal_forces(length), length);
  make_responses(length, states);
  result.by_friction.resize(3 * curves.size(), responses.size());
  for (std::size_t l = 0; l < responses.size(); ++l)
    result.by_friction.col(l) = at_once(responses[l], response_length);
  return result;
}

} // namespace frictionbeam
