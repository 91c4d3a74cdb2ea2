// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "units.h"
#include "write_scene.h"

#include <filesystem>
#include <fstream>

namespace oracle {

std::string text(double value);
std::string motions(const std::array<bool, 6> &which);

template <typename List>
std::string joined(const List &list) {
  std::string result;
  for (const auto &item : list)
    result += (result.empty() ? "" : ", ") + item;
  return result;
}

/// Rows of time and value, as an entry for courses in time has them.
std::string table(const std::vector<std::array<double, 2>> &rows);

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
  /// Entry Axes of what has its own, by columns.
  void axes(Entries &out, const Eigen::Matrix3d &Q) const {
    if (Q != Eigen::Matrix3d::Identity())
      set(out, "Axes", vector(Q.col(0), 1.) + "; " + vector(Q.col(1), 1.));
  }
  /// Entry Matrix, of stiffnesses along and about axes.
  void matrix(Entries &out, const Spring &s) const;
  void part(const std::string &heading, const Entries &entries) {
    parts.push_back("\nsubsection " + heading + "\n" + entries.str() + "end\n");
  }

  void material(const Material &m);
  void section(const Section &s);
  void pipe(const Pipe &p);
  void support(const Support &s);
  void joint(const Joint &j);
  void load(const Load &l);
  void snubber(const Support &s, Entries &out) const;
  void rest();
  void response();
  void quantities();
  void settings();

  const Scene &scene;
  const Units units;
  std::map<std::string, std::string> &tables;
  std::vector<std::string> parts, last_parts;
};

} // namespace oracle
