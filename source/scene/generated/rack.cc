// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/generated.h"

namespace frictionbeam::generated {

namespace {

constexpr Word<bool> rack_kinds[] = {
    {"plant", true, "loops to either side and risers"},
    {"planar", false, "every rest on one line, an algebraic stress case"}};
constexpr Word<bool> rack_sequences[] = {{"one step", true}, {"weight heat cool", false}};

/// A route laid cell by cell, with rest supports on the way.
class Layout {
public:
  Layout() { pipe.route.push_back({"start", Point3()}); }

  /// Go on by @p way in @p n_cells equal cells.
  void lay(const Vector3 &way, const unsigned int n_cells) {
    const Point3 begin = pipe.route.back().position;
    for (unsigned int i = 1; i <= n_cells; ++i)
      pipe.route.push_back({"", begin + static_cast<double>(i) / n_cells * way});
  }

  void rest() {
    pipe.route.back().name = "R" + std::to_string(rests.size());
    rests.push_back(pipe.route.back().name);
  }

  Pipe pipe;
  std::vector<std::string> rests;
};

const Vector3 x({1., 0., 0.}), y({0., 1., 0.}), z({0., 0., 1.});

/// Spans of 6 m; every tenth a loop to alternating sides with a rest on it, every tenth a riser, up
/// and down in turn.
void lay_plant_span(const unsigned int i, Layout &layout) {
  const double turn = (i / 10) % 2 == 0 ? 1. : -1.;
  if (i % 10 == 9) {
    layout.lay(3. * turn * y, 4);
    layout.lay(3. * x, 2);
    layout.rest();
    layout.lay(3. * x, 2);
    layout.lay(-3. * turn * y, 4);
  } else if (i % 10 == 4) {
    layout.lay(3. * x, 2);
    layout.lay(1.5 * turn * z, 2);
    layout.lay(3. * x, 2);
  } else
    layout.lay(6. * x, 4);
}

/// Spans of 6 m along one line; every tenth a loop to one side without a support on it.
void lay_planar_span(const unsigned int i, Layout &layout) {
  if (i % 10 == 9) {
    layout.lay(3. * y, 4);
    layout.lay(6. * x, 4);
    layout.lay(-3. * y, 4);
  } else
    layout.lay(6. * x, 4);
}

} // namespace

void declare_rack(ParameterReader &in) {
  in.declare_choice("Kind", true, rack_kinds, "Scene = rack.");
  in.declare_count("Spans", 20, 3, "Scene = rack. n: the line has n - 1 spans of 6 m.");
  in.declare_count("Guide every", 0, 0,
                   "Scene = rack. Every so manyth support, from the first, also holds y by a "
                   "spring of 1e10 N/m; 0: none.");
  in.declare_number("Friction", 0.3, "-", 0., 100.,
                    "Scene = rack. Friction coefficient of the rests.");
  in.declare_number(
      "Stiffness", 0., "N", 0., 1e300,
      "Scene = rack. Rigidity ES and GS of the friction elements, of length 1 m; 0: rigid.");
  in.declare_choice("Sequence", true, rack_sequences,
                    "Scene = rack. All at once, or weight, heat in 10 increments, cool in 10.");
  in.declare_number("Outer diameter", 0.3239, "m", positive, 1e300, "Scene = rack. Of the pipe.");
  in.declare_number("Wall", 0.0095, "m", positive, 1e300,
                    "Scene = rack. Thickness, at most half the outer diameter.");
  in.declare_number("Young's modulus", 2e11, "Pa", positive, 1e300, "Scene = rack.");
  in.declare_number("Poisson's ratio", 0.3, "-", -1., 0.5,
                    "Scene = rack. The shear area is that of a thin tube, 2 (1 + nu)/(4 + 3 nu) "
                    "of the area.");
  in.declare_number("Density", 7850., "kg/m3", 0., 1e300, "Scene = rack. Of the metal.");
  in.declare_number("Contents", 100., "kg/m", 0., 1e300, "Scene = rack. Mass of the contents.");
  declare_expansion(in);
  in.declare_number("Heating", 100., "K", -1e300, 1e300,
                    "Scene = rack. Rise of the temperature in operation.");
}

void build_rack(const ParameterReader &in, const LawLibrary &laws, Scene &scene) {
  const bool plant = in.choice("Kind", rack_kinds);
  const unsigned int n_spans = in.count("Spans") - 1;
  Layout layout;
  for (unsigned int i = 0; i < n_spans; ++i) {
    (plant ? lay_plant_span : lay_planar_span)(i, layout);
    if (i + 1 < n_spans)
      layout.rest();
  }
  layout.pipe.name = "pipe";
  layout.pipe.route.back().name = "end";

  const double nu = in.number("Poisson's ratio"), diameter = in.number("Outer diameter");
  if (in.number("Wall") > diameter / 2.)
    in.fail("Wall", "at most half the outer diameter, " + to_text(diameter / 2.) + " m",
            "metres, not millimetres");
  scene.materials = {
      {"steel", in.number("Young's modulus"), nu, in.number("Density"), in.number("Expansion")}};
  scene.sections = {pipe_section("pipe", diameter, in.number("Wall"),
                                 2. * (1. + nu) / (4. + 3. * nu), // G. R. Cowper (1966), thin tube
                                 in.number("Contents"))};
  scene.pipes = {layout.pipe};
  scene.restraints = {anchor("anchors", {"start", "end"})};

  const double rigidity = in.number("Stiffness");
  FrictionSupport rests =
      coulomb_support(laws, "rests", in.number("Friction"), rigidity, rigidity, 0.);
  rests.placement.points = layout.rests;
  scene.supports = {rests};
  if (const unsigned int every = in.count("Guide every"); every > 0)
    for (unsigned int i = 0; i < layout.rests.size(); i += every)
      scene.springs.push_back({"guide_" + layout.rests[i], layout.rests[i], "", {0., 1e10}});

  scene.loads = {weight_load(), temperature_load("hot", in.number("Heating"))};
  if (in.choice("Sequence", rack_sequences))
    scene.steps = {static_step("weight_and_heat", {{0, 1.}, {1, 1.}}, 1)};
  else
    scene.steps = {static_step("weight", {{0, 1.}}, 1), static_step("heat", {{0, 1.}, {1, 1.}}, 10),
                   static_step("cool", {{0, 1.}}, 10)};
  scene.quantities = sums_over_supports();
}

} // namespace frictionbeam::generated
