// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/fibre_quantities.h"

#include "base/user_error.h"
#include "mesh/tangent_of_run.h"
#include "results/quantity/station_at.h"
#include "results/stress/stress_evaluation.h"
#include "results/stress/wall_stress.h"

namespace frictionbeam {

Axes local_axes_of(const Station &station) {
  return {{dealii::cross_product_3d(station.y, station.z), station.y, station.z}};
}

Axes local_axes_of(const Model &model, const Quantity &quantity,
                   const std::function<const Frame &()> &frame) {
  if (quantity.side != Quantity::Side::any || !quantity.pipe.empty())
    return local_axes_of(station_at(model, quantity, frame()));
  const unsigned int at = model.mesh.points.at(quantity.where);
  const std::optional<Vector3> tangent =
      tangent_of_run(model.scene, model.mesh, at, places_in_pipes(model.mesh, at));
  if (!tangent)
    throw UserError(
        "Quantity " + quantity.name + "\n  read:    a direction of the pipe at point '" +
        quantity.where +
        "', where several pipes meet and none goes straight on, or more than one\n  "
        "allowed: along local where one does, or along a vector\n  try:     'along 1 0 0', "
        "or a Tee whose Branch is the pipe that is not meant");
  if (tangent->norm() == 0.)
    return local_axes_of(station_at(model, quantity, frame())); // which says that no pipe is there
  const LocalAxes axes(*tangent);
  return {{axes.x, axes.y, axes.z}};
}

double along(const Quantity &quantity, const Axes &axes, const Motion &value) {
  const unsigned int first = quantity.kind().component % 2 * 3; // of a vector, or of what turns
  double sum = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int e = 0; e < 3; ++e)
      sum += quantity.direction[d] * axes[d][e] * value[first + e];
  return sum;
}

Motion section_force_in_space(const Station &station) {
  const Vector3 &y = station.y_now, &z = station.z_now, x = dealii::cross_product_3d(y, z);
  const Motion &force = station.force;
  Motion result;
  for (unsigned int d = 0; d < 3; ++d) {
    result[d] = force[0] * x[d] + force[1] * y[d] + force[2] * z[d];
    result[3 + d] = force[3] * x[d] + force[4] * y[d] + force[5] * z[d];
  }
  return result;
}

std::array<double, 2> moments_of_bend(const Vector3 &normal, const Station &station) {
  const double y = station.y * normal, z = station.z * normal; // n x t = z y - y z
  return {
      {station.force[4] * y + station.force[5] * z, station.force[4] * z - station.force[5] * y}};
}

namespace {

/// Normal of the bend that begins, ends or goes on at a quantity's point, on the asked side of it;
/// zero if there is none. Where forces do not jump a frame has one station for both sides.
Vector3 normal_of_bend(const Model &model, const Quantity &quantity, const Station &station) {
  using Side = Quantity::Side;
  const MeshedPipe &pipe = model.mesh.pipes[station.pipe];
  for (unsigned int i = 0; i < pipe.vertices.size(); ++i)
    for (const bool after : {false, true})
      if (pipe.vertices[i] == station.vertex && (after || i > 0) &&
          quantity.side != (after ? Side::before : Side::after))
        if (const auto axis = pipe.bend_axis.find(after ? i : i - 1); axis != pipe.bend_axis.end())
          return axis->second;
  return Vector3();
}

} // namespace

double value_of_fibre(const Model &model, const Quantity &quantity, const Frame &made) {
  const auto which = static_cast<Fibre>(quantity.kind().component);
  const std::string name = "Quantity " + quantity.name + ": ";
  if (which == Fibre::in_plane || which == Fibre::out_of_plane) {
    const Station &station = station_at(model, quantity, made);
    Vector3 normal = StressEvaluation::normal_of_tee(model.scene, model.mesh, station);
    if (normal.norm() == 0.)
      normal = normal_of_bend(model, quantity, station);
    if (normal.norm() == 0.)
      throw UserError(name + "the point '" + quantity.where +
                      "' is in no bend and no Tee, and has no plane. Take My and Mz, or M along a "
                      "direction.");
    return moments_of_bend(normal, station)[which == Fibre::out_of_plane];
  }
  const Station &station = station_at(model, quantity, made);
  const Pipe &pipe = model.scene.pipes[station.pipe];
  const Section section = section_at(model.scene, station);
  if (section.wall == 0.)
    throw UserError(name + "the section '" + section.name + "' of pipe '" + pipe.name +
                    "' is given by its figures and has no wall. Give 'Outer diameter' and 'Wall'.");
  const WallStress stress = wall_stress(section, station.force, station.pressure);
  return which == Fibre::most        ? stress.most
         : which == Fibre::least     ? stress.least
         : which == Fibre::von_mises ? stress.von_mises
                                     : stress.tresca;
}

} // namespace frictionbeam
