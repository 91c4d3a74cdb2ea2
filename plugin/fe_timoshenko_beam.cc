// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_timoshenko_beam.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace frictionbeam {

using namespace dealii;

FE_TimoshenkoBeam::FE_TimoshenkoBeam(const std::vector<double> &shear_flexibility)
    : FE_Line(6), shear_flexibility(shear_flexibility) {
  for (unsigned int id = 0; id < shear_flexibility.size(); ++id)
    AssertThrow(shear_flexibility[id] >= 0. && std::isfinite(shear_flexibility[id]),
                ExcMessage("\n  read:    a shear flexibility of " +
                           std::to_string(shear_flexibility[id]) + " m2, of material " +
                           std::to_string(id) +
                           "\n  allowed: zero, for a beam that does not shear, or above"
                           "\n  try:     12 EI/GA\n"));
}

std::string FE_TimoshenkoBeam::get_name() const {
  std::ostringstream name;
  name.precision(std::numeric_limits<double>::max_digits10);
  name << "FE_TimoshenkoBeam<1,3>(1";
  for (unsigned int id = 0; id < shear_flexibility.size(); ++id)
    name << (id == 0 ? "; shear flexibility " : ", ") << shear_flexibility[id];
  name << ')';
  return name.str();
}

std::unique_ptr<FiniteElement<1, 3>> FE_TimoshenkoBeam::clone() const {
  return std::make_unique<FE_TimoshenkoBeam>(*this);
}

void FE_TimoshenkoBeam::evaluate(const CellGeometry &cell, const double xi,
                                 std::vector<ShapeFunction> &shapes) const {
  const double L = cell.length;
  const double phi = cell.material_id < shear_flexibility.size()
                         ? shear_flexibility[cell.material_id] / (L * L)
                         : 0.;
  const double m = 1. / (1. + phi);
  const double xi2 = xi * xi, xi3 = xi2 * xi;

  // In a plane: deflection w and rotation psi of the section, for the deflection (first) and the
  // rotation (second) of either end, with derivatives along the line.
  struct PlaneFunctions {
    double w_w, w_psi, psi_w, psi_psi;
  };
  const std::array<PlaneFunctions, 2> value = {
      {{m * (1 - 3 * xi2 + 2 * xi3 + phi * (1 - xi)),
        m * L * (xi - 2 * xi2 + xi3 + phi / 2 * (xi - xi2)), m * 6 / L * (xi2 - xi),
        m * (1 - 4 * xi + 3 * xi2 + phi * (1 - xi))},
       {m * (3 * xi2 - 2 * xi3 + phi * xi), m * L * (-xi2 + xi3 + phi / 2 * (xi2 - xi)),
        m * 6 / L * (xi - xi2), m * (-2 * xi + 3 * xi2 + phi * xi)}}};
  const std::array<PlaneFunctions, 2> slope = {
      {{m * (-6 * xi + 6 * xi2 - phi) / L, m * (1 - 4 * xi + 3 * xi2 + phi / 2 * (1 - 2 * xi)),
        m * 6 / L * (2 * xi - 1) / L, m * (-4 + 6 * xi - phi) / L},
       {m * (6 * xi - 6 * xi2 + phi) / L, m * (-2 * xi + 3 * xi2 + phi / 2 * (2 * xi - 1)),
        m * 6 / L * (1 - 2 * xi) / L, m * (-2 + 6 * xi + phi) / L}}};

  const Tensor<1, 3> &t = cell.tangent;
  for (unsigned int node = 0; node < 2; ++node) {
    const double axial = node == 0 ? 1 - xi : xi;
    const double axial_slope = (node == 0 ? -1. : 1.) / L;
    const PlaneFunctions &v = value[node], &s = slope[node];
    for (unsigned int d = 0; d < 3; ++d) {
      Tensor<1, 3> unit;
      unit[d] = 1.;
      const Tensor<1, 3> along = t[d] * t, across = unit - along;
      // A rotation theta deflects by theta x t; a deflection w turns the section by t x w.
      const Tensor<1, 3> deflection = cross_product_3d(unit, t),
                         rotation = cross_product_3d(t, unit);
      ShapeFunction &moved = shapes[6 * node + d], &turned = shapes[6 * node + 3 + d];
      for (unsigned int c = 0; c < 3; ++c) {
        moved.value[c] = axial * along[c] + v.w_w * across[c];
        moved.derivative[c] = axial_slope * along[c] + s.w_w * across[c];
        moved.value[3 + c] = v.psi_w * rotation[c];
        moved.derivative[3 + c] = s.psi_w * rotation[c];
        turned.value[c] = v.w_psi * deflection[c];
        turned.derivative[c] = s.w_psi * deflection[c];
        turned.value[3 + c] = axial * along[c] + v.psi_psi * across[c];
        turned.derivative[3 + c] = axial_slope * along[c] + s.psi_psi * across[c];
      }
    }
  }
}

} // namespace frictionbeam
