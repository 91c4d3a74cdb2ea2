// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/statics/last_motions.h"
#include "analysis/statics/linearized_solver.h"
#include "analysis/statics/statics.h"

namespace frictionbeam {

/**
 * Static increments of any cells: Newton's method on the line, in each of whose iterations the
 * contacts are solved on the linearized line. It has converged when the forces of the line itself
 * balance those of the contacts, which obey their laws at that very pose (doc/theory.md, "Large
 * displacements").
 */
class NonlinearStatics final : public Statics {
public:
  explicit NonlinearStatics(const Model &model);

  EquilibriumResult solve(const LineState &from, const StaticIncrement &increment, LineState &to,
                          ContactResponse &response) override;
  /// Stored energy exactly, work by the forces halfway, so that what is left over measures the
  /// increment.
  EnergyAccount account(const LineState &before, const LineState &after, const LoadCourse &course,
                        const Vector &unbalanced) const override;
  Vector forces_on_contacts(const LineState &state, const LoadCourse &course) const override;
  /// By the signs of the pivots of the tangent stiffness, of which closed contacts are a part.
  bool is_unstable(const LineState &state) const override;
  /// Nothing is proved of large motions.
  std::vector<contact::BeyondUniqueness>
  beyond_uniqueness(const std::vector<ContactStatus> &) const override {
    return {};
  }
  std::optional<Collapse> collapse(const LineState &at, const std::vector<double> &begin,
                                   const std::vector<double> &end) const override;
  bool wants_shorter() const override { return too_long; }
  void transfer(Archive &archive) override;

  /// An increment on its way to its solution.
  struct Approach {
    Pose pose;
    Vector moved; ///< unknowns since the increment began
    double time;  ///< at its end [s]
    std::vector<double> factors;
    PipeSections::Clock clock;
    Pose start;
    double largest_before;       ///< force on the unknowns as the increment begins
    LineCells::Balance &balance; ///< at the pose
    bool is_answered = false;    ///< by the sections, at one pose of the increment
    double largest = 0.;         ///< likewise
    Vector forces;               ///< left at the pose, but for the contacts
    /// Of an increment that is led, by time: factors of the loads, what they impose on all degrees
    /// of freedom, and forces on the unknowns.
    std::vector<double> factor_rates = {};
    Vector imposed_rate = {}, force_rate = {};
    double lead_stiffness = 0.; ///< of the unknown that is led, as if all were elastic
    double goal = 0.;           ///< what it is led by: the unknown's motion, or work on force_rate
  };

private:
  Approach begin(const LineState &from, const StaticIncrement &increment);
  /// What loads do by time to an increment that is led.
  void measure_rates(const LineState &from, const StaticIncrement &increment, Approach &at) const;
  void evaluate(Approach &at, const bool is_trial) const;
  /// Solve the line linearized at the pose. @p more: of the time, what an increment that is led
  /// takes more or less of.
  EquilibriumResult solve_at_pose(const LineState &from, const StaticIncrement &increment,
                                  const std::vector<Contact::Strains> &contact_forces, Approach &at,
                                  Vector &change, ContactResponse &response, double &more);
  /// Change loads, and what they impose, by time.
  void load_further(const double more, Approach &at) const;
  /// Whether the contacts' forces at this pose balance the line's; how well goes into the result.
  bool is_solved(Approach &at, const ContactResponse &response, EquilibriumResult &result) const;
  /// Whether the increment is short enough for creep; if not, the result's remark says so.
  bool follows_creep(const Approach &at, const LineState &from, const ContactResponse &response,
                     EquilibriumResult &result);
  /// Go a part of the change if its whole goes too far (search_slope()).
  /// @param before forces at its start but for the contacts, @param of_contacts those of the
  /// linearized line
  /// @return whether by all of it
  bool search(const Pose &from, const Vector &moved, const Vector &change, const Vector &before,
              const Vector &of_contacts, Approach &at) const;
  /// Go on by the change of the unknowns, or by a part of it if vertices would turn too far.
  /// @return whether by all of it
  bool move(const Vector &change, Approach &at) const;

  const Model &model;
  LinearizedSolver linearized;
  LineCells::Balance balance_at_hand; ///< kept for its memory, which is large
  /// Keep what an increment that fails has come to, for collapse().
  void remember_failure(const Approach &at, const LineState &from,
                        const StaticIncrement &increment);

  LastMotions motions;
  bool too_long = false; ///< the last increment, for creep
};

} // namespace frictionbeam
