// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/scene_kinds.h"

#include "scene/generated/generated.h"
#include "scene/part/body_parts.h"

namespace frictionbeam {

using namespace generated;

namespace {

/// Without laws to declare.
auto only(void (*const declare)(ParameterReader &)) {
  return [declare](ParameterReader &in, const LawLibrary &) { declare(in); };
}

} // namespace

const std::vector<SceneKind> &scene_kinds() {
  static const std::vector<SceneKind> kinds = {
      {"line", "", "from the parts in this file"},
      {"slab",
       "Slab",
       "pushed along a frictional surface",
       only(&declare_slab),
       &build_slab,
       "Increments",
       {},
       true},
      {"oscillator", "Oscillator", "a mass on a spring with a friction support",
       only(&declare_oscillator), &build_oscillator},
      {"friction bed",
       "Rack",
       "an anchored pipe, heated and cooled",
       only(&declare_friction_bed),
       &build_friction_bed,
       "Increments",
       {{"supports that stand for the bed", "Supports", 5}}},
      {"rack", "Rack", "spans with loops and risers, under weight and heat", only(&declare_rack),
       &build_rack},
      {"random", "Random", "a line by chance, the same for a seed on every machine",
       only(&declare_random), &build_random},
      {"long bar", "Long bar", "a square plate on a foundation, a continuum",
       only(&declare_long_bar), &build_long_bar},
      {"body", "Body", "a continuum on a mesh of your own", &declare_body, &build_body}};
  return kinds;
}

const SceneKind &scene_kind(const std::string &word) { return *find_word(scene_kinds(), word); }

} // namespace frictionbeam
