// SPDX-License-Identifier: LGPL-2.1-or-later
#include "generated.h"

#include <vector>

namespace frictionbeam::generated {

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

namespace {

/// The slab as n bars of stiffness c on n+1 friction springs: stiffness K and bound Q, half of
/// either at the two ends.
struct DiscreteSlab {
  unsigned int n;
  double c, K, Q, force;
  bool far_end_fixed;

  double weight(const unsigned int i) const { return i == 0 || i == n ? 0.5 : 1.; }

  /**
   * Displacement of the pushed end, exact, for a force that grows from zero. Nodes 0 .. m-1 slip;
   * what sticks from node m on acts on m as one spring, made from the far end by sums of positive
   * numbers only, so that no cosh overflows. The first m whose spring force stays within the bound
   * is the solution. Empty if nothing can hold the slab.
   */
  std::optional<double> pushed_end() const {
    // stiffness[m]: force at node m per displacement there, with nodes m .. n sticking.
    std::vector<double> stiffness(n + 1);
    if (far_end_fixed)
      stiffness[n - 1] = weight(n - 1) * K + c;
    else {
      stiffness[n] = K / 2.;
      stiffness[n - 1] = weight(n - 1) * K + c * stiffness[n] / (c + stiffness[n]);
    }
    for (unsigned int i = n - 1; i-- > 0;)
      stiffness[i] = weight(i) * K + c * stiffness[i + 1] / (c + stiffness[i + 1]);

    const unsigned int n_springs = far_end_fixed ? n : n + 1;
    std::vector<double> bar_force; // right of each slipping node
    double force_at_m = force, u = 0.;
    unsigned int m = 0;
    for (; m < n_springs; ++m) {
      u = force_at_m / stiffness[m];
      if (K * u <= Q)
        break;
      force_at_m -= weight(m) * Q;
      bar_force.push_back(force_at_m);
    }
    if (m == n_springs) {
      if (!far_end_fixed)
        return std::nullopt;
      u = 0.;
    }
    for (; m > 0; --m)
      u += bar_force[m - 1] / c;
    return u;
  }
};

} // namespace

void declare_slab(ParameterReader &in) {
  in.declare_number("Force", 12., "N", 0., 1e300, "At the end x = 0, towards +x.");
  in.declare_number("GS", 1e6, "N", positive, 1e300,
                    "Shear rigidity of a friction element, which is 1 m long.");
  in.declare_count("Elements", 16, 1, "Of the slab; a friction element at every node.");
  in.declare_number("Length", 8., "m", positive, 1e300, "Of the slab, along x.");
  in.declare_number("Width", 1., "m", positive, 1e300, "Of the slab.");
  in.declare_number("Height", 1., "m", positive, 1e300, "Of the slab.");
  in.declare_number("Pressure", 10., "Pa", positive, 1e300, "That presses it on the surface.");
  in.declare_number("Friction", 0.3, "-", 0., 100., "Coefficient of the surface.");
  in.declare_number("Young's modulus", 1000., "Pa", positive, 1e300, "Of the slab.");
  in.declare_choice("Far end", "free", {"free", "fixed"}, "The end at x = Length.");
  in.declare_count("Increments", 10, 1, "In which the force grows.");
}

void build_slab(const ParameterReader &in, const LawLibrary &laws, Scene &scene) {
  const unsigned int n = in.count("Elements");
  const double length = in.number("Length"), b = in.number("Width"), height = in.number("Height");
  const double E = in.number("Young's modulus"), GS = in.number("GS");
  const double friction = in.number("Friction"), force = in.number("Force");
  const bool far_end_fixed = in.text("Far end") == "fixed";
  const double h = length / n, normal_force = in.number("Pressure") * b * h;

  scene.free_motions = {{true, false, false, false, false, false}};
  scene.materials = {{"slab", E, 0.3, 0., 0.}};
  Section section;
  section.name = "slab";
  section.area = b * height;
  section.inertia = b * height * height * height / 12.;
  section.torsion_constant = 2. * section.inertia;
  scene.sections = {section};

  Pipe pipe;
  pipe.name = "slab";
  const std::string last = "P" + std::to_string(n);
  pipe.route = {{"P0", Point3(0., 0., 0.)}, {last, Point3(length, 0., 0.)}};
  scene.pipes = {pipe};
  // A whole element at every node between, half of one at either end.
  FrictionSupport bed = coulomb_support(laws, "bed", friction, GS, GS, normal_force);
  for (unsigned int i = 1; i < n; ++i) {
    scene.points.push_back({"P" + std::to_string(i), Point3(i * h, 0., 0.)});
    bed.placement.points.push_back(scene.points.back().name);
  }
  FrictionSupport ends = coulomb_support(laws, "ends", friction, GS, GS, normal_force);
  ends.placement.points = {"P0", last};
  ends.share = 0.5;
  if (n > 1)
    scene.supports.push_back(bed);
  scene.supports.push_back(ends);
  if (far_end_fixed)
    scene.restraints.push_back(hold_ux("far_end", last));

  Load push;
  push.name = "push";
  push.kind = Load::Kind::force;
  push.at = {{"P0", {{force, 0., 0., 0., 0., 0.}}, {}}};
  scene.loads = {push};
  LoadStep step;
  step.name = "push";
  step.loads = {{0, 1.}};
  step.n_increments = in.count("Increments");
  scene.steps = {step};

  Quantity u_0;
  u_0.name = "u_0";
  u_0.what = "ux";
  u_0.where = "P0";
  u_0.reference =
      DiscreteSlab{n, E * section.area / h, GS, friction * normal_force, force, far_end_fixed}
          .pushed_end();
  u_0.source = "exact solution of the discrete model, bars on friction springs";
  scene.quantities = {u_0};
  if (!u_0.reference)
    scene.remarks.push_back("The force exceeds what friction can hold: there is no equilibrium.");
}

} // namespace frictionbeam::generated
