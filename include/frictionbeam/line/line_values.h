// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/fe_arc_beam.h>
#include <frictionbeam/fe_line.h>
#include <frictionbeam/generalized_strain.h>
#include <frictionbeam/law.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/hp/fe_values.h>

#include <memory>
#include <vector>

namespace frictionbeam {

/// A cell with its degrees of freedom.
using LineCellIterator = dealii::DoFHandler<1, 3>::active_cell_iterator;

/**
 * Gauss points of a line's cell: one for a friction element, @p n_points for a straight beam,
 * at least 12 for an arc, whose functions are no polynomials.
 * @param n_points 0: two, which are exact for the stiffness of a beam whose section is elastic
 */
dealii::Quadrature<1> line_quadrature(const dealii::FiniteElement<1, 3> &fe,
                                      const unsigned int n_points = 0);

/**
 * Values of the shape functions of a line at the points of a cell, as FEValues gives them for other
 * elements: generalized strains and motions, weights along the line. Straight cells, arcs and
 * friction elements answer alike, alone, in an hp collection, or in an FESystem, whose other
 * unknowns have none.
 *
 * A copy is an object of its own: one for each thread.
 */
class LineValues {
public:
  /// @param n_points as of line_quadrature()
  explicit LineValues(const dealii::hp::FECollection<1, 3> &fes, const unsigned int n_points = 0);
  /// The same points xi in [0, 1] on all cells, which have weights only if @p quadrature has.
  LineValues(const dealii::hp::FECollection<1, 3> &fes, const dealii::Quadrature<1> &quadrature);

  LineValues(const LineValues &other);

  /**
   * Go to a cell.
   * @throws dealii::ExcMessage as line_part() and FE_ArcBeam::arc()
   */
  void reinit(const LineCellIterator &cell);

  /// False where the cell's element is no line, FE_Nothing for instance. All else is for lines.
  bool has_line() const { return part->element != nullptr; }
  /// Which laws belong to it: `support` to a friction element, `section` to beams and arcs.
  LawKind kind() const;

  unsigned int n_points() const { return fe_values->n_quadrature_points; }
  unsigned int n_dofs() const { return fe_values->dofs_per_cell; }
  double length() const { return arc ? arc->length() : chord; } ///< along the line [m]
  /// Of a point from the first vertex (0) to the second (1), along the line.
  double xi(const unsigned int q) const { return fe_values->get_quadrature().point(q)[0]; }
  double JxW(const unsigned int q) const { return fe_values->JxW(q) * length() / chord; } ///< [m]
  dealii::Point<3> point(const unsigned int q) const { return point_at(xi(q)); }
  const LocalAxes &axes(const unsigned int q) const { return axes_at[q]; }

  /// Generalized strain of shape function @p i, of the cell's dofs.
  const GeneralizedStrain &strain(const unsigned int i, const unsigned int q) const {
    return strains[n_dofs() * q + i];
  }
  /// Displacement and rotation (ux, uy, uz, rx, ry, rz) of shape function @p i, global axes.
  const dealii::Tensor<1, 6> &motion(const unsigned int i, const unsigned int q) const {
    return motions[n_dofs() * q + i];
  }

  /// Places of the line's degrees of freedom among those of the cell: its first vertex's, then its
  /// second's.
  const std::vector<unsigned int> &line_dofs() const { return part->dofs; }
  /// Not null on an arc.
  const ArcBeam *arc_beam() const { return arc ? &*arc : nullptr; }

  /// Anywhere on the cell, whatever the points are.
  dealii::Point<3> point_at(const double xi) const;
  LocalAxes local_axes(const double xi) const;

private:
  LineValues(const dealii::hp::FECollection<1, 3> &fes,
             const dealii::hp::QCollection<1> &quadratures);

  std::vector<LinePart> parts; ///< by element of the collection
  dealii::hp::FEValues<1, 3> hp_values;
  const dealii::FEValues<1, 3> *fe_values = nullptr;
  const LinePart *part = nullptr;
  dealii::Point<3> begin, end;
  double chord = 0.;
  std::unique_ptr<ArcBeam> arc;
  std::vector<LocalAxes> axes_at;
  std::vector<GeneralizedStrain> strains;
  std::vector<dealii::Tensor<1, 6>> motions;
};

} // namespace frictionbeam
