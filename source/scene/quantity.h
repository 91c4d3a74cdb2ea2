// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/body.h"
#include "scene/file/choice.h"

#include <frictionbeam/law.h>

#include <array>
#include <optional>
#include <string>

/**
 * @file
 * What a user may ask for: the one table of quantities, from which the grammar, its messages, the
 * documentation, the evaluation and Accuracy read. SI units.
 */
namespace frictionbeam {

/// A word that a quantity may ask for.
struct QuantityKind {
  /// What it is of, and so who evaluates it.
  enum class Of {
    motion,   ///< a point
    velocity, ///< a point
    section,  ///< the pipe at a point
    holder,   ///< what holds the pipe at a support, spring or point
    directed, ///< a motion, a force or a section force at a point, along a direction
    fibre,    ///< the pipe's section at a point: moments of a bend or tee, stresses of its wall
    support,  ///< one friction support
    supports, ///< all friction supports, or those of one part
    change,   ///< the state of a friction support, of which the first time is asked
    mode,     ///< a mode of the line
    stress,   ///< the line by its stress code
    limit,    ///< a step that finds the largest load
    cycle,    ///< a step at whose end a cycle of loads ends
    wall,     ///< a section that yields or creeps, the nearest to a point
    line,     ///< all of it
    exact     ///< the scene's exact solution
  };
  /// What its numbers are, for who compares two of them.
  enum class Measure { amount, count, place, error };

  const char *word;
  Of of;
  unsigned int component; ///< among those of the same: a place in what they are evaluated from
  const char *unit;
  const char *meaning = ""; ///< for the documentation, where the word does not say it
  Measure measure = Measure::amount;
  bool is_size = false;        ///< never negative
  bool is_of_line_too = false; ///< a point is not needed: the largest of the line

  /// Known only when everything else is.
  bool is_of_the_end() const {
    return of == Of::mode || of == Of::stress || of == Of::limit || of == Of::cycle;
  }
};

inline constexpr QuantityKind quantity_kinds[] = {
    {"ux", QuantityKind::Of::motion, 0, "m"},
    {"uy", QuantityKind::Of::motion, 1, "m"},
    {"uz", QuantityKind::Of::motion, 2, "m"},
    {"rx", QuantityKind::Of::motion, 3, "rad"},
    {"ry", QuantityKind::Of::motion, 4, "rad"},
    {"rz", QuantityKind::Of::motion, 5, "rad"},
    {"vx", QuantityKind::Of::velocity, 0, "m/s"},
    {"vy", QuantityKind::Of::velocity, 1, "m/s"},
    {"vz", QuantityKind::Of::velocity, 2, "m/s"},
    {"wx", QuantityKind::Of::velocity, 3, "rad/s"},
    {"wy", QuantityKind::Of::velocity, 4, "rad/s"},
    {"wz", QuantityKind::Of::velocity, 5, "rad/s"},
    {"fx", QuantityKind::Of::holder, 0, "N"},
    {"fy", QuantityKind::Of::holder, 1, "N"},
    {"fz", QuantityKind::Of::holder, 2, "N"},
    {"mx", QuantityKind::Of::holder, 3, "N m"},
    {"my", QuantityKind::Of::holder, 4, "N m"},
    {"mz", QuantityKind::Of::holder, 5, "N m"},
    {"N", QuantityKind::Of::section, 0, "N"},
    {"Vy", QuantityKind::Of::section, 1, "N"},
    {"Vz", QuantityKind::Of::section, 2, "N"},
    {"Mx", QuantityKind::Of::section, 3, "N m"},
    {"My", QuantityKind::Of::section, 4, "N m"},
    {"Mz", QuantityKind::Of::section, 5, "N m"},
    {"N_mean", QuantityKind::Of::section, 6, "N", "of N before and after"},
    // in the order of Directed
    {"u", QuantityKind::Of::directed, 0, "m", "displacement of a point"},
    {"r", QuantityKind::Of::directed, 1, "rad", "its rotation"},
    {"v", QuantityKind::Of::directed, 2, "m/s", "its velocity"},
    {"w", QuantityKind::Of::directed, 3, "rad/s", "its rate of rotation"},
    {"f", QuantityKind::Of::directed, 4, "N", "force of what holds the pipe, as fx"},
    {"m", QuantityKind::Of::directed, 5, "N m", "moment of what holds the pipe"},
    {"F", QuantityKind::Of::directed, 6, "N", "section force, on the face that looks forward"},
    {"M", QuantityKind::Of::directed, 7, "N m", "section moment on that face"},
    // in the order of Fibre
    {"M_in", QuantityKind::Of::fibre, 0, "N m", "moment in the plane of a bend or tee"},
    {"M_out", QuantityKind::Of::fibre, 1, "N m", "moment out of that plane"},
    {"sigma_1", QuantityKind::Of::fibre, 2, "Pa", "largest principal stress of the wall"},
    {"sigma_3", QuantityKind::Of::fibre, 3, "Pa", "least principal stress of the wall"},
    {"von_mises", QuantityKind::Of::fibre, 4, "Pa",
     "largest equivalent stress of the wall by von Mises", QuantityKind::Measure::amount, true},
    {"tresca", QuantityKind::Of::fibre, 5, "Pa", "largest stress intensity of the wall, by Tresca",
     QuantityKind::Measure::amount, true},
    // in the order of support_numbers
    {"fn", QuantityKind::Of::support, 0, "N", "", QuantityKind::Measure::amount, true},
    {"ft1", QuantityKind::Of::support, 1, "N"},
    {"ft2", QuantityKind::Of::support, 2, "N"},
    {"gap", QuantityKind::Of::support, 3, "m"},
    {"slip1", QuantityKind::Of::support, 4, "m"},
    {"slip2", QuantityKind::Of::support, 5, "m"},
    {"work", QuantityKind::Of::support, 6, "J", "of friction"},
    {"mt", QuantityKind::Of::support, 7, "N m", "about the normal, of Torsion"},
    {"wear", QuantityKind::Of::support, 8, "J",
     "the integral of fn |slip rate| over transient steps"},
    {"impulse", QuantityKind::Of::support, 9, "N s",
     "of fn over transient steps, impacts included"},
    {"frequency", QuantityKind::Of::mode, 0, "Hz"},
    {"flexibility", QuantityKind::Of::stress, 0, "-"},
    {"sif_in", QuantityKind::Of::stress, 1, "-"},
    {"sif_out", QuantityKind::Of::stress, 2, "-"},
    {"SL", QuantityKind::Of::stress, 3, "Pa", "of sustained and occasional loads"},
    {"SE", QuantityKind::Of::stress, 4, "Pa", "a displacement stress range"},
    {"utilization", QuantityKind::Of::stress, 5, "-", "the largest of the line without a point",
     QuantityKind::Measure::amount, true, true},
    {"plastic_strain", QuantityKind::Of::wall, 0, "-",
     "accumulated, of the nearest section that yields; the largest of the line without a point",
     QuantityKind::Measure::amount, true, true},
    {"creep_strain", QuantityKind::Of::wall, 1, "-", "likewise, of creep",
     QuantityKind::Measure::amount, true, true},
    {"yield_ratio", QuantityKind::Of::wall, 2, "-", "likewise, equivalent stress over yield stress",
     QuantityKind::Measure::amount, true, true},
    {"eps", QuantityKind::Of::wall, 3, "-", "strain along the axis there that causes stress"},
    {"chi", QuantityKind::Of::wall, 6, "rad/m", "twist"},
    {"kappa_y", QuantityKind::Of::wall, 7, "rad/m", "curvature"},
    {"kappa_z", QuantityKind::Of::wall, 8, "rad/m", "curvature"},
    {"limit_factor", QuantityKind::Of::limit, 0, "-", "part of the step's loads that was carried"},
    {"limit_bound", QuantityKind::Of::limit, 1, "-",
     "rigid-plastic bound of that part by the last motion"},
    {"cycle_growth", QuantityKind::Of::cycle, 0, "-",
     "largest growth of a section's strain in the last cycle", QuantityKind::Measure::amount, true},
    {"cycle_flow", QuantityKind::Of::cycle, 1, "-",
     "the most that plastic and creep strain of one point have accumulated in it",
     QuantityKind::Measure::amount, true},
    {"cycle_dissipation", QuantityKind::Of::cycle, 2, "J", "by pipes in the last cycle"},
    {"momentum_x", QuantityKind::Of::line, 0, "N s"},
    {"momentum_y", QuantityKind::Of::line, 1, "N s"},
    {"momentum_z", QuantityKind::Of::line, 2, "N s"},
    {"angular_momentum_x", QuantityKind::Of::line, 3, "N m s"},
    {"angular_momentum_y", QuantityKind::Of::line, 4, "N m s"},
    {"angular_momentum_z", QuantityKind::Of::line, 5, "N m s"},
    {"energy", QuantityKind::Of::line, 6, "J"},
    {"sum_normal", QuantityKind::Of::supports, 0, "N", "", QuantityKind::Measure::amount, true},
    {"sum_friction", QuantityKind::Of::supports, 1, "N", "", QuantityKind::Measure::amount, true},
    {"n_stick", QuantityKind::Of::supports, 2, "-", "", QuantityKind::Measure::count},
    {"n_slip", QuantityKind::Of::supports, 3, "-", "", QuantityKind::Measure::count},
    {"n_open", QuantityKind::Of::supports, 4, "-", "", QuantityKind::Measure::count},
    {"slip_length", QuantityKind::Of::supports, 5, "m",
     "of the zone of supports that slip and begins at the lowest x, or y or z if they extend "
     "further in it",
     QuantityKind::Measure::place},
    {"max_error", QuantityKind::Of::exact, 0, "m", "relative where Exact has a Scale",
     QuantityKind::Measure::error},
    {"stick", QuantityKind::Of::change, static_cast<unsigned int>(ContactStatus::stick), "s"},
    {"slip", QuantityKind::Of::change, static_cast<unsigned int>(ContactStatus::slip), "s"},
    {"open", QuantityKind::Of::change, static_cast<unsigned int>(ContactStatus::open), "s"},
    {"closed", QuantityKind::Of::change, static_cast<unsigned int>(ContactStatus::closed), "s"}};

/// What a quantity is along a direction, two of each: a vector and, besides, a rotation or moment.
enum class Directed : unsigned int {
  displacement,
  rotation,
  velocity,
  spin,
  force,
  moment,
  section_force,
  section_moment
};
/// What a quantity is of a pipe's section.
enum class Fibre : unsigned int { in_plane, out_of_plane, most, least, von_mises, tresca };

/// One of the quantities of the same, by its place among them.
inline const QuantityKind &quantity_kind(const QuantityKind::Of of, const unsigned int component) {
  return *std::find_if(
      std::begin(quantity_kinds), std::end(quantity_kinds),
      [&](const QuantityKind &kind) { return kind.of == of && kind.component == component; });
}

/// What is asked of a body.
struct BodyQuantityKind {
  enum class At { point, part, x }; ///< x: a coordinate

  const char *word;
  ContinuumQuantity::Kind value;
  unsigned int component;
  At at;
  const char *unit;
  bool of_friction = false; ///< its part is a surface with friction
  bool is_place = false;    ///< on it
};

inline constexpr BodyQuantityKind body_quantity_kinds[] = {
    {"ux", ContinuumQuantity::Kind::displacement, 0, BodyQuantityKind::At::point, "m"},
    {"uy", ContinuumQuantity::Kind::displacement, 1, BodyQuantityKind::At::point, "m"},
    {"uz", ContinuumQuantity::Kind::displacement, 2, BodyQuantityKind::At::point, "m"},
    {"mean_ux", ContinuumQuantity::Kind::mean_displacement, 0, BodyQuantityKind::At::part, "m"},
    {"mean_uy", ContinuumQuantity::Kind::mean_displacement, 1, BodyQuantityKind::At::part, "m"},
    {"mean_uz", ContinuumQuantity::Kind::mean_displacement, 2, BodyQuantityKind::At::part, "m"},
    {"slip_length", ContinuumQuantity::Kind::slip_length, 0, BodyQuantityKind::At::part, "m", true,
     true},
    {"slip_end", ContinuumQuantity::Kind::slip_end, 0, BodyQuantityKind::At::part, "m", true, true},
    {"open_end", ContinuumQuantity::Kind::open_end, 0, BodyQuantityKind::At::part, "m", true, true},
    {"sum_normal", ContinuumQuantity::Kind::sum_normal, 0, BodyQuantityKind::At::part, "N", true},
    {"sum_friction", ContinuumQuantity::Kind::sum_friction, 0, BodyQuantityKind::At::part, "N",
     true},
    {"N", ContinuumQuantity::Kind::axial_force, 0, BodyQuantityKind::At::x, "N"}};

/// A number that the user asks for.
struct Quantity {
  std::string name;
  std::string what; ///< a word of quantity_kinds
  bool absolute = false;
  /// Over an interval of time: change and rate are between its ends, and the change per time.
  enum class Over { end, maximum, minimum, mean, integral, change, rate, time_of } over = Over::end;
  bool wants_time = false;      ///< of a maximum or minimum: when it is reached first [s]
  double from = 0., to = 1e300; ///< interval of time [s], if not `end`
  std::string where; ///< named point, or name of a support or restraint; number of a mode
  enum class Side { any, before, after } side = Side::any; ///< of a point, for what has a pipe
  std::string pipe; ///< on which the point is meant, likewise; empty: the first
  enum class Along { none, direction, local } along = Along::none; ///< local: of the pipe there
  std::array<double, 3> direction{}; ///< unit, in global axes or those of the pipe as it was built
  std::string step;                  ///< empty: the last one
  std::optional<double> time;        ///< [s], instead of a step's end
  double scale = 1.;
  std::string unit; ///< to show, of a scaled one; empty: what it measures
  std::optional<double> reference;
  std::optional<double> limit; ///< that its size should not exceed, in its unit
  std::string source;

  const QuantityKind &kind() const { return *find_word(quantity_kinds, what); }
  bool is(const QuantityKind::Of of) const { return kind().of == of; }
  /// Of what has a direction: a force or moment, not a motion.
  bool unit_is_force() const {
    return is(QuantityKind::Of::directed) &&
           kind().component >= static_cast<unsigned int>(Directed::force);
  }
  /// Whether it is asked of one pipe at its point, on one side of it.
  bool has_pipe() const {
    return is(QuantityKind::Of::section) || is(QuantityKind::Of::fibre) ||
           is(QuantityKind::Of::stress) || is(QuantityKind::Of::wall) ||
           (unit_is_force() &&
            kind().component >= static_cast<unsigned int>(Directed::section_force));
  }
};

/// Words of what is asked over an interval of time.
inline constexpr Word<Quantity::Over> intervals[] = {
    {"max", Quantity::Over::maximum},    {"min", Quantity::Over::minimum},
    {"mean", Quantity::Over::mean},      {"integral", Quantity::Over::integral},
    {"change", Quantity::Over::change},  {"rate", Quantity::Over::rate},
    {"time_of", Quantity::Over::time_of}};

} // namespace frictionbeam
