// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/algebra/elastic_system.h"
#include "analysis/substructure/section_motion.h"
#include "mesh/solid/solid_stretches.h"
#include "model/body/wall_loads.h"
#include "model/line/solid_part.h"

namespace frictionbeam {

/// A stretch of a pipe as a scene of its own: one pipe, whose points are the line's vertices on it,
/// and the loads that act on its metal.
struct StretchScene {
  StretchScene(const Scene &whole, const LineMesh &line, const SolidStretch &stretch);

  Scene scene;
  LineMesh line;
  std::vector<unsigned int> vertices; ///< of the whole line
  unsigned int first_cell = 0;        ///< of the whole pipe
};

/**
 * The wall of a stretch of a pipe as a solid, which the line joins at its vertices by
 * SectionMotion: N, V, M and T go through the section at either end without disturbance. One
 * factorization gives the displacement fields u_k of unit forces on all sections but one, and of
 * the loads; with the motions F of the sections in these fields, relative to that one, K = G^T F^-1
 * G,   G q = motions q relative to the reference, which is symmetric and leaves rigid motions
 * without forces. The reference is an end that an anchor holds, where the section is held as
 * Solid/Anchors says; else the last one, where forces balance all others.
 */
class WallStretch {
public:
  /// @throws UserError for a wall that cannot be meshed
  WallStretch(const Scene &whole, const LineMesh &line, const SolidStretch &stretch);

  /// What the line takes. Factors the stiffness.
  SolidPart superelement();
  /// The field that belongs to motions of the sections, six each, and loads. After superelement().
  ContinuumVector displacement(const Eigen::VectorXd &motions,
                               const std::vector<double> &factors) const;

  /// The section at a place of part.vertices among the wall's rings.
  unsigned int ring_of(const unsigned int section) const { return rings[section]; }

  const SolidStretch stretch;
  const StretchScene own;
  PipeWall wall; ///< its s counts along the whole pipe
  const Scene body_scene;
  ContinuumBody<3> body;
  std::unique_ptr<const WallLoads> loads;

private:
  using Vector6 = SectionMotion::Vector6;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  bool has_held_end() const { return stretch.anchored[0] || stretch.anchored[1]; }
  Point3 place(const unsigned int section) const { return wall.rings[rings[section]].centre; }
  /// Rigid motion of a section by that of the reference: columns of the latter.
  Matrix6 carried(const unsigned int section) const;
  ContinuumVector solve(ContinuumVector forces, const Vector6 &resultant);
  /// Motions of all sections but the reference relative to it.
  Eigen::VectorXd relative(const ContinuumVector &displacement) const;
  /// G, motions to relative motions.
  Eigen::MatrixXd relation() const;
  /// Of each load at factor one: on what lies between sections.
  std::vector<std::vector<Motion>> cell_loads() const;

  std::vector<unsigned int> rings; ///< of the sections
  unsigned int reference = 0;      ///< among them
  std::vector<SectionMotion> sections;
  std::unique_ptr<ContinuumSystem> system;
  std::vector<ContinuumVector> of_forces, of_loads; ///< fields
  Eigen::MatrixXd inverse;                          ///< F^-1
  Eigen::MatrixXd free_motions;                     ///< relative, of each load (columns)
};

} // namespace frictionbeam
