// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/bound_law.h>

#include <deal.II/base/types.h>

#include <map>

namespace frictionbeam {

/// What a cell of a line is made of.
struct LineMaterial {
  BoundLaw law;     ///< of kind `section` for beams and arcs, `support` for friction elements
  double mass = 0.; ///< of the line, what it carries included [kg/m]
  /// Density times moment of inertia about a diameter [kg m]; twist has twice of it, none if 0.
  double rotary_inertia = 0.;
};

/// By the cells' material id.
using LineMaterials = std::map<dealii::types::material_id, LineMaterial>;

/**
 * The material of a cell.
 * @throws dealii::ExcMessage if there is none, if it has no law, or one of the other kind
 */
const LineMaterial &material_of(const LineMaterials &materials,
                                const dealii::types::material_id material_id, const LawKind kind);

} // namespace frictionbeam
