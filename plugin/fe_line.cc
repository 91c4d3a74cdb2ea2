// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_line.h>

#include <deal.II/hp/q_collection.h>

#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

struct LineData : public FiniteElement<1, 3>::InternalDataBase {};

std::string no_matrices(const std::string &name) {
  return "\n  read:    matrices between a cell and its children asked of " + name +
         " (by SolutionTransfer, or multigrid)"
         "\n  allowed: elements whose matrices are the same for all cells; a line's depend on the "
         "cell's direction, length and section"
         "\n  try:     transfer_line_solution() of frictionbeam/line/transfer_line_solution.h\n";
}

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

const FullMatrix<double> &FE_Line::get_prolongation_matrix(const unsigned int,
                                                           const RefinementCase<1> &) const {
  AssertThrow(false, ExcMessage(no_matrices(get_name())));
  return prolongation[0][0];
}

const FullMatrix<double> &FE_Line::get_restriction_matrix(const unsigned int,
                                                          const RefinementCase<1> &) const {
  AssertThrow(false, ExcMessage(no_matrices(get_name())));
  return restriction[0][0];
}

void FE_Line::convert_generalized_support_point_values_to_dof_values(
    const std::vector<Vector<double>> &, std::vector<double> &) const {
  AssertThrow(false,
              ExcMessage("\n  read:    VectorTools::interpolate with " + get_name() +
                         "\n  allowed: elements with support points"
                         "\n  try:     values at the vertices, by VertexDofs::index(); after "
                         "refinement transfer_line_solution()\n"));
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

void FE_Line::evaluate_all(const CellGeometry &cell, const std::vector<Point<1>> &points,
                           const TakeShapes &take) const {
  std::vector<ShapeFunction> shapes;
  for (unsigned int q = 0; q < points.size(); ++q) {
    shapes.assign(n_dofs_per_cell(), ShapeFunction());
    evaluate(cell, points[q][0], shapes);
    take(q, shapes);
  }
}

void FE_Line::fill_points(const Cell &cell, const std::vector<Point<1>> &points,
                          const InternalDataBase &fe_internal, ElementOutput &output) const {
  const Tensor<1, 3> axis = cell->vertex(1) - cell->vertex(0);
  const double length = axis.norm();
  const CellGeometry geometry{axis / length, length, cell->material_id(), cell->vertex(0),
                              cell->vertex(1)};
  evaluate_all(geometry, points,
               [&](const unsigned int q, const std::vector<ShapeFunction> &shapes) {
                 for (unsigned int i = 0, row = 0; i < shapes.size(); ++i)
                   for (unsigned int c = 0; c < n_line_components; ++c, ++row) {
                     if (fe_internal.update_each & update_values)
                       output.shape_values[row][q] = shapes[i].value[c];
                     if (fe_internal.update_each & update_gradients)
                       output.shape_gradients[row][q] = shapes[i].derivative[c] * geometry.tangent;
                   }
               });
}

void FE_Line::check_straight(const Cell &cell, const Quadrature<1> &quadrature,
                             const MappingOutput &mapping_output) const {
  const Tensor<1, 3> axis = cell->vertex(1) - cell->vertex(0);
  const double length = axis.norm();
  AssertThrow(length > 0., ExcMessage("\n  read:    " + get_name() + " on a cell of length " +
                                      std::to_string(length) + ", from vertex " +
                                      std::to_string(cell->vertex_index(0)) + " to " +
                                      std::to_string(cell->vertex_index(1)) +
                                      "\n  allowed: a length above zero"
                                      "\n  try:     one vertex in place of two\n"));
  bool is_straight = true; // points without weights compare as straight: their JxW is no number
  for (unsigned int q = 0; q < mapping_output.JxW_values.size(); ++q)
    if (std::abs(mapping_output.JxW_values[q] - quadrature.weight(q) * length) >
        1e-6 * std::abs(quadrature.weight(q)) * length)
      is_straight = false;
  for (unsigned int q = 0; q < mapping_output.quadrature_points.size(); ++q)
    if ((mapping_output.quadrature_points[q] - cell->vertex(0) - quadrature.point(q)[0] * axis)
            .norm() > 1e-6 * length)
      is_straight = false;
  AssertThrow(is_straight,
              ExcMessage("\n  read:    " + get_name() +
                         " on a cell that its mapping curves, along a manifold of the triangulation"
                         "\n  allowed: straight cells"
                         "\n  try:     MappingQ1, which takes cells as straight between their "
                         "vertices; for a bend FE_ArcBeam; or "
                         "triangulation.reset_all_manifolds()\n"));
}

void FE_Line::fill_fe_values(const Cell &cell, const CellSimilarity::Similarity,
                             const Quadrature<1> &quadrature, const Mapping<1, 3> &,
                             const MappingData &, const MappingOutput &mapping_output,
                             const InternalDataBase &fe_internal, ElementOutput &output) const {
  check_straight(cell, quadrature, mapping_output);
  fill_points(cell, quadrature.get_points(), fe_internal, output);
}

void FE_Line::fill_fe_face_values(const Cell &cell, const unsigned int face,
                                  const hp::QCollection<0> &, const Mapping<1, 3> &,
                                  const MappingData &, const MappingOutput &,
                                  const InternalDataBase &fe_internal,
                                  ElementOutput &output) const {
  fill_points(cell, {Point<1>(face)}, fe_internal, output);
}

void FE_Line::fill_fe_subface_values(const Cell &, const unsigned int, const unsigned int,
                                     const Quadrature<0> &, const Mapping<1, 3> &,
                                     const MappingData &, const MappingOutput &,
                                     const InternalDataBase &, ElementOutput &) const {
  AssertThrow(false, ExcMessage("A line's faces are vertices and have no sub-faces."));
}

LinePart line_part(const FiniteElement<1, 3> &fe) {
  LinePart part;
  for (unsigned int base = 0, component = 0; base < fe.n_base_elements(); ++base) {
    const FiniteElement<1, 3> &element = fe.base_element(base);
    const unsigned int times = fe.element_multiplicity(base);
    const auto *const line = dynamic_cast<const FE_Line *>(&element);
    AssertThrow(line == nullptr || (part.element == nullptr && times == 1),
                ExcMessage("\n  read:    " + fe.get_name() +
                           "\n  allowed: one line in an FESystem, once"
                           "\n  try:     a DoFHandler for each\n"));
    AssertThrow(element.n_base_elements() == 1 || element.n_base_elements() == 0 || line != nullptr,
                ExcMessage("\n  read:    an FESystem in an FESystem, " + fe.get_name() +
                           "\n  allowed: elements that are no systems"
                           "\n  try:     one FESystem of all of them\n"));
    if (line != nullptr) {
      part.element = line;
      part.base = base;
      part.first_component = component;
    }
    component += element.n_components() * times;
  }
  if (part.element == nullptr)
    return part;
  part.dofs.resize(part.element->n_dofs_per_cell());
  for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
    if (const auto place = fe.system_to_base_index(i); place.first.first == part.base)
      part.dofs[place.second] = i;
  return part;
}

} // namespace frictionbeam
