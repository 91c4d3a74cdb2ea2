// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/body.h"
#include "scene/components.h"
#include "scene/modal.h"
#include "scene/quantity.h"
#include "scene/settings.h"
#include "scene/study/study.h"
#include "scene/time_function.h"
#include "scene/units.h"
#include <frictionbeam/law.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

/**
 * @file
 * The scene: what a parameter file describes, as plain data in SI units (angles in radians), named
 * and checked once at the door. Parts refer to each other by their place in these lists. No mesh
 * and no unknowns here.
 */
namespace frictionbeam {

using Point3 = dealii::Point<3>;
using Vector3 = dealii::Tensor<1, 3>;
/// Three translations [m] and three rotations [rad], or three forces [N] and three moments [N m].
using Motion = std::array<double, 6>;

/// Right-handed unit vectors.
using Axes = std::array<Vector3, 3>;
inline Axes global_axes() {
  return {{Vector3({1., 0., 0.}), Vector3({0., 1., 0.}), Vector3({0., 0., 1.})}};
}

/// Component @p c in axes: the translation (0 to 2) along one of them, or the rotation about it.
inline Motion unit_motion(const Axes &axes, const unsigned int c) {
  Motion result{};
  for (unsigned int d = 0; d < 3; ++d)
    result[c / 3 * 3 + d] = axes[c % 3][d];
  return result;
}
inline std::array<Motion, 6> unit_motions(const Axes &axes) {
  std::array<Motion, 6> result;
  for (unsigned int c = 0; c < 6; ++c)
    result[c] = unit_motion(axes, c);
  return result;
}
inline double product(const Motion &force, const Motion &motion) {
  double sum = 0.;
  for (unsigned int c = 0; c < 6; ++c)
    sum += force[c] * motion[c];
  return sum;
}

struct Material {
  std::string name;
  double youngs_modulus = 0.; ///< [Pa]
  double poissons_ratio = 0.;
  double density = 0.;                            ///< [kg/m3]
  double expansion = 0.;                          ///< [1/K]
  std::vector<MaterialPoint> table;               ///< rising in temperature; empty: the same at all
  double allowable_cold = 0., allowable_hot = 0.; ///< Sc and Sh of a stress code [Pa]
  double yield_stress = 0.;                       ///< [Pa]; 0: not said

  /// Free strain from one temperature to another [degC].
  double thermal_strain(const double from, const double to) const;
  /// At a temperature [degC] of the table, modulus and mean expansion from 20 degC.
  MaterialPoint at(const double temperature) const;
};

struct Section {
  std::string name;
  double area = 0.;               ///< metal [m2]
  double inertia = 0.;            ///< about either axis [m4]
  double torsion_constant = 0.;   ///< [m4]
  double shear_area = 0.;         ///< [m2]; 0: no shear flexibility
  double outer_radius = 0.;       ///< [m]; 0 where the section is given by its figures
  double wall = 0.;               ///< [m]; 0 likewise
  double added_mass = 0.;         ///< contents, insulation and the rest [kg/m]
  double contents = 0.;           ///< density [kg/m3], in added_mass as well
  bool rotary_inertia = true;     ///< of the metal, in the mass
  double insulation = 0.;         ///< thickness [m]
  double insulation_density = 0.; ///< [kg/m3], in added_mass as well
  double corrosion = 0.;          ///< allowance, off the wall's inside in sustained stresses [m]
  std::string law = "elastic_section"; ///< of kind section
  /// Of the law, in its order; without a value: not in the file.
  std::vector<std::optional<double>> law_parameters;
  bool is_inelastic() const { return law != "elastic_section"; }

  double bore_area() const; ///< [m2]; 0 where the wall is not known
  /// r sqrt(r/t) of the mean radius, in which the oval of a straight pipe dies out [m].
  double decay_length() const {
    const double r = outer_radius - wall / 2.;
    return r * std::sqrt(r / wall);
  }
  /// Contents and insulation, by their densities [kg/m].
  double filling() const;
};

/// The section of a reducer, @p part of its way from @p begin to @p end: diameter, wall, corrosion
/// allowance, thickness of insulation, densities and the ratio of shear area change evenly.
Section between(const Section &begin, const Section &end, const double part);

struct RoutePoint {
  std::string name; ///< may be empty
  Point3 position;
  double bend_radius = 0.; ///< of the bend that rounds this corner; 0: sharp
};

/// How much more flexible than a straight pipe a bend is.
struct BendFlexibility {
  /// code: k = 1.65/h >= 1, h = t R/r^2; von_karman: (10 + 12 h^2)/(1 + 12 h^2)
  enum class Rule { none, code, von_karman, given } rule = Rule::code;
  double factor = 1.;   ///< if given
  double pressure = 0.; ///< that stiffens the bend [Pa], for code
};

struct Pipe {
  std::string name;
  unsigned int section = 0, material = 0;
  std::vector<RoutePoint> route; ///< empty if the pipe is the curve of this name in Mesh/File
  BendFlexibility bend_flexibility;
  double bend_radius = 0.; ///< of a pipe from a file that is a bend [m]; 0: straight
  std::optional<unsigned int> end_section; ///< of a reducer, whose section changes evenly to it
  bool rigid = false;                      ///< a valve, a flange: 1000 times as stiff
  std::optional<double> total_mass;        ///< of the pipe itself [kg], instead of its metal's

  /// Whether a corner of its route is rounded.
  bool has_bend() const {
    return std::any_of(route.begin(), route.end(),
                       [](const RoutePoint &point) { return point.bend_radius > 0.; });
  }
};

/// A point with a name that is no corner of a route: on a pipe, or free in space.
struct NamedPoint {
  std::string name;
  Point3 position;
};

/// Where a support stands: at named points, or repeated along a pipe between two of its points.
struct Placement {
  std::vector<std::string> points;
  std::string pipe;        ///< if repeated
  std::string from, to;    ///< named points on the pipe; empty: its ends
  double every = 0.;       ///< distance [m], the first one at that distance from `from`
  bool continuous = false; ///< a bed: at every mesh node from `from` to `to`, each for its share
};

/// A direction in space, or one that follows the pipe where the support stands.
struct Direction {
  enum class Kind { global, along, across } kind = Kind::global; ///< across: local y of the pipe
  Vector3 vector;                                                ///< unit, if global
  double sign = 1.;                                              ///< -1: the opposite direction
};

/// A friction element with its law.
struct FrictionSupport {
  enum class Rotations { none, averaged, pipe };

  std::string name, kind; ///< kind as the user called it: rest, guide, ...
  Placement placement;
  Direction normal; ///< from the ground into the pipe; zero: from the point Ground to that of At
  std::string law;
  std::vector<double> parameters; ///< of the law, in its order; per metre for a continuous bed
  std::map<unsigned int, std::vector<double>> parameters_at; ///< of single places, from 0 on
  double length = 1.; ///< of the element [m]; 0: the distance to the point Ground
  double share = 1.;  ///< of a whole element that this is: scales its forces, stiffness
                      ///< and normal_force
  Rotations rotations = Rotations::none;
  bool torsion = false, on_edges = false; ///< edges: of its Width, half of it on each
  double normal_force = 0.; ///< of a platen that is pressed on [N], for a whole element (per metre
                            ///< for a bed); 0: the ground is fixed
  std::string ground;       ///< named point of another pipe to stand on; empty: the ground
  double capacity = 0.;     ///< largest force that it is made for [N]; 0: not said
  double width = 0.;        ///< of its patch, along the pipe [m]; 0: a diameter
  double restitution = 0.;  ///< Newton's, of an impact on a rigid contact: 0 to 1
  std::array<TimeFunction, 3> ground_motion; ///< of the ground, global axes [m]; not given: 0

  const std::vector<double> &parameters_of(const unsigned int place) const {
    const auto own = parameters_at.find(place);
    return own == parameters_at.end() ? parameters : own->second;
  }
  bool ground_moves() const {
    return ground_motion[0].is_given() || ground_motion[1].is_given() ||
           ground_motion[2].is_given();
  }
};

/// Motions held exactly: anchor, guide, line stop, any set of fixed motions.
struct Restraint {
  std::string name, kind;
  Placement placement;
  std::array<bool, 6> fixed{}; ///< along and about the axes
  Axes axes = global_axes();
  std::vector<Direction> translations; ///< further directions held
  double capacity = 0.;                ///< largest force that it is made for [N]; 0: not said

  /// Whether it holds all motions.
  bool is_anchor() const {
    return std::all_of(fixed.begin(), fixed.end(), [](const bool one) { return one; });
  }
};

/// Linear spring, to the ground or between two points: the sum over six directions a of motion of
/// -(k a.u + c a.v) a. Translations along three axes and rotations about them, unless a full matrix
/// is given, whose factors L D L^T they are then.
struct Spring {
  std::string name;
  std::string point, other;    ///< other empty: the ground
  Motion stiffness{};          ///< k of each [N/m] (3), [N m/rad] (3)
  Motion damping{};            ///< c of each [N s/m] (3), [N m s/rad] (3)
  double preload = 0.;         ///< force on its point at no displacement, along the third [N]
  std::string kind = "spring"; ///< as the user called it
  std::array<Motion, 6> directions = unit_motions(global_axes());

  /// Whether it resists rotation about a global axis, by its stiffness or besides by its damping.
  bool turns(const unsigned int axis, const bool by_damping) const {
    for (unsigned int c = 0; c < 6; ++c)
      if (directions[c][3 + axis] != 0. && (stiffness[c] != 0. || (by_damping && damping[c] != 0.)))
        return true;
    return false;
  }
};

struct PointMass {
  std::string name;
  std::vector<std::string> points;
  double mass = 0.; ///< [kg]
};

struct Load {
  /// preload: of hangers (Spring::preload), added to scenes that have some, and on in all steps.
  enum class Kind { weight, temperature, pressure, force, line_force, displacement, wind, preload };
  struct AtPoint {
    std::string point;
    Motion value{};              ///< force and moment, or displacement and rotation
    std::array<bool, 6> given{}; ///< displacement: which motions are imposed
    Axes axes = global_axes();   ///< displacement: that they are along and about
  };

  std::string name;
  Kind kind = Kind::weight;
  Vector3 vector;                 ///< weight: acceleration [m/s2]; line_force: [N/m]; wind:
                                  ///< dynamic pressure times shape factor, its way [Pa]
  double value = 0.;              ///< temperature: rise above installation [K]; pressure [Pa]
  double installation = 20.;      ///< temperature: where the rise begins [degC]
  std::vector<std::string> pipes; ///< temperature, pressure, line_force: empty means all
  std::vector<AtPoint> at;        ///< force, displacement
  bool follows = false;           ///< force: turns with its point
  TimeFunction history;           ///< by which it is multiplied

  /// Of those that act on whole pipes: whether on this one.
  bool is_on(const std::string &pipe) const {
    return pipes.empty() || std::find(pipes.begin(), pipes.end(), pipe) != pipes.end();
  }
};

/// One step of the declared load sequence: all loads active at its end, with factors; they change
/// linearly in time from their values before.
struct LoadStep {
  std::string name;
  std::vector<std::pair<unsigned int, double>> loads; ///< load, factor
  unsigned int n_increments = 1;                      ///< static
  bool transient = false;
  double duration = 1.;     ///< [s]; of a static step, the pseudo-time it takes
  bool finds_limit = false; ///< static: whether it ends at the largest part of its loads
  double ramp = 0.; ///< transient: time in which the loads reach their values [s]; 0: at once
  std::optional<unsigned int> from; ///< step from whose end it starts; empty: the one before it
  /// Of loads that repeat themselves, which the step is one of: its number from 1 on, or 0.
  struct Cycle {
    unsigned int number = 0, of = 0;
    bool begins = false, ends = false; ///< whether it is the cycle's first or last step
  } cycle;
};

struct InitialCondition {
  std::vector<std::string> points, pipes; ///< pipes: all their nodes
  Motion displacement{}, velocity{};
  /// Named point: displacement and velocity are those of a rigid body there; empty: of each node.
  std::string about;
};

/// Exact course of one motion of one point, for quantities of kind max_error.
struct ExactHistory {
  std::string point;
  unsigned int component = 0;
  std::function<double(const double)> value;
  double largest = 0.; ///< errors are relative to this value [m]; 0: they are in metres
};

/// A point that an entry names, while only Mesh/File can say whether there is one.
struct AskedPoint {
  std::string entry; ///< where it stands, for a message
  std::string name;
};

struct Scene {
  std::string name; ///< of the parameter file, without folder and ending
  std::string title;
  std::string input;                  ///< the file's text, as read, for the report
  std::vector<std::string> overrides; ///< the --set options
  std::vector<std::string> remarks;   ///< what the user should know about how the file was read
  std::vector<std::string> doubts;    ///< likewise, of what is hardly meant: errors of --strict
  double accuracy = 0.; ///< demanded of the quantities, relative; 0: the file says how finely
  /// Whether it is solved several times, until that is so.
  bool takes_many_runs() const { return accuracy > 0. || mesh.refine_hinges; }
  /// Headings of the file's parts and where they stand ("case.prm:12").
  std::vector<std::pair<std::string, std::string>> origins;

  std::vector<Material> materials;
  std::vector<Section> sections;
  std::vector<Pipe> pipes;
  /// Positions of named points of sections Point and routes; of a rounded corner, its own.
  std::unordered_map<std::string, Point3> places;
  std::vector<NamedPoint> points;
  std::vector<FrictionSupport> supports;
  std::vector<Restraint> restraints;
  std::vector<Spring> springs;
  std::vector<PointMass> masses;
  std::vector<Joint> joints;
  std::vector<Tee> tees;
  Catalogue catalogue;
  std::vector<Hanger> hangers;
  std::vector<NozzleLimit> nozzles;
  StressSettings stress;
  std::vector<double> friction_multipliers; ///< of a study; empty: the friction as it is
  std::vector<Load> loads;
  std::vector<LoadStep> steps;
  std::vector<InitialCondition> initial;
  std::vector<Quantity> quantities;
  /// Points named by entries, where only Mesh/File can say which there are.
  std::vector<AskedPoint> asked_points;
  std::vector<std::string> monitors; ///< points whose motion is recorded at every increment
  std::optional<ExactHistory> exact;
  std::array<bool, 6> free_motions{{true, true, true, true, true, true}}; ///< of pipe nodes

  double installation_temperature = 20.; ///< of all that no load heats [degC]

  UnitSystem units; ///< of the file, and of what is shown
  ModalSettings modal;
  std::vector<Spectrum> spectra;
  SpectrumSettings response;
  std::vector<Combination> combinations;

  ModelKind model = ModelKind::line;
  Kinematics kinematics = Kinematics::linear; ///< of the line
  std::optional<ContinuumScene> continuum;    ///< of a scene that has one, unless model is line

  ContinuumSettings continuum_settings;
  SolidSettings solid;
  MeshSettings mesh;
  SolverSettings solver;
  TimeSettings time;
  OutputSettings output;
  CheckSettings checks;
  StudySettings study;

  /// Whether it is solved as solid pipes, alone or beside the line.
  bool is_solid() const {
    return model == ModelKind::solid || (model == ModelKind::both && !continuum);
  }

  void add_point(const std::string &point, const Point3 &position) {
    points.push_back({point, position});
    places.emplace(point, position);
  }

  bool has_bend() const {
    return std::any_of(pipes.begin(), pipes.end(),
                       [](const Pipe &pipe) { return pipe.has_bend(); });
  }

  /// Whether sections stay as stiff as their laws are at rest, whatever the laws say of yielding.
  bool keeps_elastic = false;

  /// Whether it has pipes whose section has an inelastic law.
  bool yields() const {
    return !keeps_elastic && std::any_of(pipes.begin(), pipes.end(), [this](const Pipe &pipe) {
      return !pipe.rigid && sections[pipe.section].is_inelastic();
    });
  }
};

/// A message about a scene that came after it was read, with the place of the part that it names in
/// front: "case.prm:12: Support rest ...". Unchanged if it names none.
std::string with_place(const Scene &scene, const std::string &message);

} // namespace frictionbeam
