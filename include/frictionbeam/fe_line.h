// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/fe/fe.h>

#include <array>
#include <functional>

namespace frictionbeam {

/**
 * Base of the finite elements on straight lines in space, with three displacements and three
 * rotations as components (ux, uy, uz, rx, ry, rz; global axes) and all degrees of freedom at the
 * two vertices. Its shape functions are vector-valued in every component (non-primitive) and depend
 * on the cell's tangent and length, which FEValues hands in with the cell.
 *
 * Limits, all of deal.II 9.4 with non-primitive elements: no
 * VectorTools::interpolate_boundary_values (use VertexDofs::constrain()), no
 * DoFTools::map_dofs_to_support_points; second derivatives are not offered; FEValues views return
 * only the first component (use generalized_strain()).
 *
 * What would be wrong silently is refused with a message, in debug and in release:
 *  - SolutionTransfer and all else that takes matrices from a cell to its children: they depend on
 *    the cell (use transfer_line_solution());
 *  - VectorTools::interpolate, since there are no support points (set values at vertices by
 *    VertexDofs::index());
 *  - a mapping that curves the cell, along a manifold of the triangulation: these lines are
 * straight (use MappingQ1, or FE_ArcBeam for a bend).
 */
class FE_Line : public dealii::FiniteElement<1, 3> {
public:
  static constexpr unsigned int n_line_components = 6;

  dealii::UpdateFlags requires_update_flags(const dealii::UpdateFlags flags) const override;

  std::vector<std::pair<unsigned int, unsigned int>>
  hp_vertex_dof_identities(const dealii::FiniteElement<1, 3> &other) const override;
  std::vector<std::pair<unsigned int, unsigned int>>
  hp_line_dof_identities(const dealii::FiniteElement<1, 3> &other) const override;
  bool hp_constraints_are_implemented() const override { return true; }
  /**
   * At a vertex (@p codim 1) the element with more unknowns dominates: DoFHandler of deal.II 9.4
   * joins every element there to the dominating one and to no other, so if that were a friction
   * element with three unknowns, the rotations of an arc and of a straight beam beside it would
   * come apart. On a cell (@p codim 0) the smaller space dominates, as everywhere in deal.II.
   * FE_Nothing belongs behind these elements in the collection if it was made to dominate.
   */
  dealii::FiniteElementDomination::Domination
  compare_for_domination(const dealii::FiniteElement<1, 3> &other,
                         const unsigned int codim = 0) const override;

  /// @throws dealii::ExcMessage always: see above
  const dealii::FullMatrix<double> &
  get_prolongation_matrix(const unsigned int child,
                          const dealii::RefinementCase<1> &refinement_case =
                              dealii::RefinementCase<1>::isotropic_refinement) const override;
  const dealii::FullMatrix<double> &
  get_restriction_matrix(const unsigned int child,
                         const dealii::RefinementCase<1> &refinement_case =
                             dealii::RefinementCase<1>::isotropic_refinement) const override;
  void convert_generalized_support_point_values_to_dof_values(
      const std::vector<dealii::Vector<double>> &support_point_values,
      std::vector<double> &nodal_values) const override;

protected:
  /// Geometry of one cell, as the shape functions need it.
  struct CellGeometry {
    dealii::Tensor<1, 3> tangent; ///< unit vector from the first to the second vertex
    double length;                ///< [m]
    unsigned int material_id;
    dealii::Point<3> begin, end; ///< its vertices
  };

  /// Six components of one shape function, and their derivatives along the line [1/m].
  struct ShapeFunction {
    std::array<double, n_line_components> value{};
    std::array<double, n_line_components> derivative{};
  };

  explicit FE_Line(const unsigned int dofs_per_vertex);

  /// All shape functions at the point xi in [0, 1] of a cell; @p shapes arrives zeroed.
  virtual void evaluate(const CellGeometry &cell, const double xi,
                        std::vector<ShapeFunction> &shapes) const = 0;

  using TakeShapes =
      std::function<void(const unsigned int point, const std::vector<ShapeFunction> &shapes)>;
  /// The same at many points of a cell, one after the other, for elements whose points have much in
  /// common.
  virtual void evaluate_all(const CellGeometry &cell, const std::vector<dealii::Point<1>> &points,
                            const TakeShapes &take) const;

private:
  using Cell = dealii::Triangulation<1, 3>::cell_iterator;
  using MappingData = dealii::Mapping<1, 3>::InternalDataBase;
  using MappingOutput = dealii::internal::FEValuesImplementation::MappingRelatedData<1, 3>;
  using ElementOutput = dealii::internal::FEValuesImplementation::FiniteElementRelatedData<1, 3>;

  std::unique_ptr<InternalDataBase> get_data(const dealii::UpdateFlags flags,
                                             const dealii::Mapping<1, 3> &mapping,
                                             const dealii::Quadrature<1> &quadrature,
                                             ElementOutput &output) const override;
  using dealii::FiniteElement<1, 3>::get_face_data;
  using dealii::FiniteElement<1, 3>::fill_fe_face_values;

  void fill_fe_values(const Cell &cell, const dealii::CellSimilarity::Similarity,
                      const dealii::Quadrature<1> &quadrature, const dealii::Mapping<1, 3> &,
                      const MappingData &, const MappingOutput &,
                      const InternalDataBase &fe_internal, ElementOutput &output) const override;
  void fill_fe_face_values(const Cell &cell, const unsigned int face,
                           const dealii::hp::QCollection<0> &quadrature,
                           const dealii::Mapping<1, 3> &, const MappingData &,
                           const MappingOutput &, const InternalDataBase &fe_internal,
                           ElementOutput &output) const override;
  void fill_fe_subface_values(const Cell &, const unsigned int, const unsigned int,
                              const dealii::Quadrature<0> &, const dealii::Mapping<1, 3> &,
                              const MappingData &, const MappingOutput &, const InternalDataBase &,
                              ElementOutput &) const override;

  /// @throws dealii::ExcMessage if the mapping's lengths or points are not those of a straight cell
  void check_straight(const Cell &cell, const dealii::Quadrature<1> &quadrature,
                      const MappingOutput &mapping_output) const;

  /// Fill row blocks of quadrature points with the shape functions at @p points.
  void fill_points(const Cell &cell, const std::vector<dealii::Point<1>> &points,
                   const InternalDataBase &fe_internal, ElementOutput &output) const;
};

/// The line in a finite element, which is one itself or an FESystem of one and others.
struct LinePart {
  const FE_Line *element = nullptr; ///< null if there is none
  unsigned int base = 0;            ///< base element of the FESystem
  unsigned int first_component = 0; ///< of its six
  /// Degrees of freedom of a cell that are the line's, in its order.
  std::vector<unsigned int> dofs;
};

/**
 * Find it.
 * @throws dealii::ExcMessage if an FESystem has several lines, or has another FESystem as base
 * element, where a line is not looked for
 */
LinePart line_part(const dealii::FiniteElement<1, 3> &fe);

} // namespace frictionbeam
