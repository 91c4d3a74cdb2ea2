// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "front_prediction.h"
#include "newton.h"

namespace frictionbeam::contact {

/**
 * Newton's method on chosen branches of the contact laws, in whole steps, each on the branches that
 * FrontPrediction makes of the last one: it comes near a solution of an increment in a few steps,
 * or gives up. From there Newton::solve_together() goes on, which judges.
 *
 * A step is one of the proximal law around the present forces, with a stiffness so large that it
 * holds what a branch holds (doc/theory.md, "Exact contact", the travelling front).
 */
class ActiveSet {
public:
  ActiveSet(IncrementEquations &equations, Newton &newton);

  /// An increment, or its contacts once more.
  void begin() {
    has_solved = is_sketched = false;
    settled.clear();
  }

  /**
   * From the centre and no motion, unless a contact may jam or failures in a row have made a pause;
   * x and the centre are as they were if it stalls.
   * @param is_first whether an increment begins, and not a correction of it
   * @param factor c of solve_together()
   */
  Outcome solve(const bool is_first, const double factor, Vector &x, Response &response,
                Result &result);

  /// Whether what solve() has found is in equilibrium on branches that stay, each of which has
  /// yielded a little: correct() solves it, or does not.
  bool wants_correction() const { return is_sketched; }

  /**
   * The same for a solution that solve() has found, where little has been left for x to correct:
   * on its branches, whose factors are there.
   */
  Outcome correct(Vector &x, Response &response, Result &result);

  /// A solution: where to begin the next time. @p motion without entries: as before.
  void remember(const std::vector<ContactStatus> &status, const Vector &motion);

  /// Whether a contact has several states by itself with its static friction.
  bool may_ever_jam() const;

  /// Other forces than those of the last solution are the centre.
  void forget_status() { kept.status.clear(); }

  void save(WarmStart &memory) const { memory.prediction = kept; }
  void restore(const WarmStart &memory) { kept = memory.prediction; }

private:
  /**
   * Without a front, from a motion like_before() and around the forces of the increment before: one
   * step on soft proximal contacts, most of which keep their states, from where solve_together()
   * goes on.
   */
  Outcome solve_few(const bool is_first, const double factor, Vector &x, Response &response,
                    Result &result);
  /**
   * The motion m of the increment before, as it was, turned about, or none, whichever is nearest to
   * what the change f of the loads would make of it without contacts: f.m / m.Sm times m.
   */
  Vector like_before(Response &response);
  /// To forces and x at which the branches stay as they are. @return whether they do
  bool predict(const bool is_first, Vector &x, Response &response, Result &result);
  std::vector<ContactStatus> first_branches(const Response &response) const;
  /// One step to x and forces in equilibrium on the branches. @return false if there is none
  bool step(Vector &x, Response &response, Result &result);
  void look_at_points(const double rounding, const Response &response);
  /// Of friction beyond the limit of a contact that sticks: after steps that settle, rounding [N].
  double excess() const;
  /// Whether x and the present centre are nearer to a solution than no motion and @p centre.
  bool is_nearer(const Vector &x, const std::vector<Strains> &centre, Response &response);
  /// Whether a contact has several states by itself. Whole steps lead to any of them, and from the
  /// wrong one on each increment is harder than on the path of the loads.
  bool may_jam() const;
  /// The same with friction coefficients by contact.
  template <typename Friction>
  bool is_beyond_uniqueness(const Friction &friction) const;
  /// How many contacts of each front the first prediction of an increment, @p sketch, has missed:
  /// in the next one its fronts are moved on by as many.
  void learn_how_far(const std::vector<ContactStatus> &sketch, const unsigned int n_fronts);
  /// The more failures in a row, the longer the pause.
  void learn(const bool has_led_to_solution);

  IncrementEquations &equations;
  Newton &newton;
  ProximalSites &proximal;
  FrontPrediction front;
  std::vector<Check::Point> points;   ///< of contacts after a step
  std::vector<ContactStatus> settled; ///< branches that have led to the present solution, if any
  double yielded = 0.;                ///< largest force that a branch did not hold in that step [N]
  PredictionMemory kept;
  bool has_solved = false;  ///< the present increment, which is not corrected yet
  bool is_sketched = false; ///< and has not been judged either
};

} // namespace frictionbeam::contact
