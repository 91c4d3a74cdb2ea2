// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/line/line_postprocessor.h>

namespace frictionbeam {

using namespace dealii;

LinePostprocessor::LinePostprocessor(const LawPointData &points, const LineIncrement &increment)
    : points(points), increment(increment) {}

std::vector<std::string> LinePostprocessor::get_names() const {
  return {"eps", "gamma_y", "gamma_z", "chi", "kappa_y", "kappa_z",
          "N",   "V_y",     "V_z",     "M_x", "M_y",     "M_z"};
}

std::vector<DataComponentInterpretation::DataComponentInterpretation>
LinePostprocessor::get_data_component_interpretation() const {
  return {12, DataComponentInterpretation::component_is_scalar};
}

UpdateFlags LinePostprocessor::get_needed_update_flags() const {
  return update_values | update_gradients | update_quadrature_points;
}

LineValues &LinePostprocessor::values_for(const hp::FECollection<1, 3> &fes) const {
  std::shared_ptr<Kept> &of_thread = kept.get();
  bool is_kept = of_thread != nullptr && of_thread->fes.size() == fes.size();
  for (unsigned int i = 0; i < fes.size() && is_kept; ++i)
    is_kept = &of_thread->fes[i] == &fes[i];
  if (!is_kept)
    of_thread = std::make_shared<Kept>(fes, points.n_points());
  return of_thread->values;
}

void LinePostprocessor::evaluate_vector_field(
    const DataPostprocessorInputs::Vector<3> &inputs,
    std::vector<Vector<double>> &computed_quantities) const {
  const LineCellIterator cell = inputs.template get_cell<1>();
  LineValues &values = values_for(cell->get_dof_handler().get_fe_collection());
  values.reinit(cell);
  if (!values.has_line()) {
    for (Vector<double> &quantities : computed_quantities)
      quantities = 0.;
    return;
  }
  const SectionForces forces(values, cell, points,
                             increment.line_force ? increment.line_force(cell) : Tensor<1, 3>());
  const unsigned int first = line_part(cell->get_fe()).first_component;
  const Tensor<1, 3> chord = cell->vertex(1) - cell->vertex(0);
  for (unsigned int q = 0; q < computed_quantities.size(); ++q) {
    const double xi = (inputs.evaluation_points[q] - cell->vertex(0)) * chord / chord.norm_square();
    Tensor<1, 3> rotation, du,
        dtheta; // derivatives along the line, which an arc's chord is short of
    for (unsigned int c = 0; c < 3; ++c) {
      rotation[c] = inputs.solution_values[q][first + 3 + c];
      du[c] = inputs.solution_gradients[q][first + c] * chord / values.length();
      dtheta[c] = inputs.solution_gradients[q][first + 3 + c] * chord / values.length();
    }
    const GeneralizedStrain strain =
        generalized_strain(values.local_axes(xi), rotation, du, dtheta);
    const GeneralizedStrain force = forces.at(xi);
    for (unsigned int s = 0; s < 6; ++s) {
      computed_quantities[q][s] = strain[s];
      computed_quantities[q][6 + s] = force[s];
    }
  }
}

} // namespace frictionbeam
