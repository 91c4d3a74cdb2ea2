// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/generated.h"

namespace frictionbeam::generated {

namespace {

/// Pipe on a continuous friction bed, anchored at x = 0, free at x = length, heated and cooled
/// back: closed forms with the active length L_a = EA strain/f. Axial forces at the anchor [N],
/// tension positive; displacements of the free end [m].
struct BedSolution {
  double anchor_hot, u_end_hot, anchor_cold, u_end_cold;

  BedSolution(const double EA, const double strain, const double f, const double length) {
    const double active = EA * strain / f;
    if (length <= active) {
      anchor_hot = -f * length;
      u_end_hot = strain * length - f * length * length / (2. * EA);
    } else {
      anchor_hot = -EA * strain;
      u_end_hot = strain * active / 2.;
    }
    // Cooling: reverse slip from the free end over half the active length.
    if (length <= active / 2.) {
      anchor_cold = f * length;
      u_end_cold = f * length * length / (2. * EA);
    } else if (length <= active) {
      const double a = length - active / 2.;
      anchor_cold = f * (active - length);
      u_end_cold = f / EA * (a * active / 2. - a * a / 2. + active * active / 8.);
    } else {
      anchor_cold = 0.;
      u_end_cold = strain * active / 4.;
    }
  }
};

Quantity quantity_of(const std::string &name, const std::string &what, const std::string &where,
                     const std::string &step, const double reference) {
  Quantity result;
  result.name = name;
  result.what = what;
  result.where = where;
  result.step = step;
  result.reference = reference;
  result.source = "closed form of a pipe on a continuous friction bed";
  return result;
}

} // namespace

void declare_friction_bed(ParameterReader &in) {
  in.declare_number("Length ratio", 0.3, "-", positive, 1e3,
                    "Length of the pipe over its active length EA alpha theta/f.");
  in.declare_count("Supports", 4000, 2, "Along the pipe, each in the middle of its share of it.");
  in.declare_number("EA", 6.88e8, "N", positive, 1e300, "Axial stiffness of the pipe.");
  declare_expansion(in);
  in.declare_number("Temperature rise", 60., "K", positive, 1e300, "theta.");
  in.declare_number("Friction per length", 240., "N/m", positive, 1e300,
                    "f, friction coefficient times weight per length.");
  in.declare_count("Increments", 40, 1, "Of heating, and of cooling.");
}

void build_friction_bed(const ParameterReader &in, const LawLibrary &laws, Scene &scene) {
  const double EA = in.number("EA"), alpha = in.number("Expansion"),
               rise = in.number("Temperature rise"), f = in.number("Friction per length");
  const unsigned int n = in.count("Supports");
  const double length = in.number("Length ratio") * EA * alpha * rise / f, spacing = length / n;
  const BedSolution exact(EA, alpha * rise, f, length);
  constexpr double E = 2e11, friction = 0.3;

  scene.free_motions = {{true, false, false, false, false, false}};
  scene.materials = {{"steel", E, 0.3, 0., alpha}};
  Section section;
  section.name = "pipe";
  section.area = EA / E;
  section.inertia = section.area * section.area;
  section.torsion_constant = 2. * section.inertia;
  scene.sections = {section};
  Pipe pipe;
  pipe.name = "pipe";
  pipe.route = {{"anchored", Point3(0., 0., 0.)}, {"free", Point3(length, 0., 0.)}};
  scene.pipes = {pipe};
  scene.restraints = {hold_ux("anchor", "anchored")};

  // Stiff enough that a support's elastic travel is a millionth of the pipe's.
  const double bound = f * spacing, rigidity = bound / (1e-6 * exact.u_end_hot);
  FrictionSupport first =
      coulomb_support(laws, "first_rest", friction, rigidity, rigidity, bound / friction);
  FrictionSupport rests = first;
  scene.points = {{"R1", Point3(spacing / 2., 0., 0.)}};
  first.placement.points = {"R1"};
  rests.name = "rests";
  rests.placement.pipe = "pipe";
  rests.placement.from = "R1";
  rests.placement.every = spacing;
  scene.supports = {first, rests};

  Load hot;
  hot.name = "hot";
  hot.kind = Load::Kind::temperature;
  hot.value = rise;
  scene.loads = {hot};
  LoadStep heat, cool;
  heat.name = "heat";
  heat.loads = {{0, 1.}};
  heat.n_increments = in.count("Increments");
  cool.name = "cool";
  cool.n_increments = heat.n_increments;
  scene.steps = {heat, cool};

  scene.quantities = {quantity_of("anchor_hot", "N", "anchored", "heat", exact.anchor_hot),
                      quantity_of("u_end_hot", "ux", "free", "heat", exact.u_end_hot),
                      quantity_of("anchor_cold", "N", "anchored", "cool", exact.anchor_cold),
                      quantity_of("u_end_cold", "ux", "free", "cool", exact.u_end_cold)};
}

} // namespace frictionbeam::generated
