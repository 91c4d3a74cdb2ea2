// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/generated.h"
#include "scene/generated/slab_line.h"
#include "scene/part/body_parts.h"

#include <vector>

namespace frictionbeam::generated {

namespace {

constexpr Word<bool> far_ends[] = {{"free", false}, {"fixed", true}};
constexpr Word<bool> slab_sequences[] = {{"push", false, "the force grows from 0"},
                                         {"cycle", true, "from 0 to Force, to -Force, to Force"}};

/// The slab as n bars of stiffness c on n+1 friction springs: stiffness K and bound Q, half of
/// either at the two ends. K = 0 stands for rigid springs.
struct DiscreteSlab {
  unsigned int n;
  double c, K, Q;
  bool far_end_fixed;

  double weight(const unsigned int i) const { return i == 0 || i == n ? 0.5 : 1.; }
  unsigned int n_springs() const { return far_end_fixed ? n : n + 1; }

  /// Force at node m per displacement there, with nodes m .. n sticking: a tridiagonal system
  /// eliminated from the far end, by sums of positive numbers only, so that no cosh overflows.
  std::vector<double> stiffness_of_rest() const {
    std::vector<double> stiffness(n + 1);
    if (far_end_fixed)
      stiffness[n - 1] = weight(n - 1) * K + c;
    else {
      stiffness[n] = K / 2.;
      stiffness[n - 1] = weight(n - 1) * K + c * stiffness[n] / (c + stiffness[n]);
    }
    for (unsigned int i = n - 1; i-- > 0;)
      stiffness[i] = weight(i) * K + c * stiffness[i + 1] / (c + stiffness[i + 1]);
    return stiffness;
  }

  /**
   * Displacement of the pushed end, exact, for a force >= 0 that grows from zero. Nodes 0 .. m-1
   * slip; what sticks from node m on acts on m as one spring, and the first m whose spring force
   * stays within the bound is the solution. Rigid springs: node m is where the rest of the force
   * stays within the bound, and does not move. Empty if nothing can hold the slab.
   */
  std::optional<double> pushed_end(const double force) const {
    const bool rigid = K == 0.;
    const std::vector<double> stiffness = rigid ? std::vector<double>() : stiffness_of_rest();
    std::vector<double> bar_force; // right of each slipping node
    double force_at_m = force, u = 0.;
    unsigned int m = 0;
    for (; m < n_springs(); ++m) {
      u = rigid ? 0. : force_at_m / stiffness[m];
      if (rigid ? force_at_m <= weight(m) * Q : K * u <= Q)
        break;
      force_at_m -= weight(m) * Q;
      bar_force.push_back(force_at_m);
    }
    if (m == n_springs()) {
      if (!far_end_fixed)
        return std::nullopt;
      u = 0.;
    }
    for (; m > 0; --m)
      u += bar_force[m - 1] / c;
    return u;
  }
};

/**
 * Displacement of the pushed end while the force goes 0, F, -F, F evenly in times of 1 s, by
 * Masing's rule, which is exact for springs of constant bound: from a reversal at F on,
 * u(F - dF) = u(F) - 2 u_virgin(dF/2), and likewise from -F. F must be one that friction holds.
 */
double cycled_end(const DiscreteSlab &slab, const double force, const double time) {
  const double at_reversal = *slab.pushed_end(force);
  if (time <= 1.)
    return *slab.pushed_end(force * time);
  return time <= 2. ? at_reversal - 2. * *slab.pushed_end(force * (time - 1.))
                    : -at_reversal + 2. * *slab.pushed_end(force * (time - 2.));
}

} // namespace

void declare_slab(ParameterReader &in) {
  in.declare_number("Force", 12., "N", 0., 1e300, "At the end x = 0, towards +x.");
  in.declare_number("GS", 1e6, "N", 0., 1e300,
                    "Shear rigidity of a friction element, which is 1 m long; 0: rigid.");
  in.declare_count("Elements", 16, 1, "Of the slab; a friction element at every node.");
  in.declare_number("Length", 8., "m", positive, 1e300, "Of the slab, along x.");
  in.declare_number("Width", 1., "m", positive, 1e300, "Of the slab.");
  in.declare_number("Height", 1., "m", positive, 1e300, "Of the slab.");
  in.declare_number("Pressure", 10., "Pa", positive, 1e300, "That presses it on the surface.");
  in.declare_number("Friction", 0.3, "-", 0., 100., "Coefficient of the surface.");
  in.declare_number("Young's modulus", 1000., "Pa", positive, 1e300, "Of the slab.");
  in.declare_number("Poisson", 0.3, "-", 0., 0.4999, "Ratio of the slab, of the continuum.");
  in.declare_choice("Plane", false, plane_kinds, "Of the continuum in 2D.");
  in.declare_choice("Far end", false, far_ends, "The end at x = Length.");
  in.declare_choice("Sequence", false, slab_sequences, "");
  in.declare_count("Increments", 10, 1, "Of the push, of each leg of the cycle.");
  declare_slab_line(in);
}

namespace {

/// The slab as a bar of n elements, with a friction element at every node, half of one at either
/// end.
void add_bar_on_bed(const ParameterReader &in, const LawLibrary &laws, const SlabLine &line,
                    Scene &scene) {
  const unsigned int n = in.count("Elements");
  const double length = in.number("Length"), b = in.number("Width"), height = in.number("Height");
  const double friction = in.number("Friction"), GS = line.shear_rigidity;
  const double h = length / n, normal_force = in.number("Pressure") * b * h;
  scene.free_motions = {{true, false, false, false, false, false}};
  scene.materials = {
      {"slab", line.axial_modulus, in.number("Poisson"), 0., line.squeeze > 0. ? 1. : 0.}};
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
  if (in.choice("Far end", far_ends))
    scene.restraints.push_back(hold_ux("far_end", last));
}

/// A push at the end x = 0, there and back in a cycle, the squeeze in every step.
void add_pushes(const ParameterReader &in, const SlabLine &line, Scene &scene) {
  Load push;
  push.name = "push";
  push.kind = Load::Kind::force;
  push.at = {{"P0", {{in.number("Force"), 0., 0., 0., 0., 0.}}, {}}};
  scene.loads = {push};
  std::vector<std::pair<unsigned int, double>> squeeze;
  if (line.squeeze > 0.) {
    squeeze = {{1, 1.}};
    scene.loads.push_back(temperature_load("squeeze", line.squeeze));
  }
  const auto step = [&](const std::string &name, const double factor) {
    std::vector<std::pair<unsigned int, double>> loads = squeeze;
    loads.emplace_back(0, factor);
    return static_step(name, loads, in.count("Increments"));
  };
  scene.steps = {step("push", 1.)};
  if (in.choice("Sequence", slab_sequences)) {
    scene.steps.push_back(step("pull", -1.));
    scene.steps.push_back(step("push_again", 1.));
  }
}

} // namespace

void build_slab(const ParameterReader &in, const LawLibrary &laws, Scene &scene) {
  const unsigned int n = in.count("Elements");
  const double length = in.number("Length"), b = in.number("Width"), force = in.number("Force"),
               h = length / n;
  const bool far_end_fixed = in.choice("Far end", far_ends),
             cycle = in.choice("Sequence", slab_sequences);
  const SlabLine line = read_slab_line(in, h);
  add_bar_on_bed(in, laws, line, scene);
  add_pushes(in, line, scene);
  if (scene.model != ModelKind::line)
    build_slab_continuum(in, laws, scene);

  // With the squeeze, N + EA eps is the force in bars without it: pushed by F - EA eps, and pulled
  // at the far end by EA eps, which slides there alone if the interface is rigid.
  const double EA = line.axial_modulus * b * in.number("Height"), GS = line.shear_rigidity,
               locked = EA * line.squeeze,
               bound = in.number("Friction") * (in.number("Pressure") * b * h);
  const DiscreteSlab slab{n, EA / h, GS, bound, far_end_fixed};
  const bool known = locked == 0. || (GS == 0. && !far_end_fixed && !cycle && force > locked &&
                                      force / bound * h + h <= length);
  Quantity u_0;
  u_0.name = "u_0";
  u_0.what = "ux";
  u_0.where = "P0";
  if (known)
    u_0.reference = slab.pushed_end(force - locked);
  u_0.source = "exact solution of the discrete model, bars on friction springs";
  scene.quantities = slab_line_quantities(length, n);
  scene.quantities.insert(scene.quantities.begin(), u_0);
  if (known && !u_0.reference)
    scene.remarks.push_back("The force exceeds what friction can hold: there is no equilibrium.");
  else if (cycle && known) {
    scene.exact = ExactHistory{
        "P0", 0, [=](const double time) { return cycled_end(slab, force, time); }, *u_0.reference};
    Quantity error;
    error.name = error.what = "max_error";
    error.where = "P0";
    error.reference = 0.;
    error.source = "exact solution of the discrete model by Masing's rule";
    scene.quantities.push_back(error);
  }
}

} // namespace frictionbeam::generated
