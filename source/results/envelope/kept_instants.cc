// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/envelope/kept_instants.h"

#include <algorithm>

namespace frictionbeam {

namespace {

constexpr std::size_t n_instants_at_most = 120,
                      n_numbers_at_most = 60000, ///< of all steps
    size_of_support = 10, size_of_envelopes = 4,
                      n_stations_at_most = 2500; ///< those of a longer line are thinned

} // namespace

MotionBudget::MotionBudget(const Scene &scene, const std::size_t n_stations,
                           const std::size_t n_supports)
    : of_instant(std::min(n_stations, n_stations_at_most) + size_of_support * n_supports + 1),
      n_steps(std::count_if(scene.steps.begin(), scene.steps.end(),
                            [](const LoadStep &one) { return one.transient; })) {
  const std::size_t size = size_of_envelopes * std::min(n_stations, n_stations_at_most) * n_steps;
  if (size <= n_numbers_at_most / 2)
    of_envelopes = size;
}

std::size_t MotionBudget::n_instants() const {
  if (n_steps == 0)
    return 0;
  const std::size_t n = (n_numbers_at_most - of_envelopes) / (of_instant * n_steps);
  return n < 2 ? 0 : std::min(n, n_instants_at_most);
}

KeptInstants::KeptInstants(const Scene &scene, Results &results) : scene(scene), results(results) {}

void KeptInstants::add(const Frame &frame) {
  if (frame.end_of_step || frame.step >= scene.steps.size() || !scene.steps[frame.step].transient)
    return;
  if (frame.step != step) {
    step = frame.step;
    first = results.instants.size();
    n_seen = 0;
    every = 1;
  }
  const std::size_t most =
      MotionBudget(scene, frame.line.size(), frame.supports.size()).n_instants();
  if (most == 0 || n_seen++ % every > 0)
    return;
  results.instants.push_back(frame);
  if (results.instants.size() - first <= most)
    return;
  std::size_t n_kept = first;
  for (std::size_t i = first; i < results.instants.size(); i += 2)
    if (i != n_kept++)
      results.instants[n_kept - 1] = std::move(results.instants[i]);
  results.instants.resize(n_kept);
  every *= 2;
}

void KeptInstants::transfer(Archive &archive) {
  archive(results.instants, first, n_seen, every, step);
}

} // namespace frictionbeam
