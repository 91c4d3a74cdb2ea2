// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/contact/condensation.h>
#include <frictionbeam/contact/problem.h>

namespace frictionbeam::contact {

/// A contact whose friction exceeds the limit up to which its state is unique.
struct BeyondUniqueness {
  unsigned int contact;
  double friction, limit;
};

/// From where the travelling front of the next problem is predicted, and how well that went.
struct PredictionMemory {
  std::vector<ContactStatus> status;    ///< of the last solution
  Vector motion;                        ///< of the kept unknowns in the last increment
  unsigned int failures = 0, pause = 0; ///< in a row; problems to go without
  int further = 0;                      ///< contacts that fronts go beyond where they are predicted
};

/// What a solver keeps from one problem to the next and the solutions depend on.
struct WarmStart {
  double first_factor = 0., stiffness_factor = 0.; ///< c that was good the last time, and the last
  std::vector<Strains> centre;                     ///< stresses to begin from
  std::vector<double> friction, friction_scale, gap; ///< of the last increment
  std::vector<Block> factored;                       ///< tangents that factors are there of
  PredictionMemory prediction;
};

/**
 * Exact contact: Signorini's condition and Coulomb's law without a stiffness to choose.
 *
 * The system is condensed to the unknowns of its contacts, and solved there: by Newton's method on
 * motions and forces together, by proximal steps where that stalls, and from elsewhere. On
 * a line, the states of contacts are predicted first, front by front. The iteration ends when the
 * contact laws themselves, judged without the proximal term, hold: each contact's natural-map
 * residual on its own scale. Neither a small change from step to step nor the convergence of an
 * inner solve decides (doc/theory.md, "Exact contact").
 *
 * Sites whose law has no closed form are return-mapped beside them.
 */
class ExactSolver {
public:
  /**
   * @param sites must outlive this and stay where they are
   * @param condensation of the matrix of the following problems, keeping what the sites touch
   * @param diagonal of that matrix, on all unknowns
   */
  ExactSolver(Settings settings, SiteList sites, std::unique_ptr<Condensation> condensation,
              const Vector &diagonal);
  ~ExactSolver();

  /**
   * @param unknowns in: first guess; out: the solution, as they were if there is none
   * @param response of the sites at the solution
   */
  Result solve(const Problem &problem, const ImposedMotion &imposed, const State &committed,
               Vector &unknowns, Response &response);

  /// Take these stresses for the first guess of the next problem, in place of the last solution's.
  void guess(const std::vector<Strains> &stress);
  /// Whether friction is so large that one contact of a line has several states by itself, all
  /// others held.
  bool may_jam() const;
  /// From one run of a program to another; factorizations are made again.
  WarmStart warm_start() const;
  void restore(const WarmStart &memory);

  /**
   * Contacts of the last solution with f >= K_tt/|K_tn|, where K = [K_nn K_tn; K_tn K_tt] is the
   * stiffness at the contact, all other contacts held as they are: closed ones in their normal,
   * sticking ones in their plane, too; K_tt/|K_tn| is the least of all directions in the plane that
   * are not held. For one contact the limit is sharp (several equilibria exist above it); for many
   * it is a warning.
   *
   * One factorization and three solutions a contact: quadratic in the number of contacts. See
   * doc/theory.md, "Exact contact", several equilibria.
   */
  std::vector<BeyondUniqueness> beyond_uniqueness(const std::vector<ContactStatus> &status) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation;
};

} // namespace frictionbeam::contact
