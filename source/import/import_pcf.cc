// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/import_pcf.h"

#include "base/number_text.h"
#include "base/unit_constants.h"
#include "base/user_error.h"
#include "import/line/bend_geometry.h"
#include "import/line/connections.h"
#include "import/line/neighbours.h"
#include "import/line/pieces.h"
#include "import/line/routes.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::import {

namespace {

class SupportPlanner {
public:
  SupportPlanner(const PcfLine &line, const SupportTable &table, const RouteNames &names,
                 ImportedLine &result)
      : line(line), table(table), names(names), plan(result.plan), notes(result.notes) {}

  void add(const Placed &placed) {
    const PcfComponent &component = line.components[placed.component];
    const std::vector<MappedSupport> *const row = table.find(component.words);
    if (row == nullptr && component.shape == Shape::joint) {
      notes.assumed.push_back({component.line, component.keyword + called(component) + " at " +
                                                   text_of_place(placed.position) +
                                                   ": the line's end is free"});
      return;
    }
    const std::string point = point_of(placed, component);
    const std::string comment = component.text() + called(component) +
                                (component.skey.empty() ? "" : ", SKEY " + component.skey) +
                                (component.description.empty() ? "" : ", " + component.description);
    if (row == nullptr) {
      notes.not_understood.push_back(
          {component.line, component.keyword + called(component) +
                               (component.skey.empty() ? "" : ", SKEY " + component.skey) +
                               ": no row of --support-map fits; nothing holds the line at " +
                               point});
      plan.supports.push_back({section_names.take(name_of(component)), point, comment, {}, {}, {}});
      return;
    }
    if (component.shape == Shape::joint)
      notes.assumed.push_back({component.line, component.keyword + called(component) +
                                                   " is taken as: " + kinds_of(*row)});
    for (const MappedSupport &support : *row)
      if (support.kind == "none")
        notes.count_without_effect(component.keyword + called(component), component.line);
      else
        plan.supports.push_back(
            {section_names.take(name_of(component) +
                                (row->size() > 1 ? "_" + support.kind : std::string())),
             point,
             comment,
             support,
             {},
             {}});
    add_spring_data(component, *row);
  }

private:
  /// What the file says of the spring of a support goes to the hanger that it became, where the
  /// user's table has not said it.
  void add_spring_data(const PcfComponent &component, const std::vector<MappedSupport> &row) {
    const auto given = [&](const Property property) {
      const auto value = component.properties.number(property);
      return value && *value > 0. ? value : std::nullopt;
    };
    const auto rate = given(Property::spring_rate), cold = given(Property::cold_load),
               hot = given(Property::hot_load);
    const auto refuse = [&](const std::string &what) {
      notes.not_understood.push_back(
          {component.line, component.keyword + called(component) + ": " + what});
    };
    if (hot)
      refuse("its hot load of " + rounded_number(*hot) +
             " N is not taken: it follows from stiffness, cold load and travel");
    if (!rate && !cold)
      return;
    PlannedSupport *hanger = nullptr;
    for (std::size_t i = 0; i < row.size() && i < plan.supports.size(); ++i)
      if (PlannedSupport &one = plan.supports[plan.supports.size() - 1 - i];
          one.support && one.support->kind == "hanger")
        hanger = &one;
    if (row.front().kind == "none" && row.size() == 1)
      return;
    if (hanger == nullptr) {
      refuse("its spring's data is not taken: --support-map makes no hanger of it, but " +
             kinds_of(row));
      return;
    }
    const auto is_given = [&](const std::string &entry) {
      for (const auto &[name, value] : hanger->support->entries)
        if (name == entry || name == "Item" ||
            (name == "Kind" && value == "constant" && entry == "Stiffness"))
          return true;
      return false;
    };
    const auto refuse_given = [&](const std::string &what) {
      refuse("its " + what + " is not taken: the hanger of --support-map has its own");
    };
    if (rate && is_given("Stiffness"))
      refuse_given("spring rate");
    else if (rate && !cold && !is_given("Cold load"))
      refuse("a spring rate without a cold load: not taken, the hanger is sized");
    else
      hanger->stiffness = rate;
    if (cold && is_given("Cold load"))
      refuse_given("cold load");
    else
      hanger->cold_load = cold;
  }

  static std::string called(const PcfComponent &component) {
    return component.name.empty() ? "" : " " + component.name;
  }
  static std::string name_of(const PcfComponent &component) {
    return !component.name.empty()             ? component.name
           : component.shape == Shape::support ? "support"
                                               : "equipment";
  }
  static std::string kinds_of(const std::vector<MappedSupport> &row) {
    std::string text;
    for (const MappedSupport &support : row)
      text += (text.empty() ? "" : ", ") + support.kind;
    return text;
  }

  /// The name of its point; on a bend beside the middle, a point of its own.
  std::string point_of(const Placed &placed, const PcfComponent &component) {
    if (placed.node)
      return names.nodes[*placed.node];
    if (placed.in_the_middle)
      return names.bends.at(placed.piece);
    const std::string name = point_names.take("on_bend_" + std::to_string(component.line));
    plan.points.push_back({name, placed.position});
    return name;
  }

  const PcfLine &line;
  const SupportTable &table;
  const RouteNames &names;
  LinePlan &plan;
  Notes &notes;
  UniqueNames section_names, point_names;
};

void add_masses(const PcfLine &line, const Network &network, const RouteNames &names,
                ImportedLine &result) {
  UniqueNames mass_names;
  for (const Placed &placed : network.masses) {
    const PcfComponent &component = line.components[placed.component];
    const std::string &point = names.nodes[*placed.node];
    const auto weight = component.properties.number(Property::weight);
    if (point.empty())
      result.notes.not_understood.push_back(
          {component.line, component.keyword + ", which has no length, is on no pipe; left out"});
    else if (weight && *weight > 0.)
      result.plan.masses.push_back({mass_names.take(component.keyword), point, *weight});
    else
      result.notes.assumed.push_back(
          {component.line, component.keyword + " has no length and no weight: left out"});
  }
}

} // namespace

UnitSystem units_of(const ImportOptions &options) {
  const std::optional<UnitSystem> units = UnitSystem::parse(options.units);
  if (!units)
    throw UserError("--units\n  read:    " + options.units +
                    "\n  allowed: si, or a length and a force, and a mass, a stress, a "
                    "temperature: " +
                    UnitSystem::known_words() + "\n  try:     --units \"in lb psi F\"");
  return *units;
}

ImportedLine import_pcf(const ImportOptions &options) {
  const double length = units_of(options).factor("m");
  ImportedLine result;
  const SupportTable table(options.support_map);
  const PcfFile file(options.file, options.encoding);
  PcfLine line = read_components(file, options.attributes, result.notes);
  result.n_components = line.components.size();
  for (const std::string &pipeline : line.pipelines)
    if (!pipeline.empty())
      result.plan.title += (result.plan.title.empty() ? "" : ", ") + pipeline;
  const double tolerance = 1e-3 * options.tolerance;
  complete_by_neighbours(line, tolerance, result.notes);
  SectionOptions section_options = options.sections;
  section_options.in_inches =
      std::abs(length - inch) < 1e-9 || std::abs(length - 12. * inch) < 1e-9;
  SectionPlanner sections(file, line, section_options, result.plan, result.notes);
  const Network network = make_pieces(file, line, tolerance, sections, result.notes);
  check_connections(file, line, network, tolerance, result.notes);
  check_tangents(file, line, network, tolerance, result.notes);
  const RouteNames names = make_routes(line, network, tolerance, result.plan, result.notes);
  SupportPlanner supports(line, table, names, result);
  for (const Placed &placed : network.joints)
    supports.add(placed);
  for (const Placed &placed : network.supports)
    supports.add(placed);
  add_masses(line, network, names, result);
  if (std::none_of(result.plan.supports.begin(), result.plan.supports.end(),
                   [](const PlannedSupport &one) { return one.support.has_value(); }))
    result.notes.assumed.push_back({0, "nothing holds the line: it needs supports"});
  for (std::vector<Notes::Note> *const list :
       {&result.notes.not_understood, &result.notes.assumed, &result.notes.moved})
    std::stable_sort(list->begin(), list->end(),
                     [](const Notes::Note &a, const Notes::Note &b) { return a.line < b.line; });
  return result;
}

} // namespace frictionbeam::import
