// SPDX-License-Identifier: LGPL-2.1-or-later
#include "analysis/event/event_model.h"

#include "analysis/time/mass_factorization.h"
#include "analysis/time/step_helpers.h"
#include "analysis/time/time_integrator.h"
#include "base/numbers.h"
#include "base/user_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frictionbeam {

Eigen::Vector3d EventContact::displacement(const Vector &all) const {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (unsigned int j = 0; j < unknowns.size(); ++j)
    result += all[unknowns[j]] * G.col(j);
  return result;
}

EventModel::EventModel(const Model &m)
    : model(m), contacts(m.contacts.size()), has_mass(unknowns_with_mass(m.linear.mass())),
      damped(m.linear.damping().nonZeros() > 0), damping(m.linear.damping()) {
  ground_moves = model.contacts.ground_moves();
  for (const Load &load : model.scene.loads)
    ground_moves = ground_moves || load.kind == Load::Kind::displacement;
  std::vector<bool> is_platen(has_mass.size(), false);
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    make_contact(i);
    if (contacts[i].platen_unknown >= 0)
      is_platen[contacts[i].platen_unknown] = true;
  }
  for (unsigned int u = 0; u < has_mass.size(); ++u)
    if (!has_mass[u] && !is_platen[u])
      massless.push_back(u);
  factor_mass(model.linear.mass(), mass);
  if (!massless.empty())
    condense_massless();
}

void EventModel::condense_massless() {
  check_dashpots_have_mass(model, "Time/Integrator = event");
  if (damped && model.scene.time.stiffness_damping > 0.)
    throw UserError("Time/Integrator = event: points without mass cannot have stiffness damping. "
                    "Give them mass, set 'Stiffness damping' to 0, or take another integrator.");
  std::vector<int> place(has_mass.size(), -1);
  for (unsigned int k = 0; k < massless.size(); ++k)
    place[massless[k]] = k;
  std::vector<Eigen::Triplet<double>> inside, across;
  for (unsigned int k = 0; k < massless.size(); ++k)
    for (SparseMatrix::InnerIterator entry(model.linear.stiffness(), massless[k]); entry; ++entry)
      if (place[entry.col()] >= 0)
        inside.emplace_back(k, place[entry.col()], entry.value());
      else
        across.emplace_back(k, entry.col(), entry.value());
  SparseMatrix K_inner(massless.size(), massless.size());
  K_inner.setFromTriplets(inside.begin(), inside.end());
  coupling.resize(massless.size(), has_mass.size());
  coupling.setFromTriplets(across.begin(), across.end());
  inner.analyze(K_inner);
  if (!inner.factorize(K_inner))
    throw UserError(
        "Time/Integrator = event: a motion has neither mass nor stiffness. Hold it with "
        "'Free motions', give the point a mass, or take another integrator.");
}

void EventModel::make_contact(const unsigned int i) {
  EventContact &result = contacts[i];
  const Contact &contact = model.contacts[i];
  const std::string name = model.scene.supports[contact.support].name;
  result.contact = &contact;
  if (!contact.law.has_closed_form())
    throw UserError("Time/Integrator = event needs laws with a threshold in closed form that "
                    "depends on their parameters alone, and '" +
                    contact.law.name() + "' of support " + name +
                    " has none. Take generalized_alpha.");
  result.law = contact.law.closed_form();
  if (result.law.torsional_rigidity > 0.)
    throw UserError("Time/Integrator = event has no torsion of friction elements, as support " +
                    name + " has. Set its 'Torsional rigidity' to 0 or take generalized_alpha.");
  const double l = contact.length;
  result.share = contact.share();
  result.normal = contact.platen_force != 0.              ? EventContact::Normal::platen
                  : std::isinf(result.law.axial_rigidity) ? EventContact::Normal::rigid
                                                          : EventContact::Normal::elastic;
  result.has_friction = result.law.static_friction > 0.;
  result.rigid_shear = std::isinf(result.law.shear_rigidity_y);
  result.normal_stiffness = result.share * result.law.axial_rigidity / l;
  result.shear_stiffness = result.share * result.law.shear_rigidity_y / l;
  if (result.has_friction && result.law.shear_rigidity_y != result.law.shear_rigidity_z)
    throw UserError("Time/Integrator = event has equal shear rigidities only. Set 'Shear rigidity "
                    "ratio' of support " +
                    name + " to 1 or take generalized_alpha.");
  take_unknowns(result);
}

void EventModel::take_unknowns(EventContact &result) const {
  const Contact &contact = *result.contact;
  const double l = contact.length;
  std::vector<int> columns;
  for (unsigned int j = 0; j < contact.unknowns.size(); ++j) {
    const int unknown = contact.unknowns[j];
    const Eigen::Vector3d column = l * contact.B.col(j).head<3>();
    if (has_mass[unknown])
      columns.push_back(j);
    else if (contact.platen_force != 0. &&
             column.tail<2>().norm() <= no_component * column.norm()) {
      result.platen_unknown = unknown;
      result.platen_weight = column[0];
    } else if (column.norm() > 0.)
      throw UserError("Time/Integrator = event: support " +
                      model.scene.supports[contact.support].name +
                      " touches a point that can move and has no mass. Give it a Mass, or its "
                      "pipe a density, or take nonsmooth_alpha.");
  }
  result.G.resize(3, columns.size());
  for (unsigned int k = 0; k < columns.size(); ++k) {
    result.unknowns.push_back(contact.unknowns[columns[k]]);
    result.G.col(k) = l * contact.B.col(columns[k]).head<3>();
  }
  for (int d = 0; d < 3; ++d)
    result.moves[d] = result.G.cols() > 0 && result.G.row(d).norm() > no_component;
}

Vector EventModel::forces_left(const Vector &forces, Vector &unknowns,
                               const Vector &velocity) const {
  if (!massless.empty()) {
    Vector right(massless.size());
    for (unsigned int k = 0; k < massless.size(); ++k)
      right[k] = forces[massless[k]];
    for (const int u : massless)
      unknowns[u] = 0.;
    const Vector solved = inner.solve(right - coupling * unknowns);
    for (unsigned int k = 0; k < massless.size(); ++k)
      unknowns[massless[k]] = solved[k];
  }
  Vector result = forces - model.linear.stiffness() * unknowns;
  if (damped)
    result -= damping * velocity;
  return result;
}

Vector EventModel::accelerate(Vector forces) const {
  for (int u = 0; u < forces.size(); ++u)
    if (!has_mass[u])
      forces[u] = 0.;
  return mass.solve(forces);
}

void EventModel::add_contact_force(const unsigned int i, const Eigen::Vector3d &r,
                                   Vector &forces) const {
  const EventContact &contact = contacts[i];
  for (unsigned int j = 0; j < contact.unknowns.size(); ++j)
    forces[contact.unknowns[j]] -= contact.G.col(j).dot(r);
}

Vector EventModel::ground_displacement(const Vector &imposed) const {
  constexpr double rounding = 16. * std::numeric_limits<double>::epsilon();
  Vector result(3 * contacts.size());
  for (unsigned int i = 0; i < contacts.size(); ++i) {
    const Contact &contact = *contacts[i].contact;
    Eigen::Vector3d strain = contact.strain(imposed).head<3>(), parts = Eigen::Vector3d::Zero();
    for (unsigned int j = 0; j < contact.dofs.size(); ++j)
      parts += std::abs(imposed[contact.dofs[j]]) * contact.B_dofs.col(j).head<3>().cwiseAbs();
    // What a load moves along with its ground stands still on it: rounding would rub.
    for (int d = 0; d < 3; ++d)
      if (std::abs(strain[d]) <= rounding * parts[d])
        strain[d] = 0.;
    result.segment<3>(3 * i) = contact.length * strain;
  }
  return result;
}

} // namespace frictionbeam
