// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/part/parts.h"

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

/// A random line, the same for a seed on every machine (section Random).
void declare_random(ParameterReader &in);
void build_random(const ParameterReader &in, const LawLibrary &laws, Scene &scene);

// Parts that several of them are made of.

/// Entry Expansion, which both kinds of scenes with a section Rack have.
void declare_expansion(ParameterReader &in);

/// A Coulomb friction support without a place yet: friction f, rigidities [N] (0: rigid), normal
/// +z, normal force of a platen [N] (0: none).
FrictionSupport coulomb_support(const LawLibrary &laws, const std::string &name,
                                const double friction, const double axial_rigidity,
                                const double shear_rigidity, const double normal_force);

/// A restraint that holds ux.
Restraint hold_ux(const std::string &name, const std::string &point);

/// A restraint that holds all six motions.
Restraint anchor(const std::string &name, const std::vector<std::string> &points);

/// A pipe of outer diameter and wall [m], shear area over area, added mass [kg/m].
Section pipe_section(const std::string &name, const double outer_diameter, const double wall,
                     const double shear_coefficient, const double added_mass);

/// A quantity of a body, @p x where it is asked at a place [m].
ContinuumQuantity body_quantity(const std::string &name, const ContinuumQuantity::Kind kind,
                                const std::string &where, const double x = 0.);

Load weight_load();                                                ///< 9.81 m/s2 downwards
Load temperature_load(const std::string &name, const double rise); ///< [K]

LoadStep static_step(const std::string &name,
                     const std::vector<std::pair<unsigned int, double>> &loads,
                     const unsigned int n_increments);

/// Sums of forces over all friction supports and numbers of supports by status, at the end.
std::vector<Quantity> sums_over_supports();

} // namespace frictionbeam::generated
