// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/event_integrator.h"

namespace frictionbeam {

void EventIntegrator::transfer(Archive &archive) {
  archive(motion, fallback, states, displacement, force, unknowns, velocity, present, fastest,
          farthest, strongest, ground_may_jump, at_rest_on_ground, bounces, imposed_rates,
          imposed_accelerations, n_events, n_handed_over, n_unresolved, goes_straight_on,
          first_handed_over, time_handed_over, n_unshared, reason);
}

void EventIntegrator::write(const LoadCourse &loads, LineState &to) const {
  to.time = present;
  to.unknowns = unknowns;
  to.velocity = velocity;
  to.load_factors = loads.factors(present);
  to.load_rates.clear();
  to.load_accelerations.clear();
  write_contacts(loads.imposed(present), force, to);
  Vector left = loads.forces(present);
  for (unsigned int l = 0; l < imposed_rates.size(); ++l)
    if (model.linear.accelerates(l)) {
      left += imposed_accelerations[l] * model.linear.inertia(l) +
              imposed_rates[l] * model.linear.drag(l);
      to.load_rates = imposed_rates;
      to.load_accelerations = imposed_accelerations;
    }
  for (unsigned int i = 0; i < states.size(); ++i)
    if (states[i].is_closed())
      line.add_contact_force(i, force[i], left);
  Vector all = to.unknowns;
  to.acceleration = line.accelerate(line.forces_left(left, all, velocity));
}

void EventIntegrator::write_within(const LoadCourse &loads, const double x, const double length,
                                   const ContactState &histories, LineState &to) const {
  const auto derivative_at = [&](const Eigen::MatrixXd &m) {
    Vector result = Vector::Zero(m.rows());
    for (Eigen::Index k = m.cols(); k-- > 1;)
      result = x * result + k * m.col(k);
    return Vector(result / length);
  };
  to.time = present + x * length;
  to.unknowns = TaylorMotion::at(motion.q, x);
  to.velocity = TaylorMotion::at(motion.v, x);
  to.acceleration = derivative_at(motion.v);
  to.load_factors.resize(motion.loads.factors.cols());
  for (Eigen::Index l = 0; l < motion.loads.factors.cols(); ++l) {
    const Polynomial factor = motion.loads.factors.col(l), rate = derivative(factor);
    to.load_factors[l] = value(factor, x);
    if (!model.linear.accelerates(l))
      continue;
    to.load_rates.resize(motion.loads.factors.cols(), 0.);
    to.load_accelerations.resize(motion.loads.factors.cols(), 0.);
    to.load_rates[l] = value(rate, x) / length;
    to.load_accelerations[l] = value(derivative(rate), x) / (length * length);
  }
  std::vector<Eigen::Vector3d> forces(states.size());
  for (unsigned int i = 0; i < states.size(); ++i)
    forces[i] = TaylorMotion::at(motion.r[i], x);
  to.contacts = histories;
  add_histories(x, length, to.contacts);
  write_contacts(loads.imposed(motion.loads.within(to.time)), forces, to);
}

void EventIntegrator::write_contacts(const Vector &imposed,
                                     const std::vector<Eigen::Vector3d> &forces,
                                     LineState &to) const {
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += imposed;
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    if (contact.platen_unknown >= 0) { // the platen follows the pipe
      const double compressed =
          contact.contact->platen_force /
          (contact.share * contact.law.axial_rigidity / contact.contact->length);
      const double apart = contact.contact->length * contact.contact->strain(to.dofs)[0];
      to.unknowns[contact.platen_unknown] -=
          (apart + contact.law.gap + compressed) / contact.platen_weight;
    }
  }
  model.space.expand(to.unknowns, to.dofs);
  to.dofs += imposed;
  for (unsigned int i = 0; i < states.size(); ++i) {
    const EventContact &contact = line.contacts[i];
    const double l = contact.contact->length;
    const Contact::Strains strain = contact.contact->strain(to.dofs);
    to.contacts.strain[i] = strain;
    if (to.contact_status[i] == ContactStatus::open) // until now: it may close at this instant
      to.contacts.touch[i] = strain;
    to.contact_status[i] = states[i].status;
    Contact::Strains stress = Contact::Strains::Zero();
    if (states[i].is_closed())
      stress.head<3>() = forces[i] / contact.share;
    else
      to.contacts.touch[i] = strain;
    to.contact_stress[i] = stress;
    double *const internal = to.contacts.internal.data() + contact.contact->state_offset;
    const bool elastic = states[i].is_closed() && contact.has_friction && !contact.rigid_shear;
    internal[contact.law.slip_y] =
        strain[1] - (elastic ? forces[i][1] / contact.shear_stiffness / l : 0.);
    internal[contact.law.slip_z] =
        strain[2] - (elastic ? forces[i][2] / contact.shear_stiffness / l : 0.);
    internal[contact.law.was_slipping] = states[i].status == ContactStatus::slip ? 1. : 0.;
  }
}

} // namespace frictionbeam
