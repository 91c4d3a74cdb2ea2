// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/report/report_tables.h"
#include "results/combination/governing_cases.h"
#include "results/file/envelope_tables.h"
#include "results/frame/frame_choice.h"
#include "results/page/html.h"
#include "results/picture/marker.h"
#include "results/text.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace frictionbeam {

namespace {

/// Loads active at the end of a step; of a case, none.
std::string load_list(const Scene &scene, const Frame &frame) {
  if (frame.step >= scene.steps.size())
    return dash;
  const LoadStep &step = scene.steps[frame.step];
  std::string list;
  for (const auto &[load, factor] : step.loads) {
    AssertIndexRange(load, scene.loads.size());
    list += (list.empty() ? "" : ", ") + scene.loads[load].name +
            (factor == 1. ? "" : " \u00d7 " + rounded_number(factor));
  }
  return list.empty() ? dash : list;
}

/// Where the line has moved most, as text, and how far [m].
std::pair<std::string, double> largest_displacement(const Scene &scene, const Frame &frame) {
  std::string where = dash;
  double largest = 0.;
  for (const Station &station : frame.line) {
    const double size =
        std::hypot(station.displacement[0], station.displacement[1], station.displacement[2]);
    if (std::isfinite(size) && size > largest) {
      largest = size;
      where = scene.pipes[station.pipe].name +
              ", s = " + rounded_number(station.s / scene.units.factor("m")) + " " +
              scene.units.name("m");
    }
  }
  return {where, largest};
}

/// Where and when a node has moved most in a transient step.
std::string place_and_instant(const Scene &scene, const StepEnvelope &envelope) {
  const StationPlace &place = envelope.displaced_most;
  return scene.pipes.empty()
             ? dash
             : scene.pipes[place.pipe].name +
                   ", s = " + rounded_number(place.s / scene.units.factor("m")) + " " +
                   scene.units.name("m") +
                   ", t = " + rounded_number(envelope.displacement.largest_at) + " s";
}

std::string left_out(const std::size_t n_shown, const std::size_t n_all, const std::string &what,
                     const std::string &file) {
  if (n_shown == n_all)
    return "";
  return html_note("Shown are the " + std::to_string(n_shown) + " " + what +
                   " with the largest forces of " + std::to_string(n_all) + "; " + file +
                   " has all.");
}

/// Of force times length: work that is smaller is rounding, and shown as zero.
constexpr double least_work = 1e-4;
constexpr double rounding_of_forces = 1e-9; ///< beside moments at 1 m, and the other way
constexpr double least_length = 1e-9;       ///< [m], of a scene without pipes
constexpr double rounding_of_work = 1e-8;   ///< of all supports together, likewise

std::string support_table(const Results &results, const Frame &frame) {
  AssertDimension(frame.supports.size(), results.supports.size());
  std::vector<double> weight;
  Largest force, length;
  length(largest_motion(frame)); // beside which gaps and slips may be nothing but rounding
  length(least_length);
  for (const SupportState &state : frame.supports) {
    for (const double value : {state.fn, state.ft1, state.ft2})
      force(value);
    for (const double value : {state.gap, state.slip1, state.slip2})
      length(value);
    const double size = std::hypot(state.fn, state.ft1, state.ft2);
    weight.push_back(std::isfinite(size) ? size : 0.);
  }
  const auto rows = rows_to_show(weight);
  const auto column = [&](const auto &value) {
    std::vector<double> values;
    for (const std::size_t row : rows)
      values.push_back(value(frame.supports[row]));
    return values;
  };
  std::vector<std::string> names, kinds, status;
  std::vector<std::string> ratio;
  for (const std::size_t row : rows) {
    const SupportState &state = frame.supports[row];
    names.push_back(results.supports[row].name);
    kinds.push_back(results.supports[row].kind);
    status.push_back(status_cell(state.status));
    ratio.push_back(state.fn > 0. && state.status != ContactStatus::none
                        ? fixed_number(friction_force(state) / state.fn, 3)
                        : dash);
  }
  const bool any_moment = std::any_of(frame.supports.begin(), frame.supports.end(),
                                      [](const SupportState &state) { return state.mt != 0.; });
  HtmlTable table(results.units);
  table.text("support", names)
      .text("kind", kinds)
      .html("status", status)
      .numbers("fn", "N", column([](const SupportState &s) { return s.fn; }), force.value())
      .numbers("ft1", "N", column([](const SupportState &s) { return s.ft1; }), force.value())
      .numbers("ft2", "N", column([](const SupportState &s) { return s.ft2; }), force.value())
      .right("|ft| / fn", ratio)
      .numbers("gap", "m", column([](const SupportState &s) { return s.gap; }), length.value())
      .numbers("slip1", "m", column([](const SupportState &s) { return s.slip1; }), length.value())
      .numbers("slip2", "m", column([](const SupportState &s) { return s.slip2; }), length.value());
  if (any_moment)
    table.numbers("mt", "N m", column([](const SupportState &s) { return s.mt; }));
  return table
             .numbers("friction work", "J",
                      column([](const SupportState &s) { return s.work_friction; }),
                      least_work * force.value() * length.value())
             .str() +
         left_out(rows.size(), frame.supports.size(), "supports", "supports.csv");
}

std::string reaction_table(const Results &results, const Frame &frame) {
  AssertDimension(frame.reactions.size(), results.restraints.size());
  std::vector<double> weight;
  std::array<Largest, 2> force; // and moment
  for (const Motion &reaction : frame.reactions) {
    Largest largest;
    for (unsigned int c = 0; c < 6; ++c) {
      largest(reaction[c]);
      force[c / 3](reaction[c]);
    }
    weight.push_back(largest.value());
  }
  const auto rows = rows_to_show(weight);
  std::vector<std::string> names, kinds;
  for (const std::size_t row : rows) {
    names.push_back(results.restraints[row].name);
    kinds.push_back(results.restraints[row].kind);
  }
  static const std::array<const char *, 6> headers{{"fx", "fy", "fz", "mx", "my", "mz"}};
  HtmlTable table(results.units);
  table.text("restraint", names).text("kind", kinds);
  for (unsigned int c = 0; c < 6; ++c) {
    std::vector<double> values;
    for (const std::size_t row : rows)
      values.push_back(frame.reactions[row][c]);
    const unsigned int kind = c / 3;
    table.numbers(headers[c], kind == 0 ? "N" : "N m", values,
                  std::max(force[kind].value(), rounding_of_forces * force[1 - kind].value()));
  }
  return table.str() + left_out(rows.size(), frame.reactions.size(), "restraints", "reactions.csv");
}

/// A tab for each frame; of a transient step its envelope first.
template <typename MakeTable, typename MakeEnvelope>
std::string tabs(const std::string &id, const Results &results,
                 const std::vector<const Frame *> &frames, const MakeTable &make_table,
                 const MakeEnvelope &make_envelope) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const Frame *frame : frames) {
    const StepEnvelope *const envelope = results.envelope_of(frame->step);
    panels.emplace_back(frame->name, (envelope != nullptr ? "<h3>Over the step</h3>\n" +
                                                                make_envelope(results, *envelope) +
                                                                "<h3>At its end</h3>\n"
                                                          : "") +
                                         make_table(*frame));
  }
  return html_tabs(id, panels);
}

} // namespace

std::string quantity_table(const Results &results) {
  std::vector<std::string> names, values, units, references, errors, sources;
  for (const QuantityResult &quantity : results.quantities) {
    names.push_back(quantity.name);
    values.push_back(optional_number(quantity.value, 8));
    units.push_back(quantity.unit);
    references.push_back(optional_number(quantity.reference, 8));
    errors.push_back(optional_number(quantity.error, 2));
    sources.push_back(quantity.source);
  }
  return HtmlTable()
             .text("quantity", names)
             .right("value", values)
             .text("unit", units)
             .right("reference", references)
             .right("error", errors)
             .text("source of the reference", sources)
             .str() +
         html_note("Errors are relative to the reference, or absolute where the reference is 0.");
}

namespace {

/// The rows of the table of steps, column by column.
struct StepRows {
  const Scene &scene;
  const Results &results;
  std::vector<std::string> names, loads, where;
  std::vector<double> displacement, normal, friction, work;
  const std::array<ContactStatus, 4> statuses{
      {ContactStatus::stick, ContactStatus::slip, ContactStatus::open, ContactStatus::closed}};
  std::array<std::vector<std::string>, 4> counts; ///< of supports, by status

  /// The largest values over all instants of a transient step.
  void add_largest(const Frame &frame, const StepEnvelope &envelope) {
    names.push_back(frame.name + ", largest");
    loads.push_back(load_list(scene, frame));
    where.push_back(place_and_instant(scene, envelope));
    displacement.push_back(envelope.displacement.largest);
    for (auto &count : counts)
      count.push_back(dash);
    normal.push_back(envelope.sum_normal.largest);
    friction.push_back(envelope.sum_friction.largest);
    work.push_back(std::numeric_limits<double>::quiet_NaN());
  }

  /// The end of a step. @param remark behind its name
  void add_end(const Frame &frame, const std::string &remark) {
    names.push_back(frame.name + remark);
    loads.push_back(load_list(scene, frame));
    const auto [place, size] = largest_displacement(scene, frame);
    where.push_back(place);
    displacement.push_back(size);
    std::array<unsigned int, 4> count{};
    SupportState sums;
    double sum_work = 0.;
    for (const SupportState &state : frame.supports) {
      for (unsigned int s = 0; s < 4; ++s)
        count[s] += state.status == statuses[s] ? 1 : 0;
      sums.fn += std::abs(state.fn);
      sums.ft1 += friction_force(state);
      sum_work += state.work_friction;
    }
    if (!frame.together.empty()) // a builder has made it: of a case not those of its supports
      sums = frame.together.front();
    const bool is_step = frame.step < scene.steps.size(); // a case has no contact status, no work
    for (unsigned int s = 0; s < 4; ++s)
      counts[s].push_back(is_step ? std::to_string(count[s]) : dash);
    normal.push_back(std::abs(sums.fn));
    friction.push_back(std::abs(sums.ft1));
    work.push_back(is_step ? sum_work : std::numeric_limits<double>::quiet_NaN());
  }

  static double largest(const std::vector<double> &values) {
    double result = 0.;
    for (const double value : values)
      result = std::fmax(result, std::abs(value));
    return result;
  }

  std::string table() const {
    HtmlTable table(results.units);
    table.text("step", names).text("loads", loads);
    if (!scene.pipes.empty())
      table.numbers("displacement", "m", displacement).text("at", where);
    for (unsigned int s = 0; s < 4; ++s)
      if (std::any_of(counts[s].begin(), counts[s].end(),
                      [](const std::string &count) { return count != "0" && count != dash; }))
        table.right(status_word(statuses[s]), counts[s]);
    return table.numbers("\u03a3 |fn|", "N", normal)
        .numbers("\u03a3 |ft|", "N", friction)
        .numbers("work", "J", work, rounding_of_work * largest(normal) * largest(displacement))
        .str();
  }
};

} // namespace

std::string step_table(const Scene &scene, const Results &results,
                       const std::vector<const Frame *> &frames) {
  StepRows rows{scene, results};
  bool any_envelope = false;
  for (const Frame *frame : frames) {
    const StepEnvelope *const envelope = results.envelope_of(frame->step);
    if (envelope != nullptr) {
      any_envelope = true;
      rows.add_largest(*frame, *envelope);
    }
    rows.add_end(*frame, std::string(envelope != nullptr ? ", end" : "") +
                             (is_finished(results, *frame) ? "" : " (not finished)"));
  }
  return rows.table() +
         html_note(
             std::string("At the end of each step: its loads, ") +
             (scene.pipes.empty() ? "" : "the largest displacement of the line and where it is, ") +
             "the number of supports in each state, and sums over the supports of normal "
             "force, friction force and friction work so far." +
             (any_envelope ? " Of transient steps also the largest over all instants." : ""));
}

std::string support_tables(const Results &results, const std::vector<const Frame *> &frames) {
  return tabs(
             "supports-of", results, frames,
             [&](const Frame &frame) {
               return support_table(results, frame) + governing_support_table(results, frame);
             },
             &support_envelope_table) +
         html_note(
             "Forces are those of the support on the pipe, fn positive in compression, ft1 and "
             "ft2 in the sliding plane. |ft| / fn is the friction that is used; a sticking "
             "support stays below its friction coefficient. Slip is that of the pipe on the "
             "ground since contact began.");
}

std::string reaction_tables(const Results &results, const std::vector<const Frame *> &frames) {
  return tabs(
             "reactions-of", results, frames,
             [&](const Frame &frame) {
               return reaction_table(results, frame) + governing_reaction_table(results, frame);
             },
             &reaction_envelope_table) +
         html_note("Forces and moments on the pipe in global axes, z up.");
}

} // namespace frictionbeam
