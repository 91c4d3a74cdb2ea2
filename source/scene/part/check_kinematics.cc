// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"
#include "scene/steps/history_origins.h"
#include "scene/steps/step_factors.h"
#include "scene/steps/step_tree.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::parts {

namespace {
/// Model = auto of pipes solves them as beams where it is asked for what solids do not know.
bool is_of_beams(const Scene &scene) {
  return scene.model == ModelKind::line ||
         (scene.model == ModelKind::automatic && !scene.continuum);
}
std::string in_words(const ModelKind model) {
  return "Model = " + std::string(row_of(model_kinds, model).word);
}
} // namespace

void check_kinematics(const ParameterReader &in, const Scene &scene) {
  if (scene.kinematics == Kinematics::linear)
    return;
  const auto refuse = [&](const bool is_there, const std::string &what, const std::string &hint) {
    if (is_there)
      in.fail("Kinematics", "linear with " + what, hint, "corotational with " + what);
  };
  const auto any = [](const auto &parts, const auto &is) {
    return std::any_of(parts.begin(), parts.end(), is);
  };
  refuse(!is_of_beams(scene), in_words(scene.model), "Model = line");
  refuse(!scene.solver.has_tangent(), "Method = elastic",
         "Method = exact or newton in section Solver");
  refuse(scene.output.contact_problems, "Write contact problems", "false in section Output");
  refuse(scene.modal.n_modes > 0, "modes and spectra", "a case of its own for them");
  const bool transient = any(scene.steps, [](const LoadStep &step) { return step.transient; });
  if (transient) {
    const TimeSettings &time = scene.time;
    refuse(
        !time.row().is_for_turning, "Integrator = event",
        "Integrator = moreau_jean, newmark, generalized_alpha or nonsmooth_alpha in section Time");
    if (time.integrator != Integrator::moreau_jean) {
      const std::string with = " and Integrator = " + std::string(time.row().word);
      refuse(time.stiffness_damping != 0., "Stiffness damping" + with,
             "Integrator = moreau_jean in section Time");
      refuse(time.modal_damping != 0., "Modal damping" + with,
             "Integrator = moreau_jean in section Time");
      refuse(any(scene.springs,
                 [](const Spring &spring) {
                   return std::any_of(spring.damping.begin(), spring.damping.end(),
                                      [](const double damping) { return damping != 0.; });
                 }),
             "Damping of a spring" + with, "Integrator = moreau_jean in section Time");
    }
    refuse(time.reduction.modes != ReductionSettings::Modes::all, "Modes",
           "Modes = all in section Time");
    refuse(time.theta != 0.5, "Theta above 0.5", "Theta = 0.5 in section Time");
    refuse(any(scene.loads,
               [](const Load &load) {
                 return load.kind == Load::Kind::displacement &&
                        std::any_of(load.at.begin(), load.at.end(), [](const Load::AtPoint &at) {
                          return at.given[3] || at.given[4] || at.given[5];
                        });
               }),
           "imposed rotations in a scene with transient steps", "a spring that turns the point");
  }
  refuse(any(scene.supports,
             [](const FrictionSupport &support) {
               return support.rotations != FrictionSupport::Rotations::none || support.torsion;
             }),
         "Rotations or Torsion of a support", "removing them there");
  const int n_rotations = scene.free_motions[3] + scene.free_motions[4] + scene.free_motions[5];
  refuse(n_rotations > 1 && any(scene.springs,
                                [](const Spring &spring) {
                                  return spring.turns(0, false) || spring.turns(1, false) ||
                                         spring.turns(2, false);
                                }),
         "springs that turn, in space", "Free motions = uy, uz, rx or another plane");
  refuse(any(scene.initial,
             [](const InitialCondition &initial) { return initial.displacement != Motion{}; }),
         "an initial displacement", "a static step before");
}

namespace {

bool yields(const Scene &scene, const Pipe &pipe) {
  return scene.sections[pipe.section].is_inelastic() && !pipe.rigid;
}

/// What is asked of pipes that yield, where there are none.
void check_elastic(ParameterReader &in, const Scene &scene) {
  in.enter("Output");
  if (!scene.output.sections.empty())
    in.fail("Sections", "points of pipes whose section yields or creeps",
            "'Law = fibre_pipe' in its Section");
  in.enter("Mesh");
  if (scene.mesh.refine_hinges)
    in.fail("Refine hinges", "pipes whose section yields", "'Law = fibre_pipe' in its Section");
}

/// Whether loads of a step change in it, or may.
bool changes_loads(const Scene &scene, const unsigned int step) {
  for (const auto &[load, factor] : scene.steps[step].loads)
    if (scene.loads[load].history.is_given())
      return true;
  const auto before = step_before(scene, step);
  return (before && scene.steps[*before].finds_limit) || // where it ended nobody knows
         declared_factors(scene, scene.steps[step]) !=
             (before ? declared_factors(scene, scene.steps[*before])
                     : std::vector<double>(scene.loads.size(), 0.));
}

/// A limit is a part of loads that grow evenly, on lines that may have one.
void check_limits(ParameterReader &in, const Scene &scene) {
  const bool may_yield = std::any_of(scene.pipes.begin(), scene.pipes.end(),
                                     [&](const Pipe &pipe) { return yields(scene, pipe); });
  for (unsigned int s = 0; s < scene.steps.size(); ++s) {
    const LoadStep &step = scene.steps[s];
    if (!step.finds_limit)
      continue;
    in.enter("Step " + step.name);
    if (!changes_loads(scene, s))
      in.fail("Find", "limit of loads that are other than those of the step before",
              "a larger factor, such as 'Loads = weight, push 2'", "the same loads as before");
    if (!may_yield && scene.kinematics != Kinematics::corotational)
      in.fail("Find",
              "limit with pipes whose section yields, or in large displacements, where elastic "
              "lines snap and buckle",
              "'Law = fibre_pipe' in its Section, or 'Kinematics = corotational'");
    for (const auto &[load, factor] : step.loads)
      if (!may_yield && scene.loads[load].history.is_given())
        in.fail("Find", "limit of elastic pipes with loads that grow evenly",
                "'" + scene.loads[load].name + "' without its History, or Find = nothing");
  }
}

/// A reducer has one law, and a rigid pipe none.
void check_laws_of_pipes(ParameterReader &in, Scene &scene) {
  for (const Pipe &pipe : scene.pipes) {
    const Section &section = scene.sections[pipe.section];
    if (pipe.rigid && section.is_inelastic())
      scene.remarks.push_back("Pipe " + pipe.name + ": it is Rigid, and the Law of its section " +
                              section.name + " is not asked.");
    if (pipe.rigid || !pipe.end_section)
      continue;
    const Section &end = scene.sections[*pipe.end_section];
    if (section.law == end.law && section.law_parameters == end.law_parameters)
      continue;
    in.enter("Pipe " + pipe.name);
    in.fail("End section", "a section with the Law of the first, and the same of its parameters",
            "the same entries in both, or several short pipes");
  }
}

/// Creep takes the Duration of static steps for its time, whose default means nothing.
void check_time_of_creep(ParameterReader &in, Scene &scene) {
  const auto creeping = std::find_if(scene.pipes.begin(), scene.pipes.end(), [&](const Pipe &pipe) {
    in.enter("Section " + scene.sections[pipe.section].name);
    return yields(scene, pipe) && has_creep(in);
  });
  if (creeping == scene.pipes.end() || scene.steps.empty())
    return;
  std::string without;
  bool any = false;
  for (const LoadStep &step : scene.steps) {
    in.enter("Step " + step.name);
    const bool is_told = step.transient || step.cycle.number > 1 || in.given("Duration");
    any = any || is_told;
    if (!is_told)
      without += (without.empty() ? "" : ", ") + step.name;
  }
  if (!any) {
    in.enter("Step " + scene.steps.front().name);
    in.fail("Duration", "the time that the steps take, where sections creep",
            "'set Duration = 3.6e6' (1000 hours)", "none in any step");
  }
  if (!without.empty())
    scene.remarks.push_back("Section " + scene.sections[creeping->section].name +
                            " creeps for 1 s in each of the steps without a Duration: " + without +
                            ".");
}

} // namespace

void check_inelastic(ParameterReader &in, Scene &scene) {
  in.enter("Output");
  for (const std::string &point : scene.output.sections)
    check_point(in, "Sections", point, scene);
  check_laws_of_pipes(in, scene);
  check_limits(in, scene);
  const auto found = std::find_if(scene.pipes.begin(), scene.pipes.end(),
                                  [&](const Pipe &pipe) { return yields(scene, pipe); });
  if (found == scene.pipes.end())
    return check_elastic(in, scene);
  check_time_of_creep(in, scene);
  const Section &section = scene.sections[found->section];
  in.enter("Section " + section.name);
  const auto refuse = [&](const bool is_there, const std::string &what, const std::string &hint) {
    if (is_there)
      in.fail("Law", "elastic_section with " + what, hint, section.law + " with " + what);
  };
  refuse(!is_of_beams(scene), in_words(scene.model), "Model = line");
  refuse(!scene.solver.has_tangent(), "Method = elastic",
         "Method = exact or newton in section Solver");
  refuse(scene.output.contact_problems, "Write contact problems", "false in section Output");
  for (const LoadStep &step : scene.steps)
    if (step.transient) {
      refuse(scene.time.is_exact(), "Integrator = event",
             "Integrator = moreau_jean, newmark or generalized_alpha in section Time");
      refuse(scene.time.reduction.modes != ReductionSettings::Modes::all, "Modes",
             "Modes = all in section Time");
      refuse(scene.time.theta != 0.5, "Theta above 0.5", "Theta = 0.5 in section Time");
      refuse(scene.time.modal_damping != 0. && scene.kinematics == Kinematics::linear,
             "Modal damping", "Stiffness damping in section Time");
    }
  refuse(
      std::any_of(scene.initial.begin(), scene.initial.end(),
                  [](const InitialCondition &initial) { return initial.displacement != Motion{}; }),
      "an initial displacement", "a static step before");
  if (scene.modal.n_modes > 0)
    scene.remarks.push_back("Section " + section.name +
                            ": modes and spectra take its elastic "
                            "stiffness, whatever it yields or creeps.");
  if (!scene.stress.code.empty())
    scene.remarks.push_back("Section " + section.name +
                            ": the stress code takes the forces of a line that yields or creeps "
                            "for those of an elastic one, and its ranges of stress are then too "
                            "small. Evaluate it with Law = elastic_section.");
}

namespace {

/// Forces, and moments at points, that a load has in all.
Motion sizes_of(const Load &load) {
  Motion sizes{};
  if (load.kind == Load::Kind::force)
    for (const Load::AtPoint &one : load.at)
      for (unsigned int c = 0; c < 6; ++c)
        sizes[c] += std::abs(one.value[c]);
  else
    for (unsigned int d = 0; d < 3; ++d)
      sizes[d] = std::abs(load.vector[d]);
  return sizes;
}

void remark_on_held_loads(Scene &scene) {
  constexpr double hardly_any = 1e-6; // of the load
  for (const Load &load : scene.loads) {
    const Motion sizes = sizes_of(load);
    for (unsigned int c = 0; c < 6; ++c) {
      const double *const first = sizes.data() + c / 3 * 3; // forces are not moments
      if (scene.free_motions[c] || sizes[c] <= hardly_any * *std::max_element(first, first + 3))
        continue;
      scene.remarks.push_back("Load " + load.name + ": what it has " +
                              (c < 3 ? "along " : "about ") + "xyz"[c % 3] +
                              " does nothing, and no reaction shows it: Free motions holds all "
                              "nodes so.");
      break;
    }
  }
}

void remark_on_wind(Scene &scene) {
  for (unsigned int l = 0; l < scene.loads.size(); ++l)
    if (scene.kinematics == Kinematics::corotational && scene.loads[l].kind == Load::Kind::wind &&
        std::any_of(scene.steps.begin(), scene.steps.end(),
                    [l](const LoadStep &step) { return acts(step, l); }))
      scene.remarks.push_back("Load " + scene.loads[l].name +
                              ": wind stays that of the pipe as it is built, wherever it turns.");
}

} // namespace

void remark_on_free_motions(Scene &scene) {
  remark_on_held_loads(scene);
  remark_on_wind(scene);
  const auto &free = scene.free_motions;
  for (const Pipe &pipe : scene.pipes)
    for (std::size_t i = 0; i + 1 < pipe.route.size(); ++i)
      for (unsigned int axis = 0; axis < 3; ++axis) {
        if (free[3 + axis])
          continue;
        // A pipe that bends about the axis moves along the axis times the leg's direction.
        const unsigned int next = (axis + 1) % 3, last = (axis + 2) % 3;
        const Vector3 leg = pipe.route[i + 1].position - pipe.route[i].position;
        const auto bends = [&](const unsigned int along, const unsigned int moves) {
          return std::abs(leg[along]) > 1e-6 * leg.norm() && free[moves];
        };
        if (!bends(next, last) && !bends(last, next))
          continue;
        const unsigned int moves = bends(next, last) ? last : next;
        scene.remarks.push_back(
            "Free motions: u" + std::string(1, "xyz"[moves]) + " is free and r" +
            std::string(1, "xyz"[axis]) + " is held, at the points only: between them pipe " +
            pipe.name +
            " bends, so that the answer depends on where points stand. Free both, or "
            "hold both.");
        return;
      }
}

bool has_creep(const ParameterReader &in) {
  const auto is_positive = [&](const std::string &entry) {
    double value = 0.;
    return to_number(in.raw(entry, "0"), value) && value > 0.;
  };
  return is_positive("Creep coefficient") || is_positive("Primary creep coefficient");
}

} // namespace frictionbeam::parts
