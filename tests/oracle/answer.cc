// SPDX-License-Identifier: LGPL-2.1-or-later
#include "answer.h"

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

} // namespace

Answer::Answer(const Scene &scene, const Outcome &program) {
  const frictionbeam::Results &results = program.results;
  for (const frictionbeam::Frame &frame : results.frames) {
    if (!frame.end_of_step || frame.increment == 0 || frame.step >= scene.steps.size())
      continue;
    steps.emplace_back();
    auto &step = steps.back();
    for (const frictionbeam::History &history : results.histories)
      for (std::size_t i = history.time.size(); i-- > 0;)
        if (history.time[i] <= frame.time) {
          step[history.point + " u"] = {Kind::displacement, three(history.displacement[i], 0)};
          step[history.point + " r"] = {Kind::rotation, three(history.displacement[i], 3)};
          break;
        }
    for (std::size_t i = 0; i < results.supports.size(); ++i) {
      const frictionbeam::SupportInfo &info = results.supports[i];
      const frictionbeam::SupportState &state = frame.supports[i];
      Vec force;
      for (int d = 0; d < 3; ++d)
        force[d] = state.fn * info.normal[d] + state.ft1 * info.t1[d] + state.ft2 * info.t2[d];
      Entry &entry =
          step.emplace(without_side(info.name) + " force", Entry{Kind::force, Vec::Zero()})
              .first->second;
      entry.value += force;
    }
    for (std::size_t i = 0; i < results.restraints.size(); ++i) {
      const std::string &name = results.restraints[i].name;
      step[name + " force"] = {Kind::force, three(frame.reactions[i], 0)};
      step[name + " moment"] = {Kind::moment, three(frame.reactions[i], 3)};
    }
  }
  for (const frictionbeam::ModeResult &mode : results.modes)
    frequencies.push_back(mode.frequency);
}

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
  const double turning = mapping.turn.determinant();
  const std::size_t n = std::min(original.steps.size(), changed.steps.size());
  if (original.steps.size() != changed.steps.size())
    note(1., "number of steps", Vec::Constant(changed.steps.size()),
         Vec::Constant(original.steps.size()));
  for (std::size_t s = 0; s < n; ++s) {
    double scale[4] = {};
    std::map<std::string, Answer::Entry> mapped = original.steps[s];
    for (auto &[name, entry] : mapped) {
      using Kind = Answer::Kind;
      const bool axial = entry.kind == Kind::rotation || entry.kind == Kind::moment;
      const double factor = entry.kind == Kind::displacement ? mapping.length
                            : entry.kind == Kind::force      ? mapping.force
                            : entry.kind == Kind::moment     ? mapping.force * mapping.length
                                                             : 1.;
      entry.value = factor * (axial ? turning : 1.) * (mapping.turn * entry.value);
      double &largest = scale[static_cast<int>(entry.kind)];
      largest = std::max(largest, entry.value.norm());
    }
    scale[2] = std::max(scale[2], 1e-3); // below a hundredth of a nanonewton nothing is asked
    scale[0] = std::max(scale[0], scale[1] * mapping.length / 10.);
    scale[1] = std::max(scale[1], scale[0] / mapping.length / 10.);
    scale[2] = std::max(scale[2], scale[3] / mapping.length / 10.);
    scale[3] = std::max(scale[3], scale[2] * mapping.length / 10.);
    for (const auto &[name, entry] : mapped)
      if (const auto other = changed.steps[s].find(name); other != changed.steps[s].end()) {
        const double size = scale[static_cast<int>(entry.kind)];
        const double off = (other->second.value - entry.value).norm();
        note(off / std::max(size, 1e-12), "step " + std::to_string(s + 1) + ", " + name,
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
