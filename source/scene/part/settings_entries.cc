// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/scene_kinds.h"
#include "scene/part/parts.h"

#include <algorithm>
#include <filesystem>

namespace frictionbeam::parts {

namespace {
constexpr Word<bool> bends[] = {
    {"straight pieces", false, "cut into cells, as where 'Cells per bend' is given"},
    {"arcs", true,
     "one exact curved element between two points of a bend, or more by 'Cell length'"}};
constexpr Word<Mesher> meshers[] = {
    {"auto", Mesher::automatic, "gmsh for a File alone; routes are divided without it"},
    {"gmsh", Mesher::gmsh, "routes, too, drawn and meshed by gmsh, to the same nodes"}};
constexpr Word<bool> failures[] = {
    {"nothing", false, "a run whose steps converge has the exit status 0"},
    {"checks", true, "5 if one of the checks on top of the report fails"}};
} // namespace

void declare_mesh(ParameterReader &in) {
  in.declare_text("File", "", "path of a .geo or .msh file, from the parameter file's folder",
                  "A mesh of your own: its physical curves are the pipes, its physical points the "
                  "points. Its cells are divided further by the entries below, as routes are. "
                  "Empty: the routes are meshed.");
  in.declare_number(
      "Cell length", 0., "m", 0., 1e300,
      "Longest cell of a straight run, and of an arc; 0: one cell from point to point, and on a "
      "continuous bed, which carries at nodes, a hundredth of the bed or two diameters.");
  in.declare_choice("Mesher", Mesher::automatic, meshers, "");
  const bool cut = !in.raw("Cells per bend", "").empty();
  in.declare_choice("Bends", !cut, bends, "Of routes, and of pipes from File with a Bend radius.");
  in.declare_count("Cells per bend", 8, 1,
                   "Of straight pieces, in 90 degrees; and of arcs that move in large "
                   "displacements in time, whose mass is on their chords.");
  in.declare_count("Cells per reducer", 10, 1,
                   "At least so many between two points, each with the section in its middle: 10 "
                   "leave some 0.5 % of a flexibility, a limit load in the small end 5 %.");
  in.declare_count("Refinements", 0, 0,
                   "How often each cell that the entries above make is halved. Accuracy chooses "
                   "it: with a shorter Cell length, short cells would stay as they are.",
                   20);
  in.declare_count("Section points", 5, 3,
                   "Along a cell whose section yields or creeps, those of Gauss and Lobatto: at "
                   "both ends, where hinges are, and between.",
                   20);
  in.declare_flag(
      "Refine hinges", false,
      "Solve again with cells halved where their sections have yielded, until no "
      "quantity changes by more than Accuracy, or 1e-3 without one, relatively. Elastic "
      "cells stay as they are.");
  in.declare_count("Most cells", 200000, 1,
                   "A scene of more cells and supports would run for very long, and is refused.",
                   100000000);
}

void parse_mesh(const ParameterReader &in, Scene &scene) {
  scene.mesh.file = in.text("File");
  if (!scene.mesh.file.empty()) {
    namespace fs = std::filesystem;
    const fs::path beside = fs::path(in.file().name()).parent_path() / scene.mesh.file;
    if (fs::exists(beside))
      scene.mesh.file = beside.string();
    else if (!fs::exists(scene.mesh.file))
      in.fail("File", "a file that exists, from the parameter file's folder or the working folder",
              "the path from " + fs::absolute(in.file().name()).parent_path().string());
  }
  scene.mesh.cell_length = in.number("Cell length");
  scene.mesh.mesher = in.choice("Mesher", meshers);
  scene.mesh.arcs = in.choice("Bends", bends);
  scene.mesh.cells_per_bend = in.count("Cells per bend");
  scene.mesh.cells_of_reducer = in.count("Cells per reducer");
  scene.mesh.refinements = in.count("Refinements");
  scene.mesh.section_points = in.count("Section points");
  scene.mesh.refine_hinges = in.flag("Refine hinges");
  if (scene.mesh.refine_hinges && !scene.mesh.file.empty())
    in.fail("Refine hinges", "false with a mesh of your own", "routes in place of 'File'");
  scene.mesh.most_cells = in.count("Most cells");
}

void declare_solver(ParameterReader &in) {
  in.declare_choice("Method", SolverMethod::exact, solver_methods, "");
  in.declare_number("Tolerance", 1e-10, "-", positive, 1.,
                    "Of the residual, relative to the largest force.");
  in.declare_number(
      "Contact tolerance", 1e-8, "-", positive, 1.,
      "Of exact: how far the contact laws may be missed, each contact on its own scale.");
  in.declare_number("Creep tolerance", 1e-3, "-", positive, 1.,
                    "Of sections that creep: what an increment may leave in a stress, as a share "
                    "of it. Longer ones are halved.");
  in.declare_count("Max iterations", 50, 1, "Of newton, in one increment.", 1000000000);
  in.declare_count("Max elastic iterations", 10000, 1, "Of elastic, in one increment.", 1000000000);
  in.declare_count("Max halvings", 10, 0, "How often an increment that fails may be halved.", 50);
}

void parse_solver(const ParameterReader &in, Scene &scene) {
  scene.solver.method = in.choice("Method", solver_methods);
  // What rounding leaves of forces that cancel each other.
  const auto tolerance = [&](const std::string &entry) {
    constexpr double least = 1e-14;
    const double value = in.number(entry);
    if (value < least)
      scene.remarks.push_back("Solver/" + entry + " = " + to_text(value) +
                              " is below what rounding allows: " + to_text(least) + " is taken.");
    return std::max(value, least);
  };
  scene.solver.contact_tolerance = tolerance("Contact tolerance");
  scene.solver.tolerance = tolerance("Tolerance");
  scene.solver.creep_tolerance = in.number("Creep tolerance");
  scene.solver.max_iterations = in.count("Max iterations");
  scene.solver.max_elastic_iterations = in.count("Max elastic iterations");
  scene.solver.max_halvings = in.count("Max halvings");
}

void declare_time(ParameterReader &in) {
  in.declare_choice(
      "Integrator", Integrator::moreau_jean, integrators,
      "Of transient steps. All but event: rigid contact and friction exact, as impulses on "
      "velocities, friction elements of finite stiffness by their return mapping; newmark and "
      "generalized_alpha take all by return mapping with Solver/Method = newton or elastic;");
  in.declare_number("Step", 0., "s", 0., 1e300,
                    "Of the integrator; of event: between instants of output. 0: 0.7 of the time "
                    "that a wave along the pipe needs for the shortest cell; without pipes a "
                    "fortieth of the shortest period of a mass on its springs.");
  in.declare_count("Most steps", 10000000, 1,
                   "Steps shorter than what this number allows would run for very long, and are "
                   "refused.",
                   2000000000);
  in.declare_number("Tolerance", 0., "m", 0., 1e300,
                    "Error of displacements allowed in one step, which is then halved or doubled; "
                    "0: all steps are equal.");
  in.declare_number("Output interval", 0., "s", 0., 1e300,
                    "Of what is written of a transient step; 0: every time step.");
  in.declare_number("Beta", 0.25, "-", 0., 0.5,
                    "Of Newmark, at least half of Gamma; 0.25 is the average acceleration.");
  in.declare_number("Gamma", 0.5, "-", 0.5, 1., "Of Newmark; above 0.5 it damps.");
  in.declare_number("Spectral radius", -1., "-", -1., 1.,
                    "Of the alpha schemes, for infinitely fast motions, 0 to 1; 1: no numerical "
                    "damping. -1: 0.8 of generalized_alpha, 1 of nonsmooth_alpha, which gains "
                    "energy in impacts below 1.");
  in.declare_number("Theta", 0.5, "-", 0.5, 1., "Of moreau_jean; above 0.5 it damps.");
  in.declare_number("Mass damping", 0., "1/s", 0., 1e300, "Rayleigh's alpha: C = alpha M.");
  in.declare_number("Stiffness damping", 0., "s", 0., 1e300,
                    "Rayleigh's beta: C = beta K, K without the friction elements.");
  in.declare_number("Modal damping", 0., "-", 0., 1.,
                    "Ratio to critical, of every mode of the line without its friction elements; "
                    "rigid motions are not damped.");
  declare_reduction(in);
}

void parse_time(const ParameterReader &in, Scene &scene) {
  scene.time.integrator = in.choice("Integrator", integrators);
  scene.time.tolerance = in.number("Tolerance");
  scene.time.spectral_radius = in.number("Spectral radius");
  if (scene.time.spectral_radius < 0. && scene.time.spectral_radius != -1.)
    in.fail("Spectral radius", "0 to 1, or -1 for the integrator's own", "'0.8'");
  if (scene.time.spectral_radius < 0.)
    scene.time.spectral_radius = scene.time.row().spectral_radius;
  scene.time.theta = in.number("Theta");
  scene.time.mass_damping = in.number("Mass damping");
  scene.time.stiffness_damping = in.number("Stiffness damping");
  scene.time.modal_damping = in.number("Modal damping");
  scene.time.step = in.number("Step");
  scene.time.output_interval = in.number("Output interval");
  scene.time.beta = in.number("Beta");
  scene.time.gamma = in.number("Gamma");
  if (scene.time.integrator == Integrator::newmark && scene.time.beta < scene.time.gamma / 2.)
    in.fail("Beta", "at least half of Gamma, below which newmark is unstable with long steps",
            "'0.25' with Gamma = 0.5");
  parse_reduction(in, scene);
}

void declare_exact(ParameterReader &in) {
  in.declare_text("At", "", "name of a point", "Whose motion is known exactly.");
  in.declare_text("Motion", "ux", "ux, uy, uz, rx, ry or rz", "Which motion.");
  in.declare_text("History", "", time_function_form,
                  "Its course [m, rad], for the quantity max_error: the largest error at the ends "
                  "of the steps.");
  in.declare_number("Scale", 0., "m", 0., 1e300,
                    "Errors are relative to this; 0: they are in metres.");
}

void parse_exact(const ParameterReader &in, Scene &scene) {
  const std::string point = in.text("At");
  if (point.empty())
    return;
  check_point(in, "At", point, scene);
  const unsigned int motion = motion_index(in.text("Motion"));
  if (motion == 6)
    in.fail("Motion", "one of ux, uy, uz, rx, ry, rz", "'uz'");
  const TimeFunction history =
      parse_time_function(in, "History", in.text("History"), motion < 3 ? in.si("m") : 1.);
  if (!history.is_given())
    in.fail("History", time_function_form, "'cos(t)'");
  scene.exact = ExactHistory{point, motion, history.course, in.number("Scale")};
}

void declare_checks(ParameterReader &in) {
  in.declare_number("Reference tolerance", 0.01, "-", 0., 1e300,
                    "How far a quantity may be from its reference, relative to it.");
  in.declare_flag("Uplift", true,
                  "Whether a rest fails that the line stands off at the end of a static step, or "
                  "that a sum of cases pulls up.");
}

void parse_checks(const ParameterReader &in, Scene &scene) {
  scene.checks.reference_tolerance = in.number("Reference tolerance");
  scene.checks.uplift = in.flag("Uplift");
}

void declare_output(ParameterReader &in) {
  in.declare_count("Stations", 3, 0, "Between the two nodes of a cell, in line.csv.", 1000);
  in.declare_text("Steps", "", "names of steps and cases, separated by commas",
                  "That the report shows. Empty: all up to 24, of lines of many cells up to 6, "
                  "evenly chosen.");
  in.declare_text(
      "Sections", "", "names of points, separated by commas",
      "Of pipes that yield or creep: points whose sections' forces and strains are shown "
      "and written at every increment, in section_history.csv; of several sections at a "
      "point that which flows most. Empty: the two of the line that flow most.");
  in.declare_flag("Every increment", false,
                  "Write the state at every increment, not only at the ends of steps.");
  in.declare_flag("VTU", true, "Write files for ParaView.");
  in.declare_count("VTU frames", 200, 0,
                   "Most of them that a transient step writes, at even distances of time; a step "
                   "with more of output says so. 0: all.");
  in.declare_flag("Report", true, "Write report.html.");
  in.declare_flag("Write contact problems", false,
                  "Of every static increment of the method exact: the friction-contact problem and "
                  "its solution in the format of FCLIB, into the folder contact_problems.");
  in.declare_number(
      "Checkpoint interval", 60., "s", 0., 1e300,
      "Of wall time, between two writings of checkpoint.bin, from which a run that was "
      "killed goes on with the option --resume; 0: at SIGINT and SIGTERM only.");
  in.declare_choice("Fail on", false, failures, "What else than its steps a run may fail by.");
}

void parse_output(const ParameterReader &in, Scene &scene) {
  scene.output.stations = in.count("Stations");
  scene.output.steps = in.list("Steps"); // check_output() looks whether they exist
  for (const std::string &point : in.list("Sections"))
    if (std::count(scene.output.sections.begin(), scene.output.sections.end(), point) == 0)
      scene.output.sections.push_back(point); // check_inelastic() looks whether there is one
  scene.output.every_increment = in.flag("Every increment");
  scene.output.vtu = in.flag("VTU");
  scene.output.vtu_frames = in.count("VTU frames");
  scene.output.report = in.flag("Report");
  scene.output.contact_problems = in.flag("Write contact problems");
  scene.output.checkpoint_interval = in.number("Checkpoint interval");
  scene.checks.decide_exit_status = in.choice("Fail on", failures);
}

void declare_global(ParameterReader &in) {
  in.declare_text("Units", "si", "si, or a length and a force, and a mass, a stress, a temperature",
                  "Of all numbers in this file and of all results: 'in lb psi F', 'mm N MPa'. Mass "
                  "is force s2/length and stress force/length2 unless they are named. Words: " +
                      UnitSystem::known_words() + ".");
  in.declare_text("Title", "", "any text", "Of the report.");
  std::vector<std::string> sections;
  for (const SceneKind &kind : scene_kinds())
    if (kind.is_generated() &&
        std::count(sections.begin(), sections.end(), std::string(kind.value)) == 0)
      sections.emplace_back(kind.value);
  in.declare_choice("Scene", std::string(), scene_kinds(), "",
                    "All but line are made from the few entries of a section of their own: " +
                        join(sections) + ".");
  in.declare_choice("Model", ModelKind::line, model_kinds, "");
  in.declare_choice("Kinematics", Kinematics::linear, kinematics_kinds, "Of the line.");
  in.declare_number(
      "Accuracy", 0., "-", 0., 0.5,
      "Relative error of the quantities that is good enough: the program chooses increments, time "
      "step, cells, supports and elements itself, as coarse as its estimates of the error allow, "
      "and says what it chose; 0: they are as the file says.");
  in.declare_text("Law libraries", "", "paths of .so files, separated by commas",
                  "Shared libraries with laws of your own, from the parameter file's folder or the "
                  "folder the program runs in.");
  in.declare_text("Free motions", "ux, uy, uz, rx, ry, rz", "motions out of ux, uy, uz, rx, ry, rz",
                  "Of all points; the others are held, as out of the plane of a plane scene.");
  in.declare_text("Friction multipliers", "", "numbers >= 0 separated by commas",
                  "A study: the case is solved again with all friction coefficients times each of "
                  "these, and the worst of all is shown for every support.");
  in.declare_text("Monitors", "", "names of points, separated by commas",
                  "Points whose motion is recorded at every increment.");
  in.declare_number("Installation temperature", 20., "degC", -273.15, 1e300,
                    "At which the pipes are free of thermal strain.");
}

void parse_global(const ParameterReader &in, Scene &scene) {
  scene.title = in.text("Title");
  scene.model = in.choice("Model", model_kinds);
  scene.kinematics = in.choice("Kinematics", kinematics_kinds);
  scene.accuracy = in.number("Accuracy");
  scene.free_motions = parse_motions(in, "Free motions");
  for (const double multiplier : in.numbers("Friction multipliers")) {
    if (multiplier < 0.)
      in.fail("Friction multipliers", "numbers >= 0", "'0, 0.75, 1, 1.25'");
    scene.friction_multipliers.push_back(multiplier);
  }
  if (scene.free_motions == std::array<bool, 6>{})
    in.fail("Free motions", "at least one of ux, uy, uz, rx, ry, rz", "'ux, uz, ry'");
}

void parse_monitors(const ParameterReader &in, Scene &scene) {
  for (const std::string &point : in.list("Monitors")) {
    check_point(in, "Monitors", point, scene);
    if (std::count(scene.monitors.begin(), scene.monitors.end(), point) == 0)
      scene.monitors.push_back(point); // beside those of a generated scene
  }
}

} // namespace frictionbeam::parts
