// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/event/curved_slip.h"
#include "analysis/event/load_polynomials.h"
#include "base/algebra/dense_algebra.h"

#include <algorithm>

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
 *
 * Slip along a curve is not linear. Its friction is a polynomial in time over the piece, found by
 * collocation (CurvedSlip), and the motion under that friction is summed up like any other.
 * doc/dynamics.md, "From event to event", has the equations.
 */
class TaylorMotion {
public:
  /// @param least time within which a load may do what it likes [s]
  TaylorMotion(const EventModel &model, const double least)
      : loads(model, least), model(model), least(least) {}

  /**
   * Motion from @p unknowns and @p velocity at @p time over at most @p longest [s].
   * @param forces of the contacts, at @p time: where supports share a force that the line does not
   * tell apart, they change by as little as can be
   * @return how far it is valid, the length that x = 1 stands for [s]; 0 if the friction of
   * contacts that slip along curves is not found
   */
  double compute(const LoadCourse &course, const double time, const double longest,
                 const Vector &unknowns, const Vector &velocity,
                 const std::vector<EventState> &states, const std::vector<Eigen::Vector3d> &forces);
  /// Accelerations u_1', u_2' and normal forces N at an instant, of contacts that slip along
  /// curves: without their friction, 3 rows each, and by it, 2 columns each.
  struct Beginning {
    std::vector<unsigned int> contacts;
    Vector free;
    Eigen::MatrixXd by_friction;
  };
  Beginning begin(const LoadCourse &course, const double time, const double longest,
                  const Vector &unknowns, const Vector &velocity,
                  const std::vector<EventState> &states,
                  const std::vector<Eigen::Vector3d> &forces);
  void transfer(Archive &archive) {
    archive(guess);
    archive(curve_guess);
    archive(loads);
    state_changed();
  }
  /// To be called when a contact has changed its state.
  void state_changed() { rows_are_current = false; }

  /// Whether contacts that stick hold the line where others do already.
  bool is_overdetermined() const { return relief.size() > 0; }
  Eigen::MatrixXd q, v;              ///< unknowns, by order
  std::vector<Eigen::MatrixXd> g, r; ///< of each contact, 3 by order
  std::vector<Eigen::MatrixXd> s;    ///< direction of slip, 2 by order; empty if it is straight
  LoadPolynomials loads;             ///< of the same length

  /// A component of a contact's g or r as a polynomial.
  static Polynomial row(const Eigen::MatrixXd &m, const int i) { return m.row(i).transpose(); }
  static Vector at(const Eigen::MatrixXd &m, const double x);

private:
  static constexpr int order = 30;

  struct Row {
    unsigned int contact;
    int component;
  };
  /// Make ready for contacts in these states.
  void take(const std::vector<EventState> &states);
  /// Make ready for a piece no longer than @p longest. @return the length to try first [s]
  double first_length(const std::vector<EventState> &states, const double longest);
  void make_rows(const std::vector<EventState> &states);
  /// G M^-1 H^T of the rows, factored.
  void make_delassus();
  /// Where constraints are dependent, what can be held without friction takes none.
  /// @param W whose kernel says what multipliers may change
  void make_relief(const Eigen::MatrixXd &W);
  /// @param forces of the contacts until then; null: from rest, under the friction of curves alone
  void expand_series(const double length, const std::vector<EventState> &states,
                     const std::vector<Eigen::Vector3d> *const forces);
  /// Coefficient @p k of the multipliers, into r, by G q'' + e'' = 0, and what they do to the
  /// acceleration. @param prescribed e'', by row
  void constrain(const int k, const std::vector<EventState> &states, const Vector &prescribed,
                 Vector &acceleration);
  /// Coefficient @p k of the loads' forces, those of the motions that they impose among them.
  Vector load_forces(const int k, const double length) const;
  /// Coefficient @p k of what of a closed contact's force its displacement says, or its slip by
  /// Coulomb's law. @param constants whether it includes what does not change: gap, platen
  void set_known_force(const unsigned int i, const int k, const EventState &state,
                       const bool constants, Eigen::Vector3d &known) const;
  /// From rest where @p unknowns is null.
  void begin_series(const Vector *const unknowns, const Vector *const velocity);
  /// Find the friction of contacts that slip along curves, for the series without it.
  /// @return for which part of the length, 0 if for none
  double find_friction(const double time, const double length,
                       const std::vector<EventState> &states,
                       const std::vector<Eigen::Vector3d> &forces);
  void make_responses(const double length, const std::vector<EventState> &states);
  bool is_curve(const EventState &state) const {
    return state.status == ContactStatus::slip && state.curved;
  }
  /// Of contacts that slip along curves, 3 rows each, by powers.
  Eigen::MatrixXd rates_and_normal_forces(const double length) const;
  /// How much of the length is valid, 0 to 1.
  double valid_part() const;
  void shorten_all(const double x);

  const EventModel &model;
  const double least;
  double guess = 0., curve_guess = 0.;
  bool rows_are_current = false;
  std::vector<unsigned int> curves;            ///< contacts that slip along curves
  std::vector<Eigen::MatrixXd> curve_friction; ///< of each contact, 2 by order
  CurvedSlip curved_slip;
  CurvedSlip::Responses responses;
  double response_length = 0.;            ///< what x = 1 stands for in them [s]
  std::vector<Row> rows;                  ///< multipliers
  Eigen::MatrixXd columns, accelerations; ///< H^T and M^-1 H^T
  LeastSquares delassus;
  Eigen::MatrixXd relief; ///< of friction where constraints are dependent; empty if none is
};

} // namespace frictionbeam
