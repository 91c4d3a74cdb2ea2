// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/contact/exact_solver.h>

#include "active_set.h"
#include "condensed_attempts.h"
#include "pass.h"
#include "rigid_stops.h"
#include "uniqueness.h"

#include <algorithm>
#include <optional>

namespace frictionbeam::contact {

namespace {

constexpr unsigned int most_refinements = 5, most_releases = 5;
constexpr double nothing_left = 1e-4; // part of the tolerance at which nothing is left to correct

std::unique_ptr<const Condensation> with_places(std::unique_ptr<Condensation> system,
                                                const SiteList &sites) {
  std::vector<std::vector<int>> blocks;
  for (unsigned int i = 0; i < sites.size(); ++i)
    blocks.push_back(sites[i].unknowns);
  system->add_places(blocks);
  return system;
}

double largest_of(const Vector &values) {
  return values.size() > 0 ? values.lpNorm<Eigen::Infinity>() : 0.;
}

} // namespace

class ExactSolver::Implementation {
public:
  Implementation(Settings of_solver, SiteList list, std::unique_ptr<Condensation> condensation,
                 const Vector &of_matrix)
      : settings(std::move(of_solver)), sites(std::move(list)),
        system(with_places(std::move(condensation), sites)), proximal(sites, of_matrix),
        equations(settings, sites, *system, proximal), newton(equations),
        attempts(equations, newton), diagonal(of_matrix), stops(sites) {
    if (!equations.is_of_body())
      active_set.emplace(equations, newton);
  }

  Result solve(const Problem &problem, const ImposedMotion &imposed, const State &committed,
               Vector &unknowns, Response &response);

private:
  /// The equations at the present motion of the body, and its forces.
  void begin_pass(const Pass &now);
  /// From where the increment began.
  void start_again(Pass &now);
  /// Whether nothing holds the loads of an increment that a large motion's rounding has ended.
  bool nothing_holds(Pass &now);
  /// Of all sites at the present motion of the body.
  std::vector<Strains> strains_at(const Pass &now) const;
  /// The contacts, at loads that are given.
  Outcome solve_pass(Pass &now, const bool is_first, Vector &x);
  /// Solve the contacts at the present motion of the body, and move it by what that gives.
  /// @return whether they are solved
  bool move(Pass &now);
  /// Whether the forces on all unknowns count as balanced.
  bool is_balanced(Pass &now) const;
  /// Whether a body in balance is to be solved once more: slip is let go, pairs of stops are
  /// released, rounding is corrected.
  bool goes_on(Pass &now);
  /// What goes_on() has not brought about from where halves of stops press on each other: solve the
  /// increment from its beginning without the half of each pair that presses less, or without the
  /// other one. @return whether the contact laws hold of all
  bool solve_one_sided(Pass &now);
  /// Say why there is no solution.
  void explain(const Outcome outcome, Pass &now) const;
  /// @return whether the contact laws hold; the result says so.
  bool judge(Pass &now);
  /// Whether contact forces are made by the loads, and not by each other: the certificate measures
  /// each on its own scale, beside which loads and gaps may be nothing.
  bool is_made_by_loads(const Pass &now) const;

public:
  const Settings settings;
  const SiteList sites;
  const std::unique_ptr<const Condensation> system;
  ProximalSites proximal;
  IncrementEquations equations;
  Newton newton;
  std::optional<ActiveSet> active_set; ///< of a line
  CondensedAttempts attempts;

private:
  const Vector diagonal;
  const RigidStops stops;
};

void ExactSolver::Implementation::start_again(Pass &now) {
  proximal.centre = now.centre_before;
  now.unknowns = now.unknowns_before;
  now.low.setZero();
  now.forces = unbalanced_forces(now.problem, now.unknowns, now.low);
  begin_pass(now);
}

bool ExactSolver::Implementation::nothing_holds(Pass &now) {
  start_again(now);
  Vector x;
  return attempts.solve_with_drag(x, now.response, now.result) == Outcome::slides_away;
}

bool ExactSolver::Implementation::solve_one_sided(Pass &now) {
  const Pass::Accepted pressing = *now.accepted;
  for (const bool stronger : {false, true}) {
    now.accepted.reset();
    now.is_corrected = false;
    proximal.take_all();
    stops.leave_out(pressing.response, stronger, proximal);
    start_again(now);
    for (unsigned int pass = 0; pass <= most_refinements && move(now); ++pass)
      if (is_balanced(now) && !proximal.let_slipping_go(now.response)) {
        if (judge(now) && !stops.press(now.response))
          return true;
        break;
      }
  }
  proximal.take_all();
  now.accepted = pressing;
  return false;
}

void ExactSolver::Implementation::explain(const Outcome outcome, Pass &now) const {
  Result &result = now.result;
  if (outcome == Outcome::slides_away) {
    // A later pass may have rounding of a large motion for its forces.
    const Vector motion = system->expand(newton.free_motion(), Vector::Zero(system->n_unknowns()));
    result.no_equilibrium =
        unbalanced_forces(now.problem, now.unknowns_before, Vector::Zero(motion.size()))
            .dot(motion) > 0.;
    if (result.no_equilibrium)
      result.free_motion = motion;
  }
  if (result.no_equilibrium)
    result.remark = std::string("there is no equilibrium: the loads ") +
                    (proximal.is_slide(result.free_motion)
                         ? "exceed what friction can hold, and something slides away"
                         : "move what no contact resists, which lifts off or which none touches");
  else if (const auto pair = stops.overlapping(proximal, now.imposed))
    result.remark = "contacts " + std::to_string((*pair)[0]) + " and " +
                    std::to_string((*pair)[1]) +
                    " (counted from 0) are rigid, face each other and overlap";
  else if (newton.rounding_bars()) {
    result.rounding_bars = true;
    result.remark = newton.rounding_remark();
  }
}

std::vector<Strains> ExactSolver::Implementation::strains_at(const Pass &now) const {
  std::vector<Strains> strain = now.imposed.strain;
  strain.resize(sites.size(), Strains::Zero());
  for (unsigned int i = 0; i < sites.size(); ++i)
    strain[i] += sites[i].strain_by_unknowns(now.unknowns);
  return strain;
}

Outcome ExactSolver::Implementation::solve_pass(Pass &now, const bool is_first, Vector &x) {
  const auto is_known = [&](const Outcome outcome) {
    return outcome != Outcome::stalled && !(outcome == Outcome::slides_away && newton.is_guess());
  };
  if (active_set && active_set->wants_correction()) {
    const Outcome outcome = active_set->correct(x, now.response, now.result);
    now.is_corrected = outcome == Outcome::solved;
    if (is_known(outcome))
      return outcome;
    start_again(now);
    x.setZero();
    return attempts.solve(now.is_static(), x, now.response, now.result);
  }
  if (now.accepted) {
    Outcome outcome = Outcome::stalled;
    if (active_set && now.is_corrected)
      outcome = active_set->correct(x, now.response, now.result);
    if (outcome == Outcome::stalled)
      outcome = newton.solve_together(attempts.limits.most_to_finish, x, now.response, now.result);
    return outcome;
  }
  // Where several solutions are nearly as good, whole steps lead to any of them.
  const bool is_any = now.problem.forces_before == nullptr;
  if (active_set && is_any) {
    const Outcome outcome =
        active_set->solve(is_first, attempts.best_factor(), x, now.response, now.result);
    if (is_known(outcome))
      return outcome;
    if (outcome == Outcome::slides_away) {
      start_again(now);
      x.setZero();
    }
  }
  return attempts.solve(now.is_static(), x, now.response, now.result);
}

void ExactSolver::Implementation::begin_pass(const Pass &now) {
  const Problem &problem = now.problem;
  newton.begin();
  equations.begin(
      now.forces,
      std::max(problem.largest_force, problem.right_hand_side.lpNorm<Eigen::Infinity>()),
      problem.force_so_far, strains_at(now), largest_of(now.unknowns) + now.imposed.displacement,
      now.committed, problem.increment);
}

bool ExactSolver::Implementation::move(Pass &now) {
  now.result.rounding_bars = false;
  const bool is_first = now.forces.size() == 0;
  if (is_first)
    now.forces = unbalanced_forces(now.problem, now.unknowns, now.low);
  begin_pass(now);
  Vector x = Vector::Zero(system->n_kept());
  const Outcome outcome = solve_pass(now, is_first, x);
  if (outcome != Outcome::solved) {
    if (!now.accepted)
      explain(outcome, now);
    return false;
  }
  if (active_set)
    active_set->remember(now.response.status, is_first ? x : Vector());
  const Vector change = system->expand(x, now.forces);
  now.result.back_substitutions += 2; // one to condense the loads, one to expand
  for (int i = 0; i < change.size(); ++i) {
    const double before = now.unknowns[i], added = now.low[i] + change[i];
    now.unknowns[i] += added;
    now.low[i] = added - (now.unknowns[i] - before);
  }
  return true;
}

bool ExactSolver::Implementation::is_balanced(Pass &now) const {
  const Balance balance(now.problem, sites);
  now.forces = unbalanced_forces(now.problem, now.unknowns, now.low);
  Vector left = -now.forces;
  sites.add_forces(now.response, left);
  now.size = left.lpNorm<Eigen::Infinity>();
  now.largest = balance.largest_force(now.response);
  now.result.residual = now.largest > 0. ? now.size / now.largest : now.size;
  if (now.size > balance.tolerance(settings.tolerance, diagonal, now.unknowns, now.response))
    return false;
  // What rounding of larger forces before excuses, may not be the loads at hand.
  constexpr double most_of_loads = 1e-2, least_loads = 1e-9;
  const double loads = largest_of(now.problem.right_hand_side);
  return !(loads >= least_loads * now.problem.force_so_far) || now.size <= most_of_loads * loads ||
         now.size <= settings.tolerance * now.largest;
}

bool ExactSolver::Implementation::goes_on(Pass &now) {
  if (proximal.let_slipping_go(now.response)) {
    now.accepted.reset();
    proximal.take_all();
    return true;
  }
  if (now.n_releases < most_releases && stops.press(now.response)) {
    ++now.n_releases;
    now.accept(proximal.centre);
    stops.release(now.response, proximal);
    return true;
  }
  // One more correction costs no more than a back substitution where the contacts' states stay,
  // and takes what rounding of a soft line's stiffness has left.
  if (!now.is_corrected && now.is_static() &&
      now.size > nothing_left * settings.tolerance * now.largest) {
    now.is_corrected = true;
    now.accept(proximal.centre);
    return true;
  }
  return false;
}

Result ExactSolver::Implementation::solve(const Problem &problem, const ImposedMotion &imposed,
                                          const State &committed, Vector &unknowns,
                                          Response &response) {
  proximal.begin(committed, problem.overrides);
  newton.most_iterations = problem.most_iterations;
  if (active_set)
    active_set->begin();
  for (unsigned int i = 0; i < sites.size() && problem.forces_before != nullptr; ++i)
    if (proximal.is_exact(i))
      proximal.centre[i] = (*problem.forces_before)[i];
  Pass now{problem, imposed, committed, unknowns, response, proximal.centre};
  Result &result = now.result;
  for (unsigned int pass = 0; pass <= most_refinements + now.n_releases && move(now); ++pass) {
    if (active_set && active_set->wants_correction()) {
      now.forces = unbalanced_forces(problem, unknowns, now.low);
      continue;
    }
    if (!is_balanced(now)) {
      result.rounding_bars = true;
      result.remark = too_much_rounding(now.size, now.largest);
      continue;
    }
    if (goes_on(now))
      continue;
    if (judge(now))
      return result;
    break;
  }
  if (now.accepted && stops.press(now.accepted->response) && solve_one_sided(now))
    return result;
  if (now.accepted) { // the correction has not helped
    result.rounding_bars = false;
    unknowns = now.accepted->unknowns;
    response = now.accepted->response;
    proximal.centre = now.accepted->centre;
    result.residual = now.accepted->residual;
    equations.forget_check();
    if (judge(now))
      return result;
  }
  if (result.rounding_bars && now.is_static() && nothing_holds(now))
    explain(Outcome::slides_away, now);
  if (result.iterations >= problem.most_iterations && !result.no_equilibrium)
    result.remark = "no convergence in " + std::to_string(result.iterations) + " iterations";
  proximal.centre = now.centre_before;
  unknowns = now.unknowns_before;
  return result;
}

bool ExactSolver::Implementation::judge(Pass &now) {
  Result &result = now.result;
  result.check = equations.check(now.response);
  const bool holds = result.check->holds(settings.contact_tolerance);
  result.converged = holds && is_made_by_loads(now);
  result.remark = result.converged ? ""
                  : holds ? "contacts press on each other with forces that the loads do not make"
                          : "the contact laws fail their check";
  return result.converged;
}

bool ExactSolver::Implementation::is_made_by_loads(const Pass &now) const {
  constexpr double most_amplified = 1e6; // by a wedge, say
  const Problem &problem = now.problem;
  if (problem.matrix.rows() != now.unknowns.size())
    return true; // a host's own, whose elastic forces are not known
  double of_contacts = 0.;
  for (unsigned int i = 0; i < sites.size(); ++i)
    if (proximal.is_exact(i))
      of_contacts = std::max(of_contacts, sites[i].largest_force(now.response.stress[i]));
  const double of_loads =
      std::max({largest_of(problem.right_hand_side), problem.largest_force, problem.force_so_far});
  return of_contacts <= most_amplified * of_loads ||
         of_contacts <= most_amplified * largest_of(problem.matrix * now.unknowns);
}

ExactSolver::ExactSolver(Settings settings, SiteList sites,
                         std::unique_ptr<Condensation> condensation, const Vector &diagonal)
    : implementation(std::make_unique<Implementation>(std::move(settings), std::move(sites),
                                                      std::move(condensation), diagonal)) {}

ExactSolver::~ExactSolver() = default;

Result ExactSolver::solve(const Problem &problem, const ImposedMotion &imposed,
                          const State &committed, Vector &unknowns, Response &response) {
  return implementation->solve(problem, imposed, committed, unknowns, response);
}

void ExactSolver::guess(const std::vector<Strains> &stress) {
  implementation->proximal.centre = stress;
  if (implementation->active_set)
    implementation->active_set->forget_status();
}

bool ExactSolver::may_jam() const {
  return implementation->active_set && implementation->active_set->may_ever_jam();
}

WarmStart ExactSolver::warm_start() const {
  WarmStart memory;
  memory.first_factor = implementation->attempts.first_factor();
  implementation->proximal.save(memory);
  implementation->equations.save(memory);
  if (implementation->active_set)
    implementation->active_set->save(memory);
  return memory;
}

void ExactSolver::restore(const WarmStart &memory) {
  implementation->attempts.first_factor() = memory.first_factor;
  implementation->proximal.restore(memory);
  implementation->equations.restore(memory);
  if (implementation->active_set)
    implementation->active_set->restore(memory);
}

std::vector<BeyondUniqueness>
ExactSolver::beyond_uniqueness(const std::vector<ContactStatus> &status) const {
  return contacts_beyond_uniqueness(implementation->sites, *implementation->system,
                                    implementation->proximal, status);
}

} // namespace frictionbeam::contact
