// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/part/parts.h"
#include "scene/unused/unused_row.h"

namespace frictionbeam::unused {

namespace {

/// Of a law's temperatures, those whose factors are not given.
template <char number>
std::string without_factors(const Place &at) {
  const std::string factor = std::string("Modulus factor ") + number;
  return unless(at.number(factor) > 0., "without a " + factor);
}

} // namespace

const Rows &rows_of_parts() {
  static const Rows rows = {
      {"Material",
       {"Allowable cold", "Allowable hot"},
       [](const Place &at) {
         return unless(!at.scene.stress.code.empty(), "without a stress code");
       }},
      {"Material",
       {"Yield stress"},
       [](const Place &at) {
         return unless(
             any(at.scene.sections, [](const Section &one) { return !one.is_inelastic(); }),
             "where all sections yield by their Law");
       }},
      {"Section",
       {"Insulation density"},
       [](const Place &at) { return unless(at.number("Insulation") != 0., "without Insulation"); }},
      {"Section",
       {"Creep exponent"},
       [](const Place &at) {
         return unless(at.number("Creep coefficient") > 0., "without a Creep coefficient");
       }},
      {"Section",
       {"Primary creep exponent", "Primary time exponent", "Primary hardening"},
       [](const Place &at) {
         return unless(at.number("Primary creep coefficient") > 0.,
                       "without a Primary creep coefficient");
       }},
      {"Section",
       {"Creep activation temperature", "Creep reference temperature"},
       [](const Place &at) {
         return unless(parts::has_creep(at.in), "without a coefficient of creep");
       }},
      {"Section",
       {"Creep reference temperature"},
       [](const Place &at) {
         return unless(at.number("Creep activation temperature") != 0.,
                       "without a Creep activation temperature");
       }},
      {"Section",
       {"Corrosion allowance"},
       [](const Place &at) {
         return unless(!at.scene.stress.code.empty() || at.number("Corrosion allowance") == 0.,
                       "without a stress code");
       }},
      {"Section",
       {"Rotary inertia"},
       [](const Place &at) {
         return unless(at.has_motion() || at.has_modes(), "without a transient step or modes");
       }},
      {"Section",
       {"Shear area"},
       [](const Place &at) { return unless(!at.is_wall(), at.with_model()); }},
      {"Section", {"Temperature 1", "Yield factor 1"}, &without_factors<'1'>},
      {"Section", {"Temperature 2", "Yield factor 2"}, &without_factors<'2'>},
      {"Section", {"Temperature 3", "Yield factor 3"}, &without_factors<'3'>},
      {"Section", {"Temperature 4", "Yield factor 4"}, &without_factors<'4'>},
      {"Section",
       {"Bend length", "Place in bend"},
       [](const Place &at) {
         return unless(any(at.scene.pipes, has_bend) || at.number("Bend radius") > 0.,
                       "without a bend");
       }},
      {"Pipe",
       {"Route"},
       [](const Place &at) {
         return unless(at.scene.mesh.file.empty(),
                       "beside Mesh/File, whose curve of its name the pipe is");
       }},
      {"Pipe",
       {"Bend flexibility", "Stiffening pressure"},
       [](const Place &at) {
         const Pipe *const pipe = at.part(at.scene.pipes);
         if (at.is_wall())
           return at.with_model();
         if (pipe == nullptr || has_bend_of_beams(at.scene, *pipe))
           return std::string();
         return std::string(has_bend(*pipe) ? "where all its bends are solids" : "without a bend");
       }},
      {"Support",
       {"Torsional rigidity", "Patch radius"},
       [](const Place &at) { return unless(at.is_on("Torsion"), "without Torsion = true"); }},
      {"Support",
       {"Patch radius"},
       [](const Place &at) {
         return unless(at.raw("Law", "coulomb") != "coulomb" ||
                           at.number("Torsional rigidity") != 0.,
                       "without a Torsional rigidity");
       }},
      {"Support",
       {"Shear rigidity ratio"},
       [](const Place &at) {
         return unless(!at.scene.solver.is_exact() || at.number("Shear rigidity") != 0.,
                       "without a Shear rigidity: the contact is rigid across its normal");
       }},
      {"Support",
       {"Pad"},
       [](const Place &at) {
         return unless(!at.in.given("Friction coefficient"), "beside a Friction coefficient");
       }},
      {"Support",
       {"Rotations", "Shear rigidity"},
       [](const Place &at) {
         return unless(at.raw("Kind") != "rod", "with Kind = rod, which swings with the pipe");
       }},
      {"Support",
       {"Rotations"},
       [](const Place &at) {
         return unless(at.part(at.scene.restraints) == nullptr, "where nothing rubs");
       }},
      {"Support",
       {"Rotations", "Torsion", "Pad"},
       [](const Place &at) {
         const std::string law = at.raw("Law", "coulomb");
         return unless(law != "whip_restraint" && law != "snubber",
                       "with Law = " + law + ", which acts along the normal alone");
       }},
      {"Support",
       {"Locking acceleration", "Drag"},
       [](const Place &at) {
         const bool is_snubber = at.raw("Kind") == "snubber" || at.raw("Law") == "snubber";
         return unless(!is_snubber || at.number("Locking velocity") != 0.,
                       "without a Locking velocity, for it locks in any motion; with a large one "
                       "the acceleration alone locks it");
       }},
      {"Support",
       {"Ground motion time"},
       [](const Place &at) {
         return unless(!at.raw("Ground motion").empty(), "without a Ground motion");
       }},
      {"Support",
       {"Restitution"},
       [](const Place &at) {
         return unless(at.has_motion() || at.number("Restitution") == 0.,
                       "without a transient step");
       }},
      {"Spring",
       {"Damping"},
       [](const Place &at) { return unless(at.has_motion(), "without a transient step"); }},
      {"Hanger",
       {"Weight step", "Hot step"},
       [](const Place &at) {
         return unless(at.number("Cold load") == 0., "beside a Cold load: the hanger is not sized");
       }},
      {"Support",
       {"Locked stiffness"},
       [](const Place &at) {
         return unless(at.has_motion() || at.has_modes(), "without a transient step or modes");
       }},
      {"Support",
       {"Locking velocity", "Locking acceleration", "Dead band", "Drag"},
       [](const Place &at) { return unless(at.has_motion(), "without a transient step"); }},
      {"Tee",
       {"Kind", "Pad", "Crotch radius"},
       [](const Place &at) {
         return unless(!at.scene.stress.code.empty() || at.raw("Flexibility") == "code",
                       "without a stress code");
       }},
      {"Tee",
       {"Pad"},
       [](const Place &at) {
         return unless(at.raw("Kind") == "reinforced", "but with Kind = reinforced");
       }},
      {"Load",
       {"History time"},
       [](const Place &at) { return unless(!at.raw("History").empty(), "without a History"); }},
      {"Body",
       {"Torsional rigidity", "Patch radius"},
       [](const Place &) { return std::string("of a surface, whose nodes do not turn"); }},
      {"Body",
       {"Shear rigidity ratio"},
       [](const Place &at) {
         return unless(at.scene.continuum_settings.dimension != 2,
                       "in the plane, across which nothing slides");
       }},
      {"Body",
       {"Plane", "Thickness"},
       [](const Place &at) {
         return unless(at.scene.continuum_settings.dimension == 2, "in space");
       }},
      {"Body",
       {"Gap"},
       [](const Place &at) {
         return unless(at.number("Pressure") == 0.,
                       "beside a Pressure, which presses from the start");
       }},
  };
  return rows;
}

} // namespace frictionbeam::unused
