// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/generalized_strain.h>
#include <frictionbeam/law.h>
#include <frictionbeam/line/line_material.h>
#include <frictionbeam/line/line_values.h>

#include <boost/serialization/vector.hpp>

#include <vector>

namespace frictionbeam {

/// What a law said last at a quadrature point. Supports have the first four strains and stresses.
struct LawPoint {
  GeneralizedStrain strain; ///< at the end of the increment, free strains taken off
  GeneralizedStress stress; ///< [N] and [N m], see LawKind
  std::vector<double> internal_variables;
  double dissipation = 0.; ///< since the beginning [J/m]
  ContactStatus contact = ContactStatus::none;

  template <class Archive>
  void serialize(Archive &archive, const unsigned int) {
    archive &strain &stress &internal_variables &dissipation &contact;
  }
};

/**
 * The states of all points of a line: committed, at the end of the last accepted increment, and of
 * the trial that assemble_line() writes. An increment that fails is repeated from the committed
 * ones, which nothing but commit() writes.
 *
 * The points are those of line_quadrature(), of cells that are not artificial. Cells are told apart
 * by active_cell_index(), so after refinement the object is made anew, or carried over by
 * transfer_line_solution().
 *
 * It goes into archives of boost, both states; an archive is for the same mesh and laws.
 */
class LawPointData {
public:
  LawPointData() = default;
  /**
   * Zero states.
   * @param n_points of straight beams, see line_quadrature(); a section that is not elastic may
   * want more than two
   * @throws dealii::ExcMessage as material_of(), line_part() and VertexDofs
   */
  LawPointData(const dealii::DoFHandler<1, 3> &dof_handler, const LineMaterials &materials,
               const unsigned int n_points = 0);

  /// As it was asked for.
  unsigned int n_points() const { return n_points_of_beams; }

  const std::vector<LawPoint> &committed(const LineCellIterator &cell) const {
    return committed_points[place(cell)];
  }
  const std::vector<LawPoint> &trial(const LineCellIterator &cell) const {
    return trial_points[place(cell)];
  }
  std::vector<LawPoint> &trial(const LineCellIterator &cell) { return trial_points[place(cell)]; }

  /// Accept the increment: the trial is committed.
  void commit() { committed_points = trial_points; }
  /// Give it up: the trial is what was committed.
  void roll_back() { trial_points = committed_points; }

  template <class Archive>
  void serialize(Archive &archive, const unsigned int) {
    archive &n_points_of_beams &committed_points &trial_points;
  }

private:
  friend class LineSolutionTransfer;

  /// @throws dealii::ExcMessage if this was made for another mesh
  std::size_t place(const LineCellIterator &cell) const;

  unsigned int n_points_of_beams = 0;
  std::vector<std::vector<LawPoint>> committed_points, trial_points; ///< by active cell
};

} // namespace frictionbeam
