// SPDX-License-Identifier: LGPL-2.1-or-later
#include "writer.h"

namespace oracle {

void Writer::material(const Material &m) {
  Entries out;
  if (!m.grade.empty()) {
    set(out, "Grade", m.grade);
    set(out, "Modulus temperature", text(units.temperature(m.modulus_temperature)));
  } else if (m.table.empty()) {
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
  number(out, "Allowable cold", m.allowable_cold / units.stress);
  number(out, "Allowable hot", m.allowable_hot / units.stress);
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
  number(out, "Corrosion allowance", s.corrosion / l);
  number(out, "Insulation", s.insulation / l);
  number(out, "Insulation density", s.insulation_density / m * std::pow(l, 3));
  if (!s.rotary_inertia)
    set(out, "Rotary inertia", "false");
  set(out, "Law", s.law);
  using Unit = LawValue::Unit;
  for (const LawValue &of : s.law_values)
    set(out, of.name,
        text(of.unit == Unit::pascal   ? of.value / units.stress
             : of.unit == Unit::degree ? units.temperature(of.value)
                                       : of.value));
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
    axes(out, load.axes);
  }
  if (!load.history.empty())
    set(out, "History", table(load.history));
  if (load.run_time)
    set(out, "History time", "run");
  if (load.follow)
    set(out, "Follow", "true");
  part("Load " + load.name, out);
}

void Writer::rest() {
  const double l = units.length, f = units.force;
  for (const Spring &s : scene.springs) {
    Entries out;
    set(out, "At", s.at);
    set(out, "To", s.to);
    if (s.as_matrix)
      matrix(out, s);
    else {
      set(out, "Stiffness", six(s.stiffness, f / l, f * l));
      axes(out, s.axes);
    }
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
    set(out, "Kind", t.kind);
    number(out, "Pad", t.pad / l);
    number(out, "Crotch radius", t.crotch_radius / l);
    part("Tee " + t.name, out);
  }
  for (const Hanger &h : scene.hangers) {
    Entries out;
    set(out, "Kind", h.constant ? "constant" : "variable");
    set(out, "At", h.at);
    number(out, "Stiffness", h.stiffness * l / f);
    number(out, "Cold load", h.cold_load / f);
    number(out, "Variation", h.variation, 0.25);
    set(out, "Weight step", h.weight_step);
    set(out, "Hot step", h.hot_step);
    if (h.direction != Vec(0., 0., 1.))
      set(out, "Direction", vector(h.direction, 1.));
    part("Hanger " + h.name, out);
  }
  for (const Initial &i : scene.initial) {
    Entries out;
    set(out, "At", joined(i.at));
    if (i.displacement != Six{})
      set(out, "Displacement", six(i.displacement, l, 1.));
    if (i.velocity != Six{})
      set(out, "Velocity", six(i.velocity, l, 1.));
    set(out, "Pipes", joined(i.pipes));
    set(out, "About", i.about);
    part("Initial " + (i.at.empty() ? i.pipes : i.at).front() + "_start", out);
  }
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
  response();
  quantities();
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
    if (!step.from.empty())
      set(out, "From", step.from);
    if (step.transient)
      set(out, "Analysis", "transient");
    else
      set(out, "Increments", std::to_string(step.increments));
    if (step.duration != 1. || scene.has_laws()) // creep asks for one that is given
      set(out, "Duration", text(step.duration));
    number(out, "Ramp", step.ramp);
    part("Step " + step.name, out);
  }
  parts.insert(parts.end(), last_parts.begin(), last_parts.end());
  std::string result = "set Units = " + scene.units + "\n";
  if (scene.large_displacements)
    result += "set Kinematics = corotational\n";
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

std::vector<std::string> cases_of(const Scene &scene) {
  std::vector<std::string> names;
  for (const Step &step : scene.steps)
    names.push_back(step.name);
  if (!scene.spectra.empty())
    names.push_back("spectrum");
  for (const Combination &combination : scene.combinations)
    names.push_back(combination.name);
  return names;
}

std::string quantity_name(const std::string &point, const std::string &name,
                          const std::string &motion) {
  return point + "_in_" + name + "_" + motion;
}

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
