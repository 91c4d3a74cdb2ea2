// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam::accuracy {

/// Supports whose pipe's wall gives way to their force.
struct ElasticSupports {
  std::vector<std::string> settings; ///< that make them as elastic as the wall, as follow --set
  std::vector<std::string> unknown;  ///< what cannot be judged, in words
};

/**
 * What a rigid support pushes into a pipe's wall, as the elasticity of the support: the mean motion
 * of the section per force on a patch of 30 degrees and Width along the pipe is
 * 6.8 (r/(10 t))^1.65 (Width/D)^-0.3/(E t), measured for r/t from 10 to 50 and widths of half, one
 * and two diameters (doc/solid.md) on a pipe between two anchors. Of rests, guides and stops across
 * the pipe with Coulomb's law and no rigidity of their own; the softest place of each counts.
 */
ElasticSupports elastic_supports(const Scene &scene);

} // namespace frictionbeam::accuracy
