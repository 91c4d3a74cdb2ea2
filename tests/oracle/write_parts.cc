// SPDX-License-Identifier: LGPL-2.1-or-later
#include "writer.h"

#include <algorithm>

namespace oracle {

std::string text(const double value) {
  std::ostringstream out;
  out.precision(17);
  out << (value == 0. ? 0. : value);
  return out.str();
}

std::string motions(const std::array<bool, 6> &which) {
  std::vector<std::string> list;
  for (int c = 0; c < 6; ++c)
    if (which[c])
      list.push_back(std::array<const char *, 6>{{"ux", "uy", "uz", "rx", "ry", "rz"}}[c]);
  return joined(list);
}

std::string table(const std::vector<std::array<double, 2>> &rows) {
  std::string result = "table ";
  for (const auto &row : rows)
    result += (&row == &rows.front() ? "" : ", ") + text(row[0]) + " " + text(row[1]);
  return result;
}

namespace {

/// Three tables in time, for "Ground motion".
std::string tables_of(const std::vector<std::array<double, 4>> &rows, const double length) {
  std::string result;
  for (int d = 0; d < 3; ++d) {
    std::vector<std::array<double, 2>> one;
    for (const auto &row : rows)
      one.push_back({row[0], row[1 + d] / length});
    result += (d > 0 ? "; " : "") + table(one);
  }
  return result;
}

} // namespace

void Writer::snubber(const Support &s, Entries &out) const {
  const double l = units.length, f = units.force;
  set(out, "Normal", s.direction.empty() ? vector(s.normal, 1.) : s.direction);
  number(out, "Locked stiffness", s.snubber.stiffness * l / f);
  number(out, "Locking velocity", s.snubber.velocity / l);
  number(out, "Locking acceleration", s.snubber.acceleration / l);
  number(out, "Dead band", s.snubber.dead_band / l);
  number(out, "Drag", s.snubber.drag * l / f);
}

void Writer::matrix(Entries &out, const Spring &s) const {
  Eigen::Matrix<double, 6, 6> K = Eigen::Matrix<double, 6, 6>::Zero();
  for (int first : {0, 3})
    for (int d = 0; d < 3; ++d)
      K.block<3, 3>(first, first) +=
          s.stiffness[first + d] * s.axes.col(d) * s.axes.col(d).transpose();
  std::string rows;
  for (int i = 0; i < 6; ++i) {
    Six row;
    for (int j = 0; j < 6; ++j)
      row[j] = K(std::min(i, j), std::max(i, j)); // the same to the last bit
    const double l = units.length, f = units.force;
    rows += (i > 0 ? "; " : "") + (i < 3 ? six(row, f / l, f) : six(row, f, f * l));
  }
  set(out, "Matrix", rows);
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
  if (s.continuous)
    set(out, "Continuous", "true");
  if (s.kind == "restraint") {
    set(out, "Fixed", motions(s.fixed));
    axes(out, s.axes);
  }
  const bool normal_is_way = !s.ground.empty() && !s.own_normal;
  if (s.kind == "snubber")
    snubber(s, out);
  else if (!s.direction.empty())
    set(out, "Normal", s.direction);
  else if (s.kind == "rod"
               ? s.normal != Vec(0., 0., 1.)
               : !normal_is_way && (s.kind == "stop" || s.kind == "friction" || s.kind == "rest"))
    set(out, "Normal", vector(s.normal, 1.));
  if (!s.law.empty()) {
    set(out, "Law", s.law);
    set(out, "Length", text(s.length / l));
    number(out, "Axial rigidity", s.axial_rigidity / f);
    number(out, "Drag", s.drag / f);
    number(out, "Gap", s.gap / l);
    number(out, "Elastic stiffness", s.whip.stiffness * l / f);
    number(out, "Plastic coefficient", s.whip.coefficient / f); // of a deflection in m
    number(out, "Plastic exponent", s.whip.exponent);
  } else if (!s.holds_exactly() && s.kind != "snubber") {
    if (!normal_is_way) // else it is the distance
      set(out, "Length", text(s.length / l));
    if (s.rotations != Support::Rotations::none || !s.ground.empty())
      set(out, "Rotations",
          s.rotations == Support::Rotations::pipe   ? "pipe"
          : s.rotations == Support::Rotations::none ? "none"
                                                    : "averaged");
    if (s.torsional_rigidity > 0.)
      set(out, "Torsion", "true");
    number(out, "Torsional rigidity", s.torsional_rigidity / (f * l * l));
    number(out, "Patch radius", s.patch_radius / l);
    number(out, "Normal force", s.normal_force / f);
    number(out, "Axial rigidity", s.axial_rigidity / f);
    number(out, "Shear rigidity", s.shear_rigidity / f);
    number(out, "Shear rigidity ratio", s.ratio, 1.);
    set(out, s.pad.empty() ? "Friction coefficient" : "Pad",
        s.pad.empty() ? text(s.friction) : s.pad);
    number(out, "Dynamic friction coefficient", s.dynamic_friction, -1.);
    number(out, "Gap", s.gap / l);
    number(out, "Restitution", s.restitution);
    set(out, "Ground", s.ground);
    if (!s.ground_motion.empty())
      set(out, "Ground motion", tables_of(s.ground_motion, l));
    if (s.ground_run_time)
      set(out, "Ground motion time", "run");
  }
  part("Support " + s.name, out);
}

void Writer::response() {
  const double l = units.length, f = units.force;
  const std::array<std::string, 3> axes = {{"x", "y", "z"}};
  for (const Spectrum &s : scene.spectra) {
    Entries out;
    std::string curve, directions;
    for (const auto &[frequency, acceleration] : s.curve)
      curve += (curve.empty() ? "" : "; ") + text(frequency) + " " + text(acceleration / l);
    for (int d = 0; d < 3; ++d)
      if (s.directions[d] != 0.)
        directions += (directions.empty() ? "" : ", ") + axes[d] + " " + text(s.directions[d]);
    set(out, "Curve", curve);
    set(out, "Directions", directions);
    set(out, "Supports", joined(s.supports));
    part("Spectrum " + s.name, out);
  }
  for (const Combination &c : scene.combinations) {
    Entries out;
    std::string cases;
    for (const auto &[name, factor] : c.cases)
      cases += (cases.empty() ? "" : ", ") + name + " " + text(factor);
    set(out, "Kind", c.kind);
    set(out, "Cases", cases);
    last_parts.push_back("\nsubsection Combination " + c.name + "\n" + out.str() + "end\n");
  }
  for (const Nozzle &n : scene.nozzles) {
    Entries out;
    set(out, "Support", n.support);
    set(out, "Allowed", six(n.allowed, f, f * l));
    part("Nozzle " + n.support + "_nozzle", out);
  }
}

void Writer::quantities() {
  if (!scene.quantities)
    return;
  Entries out;
  for (const std::string &point : scene.monitors)
    for (const std::string &name : cases_of(scene))
      for (const char *motion : {"ux", "uy", "uz", "rx", "ry", "rz"})
        set(out, quantity_name(point, name, motion),
            std::string(motion) + " at " + point + ", step " + name);
  last_parts.push_back("\nsubsection Quantities\n" + out.str() + "end\n");
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
  const auto add = [&](const std::string &entry, const std::string &value) {
    const auto slash = entry.find('/');
    set(sections[entry.substr(0, slash)], entry.substr(slash + 1), value);
  };
  for (const auto &[entry, value] : scene.more)
    add(entry, value);
  for (const Setting &setting : scene.settings)
    add(setting.entry, text(setting.value / std::pow(units.length, setting.length)));
  for (const auto &[heading, entries] : sections)
    if (!entries.str().empty())
      part(heading, entries);
}

} // namespace oracle
