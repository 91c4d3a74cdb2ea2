// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/catalogue/catalogue_entries.h"

#include "scene/catalogue/catalogue_file.h"
#include "scene/in_units.h"
#include "scene/part/parts.h"

#include <cmath>
#include <stdexcept>

namespace frictionbeam::parts {

namespace {

constexpr double length_tolerance = 1e-3; // of a component in a drawing [m]

/// The rows of the table that an entry names; none if it is empty.
std::vector<CatalogueRow> rows_of(const ParameterReader &in, const std::string &entry,
                                  const std::vector<CatalogueColumn> &columns) {
  if (in.text(entry).empty())
    return {};
  try {
    return read_catalogue(existing_file(in, entry), columns);
  } catch (const std::runtime_error &error) {
    in.fail(entry, "a table as doc/catalogues.md says", "to mend the line that is named",
            error.what());
  }
}

} // namespace

void declare_catalogue(ParameterReader &in) {
  in.declare_text("Hangers", "", "path of a csv file",
                  "Your own table of spring hangers: item, stiffness [N/mm], least load [N], most "
                  "load [N], in the order in which they are preferred.");
  in.declare_text(
      "Constant hangers", "", "path of a csv file",
      "The same of constant hangers: item, least load [N], most load [N], travel [mm].");
  in.declare_text(
      "Components", "", "path of a csv file",
      "Your own table of valves, flanges and other rigid parts: item, length [mm], mass "
      "[kg].");
}

namespace {

void check_range(const ParameterReader &in, const std::string &entry, const Scene &scene,
                 const CatalogueRow &row, const HangerItem &item) {
  if (item.least_load >= item.most_load)
    in.fail(entry, "a least load below the most load",
            "to change the two in line " + std::to_string(row.line),
            "item '" + item.name + "' with a least load of " +
                in_units(scene.units, item.least_load, "N") + " and a most load of " +
                in_units(scene.units, item.most_load, "N"));
}

} // namespace

void parse_catalogue(const ParameterReader &in, Scene &scene) {
  for (const CatalogueRow &row :
       rows_of(in, "Hangers", {{"stiffness", "N/m"}, {"least load", "N"}, {"most load", "N"}})) {
    const HangerItem item{row.item, row.numbers[0], row.numbers[1], row.numbers[2]};
    check_range(in, "Hangers", scene, row, item);
    scene.catalogue.hangers.push_back(item);
  }
  for (const CatalogueRow &row : rows_of(
           in, "Constant hangers", {{"least load", "N"}, {"most load", "N"}, {"travel", "m"}})) {
    const HangerItem item{row.item, 0., row.numbers[0], row.numbers[1], row.numbers[2]};
    check_range(in, "Constant hangers", scene, row, item);
    scene.catalogue.constant_hangers.push_back(item);
  }
  for (const CatalogueRow &row : rows_of(in, "Components", {{"length", "m"}, {"mass", "kg"}}))
    scene.catalogue.components.push_back({row.item, row.numbers[0], row.numbers[1]});
}

const ComponentItem &component_item(const ParameterReader &in, const Scene &scene) {
  const auto &known = scene.catalogue.components;
  if (known.empty())
    in.fail("Item", "an item beside section Catalogue with Components",
            "'set Components = components.csv' there");
  return known[in.find("Item", in.text("Item"), names(known), "catalogue item")];
}

void parse_component_of_pipe(const ParameterReader &in, const Scene &scene, Pipe &pipe) {
  if (in.text("Item").empty())
    return;
  const ComponentItem &item = component_item(in, scene);
  if (in.given("Rigid") || in.given("Mass"))
    in.fail("Item", "an item, which is rigid and has a mass, or 'Rigid' and 'Mass'",
            "removing 'Rigid' and 'Mass'");
  double length = 0.;
  for (std::size_t i = 0; i + 1 < pipe.route.size(); ++i)
    length += pipe.route[i].position.distance(pipe.route[i + 1].position);
  if (pipe.route.empty() || std::abs(length - item.length) > length_tolerance)
    in.fail(
        "Item",
        "an item as long as its pipe's route, to " + in_units(scene.units, length_tolerance, "m") +
            ": it is " + in_units(scene.units, item.length, "m") + " long, the route " +
            (pipe.route.empty() ? "in Mesh/File is not known" : in_units(scene.units, length, "m")),
        "a route of the item's length, such as 'P by " + to_text(item.length / in.si("m")) +
            " 0 0', or another item");
  pipe.rigid = true;
  pipe.total_mass = item.mass;
}

void parse_item_of_hanger(const ParameterReader &in, const Scene &scene, Hanger &hanger) {
  const std::string name = in.text("Item");
  if (name.empty())
    return;
  if (hanger.stiffness > 0.)
    in.fail("Item", "an item, which has a stiffness, of a variable hanger without 'Stiffness'",
            "removing 'Stiffness'");
  const std::string table = hanger.constant ? "Constant hangers" : "Hangers";
  const auto &known = hanger.constant ? scene.catalogue.constant_hangers : scene.catalogue.hangers;
  if (known.empty())
    in.fail("Item", "an item beside section Catalogue with " + table,
            "'set " + table + " = hangers.csv' there");
  hanger.picks_item = name == "by load";
  if (hanger.picks_item) {
    if (hanger.cold_load > 0.)
      in.fail("Item", "by load of a hanger that is sized", "removing 'Cold load'");
    return;
  }
  std::vector<std::string> allowed = names(known);
  allowed.emplace_back("by load");
  const HangerItem &item = known[in.find("Item", name, allowed, "catalogue item")];
  hanger.items.assign(hanger.points.size(), item);
  if (hanger.cold_load > 0.)
    hanger.stiffness = item.stiffness;
}

} // namespace frictionbeam::parts
