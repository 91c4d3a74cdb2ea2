// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_line.h>

#include <deal.II/hp/q_collection.h>

namespace frictionbeam {

using namespace dealii;

namespace {

struct LineData : public FiniteElement<1, 3>::InternalDataBase {};

} // namespace

FE_Line::FE_Line(const unsigned int dofs_per_vertex)
    : FiniteElement<1, 3>(FiniteElementData<1>({dofs_per_vertex, 0}, n_line_components, 3,
                                               FiniteElementData<1>::H1),
                          std::vector<bool>(2 * dofs_per_vertex, false),
                          std::vector<ComponentMask>(2 * dofs_per_vertex,
                                                     ComponentMask(n_line_components, true))) {}

UpdateFlags FE_Line::requires_update_flags(const UpdateFlags flags) const { return flags; }

std::vector<std::pair<unsigned int, unsigned int>>
FE_Line::hp_vertex_dof_identities(const FiniteElement<1, 3> &other) const {
  std::vector<std::pair<unsigned int, unsigned int>> identities;
  const unsigned int common = std::min(n_dofs_per_vertex(), other.n_dofs_per_vertex());
  for (unsigned int i = 0; i < common; ++i)
    identities.emplace_back(i, i);
  return identities;
}

std::vector<std::pair<unsigned int, unsigned int>>
FE_Line::hp_line_dof_identities(const FiniteElement<1, 3> &) const {
  return {};
}

FiniteElementDomination::Domination
FE_Line::compare_for_domination(const FiniteElement<1, 3> &other, const unsigned int codim) const {
  const unsigned int own = n_dofs_per_vertex(), others = other.n_dofs_per_vertex();
  if (own == others)
    return FiniteElementDomination::either_element_can_dominate;
  const bool more = own > others;
  // DoFHandler joins all elements at a vertex to the dominating one, each by its identities with
  // that one alone: only one that has every unknown there joins them all.
  return (codim == 0 ? !more : more) ? FiniteElementDomination::this_element_dominates
                                     : FiniteElementDomination::other_element_dominates;
}

std::unique_ptr<FiniteElement<1, 3>::InternalDataBase> FE_Line::get_data(const UpdateFlags flags,
                                                                         const Mapping<1, 3> &,
                                                                         const Quadrature<1> &,
                                                                         ElementOutput &) const {
  AssertThrow(!(flags & (update_hessians | update_3rd_derivatives)),
              ExcMessage(get_name() +
                         " offers values and gradients of its shape functions, no "
                         "second derivatives; curvatures are strains of the rotations, "
                         "see generalized_strain()."));
  auto data = std::make_unique<LineData>();
  data->update_each = flags;
  return data;
}

void FE_Line::fill_point(const Cell &cell, const double xi, const unsigned int q,
                         const InternalDataBase &fe_internal, ElementOutput &output) const {
  const Tensor<1, 3> axis = cell->vertex(1) - cell->vertex(0);
  const double length = axis.norm();
  const CellGeometry geometry{axis / length, length, cell->material_id(), cell->vertex(0),
                              cell->vertex(1)};

  std::vector<ShapeFunction> shapes(n_dofs_per_cell());
  evaluate(geometry, xi, shapes);

  for (unsigned int i = 0, row = 0; i < shapes.size(); ++i)
    for (unsigned int c = 0; c < n_line_components; ++c, ++row) {
      if (fe_internal.update_each & update_values)
        output.shape_values[row][q] = shapes[i].value[c];
      if (fe_internal.update_each & update_gradients)
        output.shape_gradients[row][q] = shapes[i].derivative[c] * geometry.tangent;
    }
}

void FE_Line::fill_fe_values(const Cell &cell, const CellSimilarity::Similarity,
                             const Quadrature<1> &quadrature, const Mapping<1, 3> &,
                             const MappingData &, const MappingOutput &,
                             const InternalDataBase &fe_internal, ElementOutput &output) const {
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    fill_point(cell, quadrature.point(q)[0], q, fe_internal, output);
}

void FE_Line::fill_fe_face_values(const Cell &cell, const unsigned int face,
                                  const hp::QCollection<0> &, const Mapping<1, 3> &,
                                  const MappingData &, const MappingOutput &,
                                  const InternalDataBase &fe_internal,
                                  ElementOutput &output) const {
  fill_point(cell, face, 0, fe_internal, output);
}

void FE_Line::fill_fe_subface_values(const Cell &, const unsigned int, const unsigned int,
                                     const Quadrature<0> &, const Mapping<1, 3> &,
                                     const MappingData &, const MappingOutput &,
                                     const InternalDataBase &, ElementOutput &) const {
  AssertThrow(false, ExcMessage("A line's faces are vertices and have no sub-faces."));
}

} // namespace frictionbeam
