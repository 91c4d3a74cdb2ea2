// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/contact/equilibrium.h"
#include "analysis/increment/energy_account.h"
#include "analysis/increment/load_course.h"
#include "analysis/statics/collapse.h"
#include <frictionbeam/contact/exact_solver.h>

#include <memory>
#include <optional>

namespace frictionbeam {

/// How the end of an increment is told where not the loads, but the motion is given.
struct PathLead {
  unsigned int unknown;               ///< that is led
  double motion;                      ///< by so much
  double end;                         ///< of the step [s], to which the loads' factors go evenly
  const std::vector<double> &factors; ///< then
  /// If given, the work of the loads is led, to `motion` times what they do on these motions of the
  /// unknowns, and the unknown only holds the line on the way.
  const Vector *before = nullptr;
};

/// A static increment, as it begins.
struct StaticIncrement {
  const LoadCourse &course;
  double time = 0.;                   ///< at its end [s]
  const std::vector<double> &factors; ///< of the loads at its end, with their histories
  double least_force = 0.;            ///< that residuals are measured by, whatever the loads [N]
  double force_so_far = 0.;           ///< largest of the sequence [N]
  unsigned int most_iterations = 0;
  bool finds_limit = false; ///< of the poses near by, where others far away would carry more
  /// If given, time and factors are a guess only, and the state's time is part of the solution.
  std::optional<PathLead> lead = {};

  /// What a problem of contacts knows of it besides forces and motions.
  void describe(const Model &model, contact::Problem &problem) const {
    problem.increment = {course.time_of_laws(time), 0., model.contacts.temperatures(factors)};
    problem.largest_force = least_force;
    problem.force_so_far = force_so_far;
    problem.most_iterations = most_iterations;
  }
};

/// Solves static increments of a line with its contacts.
class Statics {
public:
  virtual ~Statics() = default;

  /// @param to in: the state before; out: the solution, but for its contacts
  virtual EquilibriumResult solve(const LineState &from, const StaticIncrement &increment,
                                  LineState &to, ContactResponse &response) = 0;
  /// Account of an increment.
  /// @param unbalanced forces on the unknowns that the state before left so, which are put on as
  /// evenly as the loads
  virtual EnergyAccount account(const LineState &before, const LineState &after,
                                const LoadCourse &course, const Vector &unbalanced) const = 0;
  /// What loads and line put on the contacts at a state: zero without contacts, in equilibrium.
  virtual Vector forces_on_contacts(const LineState &state, const LoadCourse &course) const = 0;
  /// Where contacts in these states may have other equilibria.
  virtual std::vector<contact::BeyondUniqueness>
  beyond_uniqueness(const std::vector<ContactStatus> &status) const = 0;
  /// Whether the line would leave a state by itself, at the least push, even if every contact that
  /// is closed held it: without friction along its normal only.
  virtual bool is_unstable(const LineState &) const { return false; }
  /// Whether the last increment had a solution, and was only too long for what creeps.
  virtual bool wants_shorter() const { return false; }
  /// Of a line that has found no equilibrium any more on the way between two load cases: whether
  /// its last motion is that of a mechanism.
  virtual std::optional<Collapse> collapse(const LineState &, const std::vector<double> &,
                                           const std::vector<double> &) const {
    return {};
  }
  /// Hold less memory until it is asked for more, if it is: what has been put away is made again
  /// then. No number depends on it.
  virtual void hold_less() {}
  /// What the increments to come depend on, besides the line's state.
  virtual void transfer(Archive &archive) = 0;
};

/// The one that the line's cells need.
std::unique_ptr<Statics> make_statics(const Model &model);

} // namespace frictionbeam
