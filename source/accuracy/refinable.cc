// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy/refinable.h"
#include "accuracy/resolution.h"

#include "mesh/build_line_mesh.h"
#include "results/text.h"
#include "scene/generated/scene_kinds.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace frictionbeam::accuracy {

namespace {

std::string whole(const unsigned int number) { return std::to_string(number); }

Refinable entry(const std::string &name, const std::string &path, const unsigned int coarsest) {
  return {name,
          [=](const unsigned int level) {
            return std::vector<std::string>{path + " = " + whole(coarsest << level)};
          },
          false};
}

double number(const ParameterFile &file, const std::string &heading, const std::string &name,
              const double default_value) {
  const ParameterFile::Section *const section = file.find(heading);
  const ParameterFile::Entry *const entry = section == nullptr ? nullptr : section->find(name);
  double value = default_value;
  if (entry != nullptr)
    to_number(entry->value, value); // which read_scene() has checked
  return value;
}

/// The slab on @p n elements and on the same interface: the stiffness of a friction element is
/// that of its share of the surface.
std::vector<std::string> slab_elements(const ParameterFile &file, const unsigned int n) {
  std::vector<std::string> settings = {"Slab/Elements = " + whole(n)};
  const double rigidity = number(file, "Slab", "GS", 1e6),
               given = number(file, "Slab", "Elements", 16.);
  if (rigidity > 0.)
    settings.push_back("Slab/GS = " + exact_number(rigidity * given / n));
  return settings;
}

/// Of a route, or of a mesh file.
bool has_bend(const Scene &scene) {
  return scene.has_bend() || std::any_of(scene.pipes.begin(), scene.pipes.end(),
                                         [](const Pipe &pipe) { return pipe.bend_radius > 0.; });
}

/// Whether a pipe has mass along it, which cells have at their ends.
bool has_mass(const Scene &scene) {
  return std::any_of(scene.pipes.begin(), scene.pipes.end(), [&](const Pipe &pipe) {
    return scene.materials[pipe.material].density > 0. ||
           scene.sections[pipe.section].added_mass > 0. || pipe.total_mass.value_or(0.) > 0.;
  });
}

/// Longest cell of a mesh file [m], whose cells are of any lengths.
double longest_cell(const Scene &scene) {
  double longest = 0.;
  for (const MeshedPipe &pipe : build_line_mesh(scene).pipes)
    for (std::size_t i = 1; i < pipe.s.size(); ++i)
      longest = std::max(longest, pipe.s[i] - pipe.s[i - 1]);
  return longest;
}

/// Shortest straight run of a route, from which cells of all runs are refined [m].
double shortest_run(const Scene &scene) {
  if (!scene.mesh.file.empty())
    return longest_cell(scene);
  double shortest = 0.;
  for (const Pipe &pipe : scene.pipes)
    for (std::size_t i = 1; i < pipe.route.size(); ++i) {
      const double length = pipe.route[i].position.distance(pipe.route[i - 1].position);
      shortest = shortest == 0. ? length : std::min(shortest, length);
    }
  return shortest > 0. ? shortest : 1.;
}

bool has_creep(const Scene &scene, const ParameterFile &file) {
  return std::any_of(scene.sections.begin(), scene.sections.end(), [&](const Section &section) {
    const std::string heading = "Section " + section.name;
    return number(file, heading, "Creep coefficient", 0.) > 0. ||
           number(file, heading, "Primary creep coefficient", 0.) > 0.;
  });
}

/// One to begin with, eight where a load has a history of its own within the step. What creep lets
/// an increment leave falls as that does, with its third power: it may be what cuts increments.
Refinable increments_of(const Scene &scene, const SceneKind &kind, const bool creeps) {
  constexpr double least = 1e-7, falls = 8.;
  constexpr unsigned int level_of_proof = 6;
  const double tolerance = scene.solver.creep_tolerance;
  std::vector<std::pair<std::string, unsigned int>> paths;
  if (kind.is_generated())
    paths.emplace_back(std::string(kind.value) + "/" + kind.increments, 1);
  else
    for (const LoadStep &step : scene.steps)
      if (!step.transient && step.cycle.number <= 1) { // later cycles are as the first
        const bool has_history =
            std::any_of(step.loads.begin(), step.loads.end(), [&](const auto &load) {
              return scene.loads[load.first].history.is_given();
            });
        paths.emplace_back("Step " + step.name + "/Increments", has_history ? 8 : 1);
      }
  return {"increments of static steps",
          [=](const unsigned int level) {
            std::vector<std::string> settings;
            for (const auto &[path, coarsest] : paths)
              settings.push_back(path + " = " + whole(coarsest << level));
            if (creeps && level > 0)
              settings.push_back(
                  "Solver/Creep tolerance = " +
                  exact_number(
                      std::min(tolerance, std::max(least, tolerance / std::pow(falls, level)))));
            return settings;
          },
          true,
          false,
          Convergence::Order::first_at_best,
          &hidden_in_one_increment,
          level_of_proof};
}

/// An exact integrator takes steps only where slip follows a curve or events accumulate; of
/// these, and of the instants at which it is looked at, one or few are mostly enough.
std::optional<Refinable> time_step_of(const Scene &scene) {
  const double longest = longest_time_step(scene);
  const bool is_exact = scene.time.is_exact(),
             thin = scene.time.output_interval == 0.; // steps get too short to write them all
  return Refinable{"time step",
                   [=](const unsigned int level) {
                     std::vector<std::string> settings = {"Time/Step = " +
                                                          exact_number(longest / (1u << level))};
                     if (thin)
                       settings.push_back("Time/Output interval = " + exact_number(longest / 4.));
                     return settings;
                   },
                   is_exact, !is_exact,
                   scene.supports.empty() ? Convergence::Order::unknown
                                          : Convergence::Order::first_at_best};
}

/// Each cell is halved from level to level, be it of a long run or between two supports.
Refinable cells_of(const double run, const bool bends) {
  return {"length of cells",
          [=](const unsigned int level) {
            std::vector<std::string> settings = {"Mesh/Cell length = " + exact_number(run),
                                                 "Mesh/Refinements = " + whole(level)};
            if (bends)
              settings.push_back("Mesh/Cells per bend = 2");
            return settings;
          },
          false,
          false,
          Convergence::Order::regular,
          &unseen_between_sections};
}

} // namespace

std::vector<Refinable> refinables(const Scene &scene, const ParameterFile &file) {
  std::vector<Refinable> list;
  const ParameterFile::Entry *const entry_scene = file.sections().front().find("Scene");
  const SceneKind &kind =
      entry_scene == nullptr ? scene_kinds().front() : scene_kind(entry_scene->value);
  const bool has_transient = std::any_of(scene.steps.begin(), scene.steps.end(),
                                         [](const LoadStep &step) { return step.transient; }),
             has_static = std::any_of(scene.steps.begin(), scene.steps.end(),
                                      [](const LoadStep &step) { return !step.transient; }),
             has_bed =
                 std::any_of(scene.supports.begin(), scene.supports.end(),
                             [](const FrictionSupport &one) { return one.placement.continuous; });
  const bool has_increments = !kind.is_generated() || *kind.increments != '\0';
  const bool has_way = !scene.supports.empty() || scene.yields();
  if (has_static && has_way && has_increments)
    list.push_back(increments_of(scene, kind, has_creep(scene, file)));
  if (has_transient)
    if (const auto step = time_step_of(scene))
      list.push_back(*step);
  const bool is_large = scene.kinematics == Kinematics::corotational;
  const bool moves_cells = (has_transient || scene.modal.n_modes > 0) && has_mass(scene);
  if ((has_bed || moves_cells || is_large || scene.yields()) && !scene.pipes.empty())
    list.push_back(cells_of(shortest_run(scene), is_large && has_bend(scene)));
  else if (std::any_of(scene.pipes.begin(), scene.pipes.end(),
                       [](const Pipe &pipe) { return pipe.end_section; }))
    list.push_back(entry("cells of reducers", "Mesh/Cells per reducer", 10));
  if (kind.has_elements)
    list.push_back({"elements of the slab",
                    [file](const unsigned int level) { return slab_elements(file, 8u << level); },
                    false});
  for (const SceneKind::Fineness &one : kind.others)
    list.push_back(entry(one.what, std::string(kind.value) + "/" + one.entry, one.coarsest));
  return list;
}

LineForms line_forms(const Scene &scene, const ParameterFile &file) {
  const std::array<double, 3> &size = scene.continuum->box->size;
  unsigned int n = 32;
  while (n < 2. * size[0] / size[1] && n < 4096)
    n *= 2;
  LineForms forms;
  forms.best = forms.without_last_correction = slab_elements(file, n);
  for (auto *const form : {&forms.best, &forms.without_last_correction})
    form->push_back("Slab/Poisson squeeze = true");
  forms.best.push_back("Slab/Shear lag = 3");
  forms.without_last_correction.push_back("Slab/Shear lag = 0");
  return forms;
}

std::vector<std::string> continuum_settings(const Scene &scene, const double demanded) {
  std::vector<std::string> settings = {"Continuum/Refinement = adaptive",
                                       "Continuum/Fraction = 0.7",
                                       "Continuum/Tolerance = " + exact_number(demanded),
                                       "Continuum/Degree = " + whole(demanded < 1e-3 ? 3 : 2)};
  if (const auto &box = scene.continuum->box)
    settings.push_back("Continuum/Cells = " + whole(box->size[0] >= 4. * box->size[1] ? 2 : 4));
  return settings;
}

std::vector<std::string> exact_settings(const Scene &scene) {
  if (scene.model != ModelKind::solid && scene.kinematics == Kinematics::linear && has_bend(scene))
    return {"Mesh/Bends = arcs"};
  return {};
}

} // namespace frictionbeam::accuracy
