// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "mesh/solid/pipe_wall.h"
#include "model/body/body.h"

namespace frictionbeam {

/**
 * What the loads of a scene of pipes are on their wall: heat as a free strain of the metal,
 * pressure on the bore and as the thrust of closed ends on the two end sections, weight (of
 * contents and insulation, too) and line forces as forces on the metal's volume, and forces and
 * moments at points as tractions over the section there, uniform or linear in the distance from its
 * middle.
 */
class WallLoads {
public:
  /// @param line the scene's mesh as a line, which has its named points
  WallLoads(const Scene &scene, const LineMesh &line, const PipeWall &wall,
            const ContinuumBody<3> &body);

  /// Of each load at factor one, on the unconstrained dofs.
  std::vector<ContinuumVector> forces() const;

  /// What several loads make together.
  double free_strain(const unsigned int pipe, const std::vector<double> &factors) const;
  double pressure(const std::vector<double> &factors) const; ///< [Pa]
  Vector3 volume_force(const unsigned int pipe, const std::vector<double> &factors) const;
  /// All forces together [N], and their moment about the middle of the first section [N m].
  Motion resultant(const std::vector<double> &factors) const;
  /// Force [N] and moment [N m] on the section at a ring, thrust included.
  Motion section_load(const unsigned int ring, const std::vector<double> &factors) const;
  /// Whether some load acts on the section at a ring by itself.
  bool is_loaded(const unsigned int ring) const;

  /// Stress without free strain, of a displacement gradient.
  static dealii::SymmetricTensor<2, 3>
  stress(const LameConstants &lame, const dealii::Tensor<2, 3> &gradient, const double free_strain);

private:
  void measure();
  bool is_at_bore(const unsigned int cell) const { return cell / wall.around % wall.through == 0; }
  void add_volume(const std::vector<double> &factors, ContinuumVector &forces) const;
  void add_pressure(const double p, ContinuumVector &forces) const;
  void add_section(const unsigned int ring, const Motion &load, ContinuumVector &forces) const;

  const Scene &scene;
  const PipeWall &wall;
  const ContinuumBody<3> &body;
  std::vector<std::vector<std::pair<unsigned int, Motion>>> at_rings; ///< by load: ring, force
  // Of the mesh, for resultants; arms from the middle of the first section.
  std::vector<double> volume;        ///< of each pipe's metal [m3]
  std::vector<Vector3> first_moment; ///< integrals of the arm over it [m4]
  Vector3 bore;                      ///< of the normal out of the wall over the bore [m2]
  Vector3 turn_of_bore;              ///< of arm x normal [m3]
};

} // namespace frictionbeam
