// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "event_model.h"
#include "event_polynomial.h"

#include <Eigen/QR>

namespace frictionbeam {

/**
 * The motion of the line while no contact changes its state: linear, and summed up as a power
 * series in time to rounding. With M q'' = f(t) - C q' - K q - G^T r, the coefficients follow one
 * another, q_{k+1} = v_k/(k+1),   v_{k+1} = M^-1 (f - C v - K q - G^T r)_k/(k+1), for any damping,
 * unsymmetric friction (r_T = f |r_N| s while it slips) and constraints (rigid contacts: G q'' +
 * e'' = 0 gives r by (G M^-1 H^T)^-1 in each order) alike, where modal coordinates would need a new
 * complex eigenproblem in each state. A step is as long as terms of order 30 are below rounding:
 * half a period of the fastest motion. Everything that decides about contacts is then a polynomial
 * as well.
 */
class TaylorMotion {
public:
  explicit TaylorMotion(const EventModel &model) : model(model) {}

  /**
   * Motion from @p unknowns and @p velocity at @p time over at most @p longest [s].
   * @return how far it is valid, the length that x = 1 stands for [s]
   */
  double compute(const LoadCourse &loads, const double time, const double longest,
                 const Vector &unknowns, const Vector &velocity,
                 const std::vector<EventState> &states);
  void transfer(Archive &archive) {
    archive(guess);
    archive(factor_noise.level);
    archive(ground_noise.level);
    state_changed();
  }
  /// To be called when a contact has changed its state.
  void state_changed() { rows_are_current = false; }

  Eigen::MatrixXd q, v;              ///< unknowns, by order
  std::vector<Eigen::MatrixXd> g, r; ///< of each contact, 3 by order
  Eigen::MatrixXd factors, ground;   ///< orders by load; orders by 3 contacts

  /// A component of a contact's g or r as a polynomial.
  static Polynomial row(const Eigen::MatrixXd &m, const int i) { return m.row(i).transpose(); }
  static Vector at(const Eigen::MatrixXd &m, const double x);

private:
  struct Row {
    unsigned int contact;
    int component;
  };
  /// Of the loads' factors or the ground's motion, see interpolate().
  struct Noise {
    Vector level, before;
  };
  void make_rows(const std::vector<EventState> &states);
  bool interpolate_loads(const LoadCourse &loads, const double time, const double length);
  void expand_series(const double length, const std::vector<EventState> &states);
  /// How much of the length is valid, 0 to 1.
  double valid_part() const;
  void shorten_all(const double x);

  const EventModel &model;
  double guess = 0.;
  Noise factor_noise, ground_noise;
  bool rows_are_current = false;
  std::vector<Row> rows;                  ///< multipliers
  Eigen::MatrixXd columns, accelerations; ///< H^T and M^-1 H^T
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> delassus;
};

} // namespace frictionbeam
