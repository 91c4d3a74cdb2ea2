// SPDX-License-Identifier: LGPL-2.1-or-later
// The law of one contact, branch by branch, and how it is used: a method moves the centre to the
// force it answers until both are the same, which is the exact contact.
#include "../check.h"
#include <frictionbeam/contact/proximal_law.h>
#include <frictionbeam/disc_projection.h>

#include <cmath>
#include <limits>

using namespace frictionbeam;
using namespace frictionbeam::contact;

namespace {

constexpr double rigid = std::numeric_limits<double>::infinity();

/// Friction 0.5, and 0.4 while slipping, with rigidities ES and GS [N] of the element.
FrictionThreshold make_law(const double ES, const double GS) {
  return {0.5, 0.4, 0., ES, GS, GS, 0., 0., 0, 1, 2, 3};
}

/// A friction element half a metre long, its ground displaced by u [m] and turned; rho = 100 N/m.
contact::ProximalPoint at(const Strains &u, const Strains &centre = Strains::Zero()) {
  return {u / 0.5, 0.5, 0.5, 0., 100., 100., centre};
}

/// The tangent shall be the derivative of the stress.
void check_tangent(const FrictionThreshold &law, const contact::ProximalPoint &point) {
  const contact::ProximalAnswer answer = contact::proximal_law(law, point, {});
  for (int e = 0; e < n_support_strains; ++e) {
    contact::ProximalPoint after = point, before = point;
    after.strain[e] += 1e-7;
    before.strain[e] -= 1e-7;
    const Strains rise = contact::proximal_law(law, after, {}).stress -
                         contact::proximal_law(law, before, {}).stress;
    CHECK((rise / 2e-7 - answer.tangent.col(e)).norm() <= 1e-5 * (1. + answer.tangent.norm()));
  }
}

} // namespace

int main() {
  const FrictionThreshold law = make_law(rigid, rigid), elastic = make_law(50., 30.);
  // Open: no force, and the slip follows the node.
  const contact::ProximalAnswer open = contact::proximal_law(law, at({1e-3, 2e-3, 0., 0.}), {});
  CHECK(open.status == ContactStatus::open && open.stress.isZero(0.) && open.slip.y == 4e-3);
  CHECK(contact::proximal_law(law, at({0., 0., 0., 0.}), {}).status ==
        ContactStatus::stick); // touching

  // Sticking: 100 N/m times what the ground is moved.
  const contact::ProximalPoint pressed = at({-0.02, 5e-3, 0., 0.});
  const contact::ProximalAnswer sticks = contact::proximal_law(law, pressed, {});
  CHECK(sticks.status == ContactStatus::stick && !sticks.slip.slips);
  CHECK((sticks.stress - Strains(-2., 0.5, 0., 0.)).norm() <= 1e-14);
  check_tangent(law, pressed);

  // Slipping: f P against the motion, in its direction, and what that dissipates in an element.
  const contact::ProximalPoint pushed = at({-0.02, 0.03, 0.04, 0.});
  const contact::ProximalAnswer slips = contact::proximal_law(law, pushed, {});
  CHECK(slips.status == ContactStatus::slip && slips.slip.slips);
  CHECK((slips.stress - Strains(-2., 0.6, 0.8, 0.)).norm() <= 1e-14);
  CHECK_NEAR(slips.dissipated, 0.6 * 0.06 + 0.8 * 0.08, 1e-14);
  check_tangent(law, pushed);

  // The exact contact, whatever rho is: the centre at the force, no gap, slip along the friction.
  contact::ProximalPoint exact = at({0., 0.03, 0.04, 0.}, {-2., 0.6, 0.8, 0.});
  for (const double rho : {1., 1e4}) {
    exact.normal_rho = exact.shear_rho = rho;
    CHECK((contact::proximal_law(law, exact, {}).stress - exact.centre).norm() <= 1e-13);
  }

  // What misses the centre is told where rounding of the force hides it: a gap of 1e-17 m, and a
  // slip of 5 * 2^-58 m across the friction force, beside kilonewtons.
  const contact::ProximalPoint touching = at({1e-17, 0., 0., 0.}, {-3e3, 0., 0., 0.});
  CHECK_NEAR(contact::proximal_law(law, touching, {}).misfit[0], 1e-15, 1e-12);
  CHECK(contact::proximal_law(law, touching, {}).stress[0] == -3e3);
  const double across = std::ldexp(1., -58), along = std::ldexp(1., -10);
  const contact::ProximalAnswer turning = contact::proximal_law(
      law, at({0., 3. * along - 4. * across, 4. * along + 3. * across, 0.}, {-2e3, 6e2, 8e2, 0.}),
      {});
  CHECK(turning.status == ContactStatus::slip);
  const double shrunk = 1e3 / (1e3 + 100. * 5. * along);
  CHECK_NEAR(0.6 * turning.misfit[2] - 0.8 * turning.misfit[1], 100. * 5. * across * shrunk, 0.1);

  // An elastic element stands in series with rho; with the centre at its force it is alone.
  CHECK_NEAR(contact::proximal_law(elastic, at({-0.02, 0., 0., 0.}), {}).stress[0], -1., 1e-14);
  const contact::ProximalPoint at_force = at({-0.02, 0., 0., 0.}, {-2., 0., 0., 0.});
  CHECK_NEAR(contact::proximal_law(elastic, at_force, {}).stress[0], -2., 1e-14);
  CHECK_NEAR(contact::proximal_law(elastic, pushed, {}).slip.y, 0.06 - 0.3 / 30., 1e-14);
  check_tangent(elastic, pushed);

  // Without friction in force nothing holds across.
  contact::ProximalPoint smooth = pushed;
  smooth.friction = 0.;
  const contact::ProximalAnswer glides = contact::proximal_law(law, smooth, {});
  CHECK(glides.status == ContactStatus::slip && !glides.slip.slips && glides.stress[1] == 0.);

  // A prescribed pressure is the normal force, and has no tangent.
  contact::ProximalPoint loaded = pushed;
  loaded.pressure = 4.;
  CHECK_NEAR(contact::proximal_law(law, loaded, {}).stress[0], -4., 1e-14);
  CHECK(contact::proximal_law(law, loaded, {}).tangent.col(0).isZero(0.));
  check_tangent(law, loaded);

  // Torsion of 3 N m2, at most f P r = 0.1 N m on a patch of 0.1 m.
  FrictionThreshold patch = law;
  patch.torsional_rigidity = 3.;
  patch.patch_radius = 0.1;
  CHECK_NEAR(contact::proximal_law(patch, at({-0.02, 0., 0., 0.01}), {}).stress[3], 0.06, 1e-14);
  const contact::ProximalPoint turned = at({-0.02, 0., 0., 0.05});
  CHECK_NEAR(contact::proximal_law(patch, turned, {}).stress[3], 0.1, 1e-14);
  CHECK_NEAR(contact::proximal_law(patch, turned, {}).slip.twist, 0.1 - 0.1 / 3., 1e-14);
  check_tangent(patch, turned);
  // Against friction that does not turn, the force is held to the last bit, and so are the factors.
  const double trial[2] = {-0.7, 0.}, k[2] = {3., 3.};
  const DiscProjection on_ray(trial, k, 0.1);
  CHECK(on_ray.point[0] == -0.1 && on_ray.by_radius[0] == -1. && on_ray.by_trial[0][0] == 0.);
  CHECK_NEAR(on_ray.by_trial[1][1], 1. / 7., 1e-15);

  return check::report();
}
