// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contacts.h"

#include <algorithm>
#include <cmath>

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

} // namespace

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
        const Vec n = along ? t : sideways ? across(t) : support.normal.normalized();
        contact.normal = sign * n;
        const Vec down = -contact.normal; // the element's axis, from the pipe to the ground
        contact.t2 = across(down);
        contact.t1 = down.cross(contact.t2);
        const double lever = support.rotations == Support::Rotations::none       ? 0.
                             : support.rotations == Support::Rotations::averaged ? 0.5
                                                                                 : 1.;
        contact.rows.setZero(3, frame.n());
        add_rows(contact, places[p].node, lever * support.length * down, 1.);
        contact.gap = support.gap;
        contact.friction = support.friction;
        contact.platen = support.normal_force;
        const auto soft = [&](const double rigidity) -> Real {
          return rigidity > 0. ? static_cast<Real>(support.length) / rigidity : 0.L;
        };
        contact.soft =
            Vec3(soft(support.axial_rigidity), soft(support.shear_rigidity * support.ratio),
                 soft(support.shear_rigidity));
        result.push_back(contact);
      }
  }
  return result;
}

bool solve_contacts(const Matrix &W, const Vector &free, std::vector<Contact> &contacts) {
  const int n = contacts.size();
  Vector f = Vector::Zero(3 * n);
  std::vector<Mat3> local(n);
  std::vector<Real> rho_n(n), rho_t(n);
  for (int i = 0; i < n; ++i) {
    f.segment<3>(3 * i) = contacts[i].force;
    local[i] = W.block<3, 3>(3 * i, 3 * i);
    local[i].diagonal() += contacts[i].soft;
    rho_n[i] = 1 / local[i](0, 0);
    rho_t[i] = 1 / local[i].bottomRightCorner<2, 2>().norm();
  }
  Real change = 1, largest = 0;
  for (int sweep = 0; sweep < 20000 && change > 1e-15L * largest; ++sweep) {
    change = 0;
    for (int i = 0; i < n; ++i) {
      Contact &contact = contacts[i];
      const Vec3 others = free.segment<3>(3 * i) + W.middleRows<3>(3 * i) * f -
                          W.block<3, 3>(3 * i, 3 * i) * f.segment<3>(3 * i);
      Vec3 r = f.segment<3>(3 * i);
      for (int inner = 0; inner < 10; ++inner) {
        Vec3 u = others + local[i] * r;
        r[0] = contact.platen > 0 ? contact.platen
                                  : std::max<Real>(0, r[0] - rho_n[i] * (contact.gap + u[0]));
        u = others + local[i] * r;
        Eigen::Matrix<Real, 2, 1> t = r.tail<2>() - rho_t[i] * (u - contact.plastic).tail<2>();
        const Real limit = contact.friction * r[0], size = t.norm();
        r.tail<2>() = size > limit ? Eigen::Matrix<Real, 2, 1>(limit / size * t) : t;
      }
      change = std::max(change, (r - f.segment<3>(3 * i)).norm());
      f.segment<3>(3 * i) = r;
    }
    largest = f.cwiseAbs().maxCoeff();
  }
  const Vector motion = free + W * f;
  for (int i = 0; i < n; ++i) {
    Contact &contact = contacts[i];
    contact.force = f.segment<3>(3 * i);
    contact.motion = motion.segment<3>(3 * i);
    const Vec3 position = contact.motion + contact.soft.cwiseProduct(contact.force),
               slip = position - contact.plastic;
    const Real limit = contact.friction * contact.force[0], way = slip.tail<2>().norm() * rho_t[i];
    using Status = Contact::Status;
    const Real gap = contact.gap + contact.motion[0];
    contact.status = contact.force[0] == 0                                  ? Status::open
                     : contact.friction == 0                                ? Status::closed
                     : contact.force.tail<2>().norm() < limit * (1 - 1e-9L) ? Status::stick
                                                                            : Status::slip;
    contact.sure = contact.status == Status::slip   ? way > 1e-6L * largest
                   : contact.status == Status::open ? rho_n[i] * gap > 1e-6L * largest
                                                    : contact.force[0] > 1e-6L * largest;
    if (contact.status == Status::stick)
      contact.sure = contact.sure && contact.force.tail<2>().norm() < limit * (1 - 1e-5L);
    if (contact.status == Status::open)
      contact.plastic = contact.touch = contact.motion;
    else if (contact.status != Status::stick)
      contact.plastic.tail<2>() = position.tail<2>();
  }
  return change <= 1e-14L * largest;
}

} // namespace oracle
