// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "model/line/linear_part.h"

namespace frictionbeam {

class LineCells;

/// What an analysis sees of a line: of the scene as it was read (LineModel), or of one on fewer
/// unknowns (ReducedLine), which share its first three and the cells.
struct Model {
  const Scene &scene;
  const LineMesh &mesh;
  const Discretization &discretization;
  const ReducedSpace &space;
  const Contacts &contacts;
  const LinearPart &linear;
  const LineCells &cells; ///< of all degrees of freedom
};

} // namespace frictionbeam
