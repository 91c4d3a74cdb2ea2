// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/generated.h"

namespace frictionbeam::generated {

void declare_expansion(ParameterReader &in) {
  in.declare_number("Expansion", 1.2e-5, "1/K", positive, 1., "Coefficient alpha of the pipe.");
}

FrictionSupport coulomb_support(const LawLibrary &laws, const std::string &name,
                                const double friction, const double axial_rigidity,
                                const double shear_rigidity, const double normal_force) {
  const LawDescription &law = laws.find("coulomb");
  FrictionSupport support;
  support.name = name;
  support.kind = "friction";
  support.law = law.name;
  support.parameters = default_parameters(law);
  support.parameters[parameter_index(law, "Friction coefficient")] = friction;
  support.parameters[parameter_index(law, "Axial rigidity")] = axial_rigidity;
  support.parameters[parameter_index(law, "Shear rigidity")] = shear_rigidity;
  support.normal.vector[2] = 1.;
  support.normal_force = normal_force;
  return support;
}

Restraint hold_ux(const std::string &name, const std::string &point) {
  Restraint restraint;
  restraint.name = name;
  restraint.kind = "restraint";
  restraint.placement.points = {point};
  restraint.fixed[0] = true;
  return restraint;
}

Restraint anchor(const std::string &name, const std::vector<std::string> &points) {
  Restraint restraint;
  restraint.name = name;
  restraint.kind = "anchor";
  restraint.placement.points = points;
  restraint.fixed.fill(true);
  return restraint;
}

Section pipe_section(const std::string &name, const double outer_diameter, const double wall,
                     const double shear_coefficient, const double added_mass) {
  constexpr double pi = 3.14159265358979323846;
  const double outer = outer_diameter / 2., inner = outer - wall;
  Section section;
  section.name = name;
  section.outer_radius = outer;
  section.wall = wall;
  section.area = pi * wall * (outer + inner);
  section.inertia = section.area * (outer * outer + inner * inner) / 4.;
  section.torsion_constant = 2. * section.inertia;
  section.shear_area = shear_coefficient * section.area;
  section.added_mass = added_mass;
  return section;
}

ContinuumQuantity body_quantity(const std::string &name, const ContinuumQuantity::Kind kind,
                                const std::string &where, const double x) {
  ContinuumQuantity result;
  result.name = name;
  result.kind = kind;
  result.where = where;
  result.x = x;
  return result;
}

Load weight_load() {
  Load load;
  load.name = "weight";
  load.vector[2] = -9.81;
  return load;
}

Load temperature_load(const std::string &name, const double rise) {
  Load load;
  load.name = name;
  load.kind = Load::Kind::temperature;
  load.value = rise;
  return load;
}

LoadStep static_step(const std::string &name,
                     const std::vector<std::pair<unsigned int, double>> &loads,
                     const unsigned int n_increments) {
  LoadStep step;
  step.name = name;
  step.loads = loads;
  step.n_increments = n_increments;
  return step;
}

std::vector<Quantity> sums_over_supports() {
  std::vector<Quantity> quantities;
  for (const QuantityKind &kind : quantity_kinds)
    if (kind.of == QuantityKind::Of::supports && kind.measure != QuantityKind::Measure::place) {
      Quantity quantity;
      quantity.name = quantity.what = kind.word;
      quantities.push_back(quantity);
    }
  return quantities;
}

} // namespace frictionbeam::generated
