// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"
#include <frictionbeam/bound_law.h>
#include <frictionbeam/fe_arc_beam.h>

#include <deal.II/base/table.h>

#include <optional>

namespace frictionbeam {

/// The bend that a cell is part of, in the direction of its pipe.
struct BendPart {
  double radius = 0., length = 0.;  ///< of the whole bend's axis [m]; 0: straight
  double begin = 0.5, end = 0.5;    ///< parts of its way where the cell begins and ends
  std::optional<Point3> arc_centre; ///< of a cell that is an arc
  /// Whether the law is another from section to section.
  bool changes_along() const { return begin != end; }
};

/// Elastic and mass data of a pipe's cross section, one for each material id of the triangulation.
struct Profile {
  double EA = 0., GA = 0., GJ = 0., EI = 0.; ///< [N, N, N m2, N m2]; EI with a bend's flexibility
  double mass = 0.;                          ///< [kg/m], with contents
  double rotary_inertia = 0.;                ///< about a diameter, where it is not left out [kg m]
  double twist_inertia = 0.;                 ///< about the axis: never 0 where there is mass [kg m]
  Material material;                         ///< for its expansion
  double wind_diameter = 0.;                 ///< outer, with insulation [m]
  double pressure_strain = 0.;               ///< axial strain of a closed pipe per pressure [1/Pa]
  double pressure_curvature = 0.;            ///< of a bend about its axis [1/(m Pa)]
  Vector3 bend_axis;                         ///< of a straight piece of a bend, unit; or 0
  dealii::Table<2, double> tangent;          ///< elastic, of the section law, 6 x 6
  BoundLaw law; ///< of an inelastic section; not set of an elastic one, nor of a rigid part
  double bore_area = 0.; ///< pressure times it is what the wall carries beyond the beam [m2]
  std::optional<Point3> arc_centre; ///< of a cell that is an arc
  BendPart bend; ///< if the law has the flexibility of bends in itself; else left as it is

  ArcData arc() const { return {*arc_centre, EA, GA, GJ, EI}; }
};

} // namespace frictionbeam
