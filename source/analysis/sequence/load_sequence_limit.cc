// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/contact/opposed_contacts.h"
#include "analysis/increment/report_result.h"
#include "analysis/sequence/load_sequence.h"
#include "base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {
constexpr unsigned int most_tries = 3000;               // of increments in a step
constexpr unsigned int most_iterations_on_path = 50000; // of an increment
constexpr unsigned int most_increments_of_yield = 300;  // of lines for which halving is left
constexpr unsigned int of_mechanism = 6;                // increments of a mechanism
constexpr double on_the_way = 1e-2; // between a limit and its bound where the mechanism goes on
constexpr double rounding_of_load = 1e-9; // below which a load has not fallen

/// A part of a step's loads, 0 where a step begins at its limit but for rounding.
double without_rounding(const double part) { return std::abs(part) < rounding_of_load ? 0. : part; }
} // namespace

double LoadSequence::part_done() const {
  return (current.time - position.start) / model.scene.steps[position.step].duration;
}

bool LoadSequence::has_path() const {
  if (!model.cells.pipe_sections().any())
    return true;
  const LoadStep &step = model.scene.steps[position.step];
  const double end = position.start + step.duration;
  const bool grows_evenly =
      std::none_of(step.loads.begin(), step.loads.end(), [&](const auto &load) {
        return model.scene.loads[load.first].history.is_given();
      });
  const Vector imposed = course.imposed(end) - course.imposed(position.start);
  return model.contacts.size() == 0 && grows_evenly &&
         (imposed.size() == 0 || imposed.lpNorm<Eigen::Infinity>() == 0.);
}

void LoadSequence::pass(const std::size_t next, const bool ends, const Observer &observer) {
  const LoadStep &step = model.scene.steps[position.step];
  const std::size_t last = position.next;
  position.next = next;
  if (ends)
    current.time = position.start + step.duration; // where the next step's time begins
  if (next > last)
    observer({position.step, static_cast<unsigned int>(next), step.n_increments}, current);
  else
    observer({position.step, static_cast<unsigned int>(next), step.n_increments, false, true},
             current);
  if (between_increments)
    between_increments();
}

bool LoadSequence::run_to_limit(const Observer &observer) {
  const LoadStep &step = model.scene.steps[position.step];
  const unsigned int n = step.n_increments;
  StepReport &report = step_reports.back();
  const bool may_yield = model.cells.pipe_sections().any();
  for (unsigned int k = 0; position.next < n; ++k) {
    if (may_yield && (path.is_lost() || report.increments >= most_increments_of_yield)) {
      report.remark.clear();
      // Halves would go on and on to poses that carry a little more.
      if (!model.cells.turns_far() || path.n_soft_increments() == 0 || !end_within(on_the_way))
        return false;
      pass(n, true, observer);
      return true;
    }
    if (k == most_tries) {
      report.remark = "no limit in " + std::to_string(most_tries) +
                      " increments: " + rounded_number(part_done(), 6) +
                      " of this step's loads is carried, and the line goes on moving";
      return false;
    }
    const double done = part_done();
    const LimitPath::Trial trial = path.next(done);
    const Vector before = current.unknowns;
    const OnPath now = try_on_path(trial, done);
    bool ends = false;
    if (now == OnPath::accepted) {
      path.add(current.unknowns - before, part_done() - done, part_done());
      ends = may_yield ? end_at_collapse() : path.is_flat();
      if (ends && !may_yield && is_about_to_meet())
        return false;
      if (ends && !may_yield)
        end_at_limit("it moves without more load, most at ");
    } else {
      ++report.halvings;
      if (now == OnPath::strayed)
        path.halve_again(trial);
      else if (!path.halve(trial, now == OnPath::passed)) {
        if (now != OnPath::passed && may_yield) {
          path.lose();
          continue;
        }
        if (now != OnPath::passed) {
          fail_on_path();
          return false;
        }
        if (is_about_to_meet())
          return false;
        end_at_limit("beyond it the line carries less, or is unstable; it moves most at ");
        ends = true;
      }
    }
    pass(ends || part_done() >= 1.
             ? n
             : std::min<std::size_t>(n - 1, n * part_done() * (1. + rounding_of_load)),
         ends, observer);
  }
  return true;
}

std::optional<LimitLoad> LoadSequence::bound_of_yield() const {
  const double duration = model.scene.steps[position.step].duration;
  const auto collapse = statics.collapse(current, course.factors_at(position.start, side),
                                         course.factors_at(position.start + duration, side));
  if (!collapse)
    return {};
  return LimitLoad{without_rounding(part_done()), without_rounding(collapse->bound),
                   collapse->mechanism};
}

bool LoadSequence::end_at_collapse() {
  const unsigned int n = path.n_soft_increments();
  const bool is_asked = n == 1 || n == of_mechanism / 2 || n >= of_mechanism; // it costs much
  if (!is_asked)
    return false;
  return end_within(n < of_mechanism ? open_by_proof : on_the_way);
}

bool LoadSequence::end_within(const double open) {
  const auto limit = bound_of_yield();
  if (!limit || !(limit->bound <= (1. + open) * limit->reached))
    return false;
  step_reports.back().limit = limit;
  step_reports.back().remark.clear();
  return true;
}

LoadSequence::OnPath LoadSequence::try_on_path(const LimitPath::Trial &trial, const double done) {
  const double duration = model.scene.steps[position.step].duration,
               end = position.start + duration, time = position.start + trial.part * duration;
  StepReport &report = step_reports.back();
  const Factors at_end = course.factors_at(end, side);
  LineState to = current;
  std::optional<PathLead> lead;
  if (trial.unknown)
    lead.emplace(PathLead{*trial.unknown, trial.motion, end, at_end, trial.before});
  iterations_left = most_iterations_on_path;
  const double at_time = trial.part < 1. ? time : end;
  last_result = solve_statics(course.factors_at(at_time, side), at_time, lead, to);
  const std::string remark = report.remark;
  if (!add_result(last_result, report)) {
    report.no_equilibrium = false;
    return path.is_at_rest() && is_unstable_as_it_stands(at_time) ? OnPath::passed : OnPath::failed;
  }
  if (!lead)
    to.time = at_time;
  const double part = (to.time - position.start) / duration;
  if (part > 1.)
    return OnPath::strayed; // the next one is expected to end with all loads, or half as far
  if (path.is_passed() ? part < done : part < done - rounding_of_load * std::abs(done))
    return OnPath::passed;
  if (path.strays(trial, to.unknowns - current.unknowns, done, part))
    return OnPath::strayed;
  to.load_factors = course.factors_at(to.time, side);
  if (statics.is_unstable(to) || (lead && descends_behind(*lead, at_time, to)))
    return OnPath::passed;
  to.time = std::max(to.time, current.time); // equal but for rounding
  take(to, course.declared(to.time), to.time);
  ++report.increments;
  if (each_increment)
    each_increment({static_cast<unsigned int>(step_reports.size() - 1), report.increments, 0},
                   current);
  return OnPath::accepted;
}

bool LoadSequence::descends_behind(PathLead lead, const double time, const LineState &to) {
  constexpr double further = 1e-3; // of the increment
  if (response.status == current.contact_status || lead.before != nullptr)
    return false;
  const contact::Response of_it = response; // which is committed with it
  LineState beyond = current;
  lead.motion *= 1. + further;
  const bool is_found = solve_statics(course.factors_at(time, side), time, lead, beyond).converged;
  response = of_it;
  return is_found && beyond.time < to.time;
}

bool LoadSequence::is_unstable_as_it_stands(const double time) const {
  LineState to = current;
  to.time = time;
  to.load_factors = course.factors_at(time, side);
  return statics.is_unstable(to);
}

bool LoadSequence::is_about_to_meet() {
  constexpr double near = 1e-3; // of the largest motion
  const double moved = current.unknowns.lpNorm<Eigen::Infinity>();
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    if (current.contact_status[i] != ContactStatus::open || !contact.law.has_closed_form() ||
        contact.length * current.contacts.strain[i][0] + contact.law.closed_form().gap >
            near * moved ||
        is_held_opposite(model.contacts, current, i))
      continue;
    step_reports.back().remark =
        "at " + rounded_number(part_done(), 6) +
        " of the way of this step's loads the line gives way until it meets support " +
        model.scene.supports[contact.support].name +
        ", and what it carries there is not found along the path: take the step without Find, or "
        "begin it with this contact closed";
    return true;
  }
  return false;
}

bool LoadSequence::jumps(const LineState &to, const double time) const {
  const double done = part_done(),
               part = (time - position.start) / model.scene.steps[position.step].duration;
  return model.scene.steps[position.step].finds_limit && model.cells.turns_far() &&
         path.strays(path.given(part, done), to.unknowns - current.unknowns, done, part);
}

void LoadSequence::end_at_limit(const std::string &why) {
  StepReport &report = step_reports.back();
  report.limit = {without_rounding(part_done()), std::numeric_limits<double>::infinity(),
                  why + path.place_of_most_motion()};
  if (const auto limit = bound_of_yield(); limit && limit->bound <= widest_limit * limit->reached) {
    report.limit->bound = limit->bound;
    report.limit->mechanism += "; " + limit->mechanism;
  }
  report.remark.clear();
}

void LoadSequence::end_with_all_loads() {
  step_reports.back().limit = {1., std::numeric_limits<double>::infinity(),
                               "all of its loads are carried"};
}

void LoadSequence::fail_on_path() {
  step_reports.back().remark =
      "stopped at time " + rounded_number(current.time, 6) + ": " + last_result.remark +
      ", also after halving the increment " + std::to_string(model.scene.solver.max_halvings) +
      " times; " + rounded_number(part_done(), 6) + " of the way of this step's loads was carried";
}

} // namespace frictionbeam
