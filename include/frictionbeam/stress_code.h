// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/**
 * @file
 * The interface of a piping stress code, plain C++ without deal.II: a code is compiled into a
 * shared library of its own, and loaded by its name. plugin/codes/stress_skeleton.cc is one to
 * copy. All numbers in SI units.
 */
namespace frictionbeam {

/// A library of another version is refused.
inline constexpr int stress_code_interface_version = 1;

/// What a place of the line is.
enum class StressPart : int { straight = 0, bend = 1, run_of_tee = 2, branch_of_tee = 3 };

/// Kinds of branch connections, of which a code may know some.
enum class TeeKind : int {
  welding = 0,
  reinforced = 1,
  unreinforced = 2,
  extruded = 3,
  welded_in = 4,
  integral = 5 ///< integrally reinforced
};

/// A place of the line as a code sees it.
struct StressPoint {
  StressPart part = StressPart::straight;
  double diameter = 0., wall = 0.; ///< of this pipe: outer; nominal [m]
  double corrosion = 0.;           ///< allowance, off the wall's inside [m]
  double bend_radius = 0.;         ///< of a bend's axis [m]
  double youngs_modulus = 0.;      ///< for pressure stiffening [Pa]
  double stiffening_pressure = 0.; ///< of a bend [Pa]
  TeeKind tee = TeeKind::welding;
  double pad = 0., crotch_radius = 0.;            ///< of a tee [m]
  double run_diameter = 0., run_wall = 0.;        ///< of a tee's run [m]
  double run_corrosion = 0.;                      ///< of a tee's run [m]
  double allowable_cold = 0., allowable_hot = 0.; ///< Sc, Sh [Pa]
};

/// Forces on the cross section there.
struct StressForces {
  double axial = 0.; ///< tension > 0, without what pressure does [N]
  /// Bending about the normal of the plane of the bend or tee, and in it [N m]. Of straight pipes
  /// all bending is out_of_plane.
  double in_plane = 0., out_of_plane = 0.;
  double torsion = 0.;  ///< [N m]
  double pressure = 0.; ///< inside over outside [Pa]; 0 in a range
};

/// For reports; what a code does with them is its own matter.
struct StressFactors {
  double flexibility = 1.;                 ///< of a bend, by which it is more flexible than a pipe
  double in_plane = 1., out_of_plane = 1.; ///< stress intensification of bending
  double axial = 1.;                       ///< and of axial force, in a range
};

/// What the user sets beside the code.
struct StressRules {
  double cycles_factor = 1.; ///< f
  bool liberal = false;      ///< what the sustained stress leaves is added to the range allowed
  double occasional_factor = 1.33;
};

/// Which stress: of the forces of one state, or of the difference of those of two.
enum class StressFormula : int { longitudinal = 0, range = 1 };

/// Which limit. The longitudinal stress stands against the first two.
enum class StressLimit : int { sustained = 0, occasional = 1, range = 2 };

/// How many numbers prepare() may leave.
inline constexpr int n_stress_coefficients = 16;

/**
 * A stress code. Objects are stateless and constant: all data comes in by arguments.
 *
 * What a function throws is told to the user, if it is derived from std::exception.
 */
class StressCodeBase {
public:
  /// Why the code says nothing about such a place, in a few words, as "a tee of kind extruded; it
  /// has welding tees"; null: it does. The host asks before it solves.
  virtual const char *fault(const StressPoint &point) const = 0;

  virtual StressFactors factors(const StressPoint &point) const = 0;

  /// Work out what the place decides, once, so that stress() has little to do at each instant of a
  /// motion. @param coefficients n_stress_coefficients numbers, zero at first
  virtual void prepare(StressFormula formula, const StressPoint &point,
                       double *coefficients) const = 0;

  /**
   * A stress >= 0 [Pa] by the forces. It must be a convex function of axial force and moments, and
   * the same for moments of other signs: a host that knows the forces between bounds only takes the
   * largest at the corners.
   */
  virtual double stress(StressFormula formula, const double *coefficients,
                        const StressForces &forces) const = 0;

  /// What is allowed there, > 0 [Pa]. @param sustained_stress the largest of the sustained cases,
  /// for a range
  virtual double allowed(StressLimit limit, const StressPoint &point, const StressRules &rules,
                         double sustained_stress) const = 0;

protected:
  ~StressCodeBase() = default;
};

/// Everything the host knows about a code before it calls it.
struct StressCodeDescription {
  int interface_version; ///< always first: stress_code_interface_version of the compiled header
  const char *name;      ///< as in Stress/Code
  const char *edition;   ///< as reports say it: code, edition, paragraphs
  const StressCodeBase *code;
};

} // namespace frictionbeam

/// The object that a code's library exports.
extern "C" __attribute__((visibility("default")))
const frictionbeam::StressCodeDescription frictionbeam_stress_code;
