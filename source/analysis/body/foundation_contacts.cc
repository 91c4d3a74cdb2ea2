// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/body/foundation_contacts.h"

#include <frictionbeam/contact/proximal_law.h>

#include "base/user_error.h"
#include <frictionbeam/law_library.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

FoundationContacts::FoundationContacts(const ContinuumScene &scene, const LawLibrary &laws,
                                       const bool exact, const std::vector<FoundationPoint> &points)
    : points(points) {
  for (const ContinuumContact &contact : scene.contacts) {
    const BoundLaw bound(laws.find(contact.law), contact.parameters);
    const FrictionThreshold &law = bound.closed_form();
    if (bound.has_closed_form() && !exact &&
        ((law.static_friction > 0. &&
          (std::isinf(law.shear_rigidity_y) || std::isinf(law.shear_rigidity_z))) ||
         (!contact.pressure && std::isinf(law.axial_rigidity))))
      throw UserError("Solver/Method = newton takes a surface of finite stiffness, and '" +
                      contact.part +
                      "' is rigid. Give it one (Slab/GS; Long bar/Normal stiffness and Shear "
                      "stiffness; Body/Axial rigidity and Shear rigidity), or take Solver/Method = "
                      "exact, which has rigid contact.");
    surfaces.push_back({bound, contact.pressure, exact && bound.has_closed_form()});
  }
  for (const FoundationPoint &point : points) {
    offset.push_back(n_internal);
    n_internal += surfaces[point.surface].law.n_internal_variables();
  }
  centre.assign(points.size(), LocalVector::Zero());
  friction.assign(points.size(), 0.);
}

FoundationState FoundationContacts::initial_state() const {
  FoundationState state;
  state.internal.assign(n_internal, 0.);
  state.stress.assign(points.size(), LocalVector::Zero());
  for (unsigned int i = 0; i < points.size(); ++i)
    if (has_pressure(i))
      state.stress[i][0] = -*surfaces[points[i].surface].pressure;
  state.touch = std::vector<LocalVector>(points.size(), LocalVector::Zero());
  state.status.assign(points.size(), ContactStatus::none);
  state.dissipated.assign(points.size(), 0.);
  return state;
}

void FoundationContacts::begin(const FoundationState &committed) {
  for (unsigned int i = 0; i < points.size(); ++i)
    if (is_exact(i)) {
      const FrictionThreshold &law = surfaces[points[i].surface].law.closed_form();
      friction[i] = committed.internal[offset[i] + law.was_slipping] != 0. ? law.dynamic_friction
                                                                           : law.static_friction;
    }
}

bool FoundationContacts::let_slipping_go(const FoundationState &state) {
  bool changed = false;
  for (unsigned int i = 0; i < points.size(); ++i) {
    if (!is_exact(i) || state.status[i] != ContactStatus::slip)
      continue;
    const double dynamic = surfaces[points[i].surface].law.closed_form().dynamic_friction;
    changed |= friction[i] > dynamic;
    friction[i] = std::min(friction[i], dynamic);
  }
  return changed;
}

void FoundationContacts::evaluate(const std::vector<LocalVector> &displacement,
                                  const FoundationState &committed, const LawIncrement &increment,
                                  FoundationResponse &response) const {
  response.state = committed;
  response.tangent.assign(points.size(), LocalMatrix::Zero());
  response.misfit.assign(points.size(), LocalVector::Zero());
  response.failed = false;
  for (unsigned int i = 0; i < points.size(); ++i) {
    if (is_exact(i))
      evaluate_exact(i, displacement[i], committed, response);
    else if (!evaluate_law(i, displacement[i], committed, increment, response))
      response.failed = true;
  }
}

void FoundationContacts::evaluate_exact(const unsigned int i, const LocalVector &u,
                                        const FoundationState &committed,
                                        FoundationResponse &response) const {
  const FoundationPoint &point = points[i];
  const Surface &surface = surfaces[point.surface];
  const FrictionThreshold &law = surface.law.closed_form();
  Contact::Strains strain, around;
  strain << -u, 0.; // of elements 1 m long to the ground
  around << centre[i], 0.;
  const contact::ProximalAnswer answer = contact::proximal_law(
      law,
      {strain, 1., friction[i], law.gap, stiffness_factor * point.normal_diagonal,
       stiffness_factor * point.shear_diagonal, around, surface.pressure},
      contact::Slip::read(law, committed.internal.data() + offset[i]));
  FoundationState &state = response.state;
  state.stress[i] = answer.stress.head<3>();
  response.misfit[i] = answer.misfit.head<3>();
  response.tangent[i] = -answer.tangent.topLeftCorner<3, 3>();
  state.status[i] = answer.status;
  answer.slip.write(law, state.internal.data() + offset[i]);
  if (answer.status == ContactStatus::open)
    state.touch[i] = u;
  state.dissipated[i] += answer.dissipated;
}

bool FoundationContacts::evaluate_law(const unsigned int i, const LocalVector &u,
                                      const FoundationState &committed,
                                      const LawIncrement &increment,
                                      FoundationResponse &response) const {
  const Surface &surface = surfaces[points[i].surface];
  constexpr int n = n_support_strains;
  double strain[n] = {-u[0], -u[1], -u[2], 0.}, rate[n] = {}, stress[n], tangent[n * n];
  LawOutput out{stress, tangent, response.state.internal.data() + offset[i], 0.,
                ContactStatus::none};
  const auto integrate = [&]() {
    return surface.law.integrate(strain, rate, 1., increment, committed.internal.data() + offset[i],
                                 LawTangent::consistent, out) == LawStatus::ok;
  };
  if (!integrate())
    return false;
  if (surface.pressure) { // the normal strain that gives it, by Newton's method
    const double P = *surface.pressure;
    for (unsigned int iteration = 0; std::abs(stress[0] + P) > 1e-13 * P; ++iteration) {
      if (iteration == 50)
        return false;
      // an open contact has no stiffness: close it
      strain[0] -= tangent[0] > 0. ? (stress[0] + P) / tangent[0] : std::abs(strain[0]) + 1e-9;
      if (!integrate())
        return false;
    }
  }
  LocalMatrix &D = response.tangent[i];
  for (int a = 0; a < 3; ++a) {
    response.state.stress[i][a] = stress[a];
    for (int b = 0; b < 3; ++b)
      D(a, b) = -tangent[n * a + b];
  }
  if (surface.pressure) { // d eps follows from d N = 0
    const LocalVector by_strain = D.col(0) / D(0, 0);
    const Eigen::RowVector3d normal = D.row(0);
    D -= by_strain * normal;
  }
  response.state.status[i] = out.contact;
  response.state.dissipated[i] = committed.dissipated[i] + out.dissipation;
  if (out.contact == ContactStatus::open)
    response.state.touch[i] = u;
  return true;
}

LocalVector FoundationContacts::by_centre(const unsigned int i) const {
  if (!is_exact(i))
    return LocalVector::Zero();
  const double shear = 1. / (stiffness_factor * points[i].shear_diagonal);
  return {1. / (stiffness_factor * points[i].normal_diagonal), shear, shear};
}

bool FoundationContacts::are_exact() const {
  return std::any_of(surfaces.begin(), surfaces.end(),
                     [](const Surface &surface) { return surface.exact; });
}

bool FoundationContacts::gives_utmost(const unsigned int i, const FoundationState &state,
                                      const LocalVector &rate, const double largest) const {
  const auto sliding = rate.tail<2>();
  const double size = has_pressure(i) ? sliding.norm() : rate.norm();
  if (size <= 1e-6 * largest || (state.status[i] == ContactStatus::open && rate[0] <= 1e-6 * size))
    return true;
  if (!is_exact(i) || (!has_pressure(i) && std::abs(rate[0]) > 1e-6 * size))
    return false; // pressed on: the contact will resist more
  const double most = friction[i] * -state.stress[i][0];
  return most == 0. ||
         -state.stress[i].tail<2>().dot(sliding) >= (1. - 1e-6) * most * sliding.norm();
}

std::vector<std::optional<double>> FoundationContacts::most_friction() const {
  std::vector<std::optional<double>> result(points.size());
  for (unsigned int i = 0; i < points.size(); ++i) {
    const BoundLaw &law = surfaces[points[i].surface].law;
    if (!has_pressure(i) && law.has_closed_form())
      result[i] = std::max(law.closed_form().static_friction, law.closed_form().dynamic_friction);
  }
  return result;
}

FoundationContacts::Rest FoundationContacts::rest(const unsigned int i,
                                                  const FoundationState &committed) const {
  const FrictionThreshold &law = surfaces[points[i].surface].law.closed_form();
  const double *const old_state = committed.internal.data() + offset[i];
  return {{law.gap, old_state[law.slip_y], old_state[law.slip_z]},
          {1. / law.axial_rigidity, 1. / law.shear_rigidity_y, 1. / law.shear_rigidity_z}};
}

double FoundationContacts::gap(const unsigned int i, const LocalVector &displacement) const {
  if (has_pressure(i))
    return 0.;
  return surfaces[points[i].surface].law.gap() - displacement[0];
}

LocalVector FoundationContacts::slip(const unsigned int i, const LocalVector &displacement,
                                     const FoundationState &state) const {
  LocalVector slip = displacement - state.touch[i];
  slip[0] = 0.;
  return slip;
}

contact::Check FoundationContacts::check(const std::vector<LocalVector> &displacement,
                                         const FoundationState &state,
                                         const FoundationState &committed, const double largest,
                                         const double rounding) const {
  contact::Check result;
  for (unsigned int i = 0; i < points.size(); ++i) {
    if (!is_exact(i))
      continue;
    const FrictionThreshold &law = surfaces[points[i].surface].law.closed_form();
    const LocalVector &u = displacement[i], &stress = state.stress[i];
    const double *const old_state = committed.internal.data() + offset[i];
    const double P = -stress[0];
    result.judge({P,
                  {stress[1], stress[2]},
                  has_pressure(i) ? 0. : law.gap - u[0] + P / law.axial_rigidity,
                  {-u[1] - old_state[law.slip_y] - stress[1] / law.shear_rigidity_y,
                   -u[2] - old_state[law.slip_z] - stress[2] / law.shear_rigidity_z},
                  friction[i],
                  points[i].normal_diagonal,
                  points[i].shear_diagonal,
                  rounding},
                 largest);
    result.least_dissipation =
        std::min(result.least_dissipation,
                 points[i].weight * (state.dissipated[i] - committed.dissipated[i]));
  }
  return result;
}

} // namespace frictionbeam
