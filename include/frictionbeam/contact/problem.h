// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/check.h>
#include <frictionbeam/contact/site_list.h>

#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace frictionbeam::contact {

struct Settings {
  double tolerance = 1e-10;        ///< of the residual, relative to the largest force
  double contact_tolerance = 1e-8; ///< of the contact laws, each contact on its own scale
  /// Called in every iteration, if given: it may throw to end a solution that takes too long.
  std::function<void()> in_each_iteration = {};
};

/// What of the sites differs from their laws in an increment: on velocities instead of
/// displacements in nonsmooth time steps.
struct Overrides {
  std::vector<double> gap;            ///< [m]; far for sites that do not take part
  std::vector<double> friction_scale; ///< on the coefficient
  /// On the patch's radius, beside it; empty: 1. Where forces of friction are impulses, moments,
  /// which are elastic, are not.
  std::vector<double> patch_scale = {};
};

/// Find q with  A q + sum weight B^T stress(B q + imposed strain) = right_hand_side.
struct Problem {
  const SparseMatrix &matrix;
  Vector right_hand_side;
  Increment increment = {};
  const Overrides *overrides = nullptr; ///< of exact sites
  double largest_force = 0.; ///< to measure residuals by, beside those of the problem itself
  /// right_hand_side - matrix (unknowns + low), where the caller knows it in a cheaper way. Of the
  /// right hand side nothing but its size is then asked.
  std::function<Vector(const Vector &unknowns, const Vector &low)> unbalanced = {};
  /// Largest force of the load sequence so far, beside which rounding is rounding even where all
  /// loads are taken off.
  double force_so_far = 0.;
  unsigned int most_iterations = std::numeric_limits<unsigned int>::max(); ///< give up after
  /// Stresses of exact sites to begin from, where the caller knows better than the method. A
  /// matrix that is not positive definite has several solutions: the nearest is the one meant.
  const std::vector<Strains> *forces_before = nullptr;
};

/// What of the sites' strains is not the unknowns': of ground that moves.
struct ImposedMotion {
  std::vector<Strains> strain; ///< empty: none
  double displacement = 0.;    ///< the largest that makes them, for its rounding [m]
};

struct Result {
  bool converged = false;
  unsigned int iterations = 0, factorizations = 0;
  unsigned int back_substitutions = 0; ///< with a matrix of all unknowns
  double residual = 0.;                ///< relative to the largest force
  std::optional<Check> check;          ///< of methods that solve exact contact laws
  bool no_equilibrium = false;         ///< proved: something slides or lifts off freely
  bool rounding_bars = false;          ///< not converged, and no smaller increment would
  std::string remark;                  ///< why not converged
  Vector free_motion;                  ///< that nothing resists, where there is no equilibrium
};

/// f - A q without the sites' forces, in extended precision, where q = unknowns + low.
Vector unbalanced_forces(const Problem &problem, const Vector &unknowns, const Vector &low);

/// Why an increment ends whose forces rounding keeps from vanishing, in words without a full stop.
/// @param left what is unbalanced [N] @param largest force of the problem [N]
std::string too_much_rounding(const double left, const double largest);

/// When residual forces count as zero: below the tolerance times the largest force, or below the
/// rounding error of the forces themselves where that is larger, but never above 1e-8 of the
/// largest force, of the sequence so far.
class Balance {
public:
  Balance(const Problem &problem, const SiteList &sites) : problem(problem), sites(sites) {}

  /// right_hand_side - A q - forces of the response.
  /// @param low what rounding took from the unknowns; may be empty.
  Vector left(const Vector &unknowns, const Vector &low, const Response &response) const;
  double largest_force(const Response &response) const;
  /// @param diagonal of the tangent, for the rounding error of A q
  double tolerance(const double relative, const Vector &diagonal, const Vector &unknowns,
                   const Response &response) const;
  /// Of A q, by the same diagonal.
  static double rounding(const Vector &diagonal, const Vector &unknowns);

private:
  const Problem &problem;
  const SiteList &sites;
};

} // namespace frictionbeam::contact
