// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/how_well_known.h"

#include "results/text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double worth_a_remark = 0.05, rounding_of_parts = 1e-9;
/// Error of the displacements by how much slip has turned within increments, relative to the
/// largest displacement: 0.35 to 0.43 on a node that goes along a tractrix, 0.4 to 0.9 on lines
/// with rests in 1 to 8 increments a step, each against 64 or more (doc/accuracy.md).
constexpr double error_by_turned_slip = 0.5;
/// Error of the displacements by how much longer cells are than the curves that they stand for: 0.5
/// to 1.6 on elasticas, up to 3.5 where one cell of two takes all the bending (doc/accuracy.md).
constexpr double error_by_unbent_cells = 3.;
/// Changes of acceleration in a time step, of the acceleration, up to which the motion counts as
/// followed: five steps in a radian.
constexpr double most_change = 0.2;

/// Whether pipes have yielded or crept.
bool has_flowed(const Results &results) {
  return std::any_of(results.steps.begin(), results.steps.end(),
                     [](const StepReport &step) { return step.energy.inelastic > 0.; });
}

/// A quantity that adds up what contacts do, or asks when they do it.
const Quantity *that_follows_contacts(const Scene &scene) {
  using Over = Quantity::Over;
  const auto found =
      std::find_if(scene.quantities.begin(), scene.quantities.end(), [](const Quantity &quantity) {
        return quantity.over == Over::time_of || quantity.over == Over::integral ||
               quantity.over == Over::mean;
      });
  return found == scene.quantities.end() ? nullptr : &*found;
}

/// A quantity that is work of friction.
const Quantity *work_of_friction(const Scene &scene) {
  const auto found = std::find_if(scene.quantities.begin(), scene.quantities.end(),
                                  [](const Quantity &quantity) { return quantity.what == "work"; });
  return found == scene.quantities.end() ? nullptr : &*found;
}

KnownError by_increments(const Scene &scene, const Results &results, const Resolution &all) {
  std::size_t n_increments = 0;
  for (unsigned int i = 0; i < results.steps.size(); ++i)
    if (!scene.steps[i].transient)
      n_increments += results.steps[i].increments;
  if (n_increments == 0)
    return {0., "there is no static increment"};
  if (has_flowed(results))
    return {{}, "pipes yield or creep within increments; Accuracy measures it"};
  constexpr double as_near = 1. + rounding_of_parts;
  if (std::any_of(results.steps.begin(), results.steps.end(), [](const StepReport &step) {
        return step.limit && !(step.limit->bound <= as_near * step.limit->reached);
      }))
    return {{}, "a limit load lies between what is carried and its bound (limit_bound)"};
  if (all.loads_bend_within)
    return {{},
            "what a History, or the ground, does within an increment is not seen; Accuracy "
            "measures it"};
  if (!all.slip_is_known)
    return {{}, "a law does not say what of its motion is slip"};
  if (all.touched_within)
    return {{},
            "a support with friction closes within an increment, whose motion before that counts "
            "as slip: an error of first order, which Accuracy measures"};
  if (const Quantity *const quantity = that_follows_contacts(scene);
      quantity != nullptr && all.turned_within)
    return {{},
            "contacts change their states within increments, where " + quantity->name +
                " does not see when; Accuracy measures it"};
  if (const Quantity *const work = work_of_friction(scene);
      work != nullptr && all.limit_changed_within)
    return {{},
            "a contact begins or ceases to slip within an increment while what it can hold "
            "changes, and " +
                work->name + " does not see when; Accuracy measures it"};
  if (n_increments == 1 && all.slip_from_rest > 0.)
    return {{}, "friction slips in the only increment, and nothing shows on which way"};
  if (all.turned_unseen)
    return {{},
            "a contact closes, opens, turns back or lets go within an increment, where friction of "
            "others may turn unseen; Accuracy measures it"};
  if (all.slip_turned <= rounding_of_parts * all.largest_displacement)
    return {0., "no friction force has turned within an increment"};
  return {error_by_turned_slip * all.slip_turned / all.largest_displacement,
          "by how much friction forces turn while they slip within increments"};
}

KnownError by_time_step(const Scene &scene, const Results &results, const Resolution &all) {
  bool transient = false, reduced = false;
  for (unsigned int i = 0; i < results.steps.size(); ++i) {
    transient = transient || scene.steps[i].transient;
    reduced = reduced || (results.steps[i].reduction && results.steps[i].reduction->is_reduced);
  }
  if (!transient)
    return {0., "there is no transient step"};
  if (has_flowed(results))
    return {{}, "pipes yield or creep within time steps; Accuracy measures it"};
  if (reduced)
    return {{}, "the motion was followed on modes"};
  if (all.exact_in_time && !all.handed_over)
    return {0., "the integrator is exact"};
  if (all.exact_in_time)
    return {{}, "the integrator handed over a part of the motion"};
  if (all.state_changes > 0)
    return {{},
            "contacts changed their state in " + std::to_string(all.state_changes) +
                " time steps, which leaves an error of first order; Accuracy measures it"};
  if (all.forces_lag)
    return {{},
            "the law of a support has a force by its rate, which is that of the middle of a time "
            "step, an error of first order; Accuracy measures it"};
  if (all.turned_in_motion > all.local_errors)
    return {
        {},
        "friction turns while it slips within time steps, which leaves an error of first order; "
        "Accuracy measures it"};
  if (all.acceleration_changes > most_change * all.accelerations)
    return {{}, "the fastest motions of the cells are not followed; Accuracy measures the rest"};
  if (scene.time.theta != 0.5 || scene.time.gamma != 0.5 ||
      scene.time.spectral_radius < scene.time.row().spectral_radius)
    return {{}, "numerical damping has an error of its own; Accuracy measures it"};
  if (all.starts_to_move && all.accelerations == 0.)
    return {{},
            "nothing shows what a single time step leaves out of a motion; Accuracy measures it"};
  if (all.largest_displacement == 0.)
    return {{}, "nothing moves, and what a load does between two instants is not seen"};
  return {all.local_errors / all.largest_displacement, "sum of the local errors of the time steps"};
}

/// Largest |N| l^2/(12 EI) of cells at the ends of the steps: what the axial force bends or
/// straightens within a cell, and a cell's element leaves out, before the line as a whole makes
/// more of it.
struct AxialForces {
  double tension = 0., compression = 0.;
};
AxialForces axial_forces_in_cells(const Scene &scene, const Results &results) {
  AxialForces largest;
  for (const Frame &frame : results.frames) {
    const Station *last = nullptr; // node
    for (const Station &station : frame.line) {
      if (!station.is_node())
        continue;
      if (last != nullptr && last->pipe == station.pipe && station.s > last->s) {
        const Pipe &pipe = scene.pipes[station.pipe];
        const double length = station.s - last->s,
                     stiffness = scene.materials[pipe.material].youngs_modulus *
                                 scene.sections[pipe.section].inertia;
        const double part = station.force[0] * length * length / (12. * stiffness);
        largest.tension = std::max(largest.tension, part);
        largest.compression = std::max(largest.compression, -part);
      }
      last = &station;
    }
  }
  return largest;
}

KnownError by_cells(const Scene &scene, const Results &results, const Resolution &all) {
  double of_modes = 0.;
  for (const ModeResult &mode : results.modes)
    of_modes = std::max(of_modes, mode.by_cells);
  if (of_modes > 0.)
    return {of_modes, "of the frequencies, by how long cells are against the waves of the modes"};
  if (std::any_of(scene.steps.begin(), scene.steps.begin() + results.steps.size(),
                  [](const LoadStep &step) { return step.transient; }))
    return {{}, "inertia is spread over cells; Accuracy measures it"};
  if (scene.modal.n_modes > 0)
    return {{}, "inertia is spread over cells"};
  for (const Pipe &pipe : scene.pipes)
    if (pipe.end_section)
      return {{}, "the cells of a reducer have one section each; Accuracy measures it"};
    else if (pipe.bend_radius > 0. && !scene.mesh.arcs)
      return {{}, "a bend of the mesh file is in straight cells"};
  for (const FrictionSupport &support : scene.supports)
    if (support.placement.continuous)
      return {{}, "a bed carries at the nodes"};
  if (has_flowed(results))
    return {{},
            "pipes yield or creep between the sections that are looked at; Accuracy measures it"};
  if (unseen_yield(results) > 0.)
    return {{},
            "between the sections of a cell strains are beyond those at which its law is elastic, "
            "where nothing looks at them; take shorter cells"};
  constexpr double right_angle = 1.57079632679489662;
  double error = 0.;
  if (scene.has_bend() && !scene.mesh.arcs) {
    const double angle =
        right_angle / std::ldexp(scene.mesh.cells_per_bend, scene.mesh.refinements);
    error = angle * angle / 12.;
  }
  if (all.unbent > rounding_of_parts * all.largest_displacement)
    error += error_by_unbent_cells * all.unbent / all.largest_displacement;
  if (scene.kinematics == Kinematics::corotational) {
    const AxialForces forces = axial_forces_in_cells(scene, results);
    if (forces.compression > std::max(error, rounding_of_parts))
      return {{}, "compression bends cells within themselves; Accuracy measures it"};
    // What the tension of a cell is beyond its bending changes where it bends, not how much.
    error += forces.tension / (1. + 4. * forces.tension);
  }
  if (error == 0.)
    return {0., "the elements are exact"};
  return {error, "from the angles of cells and the tension in them"};
}

} // namespace

HowWellKnown how_well_known(const Scene &scene, const Results &results) {
  Resolution all;
  for (const StepReport &step : results.steps)
    all.include(step.resolution);
  return {by_increments(scene, results, all), by_time_step(scene, results, all),
          by_cells(scene, results, all)};
}

void include_accuracy(const bool chooses_increments, Results &results) {
  if (!results.accuracy || std::isnan(results.accuracy->estimate))
    return;
  std::vector<KnownError *> measured = {&results.known.time_step, &results.known.cells};
  if (chooses_increments)
    measured.push_back(&results.known.increments);
  else if (!results.known.increments.error)
    results.known.increments.reason = "Accuracy leaves the increments of bodies as they are given";
  for (KnownError *const known : measured)
    if (!known->is_of_walls && (!known->error || *known->error > 0.))
      *known = {results.accuracy->estimate,
                results.accuracy->model.empty()
                    ? "estimated from coarser runs, all of them together"
                    : "estimated from coarser runs and of the model, all of it together"};
}

std::string in_words(const KnownError &known) {
  if (!known.error)
    return "not estimated";
  return *known.error == 0. ? "exact" : rounded_number(100. * *known.error, 2) + " %";
}

double unseen_yield(const Results &results) {
  double largest = 0.;
  for (const StepReport &step : results.steps)
    largest = std::max(largest, step.sections.unseen_yield);
  return largest > rounding_of_parts ? largest : 0.;
}

void add_remarks(const HowWellKnown &known, const bool chooses_increments, Results &results) {
  if (unseen_yield(results) > 0.)
    results.remarks.push_back(
        "A pipe yields between the sections of a cell, where nothing looks at it, and is solved as "
        "if it did not: what is told of it is not an answer. Take shorter cells "
        "(Mesh/Cell length), more Section points, or an Accuracy.");
  const std::string ask =
      results.accuracy || !chooses_increments ? "." : ", or ask for an Accuracy.";
  if (!known.increments.error && !known.increments.reason.empty() && !has_flowed(results))
    results.remarks.push_back("What the size of the load increments does to the answers is not "
                              "estimated (" +
                              known.increments.reason + "). Take more Increments and compare" +
                              ask);
  if (results.accuracy && !std::isnan(results.accuracy->estimate))
    return; // has its own
  const std::string of_cells = results.modes.empty() ? "Displacements" : "Frequencies";
  constexpr double large =
      0.1; // the first term of what cells leave of a frequency says little then
  const auto add = [&](const KnownError &one, const std::string &what, const std::string &hint,
                       const std::string &numbers = "Displacements") {
    if (one.error && *one.error > worth_a_remark)
      results.remarks.push_back(numbers + " are known to about " + in_words(one) +
                                (numbers == "Frequencies" && *one.error > large ? " at best" : "") +
                                " for " + what + " (" + one.reason + "). " + hint);
  };
  add(known.increments, "the size of the load increments",
      "Take more Increments in the steps" + ask);
  add(known.time_step, "the time step", "Take a shorter Time/Step" + ask);
  add(known.cells, "the length of the cells",
      "Take shorter cells (Mesh/Cell length, Cells per bend; Degree and Cells around of section "
      "Solid)" +
          ask,
      of_cells);
}

} // namespace frictionbeam
