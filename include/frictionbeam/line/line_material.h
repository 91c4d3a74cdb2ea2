// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/bound_law.h>
#include <frictionbeam/fe_arc_beam.h>

#include <deal.II/base/types.h>

#include <map>
#include <vector>

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
 * What FE_TimoshenkoBeam is made with, 12 E I / (kappa G A) [m2] by material id, by the laws'
 * elastic tangents at rest: numbers of a section then stand in one place. Of supports, of ids
 * between, and without shear stiffness, 0; of unequal axes the mean of both.
 */
std::vector<double> shear_flexibilities(const LineMaterials &materials);

/// What FE_ArcBeam is made with, likewise. @throws dealii::ExcMessage if the law is of supports
ArcData arc_data(const LineMaterial &material, const dealii::Point<3> &centre);

/**
 * The material of a cell.
 * @throws dealii::ExcMessage if there is none, if it has no law, or one of the other kind
 */
const LineMaterial &material_of(const LineMaterials &materials,
                                const dealii::types::material_id material_id, const LawKind kind);

} // namespace frictionbeam
