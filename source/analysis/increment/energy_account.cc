// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/increment/energy_account.h"

#include "model/line_pose.h"
#include "model/unknowns/line_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

double EnergyAccount::left_over() const {
  return external - stored - kinetic - dissipated - inelastic - gaps - damping - impact;
}

double EnergyAccount::imbalance() const {
  const double scale = std::max(at_hand > 0. ? at_hand : turnover, least_scale);
  return scale > 0. ? std::abs(left_over()) / scale : 0.;
}

EnergyAccount &EnergyAccount::operator+=(const EnergyAccount &other) {
  external += other.external;
  stored += other.stored;
  dissipated += other.dissipated;
  inelastic += other.inelastic;
  gaps += other.gaps;
  kinetic += other.kinetic;
  damping += other.damping;
  impact += other.impact;
  at_hand = std::max(at_hand, other.at_hand);
  missed_friction += other.missed_friction;
  turnover += other.turnover;
  least_scale += other.least_scale;
  return *this;
}

namespace {

/// What slips of a contact between two states; for laws with a closed form.
Contact::Strains slip_between(const Contact &contact, const LineState &before,
                              const LineState &after) {
  const FrictionThreshold &law = contact.law.closed_form();
  const auto slip = [&](const int place) {
    return after.contacts.internal[contact.state_offset + place] -
           before.contacts.internal[contact.state_offset + place];
  };
  return {0., slip(law.slip_y), slip(law.slip_z), slip(law.twist)};
}

/// Share of one contact whose law alone knows what it has lost.
void account_by_law(const Contact &contact, const unsigned int i, const Contact::Strains &mean,
                    const LineState &before, const LineState &after, EnergyAccount &account) {
  const double lost = after.contacts.dissipated[i] - before.contacts.dissipated[i];
  account.dissipated += lost;
  account.stored +=
      contact.weight * mean.dot(after.contacts.strain[i] - before.contacts.strain[i]) - lost;
}

/// Share of one contact: its strain increment in parts that store, open a gap and slip.
void account_contact(const Contact &contact, const unsigned int i, const LineState &before,
                     const LineState &after, EnergyAccount &account) {
  const Contact::Strains change = after.contacts.strain[i] - before.contacts.strain[i],
                         force = (before.contact_stress[i] + after.contact_stress[i]) / 2.,
                         force_change = after.contact_stress[i] - before.contact_stress[i];
  const FrictionThreshold &law = contact.law.closed_form();
  const Contact::Strains slipped = slip_between(contact, before, after);
  const double normal_elastic = force_change[0] / law.axial_rigidity;
  account.gaps += contact.weight * force[0] * (change[0] - normal_elastic);
  account.stored += contact.weight * (force[0] * normal_elastic +
                                      force.tail<3>().dot(change.tail<3>() - slipped.tail<3>()));
  account.dissipated += contact.weight * force.dot(slipped);
  account.missed_friction += contact.weight * std::abs(force_change.dot(slipped)) / 2.;
}

} // namespace

double friction_work(const Contact &contact, const unsigned int i, const LineState &before,
                     const LineState &after) {
  const Contact::Strains slipped = slip_between(contact, before, after),
                         &from = before.contact_stress[i], &to = after.contact_stress[i];
  const double at_end = to.dot(slipped);
  double where_slip_begins = std::max(from.dot(slipped), at_end);
  if (to[0] < 0.) // the limit's share of the end, at the normal force of the beginning
    where_slip_begins = std::min(where_slip_begins, at_end * (from[0] / to[0]));
  return contact.weight * (where_slip_begins + at_end) / 2.;
}

EnergyAccount account_contacts(const Model &model, const LineState &before, const LineState &after,
                               const std::vector<ContactWork> &work) {
  EnergyAccount account;
  const Vector motion = after.unknowns - before.unknowns;
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    const Contact::Strains change = after.contacts.strain[i] - before.contacts.strain[i];
    Contact::Strains mean = (before.contact_stress[i] + after.contact_stress[i]) / 2.;
    EnergyAccount share;
    if (i < work.size())
      mean = work[i].mean_stress;
    if (!contact.law.has_closed_form())
      account_by_law(contact, i, mean, before, after, share);
    else if (i < work.size()) {
      for (int e = 0; e < n_support_strains; ++e) {
        const double s0 = before.contact_stress[i][e], s1 = after.contact_stress[i][e],
                     rigidity = work[i].rigidity[e];
        const double stored = std::isfinite(rigidity) && rigidity > 0.
                                  ? contact.weight * (s1 * s1 - s0 * s0) / (2. * rigidity)
                                  : 0.;
        share.stored += stored;
        const double lost = contact.weight * mean[e] * change[e] - stored;
        (e > 0 ? share.dissipated : std::isfinite(rigidity) ? share.gaps : share.impact) += lost;
      }
    } else
      account_contact(contact, i, before, after, share);
    // What of the contact's strain comes from imposed motions, and not from the unknowns.
    const Contact::Strains imposed = change - contact.strain_by_unknowns(motion);
    share.external = contact.weight * mean.dot(imposed);
    share.turnover = std::abs(share.stored) + std::abs(share.dissipated) + std::abs(share.gaps) +
                     std::abs(share.impact);
    // Where the ground takes along what nothing holds, all else is zero.
    share.least_scale =
        contact.weight * model.scene.solver.tolerance * mean.norm() * imposed.norm();
    account += share;
  }
  return account;
}

EnergyAccount account_imposed(const Model &model, const LineState &before, const LineState &after,
                              const double h) {
  EnergyAccount account;
  const LinearPart &line = model.linear;
  const Eigen::MatrixXd &damping = line.imposed_products().damping;
  if (damping.size() == 0)
    return account;
  account.stored = line.stored_by_imposed(after.load_factors, after.unknowns) -
                   line.stored_by_imposed(before.load_factors, before.unknowns);
  account.external = account.stored;
  if (after.load_rates.empty() || before.load_rates.empty())
    return account;
  account.kinetic = line.kinetic_by_imposed(after.load_rates, after.velocity) -
                    line.kinetic_by_imposed(before.load_rates, before.velocity);
  const auto as_vector = [](const std::vector<double> &values) {
    return Eigen::Map<const Vector>(values.data(), values.size());
  };
  const Vector motion = after.unknowns - before.unknowns, change = after.velocity - before.velocity,
               mean_velocity = (after.velocity + before.velocity) / 2.,
               rates = (as_vector(after.load_rates) + as_vector(before.load_rates)) / 2.,
               rate_changes = as_vector(after.load_rates) - as_vector(before.load_rates);
  // The forces on the unknowns do not work, the reactions do.
  account.external += rates.dot(line.imposed_products().mass * rate_changes);
  account.damping = h * rates.dot(damping * rates);
  for (int l = 0; l < rates.size(); ++l)
    if (line.accelerates(l)) {
      account.external -= rate_changes[l] * line.inertia(l).dot(motion) / h +
                          rates[l] * line.inertia(l).dot(change);
      account.damping -= rates[l] * line.drag(l).dot(motion + h * mean_velocity);
    }
  account.external += account.damping;
  return account;
}

namespace {

/// a . M b in extended precision: the terms of a stiff line's energy may be 1e8 times the energy.
double product(const Vector &a, const SparseMatrix &M, const Vector &b) {
  long double sum = 0.L;
  for (int i = 0; i < M.outerSize(); ++i) {
    long double row = 0.L;
    for (SparseMatrix::InnerIterator entry(M, i); entry; ++entry)
      row += static_cast<long double>(entry.value()) * b[entry.col()];
    sum += row * a[i];
  }
  return static_cast<double>(sum);
}

} // namespace

EnergyAccount account_increment(const Model &model, const LineState &before, const LineState &after,
                                const Vector &loads_before, const Vector &loads_after) {
  EnergyAccount account;
  const Vector motion = after.unknowns - before.unknowns;
  account.external = (loads_before + loads_after).dot(motion) / 2.;
  account.stored = product(before.unknowns + after.unknowns, model.linear.stiffness(), motion) / 2.;
  account.turnover = std::abs(account.external) + std::abs(account.stored);
  account += account_imposed(model, before, after, 0.);
  return account += account_contacts(model, before, after, {});
}

namespace {

/// Work that rounding of the cells' forces, K |u| in its last bits, does on a motion [J]; in large
/// displacements K |x|, for their chords are differences of places x.
double work_of_rounding(const Model &model, const LineState &after, const Vector &motion) {
  if (motion.size() == 0)
    return 0.;
  constexpr double last_bits = 8. * std::numeric_limits<double>::epsilon();
  const double moved = after.unknowns.lpNorm<Eigen::Infinity>() +
                       (model.cells.turns_far() ? largest_coordinate(model.discretization) : 0.);
  return last_bits * moved *
         Vector(model.linear.stiffness().diagonal()).cwiseAbs().dot(motion.cwiseAbs());
}

} // namespace

EnergyAccount account_cells(const Model &model, const LineState &before, const LineState &after,
                            const std::vector<double> &factors_before, const Vector &imposed) {
  const LineCells &line = model.cells;
  const Pose from = pose_of(before), to = pose_of(after);
  std::vector<double> factors(after.load_factors);
  for (unsigned int l = 0; l < factors.size(); ++l)
    factors[l] = (factors[l] + factors_before[l]) / 2.;
  LineCells::Balance mean;
  const Vector change = line.change(from, to);
  line.evaluate({from, line.halfway(from, to), to, change}, factors, mean);
  EnergyAccount account;
  account.external = mean.loads.dot(change) + mean.free_work +
                     model.contacts.platen_forces().dot(after.unknowns - before.unknowns) +
                     (mean.internal - mean.loads).dot(imposed);
  account.stored = line.stored_energy(to) - line.stored_energy(from);
  if (line.pipe_sections().any())
    account.inelastic = line.pipe_sections().dissipated(after.sections) -
                        line.pipe_sections().dissipated(before.sections);
  account.turnover =
      std::abs(account.external) + std::abs(account.stored) + std::abs(account.inelastic);
  account.least_scale = work_of_rounding(model, after, after.unknowns - before.unknowns);
  return account;
}

EnergyAccount account_motion(const Model &model, const LineState &before, const LineState &after,
                             const MotionProducts &products, const Vector &loads_before,
                             const Vector &loads_after, const std::vector<ContactWork> &work) {
  EnergyAccount account;
  const Vector motion = after.unknowns - before.unknowns;
  account.external = (loads_before + loads_after).dot(motion) / 2.;
  // As differences of energies: rounding errors of the products do not add up over the steps.
  const double stored = after.unknowns.dot(products.stiff_after) / 2.,
               kinetic = after.velocity.dot(products.momentum_after) / 2.;
  account.stored = stored - before.unknowns.dot(products.stiff_before) / 2.;
  account.kinetic = kinetic - before.velocity.dot(products.momentum_before) / 2.;
  if (model.linear.damping().nonZeros() > 0)
    account.damping = (before.velocity + after.velocity).dot(model.linear.damping() * motion) / 2.;
  account.at_hand = stored + kinetic +
                    model.linear.stored_by_imposed(after.load_factors, after.unknowns) +
                    model.linear.kinetic_by_imposed(after.load_rates, after.velocity);
  account += account_imposed(model, before, after, after.time - before.time);
  account.turnover =
      std::abs(account.external) + std::abs(account.stored) + std::abs(account.kinetic);
  return account += account_contacts(model, before, after, work);
}

} // namespace frictionbeam
