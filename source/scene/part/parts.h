// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/file/parameter_reader.h"
#include "scene/scene.h"
#include <frictionbeam/law_library.h>

#include <cmath>

/**
 * @file
 * The parts of a parameter file, each with the entries it declares and the data it becomes. All
 * functions work on the reader's current section; parse_... throws UserError.
 */
namespace frictionbeam::parts {

void declare_material(ParameterReader &in);
void parse_material(const ParameterReader &in, const std::string &name, Scene &scene);
/// The section's own law brings its parameters along as entries.
void declare_section(ParameterReader &in, const LawLibrary &laws);
void parse_section(const ParameterReader &in, const LawLibrary &laws, const std::string &name,
                   Scene &scene);
/// Whether the section that the reader is in has a coefficient of creep.
bool has_creep(const ParameterReader &in);
void declare_point(ParameterReader &in);
void parse_point(const ParameterReader &in, const std::string &name, Scene &scene);
void declare_pipe(ParameterReader &in);
void parse_pipe(const ParameterReader &in, const std::string &name, Scene &scene);

/// Where supports stand: at points, or again and again along a pipe.
void declare_placement(ParameterReader &in);
Placement parse_placement(const ParameterReader &in, Scene &scene);
/// The support's own law brings its parameters along as entries.
void declare_support(ParameterReader &in, const LawLibrary &laws);
/// The parameters of every support law, as comments of a parameter file.
void print_laws(std::ostream &out, const LawLibrary &laws);
void parse_support(const ParameterReader &in, const LawLibrary &laws, const std::string &name,
                   Scene &scene);
/// 'Support rests' and 3 of 'Support rests.3'; no heading if it does not end in a number.
std::pair<std::string, unsigned int> repeated_support(const std::string &heading);
/// Whether a section 'Support rests.3' gives the third place of support 'rests' numbers of its own.
bool is_support_place(const ParameterFile &file, const ParameterFile::Section &section);
/// All such sections, after the supports.
void parse_support_places(ParameterReader &in, const LawLibrary &laws, Scene &scene);
/// Entry 'Axes', of what has its own.
void declare_axes(ParameterReader &in, const std::string &of);
/// The global ones where it is empty.
Axes parse_axes(const ParameterReader &in);
/// A vector of length 1. @throws UserError if it is zero
Vector3 parse_unit_vector(const ParameterReader &in, const std::string &entry);
void declare_spring(ParameterReader &in);
void parse_spring(const ParameterReader &in, const std::string &name, Scene &scene);
void declare_mass(ParameterReader &in);
void parse_mass(const ParameterReader &in, const std::string &name, Scene &scene);

void declare_load(ParameterReader &in);
void parse_load(const ParameterReader &in, const std::string &name,
                const double installation_temperature, Scene &scene);
void declare_step(ParameterReader &in);
void parse_step(const ParameterReader &in, const std::string &name, Scene &scene);
void declare_initial(ParameterReader &in);
void parse_initial(const ParameterReader &in, Scene &scene);

void declare_mesh(ParameterReader &in);
void parse_mesh(const ParameterReader &in, Scene &scene);
void declare_solver(ParameterReader &in);
void parse_solver(const ParameterReader &in, Scene &scene);
void declare_time(ParameterReader &in);
void parse_time(const ParameterReader &in, Scene &scene);
/// Entries of section Time about its reduction to modes.
void declare_reduction(ParameterReader &in);
void parse_reduction(const ParameterReader &in, Scene &scene);
void declare_exact(ParameterReader &in);
void parse_exact(const ParameterReader &in, Scene &scene);
void declare_checks(ParameterReader &in);
void parse_checks(const ParameterReader &in, Scene &scene);
void declare_output(ParameterReader &in);
void parse_output(const ParameterReader &in, Scene &scene);

void declare_joint(ParameterReader &in);
void parse_joint(const ParameterReader &in, const std::string &name, Scene &scene);
void declare_tee(ParameterReader &in);
void parse_tee(const ParameterReader &in, const std::string &name, Scene &scene);
void declare_hanger(ParameterReader &in);
void parse_hanger(const ParameterReader &in, const std::string &name, Scene &scene);
/// What of the hangers depends on steps.
void check_hangers(const ParameterReader &in, Scene &scene);
/// The load of their preloads, after all others.
void add_preload(Scene &scene);
void declare_nozzle(ParameterReader &in);
void parse_nozzle(const ParameterReader &in, const std::string &name, Scene &scene);
void declare_stress(ParameterReader &in);
/// After the steps and combinations.
void parse_stress(const ParameterReader &in, Scene &scene);

void declare_modes(ParameterReader &in);
void parse_modes(const ParameterReader &in, Scene &scene);
/// What of the modes depends on steps and spectra, in section Modes.
void check_modes(const ParameterReader &in, Scene &scene);
void declare_spectrum(ParameterReader &in);
void parse_spectrum(const ParameterReader &in, const std::string &name, Scene &scene);
void declare_response(ParameterReader &in);
void parse_response(const ParameterReader &in, Scene &scene);
/// What of it depends on the spectra, in section Response.
void check_response(const ParameterReader &in, Scene &scene);
void declare_combination(ParameterReader &in);
void parse_combination(const ParameterReader &in, const std::string &name, Scene &scene);
/// Names of steps, of the spectra's result and of combinations.
std::vector<std::string> case_names(const Scene &scene);

/// Entries outside of any section.
void declare_global(ParameterReader &in);
/// Title, free motions; the monitors, which need the points, come by parse_monitors().
void parse_global(const ParameterReader &in, Scene &scene);
void parse_monitors(const ParameterReader &in, Scene &scene);

/// What does not go with Kinematics = corotational.
void check_kinematics(const ParameterReader &in, const Scene &scene);
/// What sections that yield or creep do not go with.
void check_inelastic(ParameterReader &in, Scene &scene);
/// Steps and cases that the report shall show.
void check_output(ParameterReader &in, const Scene &scene);
/// Says where pipes may be displaced but points not turned, so that the answer depends on the
/// points.
void remark_on_free_motions(Scene &scene);

/**
 * Check the scene's histories against its steps, and say in its remarks which of them begin with a
 * step that is not the first.
 * @throws UserError if a step begins after a record, whose beginning would be lost, or if the
 * ground would jump where its time begins again
 */
void check_histories(Scene &scene);

/// Entries have names of the user's own: one is declared for each that the section has.
void declare_quantities(ParameterReader &in);
void parse_quantities(const ParameterReader &in, Scene &scene);

/// After everything else: scenes that would run for hours are refused, unless that is allowed.
void check_size(ParameterReader &in, const Scene &scene);

/// Path of the file that an entry names. @throws UserError if there is none.
std::string existing_file(const ParameterReader &in, const std::string &entry);

/// Names in Scene, for references between parts.
template <typename Part>
std::vector<std::string> names(const std::vector<Part> &parts) {
  std::vector<std::string> result;
  for (const Part &part : parts)
    result.push_back(part.name);
  return result;
}

/// Names of all points: corners of routes and points of their own.
std::vector<std::string> point_names(const Scene &scene);

/// @throws UserError unless there is a point of that name; where a Mesh/File may have it, the scene
/// remembers that it was asked for.
void check_point(const ParameterReader &in, const std::string &entry, const std::string &name,
                 Scene &scene);

/// The points that entry 'At' names, as check_point() knows them, each once.
std::vector<std::string> points_at(const ParameterReader &in, Scene &scene);

/// Whether a support stands on a point or on both edges of its Width.
void declare_edges(ParameterReader &in);
/// @throws UserError for kinds and entries that have no edges
void parse_edges(const ParameterReader &in, const Scene &scene, FrictionSupport &support);

/// Words of the six motions: ux, uy, uz, rx, ry, rz.
extern const std::vector<std::string> motions;

/// "ux, rz" to flags. @throws UserError for anything else.
std::array<bool, 6> parse_motions(const ParameterReader &in, const std::string &entry);

/// Place of ux, uy, uz, rx, ry, rz; 6 if it is none of them.
unsigned int motion_index(const std::string &name);

inline constexpr double degree = 3.14159265358979323846 / 180.; ///< [rad]

} // namespace frictionbeam::parts
