// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/sequence/load_sequence.h"
#include "analysis/substructure/wall_stretch.h"
#include "results/results.h"

namespace frictionbeam {

/// The solid parts of a mixed model: what the line takes of them, and what they show when it is
/// solved. None of another model.
class MixedWalls {
public:
  /// @throws UserError for stretches whose wall cannot be meshed, and under mpirun
  MixedWalls(const Scene &scene, const LineMesh &mesh);

  /// Factors each wall's stiffness.
  std::vector<SolidPart> superelements();
  /// Displacement, stress and ovality of the walls at the ends of the steps that the line has
  /// reached, into folders of their own and into the report; with the largest of them.
  void report(const LoadSequence &sequence, Results &results);
  /// Which bends are solid and how large their walls are, a line each.
  std::vector<std::string> in_words() const;

private:
  /// Make the error that cells leave that of the walls, if it is larger.
  void add_to(KnownError &cells) const;

  const Scene &scene;
  std::vector<std::unique_ptr<WallStretch>> walls;
  std::vector<SolidPart> parts; ///< beside them, without their matrices
};

} // namespace frictionbeam
