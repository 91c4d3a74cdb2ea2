// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/sequence/limit_path.h"

#include "model/mechanism.h"
#include "model/unknowns/line_extent.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {
constexpr double arm = 0.1;         // of the line's extent, by which rotations are motions
constexpr double small_step = 1e-3; // of the extent, within which nothing snaps to another branch
constexpr double large_step = 0.05; // of the extent
constexpr double most_deviation = 0.3; // of the expected gain
constexpr double of_loads = 0.01;      // which the expected gain may be off by besides
constexpr double rounding_of_increment = 1e-12,
                 rounding_of_all = 1e-9;         // of the extent: of an increment, and
                                                 // of all of the loads at its rate
constexpr double flat = 1e-6;                    // of the first slope
constexpr double no_gain = 1e-6;                 // of the loads, in an increment
constexpr unsigned int most_first_halvings = 40; // loads of any size may be declared
constexpr unsigned int several = 3;
constexpr double soft = 1e-2;       // of the first slope
constexpr double most_growth = 10.; // of a motion over what is expected, where hinges form
constexpr double growth = 2.;       // of the motion from one increment to the next

} // namespace

LimitPath::LimitPath(const Model &model) : model(model), extent(line_extent(model.discretization)) {
  const auto &steps = model.scene.steps;
  if (std::none_of(steps.begin(), steps.end(), [](const auto &step) { return step.finds_limit; }))
    return;
  weights.setOnes(model.space.n_unknowns());
  for (unsigned int v = 0; v < model.discretization.n_line_vertices(); ++v)
    for (unsigned int c = 3; c < 6; ++c)
      if (const auto dof = model.discretization.vertex_dofs().index(v, c);
          dof != dealii::numbers::invalid_dof_index)
        for (const auto &term : model.space.terms(dof))
          if (term.weight == 1.)
            weights[term.unknown] = arm * extent;
}

double LimitPath::measure(const Vector &of) const {
  return of.size() > 0 ? of.cwiseProduct(weights).lpNorm<Eigen::Infinity>() : 0.;
}

void LimitPath::begin(const double most_part, const bool led_by_work) {
  motion.resize(0);
  gain = size = first_slope = 0.;
  n_flat = n_halved = n_passed = n_soft = n_cuts = n_steady = 0;
  first = most = most_part;
  by_work = led_by_work;
}

LimitPath::Trial LimitPath::next(const double done) const {
  if (measure(motion) == 0.)
    return {std::min(done + first, 1.), {}};
  const double part = done + slope() * size;
  if (part >= 1.)
    return {1., {}, 0., (1. - done) / slope()};
  Eigen::Index unknown;
  motion.cwiseProduct(weights).cwiseAbs().maxCoeff(&unknown);
  const unsigned int leading = unknown;
  if (by_work)
    return {part, leading, size / measure(motion), size, &motion};
  return {part, leading, std::copysign(size / weights[unknown], motion[unknown]), size};
}

LimitPath::Trial LimitPath::given(const double part, const double done) const {
  const bool is_known = measure(motion) > 0. && gain > 0.;
  return {part, {}, 0., is_known ? (part - done) / slope() : 0.};
}

bool LimitPath::strays(const Trial &trial, const Vector &moved, const double done,
                       const double part) const {
  const double length = measure(moved);
  if (length <= small_step * extent)
    return false;
  if (by_work) // hinges that form change the slope, on a path that has no branches nearby
    return trial.size > 0. && length > most_growth * trial.size;
  if (!trial.unknown)
    return trial.size == 0. || std::abs(length - trial.size) > most_deviation * trial.size;
  return std::abs(part - trial.part) >
         most_deviation * std::abs(trial.part - done) + of_loads * std::abs(part);
}

void LimitPath::cut(const Trial &trial) {
  if (trial.size > 0.)
    size = trial.size / 2.;
  else
    first /= 2.;
}

bool LimitPath::halve(const Trial &trial, const bool passed) {
  cut(trial);
  n_cuts += passed ? 0 : 1;
  n_steady = several;
  unsigned int &count = passed ? n_passed : n_halved;
  return ++count <= (measure(motion) == 0. ? most_first_halvings : model.scene.solver.max_halvings);
}

void LimitPath::add(const Vector &moved, const double gained, const double done) {
  n_halved = 0;
  const double length = measure(moved);
  // A straight bar that is held at both ends, say, moves by nothing but rounding until it buckles.
  if (length <=
      (is_at_rest() ? extent * std::max(rounding_of_increment, rounding_of_all * gained) : 0.))
    return;
  if (first_slope == 0.)
    first_slope = gained / length;
  n_flat = gained < flat * first_slope * length && gained < no_gain * done ? n_flat + 1 : 0;
  n_soft = gained < soft * first_slope * length ? n_soft + 1 : 0;
  motion = moved;
  gain = gained;
  size = n_passed > 0 || n_steady > 0 ? length : growth * length;
  n_steady -= std::min(n_steady, 1u);
  if (gained > 0.)
    size = std::min(size, most * length / gained);
  size = std::min(size, large_step * extent);
}

bool LimitPath::is_flat() const { return n_flat >= several; }

std::string LimitPath::place_of_most_motion() const {
  if (motion.size() == 0 || motion.isZero(0.))
    return "no place, for nothing has moved";
  Vector dofs;
  model.space.expand(motion, dofs);
  std::pair<unsigned int, unsigned int> place; // cell and its end
  double largest = -1.;
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size(); ++i)
    for (unsigned int end = 0; end < 2; ++end) {
      const unsigned int vertex = model.discretization.pipe_cell(i)->vertex_index(end);
      double square = 0.;
      for (unsigned int d = 0; d < 3; ++d)
        square += std::pow(dofs[model.discretization.vertex_dofs().index(vertex, d)], 2);
      if (square > largest) {
        largest = square;
        place = {i, end};
      }
    }
  return place_in_words(model, place.first, place.second);
}

void LimitPath::transfer(Archive &archive) {
  archive(motion, gain, size, first, most, first_slope, n_flat, n_halved, n_passed, n_soft, n_cuts,
          n_steady, by_work);
}

} // namespace frictionbeam
