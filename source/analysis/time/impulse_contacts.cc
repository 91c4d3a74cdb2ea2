// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/time/impulse_contacts.h"
#include "analysis/time/step_helpers.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

namespace {
constexpr double far = 1e30;       // [m]
constexpr double no_corner = 1e-6; ///< of a step: what is behind a corner at its start
constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

ImpulseContacts::ImpulseContacts(const Model &model) : model(model), kinds(model.contacts.size()) {
  const std::vector<bool> with_mass = unknowns_with_mass(model.linear.mass());
  for (unsigned int i = 0; i < kinds.size(); ++i) {
    const Contact &contact = model.contacts[i];
    Kind &kind = kinds[i];
    kind.is_exact = contact.law.has_closed_form();
    if (!kind.is_exact)
      continue;
    kind.law = contact.law.closed_form();
    // A node without mass has no momentum: its contact is one of positions, as in statics.
    bool normal_mass = true, shear_mass = true;
    for (unsigned int j = 0; j < contact.unknowns.size(); ++j)
      if (!with_mass[contact.unknowns[j]]) {
        const auto column = contact.B.col(j);
        const double rounding = no_component * column.norm();
        normal_mass = normal_mass && std::abs(column[0]) <= rounding;
        shear_mass = shear_mass && column.segment<2>(1).norm() <= rounding;
      }
    kind.rigid_normal =
        contact.law.is_rigid_along_normal() && contact.platen_force == 0. && normal_mass;
    kind.rigid_shear = std::isinf(kind.law.shear_rigidity_y) && shear_mass;
  }
}

void ImpulseContacts::set_matrix(const SparseMatrix &matrix) {
  solver = std::make_unique<ExactMethod>(model.scene.solver, model.contacts, matrix);
}

Contact::Strains ImpulseContacts::part(const unsigned int i, const Contact::Strains &stress,
                                       const bool rigid) const {
  Contact::Strains result = Contact::Strains::Zero();
  if (kinds[i].rigid_normal == rigid)
    result[0] = stress[0];
  if (kinds[i].rigid_shear == rigid)
    result.segment<2>(1) = stress.segment<2>(1);
  if (!rigid)
    result[3] = stress[3];
  return result;
}

void ImpulseContacts::take_elastic_forces(const LineState &state, const double factor,
                                          Vector &forces) const {
  for (unsigned int i = 0; i < kinds.size(); ++i)
    model.contacts[i].add_to(forces, part(i, state.contact_stress[i], false), -factor);
}

Vector ImpulseContacts::rigid_forces(const LineState &state) const {
  Vector forces = Vector::Zero(model.space.n_unknowns());
  for (unsigned int i = 0; i < kinds.size(); ++i)
    model.contacts[i].add_to(forces, part(i, state.contact_stress[i], true));
  return forces;
}

Vector ImpulseContacts::impulses() const {
  Vector result = Vector::Zero(model.space.n_unknowns());
  for (unsigned int i = 0; i < rigid_impulse.size(); ++i)
    model.contacts[i].add_to(result, rigid_impulse[i]);
  return result;
}

void ImpulseContacts::set_ground_rates(const EquilibriumProblem &problem, const LineState &from,
                                       const LoadCourse &loads, const double at_end) {
  const bool is_next = from.time != step_begin, follows = from.time == step_end;
  if (!is_next && problem.end == step_end)
    return;
  step_begin = from.time;
  step_end = problem.end;
  if (is_next)
    ground_rate_before.swap(ground_rate);
  ground_rate.assign(kinds.size(), Contact::Strains::Zero());
  if (ground_rate_before.empty() || !loads.imposes_motion())
    ground_rate_before = ground_rate;
  if (!loads.imposes_motion())
    return;
  using Side = LoadCourse::Side;
  const double h = problem.increment.length;
  const Vector before = loads.imposed_rates(step_begin, Side::after, h);
  Vector rate = loads.imposed_rates(step_end, Side::before, h);
  if (!loads.may_jump(step_begin + no_corner * h, step_end))
    rate =
        (loads.imposed(step_end) - loads.imposed(step_begin)) / h + (1. - at_end) * (rate - before);
  const bool begins_anew = (is_next && !follows) || loads.may_jump(step_begin, step_end);
  for (unsigned int i = 0; i < kinds.size(); ++i) {
    ground_rate[i] = model.contacts[i].strain(rate);
    if (begins_anew)
      ground_rate_before[i] = model.contacts[i].strain(before);
  }
}

bool ImpulseContacts::test_reversals(const LineState &from, const Vector &imposed,
                                     const Vector &unknowns) {
  bool any = false;
  for (unsigned int i = 0; i < kinds.size(); ++i) {
    const Kind &kind = kinds[i];
    const Contact &contact = model.contacts[i];
    if (!kind.rigid_shear || kind.law.dynamic_friction == kind.law.static_friction)
      continue;
    double &was_slipping = shifted.internal[contact.state_offset + kind.law.was_slipping];
    const Contact::Strains before =
                               contact.strain_by_unknowns(from.velocity) + ground_rate_before[i],
                           motion = contact.strain_by_unknowns(unknowns) + contact.strain(imposed);
    const double slip_y = motion[1] - shifted.internal[contact.state_offset + kind.law.slip_y],
                 slip_z = motion[2] - shifted.internal[contact.state_offset + kind.law.slip_z];
    if (was_slipping != 0. && before[1] * slip_y + before[2] * slip_z < 0.) {
      was_slipping = 0.;
      any = true;
    }
  }
  return any;
}

void ImpulseContacts::set_laws(const EquilibriumProblem &problem, const LineState &from,
                               const Relation &relation) {
  const double step = problem.increment.length;
  shifted = from.contacts;
  overrides.gap.assign(kinds.size(), 0.);
  overrides.friction_scale.assign(kinds.size(), 1.);
  overrides.patch_scale.assign(kinds.size(), 1.);
  for (unsigned int i = 0; i < kinds.size(); ++i) {
    const Kind &kind = kinds[i];
    if (!kind.is_exact)
      continue;
    const Contact &contact = model.contacts[i];
    const double l = contact.length;
    overrides.gap[i] = kind.law.gap;
    const Contact::Strains base = contact.strain_by_unknowns(relation.base) +
                                  contact.strain(problem.imposed) - relation.reach * ground_rate[i];
    if (kind.rigid_normal) {
      const double approach =
                       l * (contact.strain_by_unknowns(from.velocity) + ground_rate_before[i])[0],
                   gap = l * from.contacts.strain[i][0] + kind.law.gap;
      const bool takes_part =
          from.contact_status[i] != ContactStatus::open || gap + step / 2. * approach <= 1e-12 * l;
      overrides.gap[i] =
          takes_part ? -l * base[0] + relation.reach * contact.restitution * std::min(approach, 0.)
                     : far;
    }
    if (kind.rigid_shear) {
      shifted.internal[contact.state_offset + kind.law.slip_y] = base[1];
      shifted.internal[contact.state_offset + kind.law.slip_z] = base[2];
    }
    if (kind.rigid_normal != kind.rigid_shear)
      overrides.friction_scale[i] = kind.rigid_normal ? relation.share : 1. / relation.share;
    if (kind.rigid_shear) // the scale above is that of impulses, and moments are forces
      overrides.patch_scale[i] = relation.share;
  }
}

EquilibriumResult ImpulseContacts::solve(EquilibriumProblem &problem, const LineState &from,
                                         const LoadCourse &loads, const Relation &relation,
                                         Vector &unknowns, ContactResponse &response) {
  constexpr double rounding = 1e-12;
  const double half = problem.increment.length / 2.;
  motion_is_mean = std::abs(relation.reach - half) <= rounding * half;
  set_ground_rates(problem, from, loads, relation.at_end);
  set_laws(problem, from, relation);
  problem.overrides = &overrides;
  // Where supports share a force that the line does not tell apart, each keeps what it had.
  std::vector<Contact::Strains> stress(kinds.size());
  for (unsigned int i = 0; i < kinds.size(); ++i)
    stress[i] = part(i, from.contact_stress[i], true) / relation.share +
                part(i, from.contact_stress[i], false);
  solver->guess(stress);
  const Vector guess = unknowns;
  EquilibriumResult result = solver->solve(problem, shifted, unknowns, response);
  while (result.converged && test_reversals(from, problem.imposed, unknowns)) {
    const EquilibriumResult first = result;
    unknowns = guess;
    result = solver->solve(problem, shifted, unknowns, response);
    result.iterations += first.iterations;
    result.factorizations += first.factorizations;
    result.back_substitutions += first.back_substitutions;
  }
  if (result.converged)
    take_impulses(from, relation.share, problem.increment.length, response);
  return result;
}

void ImpulseContacts::take_impulses(const LineState &from, const double share, const double step,
                                    ContactResponse &response) {
  rigid_impulse.resize(kinds.size());
  contact_work.assign(kinds.size(), {Contact::Strains::Zero(), Contact::Strains::Zero()});
  for (unsigned int i = 0; i < kinds.size(); ++i) {
    const Contact &contact = model.contacts[i];
    const Kind &kind = kinds[i];
    const Contact::Strains rigid = share * part(i, response.stress[i], true),
                           elastic = part(i, response.stress[i], false);
    rigid_impulse[i] = -step * rigid;
    response.stress[i] = rigid + elastic;
    contact_work[i].mean_stress = rigid + (elastic + part(i, from.contact_stress[i], false)) / 2.;
    if (kind.is_exact)
      contact_work[i].rigidity << (contact.platen_force != 0. ? infinity : kind.law.axial_rigidity),
          kind.law.shear_rigidity_y, kind.law.shear_rigidity_z, kind.law.torsional_rigidity;
  }
}

void ImpulseContacts::take_mean_velocities(const LineState &from, const double step,
                                           const LineState &to) {
  for (unsigned int i = 0; i < kinds.size(); ++i) {
    const Contact &contact = model.contacts[i];
    const Contact::Strains line =
                               step / 2. * contact.strain_by_unknowns(from.velocity + to.velocity),
                           ground = step / 2. * (ground_rate_before[i] + ground_rate[i]),
                           motion = to.contacts.strain[i] - from.contacts.strain[i],
                           of_line = contact.strain_by_unknowns(to.unknowns - from.unknowns);
    beyond[i] = part(i, line + ground - motion, true);
    const Contact::Strains work =
        contact.weight * contact_work[i].mean_stress.cwiseProduct(beyond[i]);
    of_impulses.impact += work[0];
    of_impulses.dissipated += work[1] + work[2];
    of_impulses.external += contact.weight * contact_work[i].mean_stress.dot(
                                                 part(i, ground - (motion - of_line), true));
  }
}

void ImpulseContacts::add_histories(const LineState &from, const double step, LineState &to) {
  beyond.assign(kinds.size(), Contact::Strains::Zero());
  of_impulses = {};
  if (!motion_is_mean)
    take_mean_velocities(from, step, to);
  for (unsigned int i = 0; i < kinds.size(); ++i) {
    const Contact &contact = model.contacts[i];
    const double normal = contact.share() * -contact_work[i].mean_stress[0];
    to.contacts.impulse[i] = from.contacts.impulse[i] + step * normal;
    to.contacts.wear[i] = from.contacts.wear[i];
    const Contact::Strains change = to.contacts.strain[i] - from.contacts.strain[i] + beyond[i];
    if (!kinds[i].is_exact) { // its law alone knows what slips: all, where it says that it does
      if (slides(to.contact_status[i], to.contact_stress[i]))
        to.contacts.wear[i] += std::max(0., normal) * contact.length * change.segment<2>(1).norm();
      continue;
    }
    const FrictionThreshold &law = kinds[i].law;
    const Contact::Strains force_change =
        part(i, to.contact_stress[i], false) - part(i, from.contact_stress[i], false);
    const double slip_y = change[1] - force_change[1] / law.shear_rigidity_y,
                 slip_z = change[2] - force_change[2] / law.shear_rigidity_z;
    double twist = 0.;
    if (law.torsional_rigidity > 0.)
      twist = change[3] - force_change[3] / law.torsional_rigidity;
    const Contact::Strains &mean = contact_work[i].mean_stress;
    to.contacts.dissipated[i] =
        from.contacts.dissipated[i] +
        contact.weight * (mean[1] * slip_y + mean[2] * slip_z + mean[3] * twist);
    // What sticks at the end may have slipped before: an impact that stops it.
    to.contacts.wear[i] += normal * contact.length * std::hypot(slip_y, slip_z);
  }
}

} // namespace frictionbeam
