// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "import/pcf/support_table.h"
#include "scene/scene.h"

namespace frictionbeam::import {

/// A section of the line to be written.
struct PlannedSection {
  std::string name;
  std::string size;           ///< "DN 150", where there is a schedule; empty: by its figures
  std::string schedule;       ///< of size
  std::string nominal;        ///< what the file calls it, for a comment
  double outer_diameter = 0.; ///< [m]
  double wall = 0.;           ///< [m]
  double corrosion = 0., insulation = 0., insulation_density = 0.,
         contents = 0.; ///< [m, m, kg/m3, kg/m3]

  bool is_like(const PlannedSection &other) const;
};

struct PlannedMaterial {
  std::string name, grade, of; ///< of: what the file calls it, for a comment
};

struct PlannedPoint {
  std::string name; ///< may be empty
  Point3 position;
  double bend_radius = 0.;
};

struct PlannedPipe {
  std::string name, comment;
  std::size_t section = 0, material = 0;
  std::optional<std::size_t> end_section;
  std::vector<PlannedPoint> route;
  bool rigid = false;
  std::optional<double> mass; ///< [kg]
  std::optional<double> temperature, pressure;
};

struct PlannedTee {
  std::string name, point, branch, kind;
};

struct PlannedSupport {
  std::string name, point, comment;
  std::optional<MappedSupport> support;       ///< none: no row of the table fits
  std::optional<double> stiffness, cold_load; ///< of a hanger, as the file has them [N/m, N]
};

struct PlannedMass {
  std::string name, point;
  double mass = 0.; ///< [kg]
};

/// What the line of a piping component file becomes, before it is written.
struct LinePlan {
  std::string title;
  std::vector<PlannedSection> sections;
  std::vector<PlannedMaterial> materials;
  std::vector<NamedPoint> points; ///< on bends, beside their middle
  std::vector<PlannedPipe> pipes;
  std::vector<PlannedTee> tees;
  std::vector<PlannedSupport> supports;
  std::vector<PlannedMass> masses;
};

} // namespace frictionbeam::import
