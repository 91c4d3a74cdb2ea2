// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/fibre_quantities.h"

#include "base/user_error.h"
#include "results/quantity/station_at.h"
#include "results/stress/stress_evaluation.h"
#include "results/stress/wall_stress.h"

namespace frictionbeam {

Axes local_axes_of(const Station &station) {
  return {{dealii::cross_product_3d(station.y, station.z), station.y, station.z}};
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

/// The side of a point that lies in a bend, where none is asked for.
const Station &station_in_bend(const Model &model, const Quantity &quantity, const Frame &made) {
  const Station &first = station_at(model, quantity, made);
  if (first.bend_radius > 0. || quantity.side != Quantity::Side::any)
    return first;
  Quantity other = quantity;
  other.side = Quantity::Side::after;
  const Station *const after = find_station(model, other, made);
  return after != nullptr && after->bend_radius > 0. ? *after : first;
}

} // namespace

double value_of_fibre(const Model &model, const Quantity &quantity, const Frame &made) {
  const auto which = static_cast<Fibre>(quantity.kind().component);
  const std::string name = "Quantity " + quantity.name + ": ";
  if (which == Fibre::in_plane || which == Fibre::out_of_plane) {
    const Station &station = station_in_bend(model, quantity, made);
    const Vector3 normal = StressEvaluation::normal_of_plane(model.scene, model.mesh, station);
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
