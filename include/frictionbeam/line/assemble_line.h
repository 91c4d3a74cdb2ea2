// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/line/law_point_data.h>
#include <frictionbeam/line/line_material.h>
#include <frictionbeam/line/line_values.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <functional>

/**
 * @file
 * What the cells of a line add to the matrices and vectors of any deal.II program. A function that
 * ends in _cell does one cell, for loops of your own and for MeshWorker; the others go over the
 * locally owned cells of a DoFHandler and leave compress() to you. Cells without a line are
 * skipped.
 */
namespace frictionbeam {

/// The end of an increment: what a line is given there besides its displacement.
struct LineIncrement {
  double time = 0.;   ///< at the end [s]
  double length = 0.; ///< [s]; 0 in statics, laws then see no strain rate
  /// Which tangent the matrix is. See newton_tangent().
  LawTangent tangent = LawTangent::consistent;

  using Cell = LineCellIterator;
  using Point = dealii::Point<3>;
  /// Free strain of beams and arcs at a point, of heat for instance, {alpha T, 0, 0, 0, 0, 0}: the
  /// law is given what is left of the strain. Not of friction elements. None if empty.
  std::function<GeneralizedStrain(const Cell &, const Point &)> free_strain;
  /// Temperature that laws are given [degC]; 20 if empty.
  std::function<double(const Cell &, const Point &)> temperature;
  /// By how much it has changed in the increment [K], which creep of sections needs whose moduli
  /// fall with it; 0 if empty.
  std::function<double(const Cell &, const Point &)> temperature_change;
  /// Force on beams and arcs per length [N/m], global axes, constant along a cell. None if empty.
  std::function<dealii::Tensor<1, 3>(const Cell &)> line_force;
};

/**
 * The tangent for an iterate of Newton's method: the elastic one for the first iterate of an
 * increment, the consistent one for the others. What rests on contacts alone has no stiffness
 * before they are closed, so that its first consistent tangent is singular; and where an increment
 * unloads, the last tangent of the one before is that of slip or of plastic flow, and sends the
 * iteration far off.
 * @param iteration from 0 in each increment
 */
inline LawTangent newton_tangent(const unsigned int iteration) {
  return iteration == 0 ? LawTangent::elastic : LawTangent::consistent;
}

/**
 * Ask the law at each point of a cell:
 *   residual = integral of (u . line_force - B^T stress),  tangent = integral of B^T C B,
 * u and B being motions and generalized strains of the shape functions, stress and C the law's
 * answer to the strain B dofs - free_strain.
 *
 * @param values on that cell, with the points of @p points
 * @param dof_values of the cell's dofs
 * @param points its trial is written, its committed state is what the law starts from
 * @param tangent,residual are set; the matrix is not touched if the increment asks for no tangent
 * @return failed if a law has no answer: repeat the increment in smaller ones
 * @throws dealii::ExcMessage as LawPointData, or if it was made for other laws or points
 */
[[nodiscard]] LawStatus assemble_line_cell(const LineValues &values, const LineCellIterator &cell,
                                           const LineMaterials &materials,
                                           const std::vector<double> &dof_values,
                                           const LineIncrement &increment, LawPointData &points,
                                           dealii::FullMatrix<double> &tangent,
                                           dealii::Vector<double> &residual);

/// Mass of a cell [kg, kg m, kg m2]. @param values with points enough: four, see LineValues
void assemble_line_mass_cell(const LineValues &values, const LineCellIterator &cell,
                             const LineMaterials &materials, dealii::FullMatrix<double> &mass);

/**
 * Add the line's tangent to @p tangent and its forces to @p residual, of the solution @p solution
 * at the end of an increment. With the other loads in @p residual, an iterate of Newton's method is
 *   solution += tangent^-1 residual.
 *
 * @param constraints of the update: homogeneous, but for a linear problem that is solved at once
 * from zero. Imposed motions belong into @p solution before. Without constraints (an empty object
 * that is closed) the residual has the reactions of what is held, with the opposite sign.
 * @param solution any vector with operator[] for the locally relevant dofs
 * @param points see assemble_line_cell(); commit() when the increment is accepted
 * @return failed if a law of this process's cells has no answer; matrix and vector are then
 * incomplete. Processes have to agree on it (Utilities::MPI::max).
 */
template <typename SolutionType, typename MatrixType, typename VectorType>
[[nodiscard]] LawStatus
assemble_line(const dealii::DoFHandler<1, 3> &dof_handler, const LineMaterials &materials,
              const SolutionType &solution, const LineIncrement &increment,
              const dealii::AffineConstraints<double> &constraints, LawPointData &points,
              MatrixType &tangent, VectorType &residual);

/// The residual alone; the increment's choice of tangent does not matter.
template <typename SolutionType, typename VectorType>
[[nodiscard]] LawStatus assemble_line(const dealii::DoFHandler<1, 3> &dof_handler,
                                      const LineMaterials &materials, const SolutionType &solution,
                                      const LineIncrement &increment,
                                      const dealii::AffineConstraints<double> &constraints,
                                      LawPointData &points, VectorType &residual);

/**
 * Add the elastic stiffness, at rest: that of linear statics and dynamics. Friction elements have
 * that of the closed, sticking contact.
 * @throws dealii::ExcMessage if a law has no answer at rest
 */
template <typename MatrixType>
void assemble_line_stiffness(const dealii::DoFHandler<1, 3> &dof_handler,
                             const LineMaterials &materials,
                             const dealii::AffineConstraints<double> &constraints,
                             MatrixType &stiffness);

/// Add the consistent mass.
template <typename MatrixType>
void assemble_line_mass(const dealii::DoFHandler<1, 3> &dof_handler, const LineMaterials &materials,
                        const dealii::AffineConstraints<double> &constraints, MatrixType &mass);

// Templates.
namespace line_detail {

/// Go over the locally owned lines: @p residual and then what @p add does with it.
template <typename SolutionType, typename Add>
LawStatus for_each_line(const dealii::DoFHandler<1, 3> &dof_handler, const LineMaterials &materials,
                        const SolutionType &solution, const LineIncrement &increment,
                        LawPointData &points, const Add &add) {
  LineValues values(dof_handler.get_fe_collection(), points.n_points());
  std::vector<dealii::types::global_dof_index> dofs;
  std::vector<double> dof_values;
  dealii::FullMatrix<double> tangent;
  dealii::Vector<double> residual;
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    values.reinit(cell);
    if (!values.has_line())
      continue;
    dofs.resize(values.n_dofs());
    dof_values.resize(values.n_dofs());
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      dof_values[i] = solution[dofs[i]];
    if (assemble_line_cell(values, cell, materials, dof_values, increment, points, tangent,
                           residual) != LawStatus::ok)
      return LawStatus::failed;
    add(dofs, tangent, residual);
  }
  return LawStatus::ok;
}

/// Zero for every dof.
struct NoDisplacement {
  double operator[](const dealii::types::global_dof_index) const { return 0.; }
};

} // namespace line_detail

template <typename SolutionType, typename MatrixType, typename VectorType>
LawStatus assemble_line(const dealii::DoFHandler<1, 3> &dof_handler, const LineMaterials &materials,
                        const SolutionType &solution, const LineIncrement &increment,
                        const dealii::AffineConstraints<double> &constraints, LawPointData &points,
                        MatrixType &tangent, VectorType &residual) {
  AssertThrow(increment.tangent != LawTangent::none,
              dealii::ExcMessage("\n  read:    an increment that asks for no tangent, and a matrix"
                                 "\n  allowed: LawTangent::elastic or consistent"
                                 "\n  try:     assemble_line() without the matrix\n"));
  return line_detail::for_each_line(
      dof_handler, materials, solution, increment, points,
      [&](const auto &dofs, const auto &cell_tangent, const auto &cell_residual) {
        constraints.distribute_local_to_global(cell_tangent, cell_residual, dofs, tangent,
                                               residual);
      });
}

template <typename SolutionType, typename VectorType>
LawStatus assemble_line(const dealii::DoFHandler<1, 3> &dof_handler, const LineMaterials &materials,
                        const SolutionType &solution, const LineIncrement &increment,
                        const dealii::AffineConstraints<double> &constraints, LawPointData &points,
                        VectorType &residual) {
  LineIncrement without(increment);
  without.tangent = LawTangent::none;
  return line_detail::for_each_line(dof_handler, materials, solution, without, points,
                                    [&](const auto &dofs, const auto &, const auto &cell_residual) {
                                      constraints.distribute_local_to_global(cell_residual, dofs,
                                                                             residual);
                                    });
}

template <typename MatrixType>
void assemble_line_stiffness(const dealii::DoFHandler<1, 3> &dof_handler,
                             const LineMaterials &materials,
                             const dealii::AffineConstraints<double> &constraints,
                             MatrixType &stiffness) {
  LawPointData points(dof_handler, materials);
  LineIncrement rest;
  rest.tangent = LawTangent::elastic;
  const LawStatus status =
      line_detail::for_each_line(dof_handler, materials, line_detail::NoDisplacement(), rest,
                                 points, [&](const auto &dofs, const auto &tangent, const auto &) {
                                   constraints.distribute_local_to_global(tangent, dofs, stiffness);
                                 });
  AssertThrow(status == LawStatus::ok,
              dealii::ExcMessage("\n  read:    a law that has no answer at rest"
                                 "\n  allowed: laws that have\n  try:     other parameters\n"));
}

template <typename MatrixType>
void assemble_line_mass(const dealii::DoFHandler<1, 3> &dof_handler, const LineMaterials &materials,
                        const dealii::AffineConstraints<double> &constraints, MatrixType &mass) {
  LineValues values(dof_handler.get_fe_collection(), 4);
  std::vector<dealii::types::global_dof_index> dofs;
  dealii::FullMatrix<double> cell_mass;
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    values.reinit(cell);
    if (!values.has_line())
      continue;
    assemble_line_mass_cell(values, cell, materials, cell_mass);
    dofs.resize(values.n_dofs());
    cell->get_dof_indices(dofs);
    constraints.distribute_local_to_global(cell_mass, dofs, mass);
  }
}

} // namespace frictionbeam
