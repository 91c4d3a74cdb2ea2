// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/inelastic/section_watch.h"

#include "base/number_text.h"
#include "base/user_error.h"
#include "model/cell/line_cells.h"
#include "results/inelastic/section_states.h"

#include <algorithm>
#include <numeric>

namespace frictionbeam {

namespace {
constexpr std::size_t most_states = 200000; // 42 MB
/// Two places are different ones if between them less than this part has flowed.
constexpr double valley = 0.9;
constexpr unsigned int everywhere = dealii::numbers::invalid_unsigned_int;
} // namespace

SectionWatch::SectionWatch(const Model &model) : model(model) {
  const PipeSections &sections = model.cells.pipe_sections();
  for (unsigned int i = 0; i < model.discretization.pipe_cells().size() && sections.any(); ++i) {
    if (!sections.has(i))
      continue;
    if (model.scene.output.sections.empty())
      follow(i, everywhere);
    for (const std::string &point : model.scene.output.sections)
      follow(i, model.mesh.points.at(point));
  }
  for (const std::string &point : model.scene.output.sections)
    if (std::none_of(followed.begin(), followed.end(), [&](const Followed &one) {
          return one.vertex == model.mesh.points.at(point);
        }))
      throw UserError("Output/Sections: at the point '" + point +
                      "' no pipe has a section that yields or creeps.\n  read:    " + point +
                      "\n  allowed: points of pipes whose Section has a Law beyond yield\n  try:   "
                      "  'Sections =' empty, for the two that flow most");
}

void SectionWatch::follow(const unsigned int index, const unsigned int vertex) {
  const PipeCell &cell = model.discretization.pipe_cells()[index];
  const MeshedPipe &pipe = model.mesh.pipes[cell.pipe];
  const unsigned int last = model.scene.mesh.section_points - 1;
  for (unsigned int place = 0; place <= last; ++place) {
    const unsigned int own = place == 0      ? pipe.vertices[cell.position]
                             : place == last ? pipe.vertices[cell.position + 1]
                                             : Station::between_nodes;
    if (vertex == everywhere || (vertex == own && own != Station::between_nodes))
      followed.push_back({index, place, own});
  }
}

void SectionWatch::observe(const LineState &state) {
  if (followed.empty())
    return;
  if (n_seen++ % every == 0)
    keep(state);
  if (states.size() > most_states && time.size() > 2)
    forget_every_second();
}

void SectionWatch::keep(const LineState &state) {
  time.push_back(state.time);
  std::vector<SectionState> of_cell;
  for (unsigned int i = 0; i < followed.size(); ++i) {
    if (i == 0 || followed[i].cell != followed[i - 1].cell)
      of_cell = sections_of_cell(model, followed[i].cell, state);
    states.push_back(of_cell[followed[i].place]);
  }
}

void SectionWatch::forget_every_second() {
  std::size_t n = 0;
  for (std::size_t instant = 0; instant < time.size(); instant += 2, ++n) {
    time[n] = time[instant];
    std::copy_n(states.begin() + instant * followed.size(), followed.size(),
                states.begin() + n * followed.size());
  }
  time.resize(n);
  states.resize(n * followed.size());
  every *= 2;
}

std::vector<SectionHistory> SectionWatch::histories(const LineState &last) {
  std::vector<SectionHistory> result;
  if (n_seen == 0)
    return result;
  if ((n_seen - 1) % every != 0)
    keep(last);
  most.assign(followed.size(), 0.);
  for (std::size_t k = 0; k < states.size(); ++k)
    most[k % followed.size()] = std::max(most[k % followed.size()], states[k].inelastic_strain());
  for (const std::string &point : model.scene.output.sections)
    result.push_back(history_of(most_flowed_at(model.mesh.points.at(point)), point));
  if (model.scene.output.sections.empty())
    for (const unsigned int section : most_flowed())
      result.push_back(history_of(section, name_of(section)));
  return result;
}

unsigned int SectionWatch::most_flowed_at(const unsigned int vertex) const {
  unsigned int found = followed.size();
  for (unsigned int i = 0; i < followed.size(); ++i)
    if (followed[i].vertex == vertex && (found == followed.size() || flowed(i) > flowed(found)))
      found = i;
  return found;
}

std::vector<unsigned int> SectionWatch::most_flowed() const {
  std::vector<unsigned int> all(followed.size());
  std::iota(all.begin(), all.end(), 0u);
  const auto pipe_of = [&](const unsigned int i) {
    return model.discretization.pipe_cells()[followed[i].cell].pipe;
  };
  const auto less = [&](const unsigned int a, const unsigned int b) {
    return flowed(a) < flowed(b);
  };
  const unsigned int first = *std::max_element(all.begin(), all.end(), less);
  if (flowed(first) == 0.)
    return {};
  const auto is_elsewhere = [&](const unsigned int i) {
    if (pipe_of(i) != pipe_of(first)) // a hinge may reach from one pipe into the next
      return followed[i].vertex == Station::between_nodes ||
             followed[i].vertex != followed[first].vertex;
    const auto [begin, end] = std::minmax(i, first);
    const unsigned int least = *std::min_element(all.begin() + begin, all.begin() + end, less);
    return flowed(least) < valley * flowed(i);
  };
  std::optional<unsigned int> second;
  for (const unsigned int i : all)
    if (flowed(i) > 0. && is_elsewhere(i) && (!second || less(*second, i)))
      second = i;
  return second ? std::vector<unsigned int>{first, *second} : std::vector<unsigned int>{first};
}

std::string SectionWatch::name_of(const unsigned int section) const {
  for (const auto &[point, vertex] : model.mesh.points)
    if (vertex == followed[section].vertex)
      return point;
  const UnitSystem &units = model.scene.units;
  const SectionState &state = states[section];
  return model.scene.pipes[state.pipe].name +
         ", s = " + rounded_number(state.s / units.factor("m"), 4) + " " + units.name("m");
}

SectionHistory SectionWatch::history_of(const unsigned int section, const std::string &name) const {
  SectionHistory history{name, every, time, {}};
  for (std::size_t instant = 0; instant < time.size(); ++instant)
    history.states.push_back(states[instant * followed.size() + section]);
  return history;
}

} // namespace frictionbeam
