// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/frame/frame_builder.h"

#include "results/support/support_names.h"
#include "results/support/support_states.h"

#include <cmath>

namespace frictionbeam {

void FrameBuilder::find_places() {
  using Of = QuantityKind::Of;
  const std::vector<SupportInfo> infos = support_infos(model);
  const auto add = [&](const std::string &where, const bool of_all) {
    if (place_of(where, of_all))
      return;
    Place place{where, of_all, {}};
    for (unsigned int i = 0; i < infos.size(); ++i)
      if (of_all ? where.empty() || is_one_of(infos[i], where) : is_part_of(infos[i], where))
        place.supports.push_back(i);
    if (of_all || !place.supports.empty() || model.mesh.points.count(where) > 0)
      places.push_back(place);
  };
  add("", true);
  for (const Quantity &quantity : model.scene.quantities)
    if (quantity.is(Of::supports) || quantity.is(Of::holder) || quantity.is(Of::directed) ||
        quantity.is(Of::support))
      add(quantity.where, quantity.is(Of::supports));
}

std::optional<std::size_t> FrameBuilder::place_of(const std::string &where,
                                                  const bool of_all) const {
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i].where == where && places[i].of_all == of_all)
      return i;
  return {};
}

std::vector<SupportState> FrameBuilder::sums_of(const Frame &frame,
                                                const ForceAtPoint &force_at) const {
  std::vector<SupportState> result;
  for (const Place &place : places) {
    SupportState sum;
    for (const unsigned int i : place.supports) {
      const SupportState &one = frame.supports[i];
      if (place.of_all) {
        sum.fn += std::abs(one.fn);
        sum.ft1 += std::hypot(one.ft1, one.ft2);
        continue;
      }
      for (const auto number : support_numbers)
        sum.*number += one.*number;
      for (unsigned int c = 0; c < 6; ++c)
        sum.on_pipe[c] += one.on_pipe[c];
    }
    if (!place.of_all && place.supports.empty())
      sum.on_pipe = force_at(model.mesh.points.at(place.where), place.where);
    result.push_back(sum);
  }
  return result;
}

std::vector<SupportState> FrameBuilder::together(const LineState &state, const Frame &frame) const {
  return sums_of(frame, [&](const unsigned int vertex, const std::string &point) {
    return force_on(vertex, point, state, frame);
  });
}

std::vector<SupportState> FrameBuilder::together(const Frame &frame) const {
  const std::vector<RestraintInfo> restraints = restraint_infos();
  const std::vector<SupportInfo> supports = support_infos(model);
  return sums_of(frame, [&](const unsigned int vertex, const std::string &) {
    const Point3 place = model.mesh.vertices[vertex];
    Motion sum{};
    for (unsigned int c = 0; c < 6; ++c) {
      for (std::size_t i = 0; i < restraints.size(); ++i)
        sum[c] += restraints[i].position == place ? frame.reactions[i][c] : 0.;
      for (std::size_t i = 0; i < supports.size(); ++i)
        sum[c] += supports[i].position == place ? frame.supports[i].on_pipe[c] : 0.;
    }
    return sum;
  });
}

Motion FrameBuilder::force_on(const unsigned int vertex, const std::string &point,
                              const LineState &state, const Frame &frame) const {
  Motion force = reaction(vertex); // of restraints
  const auto add = [&](const double sign, const Motion &one) {
    for (unsigned int c = 0; c < 6; ++c)
      force[c] += sign * one[c];
  };
  for (const Spring &spring : model.scene.springs)
    if (spring.point == point || spring.other == point)
      add(spring.point == point ? 1. : -1., spring_force(state, spring));
  for (unsigned int i = 0; i < model.contacts.places().size(); ++i) {
    const unsigned int contact = model.contacts.places()[i].front();
    if (model.contacts[contact].at == vertex)
      add(1., frame.supports[i].on_pipe);
    if (model.contacts[contact].vertices[1] == vertex) // stands on the point
      add(1., force_of_contact(model, contact, state.contact_stress[contact], 1));
  }
  return force;
}

} // namespace frictionbeam
