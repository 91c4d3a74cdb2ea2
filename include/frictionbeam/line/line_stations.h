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
  GeneralizedStress at(const double xi) const;

private:
  const LineValues &values;
  const dealii::Tensor<1, 3> line_force;
  dealii::Tensor<1, 3> force, moment; ///< of the first node on the cell, global axes
  GeneralizedStress of_support;
};

/// What there is at a place of a line.
struct LineStation {
  double s = 0.; ///< along the line from the cell's first vertex [m]
  dealii::Point<3> point;
  dealii::Tensor<1, 3> displacement, rotation; ///< of the shape functions, global axes [m], [rad]
  /// Of the shape functions, free strains included: under a line force right in the cell's mean.
  GeneralizedStrain strain;
  GeneralizedStress force; ///< see SectionForces
};

/**
 * Stations at @p xi in [0, 1] of each cell: after assemble_line() of the solution, with the
 * increment that it had. One object serves all cells, in some 60 % of the time that line_stations()
 * takes for each; it must not outlive the dofs that @p dof_handler has now.
 * @code
 *   LineStations stations(dof_handler, points, increment);
 *   for (const auto &cell : dof_handler.active_cell_iterators())
 *     for (const LineStation &station : stations.on(cell, solution))
 * @endcode
 */
class LineStations {
public:
  LineStations(const dealii::DoFHandler<1, 3> &dof_handler, const LawPointData &points,
               const LineIncrement &increment, const std::vector<double> &xi = {0., 0.5, 1.});
  // Both are kept by reference.
  LineStations(const dealii::DoFHandler<1, 3> &, const LawPointData &, LineIncrement &&,
               const std::vector<double> & = {}) = delete;

  /// @param dof_values of the cell's dofs @return none if the cell has no line
  std::vector<LineStation> on_cell(const LineCellIterator &cell,
                                   const std::vector<double> &dof_values);
  /// @param solution any vector with operator[]
  template <typename SolutionType>
  std::vector<LineStation> on(const LineCellIterator &cell, const SolutionType &solution) {
    dofs.resize(cell->get_fe().n_dofs_per_cell());
    values_of_dofs.resize(dofs.size());
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      values_of_dofs[i] = solution[dofs[i]];
    return on_cell(cell, values_of_dofs);
  }

private:
  const LawPointData &points;
  const LineIncrement &increment;
  LineValues at_points, at_stations;
  std::vector<dealii::types::global_dof_index> dofs;
  std::vector<double> values_of_dofs;
};

/// Of one cell alone. @param dof_values of the cell's dofs
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
  return LineStations(cell->get_dof_handler(), points, increment, xi).on(cell, solution);
}

} // namespace frictionbeam
