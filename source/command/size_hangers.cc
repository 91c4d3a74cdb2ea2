// SPDX-License-Identifier: LGPL-2.1-or-later
#include "command/size_hangers.h"

#include "analysis/sequence/load_sequence.h"
#include "base/user_error.h"
#include "model/line_model.h"
#include "results/frame/frame_builder.h"
#include "results/text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace frictionbeam {

namespace {

constexpr double least_travel = 0.025; ///< [m]
/// Of the variation that is allowed, the part that a size may use: friction and the springs
/// themselves change the travel a little.
constexpr double usable = 0.98;

/// Springs of hangers that are to be sized, by the step of each hanger.
std::map<std::string, std::vector<unsigned int>> open_springs(const Scene &scene,
                                                              std::string Hanger::*const step) {
  std::map<std::string, std::vector<unsigned int>> springs;
  for (const Hanger &hanger : scene.hangers)
    if (hanger.cold_load == 0.) {
      std::vector<unsigned int> &list = springs[hanger.*step];
      list.insert(list.end(), hanger.springs.begin(), hanger.springs.end());
    }
  return springs;
}

/// The scene up to the end of a step, without what only its results need. Its sections stay
/// elastic: springs are chosen for the line as it is built, not for one that yields or creeps on
/// them.
Scene up_to(Scene scene, const std::string &step) {
  scene.keeps_elastic = true;
  const auto last = std::find_if(scene.steps.begin(), scene.steps.end(),
                                 [&](const LoadStep &s) { return s.name == step; });
  scene.steps.erase(last + 1, scene.steps.end());
  scene.quantities.clear();
  scene.monitors.clear();
  return scene;
}

/// A line solved up to its last step, and what was asked of it.
template <typename Ask>
void solve(const Scene &scene, const LawLibrary &laws, const std::string &what, const Ask &ask) {
  const LineModel line(scene, laws);
  LoadSequence sequence(line.model());
  if (!sequence.run([](const Progress &, const LineState &) {}))
    throw UserError("The hangers cannot be sized: " + what + ", step '" +
                    sequence.reports().back().step +
                    "' finds no equilibrium. Give their Cold load and Stiffness.");
  FrameBuilder builder(line.model());
  ask(builder, sequence.state());
}

std::string in_words(const Scene &scene, const double value, const std::string &unit) {
  return rounded_number(value / scene.units.factor(unit), 4) + " " + scene.units.name(unit);
}

using SpringsByStep = decltype(open_springs(std::declval<const Scene &>(), &Hanger::weight_step));

/// Make the springs' preloads what rigid supports in their places carry.
void find_hot_loads(const SpringsByStep &by_weight, const LawLibrary &laws, Scene &scene) {
  Scene held = scene;
  for (const auto &[step, open] : by_weight)
    for (const unsigned int s : open) {
      Restraint restraint;
      restraint.name = scene.springs[s].name + " held";
      restraint.kind = "restraint";
      restraint.placement.points = {scene.springs[s].point};
      Direction along;
      for (unsigned int d = 0; d < 3; ++d)
        along.vector[d] = scene.springs[s].directions[2][d];
      restraint.translations.push_back(along);
      held.restraints.push_back(restraint);
    }
  for (const auto &[step, springs] : by_weight) {
    const std::vector<unsigned int> &open = springs;
    solve(up_to(held, step), laws, "with rigid supports in their places",
          [&](FrameBuilder &builder, const LineState &state) {
            const Frame frame = builder.make(state);
            const auto infos = builder.restraint_infos();
            for (const unsigned int s : open)
              for (unsigned int i = 0; i < infos.size(); ++i)
                if (infos[i].name == scene.springs[s].name + " held")
                  scene.springs[s].preload =
                      product(frame.reactions[i], scene.springs[s].directions[2]);
          });
    for (const unsigned int s : open)
      if (scene.springs[s].preload <= 0.)
        throw UserError("Hanger " + scene.springs[s].name +
                        " would have to push the line the other way by " +
                        in_words(scene, -scene.springs[s].preload, "N") +
                        ". Remove it, or give its Cold load.");
  }
}

/// How far the springs' points go along them with these forces in their places [m], by spring.
std::vector<double> find_travels(const SpringsByStep &by_heat, const LawLibrary &laws,
                                 const Scene &scene) {
  std::vector<double> travel(scene.springs.size(), 0.);
  for (const auto &[step, springs] : by_heat) {
    const std::vector<unsigned int> &open = springs;
    solve(up_to(scene, step), laws, "with constant forces in their places",
          [&](FrameBuilder &builder, const LineState &state) {
            for (const unsigned int s : open)
              travel[s] = product(builder.motion(state, scene.springs[s].point),
                                  scene.springs[s].directions[2]);
          });
  }
  return travel;
}

/// Whether an item carries a load here and by its stiffness there as well.
bool carries(const HangerItem &item, const double hot, const double travel) {
  const double cold = hot + item.stiffness * travel;
  return std::min(hot, cold) >= item.least_load && std::max(hot, cold) <= item.most_load;
}

/// The first constant item of the catalogue that carries a load and has the travel.
HangerItem pick_constant_item(const Scene &scene, const Hanger &hanger, const Spring &spring,
                              const double travel) {
  const double load = spring.preload;
  unsigned int n_carrying = 0;
  double longest = 0.;
  for (const HangerItem &item : scene.catalogue.constant_hangers) {
    if (load < item.least_load || load > item.most_load)
      continue;
    if (std::abs(travel) <= usable * item.travel)
      return item;
    ++n_carrying;
    longest = std::max(longest, item.travel);
  }
  throw UserError(
      "Hanger " + hanger.name + ": no constant item of the catalogue fits " + spring.name +
      ".\n  read:    a load of " + in_words(scene, load, "N") + " and a travel of " +
      in_words(scene, travel, "m") + "\n  allowed: an item whose range holds the load, of " +
      std::to_string(scene.catalogue.constant_hangers.size()) + " there are " +
      std::to_string(n_carrying) + ", and " + rounded_number(100. * usable, 4) +
      " % of whose travel is enough" +
      (n_carrying > 0 ? ", the longest of these is " + in_words(scene, longest, "m") : "") +
      "\n  try:     more items in Catalogue/Constant hangers");
}

/// The first item of the catalogue that carries hot and cold load with no more than the variation
/// that is allowed.
HangerItem pick_item(const Scene &scene, const Hanger &hanger, const Spring &spring,
                     const double travel) {
  const double hot = spring.preload;
  unsigned int n_carrying = 0;
  const HangerItem *least = nullptr;
  for (const HangerItem &item : scene.catalogue.hangers) {
    if (!carries(item, hot, travel))
      continue;
    if (item.stiffness * std::abs(travel) <= usable * hanger.largest_variation * hot)
      return item;
    ++n_carrying;
    if (least == nullptr || item.stiffness < least->stiffness)
      least = &item;
  }
  throw UserError(
      "Hanger " + hanger.name + ": no item of the catalogue fits " + spring.name +
      ".\n  read:    a hot load of " + in_words(scene, hot, "N") + " and a travel of " +
      in_words(scene, travel, "m") +
      "\n  allowed: an item whose range holds hot and cold load, of " +
      std::to_string(scene.catalogue.hangers.size()) + " there are " + std::to_string(n_carrying) +
      ", and that varies by no more than " +
      rounded_number(100. * usable * hanger.largest_variation, 4) + " %" +
      (least != nullptr ? ", these vary by " +
                              rounded_number(100. * least->stiffness * std::abs(travel) / hot, 4) +
                              " % and more, " + least->name + " least"
                        : "") +
      "\n  try:     a larger 'Variation', more items in Catalogue/Hangers, or Kind = constant");
}

/// Choose stiffness and cold load of a spring that has its hot load, and say so.
void size_spring(Hanger &hanger, const std::size_t place, const double travel, Scene &scene) {
  Spring &spring = scene.springs[hanger.springs[place]];
  const double hot = spring.preload, variation = usable * hanger.largest_variation,
               sizing_travel = variation * least_travel;
  if (hanger.picks_item)
    hanger.items.push_back(hanger.constant ? pick_constant_item(scene, hanger, spring, travel)
                                           : pick_item(scene, hanger, spring, travel));
  const bool has_item = place < hanger.items.size();
  const bool travels_less = !hanger.constant && !has_item && std::abs(travel) < sizing_travel;
  if (!hanger.constant) {
    spring.stiffness[2] = has_item       ? hanger.items[place].stiffness
                          : travels_less ? hot / least_travel
                                         : variation * hot / std::abs(travel);
    spring.preload = hot + spring.stiffness[2] * travel;
  }
  const auto number = [&](const double value, const std::string &unit) {
    return in_words(scene, value, unit);
  };
  scene.remarks.push_back(
      "Hanger " + spring.name + " was sized: " +
      (has_item ? "item " + hanger.items[place].name + ", " : "") + "hot load " + number(hot, "N") +
      (hanger.constant ? ""
                       : ", cold load " + number(spring.preload, "N") + ", stiffness " +
                             number(spring.stiffness[2], "N/m")) +
      ", travel " + number(travel, "m") +
      (scene.yields() ? ", of the line while it is elastic" : "") +
      (travels_less
           ? ". For so little it was sized as for " + number(sizing_travel, "m") +
                 ", which is its hot load over " + number(least_travel, "m") + " for a stiffness."
           : "."));
}

} // namespace

Scene with_sized_hangers(Scene scene, const LawLibrary &laws) {
  const SpringsByStep by_weight = open_springs(scene, &Hanger::weight_step),
                      by_heat = open_springs(scene, &Hanger::hot_step);
  find_hot_loads(by_weight, laws, scene);
  const std::vector<double> travel = find_travels(by_heat, laws, scene);
  for (Hanger &hanger : scene.hangers)
    for (std::size_t i = 0; i < hanger.springs.size() && hanger.cold_load == 0.; ++i)
      size_spring(hanger, i, travel[hanger.springs[i]], scene);
  return scene;
}

} // namespace frictionbeam
