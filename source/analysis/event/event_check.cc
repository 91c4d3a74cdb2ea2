// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/event_integrator.h"
#include "base/number_text.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

/// Parts of the largest so far of displacements, velocities and forces by which a motion may miss
/// Signorini's and Coulomb's laws: its rounding is orders below, a state that was overlooked above.
constexpr double largest_miss = 1e-6, largest_miss_of_rate = 1e-5;
/// What rounding makes, of the parts that what is at rest is the sum of.
constexpr double rounding_of_laws = 1e-13;

} // namespace

/// The worst miss of a law, of what is allowed.
struct EventIntegrator::LawCheck {
  double way = 0., rate = 0., force = 0.; ///< allowed [m], [m/s], [N]
  double offset = 0.;                     ///< the same of what is closed from its gap [m]
  double miss = 1., value = 0.;
  unsigned int contact = 0;
  std::string what;

  void take(const unsigned int i, const double of_contact, const double allowed, const char *name) {
    if (of_contact <= miss * allowed)
      return;
    miss = allowed > 0. ? of_contact / allowed : HUGE_VAL; // nan is none
    value = of_contact;
    contact = i;
    what = name;
  }
};

Vector EventIntegrator::acceleration_by_contacts(const double x) const {
  Vector forces = Vector::Zero(unknowns.size());
  for (unsigned int i = 0; i < states.size(); ++i)
    line.add_contact_force(i, TaylorMotion::at(motion.r[i], x), forces);
  return line.accelerate(forces);
}

EventIntegrator::LawCheck EventIntegrator::what_laws_allow(const double x, const double length) {
  const auto size_at = [&](const unsigned int i, const Vector &of_line) {
    return line.contacts[i].displacement(of_line).lpNorm<Eigen::Infinity>();
  };
  // Also within: where a contact lifts, its force and all that it does are rounding.
  const Vector q = TaylorMotion::at(motion.q, x);
  double fastest_now = fastest, most_force = 0., pressed_at = x;
  for (const double at : {0., x / 2., x}) {
    const Vector there = TaylorMotion::at(motion.q, at), v = TaylorMotion::at(motion.v, at);
    double force = 0.;
    for (unsigned int i = 0; i < states.size(); ++i) {
      const double moved = size_at(i, there);
      farthest = std::max({farthest, moved, TaylorMotion::at(motion.g[i], at).norm() - moved});
      force = std::max(force, TaylorMotion::at(motion.r[i], at).norm());
      fastest_now = std::max(fastest_now, size_at(i, v));
    }
    if (force > most_force) {
      most_force = force;
      pressed_at = at;
    }
  }
  strongest = std::max(strongest, most_force);
  const Vector acceleration = acceleration_by_contacts(pressed_at);
  double pushed = 0.;
  for (unsigned int i = 0; i < states.size(); ++i)
    pushed = std::max(pushed, size_at(i, acceleration));
  LawCheck allowed;
  allowed.rate = std::max({largest_miss_of_rate * fastest_now, rounding_of_laws * pushed * length,
                           rounding_of_laws * farthest / length});
  allowed.way = largest_miss * farthest + allowed.rate * length +
                rounding_of_laws * q.lpNorm<Eigen::Infinity>();
  allowed.force = largest_miss * strongest;
  // Where nothing moves displacements are rounding themselves: of what forces as large as those so
  // far push in a step.
  const double push = most_force > 0. ? pushed * (strongest / most_force) : 0.;
  allowed.offset = largest_miss * std::max(farthest, q.lpNorm<Eigen::Infinity>()) +
                   rounding_of_laws * push * output_step * output_step;
  return allowed;
}

void EventIntegrator::check_laws(const unsigned int i, const double x, const double length,
                                 LawCheck &worst, contact::Check &certificate) const {
  const EventContact &contact = line.contacts[i];
  const EventState &state = states[i];
  const Eigen::Vector3d g = TaylorMotion::at(motion.g[i], x), r = TaylorMotion::at(motion.r[i], x);
  Eigen::Vector3d rate;
  for (int d = 0; d < 3; ++d)
    rate[d] = value(derivative(TaylorMotion::row(motion.g[i], d)), x) / length;
  if (contact.normal == EventContact::Normal::rigid) {
    const double gap = g[0] + contact.law.gap - state.offset;
    certificate.penetration = std::max(certificate.penetration, -gap);
    worst.take(i, -gap, worst.way + largest_miss * contact.law.gap, "is penetrated, in m by");
  }
  if (!state.is_closed())
    return;
  if (contact.normal == EventContact::Normal::rigid)
    worst.take(i, std::abs(state.offset - state.given),
               worst.offset + largest_miss * contact.law.gap,
               "is closed and stands off its gap, in m by");
  if (contact.normal == EventContact::Normal::rigid && contact.moves[0])
    worst.take(i, std::abs(rate[0]), worst.rate, "is closed and comes apart, in m/s with");
  worst.take(i, r[0], worst.force, "pulls, in N with");
  if (!contact.has_friction)
    return;
  const bool slips = state.status == ContactStatus::slip;
  const double f = slips ? contact.law.dynamic_friction : contact.law.static_friction,
               above = r.tail<2>().norm() + f * r[0];
  certificate.cone_violation =
      std::max(certificate.cone_violation, above / std::max(-r[0], 1e-12 * strongest));
  worst.take(i, above, worst.force, "has friction beyond its limit, in N by");
  if (!contact.rigid_shear)
    return;
  if (slips)
    worst.take(i, -rate.tail<2>().dot(state.direction), worst.rate,
               "slips against its friction, in m/s with");
  else
    worst.take(i, rate.tail<2>().norm(), worst.rate, "sticks and slides, in m/s with");
}

bool EventIntegrator::obeys_laws(const double x, const double length, EquilibriumResult &result) {
  LawCheck worst = what_laws_allow(x, length);
  if (!result.check)
    result.check.emplace();
  for (unsigned int i = 0; i < states.size(); ++i)
    check_laws(i, x, length, worst, *result.check);
  if (worst.what.empty())
    return true;
  failure = "event: support " +
            model.scene.supports[line.contacts[worst.contact].contact->support].name + " " +
            worst.what + " " + rounded_number(worst.value) + ", at " +
            rounded_number(present + x * length, 6) +
            " s, against its law: a defect of this integrator, please report it. Take "
            "Time/Integrator = moreau_jean meanwhile";
  return false;
}

} // namespace frictionbeam
