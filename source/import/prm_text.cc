// SPDX-License-Identifier: LGPL-2.1-or-later
#include "import/import_pcf.h"

#include "base/number_text.h"

#include <cmath>

namespace frictionbeam::import {

namespace {

constexpr std::size_t longest_text = 108; ///< of a line of the parameter file

/// @p text as it may stand in a comment or title.
std::string harmless(std::string text) {
  for (char &c : text)
    if (c == '#' || c == '\\' || static_cast<unsigned char>(c) < 32)
      c = ' ';
  return text;
}

class PrmText {
public:
  PrmText(const ImportedLine &line, const ImportOptions &options, const UnitSystem &units)
      : line(line), plan(line.plan), options(options), units(units) {}

  std::string write() {
    add_head();
    add_materials_and_sections();
    for (const NamedPoint &point : plan.points)
      section("Point " + point.name, {{"Position", place(point.position)}});
    for (const PlannedPipe &pipe : plan.pipes)
      add_pipe(pipe);
    for (const PlannedTee &tee : plan.tees)
      section("Tee " + tee.name, {{"At", tee.point}, {"Branch", tee.branch}, {"Kind", tee.kind}});
    for (const PlannedMass &mass : plan.masses)
      section("Mass " + mass.name, {{"At", mass.point}, {"Mass", number(mass.mass, "kg")}});
    for (const PlannedSupport &support : plan.supports)
      add_support(support);
    add_loads();
    return text;
  }

private:
  using Entries = std::vector<std::pair<std::string, std::string>>;

  void section(const std::string &heading, const Entries &entries, const std::string &indent = "") {
    text += indent + "subsection " + heading + "\n";
    for (const auto &[entry, value] : entries)
      text += indent + "  set " + entry + " = " + value + "\n";
    text += indent + "end\n";
  }

  /// Nanometres of lengths, ten digits of all else.
  std::string number(const double value, const std::string &unit) const {
    const double in_units = value / units.factor(unit);
    if (unit == "m")
      return exact_number(std::round(in_units * 1e9) / 1e9);
    double digits = in_units == 0. ? 0. : 9. - std::floor(std::log10(std::abs(in_units)));
    digits = std::min(digits, 300.);
    const double scale = std::pow(10., std::abs(digits));
    return exact_number(digits >= 0. ? std::round(in_units * scale) / scale
                                     : std::round(in_units / scale) * scale);
  }

  std::string temperature(const double celsius) const {
    const double zero = units.celsius(0.), degree = units.celsius(1.) - zero;
    return exact_number(std::round((celsius - zero) / degree * 1e6) / 1e6);
  }

  std::string place(const Point3 &point) const {
    return number(point[0], "m") + " " + number(point[1], "m") + " " + number(point[2], "m");
  }

  void comment(const std::string &words) {
    std::string rest = harmless(words), lead = "# ";
    while (rest.size() > longest_text) {
      std::size_t at = rest.rfind(' ', longest_text);
      if (at == std::string::npos || at == 0)
        at = rest.find(' ', longest_text);
      if (at == std::string::npos)
        break;
      text += lead + rest.substr(0, at) + "\n";
      rest.erase(0, at + 1);
      lead = "#     ";
    }
    text += lead + rest + "\n";
  }

  void list(const std::string &heading, const std::vector<Notes::Note> &notes) {
    if (notes.empty())
      return;
    comment(heading + " (" + std::to_string(notes.size()) + "):");
    for (const Notes::Note &note : notes)
      comment((note.line > 0 ? "  line " + std::to_string(note.line) + ": " : "  ") + note.text);
  }

  void add_head() {
    comment("From the piping component file " + options.file + " by 'frictionbeam import' (" +
            std::to_string(line.n_components) + " components, tolerance " +
            rounded_number(options.tolerance) +
            " mm). Comments are for the reader; all else can be changed by hand.");
    list("Not understood", line.notes.not_understood);
    list("Assumed", line.notes.assumed);
    list("Moved", line.notes.moved);
    if (!line.notes.without_effect.empty()) {
      std::string words;
      for (const auto &[word, count] : line.notes.without_effect)
        words += (words.empty() ? "" : ", ") + word + " x " + std::to_string(count.n);
      comment("Without effect here: " + words);
    }
    if (!units.is_si())
      text += "set Units = " + options.units + "\n";
    if (!plan.title.empty())
      text += "set Title = " + harmless(plan.title) + "\n";
  }

  void add_materials_and_sections() {
    for (const PlannedMaterial &material : plan.materials) {
      if (!material.of.empty())
        comment("Material " + material.of);
      section("Material " + material.name, {{"Grade", material.grade}});
    }
    for (const PlannedSection &one : plan.sections) {
      Entries entries;
      if (one.size.empty()) {
        comment(one.nominal);
        entries = {{"Outer diameter", number(one.outer_diameter, "m")},
                   {"Wall", number(one.wall, "m")}};
      } else
        entries = {{"Size", one.size}, {"Schedule", one.schedule}};
      for (const auto &[entry, value, unit] :
           {std::make_tuple("Corrosion allowance", one.corrosion, "m"),
            std::make_tuple("Contents", one.contents, "kg/m3"),
            std::make_tuple("Insulation", one.insulation, "m"),
            std::make_tuple("Insulation density", one.insulation_density, "kg/m3")})
        if (value > 0.)
          entries.emplace_back(entry, number(value, unit));
      section("Section " + one.name, entries);
    }
  }

  std::string route_of(const PlannedPipe &pipe) {
    std::string route, row;
    for (const PlannedPoint &point : pipe.route) {
      std::string one = point.name.empty() ? place(point.position)
                        : placed.insert(point.name).second
                            ? point.name + " " + place(point.position)
                            : point.name;
      if (point.bend_radius > 0.)
        one += " bend " + number(point.bend_radius, "m");
      if (&point != &pipe.route.back())
        one += ";";
      if (!row.empty() && row.size() + one.size() > longest_text - 14) {
        route += row + " \\\n              ";
        row.clear();
      }
      row += (row.empty() ? "" : " ") + one;
    }
    return route + row;
  }

  void add_pipe(const PlannedPipe &pipe) {
    comment(pipe.comment);
    Entries entries;
    if (plan.sections.size() > 1)
      entries.emplace_back("Section", plan.sections[pipe.section].name);
    if (plan.materials.size() > 1)
      entries.emplace_back("Material", plan.materials[pipe.material].name);
    if (pipe.end_section)
      entries.emplace_back("End section", plan.sections[*pipe.end_section].name);
    if (pipe.rigid)
      entries.emplace_back("Rigid", "true");
    if (pipe.mass)
      entries.emplace_back("Mass", number(*pipe.mass, "kg"));
    entries.emplace_back("Route", route_of(pipe));
    section("Pipe " + pipe.name, entries);
  }

  void add_support(const PlannedSupport &support) {
    comment(support.comment);
    if (!support.support) {
      comment("No row of --support-map fits. To be chosen:");
      section("Support " + support.name, {{"Kind", "rest"}, {"At", support.point}}, "# ");
      return;
    }
    const bool hangs = support.support->kind == "hanger";
    Entries entries{{"At", support.point}};
    if (!hangs)
      entries.insert(entries.begin(), {"Kind", support.support->kind});
    entries.insert(entries.end(), support.support->entries.begin(), support.support->entries.end());
    if (support.stiffness)
      entries.emplace_back("Stiffness", number(*support.stiffness, "N/m"));
    if (support.cold_load)
      entries.emplace_back("Cold load", number(*support.cold_load, "N"));
    section((hangs ? "Hanger " : "Support ") + support.name, entries);
  }

  /// Loads of one kind, one for each value that pipes have. @return their names
  std::string add_loads_of(const std::string &word,
                           std::optional<double> PlannedPipe::*const value) {
    std::map<double, std::string> pipes;
    std::size_t n = 0;
    for (const PlannedPipe &pipe : plan.pipes)
      if (pipe.*value) {
        std::string &names = pipes[*(pipe.*value)];
        names += (names.empty() ? "" : ", ") + pipe.name;
        ++n;
      }
    std::string all;
    unsigned int i = 0;
    for (const auto &[level, names] : pipes) {
      const bool hot = word == "hot";
      const std::string name = word + (pipes.size() > 1 ? "_" + std::to_string(++i) : "");
      Entries entries{
          {"Kind", hot ? "temperature" : "pressure"},
          {hot ? "Temperature" : "Pressure", hot ? temperature(level) : number(level, "Pa")}};
      if (pipes.size() > 1 || n < plan.pipes.size())
        entries.emplace_back("Pipes", names);
      section("Load " + name, entries);
      all += ", " + name;
    }
    return all;
  }

  void add_loads() {
    section("Load weight", {});
    const std::string pressure = add_loads_of("pressure", &PlannedPipe::pressure);
    const std::string hot = add_loads_of("hot", &PlannedPipe::temperature);
    section("Step weight", {{"Loads", "weight" + pressure}});
    if (!hot.empty())
      section("Step hot", {{"Loads", "weight" + pressure + hot}});
  }

  const ImportedLine &line;
  const LinePlan &plan;
  const ImportOptions &options;
  const UnitSystem units;
  std::set<std::string> placed;
  std::string text;
};

} // namespace

std::string prm_text(const ImportedLine &line, const ImportOptions &options) {
  return PrmText(line, options, units_of(options)).write();
}

} // namespace frictionbeam::import
