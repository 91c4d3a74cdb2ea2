// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/support/support_states.h"

#include <algorithm>

namespace frictionbeam {

using namespace dealii;

namespace {

SupportState state_of_contact(const Model &model, const LineState &state, const unsigned int i) {
  const Contact &contact = model.contacts[i];
  const double share = contact.share();
  const Contact::Strains &stress = state.contact_stress[i], &strain = state.contacts.strain[i];
  SupportState result;
  result.status = state.contact_status[i];
  result.fn = -share * stress[0];
  result.ft1 = share * stress[2];
  result.ft2 = share * stress[1];
  result.mt = -share * stress[3];
  result.work_friction = state.contacts.dissipated[i];
  result.wear = state.contacts.wear[i];
  result.impulse = state.contacts.impulse[i];
  const FrictionThreshold &law = contact.law.closed_form();
  result.gap = strain[0] * contact.length + contact.law.gap();
  if (result.status != ContactStatus::open) {
    // What is left of the displacement since contact began when the elastic part is taken out.
    const Contact::Strains &touch = state.contacts.touch[i];
    const auto slip = [&](const unsigned int e, const double rigidity) {
      const double elastic = rigidity > 0. ? stress[e] / rigidity : 0.;
      return -(strain[e] - touch[e] - elastic) * contact.length;
    };
    result.slip1 = slip(2, law.shear_rigidity_z);
    result.slip2 = slip(1, law.shear_rigidity_y);
  }
  return result;
}

/// Of both edges of a patch.
ContactStatus status_of(const ContactStatus one, const ContactStatus other) {
  for (const ContactStatus status :
       {ContactStatus::slip, ContactStatus::stick, ContactStatus::closed})
    if (one == status || other == status)
      return status;
  return one;
}

SupportState state_of_edges(const Model &model, const std::vector<unsigned int> &edges,
                            const std::array<SupportState, 2> &states) {
  SupportState result;
  result.status = status_of(states[0].status, states[1].status);
  result.gap = std::min(states[0].gap, states[1].gap);
  unsigned int n_touching = 0;
  for (const unsigned int k : {0u, 1u}) {
    const SupportState &one = states[k];
    const Contact &contact = model.contacts[edges[k]];
    const Vector3 couple = cross_product_3d(contact.arm, force_along_axes(contact, one));
    result.fn += one.fn;
    result.ft1 += one.ft1;
    result.ft2 += one.ft2;
    result.mt += one.mt - couple * contact.axes.x;
    result.work_friction += one.work_friction;
    result.wear += one.wear;
    result.impulse += one.impulse;
    result.slip1 += one.slip1;
    result.slip2 += one.slip2;
    n_touching += one.status != ContactStatus::open;
  }
  if (n_touching == 2) { // what is open has none
    result.slip1 /= 2.;
    result.slip2 /= 2.;
  }
  result.tilt = (states[1].fn - states[0].fn) * model.contacts[edges[1]].arm.norm();
  return result;
}

} // namespace

Vector3 force_along_axes(const Contact &contact, const SupportState &state) {
  return -state.fn * contact.axes.x + state.ft1 * contact.axes.z + state.ft2 * contact.axes.y;
}

std::string name_of_place(const std::string &part, const unsigned int place, const bool several) {
  return several ? part + "." + std::to_string(place + 1) : part;
}

std::vector<SupportInfo> support_infos(const Model &model) {
  std::vector<SupportInfo> infos;
  for (const auto &of_place : model.contacts.places()) {
    const Contact &contact = model.contacts[of_place.front()];
    const FrictionSupport &support = model.scene.supports[contact.support];
    infos.push_back({name_of_place(support.name, contact.place,
                                   n_places(model.mesh.supports[contact.support]) > 1),
                     support.kind, model.discretization.vertices()[contact.at], -contact.axes.x,
                     contact.axes.z, contact.axes.y, support.capacity});
  }
  return infos;
}

std::vector<unsigned int> supports_of_contacts(const Contacts &contacts) {
  std::vector<unsigned int> supports(contacts.size());
  for (unsigned int i = 0; i < contacts.places().size(); ++i)
    for (const unsigned int contact : contacts.places()[i])
      supports[contact] = i;
  return supports;
}

SupportState support_state(const Model &model, const LineState &state, const unsigned int support) {
  const std::vector<unsigned int> &contacts = model.contacts.places()[support];
  SupportState result = state_of_contact(model, state, contacts.front());
  if (contacts.size() > 1)
    result = state_of_edges(model, contacts,
                            {{result, state_of_contact(model, state, contacts.back())}});
  result.on_pipe = force_of_support(model, state, support);
  return result;
}

Motion force_of_contact(const Model &model, const unsigned int i, const Contact::Strains &stress,
                        const unsigned int side) {
  const Contact &contact = model.contacts[i];
  Motion force{};
  for (unsigned int c = 0; c < 6; ++c)
    for (unsigned int j = 0; j < contact.dofs.size(); ++j)
      if (model.discretization.vertex_dofs().index(contact.vertices[side], c) == contact.dofs[j])
        force[c] -= contact.weight * contact.B_dofs.col(j).dot(stress);
  return force;
}

Motion force_of_support(const Model &model, const LineState &state, const unsigned int support) {
  Motion sum{};
  for (const unsigned int i : model.contacts.places()[support]) {
    const Motion force = force_of_contact(model, i, state.contact_stress[i], 0);
    const Vector3 couple =
        cross_product_3d(model.contacts[i].arm, Vector3({force[0], force[1], force[2]}));
    for (unsigned int c = 0; c < 6; ++c)
      sum[c] += force[c] + (c < 3 ? 0. : couple[c - 3]);
  }
  return sum;
}

} // namespace frictionbeam
