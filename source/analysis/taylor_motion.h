// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "event_model.h"
#include "event_polynomial.h"

#include <Eigen/QR>

#include <algorithm>

namespace frictionbeam {

/// Instants this close are one [s]: a corner of a table that an instant of output misses by
/// rounding.
double same_instant(const double time);

/**
 * The motion of the line while no contact changes its state: linear, and summed up as a power
 * series in time to rounding. With M q'' = f(t) - C q' - K q - G^T r, the coefficients follow one
 * another, q_{k+1} = v_k/(k+1),   v_{k+1} = M^-1 (f - C v - K q - G^T r)_k/(k+1), for any damping,
 * unsymmetric friction (r_T = f |r_N| s while it slips) and constraints (rigid contacts: G q'' +
 * e'' = 0 gives r by (G M^-1 H^T)^-1 in each order) alike, where modal coordinates would need a new
 * complex eigenproblem in each state. A step is as long as terms of order 30 are below rounding:
 * half a period of the fastest motion. Everything that decides about contacts is then a polynomial
 * as well.
 *
 * Slip along a curve is not linear, but analytic while it lasts: the direction s of slip has a
 * power series too, on rigid surfaces from u = |u| s, on elastic ones from s' = k (u - (u.s) s)/(f
 * N), with u the velocity relative to the ground; terms of order k need those of u, N, s up to k
 * only. Steps get short where |u| is small.
 */
class TaylorMotion {
public:
  /// @param least time within which a load may do what it likes [s]
  TaylorMotion(const EventModel &model, const double least) : model(model), least(least) {}

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

  /// The instant as loads are to be asked for there: on this side of what jumps at an end.
  double within(const double time) const { return std::clamp(time, first_instant, last_instant); }

  Eigen::MatrixXd q, v;              ///< unknowns, by order
  std::vector<Eigen::MatrixXd> g, r; ///< of each contact, 3 by order
  std::vector<Eigen::MatrixXd> s;    ///< direction of slip, 2 by order; empty if it is straight
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
  bool interpolate_between(const LoadCourse &loads, const double time, const double length);
  /// Of a contact that slips along a curve, by order: velocity u in the sliding plane, |u|; on an
  /// elastic surface u.s and (u - (u.s) s)/N.
  struct Curve {
    Eigen::MatrixXd rate, turn;
    Vector speed, along;
  };
  void expand_series(const double length, const std::vector<EventState> &states);
  /// The term of order @p k of the velocity, and of the direction on a rigid surface.
  void expand_direction(const unsigned int i, const int k, const double length);
  /// The next term of the direction on an elastic surface.
  void expand_turn(const unsigned int i, const int k, const double length);
  /// Friction of order k for the normal force so far.
  Eigen::Vector2d friction(const unsigned int i, const int k, const EventState &state) const;
  /// How much of the length is valid, 0 to 1.
  double valid_part() const;
  void shorten_all(const double x);

  const EventModel &model;
  const double least;
  double guess = 0.;
  double first_instant = 0., last_instant = 0.; ///< of the loads' piece [s]
  Noise factor_noise, ground_noise;
  bool rows_are_current = false;
  std::vector<Curve> curves;
  std::vector<Row> rows;                  ///< multipliers
  Eigen::MatrixXd columns, accelerations; ///< H^T and M^-1 H^T
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> delassus;
};

} // namespace frictionbeam
