// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/stress/stress_evaluation.h"
#include "results/stress/unintensified_places.h"

#include "results/stress/stresses.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// Factors of every station, for who asks.
void add_factors(const StressEvaluation &evaluation, StressCase &result) {
  for (const Station &station : result.frame.line)
    result.factors.push_back(evaluation.code.intensification(evaluation.point(station)));
}

void find_worst(StressCase &result) {
  for (unsigned int i = 0; i < result.stress.size(); ++i)
    if (result.stress[i] / result.allowed[i] >
        result.stress[result.worst] / result.allowed[result.worst])
      result.worst = i;
}

} // namespace

namespace {

using Formulas = StressCode::Formula (StressCode::*)(const StressPoint &) const;

/// Forces of the code at a station.
/// @param before that they count from, or null
StressForces forces_of(const StressEvaluation::Axes &axes, Motion force,
                       const Motion *const before) {
  if (before != nullptr)
    for (unsigned int c = 0; c < 6; ++c)
      force[c] -= (*before)[c];
  return axes.forces(force.data());
}

/// The stresses of a case whose forces are known at one instant, or within bounds: the code's
/// stresses are convex in the forces, so that none between the bounds is larger than that at one
/// of their corners.
class StressOfCase {
public:
  StressOfCase(const StressEvaluation &evaluation, const Frame &frame) : evaluation(evaluation) {
    least = largest = &frame;
    for (const CombinationRange &range : evaluation.results.combination_ranges)
      if (range.step == frame.step) {
        least = &range.least;
        largest = &range.largest;
      }
  }

  /// @param before forces that the case's count from, or null
  void operator()(const unsigned int i, const StressPoint &point, const double pressure,
                  const Formulas formula, const Motion *const before, StressCase &result) const {
    const Station &station = least->line[i];
    const StressEvaluation::Axes axes = evaluation.axes(station, pressure);
    const StressCode::Formula stress = (evaluation.code.*formula)(point);
    double most = 0.;
    StressForces at_most;
    const unsigned int n_corners = least == largest ? 1 : 16;
    for (unsigned int corner = 0; corner < n_corners; ++corner) {
      Motion force = station.force;
      const std::array<unsigned int, 4> varies{{0, 3, 4, 5}}; // shears make no stress
      for (unsigned int k = 0; k < 4; ++k)
        if ((corner >> k & 1) != 0)
          force[varies[k]] = largest->line[i].force[varies[k]];
      const StressForces forces = forces_of(axes, force, before);
      const double value = stress(forces);
      if (corner == 0 || value > most) {
        most = value;
        at_most = forces;
      }
    }
    result.stress.push_back(most);
    result.forces.push_back(at_most);
  }

private:
  const StressEvaluation &evaluation;
  const Frame *least, *largest;
};

/// The largest stresses over a transient step, with the forces of their instants; false if there
/// are none.
/// @param before that the forces of a range count from, or null @param pressure in a pipe [Pa]
bool take_envelope(const StressEvaluation &evaluation, const Frame &frame, const std::string &from,
                   const Frame *const before,
                   const std::function<double(const unsigned int)> &pressure, StressCase &result) {
  const StepEnvelope *const envelope = evaluation.results.envelope_of(frame.step);
  if (envelope == nullptr)
    return false;
  for (const StressEnvelope &one : envelope->stresses)
    if (one.from == from && one.stress.size() == frame.line.size()) {
      result.stress = one.stress;
      result.time = one.time;
      for (std::size_t i = 0; i < frame.line.size(); ++i) {
        Motion force;
        std::copy_n(one.force.begin() + 6 * i, 6, force.begin());
        result.forces.push_back(
            forces_of(evaluation.axes(frame.line[i], pressure(frame.line[i].pipe)), force,
                      before != nullptr ? &before->line[i].force : nullptr));
      }
      return true;
    }
  return false;
}

/// Sustained or occasional stresses at the end of a step, of a transient one the largest; none if
/// the step was not reached.
/// @param pressure in a pipe during a step [Pa]
std::optional<StressCase>
case_of_loads(const StressEvaluation &evaluation, const std::string &step, const bool occasional,
              const std::function<double(const std::string &, const unsigned int)> &pressure) {
  const Frame *const frame = evaluation.frame_of(step);
  if (frame == nullptr)
    return {};
  const StressCode &code = evaluation.code;
  StressCase result;
  result.name = result.step = step;
  result.kind = occasional ? "occasional" : "sustained";
  result.frame = *frame;
  const bool is_known = take_envelope(
      evaluation, *frame, "", nullptr,
      [&](const unsigned int pipe) { return pressure(step, pipe); }, result);
  const StressOfCase stress_of(evaluation, *frame);
  for (unsigned int i = 0; i < frame->line.size(); ++i) {
    const Station &station = frame->line[i];
    const StressPoint point = evaluation.point(station);
    if (!is_known)
      stress_of(i, point, pressure(step, station.pipe), &StressCode::sustained, nullptr, result);
    result.allowed.push_back(
        code.allowed(occasional ? StressLimit::occasional : StressLimit::sustained, point));
  }
  return result;
}

/// The expansion range from one step to another; none if either was not reached.
/// @param cases of which the first @p n_sustained are sustained, whose largest stress at a station
/// counts for what the range may be there
std::optional<StressCase> case_of_expansion(const StressEvaluation &evaluation,
                                            const std::string &from, const std::string &to,
                                            const std::vector<StressCase> &cases,
                                            const std::size_t n_sustained) {
  const Frame *const before = evaluation.frame_of(from), *const after = evaluation.frame_of(to);
  if (before == nullptr || after == nullptr)
    return {};
  AssertDimension(before->line.size(), after->line.size());
  StressCase result;
  result.name = from + " to " + to;
  result.step = to;
  result.kind = "expansion";
  result.frame = *after;
  const bool is_known = take_envelope(
      evaluation, *after, from, before, [](const unsigned int) { return 0.; }, result);
  const StressOfCase stress_of(evaluation, *after);
  for (unsigned int i = 0; i < after->line.size(); ++i) {
    const StressPoint point = evaluation.point(after->line[i]);
    double sustained = 0.;
    for (std::size_t s = 0; s < n_sustained; ++s)
      sustained = std::max(sustained, cases[s].stress[i]);
    if (!is_known)
      stress_of(i, point, 0., &StressCode::expansion_range, &before->line[i].force, result);
    result.allowed.push_back(evaluation.code.allowed(StressLimit::range, point, sustained));
  }
  return result;
}

} // namespace

std::vector<StressCase>
evaluate_stresses(const Scene &scene, const LineMesh &mesh, const Results &results,
                  const std::function<double(const std::string &, const unsigned int)> &pressure) {
  std::vector<StressCase> cases;
  if (scene.stress.code.empty())
    return cases;
  const StressEvaluation evaluation(scene, mesh, results);
  const auto add = [&](std::optional<StressCase> one) {
    if (!one)
      return;
    one->code = evaluation.code.name();
    find_worst(*one);
    add_factors(evaluation, *one);
    cases.push_back(std::move(*one));
  };
  for (const std::string &step : scene.stress.sustained)
    add(case_of_loads(evaluation, step, false, pressure));
  const std::size_t n_sustained = cases.size();
  for (const std::string &step : scene.stress.occasional)
    add(case_of_loads(evaluation, step, true, pressure));
  for (const auto &[from, to] : scene.stress.expansion)
    add(case_of_expansion(evaluation, from, to, cases, n_sustained));
  return cases;
}

std::string check_stress_code(const Scene &scene, const LineMesh &mesh,
                              const std::vector<Station> &line) {
  StressEvaluation(scene, mesh, Results()).check(line);
  return unintensified_places(scene, mesh);
}

namespace {

/// Whether a station is on the side of its point and on the pipe that a quantity asks for. The
/// frames of stresses have both sides of every node.
bool is_asked(const Quantity &quantity, const Scene &scene, const LineMesh &mesh,
              const std::vector<Station> &line, const unsigned int i) {
  using Side = Quantity::Side;
  if (quantity.where.empty())
    return true;
  const Station &station = line[i];
  if (station.vertex != mesh.points.at(quantity.where) ||
      (!quantity.pipe.empty() && scene.pipes[station.pipe].name != quantity.pipe))
    return false;
  const bool ends_a_cell =
      i > 0 && line[i - 1].pipe == station.pipe && line[i - 1].vertex != station.vertex;
  return quantity.side == Side::any || (quantity.side == Side::before) == ends_a_cell;
}

} // namespace

std::optional<double> stress_quantity(const Quantity &quantity, const Scene &scene,
                                      const LineMesh &mesh, const Results &results) {
  // in the order of quantity_kinds
  enum Component : unsigned int { flexibility, sif_in, sif_out, sustained, range, utilization };
  const auto component = static_cast<Component>(quantity.kind().component);
  std::optional<double> largest;
  for (const StressCase &one : results.stresses) {
    const bool is_range = one.kind == "expansion";
    if ((component == sustained && is_range) || (component == range && !is_range) ||
        (!quantity.step.empty() && quantity.step != one.step))
      continue;
    for (unsigned int i = 0; i < one.stress.size(); ++i) {
      if (!is_asked(quantity, scene, mesh, one.frame.line, i))
        continue;
      const double value = component == flexibility   ? one.factors[i].flexibility
                           : component == sif_in      ? one.factors[i].in_plane
                           : component == sif_out     ? one.factors[i].out_of_plane
                           : component == utilization ? one.stress[i] / one.allowed[i]
                                                      : one.stress[i];
      largest = std::max(largest.value_or(0.), value);
    }
  }
  return largest;
}

std::vector<std::pair<unsigned int, unsigned int>> nozzle_sites(const Scene &scene,
                                                                const Results &results) {
  std::vector<std::pair<unsigned int, unsigned int>> sites;
  for (unsigned int n = 0; n < scene.nozzles.size(); ++n)
    for (unsigned int i = 0; i < results.restraints.size(); ++i) {
      const std::string &name = results.restraints[i].name, &support = scene.nozzles[n].support;
      if (name == support || name.substr(0, name.rfind('.')) == support)
        sites.emplace_back(n, i);
    }
  return sites;
}

double utilization(const NozzleLimit &nozzle, const Motion &force) {
  double result = 0.;
  for (unsigned int c = 0; c < 6; ++c)
    if (nozzle.allowed[c] > 0.)
      result = std::max(result, std::abs(force[c]) / nozzle.allowed[c]);
  return result;
}

std::vector<NozzleUse> evaluate_nozzles(const Scene &scene, const Results &results) {
  std::vector<NozzleUse> uses;
  const auto sites = nozzle_sites(scene, results);
  for (unsigned int n = 0; n < scene.nozzles.size(); ++n)
    for (const Frame &frame : results.frames) {
      if (!frame.is_judged)
        continue; // which no nozzle carries
      const StepEnvelope *const envelope = results.envelope_of(frame.step);
      for (unsigned int k = 0; frame.end_of_step && k < sites.size(); ++k) {
        if (sites[k].first != n)
          continue;
        const NozzleLimit &nozzle = scene.nozzles[n];
        const unsigned int i = sites[k].second;
        NozzleUse use{nozzle.name,
                      results.restraints[i].name,
                      frame.name,
                      frame.reactions[i],
                      nozzle.allowed,
                      0.,
                      {}};
        if (envelope != nullptr) {
          use.force = envelope->nozzles[k].force;
          use.time = envelope->nozzles[k].time;
        }
        use.utilization = utilization(nozzle, use.force);
        uses.push_back(use);
      }
    }
  return uses;
}

} // namespace frictionbeam
