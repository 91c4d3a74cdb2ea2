// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "parts.h"

/**
 * @file
 * Scenes that are generated from a few entries, of the same parts as any other. Each has a section
 * of its own in the parameter file, and the references of its quantities follow its entries.
 */
namespace frictionbeam::generated {

/// A slab pushed along a frictional surface by a force at one end (section Slab).
void declare_slab(ParameterReader &in);
void build_slab(const ParameterReader &in, const LawLibrary &laws, Scene &scene);

/// A mass on a spring with a friction support (section Oscillator).
void declare_oscillator(ParameterReader &in);
void build_oscillator(const ParameterReader &in, const LawLibrary &laws, Scene &scene);

/// An anchored pipe on a bed of friction supports, heated and cooled (section Rack).
void declare_friction_bed(ParameterReader &in);
void build_friction_bed(const ParameterReader &in, const LawLibrary &laws, Scene &scene);

/// A rack of n spans with loops, risers and guides, under weight and heat (section Rack).
void declare_rack(ParameterReader &in);
void build_rack(const ParameterReader &in, const LawLibrary &laws, Scene &scene);

/// A Coulomb friction support at given points: friction f, rigidities [N], normal +z.
FrictionSupport coulomb_support(const LawLibrary &laws, const std::string &name,
                                const double friction, const double axial_rigidity,
                                const double shear_rigidity, const double normal_force);

/// A restraint that holds ux.
Restraint hold_ux(const std::string &name, const std::string &point);

} // namespace frictionbeam::generated
