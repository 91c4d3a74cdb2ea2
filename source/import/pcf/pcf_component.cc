// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/pcf/pcf_component.h"

#include "base/unit_constants.h"
#include "scene/file/parameter_file.h"

#include <algorithm>

namespace frictionbeam::import {

namespace {

constexpr double pi_of_angles = 3.14159265358979323846;
/// Of a line of pipes [m]; beyond it stands a number in another unit, or none.
constexpr double farthest = 1e6;

/// Attributes that are taken as they are, whatever the table says.
const std::vector<std::string> own_attributes = {
    "END-POINT", "CENTRE-POINT", "BRANCH1-POINT", "BRANCH2-POINT", "CO-ORDS",
    "SKEY",      "ITEM-CODE",    "BEND-RADIUS",   "ANGLE",         "ITEM-DESCRIPTION"};

bool names_a_support(const std::string &key) {
  return key == "NAME" || key == "TAG" || key.rfind("SUPPORT-", 0) == 0 ||
         key == "CONNECTION-REFERENCE";
}

bool has_digit(const std::string &text) {
  return text.find_first_of("0123456789") != std::string::npos;
}

/// Whether a component says that it is made of straight pieces cut aslant.
bool is_mitred(const PcfComponent &component) {
  for (const std::string &text : {component.keyword, component.skey, component.description})
    if (capitals(text).find("MITRE") != std::string::npos ||
        capitals(text).find("MITER") != std::string::npos)
      return true;
  return false;
}

class ComponentReader {
public:
  ComponentReader(const PcfFile &file, const std::string &attributes, Notes &notes)
      : file(file), notes(notes) {
    read_units();
    table.emplace(attributes, line.in_inches);
    read_materials();
  }

  PcfLine read() {
    line.pipelines.emplace_back();
    pipeline_properties.emplace_back();
    for (const PcfBlock &block : file.blocks()) {
      if (block.in_materials || block.keyword == "MATERIALS" ||
          block.keyword.rfind("UNITS-", 0) == 0 || block.keyword == "ISOGEN-FILES") {
        if (!block.in_materials)
          count_entries(block);
        continue;
      }
      if (block.keyword == "PIPELINE-REFERENCE")
        begin_pipeline(block);
      else
        add(block);
    }
    for (PcfComponent &component : line.components)
      component.properties.complete(pipeline_properties[component.pipeline]);
    note_weights();
    return std::move(line);
  }

private:
  /// The factor of a length unit [m]; @p needed: the file must have it.
  double length_unit(const std::string &key, const bool needed) const {
    const std::string hint =
        "the line '" + key + " MM' or '" + key + " INCH' with the others at the file's beginning";
    for (const PcfBlock &block : file.blocks())
      if (block.keyword == key) {
        const std::string unit = capitals(block.text);
        if (unit == "MM")
          return 1e-3;
        if (unit == "INCH" || unit == "IN" || unit == "INCHES")
          return inch;
        file.fail(block.line, key + " " + block.text, "MM or INCH", hint);
      }
    if (needed)
      file.fail(0, "a file without " + key, "a piping component file, which says its units", hint);
    return 0.;
  }

  void read_units() {
    unit = length_unit("UNITS-CO-ORDS", true);
    line.in_inches = unit == inch;
    line.bores_in_inches = length_unit("UNITS-BORE", true) == inch;
    length_unit("UNITS-BOLT-DIA", false);
    length_unit("UNITS-BOLT-LENGTH", false);
    for (const PcfBlock &block : file.blocks()) {
      const std::string word = capitals(block.text);
      if (block.keyword == "UNITS-WEIGHT") {
        if (word != "KGS" && word != "KG" && word != "LBS" && word != "LB")
          file.fail(block.line, "UNITS-WEIGHT " + block.text, "KGS or LBS", "'UNITS-WEIGHT KGS'");
        weight_unit = word;
      } else if (block.keyword.rfind("UNITS-", 0) == 0 && block.keyword != "UNITS-BORE" &&
                 block.keyword != "UNITS-CO-ORDS" && block.keyword != "UNITS-BOLT-DIA" &&
                 block.keyword != "UNITS-BOLT-LENGTH")
        notes.count_without_effect(block.keyword, block.line);
    }
  }

  /// What MATERIALS says of each ITEM-CODE.
  void read_materials() {
    for (const PcfBlock &block : file.blocks()) {
      has_materials = has_materials || block.keyword == "MATERIALS";
      if (!block.in_materials)
        continue;
      if (block.keyword != "ITEM-CODE") {
        notes.not_understood.push_back(
            {block.line, block.keyword + " " + block.text + ", after MATERIALS"});
        continue;
      }
      std::string &text = descriptions[block.text];
      for (const PcfEntry &entry : block.entries)
        if (entry.key == "DESCRIPTION")
          text = entry.text;
        else
          notes.count_without_effect(entry.key, entry.line);
    }
  }

  void count_entries(const PcfBlock &block) {
    for (const PcfEntry &entry : block.entries)
      notes.count_without_effect(entry.key, entry.line);
  }

  void begin_pipeline(const PcfBlock &block) {
    line.pipelines.push_back(block.text);
    Properties properties;
    for (const PcfEntry &entry : block.entries)
      read_attribute(entry, block.keyword, properties);
    if (properties.numbers.erase(Property::weight) > 0) // each component would weigh as much
      notes.not_understood.push_back(
          {block.line, block.keyword + ": the weight of a whole pipeline; not taken"});
    pipeline_properties.push_back(properties);
  }

  /// Weights of what has that of its section, and of supports.
  void note_weights() {
    std::map<std::string, Notes::Count> counts;
    for (const PcfComponent &component : line.components)
      if (component.shape != Shape::rigid && component.shape != Shape::end &&
          !(component.kind != nullptr && component.kind->may_be_point) &&
          component.properties.number(Property::weight)) {
        Notes::Count &count = counts[component.keyword];
        if (count.n++ == 0)
          count.first_line = component.line;
      }
    for (const auto &[keyword, count] : counts)
      notes.not_understood.push_back(
          {count.first_line, "the weight that " + std::to_string(count.n) + " " + keyword +
                                 " say is not taken: pipe weighs what its section does"});
  }

  void read_attribute(const PcfEntry &entry, const std::string &keyword, Properties &properties) {
    const AttributeTable::Row *row = table->find(entry.key);
    const AttributeTable::Row of_weight{Property::weight, weight_unit};
    if (entry.key == "WEIGHT" ||
        (row != nullptr && row->property == Property::weight && row->unit.empty()))
      row = &of_weight;
    if (row == nullptr) {
      if (entry.key.rfind("COMPONENT-ATTRIBUTE", 0) == 0 && !entry.text.empty())
        notes.not_understood.push_back(
            {entry.line, keyword + ": " + entry.key + " " + entry.text +
                             ", whose meaning --attributes can say (caesar, caepipe, or a file)"});
      else
        notes.count_without_effect(entry.key, entry.line);
      return;
    }
    if (row->property == Property::none)
      notes.count_without_effect(entry.key, entry.line);
    const std::string trouble = AttributeTable::read(*row, entry.text, properties);
    if (!trouble.empty())
      notes.not_understood.push_back(
          {entry.line, keyword + ": " + entry.key + " " + entry.text + " " + trouble});
  }

  PcfPoint read_point(const PcfBlock &block, const PcfEntry &entry) const {
    const std::vector<std::string> words = split(entry.text, ' ');
    PcfPoint point;
    point.line = entry.line;
    const std::string cut = file.is_last(block) && &entry == &block.entries.back()
                                ? "; the file ends here: was it cut off?"
                                : "";
    for (unsigned int d = 0; d < 3; ++d)
      if (words.size() <= d || !to_number(words[d], point.position[d]) ||
          std::abs(point.position[d] *= unit) > farthest)
        file.fail(entry.line, block.keyword + ": " + entry.key + " " + entry.text + cut,
                  "x y z in the unit of UNITS-CO-ORDS, at most 1000 km, and then the bore",
                  "'" + entry.key + " 1000.0 0.0 0.0 100'");
    if (words.size() > 3 && (!to_number(words[3], point.bore) || point.bore < 0.))
      point.bore = 0.; // a word such as BW: no bore
    return point;
  }

  void add_entry(const PcfBlock &block, const PcfEntry &entry, PcfComponent &component) {
    if (entry.key == "END-POINT")
      component.ends.push_back(read_point(block, entry));
    else if (entry.key == "CENTRE-POINT")
      component.centre = read_point(block, entry);
    else if (entry.key == "BRANCH1-POINT" || entry.key == "BRANCH2-POINT")
      component.branches.push_back(read_point(block, entry));
    else if (entry.key == "CO-ORDS")
      component.place = read_point(block, entry);
    else if (entry.key == "SKEY")
      component.skey = entry.text;
    else if (entry.key == "ITEM-CODE")
      component.item = entry.text;
    else if (entry.key == "ITEM-DESCRIPTION")
      component.description = entry.text;
    else if (double value; entry.key == "BEND-RADIUS" && to_number(entry.text, value))
      component.bend_radius = value * unit;
    else if (double value; entry.key == "ANGLE" && to_number(entry.text, value))
      component.angle = value / 100. * pi_of_angles / 180.; // hundredths of a degree
    else if (names_a_support(entry.key) &&
             (component.shape == Shape::support || component.shape == Shape::joint)) {
      if (component.name.empty() && entry.key != "SUPPORT-TYPE" && entry.key != "SUPPORT-DIRECTION")
        component.name = entry.text;
      component.words.push_back(entry.text);
    } else if (table->find(entry.key) != nullptr || entry.key == "WEIGHT" ||
               entry.key.rfind("COMPONENT-ATTRIBUTE", 0) == 0)
      read_attribute(entry, component.keyword, component.properties);
    else if (component.shape == Shape::support && has_digit(entry.text))
      notes.not_understood.push_back(
          {entry.line, component.keyword + ": " + entry.key + " " + entry.text +
                           ", whose meaning --attributes can say (spring_rate, cold_load, ...)"});
    else
      notes.count_without_effect(entry.key, entry.line);
  }

  void add(const PcfBlock &block) {
    PcfComponent component;
    component.keyword = block.keyword;
    component.line = block.line;
    component.pipeline = line.pipelines.size() - 1;
    component.kind = find_component_kind(block.keyword);
    component.shape = component.kind != nullptr ? component.kind->shape : Shape::none;
    if (component.shape == Shape::none && component.kind != nullptr) {
      notes.count_without_effect(block.keyword, block.line);
      return;
    }
    for (const PcfEntry &entry : block.entries)
      add_entry(block, entry, component);
    if (component.description.empty())
      component.description = describe(component);
    component.words.insert(component.words.end(), {component.skey, component.item,
                                                   component.description, component.keyword});
    if (component.kind == nullptr) {
      add_unknown(block, component);
      return;
    }
    if (component.kind->remark != nullptr)
      notes.assumed.push_back(
          {component.line, component.keyword + " is " + component.kind->remark});
    if (component.shape == Shape::bend && is_mitred(component))
      notes.not_understood.push_back({component.line, component.keyword +
                                                          " is mitred: taken as a "
                                                          "smooth bend of the same radius, whose "
                                                          "flexibility and stress factors differ"});
    check_points(block, component);
    line.components.push_back(component);
  }

  std::string describe(const PcfComponent &component) {
    const auto found = descriptions.find(component.item);
    if (found != descriptions.end())
      return found->second;
    if (!component.item.empty() && !said_missing) {
      said_missing = true;
      notes.assumed.push_back({component.line, "ITEM-CODE " + component.item +
                                                   (has_materials ? " is not in MATERIALS"
                                                                  : ": the file has no MATERIALS; "
                                                                    "was it cut off?")});
    }
    return "";
  }

  /// Whether its CENTRE-POINT makes a bend.
  static bool turns(const PcfComponent &component) {
    if (!component.centre)
      return false;
    const Point3 &a = component.ends[0].position, &b = component.ends[1].position,
                 &corner = component.centre->position;
    const double first = corner.distance(a), second = corner.distance(b);
    return std::abs(first - second) < 1e-3 * first && a.distance(b) < 0.999 * (first + second);
  }

  /// A word that is not known: with two ends, the line goes through it as through a pipe.
  void add_unknown(const PcfBlock &block, PcfComponent &component) {
    if (component.ends.size() != 2) {
      notes.not_understood.push_back({block.line, block.keyword +
                                                      (block.text.empty() ? "" : " " + block.text) +
                                                      ", left out: no component that is known"});
      return;
    }
    component.shape = turns(component) ? Shape::bend : Shape::pipe;
    notes.not_understood.push_back(
        {block.line, block.keyword + ", no component that is known: taken as a " +
                         (component.shape == Shape::bend ? "bend" : "pipe") + " from end to end"});
    line.components.push_back(component);
  }

  void check_points(const PcfBlock &block, const PcfComponent &component) const {
    std::string lacks;
    std::string allowed;
    const std::size_t n = component.ends.size();
    const std::string has = std::to_string(n) + " END-POINT" + (n == 1 ? "" : "s");
    switch (component.shape) {
    case Shape::support:
    case Shape::joint:
      if (!component.place && n == 0)
        lacks = "no CO-ORDS", allowed = "CO-ORDS x y z";
      break;
    case Shape::end:
      if (n == 0 || n > 2)
        lacks = has, allowed = "one or two END-POINTs";
      break;
    case Shape::olet:
      if (!component.centre || component.branches.empty())
        lacks = component.centre ? "no BRANCH1-POINT" : "no CENTRE-POINT",
        allowed = "CENTRE-POINT, on the pipe's axis, and BRANCH1-POINT";
      break;
    default:
      if (n != 2)
        lacks = has, allowed = "two END-POINTs";
      else if (component.shape == Shape::bend && !component.centre)
        lacks = "no CENTRE-POINT", allowed = "CENTRE-POINT, where the two tangents meet";
      else if (component.shape == Shape::tee && component.branches.empty())
        lacks = "no BRANCH1-POINT", allowed = "two END-POINTs and BRANCH1-POINT";
    }
    if (!lacks.empty())
      file.fail(block.line,
                block.keyword + " with " + lacks +
                    (file.is_last(block) ? "; the file ends here: was it cut off?" : ""),
                allowed, "the file as its program wrote it, or the points by hand");
  }

  const PcfFile &file;
  Notes &notes;
  std::optional<AttributeTable> table;
  double unit = 1e-3; ///< of co-ordinates [m]
  std::string weight_unit;
  std::map<std::string, std::string> descriptions; ///< by ITEM-CODE
  bool has_materials = false, said_missing = false;
  std::vector<Properties> pipeline_properties;
  PcfLine line;
};

} // namespace

PcfLine read_components(const PcfFile &file, const std::string &attributes, Notes &notes) {
  return ComponentReader(file, attributes, notes).read();
}

} // namespace frictionbeam::import
