// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/number_text.h"
#include "scene/law_entries.h"
#include "scene/part/parts.h"
#include "scene/part/pipe_library.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Cowper's shear coefficient of a hollow circle, m = inner over outer radius
/// (G. R. Cowper, J. Appl. Mech. 33 (1966) 335-340).
double cowper(const double nu, const double m) {
  const double a = (1. + m * m) * (1. + m * m);
  return 6. * (1. + nu) * a / ((7. + 6. * nu) * a + (20. + 12. * nu) * m * m);
}

/// Whether lengths are in inches or feet [m]; a foot is twelve inches to rounding only.
bool is_in_inches(const double unit) {
  return std::abs(unit - 0.0254) < 1e-9 || std::abs(unit - 0.3048) < 1e-9;
}

/// Second moment of area of a hollow circle; of a wall so thin that fourth powers cancel, by
/// A (D^2 + d^2)/16.
double inertia_of_pipe(const double D, const double wall) {
  const double d = D - 2. * wall;
  return wall < 1e-6 * D ? pi * (D - wall) * wall * (D * D + d * d) / 16.
                         : pi / 64. * (D * D * D * D - d * d * d * d);
}

} // namespace

double Section::bore_area() const {
  const double r = outer_radius - wall;
  return wall > 0. ? pi * r * r : 0.;
}

double Section::filling() const {
  return contents * bore_area() +
         insulation_density * pi * insulation * (2. * outer_radius + insulation);
}

namespace {

/// By which the area at shear is smaller than that of the metal; 0: no shear flexibility.
double shear_factor(const Section &section) {
  return section.shear_area > 0. ? section.area / section.shear_area : 0.;
}

} // namespace

Section between(const Section &begin, const Section &end, const double part) {
  const auto mix = [&](const double a, const double b) { return a + part * (b - a); };
  Section section = begin;
  section.added_mass = mix(begin.added_mass, end.added_mass);
  section.contents = mix(begin.contents, end.contents);
  section.insulation_density = mix(begin.insulation_density, end.insulation_density);
  section.insulation = mix(begin.insulation, end.insulation);
  section.corrosion = mix(begin.corrosion, end.corrosion);
  section.outer_radius = mix(begin.outer_radius, end.outer_radius);
  section.wall = mix(begin.wall, end.wall);
  if (begin.wall > 0. && end.wall > 0.) {
    section.added_mass += section.filling() - mix(begin.filling(), end.filling());
    const double D = 2. * section.outer_radius, t = section.wall;
    section.area = pi * (D - t) * t;
    section.inertia = inertia_of_pipe(D, t);
    section.torsion_constant = 2. * section.inertia;
  } else {
    section.area = mix(begin.area, end.area);
    section.inertia = mix(begin.inertia, end.inertia);
    section.torsion_constant = mix(begin.torsion_constant, end.torsion_constant);
  }
  const double factor = mix(shear_factor(begin), shear_factor(end));
  section.shear_area = factor > 0. ? section.area / factor : 0.;
  return section;
}

namespace parts {

namespace {
const std::string elastic_law = "elastic_section";
}

void declare_section(ParameterReader &in, const LawLibrary &laws) {
  in.declare_text("Size", "", "NPS or DN and a number, or a name in Size table",
                  "Standard pipe of ASME B36.10M (its table in mm, or in inches where 'Units' has "
                  "in or ft), such as 'NPS 6' or 'DN 150', instead of diameter "
                  "and wall.");
  in.declare_text("Schedule", "40", "5 to 160, STD, XS, XXS, or as in Size table", "Of Size.");
  in.declare_text("Size table", "", "path of a text file, from the parameter file's folder",
                  "Of your own sizes: rows 'size, schedule, outer diameter, wall', names without "
                  "blanks, in the units of this file.");
  in.declare_number("Outer diameter", 0., "m", 0., 1e300,
                    "Of the pipe; 0: the section is given by its figures below.");
  in.declare_number("Wall", 0., "m", 0., 1e300,
                    "Thickness, at most half the outer diameter (a solid bar).");
  in.declare_number("Area", 0., "m2", 0., 1e300, "Of the metal, instead of diameter and wall.");
  in.declare_number("Inertia", 0., "m4", 0., 1e300,
                    "Second moment of area about either axis, instead of diameter and wall.");
  in.declare_number("Torsion constant", 0., "m4", 0., 1e300, "0: twice the inertia.");
  in.declare_text("Shear area", "half", "half, cowper, none, or a number > 0 [m2]",
                  "Area that resists shear. half: half the area, right for a thin pipe; cowper: "
                  "Cowper's figure for a hollow circle with Poisson's ratio 0.3; none: no shear "
                  "flexibility.");
  in.declare_number("Added mass", 0., "kg/m", 0., 1e300,
                    "Contents, insulation and what else moves with the pipe.");
  in.declare_flag("Rotary inertia", true,
                  "Of the metal, in the mass of transient steps, about a "
                  "diameter of the section; twist has its own always.");
  in.declare_number("Contents", 0., "kg/m3", 0., 1e300, "Density of what fills the pipe.");
  in.declare_number("Corrosion allowance", 0., "m", 0., 1e300,
                    "Taken off the inside of the wall in sustained and occasional stresses.");
  in.declare_number("Insulation", 0., "m", 0., 1e300, "Thickness.");
  in.declare_number("Insulation density", 0., "kg/m3", 0., 1e300, "With its cladding.");
  in.declare_text("Law", elastic_law, join(laws.names(LawKind::section)),
                  "Of the section: elastic, or one that yields or creeps (doc/inelastic.md). Its "
                  "parameters are entries of the section; those that diameter, wall, material and "
                  "bend say already may be left out.");
  const LawDescription &law = find_law(in, laws, LawKind::section, elastic_law);
  if (law.name != elastic_law) // which has no entries of its own
    declare_parameters(in, law);
}

namespace {

/// Outer diameter and wall, as given or of a nominal size [m]; zero where neither is.
std::pair<double, double> parse_diameter_and_wall(const ParameterReader &in) {
  if (const std::string size = in.text("Size"); !size.empty()) {
    for (const char *entry : {"Outer diameter", "Wall"})
      if (in.given(entry))
        in.fail(entry, "either a Size or diameter and wall", "removing one of the two");
    const bool own = !in.text("Size table").empty();
    const std::optional<PipeSize> found =
        own ? find_pipe_size(existing_file(in, "Size table"), size, in.text("Schedule"), in.si("m"))
            : find_pipe_size(size, in.text("Schedule"), is_in_inches(in.si("m")));
    if (!found)
      in.fail("Size",
              own ? "a size and schedule in the file of Size table" : known_pipe_sizes(size),
              own ? "a row '" + size + ", " + in.text("Schedule") + ", ...' there" : "'NPS 6'",
              "'" + size + "', schedule " + in.text("Schedule"));
    return {found->outer_diameter, found->wall};
  }
  if (in.given("Schedule") || in.given("Size table"))
    in.fail("Size", "a size beside 'Schedule' or 'Size table'", "'NPS 6'");
  return {in.number("Outer diameter"), in.number("Wall")};
}

/// A hollow circle of outer diameter D and wall t.
void set_pipe(const ParameterReader &in, const double D, const double t, Section &section) {
  if (t == 0.)
    in.fail("Wall", "a number > 0 [m], needed beside 'Outer diameter'",
            "the wall thickness, or Area and Inertia without 'Outer diameter'");
  if (t > D / 2.)
    in.fail("Wall", "at most half the outer diameter, " + to_text(D / 2.) + " m",
            "metres, not millimetres");
  for (const char *entry : {"Area", "Inertia", "Torsion constant"})
    if (in.given(entry))
      in.fail(entry, "either diameter and wall, or the section's figures",
              "removing '" + std::string(entry) + "' or 'Outer diameter'");
  section.outer_radius = D / 2.;
  section.wall = t;
  section.area = pi * (D - t) * t;
  section.inertia = inertia_of_pipe(D, t);
  section.torsion_constant = 2. * section.inertia;
}

/// A section of any other shape, by its figures.
void set_figures(const ParameterReader &in, Section &section) {
  for (const char *entry : {"Area", "Inertia"})
    if (in.number(entry) == 0.)
      in.fail(entry, "a number > 0, needed where 'Outer diameter' is not given",
              "'Outer diameter' and 'Wall', or 'Area' and 'Inertia'");
  if (in.given("Wall"))
    in.fail("Wall", "a wall only beside 'Outer diameter'", "'Outer diameter' as well");
  section.area = in.number("Area");
  section.inertia = in.number("Inertia");
  section.torsion_constant = in.number("Torsion constant");
  if (section.torsion_constant == 0.)
    section.torsion_constant = 2. * section.inertia;
}

void set_shear_area(const ParameterReader &in, const double D, const double t, Section &section) {
  const std::string shear = in.text("Shear area");
  if (shear == "half")
    section.shear_area = section.area / 2.;
  else if (shear == "cowper") {
    if (D == 0.)
      in.fail("Shear area", "cowper beside 'Outer diameter' and 'Wall' only",
              "half, none or a number [m2]");
    section.shear_area = cowper(0.3, 1. - 2. * t / D) * section.area;
  } else if (shear != "none" && !(to_number(shear, section.shear_area) && section.shear_area > 0.))
    in.fail("Shear area", "half, cowper, none, or a number > 0 [m2]", "half");
  else if (shear != "none")
    section.shear_area *= in.si("m2");
}

/// A pipe has one diameter and one wall, whatever its law could be told.
/// @param D, t outer diameter and wall of the section [m]
void check_size_of_law(const ParameterReader &in, const LawDescription &law, const double D,
                       const double t) {
  constexpr double rounding = 1e-6; // of nominal sizes, and of units
  const std::pair<std::string, double> sizes[] = {{"Outside diameter", D}, {"Wall thickness", t}};
  const std::vector<std::string> entries = law_entries(law);
  for (const auto &[entry, size] : sizes)
    if (D > 0. && std::count(entries.begin(), entries.end(), entry) > 0 && in.given(entry) &&
        std::abs(in.number(entry) - size) > rounding * size)
      in.fail(entry,
              "in the law of a section that has a diameter and a wall, the same: " +
                  exact_number(size / in.si("m")),
              "leaving it out: the law takes it from Outer diameter and Wall, or Size",
              in.text(entry));
}

} // namespace

void parse_section(const ParameterReader &in, const LawLibrary &laws, const std::string &name,
                   Scene &scene) {
  Section section;
  section.name = name;
  const auto [D, t] = parse_diameter_and_wall(in);
  if (D > 0.)
    set_pipe(in, D, t, section);
  else
    set_figures(in, section);
  set_shear_area(in, D, t, section);
  section.rotary_inertia = in.flag("Rotary inertia");
  section.insulation = in.number("Insulation");
  section.corrosion = in.number("Corrosion allowance");
  if (section.corrosion > 0. && section.corrosion >= section.wall)
    in.fail("Corrosion allowance", "less than the wall of a pipe given by its diameter and wall",
            "'0'");
  if (D == 0. && (in.given("Contents") || in.given("Insulation")))
    in.fail_section("contents or insulation of a section without diameter",
                    "these beside 'Outer diameter' and 'Wall', or 'Size'", "'Added mass'");
  section.contents = in.number("Contents");
  section.insulation_density = in.number("Insulation density");
  section.added_mass = in.number("Added mass") + section.filling();
  section.law = in.text("Law");
  const LawDescription &law = laws.find(section.law);
  if (section.is_inelastic()) {
    check_size_of_law(in, law, D, t);
    remark_on_units(in, "Section " + name, law, scene.remarks);
  }
  for (int i = 0; section.is_inelastic() && i < law.n_parameters; ++i)
    section.law_parameters.push_back(in.given(law.parameters[i].name)
                                         ? std::optional<double>(in.number(law.parameters[i].name))
                                         : std::nullopt);
  scene.sections.push_back(section);
}

void print_laws(std::ostream &out, const LawLibrary &laws) {
  for (const LawKind kind : {LawKind::section, LawKind::support})
    for (const std::string &name : laws.names(kind)) {
      if (name == Section().law) // which has no entries of its own
        continue;
      const LawDescription &law = laws.find(name);
      out << "\n# Entries of a " << (kind == LawKind::section ? "Section" : "Support")
          << " with Law = " << name << " (" << law.reference << "):\n";
      for (int i = 0; i < law.n_parameters; ++i) {
        const LawParameter &p = law.parameters[i];
        out << "#   " << p.name << " = " << p.default_value << " [" << p.unit << "] " << p.meaning
            << '\n';
      }
    }
}

} // namespace parts

} // namespace frictionbeam
