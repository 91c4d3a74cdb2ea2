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

/// How far the platen must be pushed towards the pipe for the contact to carry the force on it [m].
double platen_position(const Contact &contact, const std::string &support) {
  const double wanted = -contact.platen_force * contact.length / contact.weight;
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
  contact.B.resize(n_support_strains, dofs.size());
  for (unsigned int i = 0; i < dofs.size(); ++i) {
    const GeneralizedStrain strain = generalized_strain(values, contact.axes, i, 0);
    for (int e = 0; e < n_support_strains; ++e)
      contact.B(e, i) = strain[e];
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
  contact.B_reduced.setZero(n_support_strains, contact.unknowns.size());
  for (unsigned int i = 0; i < contact.dofs.size(); ++i)
    for (const auto &term : space.terms(contact.dofs[i])) {
      const auto place =
          std::lower_bound(contact.unknowns.begin(), contact.unknowns.end(), term.unknown) -
          contact.unknowns.begin();
      contact.B_reduced.col(place) += term.weight * contact.B.col(i);
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
  const double share = support.share * mesh.supports[cell.support][cell.site].tributary;
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
    contact.law = BoundLaw(laws.find(support.law), support.parameters);
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
    list.push_back(std::move(contact));
  }
}

void Contacts::add_platen(const Contact &contact, const std::string &support,
                          const Discretization &discretization, const ReducedSpace &space) {
  const double position = platen_position(contact, support);
  for (unsigned int d = 0; d < 3; ++d) {
    const auto dof = discretization.vertex_dofs().index(contact.vertices[1], d);
    for (const auto &term : space.terms(dof)) {
      preload[term.unknown] += contact.platen_force * -contact.axes.x[d] * term.weight;
      if (space.terms(dof).begin() + 1 == space.terms(dof).end() && term.weight == 1.)
        platen_positions.emplace_back(term.unknown, position * -contact.axes.x[d]);
    }
  }
}

Contacts::Contacts(const Contacts &contacts, const std::vector<int> &dof_places,
                   const std::vector<int> &unknown_places, const unsigned int n_unknowns)
    : list(contacts.list), n_internal(contacts.n_internal), preload(Vector::Zero(n_unknowns)) {
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
  for (const auto &[unknown, position] : contacts.platen_positions)
    platen_positions.emplace_back(unknown_places[unknown], position);
}

void Contacts::set_parameters(const unsigned int i, const std::vector<double> &parameters) {
  list[i].law = BoundLaw(list[i].law.description(), parameters);
}

void Contacts::prepare(ContactResponse &response) const {
  const unsigned int n = list.size();
  response.stress.resize(n);
  response.tangent.resize(n);
  response.status.resize(n);
  response.failed = false;
  response.state.internal.resize(n_internal + 1);
  response.state.strain.resize(n);
  response.state.touch.resize(n);
  response.state.dissipated.resize(n);
  response.state.wear.resize(n);
  response.state.impulse.resize(n);
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

void Contacts::evaluate_law(const unsigned int i, const ContactState &committed,
                            const ContactIncrement &increment, const LawTangent tangent,
                            ContactResponse &response) const {
  const Contact &contact = list[i];
  const Contact::Strains &strain = response.state.strain[i];
  Contact::Strains rate = Contact::Strains::Zero();
  if (increment.length > 0.)
    rate = (strain - committed.strain[i]) / increment.length;
  const double temperature =
      increment.temperatures.empty() ? contact.installation_temperature : increment.temperatures[i];
  LawOutput output{response.stress[i].data(), response.tangent[i].data(),
                   response.state.internal.data() + contact.state_offset, 0., ContactStatus::none};
  if (contact.law.integrate(strain.data(), rate.data(), contact.length,
                            {increment.time, increment.length, temperature},
                            committed.internal.data() + contact.state_offset, tangent,
                            output) != LawStatus::ok)
    response.failed = true;
  response.status[i] = output.contact;
  response.state.touch[i] = output.contact == ContactStatus::open ? strain : committed.touch[i];
  response.state.dissipated[i] = committed.dissipated[i] + contact.weight * output.dissipation;
}

void Contacts::add_forces(const ContactResponse &response, Vector &forces) const {
  for (unsigned int i = 0; i < list.size(); ++i)
    list[i].add_to(forces, response.stress[i]);
}

void Contacts::add_tangent(const ContactResponse &response, SparseMatrix &matrix) const {
  for (unsigned int i = 0; i < list.size(); ++i) {
    const Contact &contact = list[i];
    const auto local =
        (contact.weight * contact.B_reduced.transpose() * response.tangent[i] * contact.B_reduced)
            .eval();
    for (unsigned int j = 0; j < contact.unknowns.size(); ++j)
      for (unsigned int k = 0; k < contact.unknowns.size(); ++k)
        add_to(matrix, contact.unknowns[j], contact.unknowns[k], local(j, k));
  }
}

void Contacts::place_platens(Vector &unknowns) const {
  for (const auto &[unknown, value] : platen_positions)
    unknowns[unknown] += value;
}

ContactState Contacts::initial_state(const Vector &all_dofs) const {
  ContactState state;
  state.internal.assign(n_internal + 1, 0.);
  state.strain.resize(list.size());
  state.dissipated.assign(list.size(), 0.);
  state.wear = state.impulse = state.dissipated;
  for (unsigned int i = 0; i < list.size(); ++i)
    state.strain[i] = list[i].strain(all_dofs);
  state.touch = state.strain;
  if (all_dofs.isZero(0.))
    return state;
  // Touch down at the initial displacements: evaluated as if lifted off by one length, whatever is
  // irreversible follows the node.
  for (unsigned int i = 0; i < list.size(); ++i) {
    const Contact &contact = list[i];
    const Contact::Strains &strain = state.strain[i];
    const BoundLaw::Answer answer =
        contact.law.answer_at_rest({1., strain[1], strain[2], strain[3]}, contact.length,
                                   LawTangent::none, contact.installation_temperature);
    std::copy(answer.state.begin(), answer.state.end() - 1,
              state.internal.begin() + contact.state_offset);
  }
  return state;
}

} // namespace frictionbeam
