// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/verdicts.h"

#include "model/line_model.h"
#include "results/combination/uplift.h"
#include "results/energy_judgement.h"
#include "results/how_well_known.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {

/// Of what supports and loads of a solid, or a line and its solid parts, hand to each other, a
/// share of the largest force: some forty times what the verification's have.
constexpr double most_force_lost = 1e-4;
constexpr std::size_t most_named = 3;

/// All of one check that was judged; what of it is told is chosen at the end.
class OneCheck {
public:
  OneCheck(const std::string &name, const std::string &section, const std::string &unit)
      : like{name, "", "", 0., {}, unit, true, section} {}

  void judge(const std::string &of, const std::string &step, const double value,
             const double allowed) {
    add(of, step, value, allowed, value <= allowed);
  }
  void add(const std::string &of, const std::string &step, const double value,
           const std::optional<double> allowed, const bool passes) {
    Verdict verdict = like;
    verdict.of = of;
    verdict.step = step;
    verdict.value = value;
    verdict.allowed = allowed;
    verdict.passes = passes;
    all.push_back(verdict);
  }
  /// What fails, or else what came nearest to it.
  void tell(std::vector<Verdict> &told) const {
    const std::size_t before = told.size();
    std::copy_if(all.begin(), all.end(), std::back_inserter(told),
                 [](const Verdict &verdict) { return !verdict.passes; });
    if (told.size() == before && !all.empty())
      told.push_back(
          *std::max_element(all.begin(), all.end(),
                            [](const Verdict &a, const Verdict &b) { return use(a) < use(b); }));
  }

private:
  /// Of what is allowed; where nothing is, the least value is nearest to failing.
  static double use(const Verdict &verdict) {
    return !verdict.allowed        ? -verdict.value
           : *verdict.allowed > 0. ? verdict.value / *verdict.allowed
                                   : verdict.value;
  }

  Verdict like;
  std::vector<Verdict> all;
};

OneCheck solution(const Results &results) {
  OneCheck check("solution", "solver", "-");
  for (const Check &one : results.certificate)
    if (one.name == "equilibrium")
      check.add("every step", "", one.value, {}, results.status == RunStatus::converged);
  return check;
}

/// Whether a transient step takes energy away on purpose.
bool damps(const Scene &scene) {
  const TimeSettings &time = scene.time;
  const bool is_newmark = time.integrator == Integrator::newmark;
  return has_transient_step(scene) && !time.is_exact() &&
         (time.theta > 0.5 || (is_newmark && time.gamma > 0.5) ||
          (!is_newmark && time.spectral_radius < 1.));
}

OneCheck energy(const Scene &scene, const Results &results) {
  OneCheck check("energy", "solver", "-");
  if (damps(scene))
    return check;
  const bool by_increments =
      scene.kinematics == Kinematics::corotational && !has_transient_step(scene);
  for (const Check &one : results.certificate)
    if (one.name == "energy" && std::isfinite(one.value))
      check.judge("what the account leaves over", "", one.value,
                  by_increments ? most_energy_left_by_increments : most_energy_left);
  return check;
}

/// Forces that are there twice in a model with solids.
OneCheck balance(const Results &results) {
  OneCheck check("force balance", "solver", "-");
  for (const Check &one : results.certificate)
    if (one.name == "support_balance" || one.name == "solid_join")
      check.judge(one.name, "", one.value, most_force_lost);
  return check;
}

/// Pipes that are solved as elastic and yield where nothing looks.
OneCheck yield(const Results &results) {
  constexpr double most_unseen = 0.01; // of the elastic bound
  OneCheck check("yield", "solver", "-");
  if (const double unseen = unseen_yield(results); unseen > 0.)
    check.judge("strains between the sections of a cell", "", unseen, most_unseen);
  return check;
}

OneCheck stress(const Results &results) {
  OneCheck check("stress", "stresses", "Pa");
  for (const StressCase &one : results.stresses)
    if (!one.stress.empty())
      check.judge(one.kind + " " + one.name, one.step, one.stress[one.worst],
                  one.allowed[one.worst]);
  return check;
}

OneCheck nozzles(const Results &results) {
  OneCheck check("allowable loads", "nozzles", "-");
  for (const NozzleUse &one : results.nozzles)
    check.judge(one.name + " at " + one.support, one.step, one.utilization, 1.);
  return check;
}

/// Variability over all temperatures, and the range of items of a catalogue.
OneCheck hangers(const Results &results) {
  OneCheck check("hanger", "hangers", "-");
  for (const HangerUse &one : results.hangers) {
    if (one.stiffness > 0.)
      check.judge(
          one.name + ", variability" +
              (one.hot_load > 0. ? "" : ", of which there is none: its hot load is not above 0"),
          one.step, one.variability, one.allowed_variability);
    if (!one.item.empty()) {
      check.judge(one.name + ", load over the most of " + one.item, one.most_step,
                  one.most_load / one.most_allowed, 1.);
      check.judge(one.name + ", least load of " + one.item + " over the load", one.least_step,
                  one.least_load > 0. ? one.least_allowed / one.least_load
                                      : std::numeric_limits<double>::infinity(),
                  1.);
    }
    if (one.allowed_travel > 0.)
      check.judge(one.name + ", travel over that of " + one.item, "",
                  one.largest_travel / one.allowed_travel, 1.);
  }
  return check;
}

OneCheck uplift(const Scene &scene, const Results &results) {
  OneCheck check("uplift", "uplift", "N");
  for (const Uplift &one : uplifts_of(scene, results))
    check.add(results.supports[one.support].name, one.case_name, one.least, {}, !one.lifts);
  return check;
}

double size_of(const Motion &force) { return std::hypot(force[0], force[1], force[2]); }

/// Over all steps, transient ones at each instant, and combinations that are states.
OneCheck capacity(const Results &results) {
  OneCheck check("capacity", "supports", "N");
  const auto judge = [&](const std::string &name, const double limit, const auto &at_end,
                         const auto &at_most, const auto &is_struck) {
    if (limit == 0.)
      return;
    for (const Frame &frame : results.frames) {
      if (!frame.is_judged)
        continue;
      const StepEnvelope *const envelope = results.envelope_of(frame.step);
      if (envelope != nullptr && is_struck(*envelope))
        check.add(name + ", which is struck: the force of an impact has no largest", frame.name,
                  std::numeric_limits<double>::infinity(), limit, false);
      else
        check.judge(name, frame.name, envelope != nullptr ? at_most(*envelope) : at_end(frame),
                    limit);
    }
  };
  for (std::size_t i = 0; i < results.supports.size(); ++i)
    judge(
        results.supports[i].name, results.supports[i].capacity,
        [&](const Frame &frame) {
          const SupportState &state = frame.supports[i];
          return std::hypot(state.fn, state.ft1, state.ft2);
        },
        [&](const StepEnvelope &envelope) {
          return std::abs(envelope.supports[i].force.extreme());
        },
        [&](const StepEnvelope &envelope) { return envelope.supports[i].n_impacts > 0; });
  for (std::size_t i = 0; i < results.restraints.size(); ++i)
    judge(
        results.restraints[i].name, results.restraints[i].capacity,
        [&](const Frame &frame) { return size_of(frame.reactions[i]); },
        [&](const StepEnvelope &envelope) {
          return std::abs(envelope.restraints[i].force.extreme());
        },
        [](const StepEnvelope &) { return false; });
  return check;
}

/// Quantities of which something is asked and that the run did not come to.
void add_not_reached(const Scene &scene, const Results &results,
                     const std::optional<double> Quantity::*const asked, OneCheck &check) {
  if (scene.model != ModelKind::line && !scene.is_solid()) // bodies have quantities of their own
    return;
  for (const Quantity &quantity : scene.quantities)
    if (quantity.*asked &&
        std::none_of(results.quantities.begin(), results.quantities.end(),
                     [&](const QuantityResult &one) { return one.name == quantity.name; }))
      check.add(quantity.name + ", which was not reached", quantity.step,
                std::numeric_limits<double>::infinity(), *(quantity.*asked), false);
}

OneCheck limits(const Scene &scene, const Results &results) {
  OneCheck check("limit", "quantities", "");
  add_not_reached(scene, results, &Quantity::limit, check);
  for (const QuantityResult &one : results.quantities)
    if (one.limit && one.of_impact)
      check.add(one.name + ", the force of an impact, which has no largest", "",
                std::numeric_limits<double>::infinity(), *one.limit, false);
    else if (one.limit)
      check.judge(one.name + " [" + one.unit + "]", "", std::abs(one.value), *one.limit);
  return check;
}

OneCheck references(const Scene &scene, const Results &results) {
  OneCheck check("reference", "quantities", "-");
  add_not_reached(scene, results, &Quantity::reference, check);
  for (const QuantityResult &one : results.quantities)
    if (one.error && one.reference != 0.) // of which nothing is relative
      check.judge(one.name, "", *one.error, scene.checks.reference_tolerance);
  return check;
}

} // namespace

std::vector<Verdict> verdicts_of(const Scene &scene, const Results &results) {
  std::vector<Verdict> told;
  solution(results).tell(told);
  if (results.accuracy)
    told.push_back(
        {"accuracy",
         results.accuracy->left_out.empty() ? "all quantities" : "quantities but those left out",
         "", results.accuracy->estimate, results.accuracy->demanded, "-", results.accuracy->reached,
         "accuracy"});
  energy(scene, results).tell(told);
  balance(results).tell(told);
  yield(results).tell(told);
  stress(results).tell(told);
  nozzles(results).tell(told);
  hangers(results).tell(told);
  if (scene.checks.uplift)
    uplift(scene, results).tell(told);
  capacity(results).tell(told);
  limits(scene, results).tell(told);
  references(scene, results).tell(told);
  return told;
}

bool any_fails(const std::vector<Verdict> &verdicts) {
  return std::any_of(verdicts.begin(), verdicts.end(),
                     [](const Verdict &verdict) { return !verdict.passes; });
}

std::string failures_in_words(const std::vector<Verdict> &verdicts) {
  std::string text;
  std::size_t n = 0;
  for (const Verdict &verdict : verdicts)
    if (!verdict.passes && ++n <= most_named)
      text += (n == 1 ? "" : ", ") + verdict.check + " of " + verdict.of +
              (verdict.step.empty() ? "" : " in " + verdict.step);
  if (n == 0)
    return "";
  if (n > most_named)
    text += " and " + std::to_string(n - most_named) + " more";
  return (n == 1 ? "A check fails: " : std::to_string(n) + " checks fail: ") + text + ".";
}

} // namespace frictionbeam
