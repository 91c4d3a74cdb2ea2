// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/line/assemble_line.h>

#include <algorithm>
#include <string>

namespace frictionbeam {

using namespace dealii;

namespace {

/// The law's answer at a point, into @p trial and @p tangent.
LawStatus ask_law(const BoundLaw &law, const double length, const LineIncrement &increment,
                  const LawIncrement &of_law, const LawPoint &committed, LawPoint &trial,
                  double *const tangent) {
  GeneralizedStrain rate;
  if (increment.length > 0.)
    rate = (trial.strain - committed.strain) / increment.length;
  LawOutput output{&trial.stress[0], tangent, trial.internal_variables.data(), 0.,
                   ContactStatus::none};
  const LawStatus status =
      law.integrate(&trial.strain[0], &rate[0], length, of_law, committed.internal_variables.data(),
                    increment.tangent, output);
  trial.dissipation = committed.dissipation + output.dissipation;
  trial.contact = output.contact;
  return status;
}

void check_points(const std::vector<LawPoint> &points, const LineValues &values,
                  const BoundLaw &law) {
  const auto fits = [&](const LawPoint &point) {
    return point.internal_variables.size() == law.n_internal_variables();
  };
  AssertThrow(points.size() == values.n_points() && std::all_of(points.begin(), points.end(), fits),
              ExcMessage("\n  read:    states of " + std::to_string(points.size()) +
                         " points for a cell of " + std::to_string(values.n_points()) +
                         " with the law '" + law.name() + "' of " +
                         std::to_string(law.n_internal_variables()) + " internal variables" +
                         "\n  allowed: states that were made for these laws and these points" +
                         "\n  try:     LawPointData anew, LineValues with its n_points()\n"));
}

/// Add B^T C B.
void add_tangent(const LineValues &values, const unsigned int q, const unsigned int n_strains,
                 const double *const C, FullMatrix<double> &tangent) {
  const std::vector<unsigned int> &dofs = values.line_dofs();
  for (const unsigned int j : dofs) {
    const GeneralizedStrain &B_j = values.strain(j, q);
    GeneralizedStrain stress; // of B_j, times the weight
    for (unsigned int s = 0; s < n_strains; ++s)
      for (unsigned int t = 0; t < n_strains; ++t)
        stress[s] += values.JxW(q) * C[n_strains * s + t] * B_j[t];
    for (const unsigned int i : dofs)
      tangent(i, j) += values.strain(i, q) * stress;
  }
}

} // namespace

LawStatus assemble_line_cell(const LineValues &values, const LineCellIterator &cell,
                             const LineMaterials &materials, const std::vector<double> &dof_values,
                             const LineIncrement &increment, LawPointData &points,
                             FullMatrix<double> &tangent, Vector<double> &residual) {
  AssertDimension(dof_values.size(), values.n_dofs());
  const bool is_section = values.kind() == LawKind::section;
  const LineMaterial &material = material_of(materials, cell->material_id(), values.kind());
  const std::vector<LawPoint> &committed = points.committed(cell);
  std::vector<LawPoint> &trial = points.trial(cell);
  check_points(trial, values, material.law);
  const unsigned int n_strains = material.law.description().n_strains;
  residual.reinit(values.n_dofs());
  if (increment.tangent != LawTangent::none)
    tangent.reinit(values.n_dofs(), values.n_dofs());
  Tensor<1, 3> force;
  if (is_section && increment.line_force)
    force = increment.line_force(cell);

  for (unsigned int q = 0; q < values.n_points(); ++q) {
    GeneralizedStrain strain;
    for (const unsigned int i : values.line_dofs())
      strain += dof_values[i] * values.strain(i, q);
    if (is_section && increment.free_strain)
      strain -= increment.free_strain(cell, values.point(q));
    for (unsigned int s = n_strains; s < 6; ++s)
      strain[s] = 0.; // of supports, which have no curvature
    trial[q].strain = strain;
    LawIncrement of_law;
    of_law.time = increment.time;
    of_law.length = increment.length;
    if (increment.temperature)
      of_law.temperature = increment.temperature(cell, values.point(q));
    if (increment.temperature_change)
      of_law.temperature_change = increment.temperature_change(cell, values.point(q));
    double C[n_section_strains * n_section_strains];
    if (ask_law(material.law, values.length(), increment, of_law, committed[q], trial[q], C) !=
        LawStatus::ok)
      return LawStatus::failed;
    for (const unsigned int i : values.line_dofs()) {
      double value = -(values.strain(i, q) * trial[q].stress);
      for (unsigned int d = 0; d < 3; ++d)
        value += values.motion(i, q)[d] * force[d];
      residual[i] += value * values.JxW(q);
    }
    if (increment.tangent != LawTangent::none)
      add_tangent(values, q, n_strains, C, tangent);
  }
  return LawStatus::ok;
}

void assemble_line_mass_cell(const LineValues &values, const LineCellIterator &cell,
                             const LineMaterials &materials, FullMatrix<double> &mass) {
  const LineMaterial &material = material_of(materials, cell->material_id(), values.kind());
  mass.reinit(values.n_dofs(), values.n_dofs());
  for (unsigned int q = 0; q < values.n_points(); ++q) {
    const Tensor<1, 3> &x = values.axes(q).x;
    for (const unsigned int j : values.line_dofs()) {
      const Tensor<1, 6> &motion = values.motion(j, q);
      const Tensor<1, 3> rotation({motion[3], motion[4], motion[5]});
      const Tensor<1, 3> turning = material.rotary_inertia * (rotation + (rotation * x) * x);
      Tensor<1, 6> momentum;
      for (unsigned int d = 0; d < 3; ++d) {
        momentum[d] = material.mass * motion[d] * values.JxW(q);
        momentum[3 + d] = turning[d] * values.JxW(q);
      }
      for (const unsigned int i : values.line_dofs())
        mass(i, j) += values.motion(i, q) * momentum;
    }
  }
}

} // namespace frictionbeam
