// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/catalogue/catalogue_entries.h"
#include "scene/part/parts.h"

namespace frictionbeam::parts {

namespace {

/// Six numbers, or three for the translations alone, in @p units. @p angles: rotations are given
/// in degrees.
Motion parse_motion(const ParameterReader &in, const std::string &entry, const bool angles,
                    const std::array<const char *, 2> &units) {
  const std::vector<double> values = in.numbers(entry);
  if (values.size() != 3 && values.size() != 6)
    in.fail(entry, "three numbers, or six with the rotations", "'0 0 0'");
  Motion motion{};
  for (unsigned int i = 0; i < values.size(); ++i)
    motion[i] = in.in_bounds(
        entry, values[i] * in.si(entry, units[i / 3]) * (angles && i >= 3 ? degree : 1.),
        units[i / 3]);
  return motion;
}

} // namespace

void declare_spring(ParameterReader &in) {
  in.declare_text("At", "", "name of a point", "Where the spring acts.");
  in.declare_text("To", "", "name of a point", "Its other end; empty: the ground.");
  in.declare_text("Stiffness", "0 0 0", "kx ky kz [N/m], or with three more about x y z [N m/rad]",
                  "In global axes, none of them negative.");
  in.declare_text("Damping", "0 0 0",
                  "cx cy cz [N s/m], or with three more about x y z [N m s/rad]",
                  "Of a dashpot beside the spring, in transient steps.");
}

void parse_spring(const ParameterReader &in, const std::string &name, Scene &scene) {
  Spring spring;
  spring.name = name;
  spring.point = in.text("At");
  spring.other = in.text("To");
  check_point(in, "At", spring.point, scene);
  if (!spring.other.empty())
    check_point(in, "To", spring.other, scene);
  if (spring.point == spring.other)
    in.fail("To", "another point than At", "a second point, or nothing for the ground");
  spring.stiffness = parse_motion(in, "Stiffness", false, {{"N/m", "N m/rad"}});
  spring.damping = parse_motion(in, "Damping", false, {{"N s/m", "N m s/rad"}});
  for (const double c : spring.damping)
    if (c < 0.)
      in.fail("Damping", "numbers >= 0", "a positive damping");
  double sum = 0.;
  for (const double c : spring.damping)
    sum += c;
  for (const double k : spring.stiffness) {
    if (k < 0.)
      in.fail("Stiffness", "numbers >= 0", "a positive stiffness");
    sum += k;
  }
  if (sum == 0.)
    in.fail("Stiffness", "at least one number > 0", "'1e6 0 0'");
  scene.springs.push_back(spring);
}

void declare_mass(ParameterReader &in) {
  in.declare_text("At", "", "names of points, separated by commas", "One such mass at each.");
  in.declare_number("Mass", 0., "kg", 0., 1e300, "Of a valve, a flange.");
  in.declare_text("Item", "", "name of an item of Catalogue/Components",
                  "Of your own table, whose mass it has.");
}

void parse_mass(const ParameterReader &in, const std::string &name, Scene &scene) {
  PointMass mass;
  mass.name = name;
  mass.points = in.list("At");
  if (mass.points.empty())
    in.fail("At", "at least one point", "the name of a point");
  for (const std::string &point : mass.points)
    check_point(in, "At", point, scene);
  mass.mass = in.number("Mass");
  if (!in.text("Item").empty()) {
    if (in.given("Mass"))
      in.fail("Item", "an item, which has a mass, or 'Mass'", "removing 'Mass'");
    mass.mass = component_item(in, scene).mass;
  }
  scene.masses.push_back(mass);
}

void declare_initial(ParameterReader &in) {
  in.declare_text("At", "", "names of points, separated by commas",
                  "Which points start so. What several such sections give a point adds up.");
  in.declare_text("Pipes", "", "names of pipes, separated by commas",
                  "All of whose nodes start so.");
  in.declare_text("About", "", "name of a point",
                  "Displacement and velocity are those of a rigid body at this point; empty: of "
                  "each node.");
  in.declare_text("Displacement", "0 0 0", "ux uy uz [m], or with rx ry rz [degrees]",
                  "At the start of the first step, which must be transient.");
  in.declare_text("Velocity", "0 0 0", "vx vy vz [m/s], or with three more [degrees/s]",
                  "At the start of the first transient step.");
}

void parse_initial(const ParameterReader &in, Scene &scene) {
  InitialCondition initial;
  initial.points = in.list("At");
  initial.pipes = in.list("Pipes");
  if (initial.points.empty() && initial.pipes.empty())
    in.fail("At", "at least one point here, or a pipe in Pipes", "the name of a point");
  for (const std::string &point : initial.points)
    check_point(in, "At", point, scene);
  for (const std::string &pipe : initial.pipes)
    in.find("Pipes", pipe, names(scene.pipes), "pipe");
  initial.about = in.text("About");
  if (!initial.about.empty())
    check_point(in, "About", initial.about, scene);
  initial.displacement = parse_motion(in, "Displacement", true, {{"m", "rad"}});
  if (initial.displacement != Motion{} && !scene.steps.empty() && !scene.steps.front().transient)
    in.fail("Displacement", "none before a static step, which moves the line to its equilibrium",
            "a load of kind displacement");
  initial.velocity = parse_motion(in, "Velocity", true, {{"m/s", "rad/s"}});
  if (std::none_of(scene.steps.begin(), scene.steps.end(),
                   [](const LoadStep &step) { return step.transient; }))
    in.fail_section("a section Initial and no transient step", "Initial with a transient step",
                    "set Analysis = transient in a step");
  scene.initial.push_back(initial);
}

} // namespace frictionbeam::parts
