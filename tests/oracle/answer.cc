// SPDX-License-Identifier: LGPL-2.1-or-later
#include "answer.h"
#include "units.h"
#include "write_scene.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace oracle {

namespace {

template <typename Values>
Vec three(const Values &values, const int first) {
  return Vec(values[first], values[first + 1], values[first + 2]);
}

/// A guide's two sides are one: "guide.plus" and "guide.minus" become "guide".
std::string without_side(std::string name) {
  for (const std::string side : {".plus", ".minus"})
    if (const auto at = name.find(side); at != std::string::npos)
      name.erase(at, side.size());
  return name;
}

using Turns = Answer::Turns;
using Kind = Answer::Kind;
using StepAnswer = std::map<std::string, Answer::Entry>;

/// How a step, the spectra or a combination turn: signs are lost in some.
Turns turns_of(const Scene &scene, const std::string &name) {
  if (name == "spectrum")
    return Turns::absolute;
  for (const Combination &combination : scene.combinations) {
    if (combination.name != name)
      continue;
    bool all_vectors = true;
    for (const auto &part : combination.cases)
      all_vectors = all_vectors && turns_of(scene, part.first) == Turns::vector;
    if (combination.kind == "srss" || combination.kind == "absolute")
      return Turns::absolute;
    if (combination.kind == "range")
      return all_vectors ? Turns::absolute : Turns::unknown;
    return all_vectors ? Turns::vector : Turns::unknown;
  }
  return Turns::vector;
}

void add_motions(const frictionbeam::Results &results, const double time, StepAnswer &step) {
  for (const frictionbeam::History &history : results.histories)
    for (std::size_t i = history.time.size(); i-- > 0;)
      if (history.time[i] <= time) {
        step[history.point + " u"] = {Kind::displacement, three(history.displacement[i], 0)};
        step[history.point + " r"] = {Kind::rotation, three(history.displacement[i], 3)};
        break;
      }
}

/// Below this a normal force is rounding, and when the support last touched is nobody's knowledge.
double force_that_touches(const frictionbeam::Results &results) {
  double largest = 0.;
  for (const frictionbeam::Frame &frame : results.frames)
    for (const frictionbeam::SupportState &state : frame.supports)
      largest = std::max(largest, state.fn);
  return 1e-12 * largest;
}

void add_supports(const frictionbeam::Results &results, const frictionbeam::Frame &frame,
                  const double force_that_touches, StepAnswer &step) {
  for (std::size_t i = 0; i < results.supports.size(); ++i) {
    const frictionbeam::SupportInfo &info = results.supports[i];
    const frictionbeam::SupportState &state = frame.supports[i];
    Vec force, slip;
    for (int d = 0; d < 3; ++d) {
      force[d] = state.fn * info.normal[d] + state.ft1 * info.t1[d] + state.ft2 * info.t2[d];
      slip[d] = state.slip1 * info.t1[d] + state.slip2 * info.t2[d];
    }
    const std::string name = without_side(info.name);
    step.emplace(name + " force", Answer::Entry{Kind::force, Vec::Zero()}).first->second.value +=
        force;
    if (name != info.name)
      continue;
    if (state.fn > force_that_touches)
      step[name + " slip"] = {Kind::displacement, slip};
    step[name + " mt"] = {Kind::moment, Vec(std::abs(state.mt), 0., 0.), Turns::fixed};
  }
}

void add_reactions(const frictionbeam::Results &results, const frictionbeam::Frame &frame,
                   const Turns turns, StepAnswer &step) {
  for (std::size_t i = 0; i < results.restraints.size(); ++i) {
    const std::string &name = results.restraints[i].name;
    step[name + " force"] = {Kind::force, three(frame.reactions[i], 0), turns};
    step[name + " moment"] = {Kind::moment, three(frame.reactions[i], 3), turns};
  }
}

/// The largest over a transient step.
void add_envelope(const frictionbeam::Results &results, const frictionbeam::StepEnvelope &envelope,
                  StepAnswer &step) {
  const auto add = [&](const std::string &name, const Kind kind, const double value) {
    if (std::isfinite(value))
      step[name + " over the step"] = {kind, Vec(value, 0., 0.), Turns::fixed};
  };
  for (std::size_t i = 0; i < results.supports.size(); ++i) {
    const std::string &name = results.supports[i].name;
    if (name != without_side(name))
      continue;
    add(name + " fn", Kind::force, envelope.supports[i].values[0].largest);
    add(name + " gap", Kind::displacement, envelope.supports[i].values[3].largest);
    add(name + " friction", Kind::force, envelope.supports[i].friction.largest);
  }
  for (std::size_t i = 0; i < results.restraints.size(); ++i)
    add(results.restraints[i].name, Kind::force, envelope.restraints[i].force.largest);
  add("displacement", Kind::displacement, envelope.displacement.largest);
}

/// What became of the work of the loads, of lines that yield.
void add_energies(const frictionbeam::EnergyAccount &account, StepAnswer &step) {
  const auto add = [&](const std::string &name, const double value) {
    step[name + " over the step"] = {Kind::energy, Vec(value, 0., 0.), Turns::fixed};
  };
  add("work of loads", account.external);
  add("stored energy", account.stored);
  add("dissipated by pipes", account.inelastic);
  add("dissipated by supports", account.dissipated);
}

/// Sums of sizes, component by component, depend on the axes, and so do stresses made of them; sums
/// of squares do not.
bool adds_sizes(const Scene &scene) {
  return std::any_of(scene.more.begin(), scene.more.end(), [](const auto &entry) {
    return entry.first.rfind("Response/", 0) == 0 && entry.second == "absolute";
  });
}

/// Stresses and nozzles, by what they use of what is allowed.
void add_judgements(const Scene &scene, const frictionbeam::Results &results,
                    const std::string &name, StepAnswer &step) {
  const Turns of_case = turns_of(scene, name);
  const bool is_known =
      of_case == Turns::vector || (of_case == Turns::absolute && !adds_sizes(scene));
  const Turns turns = is_known ? Turns::fixed : Turns::unknown;
  for (const frictionbeam::StressCase &one : results.stresses)
    if (one.step == name && !one.stress.empty()) {
      Answer::Entry entry{Kind::ratio, Vec(one.stress[one.worst] / one.allowed[one.worst], 0., 0.),
                          turns};
      entry.by_stations = true;
      step["utilization, " + one.kind] = entry;
    }
  for (const frictionbeam::NozzleUse &nozzle : results.nozzles)
    if (nozzle.step == name)
      step["nozzle " + nozzle.name] = {Kind::ratio, Vec(nozzle.utilization, 0., 0.), turns};
}

/// Motions of points, which the file asked for.
void add_quantities(const Scene &scene, const frictionbeam::Results &results,
                    const std::string &name, StepAnswer &step) {
  const Units units(scene.units);
  std::map<std::string, double> values;
  for (const frictionbeam::QuantityResult &quantity : results.quantities)
    values[quantity.name] = quantity.value;
  for (const std::string &point : scene.monitors) {
    Vec u, r;
    bool known = true;
    for (int c = 0; c < 6; ++c) {
      const auto found = values.find(quantity_name(
          point, name, std::array<const char *, 6>{{"ux", "uy", "uz", "rx", "ry", "rz"}}[c]));
      known = known && found != values.end();
      if (known)
        (c < 3 ? u : r)[c % 3] = found->second * (c < 3 ? units.length : 1.);
    }
    if (!known)
      continue;
    const Turns turns = turns_of(scene, name);
    step[point + " asked u"] = {Kind::displacement, u, turns};
    step[point + " asked r"] = {Kind::rotation, r, turns};
  }
}

} // namespace

Answer::Answer(const Scene &scene, const Outcome &program) {
  const frictionbeam::Results &results = program.results;
  const std::vector<std::string> names = cases_of(scene);
  for (const frictionbeam::Frame &frame : results.frames) {
    const bool derived = frame.step >= scene.steps.size();
    if (!frame.end_of_step || (frame.increment == 0 && !derived) || frame.step >= names.size())
      continue;
    steps.emplace_back();
    auto &step = steps.back();
    const std::string &name = names[frame.step];
    if (!derived) {
      add_motions(results, frame.time, step);
      add_supports(results, frame, force_that_touches(results), step);
      if (const auto *const envelope = results.envelope_of(frame.step))
        add_envelope(results, *envelope, step);
      if (scene.has_laws())
        add_energies(results.steps[frame.step].energy, step);
    }
    add_reactions(results, frame, turns_of(scene, name), step);
    add_judgements(scene, results, name, step);
    if (scene.quantities)
      add_quantities(scene, results, name, step);
  }
  for (const frictionbeam::ModeResult &mode : results.modes)
    frequencies.push_back(mode.frequency);
}

namespace {

using Scales = std::array<double, 6>;

/// The entries of a step as they shall be, and the largest of each kind.
StepAnswer mapped(StepAnswer step, const Mapping &mapping, Scales &scale) {
  const double turning = mapping.turn.determinant();
  const bool turns = !mapping.turn.isIdentity(0.);
  scale = {};
  for (auto it = step.begin(); it != step.end();) {
    Answer::Entry &entry = it->second;
    if ((turns && entry.turns == Turns::unknown) || (entry.by_stations && !mapping.same_stations) ||
        (it->first.find("over the step") != std::string::npos && !mapping.steps.empty())) {
      it = step.erase(it);
      continue;
    }
    const bool axial = entry.kind == Kind::rotation || entry.kind == Kind::moment;
    entry.value *= entry.kind == Kind::displacement ? mapping.length
                   : entry.kind == Kind::force      ? mapping.force
                   : entry.kind == Kind::moment || entry.kind == Kind::energy
                       ? mapping.force * mapping.length
                       : 1.;
    if (entry.turns == Turns::vector)
      entry.value = (axial ? turning : 1.) * (mapping.turn * entry.value);
    else if (entry.turns == Turns::absolute)
      entry.value = mapping.turn.cwiseAbs() * entry.value;
    double &largest = scale[static_cast<int>(entry.kind)];
    largest = std::max(largest, entry.value.norm());
    ++it;
  }
  scale[2] = std::max(scale[2], 1e-3 * mapping.force);  // below 1e-11 N nothing is asked,
  scale[0] = std::max(scale[0], 1e-6 * mapping.length); // nor below 1e-14 m
  scale[0] = std::max(scale[0], scale[1] * mapping.length / 10.);
  scale[1] = std::max(scale[1], scale[0] / mapping.length / 10.);
  scale[2] = std::max(scale[2], scale[3] / mapping.length / 10.);
  scale[3] = std::max(scale[3], scale[2] * mapping.length / 10.);
  scale[5] = std::max(scale[5], scale[2] * scale[0]);
  return step;
}

} // namespace

double largest_difference(const Answer &original, const Mapping &mapping, const Answer &changed,
                          std::string &what, int &numbers) {
  double worst = 0.;
  const auto note = [&](const double difference, const std::string &name, const Vec &is,
                        const Vec &should) {
    ++numbers;
    if (!(difference > worst) && std::isfinite(difference))
      return;
    worst = std::isfinite(difference) ? difference : 1e300;
    std::ostringstream out;
    out.precision(12);
    out << name << ": " << is.transpose() << ", should be " << should.transpose();
    what = out.str();
  };
  std::vector<std::pair<std::size_t, std::size_t>> pairs = mapping.steps;
  if (pairs.empty()) {
    for (std::size_t s = 0; s < std::min(original.steps.size(), changed.steps.size()); ++s)
      pairs.emplace_back(s, s);
    if (original.steps.size() != changed.steps.size())
      note(1., "number of steps", Vec::Constant(changed.steps.size()),
           Vec::Constant(original.steps.size()));
  }
  Scales largest_so_far = {};
  for (const auto &[from, to] : pairs) {
    if (from >= original.steps.size() && to >= changed.steps.size())
      continue; // neither got there
    if (from >= original.steps.size() || to >= changed.steps.size()) {
      note(1., "number of steps", Vec::Constant(changed.steps.size()),
           Vec::Constant(original.steps.size()));
      continue;
    }
    Scales scale;
    const StepAnswer should_be = mapped(original.steps[from], mapping, scale);
    for (const int i :
         {0, 1, 2, 3, 5}) { // increments keep the rounding of what was larger, to 1e-4 of it
      largest_so_far[i] = std::max(largest_so_far[i], scale[i]);
      scale[i] = std::max(scale[i], 1e-4 * largest_so_far[i]);
    }
    for (const auto &[name, entry] : should_be)
      if (const auto other = changed.steps[to].find(name); other != changed.steps[to].end()) {
        const double size = scale[static_cast<int>(entry.kind)];
        const double off = (other->second.value - entry.value).norm();
        note(off / std::max(size, 1e-12), "step " + std::to_string(from + 1) + ", " + name,
             other->second.value, entry.value);
      }
  }
  for (std::size_t i = 0; i < std::min(original.frequencies.size(), changed.frequencies.size());
       ++i) {
    const double right = original.frequencies[i] / mapping.time;
    note(std::abs(changed.frequencies[i] - right) / right, "mode " + std::to_string(i + 1),
         Vec::Constant(changed.frequencies[i]), Vec::Constant(right));
  }
  return worst;
}

} // namespace oracle
