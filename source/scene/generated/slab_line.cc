// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/slab_line.h"

#include <cmath>

namespace frictionbeam::generated {

void declare_slab_line(ParameterReader &in) {
  in.declare_flag(
      "Poisson squeeze", false,
      "Of the line: the pressure p squeezes the slab, whose free axial strain is nu p/E "
      "(plane stress) or nu (1+nu) p/E (plane strain).");
  in.declare_number("Shear lag", 0., "-", 0., 1e300,
                    "Of the line: c in the interface stiffness per length k = c G Width/Height, in "
                    "series with GS, by which the surface moves less than the mean of the section; "
                    "3 for a linear distribution of shear; 0: none.");
}

SlabLine read_slab_line(const ParameterReader &in, const double spacing) {
  const double E = in.number("Young's modulus"), nu = in.number("Poisson"), GS = in.number("GS"),
               c = in.number("Shear lag");
  const bool plane_strain = in.choice("Plane", plane_kinds);
  SlabLine line;
  line.axial_modulus = plane_strain ? E / (1. - nu * nu) : E;
  if (in.flag("Poisson squeeze"))
    line.squeeze = nu * (plane_strain ? 1. + nu : 1.) * in.number("Pressure") / E;
  const double lag = c * E / (2. * (1. + nu)) * in.number("Width") / in.number("Height") * spacing;
  line.shear_rigidity = c == 0. ? GS : GS == 0. ? lag : GS * lag / (GS + lag);
  return line;
}

std::vector<Quantity> slab_line_quantities(const double length, const unsigned int n_elements) {
  std::vector<Quantity> quantities;
  for (const unsigned int x : {2, 4, 6}) {
    const double node = x * n_elements / length;
    if (x >= length || std::abs(node - std::round(node)) > 1e-9)
      continue;
    Quantity force;
    force.name = "N_" + std::to_string(x);
    force.what = "N_mean";
    force.where = "P" + std::to_string(std::lround(node));
    force.scale = -1.;
    quantities.push_back(force);
  }
  Quantity slip;
  slip.name = slip.what = "slip_length";
  quantities.push_back(slip);
  Quantity end;
  end.name = "u_0_mean";
  end.what = "ux";
  end.where = "P0";
  quantities.push_back(end);
  return quantities;
}

} // namespace frictionbeam::generated
