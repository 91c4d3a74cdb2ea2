// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

namespace frictionbeam {

struct PipeSize {
  double outer_diameter, wall; ///< [m]
};

/// Of "NPS 6" or "DN 150" with a schedule of ASME B36.10M: 5 to 160, STD, XS, XXS.
/// @param in_inches its figures in US customary units, which differ by some 1e-4 from those in mm
std::optional<PipeSize> find_pipe_size(const std::string &name, const std::string &schedule,
                                       const bool in_inches);
/// What there is: the schedules of a size, or all sizes.
std::string known_pipe_sizes(const std::string &name);

/// From a user's file, rows "size, schedule, outer diameter, wall", its unit in metres.
std::optional<PipeSize> find_pipe_size(const std::string &file, const std::string &name,
                                       const std::string &schedule, const double unit);

/// What depends on temperature of the grades there are; null: given otherwise.
using MaterialGrade = const std::vector<MaterialPoint> *;
constexpr MaterialGrade no_grade = nullptr;
extern const Word<MaterialGrade> material_grades[3];
/// From a user's file, rows "temperature, Young's modulus, mean expansion from 20 degC", rising in
/// temperature; empty if there is none.
std::vector<MaterialPoint> read_material_table(const std::string &file, const UnitSystem &units);

} // namespace frictionbeam
