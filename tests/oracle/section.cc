// SPDX-License-Identifier: LGPL-2.1-or-later
#include "frame.h"

#include <algorithm>
#include <cmath>

namespace oracle {

namespace {

/// Outer diameter and wall in mm of the standard pipes that the generator uses (ASME B36.10M).
const std::map<std::pair<std::string, std::string>, std::pair<double, double>> standard_pipes = {
    {{"NPS 2", "40"}, {60.3, 3.91}},   {{"NPS 4", "40"}, {114.3, 6.02}},
    {{"NPS 6", "40"}, {168.3, 7.11}},  {{"NPS 6", "80"}, {168.3, 10.97}},
    {{"NPS 8", "STD"}, {219.1, 8.18}}, {{"DN 250", "40"}, {273.0, 9.27}},
    {{"DN 300", "XS"}, {323.8, 12.7}}};

const std::map<std::string, double> inches = {{"NPS 2", 2.375},  {"NPS 4", 4.5},
                                              {"NPS 6", 6.625},  {"NPS 8", 8.625},
                                              {"DN 250", 10.75}, {"DN 300", 12.75}};

/// Cowper's shear coefficient of a hollow circle for a Poisson's ratio of 0.3, J. Appl. Mech. 33
/// (1966) 335-340; m is the inner over the outer radius.
double cowper(const double m) {
  const double nu = 0.3, a = std::pow(1. + m * m, 2);
  return 6. * (1. + nu) * a / ((7. + 6. * nu) * a + (20. + 12. * nu) * m * m);
}

void tube(const double D, const double t, Figures &f) {
  const double d = D - 2. * t;
  f.area = pi / 4. * (D * D - d * d);
  f.inertia = pi / 64. * (std::pow(D, 4) - std::pow(d, 4));
  f.torsion = 2. * f.inertia;
  f.radius = D / 2.;
  f.wall = t;
}

} // namespace

Figures figures(const Section &section, const bool in_inches) {
  Figures f{section.area, section.inertia, section.torsion, 0., 0., 0., section.added_mass, 0.};
  double D = section.diameter, t = section.wall;
  if (!section.size.empty()) {
    const auto [outer, wall] = standard_pipes.at({section.size, section.schedule});
    D = outer / 1000.;
    t = wall / 1000.;
    if (in_inches) { // the standard's own diameters, walls to thousandths
      D = inches.at(section.size) * 0.0254;
      t = std::round(wall / 25.4 * 1000.) / 1000. * 0.0254;
    }
  }
  if (D > 0.)
    tube(D, t, f);
  else if (f.torsion == 0.)
    f.torsion = 2. * f.inertia;
  using Shear = Section::Shear;
  f.shear = section.shear == Shear::half     ? f.area / 2.
            : section.shear == Shear::none   ? 0.
            : section.shear == Shear::cowper ? f.area * cowper((D - 2. * t) / D)
                                             : section.shear_area;
  f.insulation = section.insulation;
  const double bore = std::max(0., D - 2. * t);
  f.added += section.contents * pi / 4. * bore * bore;
  f.added +=
      section.insulation_density * pi / 4. * (std::pow(D + 2. * section.insulation, 2) - D * D);
  return f;
}

Figures between(const Section &begin, const Section &end, const double part, const bool in_inches) {
  const Figures a = figures(begin, in_inches), b = figures(end, in_inches);
  const auto mix = [&](const double x, const double y) { return (1. - part) * x + part * y; };
  Figures f{};
  f.added = mix(a.added, b.added);
  f.insulation = mix(a.insulation, b.insulation);
  if (a.wall > 0. && b.wall > 0.) {
    tube(2. * mix(a.radius, b.radius), mix(a.wall, b.wall), f);
    // what else there is evenly, what fills the bore and clads the pipe by its room
    const auto clad = [](const double D, const double t) {
      return pi / 4. * (std::pow(D + 2. * t, 2) - D * D);
    };
    const auto bore = [](const double D, const double t) {
      return pi / 4. * std::pow(D - 2. * t, 2);
    };
    const auto rest = [&](const Section &s, const Figures &g) {
      return g.added - s.contents * bore(2. * g.radius, g.wall) -
             s.insulation_density * clad(2. * g.radius, g.insulation);
    };
    f.added =
        mix(rest(begin, a), rest(end, b)) +
        mix(begin.contents, end.contents) * bore(2. * f.radius, f.wall) +
        mix(begin.insulation_density, end.insulation_density) * clad(2. * f.radius, f.insulation);
  } else {
    f.area = mix(a.area, b.area);
    f.inertia = mix(a.inertia, b.inertia);
    f.torsion = mix(a.torsion, b.torsion);
  }
  // Evenly: by how much less stiff to shear the section is than all of its metal.
  const auto loss = [](const Figures &g) { return g.shear > 0. ? g.area / g.shear : 0.; };
  const double lost = mix(loss(a), loss(b));
  f.shear = lost > 0. ? f.area / lost : 0.;
  return f;
}

namespace {

/// A column of a material's table, linear between rows and level beyond its ends.
double look_up(const Material &material, const double temperature, const int column) {
  const auto &rows = material.table;
  if (temperature <= rows.front()[0])
    return rows.front()[column];
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    if (temperature <= rows[i + 1][0]) {
      const double part = (temperature - rows[i][0]) / (rows[i + 1][0] - rows[i][0]);
      return (1. - part) * rows[i][column] + part * rows[i + 1][column];
    }
  return rows.back()[column];
}

} // namespace

double modulus(const Material &material) {
  return material.table.empty() ? material.E : look_up(material, material.modulus_temperature, 1);
}

double thermal_strain(const Material &material, const double from, const double to) {
  if (material.table.empty())
    return material.expansion * (to - from);
  const auto from_20 = [&](const double t) { return look_up(material, t, 2) * (t - 20.); };
  return from_20(to) - from_20(from);
}

double bend_flexibility(const Pipe &pipe, const Figures &section, const Material &material,
                        const double radius) {
  using Flexibility = Pipe::Flexibility;
  if (pipe.flexibility == Flexibility::none)
    return 1.;
  if (pipe.flexibility == Flexibility::given)
    return pipe.flexibility_factor;
  const double t = section.wall, r = section.radius - t / 2., h = t * radius / (r * r);
  if (pipe.flexibility == Flexibility::von_karman)
    return (10. + 12. * h * h) / (1. + 12. * h * h);
  const double pressure = 1. + 6. * pipe.stiffening_pressure / modulus(material) *
                                   std::pow(r / t, 7. / 3.) * std::pow(radius / r, 1. / 3.);
  return std::max(1., 1.65 / h / pressure);
}

Vec across(const Vec &tangent) {
  const bool vertical = std::hypot(tangent[0], tangent[1]) < 1e-6 * tangent.norm();
  return vertical ? Vec(Vec(Vec::UnitX() - tangent[0] * tangent).cross(tangent).normalized())
                  : Vec(Vec::UnitZ().cross(tangent).normalized());
}

} // namespace oracle
