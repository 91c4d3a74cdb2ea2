// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/pipe_library.h"

#include "scene/file/parameter_file.h"
#include "scene/file/table_rows.h"

#include <cmath>
#include <sstream>

namespace frictionbeam {

namespace {

struct SizeRow {
  const char *nps;
  int dn;
  double outer_diameter; ///< [mm]
  double inches;         ///< outer diameter
  const char *schedules; ///< schedule and wall [mm], one after the other
};

// ASME B36.10M, welded and seamless wrought steel pipe: NPS, DN, outer diameter in mm and in
// inches, walls in mm. Walls in inches are those in mm, rounded to thousandths.
// clang-format off
const SizeRow size_rows[] = {
    {"1/2", 15, 21.3, 0.84, "5 1.65 10 2.11 40 2.77 80 3.73 160 4.78 STD 2.77 XS 3.73 XXS 7.47"},
    {"3/4", 20, 26.7, 1.05, "5 1.65 10 2.11 40 2.87 80 3.91 160 5.56 STD 2.87 XS 3.91 XXS 7.82"},
    {"1", 25, 33.4, 1.315, "5 1.65 10 2.77 40 3.38 80 4.55 160 6.35 STD 3.38 XS 4.55 XXS 9.09"},
    {"1-1/4", 32, 42.2, 1.66, "5 1.65 10 2.77 40 3.56 80 4.85 160 6.35 STD 3.56 XS 4.85 XXS 9.7"},
    {"1-1/2", 40, 48.3, 1.9, "5 1.65 10 2.77 40 3.68 80 5.08 160 7.14 STD 3.68 XS 5.08 XXS 10.15"},
    {"2", 50, 60.3, 2.375, "5 1.65 10 2.77 40 3.91 80 5.54 160 8.74 STD 3.91 XS 5.54 XXS 11.07"},
    {"2-1/2", 65, 73.0, 2.875, "5 2.11 10 3.05 40 5.16 80 7.01 160 9.53 STD 5.16 XS 7.01 XXS 14.02"},
    {"3", 80, 88.9, 3.5, "5 2.11 10 3.05 40 5.49 80 7.62 160 11.13 STD 5.49 XS 7.62 XXS 15.24"},
    {"3-1/2", 90, 101.6, 4.0, "5 2.11 10 3.05 40 5.74 80 8.08 STD 5.74 XS 8.08"},
    {"4", 100, 114.3, 4.5, "5 2.11 10 3.05 40 6.02 80 8.56 120 11.13 160 13.49 STD 6.02 XS 8.56 XXS 17.12"},
    {"5", 125, 141.3, 5.563, "5 2.77 10 3.4 40 6.55 80 9.53 120 12.7 160 15.88 STD 6.55 XS 9.53 XXS 19.05"},
    {"6", 150, 168.3, 6.625, "5 2.77 10 3.4 40 7.11 80 10.97 120 14.27 160 18.26 STD 7.11 XS 10.97 XXS 21.95"},
    {"8", 200, 219.1, 8.625, "5 2.77 10 3.76 20 6.35 30 7.04 40 8.18 60 10.31 80 12.7 100 15.09 120 18.26 140 20.62 160 23.01 STD 8.18 XS 12.7 XXS 22.23"},
    {"10", 250, 273.0, 10.75, "5 3.4 10 4.19 20 6.35 30 7.8 40 9.27 60 12.7 80 15.09 100 18.26 120 21.44 140 25.4 160 28.58 STD 9.27 XS 12.7 XXS 25.4"},
    {"12", 300, 323.8, 12.75, "5 3.96 10 4.57 20 6.35 30 8.38 40 10.31 60 14.27 80 17.48 100 21.44 120 25.4 140 28.58 160 33.32 STD 9.53 XS 12.7 XXS 25.4"},
    {"14", 350, 355.6, 14.0, "5 3.96 10 6.35 20 7.92 30 9.53 40 11.13 60 15.09 80 19.05 100 23.83 120 27.79 140 31.75 160 35.71 STD 9.53 XS 12.7"},
    {"16", 400, 406.4, 16.0, "5 4.19 10 6.35 20 7.92 30 9.53 40 12.7 60 16.66 80 21.44 100 26.19 120 30.96 140 36.53 160 40.49 STD 9.53 XS 12.7"},
    {"18", 450, 457.0, 18.0, "5 4.19 10 6.35 20 7.92 30 11.13 40 14.27 60 19.05 80 23.83 100 29.36 120 34.93 140 39.67 160 45.24 STD 9.53 XS 12.7"},
    {"20", 500, 508.0, 20.0, "5 4.78 10 6.35 20 9.53 30 12.7 40 15.09 60 20.62 80 26.19 100 32.54 120 38.1 140 44.45 160 50.01 STD 9.53 XS 12.7"},
    {"22", 550, 559.0, 22.0, "5 4.78 10 6.35 20 9.53 30 12.7 60 22.23 80 28.58 100 34.93 120 41.28 140 47.63 160 53.98 STD 9.53 XS 12.7"},
    {"24", 600, 610.0, 24.0, "5 5.54 10 6.35 20 9.53 30 14.27 40 17.48 60 24.61 80 30.96 100 38.89 120 46.02 140 52.37 160 59.54 STD 9.53 XS 12.7"},
    {"26", 650, 660.0, 26.0, "10 7.92 20 12.7 STD 9.53 XS 12.7"},
    {"28", 700, 711.0, 28.0, "10 7.92 20 12.7 30 15.88 STD 9.53 XS 12.7"},
    {"30", 750, 762.0, 30.0, "5 6.35 10 7.92 20 12.7 30 15.88 STD 9.53 XS 12.7"},
    {"32", 800, 813.0, 32.0, "10 7.92 20 12.7 30 15.88 40 17.48 STD 9.53 XS 12.7"},
    {"34", 850, 864.0, 34.0, "10 7.92 20 12.7 30 15.88 40 17.48 STD 9.53 XS 12.7"},
    {"36", 900, 914.0, 36.0, "10 7.92 20 12.7 30 15.88 40 19.05 STD 9.53 XS 12.7"},
};
// clang-format on

// Modulus: ASME BPVC II-D, table TM-1 (carbon steels with C <= 0.30 %, and material group G).
// Mean expansion from 20 degC: table TE-1, coefficient B, groups 1 and 3. 1e9 Pa, 1e-6/K.
const std::vector<MaterialPoint> carbon_steel = {
    {-75., 209e9, 11.0e-6}, {20., 202e9, 11.5e-6},  {100., 198e9, 12.1e-6}, {150., 195e9, 12.4e-6},
    {200., 192e9, 12.7e-6}, {250., 189e9, 13.0e-6}, {300., 185e9, 13.3e-6}, {350., 179e9, 13.6e-6},
    {400., 171e9, 13.8e-6}, {450., 162e9, 14.1e-6}, {500., 151e9, 14.4e-6}, {550., 137e9, 14.6e-6}};
const std::vector<MaterialPoint> austenitic_steel = {
    {20., 195e9, 15.3e-6},  {100., 189e9, 16.2e-6}, {150., 186e9, 16.6e-6}, {200., 183e9, 17.0e-6},
    {250., 179e9, 17.4e-6}, {300., 176e9, 17.7e-6}, {350., 172e9, 17.9e-6}, {400., 169e9, 18.1e-6},
    {450., 165e9, 18.3e-6}, {500., 160e9, 18.4e-6}, {550., 156e9, 18.6e-6}};

} // namespace

std::optional<PipeSize> find_pipe_size(const std::string &name, const std::string &schedule,
                                       const bool in_inches) {
  const std::vector<std::string> words = split(name, ' ');
  if (words.size() != 2 || (words[0] != "NPS" && words[0] != "DN"))
    return {};
  for (const SizeRow &row : size_rows) {
    if (words[1] != (words[0] == "NPS" ? std::string(row.nps) : std::to_string(row.dn)))
      continue;
    const std::vector<std::string> schedules = split(row.schedules, ' ');
    for (unsigned int i = 0; i + 1 < schedules.size(); i += 2)
      if (schedules[i] == schedule) {
        const double wall = std::stod(schedules[i + 1]);
        if (in_inches)
          return PipeSize{0.0254 * row.inches, 0.0254 * std::round(1e3 * wall / 25.4) / 1e3};
        return PipeSize{1e-3 * row.outer_diameter, 1e-3 * wall};
      }
  }
  return {};
}

std::string known_pipe_sizes(const std::string &name) {
  const std::vector<std::string> words = split(name, ' ');
  std::string sizes;
  for (const SizeRow &row : size_rows) {
    if (words.size() == 2 &&
        words[1] == (words[0] == "NPS" ? std::string(row.nps) : std::to_string(row.dn))) {
      std::string schedules;
      const std::vector<std::string> list = split(row.schedules, ' ');
      for (unsigned int i = 0; i < list.size(); i += 2)
        schedules += (schedules.empty() ? "" : ", ") + list[i];
      return name + " with schedule " + schedules;
    }
    sizes += (sizes.empty() ? "" : ", ") + std::string(row.nps);
  }
  return "NPS " + sizes + ", or the same sizes as DN 15 to DN 900";
}

std::optional<PipeSize> find_pipe_size(const std::string &file, const std::string &name,
                                       const std::string &schedule, const double unit) {
  for (const TableRow &line : read_table_rows(file)) {
    const std::vector<std::string> row = fields_of_row(line.text);
    double D, t;
    if (row.size() == 4 && row[0] == name && row[1] == schedule && to_number(row[2], D) &&
        to_number(row[3], t))
      return PipeSize{unit * D, unit * t};
  }
  return {};
}

const Word<MaterialGrade> material_grades[] = {{"given below", no_grade},
                                               {"carbon steel", &carbon_steel},
                                               {"austenitic steel", &austenitic_steel}};

std::vector<MaterialPoint> read_material_table(const std::string &file, const UnitSystem &units) {
  std::vector<MaterialPoint> table;
  for (const TableRow &line : read_table_rows(file)) {
    const std::vector<std::string> row = fields_of_row(line.text);
    MaterialPoint point;
    if (row.size() != 3 || !to_number(row[0], point.temperature) ||
        !to_number(row[1], point.youngs_modulus) || !to_number(row[2], point.expansion) ||
        point.youngs_modulus <= 0.) {
      if (double number = 0.; table.empty() && !(!row.empty() && to_number(row[0], number)))
        continue; // a heading
      return {};
    }
    point.temperature = units.celsius(point.temperature);
    point.youngs_modulus *= units.factor("Pa");
    point.expansion /= units.factor("K");
    if (!table.empty() && point.temperature <= table.back().temperature)
      return {};
    table.push_back(point);
  }
  return table;
}

} // namespace frictionbeam
