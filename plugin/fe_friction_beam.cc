// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/fe_friction_beam.h>

namespace frictionbeam {

using namespace dealii;

FE_FrictionBeam::FE_FrictionBeam(const Rotations rotations, const bool torsion)
    : FE_Line(rotations == Rotations::none && !torsion ? 3 : 6), rotations(rotations),
      torsion(torsion) {}

std::string FE_FrictionBeam::get_name() const {
  const char *const options[] = {"no rotations", "averaged rotations", "first node's rotations",
                                 "second node's rotations"};
  const char *const option = options[static_cast<unsigned int>(rotations)];
  return std::string("FE_FrictionBeam<1,3>(") + option + (torsion ? ", torsion)" : ")");
}

std::unique_ptr<FiniteElement<1, 3>> FE_FrictionBeam::clone() const {
  return std::make_unique<FE_FrictionBeam>(*this);
}

void FE_FrictionBeam::evaluate(const CellGeometry &cell, const double xi,
                               std::vector<ShapeFunction> &shapes) const {
  const Tensor<1, 3> &t = cell.tangent;
  const unsigned int turning_node = rotations == Rotations::first_node ? 0 : 1;
  for (unsigned int node = 0; node < 2; ++node) {
    const double linear = node == 0 ? 1 - xi : xi;
    const double slope = (node == 0 ? -1. : 1.) / cell.length;
    for (unsigned int d = 0; d < 3; ++d) {
      ShapeFunction &moved = shapes[n_dofs_per_vertex() * node + d];
      moved.value[d] = linear;
      moved.derivative[d] = slope;
      if (n_dofs_per_vertex() == 3)
        continue;
      ShapeFunction &turned = shapes[6 * node + 3 + d];
      for (unsigned int c = 0; c < 3; ++c) {
        const double along = t[d] * t[c], across = (c == d ? 1. : 0.) - along;
        if (torsion) {
          turned.value[3 + c] += linear * along;
          turned.derivative[3 + c] += slope * along;
        }
        if (rotations == Rotations::averaged) {
          turned.value[3 + c] += linear * across;
          turned.derivative[3 + c] += slope * across;
        } else if (rotations != Rotations::none && node == turning_node)
          turned.value[3 + c] += across;
      }
    }
  }
}

} // namespace frictionbeam
