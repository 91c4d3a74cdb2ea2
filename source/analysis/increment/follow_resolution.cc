// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/increment/follow_resolution.h"

#include "base/algebra/dense_algebra.h"
#include "model/line_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace frictionbeam {

namespace {

constexpr double no_gap = 1e-9;      ///< of the largest displacement
constexpr double no_friction = 1e-9; ///< of the contact's force
/// Sine by which friction is taken to turn from where it begins to slip to the increment's end.
constexpr double turn_of_a_beginning = 0.3;

/// What friction displaces a contact by, per force [m/N]: by the stiffness of its own unknowns, all
/// others held.
Eigen::Matrix2d compliance_of(const Contact &contact, const SparseMatrix &stiffness) {
  const unsigned int n = contact.unknowns.size();
  Eigen::MatrixXd K(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      K(i, j) = stiffness.coeff(contact.unknowns[i], contact.unknowns[j]);
  // Nothing displaces the line in what it does not resist: the pseudo-inverse.
  const Eigen::MatrixXd B = contact.length * contact.B.middleRows(1, 2);
  return B * LeastSquares(K).pseudo_inverse() * B.transpose();
}

/// What friction displaces the line by at most, per force [m/N]: a long line undercuts compliances
/// of contacts as it has cells.
double largest_compliance(const Eigen::Matrix2d &compliance) {
  constexpr double cells_that_give = 4096.;
  const double mean = compliance.trace() / 2.; // of the eigenvalues
  return cells_that_give *
         (mean + std::hypot(compliance(0, 0) - compliance(1, 1), 2. * compliance(0, 1)) / 2.);
}

/// Whether a force along a direction pushes across it, too.
bool pushes_across(const Eigen::Matrix2d &compliance, const Eigen::Vector2d &along) {
  constexpr double rounding = 1e-6;
  const Eigen::Vector2d across(-along[1], along[0]);
  return std::abs(across.dot(compliance * along)) >
         rounding * along.squaredNorm() * compliance.norm();
}

double sine_between(const Eigen::Vector2d &a, const Eigen::Vector2d &b) {
  const double sizes = a.norm() * b.norm();
  return sizes > 0. ? std::abs(a[0] * b[1] - a[1] * b[0]) / sizes : 0.;
}

/**
 * Sine by which friction turns from where it begins to slip to an increment's end, of a contact
 * that would move alone: until it slips its force goes from that before towards the one that would
 * hold it, by the change of loads.
 */
double turn_alone(const Eigen::Matrix2d &compliance, const Eigen::Vector2d &path,
                  const Eigen::Vector2d &before, const Eigen::Vector2d &after) {
  const Eigen::Vector2d change = after + LeastSquares(compliance).solve(path) - before;
  // |before + s change| = |after|
  const double a = change.squaredNorm(), b = before.dot(change),
               c = before.squaredNorm() - after.squaredNorm();
  if (a == 0. || c >= 0.)
    return 0.;
  const double s = (-b + std::sqrt(b * b - a * c)) / a;
  return sine_between(before + std::min(s, 1.) * change, after);
}

/// Of a motion of the line: whether nothing of it goes along a direction.
class Directions {
public:
  /// @param places of the translations among the degrees of freedom, three of each vertex
  Directions(const LineState &before, const LineState &after,
             const std::vector<unsigned int> &places) {
    for (std::size_t i = 0; i < places.size(); i += 3) {
      Eigen::Vector3d motion;
      for (unsigned int d = 0; d < 3; ++d)
        motion[d] = after.dofs[places[i + d]] - before.dofs[places[i + d]];
      squares += motion * motion.transpose();
    }
  }
  bool has_none_along(const Vector3 &direction) const {
    constexpr double nothing = 1e-12; // of squares
    const Eigen::Vector3d d(direction[0], direction[1], direction[2]);
    return d.dot(squares * d) <= nothing * squares.trace();
  }

private:
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
};

/// Whether a contact closes a gap or opens.
bool opens_or_closes(const ContactStatus before, const ContactStatus after) {
  return (before == ContactStatus::open) != (after == ContactStatus::open);
}

/// Whether the course of a contact's force has a corner within an increment: not where it touches
/// and is pressed from the beginning.
bool has_corner(const Contact &contact, const ContactStatus before, const ContactStatus after,
                const double strain_before, const double nothing) {
  if (before == after)
    return false;
  if (before != ContactStatus::open || !contact.law.has_closed_form())
    return true;
  return contact.length * strain_before + contact.law.closed_form().gap > nothing;
}

/// Whether a contact begins or ceases to slip within an increment while the most that it can hold
/// changes.
bool changes_limit_within(const Contact &contact, const unsigned int i, const LineState &before,
                          const LineState &after) {
  constexpr double nothing = 1e-9;
  const FrictionThreshold &law = contact.law.closed_form();
  const Contact::Strains &from = before.contact_stress[i], &to = after.contact_stress[i];
  const double least = std::max(std::abs(from[0]), std::abs(to[0])) * (1. - nothing);
  if (std::abs(from[0]) >= least && std::abs(to[0]) >= least)
    return false; // the normal force stays
  const auto slips = [&](const int place) {
    const double moved = after.contacts.internal[contact.state_offset + place] -
                         before.contacts.internal[contact.state_offset + place];
    return std::abs(moved) * contact.length > 0.;
  };
  const bool is_open = after.contact_status[i] == ContactStatus::open;
  if (law.static_friction == 0.)
    return false;
  if (is_open)
    return before.contact_status[i] != ContactStatus::open &&
           (slips(law.slip_y) || slips(law.slip_z));
  const bool begins = before.contact_status[i] != after.contact_status[i],
             turns = law.patch_radius > 0. && slips(law.twist);
  return (begins && after.contact_status[i] == ContactStatus::slip) || turns;
}

/// What contacts do within an increment beside which the friction of others may turn unseen.
class UnseenTurns {
public:
  UnseenTurns(const Model &model, const LineState &before, const LineState &after) {
    double largest = 0.;
    for (const Contact::Strains &stress : after.contact_stress)
      largest = std::max(largest, stress.head<3>().norm());
    for (unsigned int i = 0; i < model.contacts.size(); ++i)
      if (const Contact &contact = model.contacts[i]; contact.law.has_closed_form())
        add(contact.law.closed_form(), i, before, after, nothing * largest);
  }

  bool has_friction() const { return any_friction; }
  /// Several contacts with friction, of which some begin to slip from no friction while normal
  /// forces change, or have friction from before and begin, end or turn their slip, or let go of a
  /// static friction that is larger.
  bool beside_slip() const {
    return n_held > 1 && (lets_go || has_past || (begins && changes_forces));
  }

private:
  static constexpr double nothing = 1e-9;

  void add(const FrictionThreshold &law, const unsigned int i, const LineState &before,
           const LineState &after, const double least) {
    const ContactStatus from = before.contact_status[i], to = after.contact_status[i];
    if (law.static_friction == 0. || (from == ContactStatus::open && to == ContactStatus::open))
      return;
    any_friction = true;
    const Contact::Strains &stress_before = before.contact_stress[i],
                           &stress = after.contact_stress[i];
    if (to == ContactStatus::open || !(-stress[0] > least))
      return;
    ++n_held;
    changes_forces =
        changes_forces || (from != ContactStatus::open &&
                           std::abs(stress[0] - stress_before[0]) > nothing * std::abs(stress[0]));
    const bool slipped = from == ContactStatus::slip, slips = to == ContactStatus::slip;
    const Eigen::Vector2d T0 = stress_before.segment<2>(1), T1 = stress.segment<2>(1);
    const bool has_friction_before = T0.norm() > nothing * T1.norm();
    begins = begins || (slips && !slipped);
    has_past = has_past || (slips != slipped && has_friction_before) || (slips && T0.dot(T1) < 0.);
    lets_go = lets_go || (slips && !slipped && law.dynamic_friction < law.static_friction);
  }

  bool any_friction = false, begins = false, has_past = false, lets_go = false,
       changes_forces = false;
  unsigned int n_held = 0;
};

/// Whether the law of a contact, without a closed form that holds at any rate, answers to one small
/// strain otherwise at another rate: to shear, pressed or pulled, in one second or two, and at
/// sliding velocities of machines, by which friction may vary.
bool answers_to_rates(const Contact &contact) {
  constexpr double small = 1e-12, same = 1e-6;
  const BoundLaw &law = contact.law;
  if (law.has_closed_form())
    return false;
  const std::vector<double> fresh(law.n_internal_variables() + 1, 0.);
  using Strains = Contact::Strains;
  const Strains sliding(0., 1. / contact.length, 1. / contact.length, 1. / contact.length); // 1 m/s
  for (const double normal : {-small, small}) {
    const Strains strain(normal, small, small, small);
    for (const std::array<Strains, 2> &rates : {std::array<Strains, 2>{strain, strain / 2.},
                                                std::array<Strains, 2>{1e-3 * sliding, sliding}}) {
      std::array<Strains, 2> stress;
      for (int i = 0; i < 2; ++i) {
        std::vector<double> state = fresh;
        LawOutput output{stress[i].data(), nullptr, state.data(), 0., ContactStatus::none};
        if (law.integrate(strain.data(), rates[i].data(), contact.length, {1., small / rates[i][1]},
                          fresh.data(), LawTangent::none, output) != LawStatus::ok)
          return false;
      }
      if ((stress[0] - stress[1]).norm() > same * (stress[0].norm() + stress[1].norm()))
        return true;
    }
  }
  return false;
}

bool any_answers_to_rates(const Contacts &contacts) {
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (answers_to_rates(contacts[i]))
      return true;
  return false;
}

} // namespace

FollowResolution::FollowResolution(const Model &model)
    : model(model), forces_lag(any_answers_to_rates(model.contacts)),
      is_translation(model.space.n_unknowns(), false) {
  const VertexDofs &dofs = model.discretization.vertex_dofs();
  for (unsigned int v = 0; v < model.discretization.n_line_vertices(); ++v)
    for (unsigned int d = 0; d < 3; ++d) {
      translations.push_back(dofs.index(v, d));
      for (const auto &term : model.space.terms(translations.back()))
        is_translation[term.unknown] = true;
    }
}

void FollowResolution::add_displacement(const LineState &state, Resolution &resolution) const {
  double largest = 0.; // squared
  for (std::size_t i = 0; i < translations.size(); i += 3) {
    const double x = state.dofs[translations[i]], y = state.dofs[translations[i + 1]],
                 z = state.dofs[translations[i + 2]];
    largest = std::max(largest, x * x + y * y + z * z);
  }
  resolution.largest_displacement = std::max(resolution.largest_displacement, std::sqrt(largest));
  const LineCells::Unbent cells = model.cells.unbent(pose_of(state));
  resolution.unbent = std::max(resolution.unbent, cells.length);
  resolution.largest_displacement = std::max(resolution.largest_displacement, cells.bow);
}

void FollowResolution::add_time_step(const LineState &before, const LineState &after,
                                     const bool is_exact, Resolution &resolution) const {
  add_displacement(after, resolution);
  resolution.exact_in_time = resolution.exact_in_time && is_exact;
  if (is_exact)
    return;
  resolution.forces_lag = resolution.forces_lag || forces_lag;
  if (!after.events.empty())
    ++resolution.state_changes;
  double turned = 0.;
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Eigen::Vector2d T0 = before.contact_stress[i].segment<2>(1),
                          T1 = after.contact_stress[i].segment<2>(1);
    if (after.contact_status[i] != ContactStatus::slip || T0.isZero(0.) || T1.isZero(0.))
      continue;
    const Eigen::Vector2d path =
        model.contacts[i].length *
        (after.contacts.strain[i].segment<2>(1) - before.contacts.strain[i].segment<2>(1));
    turned = std::max(turned, std::abs(T0[0] * T1[1] - T0[1] * T1[0]) / (T0.norm() * T1.norm()) *
                                  path.norm() / 2.);
  }
  resolution.turned_in_motion += turned;
  if (before.acceleration.isZero(0.)) { // nothing is known of the step before
    resolution.starts_to_move = resolution.starts_to_move || !after.acceleration.isZero(0.);
    return;
  }
  double change = 0., size = 0.;
  for (unsigned int i = 0; i < is_translation.size(); ++i)
    if (is_translation[i]) {
      change = std::max(change, std::abs(after.acceleration[i] - before.acceleration[i]));
      size = std::max(size, std::abs(after.acceleration[i]));
    }
  const double h = after.time - before.time;
  resolution.local_errors += h * h / 12. * change;
  resolution.acceleration_changes += change;
  resolution.accelerations += size;
}

void FollowResolution::add_increment(const LineState &before, const LineState &after,
                                     Resolution &resolution) {
  add_displacement(after, resolution);
  slip_turned.resize(model.contacts.size(), 0.);
  compliances.resize(model.contacts.size());
  slips.resize(model.contacts.size());
  const Directions motion(before, after, translations);
  bool has_met = false;
  for (unsigned int i = 0; i < model.contacts.size(); ++i) {
    const Contact &contact = model.contacts[i];
    resolution.slip_is_known = resolution.slip_is_known && contact.law.has_closed_form();
    const ContactStatus status_before = before.contact_status[i], status = after.contact_status[i];
    const bool is_corner = has_corner(contact, status_before, status, before.contacts.strain[i][0],
                                      no_gap * resolution.largest_displacement);
    resolution.turned_within = resolution.turned_within || is_corner;
    has_met = has_met || (is_corner && opens_or_closes(status_before, status));
    if (!contact.law.has_closed_form())
      continue;
    const FrictionThreshold &law = contact.law.closed_form();
    resolution.limit_changed_within =
        resolution.limit_changed_within || changes_limit_within(contact, i, before, after);
    if (status == ContactStatus::open)
      continue;
    const double gap = contact.length * before.contacts.strain[i][0] + law.gap,
                 normal_force = after.contact_stress[i].head<3>().norm();
    if (contact.platen_force == 0. && gap > no_gap * resolution.largest_displacement &&
        after.contact_stress[i].segment<2>(1).norm() > no_friction * normal_force)
      resolution.touched_within = true;
    if (status != ContactStatus::slip)
      continue;
    const auto slip = [&](const int place) {
      return contact.length * (after.contacts.internal[contact.state_offset + place] -
                               before.contacts.internal[contact.state_offset + place]);
    };
    const Eigen::Vector2d path(slip(law.slip_y), slip(law.slip_z)),
        T0 = before.contact_stress[i].segment<2>(1), T1 = after.contact_stress[i].segment<2>(1);
    const double largest = std::max(T0.norm(), T1.norm()), length = path.norm();
    if (T0.norm() <= 1e-9 * largest)
      resolution.slip_from_rest = std::max(resolution.slip_from_rest, length);
    if (!(largest > 0. && length > 0.))
      continue;
    if (!compliances[i])
      compliances[i] = compliance_of(contact, model.linear.stiffness());
    const double moved_by_friction =
        largest * contact.share() * largest_compliance(*compliances[i]);
    const Eigen::Vector2d change = T1 - T0;
    slip_turned[i] += std::abs(change[0] * path[1] - change[1] * path[0]) / (length * largest) *
                      std::min(length / 2., moved_by_friction);
    const Vector3 across = path[1] * contact.axes.y - path[0] * contact.axes.z;
    const bool moves_across = !motion.has_none_along(across / across.norm()),
               may_bend = moves_across || pushes_across(*compliances[i], path);
    // What has begun to slip within the increment did so on a way that nothing shows.
    if (status_before != ContactStatus::slip && moves_across)
      slip_turned[i] += turn_of_a_beginning * (1. - T0.norm() / largest) *
                        std::min(length / 2., moved_by_friction);
    else if (status_before != ContactStatus::slip && may_bend)
      slip_turned[i] += turn_alone(*compliances[i] * contact.share(), path, T0, T1) *
                        std::min(2. * length, moved_by_friction);
    if (after.time > before.time) {
      ++slips[i].n_increments;
      slips[i].bent = may_bend ? std::min(length, moved_by_friction) : 0.;
    }
    resolution.slip_turned = std::max(resolution.slip_turned, slip_turned[i]);
  }
  resolution.slip_in_one = 0.;
  for (const SlipOfStep &slip : slips)
    if (slip.n_increments == 1)
      resolution.slip_in_one = std::max(resolution.slip_in_one, slip.bent);
  const UnseenTurns unseen(model, before, after);
  const bool shows = resolution.slip_turned > 1e-9 * resolution.largest_displacement; // how far
  resolution.turned_unseen = resolution.turned_unseen || (has_met && unseen.has_friction()) ||
                             (!shows && unseen.beside_slip());
}

void FollowResolution::transfer(Archive &archive) { archive(slip_turned, slips); }

} // namespace frictionbeam
