// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/line/law_point_data.h>

#include <frictionbeam/vertex_dofs.h>

#include <array>
#include <string>

namespace frictionbeam {

using namespace dealii;

namespace {

std::string name_of(const LawKind kind) { return kind == LawKind::support ? "support" : "section"; }

std::string known_ids(const LineMaterials &materials) {
  std::string ids;
  for (const auto &[id, material] : materials)
    ids += (ids.empty() ? "" : ", ") + std::to_string(id);
  return ids.empty() ? "none" : ids;
}

/// N, V_y, V_z, M_x, M_y, M_z by the strain of the same place [N], [N m2].
std::array<double, 6> elastic_diagonal(const BoundLaw &section) {
  const BoundLaw::Answer answer =
      section.answer_at_rest(std::vector<double>(6, 0.), 1., LawTangent::elastic, 20.);
  std::array<double, 6> diagonal;
  for (unsigned int s = 0; s < 6; ++s)
    diagonal[s] = answer.tangent[7 * s];
  return diagonal;
}

} // namespace

std::vector<double> shear_flexibilities(const LineMaterials &materials) {
  std::vector<double> result;
  for (const auto &[id, material] : materials) {
    if (!material.law.is_set() || material.law.description().kind != LawKind::section)
      continue;
    const auto C = elastic_diagonal(material.law);
    const double shear = C[1] + C[2], bending = C[4] + C[5];
    result.resize(id + 1, 0.);
    result[id] = shear > 0. ? 12. * bending / shear : 0.;
  }
  return result;
}

ArcData arc_data(const LineMaterial &material, const Point<3> &centre) {
  AssertThrow(material.law.is_set() && material.law.description().kind == LawKind::section,
              ExcMessage("\n  read:    an arc of a material without a law of kind 'section'"
                         "\n  allowed: a section\n  try:     'elastic_section'\n"));
  const auto C = elastic_diagonal(material.law);
  return {centre, C[0], (C[1] + C[2]) / 2., C[3], (C[4] + C[5]) / 2.};
}

const LineMaterial &material_of(const LineMaterials &materials,
                                const types::material_id material_id, const LawKind kind) {
  const auto found = materials.find(material_id);
  AssertThrow(found != materials.end(),
              ExcMessage("\n  read:    a cell of material id " + std::to_string(material_id) +
                         "\n  allowed: those that have a LineMaterial: " + known_ids(materials) +
                         "\n  try:     one more, or another material id\n"));
  const BoundLaw &law = found->second.law;
  AssertThrow(law.is_set(),
              ExcMessage("\n  read:    material " + std::to_string(material_id) + " without a law" +
                         "\n  allowed: a law of kind '" + name_of(kind) +
                         "'\n  try:     BoundLaw(library.find(...), parameters)\n"));
  AssertThrow(law.description().kind == kind,
              ExcMessage("\n  read:    a cell of material id " + std::to_string(material_id) +
                         " with the law '" + law.name() + "', of kind '" +
                         name_of(law.description().kind) + "'\n  allowed: kind '" + name_of(kind) +
                         "', which its element has\n  try:     'support' for FE_FrictionBeam, "
                         "'section' for beams and arcs\n"));
  return found->second;
}

LawPointData::LawPointData(const DoFHandler<1, 3> &dof_handler, const LineMaterials &materials,
                           const unsigned int n_points)
    : n_points_of_beams(n_points),
      committed_points(dof_handler.get_triangulation().n_active_cells()) {
  const VertexDofs shared(dof_handler); // throws where lines do not share their unknowns
  LineValues values(dof_handler.get_fe_collection(), n_points);
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (cell->is_artificial())
      continue;
    values.reinit(cell);
    if (!values.has_line())
      continue;
    const LineMaterial &material = material_of(materials, cell->material_id(), values.kind());
    LawPoint point;
    point.internal_variables.assign(material.law.n_internal_variables(), 0.);
    committed_points[cell->active_cell_index()].assign(values.n_points(), point);
  }
  trial_points = committed_points;
}

std::size_t LawPointData::place(const LineCellIterator &cell) const {
  const unsigned int n_cells = cell->get_triangulation().n_active_cells();
  AssertThrow(committed_points.size() == n_cells,
              ExcMessage("\n  read:    states of the points of " +
                         std::to_string(committed_points.size()) + " cells\n  allowed: " +
                         std::to_string(n_cells) + " cells, as many as the mesh has" +
                         "\n  try:     LawPointData(dof_handler, materials) for a new mesh, "
                         "transfer_line_solution() for one that is refined\n"));
  return cell->active_cell_index();
}

} // namespace frictionbeam
