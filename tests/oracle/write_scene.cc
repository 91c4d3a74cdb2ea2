// SPDX-License-Identifier: LGPL-2.1-or-later
#include "write_scene.h"
#include "units.h"

#include <filesystem>
#include <fstream>
#include <functional>

namespace oracle {

namespace {

std::string text(const double value) {
  std::ostringstream out;
  out.precision(17);
  out << (value == 0. ? 0. : value);
  return out.str();
}

template <typename List>
std::string joined(const List &list) {
  std::string result;
  for (const auto &item : list)
    result += (result.empty() ? "" : ", ") + item;
  return result;
}

std::string motions(const std::array<bool, 6> &which) {
  std::vector<std::string> list;
  for (int c = 0; c < 6; ++c)
    if (which[c])
      list.push_back(std::array<const char *, 6>{{"ux", "uy", "uz", "rx", "ry", "rz"}}[c]);
  return joined(list);
}

/// Writes the parts of one scene; entries that have their default are left out.
class Writer {
public:
  Writer(const Scene &scene, std::map<std::string, std::string> &tables)
      : scene(scene), units(scene.units), tables(tables) {}

  std::string all();

private:
  using Entries = std::ostringstream;
  static void set(Entries &out, const std::string &name, const std::string &value) {
    if (!value.empty())
      out << "  set " << name << " = " << value << '\n';
  }
  static void number(Entries &out, const std::string &name, const double value,
                     const double unset = 0.) {
    if (value != unset)
      set(out, name, text(value));
  }
  std::string vector(const Vec &v, const double unit) const {
    return text(v[0] / unit) + " " + text(v[1] / unit) + " " + text(v[2] / unit);
  }
  std::string six(const Six &values, const double unit, const double turning_unit) const {
    std::string result;
    for (int c = 0; c < 6; ++c)
      result += (c > 0 ? " " : "") + text(values[c] / (c < 3 ? unit : turning_unit));
    return result;
  }
  void part(const std::string &heading, const Entries &entries) {
    parts.push_back("\nsubsection " + heading + "\n" + entries.str() + "end\n");
  }

  void material(const Material &m);
  void section(const Section &s);
  void pipe(const Pipe &p);
  void support(const Support &s);
  void joint(const Joint &j);
  void load(const Load &l);
  void rest();
  void settings();

  const Scene &scene;
  const Units units;
  std::map<std::string, std::string> &tables;
  std::vector<std::string> parts;
};

void Writer::material(const Material &m) {
  Entries out;
  if (m.table.empty()) {
    set(out, "Young's modulus", text(m.E / units.stress));
    set(out, "Expansion", text(units.per_degree(m.expansion)));
  } else {
    set(out, "Table", m.name + ".txt");
    set(out, "Modulus temperature", text(units.temperature(m.modulus_temperature)));
    for (const auto &row : m.table)
      tables[m.name + ".txt"] += text(units.temperature(row[0])) + ", " +
                                 text(row[1] / units.stress) + ", " +
                                 text(units.per_degree(row[2])) + "\n";
  }
  set(out, "Poisson's ratio", text(m.nu));
  set(out, "Density", text(m.density * std::pow(units.length, 3) / units.mass));
  part("Material " + m.name, out);
}

void Writer::section(const Section &s) {
  Entries out;
  const double l = units.length, m = units.mass;
  set(out, "Size", s.size);
  set(out, "Schedule", s.schedule);
  number(out, "Outer diameter", s.diameter / l);
  number(out, "Wall", s.wall / l);
  number(out, "Area", s.area / (l * l));
  number(out, "Inertia", s.inertia / std::pow(l, 4));
  number(out, "Torsion constant", s.torsion / std::pow(l, 4));
  using Shear = Section::Shear;
  set(out, "Shear area",
      s.shear == Shear::half     ? "half"
      : s.shear == Shear::cowper ? "cowper"
      : s.shear == Shear::none   ? "none"
                                 : text(s.shear_area / (l * l)));
  number(out, "Added mass", s.added_mass / m * l);
  number(out, "Contents", s.contents / m * std::pow(l, 3));
  number(out, "Insulation", s.insulation / l);
  number(out, "Insulation density", s.insulation_density / m * std::pow(l, 3));
  if (!s.rotary_inertia)
    set(out, "Rotary inertia", "false");
  part("Section " + s.name, out);
}

void Writer::pipe(const Pipe &p) {
  Entries out;
  const double l = units.length;
  set(out, "Section", scene.sections[p.section].name);
  set(out, "Material", scene.materials[p.material].name);
  std::string route;
  for (std::size_t i = 0; i < p.route.size(); ++i) {
    const Corner &corner = p.route[i];
    route += (i > 0 ? "; " : "") + corner.name;
    if (!corner.by_name)
      route += corner.relative ? " by " + vector(corner.position - p.route[i - 1].position, l)
                               : " " + vector(corner.position, l);
    if (corner.bend > 0.)
      route += " bend " + text(corner.bend / l);
  }
  set(out, "Route", route);
  using Flexibility = Pipe::Flexibility;
  if (p.flexibility != Flexibility::code)
    set(out, "Bend flexibility",
        p.flexibility == Flexibility::von_karman ? "von Karman"
        : p.flexibility == Flexibility::none     ? "none"
                                                 : text(p.flexibility_factor));
  number(out, "Stiffening pressure", p.stiffening_pressure / units.stress);
  if (p.end_section >= 0)
    set(out, "End section", scene.sections[p.end_section].name);
  if (p.rigid)
    set(out, "Rigid", "true");
  if (p.mass >= 0.)
    set(out, "Mass", text(p.mass / units.mass));
  part("Pipe " + p.name, out);
}

void Writer::support(const Support &s) {
  Entries out;
  const double l = units.length, f = units.force;
  set(out, "Kind", s.kind);
  set(out, "At", joined(s.at));
  set(out, "Pipe", s.pipe);
  number(out, "Every", s.every / l);
  set(out, "From", s.from);
  set(out, "To", s.to);
  if (s.kind == "restraint")
    set(out, "Fixed", motions(s.fixed));
  if (!s.direction.empty())
    set(out, "Normal", s.direction);
  else if (s.ground.empty() && (s.kind == "stop" || s.kind == "friction" || s.kind == "rest"))
    set(out, "Normal", vector(s.normal, 1.));
  if (!s.holds_exactly()) {
    if (s.ground.empty()) // else it is the distance
      set(out, "Length", text(s.length / l));
    if (s.rotations != Support::Rotations::none)
      set(out, "Rotations", s.rotations == Support::Rotations::pipe ? "pipe" : "averaged");
    number(out, "Normal force", s.normal_force / f);
    number(out, "Axial rigidity", s.axial_rigidity / f);
    number(out, "Shear rigidity", s.shear_rigidity / f);
    number(out, "Shear rigidity ratio", s.ratio, 1.);
    set(out, "Friction coefficient", text(s.friction));
    number(out, "Dynamic friction coefficient", s.dynamic_friction, -1.);
    number(out, "Gap", s.gap / l);
    set(out, "Ground", s.ground);
  }
  part("Support " + s.name, out);
}

void Writer::joint(const Joint &j) {
  Entries out;
  const double l = units.length, f = units.force;
  set(out, "At", j.at);
  set(out, "Pipe", j.pipe);
  number(out, "Axial", j.axial * l / f);
  number(out, "Lateral", j.lateral * l / f);
  number(out, "Bending", j.bending / (l * f));
  number(out, "Torsion", j.torsion / (l * f));
  number(out, "Thrust area", j.thrust_area / (l * l));
  part("Joint " + j.name, out);
}

void Writer::load(const Load &load) {
  Entries out;
  const double l = units.length, f = units.force;
  set(out, "Kind", load.kind);
  set(out, "Pipes", joined(load.pipes));
  if (load.kind == "weight" || load.kind == "ground acceleration")
    set(out, "Acceleration", vector(load.vector, l));
  else if (load.kind == "line force")
    set(out, "Force per length", vector(load.vector, f / l));
  else if (load.kind == "wind") {
    set(out, "Wind", vector(load.vector, units.stress));
    set(out, "Shape factor", text(load.value));
  } else if (load.kind == "temperature")
    set(out, "Temperature", text(units.temperature(load.value)));
  else if (load.kind == "pressure")
    set(out, "Pressure", text(load.value / units.stress));
  else if (load.kind == "force") {
    std::string forces;
    for (const auto &[point, force] : load.at)
      forces += (forces.empty() ? "" : "; ") + point + " " + six(force, f, f * l);
    set(out, "Forces", forces);
  } else {
    std::string list;
    for (std::size_t i = 0; i < load.at.size(); ++i) {
      list += (i > 0 ? "; " : "") + load.at[i].first;
      for (int c = 0; c < 6; ++c)
        if (load.given[i][c])
          list += std::string(" ") +
                  std::array<const char *, 6>{{"ux", "uy", "uz", "rx", "ry", "rz"}}[c] + " " +
                  text(load.at[i].second[c] / (c < 3 ? l : 1.));
    }
    set(out, "Displacements", list);
  }
  part("Load " + load.name, out);
}

void Writer::rest() {
  const double l = units.length, f = units.force;
  for (const Spring &s : scene.springs) {
    Entries out;
    set(out, "At", s.at);
    set(out, "To", s.to);
    set(out, "Stiffness", six(s.stiffness, f / l, f * l));
    if (s.damping != Six{})
      set(out, "Damping", six(s.damping, f / l, f * l));
    part("Spring " + s.name, out);
  }
  for (const Mass &m : scene.masses) {
    Entries out;
    set(out, "At", joined(m.at));
    set(out, "Mass", text(m.mass / units.mass));
    part("Mass " + m.name, out);
  }
  for (const Joint &j : scene.joints)
    joint(j);
  for (const Tee &t : scene.tees) {
    Entries out;
    set(out, "At", t.at);
    set(out, "Branch", t.branch);
    if (t.code)
      set(out, "Flexibility", "code");
    else if (t.in_plane > 0.)
      set(out, "Flexibility", text(t.in_plane / (f * l)) + " " + text(t.out_of_plane / (f * l)));
    part("Tee " + t.name, out);
  }
  for (const Hanger &h : scene.hangers) {
    Entries out;
    set(out, "Kind", h.constant ? "constant" : "variable");
    set(out, "At", h.at);
    number(out, "Stiffness", h.stiffness * l / f);
    number(out, "Cold load", h.cold_load / f);
    part("Hanger " + h.name, out);
  }
  for (const Initial &i : scene.initial) {
    Entries out;
    set(out, "At", joined(i.at));
    if (i.displacement != Six{})
      set(out, "Displacement", six(i.displacement, l, 1.));
    if (i.velocity != Six{})
      set(out, "Velocity", six(i.velocity, l, 1.));
    part("Initial " + i.at.front(), out);
  }
}

void Writer::settings() {
  std::map<std::string, Entries> sections;
  if (!scene.arcs)
    set(sections["Mesh"], "Cells per bend", std::to_string(scene.cells_per_bend));
  number(sections["Mesh"], "Cell length", scene.cell_length / units.length);
  set(sections["Output"], "Stations", std::to_string(scene.stations));
  set(sections["Output"], "VTU", "false");
  set(sections["Output"], "Report", "false");
  if (scene.modes > 0) {
    set(sections["Modes"], "Number", std::to_string(scene.modes));
    set(sections["Modes"], "Mass", scene.lumped ? "lumped" : "consistent");
  }
  for (const auto &[entry, value] : scene.more) {
    const auto slash = entry.find('/');
    set(sections[entry.substr(0, slash)], entry.substr(slash + 1), value);
  }
  for (const auto &[heading, entries] : sections)
    if (!entries.str().empty())
      part(heading, entries);
}

std::string Writer::all() {
  for (const Material &m : scene.materials)
    material(m);
  for (const Section &s : scene.sections)
    section(s);
  for (const Point &p : scene.points) {
    Entries out;
    set(out, "Position", vector(p.position, units.length));
    part("Point " + p.name, out);
  }
  for (const Support &s : scene.supports)
    support(s);
  rest();
  settings();
  if (scene.sections_reversed) // parts may stand in any order but pipes, loads and steps
    parts = {parts.rbegin(), parts.rend()};
  for (const Pipe &p : scene.pipes)
    pipe(p);
  for (const Load &l : scene.loads)
    load(l);
  for (const Step &step : scene.steps) {
    Entries out;
    std::string loads;
    for (const auto &[which, factor] : step.loads)
      loads += (loads.empty() ? "" : ", ") + scene.loads[which].name + " " + text(factor);
    set(out, "Loads", loads);
    if (step.transient)
      set(out, "Analysis", "transient");
    else
      set(out, "Increments", std::to_string(step.increments));
    number(out, "Duration", step.duration, 1.);
    number(out, "Ramp", step.ramp);
    part("Step " + step.name, out);
  }
  std::string result = "set Units = " + scene.units + "\n";
  if (scene.installation_temperature != 20.)
    result += "set Installation temperature = " +
              text(units.temperature(scene.installation_temperature)) + "\n";
  if (!scene.monitors.empty())
    result += "set Monitors = " + joined(scene.monitors) + "\n";
  if (motions(scene.free_motions) != "ux, uy, uz, rx, ry, rz")
    result += "set Free motions = " + motions(scene.free_motions) + "\n";
  for (const std::string &part : parts)
    result += part;
  return result;
}

} // namespace

std::string parameter_file(const Scene &scene, std::map<std::string, std::string> &tables) {
  return Writer(scene, tables).all();
}

void write_scene(const Scene &scene, const std::string &file, const std::string &comment) {
  std::map<std::string, std::string> tables;
  std::ofstream out(file);
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);)
    out << "# " << line << '\n';
  out << parameter_file(scene, tables);
  for (const auto &[name, rows] : tables)
    std::ofstream(std::filesystem::path(file).parent_path() / name) << rows;
}

} // namespace oracle
