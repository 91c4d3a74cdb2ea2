// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/generated.h"
#include "scene/part/body_parts.h"

namespace frictionbeam::generated {

namespace {

using Kind = ContinuumQuantity::Kind;

struct Point {
  const char *name;
  double part; ///< x over the side
};
constexpr std::array<Point, 5> points = {
    {{"A", 0.}, {"B", 0.03125}, {"C", 0.125}, {"D", 0.1875}, {"E", 0.28125}}};

} // namespace

void declare_long_bar(ParameterReader &in) {
  in.declare_number("Side", 0.04, "m", positive, 1e300, "Of the square plate.");
  in.declare_number("Young's modulus", 1.3e11, "Pa", positive, 1e300, "Of the plate.");
  in.declare_number("Poisson", 0.2, "-", 0., 0.4999, "Ratio of the plate.");
  in.declare_choice("Plane", true, plane_kinds, "Kind of plane problem.");
  in.declare_number("Friction", 1., "-", 0., 100., "Coefficient of the foundation.");
  in.declare_number("Top pressure", 5e7, "Pa", 0., 1e300, "On y = Side.");
  in.declare_number("Side pressure", 1.5e8, "Pa", 0., 1e300, "On x = 0.");
  in.declare_number("Normal stiffness", 0., "Pa/m", 0., 1e300, "Of the foundation; 0: rigid.");
  in.declare_number("Shear stiffness", 0., "Pa/m", 0., 1e300, "Of the foundation; 0: rigid.");
}

void build_long_bar(const ParameterReader &in, const LawLibrary &laws, Scene &scene) {
  const double side = in.number("Side");
  ContinuumScene body;
  body.plane_strain = in.choice("Plane", plane_kinds);
  body.youngs_modulus = in.number("Young's modulus");
  body.poissons_ratio = in.number("Poisson");
  ContinuumBox box;
  box.size = {{side, side, side}};
  box.cells.fill(scene.continuum_settings.cells);
  body.box = box;
  for (const Point &point : points)
    body.points[point.name] = dealii::Point<3>(point.part * side, 0., 0.);
  body.points["corner"] = dealii::Point<3>(side, 0., 0.);
  body.holds.push_back({"x1", {{true, false, false}}});
  // On springs the foundation holds the plate; a point held as well would draw a force of its own,
  // under which displacements grow without bound as the mesh becomes finer.
  if (in.number("Normal stiffness") == 0.)
    body.holds.push_back({"corner", {{false, true, false}}});
  body.tractions.push_back({"y1", {}, in.number("Top pressure")});
  body.tractions.push_back({"x0", {}, in.number("Side pressure")});

  const LawDescription &law = laws.find("coulomb");
  ContinuumContact foundation;
  foundation.part = "y0";
  foundation.law = law.name;
  foundation.parameters = default_parameters(law);
  foundation.parameters[parameter_index(law, "Friction coefficient")] = in.number("Friction");
  foundation.parameters[parameter_index(law, "Axial rigidity")] = in.number("Normal stiffness");
  foundation.parameters[parameter_index(law, "Shear rigidity")] = in.number("Shear stiffness");
  body.contacts.push_back(foundation);
  body.steps = {{"press", 1., scene.continuum_settings.increments}};

  for (const Point &point : points)
    body.quantities.push_back(
        body_quantity(std::string("u_") + point.name, Kind::displacement, point.name));
  body.quantities.push_back(body_quantity("open_length", Kind::open_end, "y0"));
  body.quantities.push_back(body_quantity("slip_end", Kind::slip_end, "y0"));
  body.quantities.push_back(body_quantity("tangential_reaction", Kind::sum_friction, "y0"));
  scene.continuum = body;
}

} // namespace frictionbeam::generated
