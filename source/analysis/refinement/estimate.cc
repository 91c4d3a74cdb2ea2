// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/refinement/estimate.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/fe_values_extractors.h>

namespace frictionbeam {

using namespace dealii;

namespace {

template <int dim>
class Estimator {
public:
  Estimator(const ContinuumBody<dim> &body, const ContinuumVector &u,
            const ContinuumVector &traction, const double factor)
      : body(body), u(u), traction(traction), factor(factor), lame(lame_constants(body.continuum)),
        degree(body.fe.degree), cell_rule(degree + 1), face_rule(degree + 1),
        in_cell(body.fe, cell_rule, update_hessians | update_JxW_values),
        on_face(body.fe, face_rule, flags), on_neighbor(body.fe, face_rule, flags),
        on_subface(body.fe, face_rule, flags) {}

  /// Add the parts of a cell: its own, and those of its faces, which count for both sides. Each
  /// face is visited once, from the finer side; if the other cell belongs to another process, by
  /// both.
  void add(const typename DoFHandler<dim>::active_cell_iterator &cell,
           dealii::Vector<float> &result) {
    double sum = interior(cell);
    for (const unsigned int f : cell->face_indices()) {
      if (cell->face(f)->at_boundary()) {
        sum += boundary(cell, f);
        continue;
      }
      if (cell->face(f)->has_children()) {
        for (unsigned int sub = 0; sub < cell->face(f)->n_active_descendants(); ++sub) {
          const auto child = cell->neighbor_child_on_subface(f, sub);
          if (child->is_locally_owned())
            continue;
          const unsigned int there = cell->neighbor_of_neighbor(f);
          on_subface.reinit(cell, f, sub);
          on_neighbor.reinit(child, there);
          sum += jump(on_subface, on_neighbor, child->face(there)->diameter());
        }
        continue;
      }
      const auto neighbor = cell->neighbor(f);
      const bool is_owned = neighbor->is_locally_owned();
      double part = 0.;
      if (cell->neighbor_is_coarser(f)) {
        const auto there = cell->neighbor_of_coarser_neighbor(f);
        on_face.reinit(cell, f);
        on_subface.reinit(neighbor, there.first, there.second);
        part = jump(on_face, on_subface, cell->face(f)->diameter());
      } else {
        if (is_owned && neighbor->active_cell_index() < cell->active_cell_index())
          continue;
        on_face.reinit(cell, f);
        on_neighbor.reinit(neighbor, cell->neighbor_of_neighbor(f));
        part = jump(on_face, on_neighbor, cell->face(f)->diameter());
      }
      sum += part;
      if (is_owned)
        result[neighbor->active_cell_index()] += part / body.continuum.youngs_modulus;
    }
    result[cell->active_cell_index()] += sum / body.continuum.youngs_modulus;
  }

private:
  Tensor<1, dim> stress_on(const Tensor<2, dim> &gradient, const Tensor<1, dim> &normal) const {
    Tensor<1, dim> result = lame.lambda * trace(gradient) * normal;
    result += lame.mu * (gradient * normal + transpose(gradient) * normal);
    return result;
  }

  double interior(const typename DoFHandler<dim>::active_cell_iterator &cell) {
    if (degree == 1)
      return 0.; // no bulk term on parallelograms
    in_cell.reinit(cell);
    std::vector<Tensor<3, dim>> hessians(cell_rule.size());
    in_cell[FEValuesExtractors::Vector(0)].get_function_hessians(u, hessians);
    double sum = 0.;
    for (unsigned int q = 0; q < cell_rule.size(); ++q) {
      Tensor<1, dim> divergence;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          divergence[i] +=
              (lame.lambda + lame.mu) * hessians[q][j][i][j] + lame.mu * hessians[q][i][j][j];
      sum += divergence.norm_square() * in_cell.JxW(q);
    }
    const double h = cell->diameter() / degree;
    return h * h * sum * body.thickness();
  }

  double jump(const FEFaceValuesBase<dim> &here, const FEFaceValuesBase<dim> &there,
              const double size) {
    std::vector<Tensor<2, dim>> a(face_rule.size()), b(face_rule.size());
    here[FEValuesExtractors::Vector(0)].get_function_gradients(u, a);
    there[FEValuesExtractors::Vector(0)].get_function_gradients(u, b);
    double sum = 0.;
    for (unsigned int q = 0; q < face_rule.size(); ++q)
      sum += stress_on(a[q] - b[q], here.normal_vector(q)).norm_square() * here.JxW(q);
    return 0.5 * size / degree * sum * body.thickness();
  }

  double boundary(const typename DoFHandler<dim>::active_cell_iterator &cell,
                  const unsigned int f) {
    on_face.reinit(cell, f);
    const types::boundary_id id = cell->face(f)->boundary_id();
    const bool on_surface = body.surface_of(id) >= 0;
    std::array<bool, dim> held{};
    for (const ContinuumHold &part : body.continuum.holds)
      if (body.mesh.points.count(part.part) == 0 && body.mesh.part(part.part) == id)
        for (unsigned int d = 0; d < dim; ++d)
          held[d] = held[d] || part.fixed[d];
    std::vector<Tensor<2, dim>> gradients(face_rule.size());
    std::vector<Tensor<1, dim>> contact(face_rule.size());
    on_face[FEValuesExtractors::Vector(0)].get_function_gradients(u, gradients);
    if (on_surface)
      on_face[FEValuesExtractors::Vector(0)].get_function_values(traction, contact);
    double sum = 0.;
    for (unsigned int q = 0; q < face_rule.size(); ++q) {
      const Tensor<1, dim> n = on_face.normal_vector(q);
      Tensor<1, dim> left = stress_on(gradients[q], n) - factor * body.traction(id, n);
      if (on_surface)
        left -= contact[q];
      for (unsigned int d = 0; d < dim; ++d)
        if (held[d])
          left[d] = 0.;
      sum += left.norm_square() * on_face.JxW(q);
    }
    return cell->face(f)->diameter() / degree * sum * body.thickness();
  }

  const UpdateFlags flags =
      update_values | update_gradients | update_normal_vectors | update_JxW_values;
  const ContinuumBody<dim> &body;
  const ContinuumVector &u, &traction;
  const double factor;
  const LameConstants lame;
  const unsigned int degree;
  const QGauss<dim> cell_rule;
  const QGauss<dim - 1> face_rule;
  FEValues<dim> in_cell;
  FEFaceValues<dim> on_face, on_neighbor;
  FESubfaceValues<dim> on_subface;
};

} // namespace

template <int dim>
dealii::Vector<float> estimate_error(const ContinuumBody<dim> &body, const ContinuumState &state,
                                     const ContinuumVector &contact_traction) {
  dealii::Vector<float> result(body.triangulation->n_active_cells());
  Estimator<dim> estimator(body, state.displacement, contact_traction, state.factor);
  for (const auto &cell : body.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      estimator.add(cell, result);
  return result;
}

template dealii::Vector<float> estimate_error<2>(const ContinuumBody<2> &, const ContinuumState &,
                                                 const ContinuumVector &);
template dealii::Vector<float> estimate_error<3>(const ContinuumBody<3> &, const ContinuumState &,
                                                 const ContinuumVector &);

} // namespace frictionbeam
