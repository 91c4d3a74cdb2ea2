// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene/scene.h"

#include <functional>
#include <memory>

namespace frictionbeam {

/// A place of the line as a stress code sees it. SI units.
struct StressPoint {
  enum class Part { straight, bend, run_of_tee, branch_of_tee } part = Part::straight;
  double diameter = 0., wall = 0.; ///< outer; nominal wall
  double corrosion = 0.;           ///< allowance
  double bend_radius = 0.;         ///< of a bend
  double youngs_modulus = 0.;      ///< for pressure stiffening
  double stiffening_pressure = 0.; ///< of a bend
  Tee::Kind tee = Tee::Kind::welding;
  double pad = 0., crotch_radius = 0.;
  double run_diameter = 0., run_wall = 0.;        ///< of a tee
  double allowable_cold = 0., allowable_hot = 0.; ///< Sc, Sh
};

/// Forces on a cross section: axial (tension > 0), in-plane and out-of-plane bending, torsion.
struct StressForces {
  double axial = 0.;                                     ///< without what pressure does [N]
  double in_plane = 0., out_of_plane = 0., torsion = 0.; ///< [N m]
  double pressure = 0.;                                  ///< inside [Pa]
};

/**
 * A piping code: stresses of a place under given forces and what it allows. Another code is another
 * class behind this interface and a line in make_stress_code().
 */
class StressCode {
public:
  virtual ~StressCode() = default;

  virtual std::string name() const = 0; ///< with its edition

  /// Stress intensification factors in and out of the plane, >= 1.
  struct Factors {
    double in_plane = 1., out_of_plane = 1.;
  };
  virtual Factors intensification(const StressPoint &point) const = 0;

  /// A stress at one place by the forces there [Pa], with all that the place decides worked out: to
  /// be evaluated at every instant of a motion. Convex in the forces.
  using Formula = std::function<double(const StressForces &)>;
  /// Longitudinal stress of weight, pressure and what else is sustained or occasional.
  virtual Formula sustained(const StressPoint &point) const = 0;
  /// Of the difference of the forces of two states.
  virtual Formula expansion_range(const StressPoint &point) const = 0;

  virtual double allowed_sustained(const StressPoint &point) const = 0;
  virtual double allowed_occasional(const StressPoint &point,
                                    const StressSettings &settings) const = 0;
  /// @param sustained_stress SL there, for the liberal allowable range.
  virtual double allowed_range(const StressPoint &point, const StressSettings &settings,
                               const double sustained_stress) const = 0;
};

/// The code of that name, as in Stress/Code.
std::unique_ptr<const StressCode> make_stress_code(const std::string &name);

/// Flexibility characteristic and factors of a bend by ASME B31.3, appendix D.
struct BendFactors {
  double h = 0., k = 1., in_plane = 1., out_of_plane = 1.;
};
/// @param pressure that stiffens it [Pa]; the factors are >= 1.
BendFactors b31_3_bend(const double diameter, const double wall, const double bend_radius,
                       const double youngs_modulus, const double pressure);

} // namespace frictionbeam
