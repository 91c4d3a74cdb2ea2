// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line/linear_part.h"

namespace frictionbeam {

class CorotationalLine;

/// What an analysis sees of a line: of the scene as it was read (LineModel), or of one on fewer
/// unknowns (ReducedLine), which share its first three.
struct Model {
  const Scene &scene;
  const LineMesh &mesh;
  const Discretization &discretization;
  const ReducedSpace &space;
  const Contacts &contacts;
  const LinearPart &linear;
  const CorotationalLine *corotational = nullptr; ///< null in linear kinematics
};

} // namespace frictionbeam
