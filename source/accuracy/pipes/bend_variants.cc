// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/pipes/bend_variants.h"

#include "mesh/pipe_of_each_bend.h"
#include "results/text.h"

#include <cmath>
#include <limits>

namespace frictionbeam::accuracy {

namespace {

/// How far the rule of a bend may be off.
double error(const BendModel &bend, const Flexibility by) {
  return std::abs(std::log(bend.*by / bend.by_rule)) + bend.off;
}

/// That of the wall, or as much further from the rule as it may be off.
double furthest(const BendModel &bend, const Flexibility by) {
  return bend.*by < bend.by_rule ? bend.*by * std::exp(-bend.off) : bend.*by * std::exp(bend.off);
}

/// What a bend turns by more, wherever the scene has pressure in it: a pair of moments at its ends,
/// which as a free curvature would turn it by as much.
/// @param part of its turn @param pipe that it is of in the scene @param flexibility of it there
void add_turn_by_pressure(const BendModel &bend, const double part, const Pipe &pipe,
                          const double flexibility, Scene &scene) {
  const std::size_t n_loads = scene.loads.size();
  std::array<std::string, 2> points;
  for (std::size_t l = 0; l < n_loads; ++l) {
    if (scene.loads[l].kind != Load::Kind::pressure || !scene.loads[l].is_on(pipe.name))
      continue;
    for (unsigned int end = 0; end < 2 && points[end].empty(); ++end) {
      points[end] = "end of a bend " + std::to_string(scene.points.size());
      scene.add_point(points[end], bend.ends[end]);
    }
    Load load;
    load.kind = Load::Kind::force;
    load.name = "turn by pressure " + std::to_string(scene.loads.size());
    load.history = scene.loads[l].history;
    load.at.resize(2);
    for (unsigned int end = 0; end < 2; ++end) {
      load.at[end].point = points[end];
      for (unsigned int d = 0; d < 3; ++d)
        load.at[end].value[3 + d] = (end == 0 ? -1. : 1.) * part * scene.loads[l].value *
                                    bend.turn_by_pressure[d] / flexibility;
    }
    for (LoadStep &step : scene.steps)
      for (std::size_t i = 0, n = step.loads.size(); i < n; ++i)
        if (step.loads[i].first == l)
          step.loads.emplace_back(scene.loads.size(), step.loads[i].second);
    scene.loads.push_back(load);
  }
}

} // namespace

BendVariants::BendVariants(const Scene &whole, const Results &beams, const BendModels &models,
                           const SolveAs &solve)
    : scene(whole), beams(beams), solve(solve) {
  for (unsigned int p = 0; p < whole.pipes.size(); ++p)
    pieces.push_back({p});
  bool has_several = false;
  for (const BendModel &bend : models.judged)
    has_several = ++n_bends[bend.pipe] > 1 || has_several;
  if (has_several)
    cut_pipes(whole);
}

Difference BendVariants::change(const Bends &walls, const Flexibility by,
                                const std::string &what) const {
  return between(beams, solve(with(walls, by), what));
}

double BendVariants::change_per_part(const Bends &walls, const Off off) const {
  constexpr double part = 0.1;
  const std::string what = "solid bends as flexible as their walls";
  const Results now = solve(with(walls, &BendModel::in_plane), what),
                more = solve(with(walls, &BendModel::in_plane, 1. + part, off),
                             what + ", and " + rounded_number(100. * part, 2) + " % more");
  return between(more, now).value / part;
}

void BendVariants::cut_pipes(const Scene &whole) {
  constexpr double same = 1e-6;
  std::vector<unsigned int> owner;
  Scene cut = with_pipe_of_each_bend(whole, owner);
  if (!(between(solve(cut, "each bend a pipe of its own"), beams).value <= same))
    return;
  scene = std::move(cut);
  pieces.assign(whole.pipes.size(), {});
  for (unsigned int p = 0; p < owner.size(); ++p)
    pieces[owner[p]].push_back(p);
}

Scene BendVariants::with(const Bends &walls, const Flexibility by, const double times,
                         const Off off) const {
  std::map<unsigned int, const BendModel *> worst;
  for (const BendModel *const wall : walls) {
    const BendModel *&of_pipe = worst[pipe_of(*wall)];
    if (of_pipe == nullptr || error(*wall, by) > error(*of_pipe, by))
      of_pipe = wall;
  }
  Scene variant = scene;
  for (const auto &[pipe, wall] : worst)
    variant.pipes[pipe].bend_flexibility = {BendFlexibility::Rule::given,
                                            times * furthest(*wall, by)};
  for (const BendModel *const wall : walls) {
    const unsigned int pipe = pipe_of(*wall);
    const double more = off == Off::with_turn_by_pressure ? times - 1. : 0.;
    add_turn_by_pressure(*wall, wall->more_turn + more, scene.pipes[pipe],
                         variant.pipes[pipe].bend_flexibility.factor, variant);
  }
  return variant;
}

Difference BendVariants::between(const Results &coarse, const Results &fine) const {
  if (coarse.status != RunStatus::converged || fine.status != RunStatus::converged)
    return {std::numeric_limits<double>::infinity(), "equilibrium"};
  return largest(differences(scene, coarse, fine));
}

} // namespace frictionbeam::accuracy
