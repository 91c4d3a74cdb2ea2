// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>

/**
 * @file
 * A piping scene as the tests see it: the entries of a parameter file as plain numbers in SI units
 * (angles in degrees where the file has degrees). The generator makes it, the writer turns it into
 * a parameter file for the program, and the dense solver solves it. Nothing here is shared with the
 * application: what one of the two reads wrongly, the other does not.
 */
namespace oracle {

using Vec = Eigen::Vector3d;
using Six = std::array<double, 6>; ///< translations and rotations, or forces and moments
constexpr double pi = 3.14159265358979323846;

struct Material {
  std::string name;
  double E = 2e11, nu = 0.3, density = 7850., expansion = 1.2e-5;
  /// Rows of temperature [degC], Young's modulus [Pa], mean expansion from 20 degC [1/K].
  std::vector<std::array<double, 3>> table;
  double modulus_temperature = 20.; ///< at which the modulus is taken from the table
  std::string grade;                ///< of the program's tables; empty: by the figures
  double allowable_cold = 0., allowable_hot = 0.;
};

/// A parameter of a section's law.
struct LawValue {
  enum class Unit { none, pascal, degree } unit = Unit::none; ///< of the file's entry
  std::string name;
  double value = 0.; ///< SI, degC
};

struct Section {
  enum class Shear { half, cowper, none, given } shear = Shear::half;
  std::string name;
  std::string size, schedule;      ///< such as "NPS 6" and "40"; empty: by figures
  double diameter = 0., wall = 0.; ///< 0: by the next ones
  double area = 0., inertia = 0.;  ///< [m2], [m4]
  double torsion = 0.;             ///< [m4]; 0: twice the inertia
  double shear_area = 0.;          ///< if given
  double added_mass = 0.;          ///< [kg/m]
  double contents = 0.;            ///< density [kg/m3]
  double insulation = 0.;          ///< thickness [m]
  double insulation_density = 0.;  ///< [kg/m3]
  double corrosion = 0.;           ///< allowance of stresses [m]
  bool rotary_inertia = true;
  std::string law; ///< empty: elastic
  std::vector<LawValue> law_values;
};

struct Corner {
  std::string name;
  Vec position;
  double bend = 0.;      ///< radius; 0: sharp
  bool relative = false; ///< written as 'by dx dy dz'
  bool by_name = false;  ///< written as a name alone
};

struct Pipe {
  enum class Flexibility { code, von_karman, none, given } flexibility = Flexibility::code;
  std::string name;
  int section = 0, material = 0;
  std::vector<Corner> route;
  double flexibility_factor = 1., stiffening_pressure = 0.;
  int end_section = -1; ///< of a reducer
  bool rigid = false;
  double mass = -1.; ///< of the pipe's own; -1: by density
};

struct Point {
  std::string name;
  Vec position;
};

/// What a snubber's law has.
struct Snubber {
  double stiffness = 0., velocity = 0., acceleration = 0., dead_band = 0., drag = 0.;
};

/// Of a pipe whip restraint, F = coefficient d^exponent [N, d in m].
struct Whip {
  double stiffness = 0., coefficient = 0., exponent = 0.;
};

struct Support {
  enum class Rotations { none, averaged, pipe } rotations = Rotations::none;
  std::string name, kind = "rest";
  std::vector<std::string> at;
  std::string pipe, from, to; ///< instead of at, with every
  double every = 0.;
  std::array<bool, 6> fixed{{true, true, true, true, true, true}}; ///< of a restraint
  std::string direction; ///< "along", "across", or empty: the normal
  Vec normal = Vec(0., 0., 1.);
  double length = 1.;
  double normal_force = 0.;                                    ///< of a platen
  double axial_rigidity = 0., shear_rigidity = 0., ratio = 1.; ///< 0: rigid
  double friction = 0., dynamic_friction = -1.;
  double gap = 0.;
  std::string ground;      ///< point to stand on; empty: the ground
  std::string pad;         ///< instead of the friction coefficient, which is then its own
  bool own_normal = false; ///< with ground: normal and length are given, not the way from there
  bool continuous = false; ///< a bed along pipe instead of every; rigidities per metre
  double torsional_rigidity = 0., patch_radius = 0.; ///< of torsion, if the first is not 0
  double restitution = 0.;
  std::vector<std::array<double, 4>> ground_motion; ///< rows of a table: t, x, y, z
  bool ground_run_time = false;                     ///< of ground_motion
  Snubber snubber;
  std::string law;  ///< "skeleton" (axial rigidity and drag), "whip_restraint"; empty: coulomb
  double drag = 0.; ///< of the skeleton [N s]
  Whip whip;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< columns: those of fixed
  bool as_pair = false; ///< a guide or stop without gap as two contacts, not as a held direction

  bool holds_exactly() const {
    if (as_pair)
      return false;
    return kind == "anchor" || kind == "restraint" ||
           (ground_motion.empty() && restitution == 0. &&
            (kind == "guide" || kind == "line stop" || kind == "stop") && friction == 0. &&
            gap == 0. && axial_rigidity == 0. && shear_rigidity == 0. && ground.empty());
  }
};

struct Spring {
  std::string name, at, to; ///< to empty: the ground
  Six stiffness{}, damping{};
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< columns: those of both
  bool as_matrix = false;                             ///< written as a full matrix in global axes
};

struct Mass {
  std::string name;
  std::vector<std::string> at;
  double mass = 0.;
};

struct Joint {
  std::string name, at, pipe;
  double axial = 0., lateral = 0., bending = 0., torsion = 0.; ///< stiffness; 0: rigid
  double thrust_area = 0.;
};

struct Tee {
  std::string name, at, branch;
  bool code = false;                       ///< springs of ASME III NB-3686.5
  double in_plane = 0., out_of_plane = 0.; ///< else; 0: rigid
  std::string kind;                        ///< of stresses
  double pad = 0., crotch_radius = 0.;
};

struct Hanger {
  std::string name, at;
  bool constant = false;
  double stiffness = 0., cold_load = 0.; ///< without cold load it is sized
  double variation = 0.25;
  std::string weight_step, hot_step; ///< for which it is sized; empty: the first and the second
  Vec direction = Vec(0., 0., 1.);
};

struct Load {
  std::string name, kind = "weight";
  Vec vector = Vec(0., 0., -9.81); ///< acceleration, dynamic pressure of wind, force per length
  double value = 0.;               ///< temperature, pressure, shape factor of wind
  std::vector<std::string> pipes;  ///< empty: all
  std::vector<std::pair<std::string, Six>> at;        ///< forces, or displacements [m, degrees]
  std::vector<std::array<bool, 6>> given;             ///< displacements: which
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< columns: those of displacements
  std::vector<std::array<double, 2>> history;         ///< rows of a table of its factor: t, factor
  bool run_time = false;                              ///< of the history
  bool follow = false;                                ///< of forces
};

struct Step {
  std::string name;
  std::vector<std::pair<int, double>> loads; ///< load and factor
  int increments = 1;
  bool transient = false;
  double duration = 1., ramp = 0.;
  std::string from; ///< step from whose end it starts; empty: the one before
};

/// Which motions or directions and how much; a turn of the scene turns them.
struct Spectrum {
  std::string name;
  std::vector<std::array<double, 2>> curve; ///< frequency, acceleration
  Vec directions = Vec::Zero();             ///< factors
  std::vector<std::string> supports;
};

struct Combination {
  std::string name, kind;
  std::vector<std::pair<std::string, double>> cases;
};

struct Nozzle {
  std::string support;
  Six allowed{};
};

/// A setting with a unit: the value in SI times [length^l time^t].
struct Setting {
  std::string entry; ///< "Section/Entry"
  double value = 0.;
  int length = 0, time = 0;
};

struct Initial {
  std::vector<std::string> at, pipes;
  std::string about;
  Six displacement{}, velocity{};
};

struct Scene {
  std::string units = "si";
  double installation_temperature = 20.;
  std::array<bool, 6> free_motions{{true, true, true, true, true, true}};
  std::vector<Material> materials;
  std::vector<Section> sections;
  std::vector<Pipe> pipes;
  std::vector<Point> points;
  std::vector<Support> supports;
  std::vector<Spring> springs;
  std::vector<Mass> masses;
  std::vector<Joint> joints;
  std::vector<Tee> tees;
  std::vector<Hanger> hangers;
  std::vector<Load> loads;
  std::vector<Step> steps;
  std::vector<Initial> initial;
  std::vector<Spectrum> spectra;
  std::vector<Combination> combinations;
  std::vector<Nozzle> nozzles;
  std::vector<Setting> settings;
  std::vector<std::string> monitors; ///< points whose motion is compared

  bool arcs = true; ///< else bends are cut into straight pieces
  int cells_per_bend = 8;
  double cell_length = 0.;
  int stations = 3;
  int modes = 0;
  bool lumped = false;                                   ///< mass of the modes
  std::vector<std::pair<std::string, std::string>> more; ///< further entries, "Section/Entry"
  bool large_displacements = false;
  bool quantities = false; ///< motions of points in every case, and extremes of transient steps
  bool sections_reversed = false; ///< the file's parts in reverse order where order is free

  bool has_laws() const { ///< of sections
    for (const Section &section : sections)
      if (!section.law.empty())
        return true;
    return false;
  }
  bool has_contacts() const {
    for (const Support &support : supports)
      if (!support.holds_exactly())
        return true;
    return false;
  }
};

} // namespace oracle
