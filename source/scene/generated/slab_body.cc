// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/generated.h"
#include "scene/part/body_parts.h"

#include <algorithm>
#include <cmath>

namespace frictionbeam::generated {

using Kind = ContinuumQuantity::Kind;

void build_slab_continuum(const ParameterReader &in, const LawLibrary &laws, Scene &scene) {
  const double length = in.number("Length"), width = in.number("Width"),
               height = in.number("Height");
  const ContinuumSettings &settings = scene.continuum_settings;
  ContinuumScene body;
  body.dimension = settings.dimension;
  body.plane_strain = in.choice("Plane", plane_kinds);
  body.thickness = width;
  body.youngs_modulus = in.number("Young's modulus");
  body.poissons_ratio = in.number("Poisson");
  ContinuumBox box;
  box.size = {{length, height, width}};
  const double cell = height / settings.cells;
  box.cells = {{std::max(1u, static_cast<unsigned int>(std::lround(length / cell))), settings.cells,
                std::max(1u, static_cast<unsigned int>(std::lround(width / cell)))}};
  body.box = box;
  body.holds.push_back({"y0", {{false, true, false}}});
  if (in.text("Far end") == "fixed")
    body.holds.push_back({"x1", {{true, false, false}}});
  dealii::Tensor<1, 3> push;
  push[0] = in.number("Force") / (width * height);
  body.tractions.push_back({"x0", push, 0.});

  // The line's friction elements stand every cell length, and share out their stiffness.
  const LawDescription &law = laws.find("coulomb");
  ContinuumContact surface;
  surface.part = "y1";
  surface.law = law.name;
  surface.parameters = default_parameters(law);
  surface.parameters[parameter_index(law, "Friction coefficient")] = in.number("Friction");
  const double rigidity =
      in.number("GS") * in.count("Elements") / (in.number("Length") * in.number("Width"));
  surface.parameters[parameter_index(law, "Axial rigidity")] = rigidity;
  surface.parameters[parameter_index(law, "Shear rigidity")] = rigidity;
  surface.pressure = in.number("Pressure");
  body.contacts.push_back(surface);

  body.steps = {{"push", 1., settings.increments}};
  if (in.text("Sequence") == "cycle") {
    body.steps.push_back({"pull", -1., settings.increments});
    body.steps.push_back({"push_again", 1., settings.increments});
  }
  body.quantities.push_back(body_quantity("slip_length", Kind::slip_length, "y1"));
  for (const int x : {2, 4, 6})
    if (x < length)
      body.quantities.push_back(
          body_quantity("N_" + std::to_string(x), Kind::axial_force, "y1", static_cast<double>(x)));
  body.quantities.push_back(body_quantity("u_0_mean", Kind::mean_displacement, "x0"));
  scene.continuum = body;
}

} // namespace frictionbeam::generated
