// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/line/transfer_line_solution.h>

#include <frictionbeam/fe_friction_beam.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/manifold.h>

#include <cmath>
#include <string>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Whether both children of a cell will be taken away.
bool will_be_coarsened(const DoFHandler<1, 3>::cell_iterator &parent) {
  for (unsigned int child = 0; child < parent->n_children(); ++child)
    if (!parent->child(child)->is_active() || !parent->child(child)->coarsen_flag_set())
      return false;
  return parent->has_children();
}

std::string where(const LineCellIterator &cell) {
  return "cell " + std::to_string(cell->active_cell_index()) + " of material id " +
         std::to_string(cell->material_id());
}

void check_changeable(const LineCellIterator &cell) {
  const FE_Line *const line = line_part(cell->get_fe()).element;
  if (line == nullptr)
    return;
  const std::string kind = dynamic_cast<const FE_ArcBeam *>(line) != nullptr ? "an arc"
                           : dynamic_cast<const FE_FrictionBeam *>(line) != nullptr
                               ? "a friction element"
                               : "";
  AssertThrow(kind.empty(),
              ExcMessage("\n  read:    a flag to refine or coarsen on " + where(cell) + ", " +
                         kind +
                         "\n  allowed: straight beams; an arc is exact in one cell, and a "
                         "friction element is one contact" +
                         "\n  try:     cell->clear_refine_flag(), clear_coarsen_flag() there\n"));
  if (!cell->refine_flag_set())
    return;
  const Triangulation<1, 3>::cell_iterator line_cell = cell;
  const Point<3> middle = 0.5 * (cell->vertex(0) + cell->vertex(1)),
                 given = cell->get_manifold().get_new_point_on_line(line_cell);
  AssertThrow(middle.distance(given) <= 1e-8 * cell->diameter(),
              ExcMessage("\n  read:    a manifold that puts the new vertex of " + where(cell) +
                         " off the cell\n  allowed: flat ones: the cell is straight, and its "
                         "solution is along the chord" +
                         "\n  try:     triangulation.reset_all_manifolds(), or refine before the "
                         "first solution\n"));
}

/// Row of dof @p i of a matrix of its base element, times the values of that element's dofs.
double row_times(const FullMatrix<double> &matrix, const FiniteElement<1, 3> &fe,
                 const unsigned int i, const Vector<double> &values) {
  const auto [base, row] = fe.system_to_base_index(i);
  double sum = 0.;
  for (unsigned int j = 0; j < fe.n_dofs_per_cell(); ++j)
    if (fe.system_to_base_index(j).first == base)
      sum += matrix(row, fe.system_to_base_index(j).second) * values[j];
  return sum;
}

} // namespace

LineSolutionTransfer::LineSolutionTransfer(const DoFHandler<1, 3> &dof_handler)
    : dof_handler(dof_handler) {}

LineSolutionTransfer::Stored
LineSolutionTransfer::store(const LineCellIterator &cell,
                            const std::vector<const Vector<double> *> &vectors,
                            const LawPointData *const points) const {
  Stored stored{cell->active_fe_index(), {}, {}};
  for (const Vector<double> *const vector : vectors) {
    stored.values.emplace_back(cell->get_fe().n_dofs_per_cell());
    if (stored.values.back().size() > 0)
      cell->get_dof_values(*vector, stored.values.back());
  }
  if (points == nullptr)
    return stored;
  const Quadrature<1> quadrature = line_quadrature(cell->get_fe(), points->n_points());
  const auto &committed = points->committed(cell), &trial = points->trial(cell);
  for (unsigned int q = 0; q < committed.size(); ++q)
    stored.points.push_back({quadrature.point(q)[0], committed[q], trial[q]});
  return stored;
}

LineSolutionTransfer::Stored LineSolutionTransfer::join(const std::vector<Stored> &children) const {
  Stored stored{children[0].fe_index, {}, {}};
  const FiniteElement<1, 3> &fe = dof_handler.get_fe(stored.fe_index);
  const LinePart part = line_part(fe);
  const unsigned int n_at_vertex = part.element == nullptr ? 0 : part.element->n_dofs_per_vertex();
  for (unsigned int v = 0; v < n_vectors; ++v) {
    Vector<double> values(fe.n_dofs_per_cell());
    for (unsigned int i = 0; i < part.dofs.size(); ++i) // child 0 has its vertex 0, 1 its vertex 1
      values[part.dofs[i]] = children[i / n_at_vertex].values[v][part.dofs[i]];
    for (unsigned int base = 0; base < fe.n_base_elements(); ++base) {
      const FiniteElement<1, 3> &element = fe.base_element(base);
      if (&element == part.element || element.n_dofs_per_cell() == 0)
        continue;
      for (unsigned int child = 0; child < 2; ++child) {
        const FullMatrix<double> &R = element.get_restriction_matrix(child);
        for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i) {
          const auto place = fe.system_to_base_index(i);
          if (place.first.first != base)
            continue;
          const double value = row_times(R, fe, i, children[child].values[v]);
          if (element.restriction_is_additive(place.second))
            values[i] += value;
          else if (value != 0.)
            values[i] = value;
        }
      }
    }
    stored.values.push_back(values);
  }
  for (unsigned int child = 0; child < 2; ++child)
    for (Place place : children[child].points) {
      place.xi = 0.5 * (child + place.xi);
      stored.points.push_back(place);
    }
  return stored;
}

void LineSolutionTransfer::prepare(const std::vector<const Vector<double> *> &vectors,
                                   const LawPointData *const points) {
  cells.clear();
  n_vectors = vectors.size();
  has_points = points != nullptr;
  n_points_of_beams = has_points ? points->n_points() : 0;
  for (const Vector<double> *const vector : vectors)
    AssertThrow(vector->size() == dof_handler.n_dofs(),
                ExcDimensionMismatch(vector->size(), dof_handler.n_dofs()));
  std::map<Key, DoFHandler<1, 3>::cell_iterator> parents;
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    AssertThrow(!cell->is_artificial(),
                ExcMessage("\n  read:    a mesh with artificial cells"
                           "\n  allowed: meshes that every process knows all of"
                           "\n  try:     parallel::shared::Triangulation without artificial cells, "
                           "and vectors with all entries on each process\n"));
    const bool goes = cell->level() > 0 && will_be_coarsened(cell->parent());
    if (goes || cell->refine_flag_set())
      check_changeable(cell);
    if (goes)
      parents[{cell->parent()->level(), cell->parent()->index()}] = cell->parent();
    else
      cells[{cell->level(), cell->index()}] = store(cell, vectors, points);
  }
  for (const auto &[key, parent] : parents)
    cells[key] =
        join({store(parent->child(0), vectors, points), store(parent->child(1), vectors, points)});
}

Vector<double> LineSolutionTransfer::on_child(const Triangulation<1, 3>::cell_iterator &parent,
                                              const unsigned int child,
                                              const FiniteElement<1, 3> &fe,
                                              const Vector<double> &values) const {
  Vector<double> result(fe.n_dofs_per_cell());
  const LinePart part = line_part(fe);
  if (part.element != nullptr) {
    const MappingQ1<1, 3> mapping; // FEValues keep a pointer to it
    FEValues<1, 3> middle(mapping, *part.element, QMidpoint<1>(), update_values);
    middle.reinit(parent);
    const unsigned int n = part.element->n_dofs_per_vertex();
    for (unsigned int c = 0; c < n; ++c) {
      double value = 0.;
      for (unsigned int i = 0; i < part.dofs.size(); ++i)
        value += middle.shape_value_component(i, 0, c) * values[part.dofs[i]];
      const unsigned int own =
          child == 0 ? 0 : n; // the vertex that it has in common with its parent
      result[part.dofs[own + c]] = values[part.dofs[own + c]];
      result[part.dofs[n - own + c]] = value;
    }
  }
  for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i) {
    const FiniteElement<1, 3> &element = fe.base_element(fe.system_to_base_index(i).first.first);
    if (&element != part.element)
      result[i] = row_times(element.get_prolongation_matrix(child), fe, i, values);
  }
  return result;
}

std::vector<Vector<double>> LineSolutionTransfer::interpolate() const {
  std::vector<Vector<double>> result(n_vectors, Vector<double>(dof_handler.n_dofs()));
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    if (cell->get_fe().n_dofs_per_cell() == 0)
      continue;
    const auto own = cells.find({cell->level(), cell->index()});
    if (own != cells.end()) {
      for (unsigned int v = 0; v < n_vectors; ++v)
        cell->set_dof_values(own->second.values[v], result[v]);
      continue;
    }
    const auto parent = cell->parent();
    const unsigned int child = parent->child(0) == cell ? 0 : 1;
    const Stored &of_parent = cells.at({parent->level(), parent->index()});
    for (unsigned int v = 0; v < n_vectors; ++v)
      cell->set_dof_values(on_child(parent, child, cell->get_fe(), of_parent.values[v]), result[v]);
  }
  return result;
}

LawPointData LineSolutionTransfer::interpolate_points() const {
  AssertThrow(has_points, ExcMessage("\n  read:    states asked for that prepare() was not given"
                                     "\n  allowed: those it was\n  try:     prepare(vectors, "
                                     "&points)\n"));
  LawPointData result;
  result.n_points_of_beams = n_points_of_beams;
  for (const auto &cell : dof_handler.active_cell_iterators()) {
    result.committed_points.emplace_back();
    result.trial_points.emplace_back();
    const auto own = cells.find({cell->level(), cell->index()});
    const bool is_child = own == cells.end();
    const Stored &from =
        is_child ? cells.at({cell->parent()->level(), cell->parent()->index()}) : own->second;
    if (from.points.empty())
      continue;
    const Quadrature<1> quadrature = line_quadrature(cell->get_fe(), n_points_of_beams);
    const double begin = is_child && cell->parent()->child(1) == cell ? 0.5 : 0.,
                 size = is_child ? 0.5 : 1.;
    for (unsigned int q = 0; q < quadrature.size(); ++q) {
      const double xi = begin + size * quadrature.point(q)[0];
      const Place *nearest = &from.points[0];
      for (const Place &place : from.points)
        if (std::abs(place.xi - xi) < std::abs(nearest->xi - xi))
          nearest = &place;
      result.committed_points.back().push_back(nearest->committed);
      result.trial_points.back().push_back(nearest->trial);
    }
  }
  return result;
}

void transfer_line_solution(Triangulation<1, 3> &triangulation, DoFHandler<1, 3> &dof_handler,
                            const std::vector<Vector<double> *> &vectors,
                            LawPointData *const points) {
  triangulation.prepare_coarsening_and_refinement();
  LineSolutionTransfer transfer(dof_handler);
  transfer.prepare({vectors.begin(), vectors.end()}, points);
  triangulation.execute_coarsening_and_refinement();
  const hp::FECollection<1, 3> fes(dof_handler.get_fe_collection());
  dof_handler.distribute_dofs(fes);
  const std::vector<Vector<double>> result = transfer.interpolate();
  for (unsigned int v = 0; v < vectors.size(); ++v)
    *vectors[v] = result[v];
  if (points != nullptr)
    *points = transfer.interpolate_points();
}

} // namespace frictionbeam
