// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/increment/motion_piece.h"
#include "model/model.h"
#include "results/results.h"

#include <Eigen/Core>

#include <memory>

namespace frictionbeam {

class SmoothCourses;
struct EnvelopeTools;
struct EnvelopeStresses;

/**
 * Gathers the envelopes of transient steps: at every instant that the analysis reports, not only at
 * those of output, the least and largest values of support forces, reactions, section forces and
 * displacements, the stresses of the code's formulas and the use of nozzles. The start of a step is
 * the first of its instants. Whatever is not linear in the forces (sizes, stresses, ratios) is
 * evaluated at each instant, and not made of extremes of different ones. Integrators that know the
 * motion between their instants (MotionPiece) have its extremes there as well.
 */
class Envelope {
public:
  /// @param results that know their supports, restraints and points; the envelopes go there
  Envelope(const Model &model, Results &results);
  ~Envelope();

  /// To be called after every increment of the analysis. @param line_is_known of a reduced line,
  /// whether the state is that of the whole line
  void observe(const unsigned int step, const unsigned int increment,
               const unsigned int n_increments, const LineState &state,
               const bool line_is_known = true);

  /// To be called with the instant observed last once more, behind a jump. What closes there is
  /// known to strike, or not, at the end of the time step.
  void observe_behind_jump(const LineState &state, const bool line_is_known);

  /// To be called with every smooth piece of a motion, before its end is observed. Whatever is a
  /// polynomial in time has its extremes at roots of the derivative; sizes, stresses and ratios are
  /// searched for by golden sections of the same polynomials. Of a reduced line only in steps
  /// that need the whole one.
  void observe_piece(const MotionPiece &piece);

  /// Whether a step's answer depends on the whole line at every instant: stresses and combinations.
  /// Elsewhere the section forces of a reduced line are looked at where they are known anyway;
  /// supports and reactions at every instant.
  bool needs_line(const unsigned int step) const;

  /// What was gathered so far, with the envelopes.
  void transfer(Archive &archive);

private:
  struct Places;
  struct Size;

  void begin(const unsigned int step, const LineState &state);
  /// Make what evaluates states of a step.
  void prepare(const unsigned int step);
  void include(const LineState &state, const bool line_is_known);
  void include_supports(const LineState &state);
  void include_line(const LineState &state);
  void include_reactions(const double time, const std::vector<Motion> &reactions);
  void include_displacements(const LineState &state);
  /// @param forces six of each of the stations from @p first on
  void include_forces(const double time, const unsigned int first, const double *const forces,
                      const unsigned int n_stations);
  /// What of a state is a polynomial in time within a smooth piece: six numbers a support, the sum
  /// of their normal forces, six a restraint and a point, three a node of the pipes, six a station,
  /// and those of a frame where combinations want them.
  Eigen::VectorXd numbers_at(const LineState &state);
  /// Of which kind each of these is.
  Eigen::VectorXd kinds_of_numbers(const LineState &state);
  /// Call use(number, least, least_at, largest, largest_at) for each of them that has an envelope.
  template <typename Use>
  void for_each_number(const Use &use);
  /// Call use(size, least and largest so far, take(instant, value)) for each size that is made of
  /// such numbers.
  template <typename Use>
  void for_each_size(const MotionPiece &piece, const SmoothCourses &courses, const Use &use);
  template <typename Use>
  void for_each_size_of_supports(const MotionPiece &piece, const SmoothCourses &courses,
                                 const Use &use);
  template <typename Use>
  void for_each_size_of_restraints(const SmoothCourses &courses, const Use &use);
  static Size norm_of(const SmoothCourses &courses, const unsigned int first, const unsigned int n);
  /// Whether anything may be larger or smaller within these courses than it is known to be.
  bool may_widen(const MotionPiece &piece, const SmoothCourses &courses,
                 const Eigen::VectorXd &sizes);
  /// Whether a rigid contact closed in the time step.
  bool strikes(const LineState &state, const unsigned int support) const;
  /// Whether its force at this instant is then the impulse over the length of the time step:
  /// `event` keeps them apart.
  bool is_impulse(const LineState &state, const unsigned int i) const;
  double previous_impulse_of(const unsigned int support) const; ///< [N s]

  const Model &model;
  Results &results;
  std::unique_ptr<EnvelopeTools>
      tools; ///< what makes numbers of states; null before the first step
  std::unique_ptr<EnvelopeStresses> stresses; ///< of the step at hand
  std::vector<ContactStatus> previous_status;
  std::vector<double> previous_impulse;
  std::array<double, 5> sizes_met{}; ///< of numbers of each kind, in the pieces of the step
};

} // namespace frictionbeam
