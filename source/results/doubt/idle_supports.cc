// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/doubt/idle_supports.h"

#include "base/number_text.h"
#include "mesh/point_set.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double same_point = 1e-6; ///< [m]

/// Frames of steps, without those of spectra and combinations.
std::vector<const Frame *> frames_of_steps(const Scene &scene, const Results &results) {
  std::vector<const Frame *> frames;
  for (const Frame &frame : results.frames)
    if (frame.step < scene.steps.size())
      frames.push_back(&frame);
  return frames;
}

/// Whether a support has no force and neither opens nor closes.
bool is_idle(const std::vector<const Frame *> &frames, const std::size_t support) {
  const SupportState *first = nullptr;
  for (const Frame *const frame : frames) {
    if (frame->supports.size() <= support)
      continue;
    const SupportState &state = frame->supports[support];
    if (first == nullptr)
      first = &state;
    if (state.fn != 0. || state.gap != first->gap)
      return false;
  }
  return first != nullptr;
}

bool pushes_along(const std::vector<const Frame *> &frames, const std::size_t restraint,
                  const Vector3 &direction) {
  constexpr double rounding = 1e-9;
  return std::any_of(frames.begin(), frames.end(), [&](const Frame *const frame) {
    if (frame->reactions.size() <= restraint)
      return false;
    const Motion &force = frame->reactions[restraint];
    const Vector3 translation({force[0], force[1], force[2]});
    return std::abs(translation * direction) > rounding * translation.norm();
  });
}

} // namespace

void remark_on_idle_supports(const Scene &scene, Results &results) {
  const std::vector<const Frame *> frames = frames_of_steps(scene, results);
  const std::size_t n_restraints = results.restraints.size() - scene.springs.size(); // come first
  PointSet places(same_point);
  std::vector<std::vector<std::size_t>> held; // restraints at each place
  for (std::size_t r = 0; r < n_restraints; ++r) {
    const std::size_t place = places.insert(results.restraints[r].position);
    held.resize(places.points.size());
    held[place].push_back(r);
  }
  std::vector<std::string> idle;
  std::string held_by;
  for (std::size_t i = 0; i < results.supports.size(); ++i) {
    const SupportInfo &support = results.supports[i];
    const std::size_t place = places.insert(support.position);
    if (place >= held.size())
      continue;
    const auto pushing =
        std::find_if(held[place].begin(), held[place].end(),
                     [&](const std::size_t r) { return pushes_along(frames, r, support.normal); });
    if (pushing == held[place].end() || !is_idle(frames, i))
      continue;
    if (idle.empty())
      held_by = results.restraints[*pushing].name;
    idle.push_back(support.name);
  }
  if (!idle.empty())
    results.remarks.push_back("Supports that carry nothing, for an anchor or restraint holds their "
                              "points along their normals, and has all of the force: " +
                              first_of(idle) + " (beside " + held_by +
                              (idle.size() > 1 ? " and others)." : ")."));
}

} // namespace frictionbeam
