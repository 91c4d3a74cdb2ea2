// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/solid/mixed_walls.h"
#include "command/solid/wall_scene.h"

#include "base/processes.h"
#include "base/user_error.h"
#include "results/file/body_vtu.h"
#include "results/file/output_file.h"
#include "results/solid/solid_files.h"
#include "results/solid/wall_doubts.h"
#include "results/stress/inner_pressure.h"
#include "results/text.h"
#include "scene/in_units.h"
#include "scene/solid/mixed_entries.h"
#include "scene/steps/history_origins.h"
#include "scene/steps/step_factors.h"
#include "scene/steps/step_tree.h"

#include <algorithm>

namespace frictionbeam {

namespace {

const Station &station_at(const Frame &frame, const unsigned int pipe, const unsigned int vertex,
                          const bool is_last) {
  const auto is_it = [&](const Station &one) {
    return one.pipe == pipe && one.is_node() && one.vertex == vertex;
  };
  const auto first = std::find_if(frame.line.begin(), frame.line.end(), is_it);
  AssertThrow(first != frame.line.end(), dealii::ExcInternalError());
  return is_last ? *std::find_if(frame.line.rbegin(), frame.line.rend(), is_it) : *first;
}

/// How far the forces across the end sections of a wall, by its stresses, are from those of the
/// line: the largest difference of forces and of moments over a diameter, of the largest of these
/// or of rounding.
double disagreement(const WallStretch &wall, const SolidPart &part, const Frame &frame,
                    const std::vector<RingState> &rings, const std::vector<double> &factors) {
  const double thrust = wall.loads->pressure(factors) * wall.wall.bore_area(),
               diameter = 2. * wall.wall.outer;
  double largest = force_of_rounding(wall.body_scene, wall.wall) + std::abs(thrust),
         difference = 0.;
  for (const bool at_end : {false, true}) {
    const unsigned int section = at_end ? part.vertices.size() - 1 : 0,
                       ring = wall.ring_of(section);
    const Station &station = station_at(frame, part.pipe, part.vertices[section], !at_end);
    Motion cut = rings[ring].cut[at_end ? 0 : 1];
    for (unsigned int c = 0; c < 6; ++c)
      cut[c] -= rings[ring].moved_thrust[c];
    const Vector3 force({cut[0], cut[1], cut[2]}), moment({cut[3], cut[4], cut[5]}),
        x = wall.wall.rings[ring].tangent;
    const Motion local = {{force * x - thrust, force * station.y, force * station.z, moment * x,
                           moment * station.y, moment * station.z}};
    for (unsigned int c = 0; c < 6; ++c) {
      const double unit = c < 3 ? 1. : diameter;
      largest = std::max({largest, std::abs(local[c]) / unit, std::abs(station.force[c]) / unit});
      difference = std::max(difference, std::abs(local[c] - station.force[c]) / unit);
    }
  }
  return difference / largest;
}

/// Pressures in a pipe between which that of all steps is [Pa]: at the ends of the steps, and with
/// histories the largest and the least on the way.
std::vector<double> pressures_in(const Scene &scene, const unsigned int pipe) {
  std::vector<double> result;
  const auto acts_there = [&](const Load &load) {
    return load.kind == Load::Kind::pressure && load.is_on(scene.pipes[pipe].name);
  };
  bool has_history = false;
  for (const Load &load : scene.loads)
    has_history = has_history || (acts_there(load) && load.history.is_given());
  for (const LoadStep &step : scene.steps)
    result.push_back(pressure_in(scene, step.name, pipe));
  if (!has_history)
    return result;
  constexpr unsigned int n_instants = 200; // of a step, of histories that have no corners
  constexpr double margin = 1.05;
  double begin = 0., least = 0., largest = 0.;
  for (unsigned int s = 0; s < scene.steps.size(); ++s) {
    const HistoryOrigins origins(scene, s);
    const double duration = scene.steps[s].duration;
    std::vector<double> instants;
    for (unsigned int i = 0; i <= n_instants; ++i)
      instants.push_back(begin + duration * i / n_instants);
    for (unsigned int l = 0; l < scene.loads.size(); ++l)
      for (const double corner : scene.loads[l].history.breaks)
        instants.push_back(std::clamp(origins.loads[l] + corner, begin, begin + duration));
    for (const unsigned int of : {s, step_before(scene, s).value_or(s)}) {
      const std::vector<double> factors = declared_factors(scene, scene.steps[of]);
      for (const double time : instants) {
        double before = 0., after = 0.;
        for (unsigned int l = 0; l < scene.loads.size(); ++l)
          if (const Load &load = scene.loads[l]; acts_there(load)) {
            const double value = factors[l] * load.value, t = time - origins.loads[l];
            before += value * (load.history.is_given() ? load.history.before(t) : 1.);
            after += value * (load.history.is_given() ? load.history.after(t) : 1.);
          }
        least = std::min({least, before, after});
        largest = std::max({largest, before, after});
      }
    }
    begin += duration;
  }
  result.insert(result.end(), {margin * least, margin * largest});
  return result;
}

/// Quantities that are stresses of a beam's wall where the wall is a solid.
std::vector<std::string> nominal_stresses(const Scene &scene, const Results &results,
                                          const std::vector<SolidPart> &parts) {
  const auto is_in_a_part = [&](const std::string &where) {
    return std::any_of(results.points.begin(), results.points.end(), [&](const PointInfo &point) {
      return point.name == where &&
             std::any_of(parts.begin(), parts.end(), [&](const SolidPart &part) {
               return std::count(part.vertices.begin(), part.vertices.end(), point.vertex) > 0;
             });
    });
  };
  std::vector<std::string> names;
  for (const Quantity &quantity : scene.quantities)
    if (quantity.is(QuantityKind::Of::fibre) && quantity.kind().unit == std::string("Pa") &&
        (quantity.where.empty() || is_in_a_part(quantity.where)))
      names.push_back(quantity.name);
  return names;
}

} // namespace

MixedWalls::MixedWalls(const Scene &scene, const LineMesh &mesh) : scene(scene) {
  if (solid_places(scene).empty())
    return;
  if (n_processes() > 1)
    throw UserError("Walls of pipes are solved by one process.\n  read:    Solid/At under "
                    "mpirun\n  allowed: one process\n  try:     without mpirun");
  std::vector<PipePath> paths;
  for (const Pipe &pipe : scene.pipes)
    paths.emplace_back(pipe, scene.units);
  for (const SolidStretch &stretch : solid_stretches(scene, paths))
    walls.push_back(std::make_unique<WallStretch>(scene, mesh, stretch));
}

std::vector<SolidPart> MixedWalls::superelements() {
  std::vector<SolidPart> result;
  for (const auto &wall : walls)
    result.push_back(wall->superelement(pressures_in(scene, wall->stretch.pipe)));
  parts = result;
  return result;
}

std::vector<std::string> MixedWalls::in_words() const {
  std::vector<std::string> result;
  for (const auto &wall : walls) {
    const SolidStretch &stretch = wall->stretch;
    std::string text = "Solid: " + stretch.name + " on pipe " + scene.pipes[stretch.pipe].name +
                       " from " + in_units(scene.units, stretch.from, "m") + " to " +
                       in_units(scene.units, stretch.to, "m") + ", " +
                       std::to_string(wall->wall.n_layers()) + " layers of " +
                       std::to_string(wall->wall.around * wall->wall.through) +
                       " cells of degree " + std::to_string(scene.solid.degree) + ", " +
                       std::to_string(wall->body.dof_handler.n_dofs()) + " unknowns";
    if (!wall->wall.patches.empty())
      text += ", pressed on " + std::to_string(wall->wall.patches.size()) +
              (wall->wall.patches.size() == 1 ? " patch by a rest" : " patches by rests");
    if (!wall->own.near_rests.empty())
      text += "; the oval that " + join(wall->own.near_rests) +
              " beside it would press into the wall is left out, Solid/Reach = " +
              rounded_number(std::ceil(wall->own.wanted_reach * 10.) / 10., 3) + " takes it in";
    if (stretch.is_short)
      text +=
          "; a bend, an anchor or the pipe's end leaves less straight pipe beside it than asked";
    if (stretch.anchored[0] && stretch.anchored[1])
      text += "; of its two anchors the second one holds the section as Solid/Anchors says, the "
              "first one its mean";
    result.push_back(text + ".");
  }
  const bool none_is_anchored = std::none_of(walls.begin(), walls.end(), [](const auto &wall) {
    return wall->stretch.anchored[0] || wall->stretch.anchored[1];
  });
  if (!walls.empty() && none_is_anchored &&
      scene.solid.anchors == SolidSettings::Anchors::breathing)
    result.push_back("Solid: its Anchors is not used where no solid ends at an anchor.");
  return result;
}

void MixedWalls::add_to(KnownError &cells) const {
  for (const auto &wall : walls) {
    const KnownError error = error_of_cells(wall->own.scene, "the wall of " + wall->stretch.name);
    if (!error.error || (cells.error && *error.error > *cells.error)) {
      cells = error;
      cells.is_of_walls = true;
    }
  }
}

void MixedWalls::report(const LoadSequence &sequence, Results &results) {
  add_to(results.known.cells);
  double ovality = 0., mises = 0., join = 0.;
  bool is_cut_near_rests = false;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const WallStretch &wall = *walls[w];
    const SolidPart &part = parts[w];
    std::vector<WallFrame> frames;
    std::vector<ContinuumState> states;
    for (const Frame &frame : results.frames) {
      if (!frame.end_of_step || frame.step >= results.steps.size() ||
          !results.steps[frame.step].converged)
        continue;
      Eigen::VectorXd motions(6 * part.vertices.size());
      for (std::size_t i = 0; i < part.vertices.size(); ++i) {
        const Station &station = station_at(frame, part.pipe, part.vertices[i], false);
        for (unsigned int c = 0; c < 6; ++c)
          motions[6 * i + c] = station.displacement[c];
      }
      ContinuumState state;
      state.step = frame.step;
      state.increment = frame.increment;
      state.time = frame.time;
      state.factors = sequence.factors_at_end(frame.step);
      state.displacement = wall.displacement(motions, state.factors);
      frames.push_back({frame.step, wall_state(wall.wall, *wall.loads, wall.body, state,
                                               wall.pressure_stiffness())});
      join = std::max(join, disagreement(wall, part, frame, frames.back().rings, state.factors));
      states.push_back(std::move(state));
    }
    if (frames.empty()) // the first step was not solved
      return;
    for (const std::string &text : {doubt_of_stresses(wall.own.scene, wall.wall, frames),
                                    doubt_of_bore(wall.own.scene, wall.wall, frames)})
      if (!text.empty())
        results.doubts.push_back(text);
    for (const WallFrame &frame : frames)
      for (unsigned int i = 0; i < frame.rings.size(); ++i) {
        const RingState &ring = frame.rings[i];
        if (wall.is_disturbed(i)) {
          is_cut_near_rests = true;
          continue;
        }
        ovality = std::max(ovality, ring.ovality(2. * wall.wall.outer));
        mises = std::max({mises, ring.largest_mises(0), ring.largest_mises(1)});
      }
    if (scene.output.directory.empty())
      continue;
    const std::string folder = scene.output.directory + "/solid_" + wall.stretch.name;
    prepare_output_folder(folder);
    write_wall_csv(wall.own.scene, wall.wall, frames, folder);
    if (scene.output.vtu)
      write_body_vtu<3>(
          wall.body, states, "solid",
          [&](const ContinuumState &state) {
            return stress_of_wall(*wall.loads, wall.body, state.factors);
          },
          folder);
    if (!scene.output.report)
      continue;
    RingNames names;
    for (const PointInfo &point : results.points)
      if (const auto at = std::find(part.vertices.begin(), part.vertices.end(), point.vertex);
          at != part.vertices.end())
        names[wall.ring_of(at - part.vertices.begin())].push_back(point.name);
    const std::string id = "wall" + std::to_string(w + 1);
    results.sections.push_back({id, "Wall of " + wall.stretch.name,
                                wall_report(wall.own.scene, wall.wall, frames, names, id, folder)});
  }
  if (walls.empty())
    return;
  std::string names;
  for (const auto &wall : walls)
    names += (names.empty() ? "" : ", ") + wall->stretch.name;
  results.remarks.push_back(
      "largest_ovality and largest_wall_stress are those of the solid parts, " + names +
      ": bends and pipes that are beams have no part in them (Model = solid has those of the whole "
      "wall)" +
      std::string(is_cut_near_rests ? ", nor has the wall about rests that stand near where a part "
                                      "is cut, whose free end gives way too far (a larger "
                                      "Solid/Reach takes them in)."
                                    : "."));
  if (const auto nominal = nominal_stresses(scene, results, parts); !nominal.empty())
    results.remarks.push_back(
        frictionbeam::join(nominal) + (nominal.size() == 1 ? " is" : " are") +
        " by the section forces of a beam, without what ovalizes and bends the solid wall there: "
        "largest_wall_stress and wall.csv have its stress.");
  const double Pa = scene.units.factor("Pa");
  results.quantities.push_back({"largest_ovality", "-", "", ovality, {}, {}});
  results.quantities.push_back(
      {"largest_wall_stress", scene.units.name("Pa"), "", mises / Pa, {}, {}});
  results.quantities.back().in_si = Pa;
  results.certificate.push_back({"solid_join", "-",
                                 "forces across the ends of solid parts, by their stresses and by "
                                 "the line, of the largest of them",
                                 join});
}

} // namespace frictionbeam
