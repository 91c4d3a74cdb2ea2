// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/energy_judgement.h"

#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {
constexpr double remark_above = 1e-6, failed_above = most_energy_left, gained_above = 1e-3;
constexpr double failed_above_at_contacts = 0.1; ///< where contacts that give way may gain some

/// Diagonal of the box about all there is [m].
double size_of_scene(const Results &results) {
  std::array<Extremes, 3> bounds;
  const auto add = [&](const Point3 &place) {
    for (unsigned int d = 0; d < 3; ++d)
      bounds[d].include(place[d], 0.);
  };
  for (const PointInfo &point : results.points)
    add(point.position);
  for (const SupportInfo &support : results.supports)
    add(support.position);
  if (!results.frames.empty())
    for (const Station &station : results.frames.back().line)
      add(station.position);
  Vector3 size;
  for (unsigned int d = 0; d < 3; ++d)
    if (bounds[d].is_known())
      size[d] = bounds[d].largest - bounds[d].least;
  return size.norm();
}
} // namespace

double energy_of_rounding(const Results &results) {
  constexpr double rounding = 1e-12;
  double force = 0.;
  for (const Frame &frame : results.frames) {
    for (const SupportState &support : frame.supports)
      force = std::max({force, std::abs(support.fn), std::hypot(support.ft1, support.ft2)});
    for (const Motion &reaction : frame.reactions)
      force = std::max(force, std::hypot(reaction[0], reaction[1], reaction[2]));
  }
  const double size = size_of_scene(results);
  return rounding * force * (size > 0. ? size : 1.);
}

namespace {
/// Whether motions in a transient step are more than rounding of displacements and places.
bool moves(const StepEnvelope &step, const double size_of_scene) {
  constexpr double rounding = 1e-9;
  const auto range = [](const Extremes &values) {
    return values.is_known() ? values.largest - values.least : 0.;
  };
  double size = std::abs(step.displacement.extreme()), motion = range(step.displacement);
  for (const std::array<Extremes, 6> &point : step.points)
    for (const Extremes &component : point) {
      size = std::max(size, std::abs(component.extreme()));
      motion = std::max(motion, range(component));
    }
  return motion > std::max(rounding * size, 1e-13 * size_of_scene);
}
} // namespace

void remark_on_gains(Results &results) {
  const double rounding = energy_of_rounding(results), size = size_of_scene(results);
  for (unsigned int i = 0; i < results.steps.size(); ++i) {
    StepReport &step = results.steps[i];
    const StepEnvelope *const envelope = results.envelope_of(i);
    if (!envelope || !moves(*envelope, size))
      continue;
    // Impacts lose energy: what they give is wrong, too, where numerical damping takes it again.
    const double by_impacts = -step.energy.impact,
                 gained = std::max(step.energy.gained(), by_impacts);
    // Where nothing moves, rounding is large beside the energy in motion.
    if (!(step.energy.at_hand >
          1e-9 * std::max(step.energy.stored, std::abs(step.energy.external))) ||
        !(gained > std::max(gained_above * step.energy.at_hand, rounding)))
      continue;
    const std::string gain =
        std::string(gained == by_impacts ? "its impacts have" : "the integrator has") + " gained " +
        rounded_number(100. * gained / step.energy.at_hand, 2) +
        " % of the largest energy in motion";
    const double failed = results.supports.empty() ? failed_above : failed_above_at_contacts;
    if (gained > failed * step.energy.at_hand) {
      step.remark += (step.remark.empty() ? "" : "; ") + gain;
      step.converged = false;
      if (results.status == RunStatus::converged)
        results.status = RunStatus::failed;
    } else
      results.remarks.push_back("Step " + step.step + ": " + gain +
                                (results.supports.empty()
                                     ? ". Take a shorter time step or moreau_jean."
                                     : ", at contacts. Take a shorter time step, moreau_jean or "
                                       "event."));
  }
}

namespace {
/// Of a transient step: the largest energy in motion, or that came or went [J].
double largest_term(const EnergyAccount &energy) {
  return std::max({energy.at_hand, std::abs(energy.external), energy.dissipated, energy.inelastic,
                   energy.damping, std::abs(energy.impact)});
}
} // namespace

double left_over_beyond_rounding(const EnergyAccount &energy) {
  return std::max(0., std::abs(energy.left_over()) - energy.least_scale);
}

double least_turnover(const std::vector<StepReport> &steps) {
  double largest = 0.;
  for (const StepReport &step : steps)
    largest = std::max(largest, step.energy.turnover);
  return 1e-6 * largest;
}

namespace {
/// With large displacements the account measures the increments.
void judge_increments(const Scene &scene, Results &results) {
  for (unsigned int i = 0; i < results.steps.size(); ++i) {
    const EnergyAccount &energy = results.steps[i].energy;
    const double turnover = std::max(energy.turnover, least_turnover(results.steps)),
                 left_over = left_over_beyond_rounding(energy);
    if (!scene.steps[i].transient && left_over > most_energy_left_by_increments * turnover)
      results.remarks.push_back(
          "Step " + results.steps[i].step + ": the account of energy leaves over " +
          rounded_number(100. * left_over / turnover, 2) +
          " % of its turnover: its increments are too large to follow the line, or the line has "
          "snapped from one pose to another. Take more of them, or a transient step.");
  }
}
} // namespace

void judge_energy(const Scene &scene, Results &results) {
  if (scene.kinematics == Kinematics::corotational) {
    judge_increments(scene, results);
    return;
  }
  for (unsigned int i = 0; i < results.steps.size(); ++i) {
    StepReport &step = results.steps[i];
    const bool is_exact = scene.steps[i].transient && scene.time.is_exact();
    const double turnover = std::max(is_exact ? largest_term(step.energy) : step.energy.turnover,
                                     least_turnover(results.steps)),
                 left_over = left_over_beyond_rounding(step.energy);
    if ((scene.steps[i].transient && !is_exact) || !(left_over > remark_above * turnover) ||
        (is_exact && !(left_over > energy_of_rounding(results))))
      continue;
    const std::string account = "the account of energy leaves over " +
                                rounded_number(100. * left_over / turnover, 2) + " % of its " +
                                (is_exact ? "largest term" : "turnover");
    if (left_over <= failed_above * turnover) {
      results.remarks.push_back("Step " + step.step + ": " + account +
                                ": its numbers are known to about that.");
      continue;
    }
    step.remark += (step.remark.empty() ? "" : "; ") + account;
    step.converged = false;
    if (results.status == RunStatus::converged)
      results.status = RunStatus::failed;
  }
}

} // namespace frictionbeam
