// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/quantity/point_forces.h"
#include "base/user_error.h"
#include "results/support/support_states.h"
#include "scene/support_pair.h"

namespace frictionbeam {

bool is_part_of(const SupportInfo &support, const std::string &where) {
  if (support.name == where)
    return true;
  if (is_of_a_pair(support.kind))
    for (const std::string half : {plus_half, minus_half})
      if (const auto at = support.name.rfind(half); at != std::string::npos)
        return support.name.substr(0, at) + support.name.substr(at + half.size()) == where;
  return false;
}

bool is_one_of(SupportInfo support, const std::string &where) {
  if (is_part_of(support, where))
    return true;
  support.name = support.name.substr(0, support.name.rfind('.'));
  return is_part_of(support, where);
}

std::optional<double> force_of_supports(const Model &model, const Results &results,
                                        const std::string &name, const LineState &state,
                                        const unsigned int component) {
  std::optional<double> force;
  for (unsigned int i = 0; i < results.supports.size(); ++i)
    if (is_part_of(results.supports[i], name))
      force = force.value_or(0.) + force_of_support(model, state, i)[component];
  return force;
}

double force_at_point(const Model &model, const FrameBuilder &builder, const std::string &point,
                      const LineState &state, const unsigned int component) {
  const unsigned int vertex = model.mesh.points.at(point);
  double force = builder.reaction(vertex)[component]; // of restraints
  for (const Spring &spring : model.scene.springs)
    if (spring.point == point || spring.other == point)
      force += (spring.point == point ? 1. : -1.) * builder.spring_force(state, spring)[component];
  for (unsigned int i = 0; i < model.contacts.places().size(); ++i) {
    const unsigned int contact = model.contacts.places()[i].front();
    if (model.contacts[contact].at == vertex)
      force += force_of_support(model, state, i)[component];
    if (model.contacts[contact].vertices[1] == vertex) // stands on the point
      force += force_of_contact(model, contact, state.contact_stress[contact], 1)[component];
  }
  return force;
}

void refuse_place(const Quantity &quantity) {
  throw UserError("Quantity " + quantity.name +
                  ": there is no point, restraint, spring or "
                  "support called '" +
                  quantity.where +
                  "'. A repeated support's names are numbered: name.1, name.2, ...");
}

} // namespace frictionbeam
