// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/inelastic/yielding.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <map>

namespace frictionbeam {

namespace {

/// The end of the step from which that of a frame starts; null if there is none.
const Frame *before(const std::vector<const Frame *> &frames, const Frame &frame) {
  const auto found = std::lower_bound(
      frames.begin(), frames.end(), frame.step_before,
      [](const Frame *one, const int step) { return static_cast<int>(one->step) < step; });
  return found != frames.end() && static_cast<int>((*found)->step) == frame.step_before ? *found
                                                                                        : nullptr;
}

/// By which a section's strain grew in the step that ends with a frame.
double growth(const std::vector<const Frame *> &frames, const Frame &frame, const std::size_t i,
              double SectionState::*const strain) {
  const Frame *const last = before(frames, frame);
  return frame.sections[i].*strain - (last != nullptr ? last->sections[i].*strain : 0.);
}

/// Where a section has flowed most, the last such frame.
const Frame &most_flowed_in(const std::vector<const Frame *> &frames, const std::size_t i) {
  const Frame *most = frames.front();
  for (const Frame *frame : frames)
    if (frame->sections[i].inelastic_strain() >= most->sections[i].inelastic_strain())
      most = frame;
  return *most;
}

/// Each section where it has flowed most.
std::vector<SectionState> most_flowed_sections(const std::vector<const Frame *> &frames) {
  std::vector<SectionState> result;
  for (std::size_t i = 0; i < frames.back()->sections.size(); ++i)
    result.push_back(most_flowed_in(frames, i).sections[i]);
  return result;
}

/// Of a strain that only grows: the largest, and the step in which that grew most.
WorstSection worst_of(const std::vector<const Frame *> &frames,
                      const std::vector<SectionState> &end, const std::vector<std::size_t> &own,
                      double SectionState::*const strain) {
  std::size_t worst = own.front();
  for (const std::size_t i : own)
    if (end[i].*strain > end[worst].*strain)
      worst = i;
  WorstSection result{end[worst].*strain, end[worst].s, ""};
  double most = 0.;
  for (const Frame *frame : frames)
    if (const double now = growth(frames, *frame, worst, strain); now > most) {
      most = now;
      result.step = frame->name;
    }
  return result;
}

WorstSection largest_utilization(const std::vector<const Frame *> &frames,
                                 const std::vector<std::size_t> &own) {
  WorstSection result;
  for (const Frame *frame : frames)
    for (const std::size_t i : own)
      if (const SectionState &section = frame->sections[i];
          section.utilization > result.value || std::isnan(section.utilization))
        result = {section.utilization, section.s, frame->name};
  return result;
}

/// @param first, last of its sections in each frame
Hinge hinge_between(const std::vector<const Frame *> &frames, const std::vector<SectionState> &end,
                    const std::size_t first, const std::size_t last) {
  Hinge hinge{end[first].s, end[last].s, end[first], "", false};
  for (std::size_t i = first; i <= last; ++i) {
    if (end[i].plastic_strain > hinge.worst.plastic_strain)
      hinge.worst = end[i];
    hinge.flows =
        hinge.flows || growth(frames, *frames.back(), i, &SectionState::plastic_strain) > 0.;
  }
  for (const Frame *frame : frames)
    for (std::size_t i = first; i <= last && hinge.since.empty(); ++i)
      if (frame->sections[i].is_hinge())
        hinge.since = frame->name;
  return hinge;
}

} // namespace

std::vector<const Frame *> frames_of_sections(const Results &results) {
  std::vector<const Frame *> frames;
  for (const Frame &frame : results.frames)
    if (!frame.sections.empty()) {
      AssertDimension(frame.sections.size(),
                      (frames.empty() ? frame : *frames.front()).sections.size());
      frames.push_back(&frame);
    }
  return frames;
}

Frame most_flowed(const std::vector<const Frame *> &frames) {
  Frame result = *frames.back();
  result.sections = most_flowed_sections(frames);
  for (std::size_t i = 0; i < result.sections.size(); ++i)
    if (most_flowed_in(frames, i).step != result.step)
      result.name = over_all_steps;
  return result;
}

std::vector<PipeYield> yield_of_pipes(const Results &results) {
  const std::vector<const Frame *> frames = frames_of_sections(results);
  std::vector<PipeYield> pipes;
  if (frames.empty())
    return pipes;
  const std::vector<SectionState> end = most_flowed_sections(frames);
  std::map<unsigned int, std::vector<std::size_t>> sections_of_pipe;
  for (std::size_t i = 0; i < end.size(); ++i)
    sections_of_pipe[end[i].pipe].push_back(i);
  const std::vector<Hinge> found = hinges_of(frames);
  for (const auto &[pipe, own] : sections_of_pipe) {
    PipeYield one;
    one.pipe = pipe;
    one.plastic = worst_of(frames, end, own, &SectionState::plastic_strain);
    one.creep = worst_of(frames, end, own, &SectionState::creep_strain);
    one.utilization = largest_utilization(frames, own);
    for (const std::size_t i : own)
      one.dissipated += end[i].length * end[i].dissipated;
    for (const Hinge &hinge : found)
      one.n_hinges += hinge.worst.pipe == pipe ? 1 : 0;
    pipes.push_back(one);
  }
  return pipes;
}

std::vector<Hinge> hinges_of(const std::vector<const Frame *> &frames) {
  std::vector<Hinge> found;
  const std::vector<SectionState> end = most_flowed_sections(frames);
  for (std::size_t first = 0; first < end.size(); ++first) {
    if (!end[first].is_hinge())
      continue;
    std::size_t last = first;
    while (last + 1 < end.size() && end[last + 1].pipe == end[first].pipe &&
           end[last + 1].is_hinge())
      ++last;
    found.push_back(hinge_between(frames, end, first, last));
    first = last;
  }
  return found;
}

} // namespace frictionbeam
