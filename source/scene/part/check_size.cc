// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/bed_cells.h"
#include "scene/part/parts.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::parts {

namespace {

double length_of(const Pipe &pipe) {
  double length = 0.;
  for (std::size_t i = 1; i < pipe.route.size(); ++i)
    length += pipe.route[i].position.distance(pipe.route[i - 1].position);
  return length;
}

/// Cells of the straight runs and bends of a pipe, at least.
double cells_of(const Pipe &pipe, const MeshSettings &mesh) {
  double n = pipe.route.size();
  if (mesh.cell_length > 0.)
    n += length_of(pipe) / mesh.cell_length;
  if (!mesh.arcs)
    for (const RoutePoint &point : pipe.route)
      n += point.bend_radius > 0. ? mesh.cells_per_bend : 0.;
  return n;
}

/// Those that a bed gives a pipe by itself; of one that has From and To, none are counted.
double cells_of_bed(const Pipe &pipe, const Scene &scene) {
  const auto carries = [&](const FrictionSupport &support) {
    const Placement &bed = support.placement;
    return bed.continuous && bed.pipe == pipe.name && bed.from.empty() && bed.to.empty();
  };
  const double length = length_of(pipe);
  return scene.mesh.cell_length == 0. && length > 0. &&
                 std::any_of(scene.supports.begin(), scene.supports.end(), carries)
             ? length / bed_cell_length(scene.sections[pipe.section], length)
             : 0.;
}

double number_at(const Placement &placement, const Scene &scene) {
  double n = placement.points.size();
  for (const Pipe &pipe : scene.pipes)
    if (pipe.name == placement.pipe && placement.every > 0.)
      n += length_of(pipe) / placement.every;
  return n;
}

/// Of equal cells as high as those of a box.
double cells_of(const ContinuumBox &box, const unsigned int dimension) {
  const double cell = box.size[1] / box.cells[1];
  double n = 1.;
  for (unsigned int d = 0; d < dimension; ++d)
    n *= std::max(1., box.size[d] / cell);
  return n;
}

} // namespace

void check_size(ParameterReader &in, const Scene &scene) {
  double n_cells = 0., n_supports = 0.;
  for (const Pipe &pipe : scene.pipes)
    n_cells += cells_of(pipe, scene.mesh) + cells_of_bed(pipe, scene);
  for (const FrictionSupport &support : scene.supports)
    n_supports += number_at(support.placement, scene);
  for (const Restraint &restraint : scene.restraints)
    n_supports += number_at(restraint.placement, scene);
  const auto check = [&](const std::string &heading, const std::string &entry,
                         const std::string &what, const double n, const std::string &read,
                         const std::string &advice) {
    in.enter(heading);
    const unsigned int most = in.count(entry);
    if (n > most)
      in.fail_section(
          read, "at most " + std::to_string(most) + " " + what + ", since more take very long",
          advice + "; or, if it is meant, " + heading + "/" + entry + " = " +
              std::to_string(static_cast<unsigned long>(1.1 * std::min(n, 1e15))));
  };
  const double n = std::ldexp(n_cells + n_supports, scene.mesh.refinements); // which cut cells, too
  check("Mesh", "Most cells", "cells and supports", n,
        "a scene of some " + to_text(std::ceil(n)) + " cells and supports",
        "a longer Cell length, fewer Cells per bend or Refinements, or supports less often");
  if (scene.continuum && scene.continuum->box) {
    const double n_of_box = cells_of(*scene.continuum->box, scene.continuum->dimension);
    check("Mesh", "Most cells", "cells", n_of_box,
          "a box of some " + to_text(std::ceil(n_of_box)) + " cells", "fewer Continuum/Cells");
  }
  for (const LoadStep &step : scene.steps)
    if (step.transient && scene.time.step > 0.)
      check("Time", "Most steps", "time steps", step.duration / scene.time.step,
            "Step '" + step.name + "' would take too many time steps: " + to_text(step.duration) +
                " s in steps of " + to_text(scene.time.step) + " s",
            "a longer Step or a shorter Duration");
}

} // namespace frictionbeam::parts
