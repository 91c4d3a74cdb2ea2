// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model/contact/contacts.h"
#include "model/contact/ground_point.h"

#include "base/user_error.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace frictionbeam {

using namespace dealii;

namespace {

/// Whether the contact carries the force of its platen without giving way.
bool is_pressed_rigid(const Contact &contact) {
  return contact.platen_force != 0. && contact.law.has_closed_form() &&
         contact.law.is_rigid_along_normal() && contact.law.closed_form().gap == 0.;
}

/// The generalized stress with which a contact carries the force of its platen [N].
double stress_of_platen(const Contact &contact) {
  return -contact.platen_force * contact.length / contact.weight;
}

/// How far the platen must be pushed towards the pipe for the contact to carry the force on it [m].
double platen_position(const Contact &contact, const std::string &support) {
  if (is_pressed_rigid(contact))
    return 0.;
  const double wanted = stress_of_platen(contact);
  double strain = -1e-12;
  for (unsigned int iteration = 0; iteration < 200; ++iteration) {
    const BoundLaw::Answer answer =
        contact.law.answer_at_rest({strain, 0., 0., 0.}, contact.length, LawTangent::consistent,
                                   contact.installation_temperature);
    const double force = answer.stress[0], tangent = answer.tangent[0];
    if (std::abs(force - wanted) <= 1e-12 * std::abs(wanted))
      return -strain * contact.length;
    strain = tangent > 0. ? strain - (force - wanted) / tangent : 2. * strain;
  }
  if (contact.law.has_closed_form() && contact.law.closed_form().gap > 0.)
    throw UserError("Support " + support +
                    ": a Gap and a Normal force do not go together on a rigid support, whose "
                    "platen is pressed onto the pipe. Leave out one of the two.");
  throw UserError("Support " + support + ": its law '" + contact.law.name() +
                  "' cannot carry the Normal force on it. Give the law a larger rigidity.");
}

/// Pipes that meet at each vertex.
std::vector<std::vector<unsigned int>> pipes_by_vertex(const LineMesh &mesh) {
  std::vector<std::vector<unsigned int>> result(mesh.vertices.size());
  for (unsigned int p = 0; p < mesh.pipes.size(); ++p)
    for (const unsigned int vertex : mesh.pipes[p].vertices)
      if (result[vertex].empty() || result[vertex].back() != p) // a loop comes back
        result[vertex].push_back(p);
  return result;
}

/// Loads that heat some of these pipes, and the mean of how much over all of them [K].
std::vector<std::pair<unsigned int, double>> heating_of(const std::vector<unsigned int> &pipes,
                                                        const Scene &scene) {
  std::vector<std::pair<unsigned int, double>> result;
  for (unsigned int l = 0; l < scene.loads.size(); ++l) {
    const Load &load = scene.loads[l];
    if (load.kind != Load::Kind::temperature)
      continue;
    const auto heated = std::count_if(pipes.begin(), pipes.end(), [&](const unsigned int pipe) {
      return load.pipes.empty() ||
             std::count(load.pipes.begin(), load.pipes.end(), scene.pipes[pipe].name) > 0;
    });
    if (heated > 0)
      result.emplace_back(l, load.value * heated / pipes.size());
  }
  return result;
}

/// The matrix B of strains = B u at the middle of the friction element that @p values are of.
template <typename Cell>
void set_strains_by_dofs(const Cell &cell, const FEValues<1, 3> &values, Contact &contact) {
  std::vector<types::global_dof_index> dofs(values.dofs_per_cell);
  cell->get_dof_indices(dofs);
  contact.dofs.assign(dofs.begin(), dofs.end());
  contact.B_dofs.resize(n_support_strains, dofs.size());
  for (unsigned int i = 0; i < dofs.size(); ++i) {
    const GeneralizedStrain strain = generalized_strain(values, contact.axes, i, 0);
    for (int e = 0; e < n_support_strains; ++e)
      contact.B_dofs(e, i) = strain[e];
  }
}

/// The same matrix on the unknowns, B C of u = C q + imposed motions, and the unknowns that it and
/// the contact's vertices depend on.
void set_strains_by_unknowns(const Discretization &discretization, const ReducedSpace &space,
                             Contact &contact) {
  for (const unsigned int dof : contact.dofs)
    for (const auto &term : space.terms(dof))
      contact.unknowns.push_back(term.unknown);
  for (const unsigned int vertex : contact.vertices)
    for (unsigned int c = 0; c < 6; ++c)
      if (const auto dof = discretization.vertex_dofs().index(vertex, c);
          dof != numbers::invalid_dof_index)
        for (const auto &term : space.terms(dof))
          contact.vertex_unknowns.push_back(term.unknown);
  std::sort(contact.unknowns.begin(), contact.unknowns.end());
  contact.unknowns.erase(std::unique(contact.unknowns.begin(), contact.unknowns.end()),
                         contact.unknowns.end());
  contact.B.setZero(n_support_strains, contact.unknowns.size());
  for (unsigned int i = 0; i < contact.dofs.size(); ++i)
    for (const auto &term : space.terms(contact.dofs[i])) {
      const auto place =
          std::lower_bound(contact.unknowns.begin(), contact.unknowns.end(), term.unknown) -
          contact.unknowns.begin();
      contact.B.col(place) += term.weight * contact.B_dofs.col(i);
    }
}

/// What a contact has from its support.
/// @param length of its cell [m], which counts unless it stands on a point
Contact contact_of(const SupportCell &cell, const Scene &scene, const LineMesh &mesh,
                   const double length) {
  const FrictionSupport &support = scene.supports[cell.support];
  Contact contact;
  contact.vertices = cell.vertices;
  contact.axes = LocalAxes(cell.axis);
  contact.length = support.ground.empty() ? length : cell.length;
  contact.support = cell.support;
  contact.site = cell.site;
  const Site &site = mesh.supports[cell.support][cell.site];
  contact.place = site.place;
  contact.at = site.at;
  contact.arm = site.arm;
  const double share = support.share * site.tributary;
  contact.weight = share * contact.length;
  contact.platen_force = share * support.normal_force;
  contact.restitution = support.restitution;
  contact.installation_temperature = scene.installation_temperature;
  return contact;
}

} // namespace

Contacts::Contacts(const Scene &scene, const LineMesh &mesh, const Discretization &discretization,
                   const ReducedSpace &space, const LawLibrary &laws)
    : preload(Vector::Zero(space.n_unknowns())) {
  list.reserve(discretization.support_cells().size());
  const std::vector<std::vector<unsigned int>> pipes = pipes_by_vertex(mesh);
  std::map<unsigned int, FEValues<1, 3>> values; // by element of the collection
  unsigned int n_internal = 0;
  for (unsigned int c = 0; c < discretization.support_cells().size(); ++c) {
    const SupportCell &support_cell = discretization.support_cells()[c];
    const FrictionSupport &support = scene.supports[support_cell.support];
    const auto cell = discretization.support_cell(c);
    const auto fe_index = cell->active_fe_index();
    FEValues<1, 3> &fe_values =
        values
            .try_emplace(fe_index, discretization.elements()[fe_index], QGauss<1>(1),
                         update_values | update_gradients | update_JxW_values)
            .first->second;
    fe_values.reinit(cell);

    Contact contact = contact_of(support_cell, scene, mesh, fe_values.JxW(0));
    contact.law = BoundLaw(laws.find(support.law), support.parameters_of(contact.place));
    contact.heating = heating_of(pipes[contact.vertices[0]], scene);
    for (unsigned int d = 0; d < 3; ++d)
      if (support.ground_motion[d].is_given())
        moving.emplace_back(discretization.vertex_dofs().index(contact.vertices[1], d),
                            &support.ground_motion[d]);
    contact.state_offset = n_internal;
    n_internal += contact.law.n_internal_variables();

    set_strains_by_dofs(cell, fe_values, contact);
    if (!support.ground.empty())
      stand_on_point(support, discretization, contact);
    set_strains_by_unknowns(discretization, space, contact);
    if (contact.platen_force != 0.)
      add_platen(contact, support.name, discretization, space);
    const bool is_of_last = !list.empty() && list.back().support == contact.support &&
                            list.back().place == contact.place;
    if (!is_of_last)
      of_places.emplace_back();
    of_places.back().push_back(list.size());
    list.push_back(std::move(contact));
  }
  refer_to(list);
}

void Contacts::add_platen(const Contact &contact, const std::string &support,
                          const Discretization &discretization, const ReducedSpace &space) {
  const double position = platen_position(contact, support);
  for (unsigned int d = 0; d < 3; ++d) {
    const auto dof = discretization.vertex_dofs().index(contact.vertices[1], d);
    for (const auto &term : space.terms(dof)) {
      preload[term.unknown] += contact.platen_force * -contact.axes.x[d] * term.weight;
      if (space.terms(dof).begin() + 1 == space.terms(dof).end() && term.weight == 1.)
        platens.push_back(
            {static_cast<unsigned int>(list.size()), term.unknown, -contact.axes.x[d], position});
    }
  }
}

Contacts::Contacts(const Contacts &contacts, const std::vector<int> &dof_places,
                   const std::vector<int> &unknown_places, const unsigned int n_unknowns)
    : list(contacts.list), of_places(contacts.of_places), preload(Vector::Zero(n_unknowns)) {
  for (Contact &contact : list) {
    for (unsigned int &dof : contact.dofs)
      dof = dof_places[dof];
    for (int &unknown : contact.unknowns)
      unknown = unknown_places[unknown];
    for (int &unknown : contact.vertex_unknowns)
      unknown = unknown_places[unknown];
  }
  for (const auto &[dof, course] : contacts.moving)
    moving.emplace_back(dof_places[dof], course);
  for (int unknown = 0; unknown < contacts.preload.size(); ++unknown)
    if (contacts.preload[unknown] != 0.)
      preload[unknown_places[unknown]] += contacts.preload[unknown];
  for (const Platen &platen : contacts.platens)
    platens.push_back(
        {platen.contact, unknown_places[platen.unknown], platen.towards_pipe, platen.position});
  refer_to(list);
}

void Contacts::set_parameters(const unsigned int i, const std::vector<double> &parameters) {
  list[i].law = BoundLaw(list[i].law.description(), parameters);
}

std::vector<double> Contacts::temperatures(const std::vector<double> &load_factors) const {
  std::vector<double> result;
  if (std::none_of(list.begin(), list.end(),
                   [](const Contact &contact) { return !contact.heating.empty(); }))
    return result;
  for (const Contact &contact : list)
    result.push_back(contact.temperature(load_factors));
  return result;
}

void Contacts::add_ground_motion(const std::function<double(const TimeFunction &)> &value,
                                 Vector &imposed) const {
  for (const auto &[dof, course] : moving)
    imposed[dof] += value(*course);
}

void Contacts::evaluate(const Vector &all_dofs, const ContactState &committed,
                        const ContactIncrement &increment, const LawTangent tangent,
                        ContactResponse &response) const {
  prepare(response);
  for (unsigned int i = 0; i < list.size(); ++i) {
    response.state.strain[i] = list[i].strain(all_dofs);
    evaluate_law(i, committed, increment, tangent, response);
  }
}

void Contacts::place_platens(Vector &unknowns) const {
  for (const Platen &platen : platens) {
    const Contact &contact = list[platen.contact];
    const double pipe_leaves = contact.length * contact.strain_by_unknowns(unknowns)[0];
    unknowns[platen.unknown] += platen.towards_pipe * (platen.position + pipe_leaves);
  }
}

void Contacts::press_platens(ContactResponse &response) const {
  for (unsigned int i = 0; i < list.size(); ++i)
    if (is_pressed_rigid(list[i])) {
      response.stress[i][0] = stress_of_platen(list[i]);
      response.status[i] = list[i].law.closed_form().static_friction > 0. ? ContactStatus::stick
                                                                          : ContactStatus::closed;
    }
}

ContactState Contacts::initial_state(const Vector &all_dofs) const {
  std::vector<Contact::Strains> strain;
  for (const Contact &contact : list)
    strain.push_back(contact.strain(all_dofs));
  return SiteList::initial_state(strain);
}

} // namespace frictionbeam
