// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/line/assemble_line.h>

#include <vector>

namespace frictionbeam {

/**
 * Section forces of a cell, N, V_y, V_z [N], M_x, M_y, M_z [N m] in the local axes of each place,
 * of the part beyond on the part before.
 *
 * On beams and arcs they follow by equilibrium from what the cell's first node puts into it: its
 * internal forces, by the stresses that laws said last (LawPointData::trial()), less its share of
 * the line force. So they are exact between the nodes where those at the nodes are, under a line
 * force, too, which the cell's own strains know only in the mean: one cell under q shows q L^2/8 in
 * its middle. Of a friction element they are its law's N, T_y, T_z, M_x, and zero.
 */
class SectionForces {
public:
  /**
   * @param values on the cell, with the points of @p points
   * @param line_force on the cell [N/m], as it was assembled
   */
  SectionForces(const LineValues &values, const LineCellIterator &cell, const LawPointData &points,
                const dealii::Tensor<1, 3> &line_force = {});

  /// @param xi from the first vertex, 0, to the second, 1
  GeneralizedStrain at(const double xi) const;

private:
  const LineValues &values;
  const dealii::Tensor<1, 3> line_force;
  dealii::Tensor<1, 3> force, moment; ///< of the first node on the cell, global axes
  GeneralizedStrain of_support;
};

/// What there is at a place of a line.
struct LineStation {
  double s = 0.; ///< along the line from the cell's first vertex [m]
  dealii::Point<3> point;
  dealii::Tensor<1, 3> displacement, rotation; ///< of the shape functions, global axes [m], [rad]
  /// Of the shape functions, free strains included: under a line force right in the cell's mean.
  GeneralizedStrain strain;
  GeneralizedStrain force; ///< see SectionForces
};

/**
 * Stations of a cell, at @p xi in [0, 1]: after assemble_line() of the solution, with the increment
 * that it had.
 * @param dof_values of the cell's dofs
 * @return none if the cell has no line
 */
std::vector<LineStation> line_stations_cell(const LineCellIterator &cell,
                                            const std::vector<double> &dof_values,
                                            const LawPointData &points,
                                            const LineIncrement &increment,
                                            const std::vector<double> &xi);

/// The same from a solution. @param solution any vector with operator[]
template <typename SolutionType>
std::vector<LineStation> line_stations(const LineCellIterator &cell, const SolutionType &solution,
                                       const LawPointData &points, const LineIncrement &increment,
                                       const std::vector<double> &xi = {0., 0.5, 1.}) {
  std::vector<dealii::types::global_dof_index> dofs(cell->get_fe().n_dofs_per_cell());
  std::vector<double> dof_values(dofs.size());
  cell->get_dof_indices(dofs);
  for (unsigned int i = 0; i < dofs.size(); ++i)
    dof_values[i] = solution[dofs[i]];
  return line_stations_cell(cell, dof_values, points, increment, xi);
}

} // namespace frictionbeam
