// SPDX-License-Identifier: LGPL-2.1-or-later
#include "host_sites.h"

#include "../number_text.h"

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <stdexcept>

namespace frictionbeam::contact {

namespace {

/// Says what is wrong with one of the contacts.
class Refusal {
public:
  explicit Refusal(const unsigned int contact) : contact(contact) {}

  [[noreturn]] void operator()(const std::string &read, const std::string &allowed,
                               const std::string &attempt) const {
    because(read + "\n  allowed: " + allowed + "\n  try:     " + attempt);
  }
  /// @param why all three
  [[noreturn]] void because(const std::string &why) const {
    throw std::invalid_argument("Contact " + std::to_string(contact) + " (counted from 0): " + why);
  }

private:
  const unsigned int contact;
};

using frictionbeam::text_of;

std::string text_of(const Vector3 &v) {
  return "(" + text_of(v[0]) + ", " + text_of(v[1]) + ", " + text_of(v[2]) + ")";
}

BoundLaw law_of(const Contact &contact, const Refusal &refuse) {
  if (contact.law == nullptr)
    refuse("it has no law", "a law of kind `support`", "LawLibrary::find(\"coulomb\")");
  const LawDescription &law = *contact.law;
  if (law.kind != LawKind::support)
    refuse(std::string("its law '") + law.name + "' is one of sections", "a law of kind `support`",
           "LawLibrary::names(LawKind::support) lists them");
  try {
    return BoundLaw(law, contact.parameters);
  } catch (const std::invalid_argument &fault) {
    refuse.because(fault.what());
  }
}

/// Rows: the normal and two directions across.
Eigen::Matrix3d frame_of(const Contact &contact, const Refusal &refuse) {
  constexpr double unit = 1e-6, right_angle = 1e-6;
  if (!(std::abs(contact.normal.norm() - 1.) <= unit))
    refuse("its normal is " + text_of(contact.normal) + ", of length " +
               text_of(contact.normal.norm()),
           "a unit vector from the first body to the second", "normal / normal.norm()");
  const Vector3 n = contact.normal.normalized();
  Vector3 t = contact.tangent;
  if (t.isZero(0.)) {
    Eigen::Index least;
    n.cwiseAbs().minCoeff(&least);
    t = Vector3::Unit(least) - n[least] * n;
  } else if (!(std::abs(t.dot(n)) <= right_angle * t.norm()))
    refuse("its tangent " + text_of(t) + " is not across its normal " + text_of(n),
           "a frame of right angles", "no tangent, where any direction will do");
  t = (t - t.dot(n) * n).normalized();
  Eigen::Matrix3d frame;
  frame << n.transpose(), t.transpose(), n.cross(t).transpose();
  return frame;
}

} // namespace

HostSites::HostSites(const System &system, const std::vector<Contact> &contacts) {
  unsigned int state_offset = 0;
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Contact &contact = contacts[i];
    const Refusal refuse(i);
    Site site;
    site.law = law_of(contact, refuse);
    if (!(contact.area > 0.) || !std::isfinite(contact.area))
      refuse("its area is " + text_of(contact.area), "above 0", "1 for a law per piece");
    if (!std::isfinite(contact.gap))
      refuse("its gap is " + text_of(contact.gap) + " m", "a length",
             "leave it out if it never touches");
    if (contact.dofs.empty() || contact.dofs.size() != contact.rows.size())
      refuse(std::to_string(contact.dofs.size()) + " dofs and " +
                 std::to_string(contact.rows.size()) + " rows",
             "a row for each dof, and one at least", "on_ground() or between()");
    site.length = 1.;
    site.weight = contact.area;
    site.state_offset = state_offset;
    state_offset += site.law.n_internal_variables();
    const Eigen::Matrix3d frame = frame_of(contact, refuse);

    std::map<int, Vector3> columns;
    Strains given_strain = Strains::Zero();
    given_strain[0] = contact.gap;
    double size = 0.;
    for (unsigned int j = 0; j < contact.dofs.size(); ++j) {
      if (contact.dofs[j] >= system.dofs.size())
        refuse("it names dof " + std::to_string(contact.dofs[j]),
               "0 to " + std::to_string(system.dofs.size() - 1) + ", as the matrix numbers them",
               "add the number of dofs before those of a second handler");
      if (!contact.rows[j].allFinite())
        refuse("the row of its dof " + std::to_string(contact.dofs[j]) + " is " +
                   text_of(contact.rows[j]),
               "numbers", "minus a unit vector for a dof of the first body");
      const Vector3 row = frame * contact.rows[j];
      size = std::max(size, row.norm());
      const System::Resolved &dof = system.dofs[contact.dofs[j]];
      given_strain.head<3>() += dof.given * row;
      for (const System::Term &term : dof.terms)
        columns.try_emplace(term.unknown, Vector3::Zero()).first->second += term.weight * row;
    }
    bool opens = false;
    for (const auto &[unknown, column] : columns)
      opens = opens || std::abs(column[0]) > 1e-12 * size;
    if (!opens)
      refuse("nothing that is free moves it along its normal " + text_of(contact.normal),
             "a contact of which at least one dof with a row along the normal is not constrained",
             "leave the contact out, or its constraint");
    site.B.setZero(n_strains, columns.size());
    for (const auto &[unknown, column] : columns) {
      site.B.col(site.unknowns.size()).head<3>() = column;
      site.unknowns.push_back(unknown);
    }
    sites.push_back(std::move(site));
    given.push_back(given_strain);
    frames.push_back(frame);
  }
}

std::vector<int> HostSites::unknowns() const {
  std::vector<int> all;
  for (const Site &site : sites)
    all.insert(all.end(), site.unknowns.begin(), site.unknowns.end());
  return all;
}

} // namespace frictionbeam::contact
