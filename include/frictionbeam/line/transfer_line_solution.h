// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/line/law_point_data.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <utility>
#include <vector>

namespace frictionbeam {

/**
 * Carries solutions of a line, and the states of its laws, over a refinement. It is used as
 * dealii::SolutionTransfer is, which these elements refuse:
 * @code
 *   triangulation.prepare_coarsening_and_refinement();
 *   LineSolutionTransfer transfer(dof_handler);
 *   transfer.prepare({&u, &v}, &points);
 *   triangulation.execute_coarsening_and_refinement();
 *   dof_handler.distribute_dofs(fes);
 *   std::vector<Vector<double>> on_new_mesh = transfer.interpolate();
 *   points = transfer.interpolate_points();
 * @endcode
 * A new vertex gets the displacement and rotation that its parent cell has there. Children have
 * their parent's material, so that all a cell can represent is carried over exactly: rigid motions,
 * linear stretch and twist, the bending of a beam under end loads with its shear. Where children
 * are taken away, what their common vertex has is lost. Other elements of an FESystem go over by
 * their own matrices. A law's point gets the state of the nearest one it comes from, which stays a
 * state that the law can have.
 */
class LineSolutionTransfer {
public:
  explicit LineSolutionTransfer(const dealii::DoFHandler<1, 3> &dof_handler);

  /**
   * Before the refinement, after prepare_coarsening_and_refinement().
   * @param points may be null
   * @throws dealii::ExcMessage if an arc or a friction element is to be refined or coarsened: the
   * one is exact in one cell, the other is one contact; if a manifold puts the new vertex off the
   * cell, which is straight; if there are artificial cells
   */
  void prepare(const std::vector<const dealii::Vector<double> *> &vectors,
               const LawPointData *points = nullptr);

  /// After the refinement and distribute_dofs(): the vectors, in their order.
  std::vector<dealii::Vector<double>> interpolate() const;
  /// The states. @throws dealii::ExcMessage if prepare() was given none
  LawPointData interpolate_points() const;

private:
  using Key = std::pair<int, int>; ///< level and index of a cell
  /// A point's place on its cell or parent, and what it knows.
  struct Place {
    double xi;
    LawPoint committed, trial;
  };
  struct Stored {
    unsigned int fe_index;
    std::vector<dealii::Vector<double>> values; ///< of the cell's dofs, for each vector
    std::vector<Place> points;
  };

  Stored store(const LineCellIterator &cell,
               const std::vector<const dealii::Vector<double> *> &vectors,
               const LawPointData *points) const;
  /// On the parent of two cells that go.
  Stored join(const std::vector<Stored> &children) const;
  /// Values on a child of the cell that they are of.
  dealii::Vector<double> on_child(const dealii::Triangulation<1, 3>::cell_iterator &parent,
                                  const unsigned int child, const dealii::FiniteElement<1, 3> &fe,
                                  const dealii::Vector<double> &values) const;

  const dealii::DoFHandler<1, 3> &dof_handler;
  std::map<Key, Stored> cells; ///< that will be there or have children
  unsigned int n_vectors = 0;
  unsigned int n_points_of_beams = 0;
  bool has_points = false;
};

/**
 * All of the above in one call: refine and coarsen as cells are flagged, distribute the degrees of
 * freedom again, and carry @p vectors and @p points over. Constraints, matrices and what belongs to
 * other handlers of the triangulation are yours to make anew.
 * @throws dealii::ExcMessage as LineSolutionTransfer::prepare(), and the mesh is as it was
 */
void transfer_line_solution(dealii::Triangulation<1, 3> &triangulation,
                            dealii::DoFHandler<1, 3> &dof_handler,
                            const std::vector<dealii::Vector<double> *> &vectors,
                            LawPointData *points = nullptr);

} // namespace frictionbeam
