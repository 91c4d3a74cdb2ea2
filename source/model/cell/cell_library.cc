// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/cell/corotational_cells.h"
#include "model/cell/linear_cells.h"

namespace frictionbeam {

std::unique_ptr<const LineCells> make_line_cells(const Scene &scene, const LineMesh &mesh,
                                                 const Discretization &discretization,
                                                 const ReducedSpace &space,
                                                 const LinearPart &linear) {
  if (scene.kinematics == Kinematics::corotational)
    return std::make_unique<const CorotationalCells>(scene, mesh, discretization, space, linear);
  return std::make_unique<const LinearCells>(scene, mesh, discretization, space, linear);
}

} // namespace frictionbeam
