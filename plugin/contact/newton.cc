// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton.h"
#include "free_motion.h"
#include <frictionbeam/contact/halving_search.h>
#include <frictionbeam/contact/tolerances.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam::contact {

namespace {

constexpr unsigned int most_proximal = 15, most_stalls = 4;
constexpr double stiffness_of_direction = 1e6;
/// Part of the largest force up to which rounding may be left to the refinement on the whole line.
constexpr double most_rounding = 1e-2;
/// Parts of the tolerances at which nothing is left to gain, and of the merit that a step must
/// leave for another one to be worth it.
constexpr double sharp = 1e-4, least_gain = 0.25;
constexpr double not_looked_at = std::numeric_limits<double>::max();

/// (I - D diag(by centre))^-1, of the tangent D of an exact contact: its normal force depends on
/// nothing else, its friction and its torsion on this and on themselves, and the centre has no
/// torsion.
class LawWithoutCentre {
public:
  LawWithoutCentre(const Block &D, const Strains &by_centre)
      : normal(1. - D(0, 0) * by_centre[0]), by_normal(D.col(0) * by_centre[0]),
        across(Eigen::Matrix2d::Identity() -
               D.block<2, 2>(1, 1) * by_centre.segment<2>(1).asDiagonal()) {
    swaps = std::abs(across(1, 0)) > std::abs(across(0, 0));
    if (swaps)
      across.row(0).swap(across.row(1));
    factor = across(1, 0) / across(0, 0);
    last = across(1, 1) - factor * across(0, 1);
  }

  template <int n_columns, int order>
  Eigen::Matrix<double, n_strains, n_columns, order>
  times(const Eigen::Matrix<double, n_strains, n_columns, order> &right) const {
    auto x = right;
    x.row(0) /= normal;
    for (int row = 1; row < n_strains; ++row)
      x.row(row) += by_normal[row] * x.row(0);
    if (swaps)
      x.row(1).swap(x.row(2));
    x.row(2) = (x.row(2) - factor * x.row(1)) / last;
    x.row(1) = (x.row(1) - across(0, 1) * x.row(2)) / across(0, 0);
    return x;
  }

private:
  double normal, factor, last;
  Strains by_normal;
  Eigen::Matrix2d across; ///< its larger row first
  bool swaps;
};

} // namespace

void Newton::begin() {
  is_barred = guesses = false;
  may_guess = true;
  proof.reset();
}

void Newton::set_drag(const double factor) {
  is_barred = false;
  equations.set_drag(factor);
}

std::string Newton::rounding_remark() const {
  return too_much_rounding(equations.force_left, equations.largest_force) +
         ": what carries the loads is too stiff for them, or something moves freely before a "
         "contact closes";
}

bool Newton::slides_away(const Vector &x, Response &response) {
  constexpr double shift = 1e-9;
  equations.evaluate(x, response);
  Vector forces = equations.forces_left(response);
  const double drag = equations.drag_factor();
  if (drag > 0.) // the loads' own
    forces += drag * diagonal.cwiseProduct(x);
  equations.begin_tangent(shift);
  const double stiff = diagonal.size() > 0 ? diagonal.maxCoeff() : 1.;
  for (unsigned int i = 0; i < contacts.size(); ++i) // what is closed holds along its normal
    if (response.status[i] != ContactStatus::open)
      equations.add_block(i, stiff * contacts[i].length * contacts[i].length / contacts[i].weight *
                                 Strains::UnitX().asDiagonal());
  if (!equations.factor_tangent())
    return false;
  const Vector motion = equations.solve_tangent(forces);
  const double work = forces.dot(motion);
  return work > 0. && motion.dot(S * motion) <= 1e-3 * work && loads_do(work, motion) &&
         is_resisted_in_vain(motion, response, false);
}

bool Newton::is_resisted_in_vain(const Vector &motion, const Response &response,
                                 const bool is_solution) {
  constexpr double nothing = 1e-12; // of the motion: a contact that it leaves where it is
  const double size = motion.lpNorm<Eigen::Infinity>();
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Strains rate = equations.strain_of(i, motion);
    if (contacts[i].length * rate.lpNorm<Eigen::Infinity>() > nothing * size &&
        !proximal.gives_utmost(i, response, rate))
      return false;
  }
  if (!proof) // once for these loads
    proof =
        find_free_motion(contacts, equations.unknowns_of_contacts(), S, diagonal, equations.loads);
  guesses = !proof->is_any_force && !is_solution;
  if (proof->is_any_force)
    return proof->motion.size() > 0;
  proof->motion = motion;
  return is_solution || (may_guess && !(equations.drag_factor() > 0.));
}

std::optional<std::vector<Strains>> Newton::balanced_forces() const {
  return find_balanced_forces(contacts, equations.unknowns_of_contacts(), S, diagonal,
                              equations.loads);
}

bool Newton::strains_nothing(const Vector &x) {
  constexpr double shift = 1e-12, soft = 1e-13;
  equations.begin_tangent(shift);
  if (!equations.factor_tangent())
    return false;
  Vector part = x;
  for (int iteration = 0; iteration < 3; ++iteration) // what is strained shrinks by its stiffness
    part = equations.solve_tangent(shift * diagonal.cwiseProduct(part));
  return part.norm() > x.norm() / 2. &&
         part.dot(S * part) <= soft * part.dot(diagonal.cwiseProduct(part));
}

bool Newton::drag_alone_holds(const Vector &x, const Response &response) {
  constexpr double hardly_elastic = 1e-3;
  const double work = equations.drag_factor() * x.dot(diagonal.cwiseProduct(x));
  return work > 0. && loads_do(work, x) && x.dot(S * x) <= hardly_elastic * work &&
         strains_nothing(x) && is_resisted_in_vain(x, response, true);
}

bool Newton::loads_do(const double work, const Vector &motion) const {
  constexpr double rounding_of_work = 1e-3;
  return equations.loads.dot(motion) >= (1. - rounding_of_work) * work;
}

bool Newton::step_around_centre(Vector &x, Vector &forces, Response &response, Result &result) {
  Vector direction;
  ++result.iterations;
  if (!equations.factor(response, result) || !equations.solve(forces, response, result, direction))
    return false;
  const Vector start = x;
  equations.begin_step();
  const auto go = [&](const double length) {
    x = start + length * direction;
    equations.evaluate_on_step(length, x, response);
    forces = equations.forces_left(response);
    return equations.energy(forces);
  };
  search_by_halving(go, equations.energy(forces), 0.0625);
  return true;
}

bool Newton::approach(Vector &x, Response &response, Result &result) {
  equations.evaluate(x, response);
  Vector forces = equations.forces_left(response);
  if (response.failed || !step_around_centre(x, forces, response, result) || response.failed)
    return false;
  take_forces_as_centre(response);
  return true;
}

Outcome Newton::solve_proximal(Vector &x, Response &response, Result &result) {
  equations.evaluate(x, response);
  Vector forces = equations.forces_left(response);
  for (unsigned int iteration = 0;; ++iteration) {
    if (settings.in_each_iteration)
      settings.in_each_iteration();
    if (response.failed) {
      result.remark = "a law had no answer";
      return Outcome::stalled;
    }
    if (equations.balanced(forces, x, response, result))
      return Outcome::solved;
    if (iteration == most_proximal || !step_around_centre(x, forces, response, result)) {
      result.remark = "no convergence in " + std::to_string(most_proximal) + " iterations";
      return slides_away(x, response) ? Outcome::slides_away : Outcome::stalled;
    }
  }
}

void Newton::eliminate_centre(Response &response, std::vector<Strains> &step) const {
  const double epsilon = std::min(1., proximal.stiffness_factor / stiffness_of_direction);
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    if (!proximal.is_exact(i)) {
      step[i].setZero();
      continue;
    }
    proximal.centre[i][3] = response.stress[i][3]; // torsion has no proximal term
    const LawWithoutCentre without(response.tangent[i], (1. - epsilon) * proximal.by_centre(i));
    response.tangent[i] = without.times(response.tangent[i]);
    step[i] = without.times(proximal.misfit[i]);
    response.stress[i] = proximal.centre[i] + step[i];
  }
}

Outcome Newton::solve_together(const unsigned int most_iterations, Vector &x, Response &response,
                               Result &result, const double nothing_to_gain,
                               const double most_rise) {
  std::vector<Strains> step(contacts.size());
  equations.evaluate(x, response);
  double before = equations.energy_together(response);
  Vector direction;
  unsigned int stalls = 0;
  struct Solved {
    Vector x;
    std::vector<Strains> centre;
    double merit;
  };
  std::optional<Solved> solved; // the best so far that the tolerances accept
  const auto take = [&]() {
    if (!response.failed && before <= solved->merit)
      return Outcome::solved;
    x = solved->x;
    proximal.centre = solved->centre;
    equations.evaluate(x, response);
    equations.balanced(equations.forces_left(response), x, response, result);
    return Outcome::solved;
  };
  for (unsigned int iteration = 0;; ++iteration) {
    if (settings.in_each_iteration)
      settings.in_each_iteration();
    if (response.failed || !(before < std::numeric_limits<double>::max()))
      return solved ? take() : Outcome::stalled;
    // A tenth of the tolerance is aimed at, and the whole accepted where rounding bars the way.
    // From there a step or two more, on the same states of contact, reach rounding.
    const bool last = iteration == most_iterations || stalls == most_stalls;
    const bool is_balanced =
        equations.balanced(equations.forces_left(response), x, response, result);
    const double natural_map =
        is_balanced || last ? equations.check(response).natural_map : not_looked_at;
    const bool holds = is_balanced && natural_map <= (last ? 1. : 0.1) * settings.contact_tolerance;
    if (solved && (before > least_gain * solved->merit || (last && !holds))) {
      if (!holds)
        before = std::numeric_limits<double>::max();
      return take();
    }
    if (holds && (last || (natural_map <= sharp * settings.contact_tolerance &&
                           equations.force_left <=
                               std::max({sharp * settings.tolerance * equations.largest_force,
                                         equations.rounding, nothing_to_gain}))))
      return Outcome::solved;
    if (holds)
      solved = {x, proximal.centre, before};
    if (last) {
      if (equations.force_left > equations.rounding || natural_map > settings.contact_tolerance)
        return Outcome::stalled;
      // As good as rounding lets it be: what is left is solved for once more, on the whole line.
      if (equations.force_left <= most_rounding * equations.largest_force)
        return Outcome::solved;
      if (slides_away(x, response))
        return Outcome::slides_away;
      is_barred = true;
      return Outcome::stalled;
    }

    eliminate_centre(response, step);
    ++result.iterations;
    if (!equations.factor(response, result) ||
        !equations.solve(equations.forces_left(response), response, result, direction)) {
      before = std::numeric_limits<double>::max();
      if (solved)
        return take();
      return slides_away(x, response) ? Outcome::slides_away : Outcome::stalled;
    }
    const Vector start = x;
    for (unsigned int i = 0; i < contacts.size(); ++i)
      if (proximal.is_exact(i))
        step[i] += response.tangent[i] * equations.strain_of(i, direction);

    const std::vector<Strains> centre = proximal.centre;
    equations.begin_step();
    const auto go = [&](const double length) {
      x = start + length * direction;
      for (unsigned int i = 0; i < contacts.size(); ++i)
        proximal.centre[i] = centre[i] + length * step[i];
      equations.evaluate_on_step(length, x, response);
      return equations.energy_together(response);
    };
    before = take_step_of_both(go, most_rise * before, stalls);
  }
}

} // namespace frictionbeam::contact
