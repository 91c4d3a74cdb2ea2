// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oracle {

namespace {

/// Motion of the contact's point: with Rotations = pipe it lies at the end of the element, with
/// averaged half way.
void add_rows(Contact &contact, const int node, const Vec &arm, const Real sign) {
  const Vec axes[3] = {contact.normal, contact.t1, contact.t2};
  for (int i = 0; i < 3; ++i) {
    contact.rows.block<1, 3>(i, 6 * node) += sign * axes[i].cast<Real>().transpose();
    // (theta x arm) . axis = theta . (arm x axis)
    contact.rows.block<1, 3>(i, 6 * node + 3) += sign * arm.cross(axes[i]).cast<Real>().transpose();
  }
}

/// Half of the lever arm turns with the ground's pipe.
void add_turns(Contact &contact, const int node, const Vec &arm) {
  const Vec axes[3] = {contact.normal, contact.t1, contact.t2};
  for (int i = 0; i < 3; ++i)
    contact.rows.block<1, 3>(i, 6 * node + 3) += arm.cross(axes[i]).cast<Real>().transpose();
}

} // namespace

Vec3 ground_at(const Contact &contact, const double time) {
  const auto &rows = contact.ground_motion;
  if (rows.empty() || time < rows.front()[0])
    return Vec3::Zero();
  std::size_t i = 0;
  while (i + 2 < rows.size() && time > rows[i + 1][0])
    ++i;
  const double part =
      rows.size() == 1 ? 0. : std::min(1., (time - rows[i][0]) / (rows[i + 1][0] - rows[i][0]));
  Vec x;
  for (int d = 0; d < 3; ++d)
    x[d] = rows[i][1 + d] + (rows.size() == 1 ? 0. : part * (rows[i + 1][1 + d] - rows[i][1 + d]));
  return Vec3(x.dot(contact.normal), x.dot(contact.t1), x.dot(contact.t2));
}

Matrix contact_rows(const std::vector<Contact> &contacts, const int n) {
  const int n_contacts = contacts.size();
  Matrix C = Matrix::Zero(4 * n_contacts, n);
  for (int i = 0; i < n_contacts; ++i) {
    C.middleRows<3>(3 * i) = contacts[i].rows;
    if (contacts[i].twist_stiffness > 0)
      C.row(3 * n_contacts + i) = contacts[i].twist_row;
  }
  return C;
}

std::vector<Contact> contacts_of(const Scene &scene, const Frame &frame) {
  std::vector<Contact> result;
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const Support &support = scene.supports[i];
    if (support.holds_exactly())
      continue;
    const bool pair =
        support.kind == "guide" || support.kind == "line stop" || support.kind == "stop";
    const std::vector<Place> places = frame.places(support);
    for (const double sign : pair ? std::vector<double>{1., -1.} : std::vector<double>{1.})
      for (std::size_t p = 0; p < places.size(); ++p) {
        Contact contact;
        contact.support = i;
        contact.name = support.name + (pair ? sign > 0. ? ".plus" : ".minus" : "") +
                       (places.size() > 1 ? "." + std::to_string(p + 1) : "");
        const Vec t = places[p].tangent;
        const bool along = support.kind == "line stop" || support.direction == "along",
                   sideways = support.kind == "guide" || support.direction == "across";
        const Vec on = frame.positions()[places[p].node];
        const int ground = support.ground.empty() ? -1 : frame.node_of(support.ground);
        const Vec way = ground < 0 ? Vec(Vec::Zero()) : Vec(on - frame.positions()[ground]);
        const Vec n = along                                ? t
                      : sideways                           ? across(t)
                      : ground >= 0 && !support.own_normal ? Vec(way.normalized())
                                                           : support.normal.normalized();
        const double length = ground >= 0 && !support.own_normal ? way.norm() : support.length;
        contact.normal = sign * n;
        const Vec down = -contact.normal; // the element's axis, from the pipe to the ground
        contact.t2 = across(down);
        contact.t1 = down.cross(contact.t2);
        const bool averaged = support.rotations == Support::Rotations::averaged;
        // Of two ends of which one is a free point, the other has the whole lever arm.
        const auto part = [&](const int other) {
          return ground >= 0 && !frame.turns(other) ? 1. : 0.5;
        };
        const double lever = support.rotations == Support::Rotations::none ? 0.
                             : averaged                                    ? part(ground)
                                                                           : 1.;
        contact.rows.setZero(3, frame.n());
        // What the element's length leaves of the way between two points along the normal is rigid,
        // and part of the ground's pipe, or of the support's where the ground cannot turn.
        const bool ground_turns = ground >= 0 && frame.turns(ground);
        const Vec left = ground >= 0 && support.rotations != Support::Rotations::none
                             ? Vec((way.dot(down) + length) * down)
                             : Vec(Vec::Zero());
        add_rows(contact, places[p].node,
                 lever * length * down - (ground_turns ? Vec(Vec::Zero()) : left), 1.);
        contact.twist_row.setZero(frame.n());
        contact.twist_row.segment<3>(6 * places[p].node + 3) =
            contact.normal.cast<Real>().transpose();
        if (ground >= 0) { // what of the way is across the normal is a rigid arm of that pipe
          add_rows(contact, ground, way - way.dot(n) * n + left, -1.);
          if (averaged)
            add_turns(contact, ground, part(places[p].node) * length * down);
          contact.twist_row.segment<3>(6 * ground + 3) = -contact.normal.cast<Real>().transpose();
        }
        contact.ground_motion = support.ground_motion;
        contact.twist_stiffness = support.torsional_rigidity / length * places[p].share;
        contact.patch_radius = support.patch_radius;
        contact.gap = support.gap;
        contact.friction = support.friction;
        contact.platen = support.normal_force * places[p].share;
        const auto soft = [&](const double rigidity) -> Real {
          return rigidity > 0. ? static_cast<Real>(length) / (rigidity * places[p].share) : 0.L;
        };
        contact.soft =
            Vec3(soft(support.axial_rigidity), soft(support.shear_rigidity * support.ratio),
                 soft(support.shear_rigidity));
        result.push_back(contact);
      }
  }
  return result;
}

namespace {

/// Put forces @p r of a contact once through its laws, where the others move it by @p others.
Vec3 through_laws(const Contact &contact, const Mat3 &local, const Vec3 &others, const Real rho_n,
                  const Real rho_t, Vec3 r) {
  Vec3 u = others + local * r;
  r[0] =
      contact.platen > 0 ? contact.platen : std::max<Real>(0, r[0] - rho_n * (contact.gap + u[0]));
  u = others + local * r;
  Eigen::Matrix<Real, 2, 1> t = r.tail<2>() - rho_t * (u - contact.plastic).tail<2>();
  const Real limit = contact.friction * r[0], size = t.norm();
  r.tail<2>() = size > limit ? Eigen::Matrix<Real, 2, 1>(limit / size * t) : t;
  return r;
}

} // namespace

bool solve_contacts(const Matrix &W, const Vector &free, std::vector<Contact> &contacts,
                    Real &largest_so_far) {
  const int n = contacts.size();
  Vector f = Vector::Zero(4 * n);
  std::vector<Mat3> local(n);
  std::vector<Real> rho_n(n), rho_t(n);
  for (int i = 0; i < n; ++i) {
    f.segment<3>(3 * i) = contacts[i].force;
    f[3 * n + i] = contacts[i].moment;
    local[i] = W.block<3, 3>(3 * i, 3 * i);
    local[i].diagonal() += contacts[i].soft;
    rho_n[i] = 1 / local[i](0, 0);
    rho_t[i] = 1 / local[i].bottomRightCorner<2, 2>().norm();
  }
  Real change = 1, largest = 1e-4L * largest_so_far;
  for (int sweep = 0; sweep < 20000 && change > 1e-15L * largest; ++sweep) {
    change = 0;
    for (int i = 0; i < n; ++i) {
      Contact &contact = contacts[i];
      const Vec3 others = free.segment<3>(3 * i) + W.middleRows<3>(3 * i) * f -
                          W.block<3, 3>(3 * i, 3 * i) * f.segment<3>(3 * i);
      Vec3 r = f.segment<3>(3 * i);
      const Vec3 once = through_laws(contact, local[i], others, rho_n[i], rho_t[i], r);
      // Ten times may end where they began, on a circle: once through the laws must not move it.
      change = std::max(change, (once - r).norm());
      r = once;
      for (int inner = 1; inner < 10; ++inner)
        r = through_laws(contact, local[i], others, rho_n[i], rho_t[i], r);
      change = std::max(change, (r - f.segment<3>(3 * i)).norm());
      f.segment<3>(3 * i) = r;
      if (contact.twist_stiffness == 0)
        continue;
      const int row = 3 * n + i; // exact in one go: the moment that would hold, within its limit
      const Real others_twist = free[row] + W.row(row).dot(f) - W(row, row) * f[row],
                 soft = 1 / contact.twist_stiffness,
                 limit = r[0] <= 0                  ? 0.L
                         : contact.patch_radius > 0 ? contact.friction * r[0] * contact.patch_radius
                                                    : std::numeric_limits<Real>::infinity();
      const Real moment = std::clamp<Real>(
          -(others_twist - contact.plastic_twist) / (W(row, row) + soft), -limit, limit);
      change = std::max(change, std::abs(moment - f[row]));
      f[row] = moment;
    }
    largest = std::max(f.cwiseAbs().maxCoeff(), 1e-4L * largest_so_far);
  }
  largest_so_far = std::max(largest_so_far, largest);
  const Vector motion = free + W * f;
  for (int i = 0; i < n; ++i) {
    Contact &contact = contacts[i];
    contact.force = f.segment<3>(3 * i);
    contact.motion = motion.segment<3>(3 * i);
    contact.moment = f[3 * n + i];
    contact.twist = motion[3 * n + i];
    if (contact.twist_stiffness > 0) // what is not elastic has slipped
      contact.plastic_twist = contact.force[0] == 0
                                  ? contact.twist
                                  : contact.twist + contact.moment / contact.twist_stiffness;
    const Vec3 position = contact.motion + contact.soft.cwiseProduct(contact.force),
               slip = position - contact.plastic;
    const Real limit = contact.friction * contact.force[0], way = slip.tail<2>().norm() * rho_t[i];
    using Status = Contact::Status;
    const Real gap = contact.gap + contact.motion[0];
    contact.status = contact.force[0] <= 1e-14L * largest_so_far            ? Status::open
                     : contact.friction == 0                                ? Status::closed
                     : contact.force.tail<2>().norm() < limit * (1 - 1e-9L) ? Status::stick
                                                                            : Status::slip;
    contact.sure = contact.status == Status::slip   ? way > 1e-6L * largest
                   : contact.status == Status::open ? rho_n[i] * gap > 1e-6L * largest
                                                    : contact.force[0] > 1e-6L * largest;
    if (contact.status == Status::stick)
      contact.sure = contact.sure && contact.force.tail<2>().norm() < limit * (1 - 1e-5L);
    const bool apart = rho_n[i] * gap > 1e-10L * largest_so_far;
    contact.sure_of_touch =
        apart || (contact.sure_of_touch && contact.force[0] > 1e-10L * largest_so_far);
    if (contact.status == Status::open)
      contact.plastic = contact.touch = contact.motion;
    else if (contact.status != Status::stick)
      contact.plastic.tail<2>() = position.tail<2>();
  }
  return change <= 1e-14L * largest;
}

} // namespace oracle
