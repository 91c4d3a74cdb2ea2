// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"
#include "scene/part/pipe_library.h"

#include <algorithm>
#include <filesystem>

namespace frictionbeam {

MaterialPoint Material::at(const double temperature) const {
  if (table.empty())
    return {temperature, youngs_modulus, expansion};
  const auto after = std::upper_bound(
      table.begin(), table.end(), temperature,
      [](const double t, const MaterialPoint &point) { return t < point.temperature; });
  if (after == table.begin() || after == table.end())
    return after == table.begin() ? table.front() : table.back();
  const MaterialPoint &low = *(after - 1), &high = *after;
  const double part = (temperature - low.temperature) / (high.temperature - low.temperature);
  return {temperature, low.youngs_modulus + part * (high.youngs_modulus - low.youngs_modulus),
          low.expansion + part * (high.expansion - low.expansion)};
}

double Material::thermal_strain(const double from, const double to) const {
  if (table.empty())
    return expansion * (to - from);
  return at(to).expansion * (to - 20.) - at(from).expansion * (from - 20.);
}

namespace parts {

void declare_material(ParameterReader &in) {
  in.declare_choice("Grade", no_grade, material_grades,
                    "With Young's modulus (ASME BPVC II-D, table TM-1) and mean expansion (table "
                    "TE-1) that depend on temperature; density and Poisson's ratio stay below.");
  in.declare_text("Table", "", "path of a text file, from the parameter file's folder",
                  "Instead of Grade: rows 'temperature, Young's modulus, mean expansion from 20 "
                  "degC', in the units of this file.");
  in.declare_number("Modulus temperature", 20., "degC", -273.15, 1e300,
                    "At which Young's modulus is taken from the grade or table.");
  in.declare_number("Young's modulus", 2e11, "Pa", positive, 1e300, "Of the pipe's metal.");
  in.declare_number("Poisson's ratio", 0.3, "-", -1., 0.5, "Of the pipe's metal.");
  in.declare_number("Density", 7850., "kg/m3", 0., 1e300, "Of the pipe's metal.");
  in.declare_number("Expansion", 1.2e-5, "1/K", -1., 1., "Coefficient of thermal expansion.");
  in.declare_number("Allowable cold", 0., "Pa", 0., 1e300, "Sc of a stress code.");
  in.declare_number("Allowable hot", 0., "Pa", 0., 1e300, "Sh of a stress code.");
  in.declare_number("Yield stress", 0., "Pa", 0., 1e300,
                    "Above which an elastic line is a doubtful model: stresses above it are "
                    "remarked. 0: not said, and nothing is. What yields has a Law in its Section.");
}

std::string existing_file(const ParameterReader &in, const std::string &entry) {
  namespace fs = std::filesystem;
  const fs::path beside = fs::path(in.file().name()).parent_path() / in.text(entry);
  if (fs::exists(beside))
    return beside.string();
  if (!fs::exists(in.text(entry)))
    in.fail(entry, "a file that exists, from the parameter file's folder or the working folder",
            "the path from " + fs::absolute(in.file().name()).parent_path().string());
  return in.text(entry);
}

void parse_material(const ParameterReader &in, const std::string &name, Scene &scene) {
  Material material;
  material.name = name;
  material.youngs_modulus = in.number("Young's modulus");
  material.poissons_ratio = in.number("Poisson's ratio");
  material.density = in.number("Density");
  material.expansion = in.number("Expansion");
  material.allowable_cold = in.number("Allowable cold");
  material.allowable_hot = in.number("Allowable hot");
  material.yield_stress = in.number("Yield stress");
  const bool graded = in.choice("Grade", material_grades) != no_grade,
             tabled = !in.text("Table").empty();
  if (graded && tabled)
    in.fail("Table", "a grade or a table", "removing one of the two");
  if (graded || tabled) {
    for (const char *entry : {"Young's modulus", "Expansion"})
      if (in.given(entry))
        in.fail(entry, "either this entry or a grade or table", "removing one of the two");
    material.table = graded ? *in.choice("Grade", material_grades)
                            : read_material_table(existing_file(in, "Table"), scene.units);
    if (material.table.empty())
      in.fail("Table", "rows 'temperature, Young's modulus, mean expansion', rising in temperature",
              "a text file such as '20, 202e9, 11.5e-6'");
    material.youngs_modulus = material.at(in.number("Modulus temperature")).youngs_modulus;
    material.expansion = material.at(20.).expansion;
  } else if (in.given("Modulus temperature"))
    in.fail("Modulus temperature", "this entry beside 'Grade' or 'Table' only",
            "removing it, or a grade");
  constexpr double least = 1e9, most = 1e12; // Pa, of any metal or plastic that pipes are made of
  if (material.youngs_modulus < least || material.youngs_modulus > most)
    scene.doubts.push_back(
        "Material " + name + ": its Young's modulus is " + to_text(material.youngs_modulus) +
        " Pa, and no pipe's is below 1e9 Pa or above 1e12 Pa. Look at its unit.");
  constexpr double heaviest = 23e3; // kg/m3, osmium
  if (material.density > heaviest)
    scene.doubts.push_back("Material " + name + ": its density is " + to_text(material.density) +
                           " kg/m3, more than any metal's. Look at its unit, and at the mass in "
                           "Units.");
  scene.materials.push_back(material);
}

} // namespace parts

} // namespace frictionbeam
