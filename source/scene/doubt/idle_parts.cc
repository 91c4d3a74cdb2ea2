// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/doubt/idle_parts.h"

#include "scene/part/parts.h"

#include <algorithm>

namespace frictionbeam {

namespace {

/// What an Initial wants of a point in directions in which a load moves it.
void remark_on_moved_points(Scene &scene) {
  for (const InitialCondition &initial : scene.initial) {
    std::vector<std::string> points = initial.points;
    for (const Pipe &pipe : scene.pipes)
      if (std::count(initial.pipes.begin(), initial.pipes.end(), pipe.name) > 0)
        for (const RoutePoint &point : pipe.route)
          if (std::count(points.begin(), points.end(), point.name) == 0)
            points.push_back(point.name);
    for (const Load &load : scene.loads)
      for (const Load::AtPoint &moved : load.at)
        for (unsigned int c = 0; c < 6; ++c)
          if (const Motion axis = unit_motion(moved.axes, c);
              load.kind == Load::Kind::displacement && moved.given[c] &&
              (product(initial.velocity, axis) != 0. ||
               product(initial.displacement, axis) != 0.) &&
              std::count(points.begin(), points.end(), moved.point) > 0)
            scene.remarks.push_back("The Initial of " + moved.point + " has a part along " +
                                    parts::motions[c] + ", in which load " + load.name +
                                    " moves it: it does nothing there.");
  }
}

/// What an Initial wants in directions that Free motions holds.
void remark_on_initial(Scene &scene) {
  for (const InitialCondition &initial : scene.initial)
    for (unsigned int c = 0; c < 6 && initial.about.empty(); ++c)
      if (!scene.free_motions[c] && (initial.velocity[c] != 0. || initial.displacement[c] != 0.)) {
        const std::string &where =
            initial.points.empty() ? initial.pipes.front() : initial.points.front();
        scene.remarks.push_back("The Initial of " + where + " has a part along " +
                                parts::motions[c] +
                                ", which is not one of the Free motions: it does nothing.");
      }
}

/// Corners of a route that are to be rounded, and at which it goes straight on.
void remark_on_straight_bends(const Pipe &pipe, Scene &scene) {
  constexpr double no_angle = 1e-9; // as PipePath has it [rad]
  for (unsigned int i = 1; i + 1 < pipe.route.size(); ++i) {
    const RoutePoint &point = pipe.route[i];
    const Vector3 before = point.position - pipe.route[i - 1].position,
                  after = pipe.route[i + 1].position - point.position;
    if (point.bend_radius > 0. && before * after > 0. &&
        cross_product_3d(before, after).norm() <= no_angle * before.norm() * after.norm())
      scene.remarks.push_back("Pipe " + pipe.name + ": the route goes straight on at point " +
                              (point.name.empty() ? std::to_string(i + 1) : point.name) +
                              ", where it has a bend, and there is none.");
  }
}

/// Loads that no step names. What such a load of displacements moves is not held.
void remark_on_loads(Scene &scene) {
  for (unsigned int l = 0; l < scene.loads.size(); ++l) {
    const auto names_it = [&](const LoadStep &step) {
      return std::any_of(step.loads.begin(), step.loads.end(),
                         [&](const auto &load) { return load.first == l; });
    };
    Load &load = scene.loads[l];
    if (std::any_of(scene.steps.begin(), scene.steps.end(), names_it))
      continue;
    if (load.kind == Load::Kind::displacement)
      load.at.clear();
    scene.remarks.push_back("Load " + load.name + " is in the Loads of no step, and does nothing.");
  }
}

} // namespace

void remark_on_idle_parts(Scene &scene) {
  const bool has_motion = std::any_of(scene.steps.begin(), scene.steps.end(),
                                      [](const LoadStep &step) { return step.transient; });
  for (const Pipe &pipe : scene.pipes)
    remark_on_straight_bends(pipe, scene);
  for (const Spring &spring : scene.springs)
    if (spring.kind == "spring" && spring.stiffness == Motion{} &&
        (!has_motion || spring.damping == Motion{}))
      scene.remarks.push_back("Spring " + spring.name + " has no stiffness, and does nothing.");
  for (const Joint &joint : scene.joints)
    if (joint.kind == "joint" &&
        std::min({joint.axial, joint.lateral, joint.bending, joint.torsion}) >= Joint::rigid)
      scene.remarks.push_back("Joint " + joint.name +
                              " is rigid in all its motions, and does nothing.");
  for (const PointMass &mass : scene.masses)
    if (mass.mass == 0.)
      scene.remarks.push_back("Mass " + mass.name + " is of 0 kg, and does nothing.");
  remark_on_initial(scene);
  remark_on_moved_points(scene);
  remark_on_loads(scene);
}

} // namespace frictionbeam
