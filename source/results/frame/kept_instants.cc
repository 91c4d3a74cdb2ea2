// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/kept_instants.h"

#include <algorithm>

namespace frictionbeam {

namespace {

constexpr std::size_t n_at_most = 120,                ///< of a step
    n_numbers_at_most = 120000, size_of_support = 10; ///< stations times instants, of all steps

} // namespace

KeptInstants::KeptInstants(const Scene &scene, Results &results)
    : scene(scene), results(results),
      n_steps(std::count_if(scene.steps.begin(), scene.steps.end(),
                            [](const LoadStep &one) { return one.transient; })) {}

std::size_t KeptInstants::most_of(const Frame &frame) const {
  const std::size_t size = frame.line.size() + size_of_support * frame.supports.size() + 1;
  return std::min(n_at_most, n_numbers_at_most / (size * n_steps));
}

void KeptInstants::add(const Frame &frame) {
  if (frame.end_of_step || frame.step >= scene.steps.size() || !scene.steps[frame.step].transient)
    return;
  if (frame.step != step) {
    step = frame.step;
    first = results.instants.size();
    n_seen = 0;
    every = 1;
  }
  const std::size_t most = most_of(frame);
  if (most < 2 || n_seen++ % every > 0)
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
