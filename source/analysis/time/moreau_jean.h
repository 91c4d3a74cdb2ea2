// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "analysis/time/impulse_contacts.h"
#include "analysis/time/motion_products.h"

#include <limits>

namespace frictionbeam {

/**
 * Moreau and Jean's time stepping (Jean, CMAME 177 (1999) 235-257): with x_theta = theta x1 +
 * (1 - theta) x0,
 *   M (v1 - v0) = h (f - C v - K q - elastic contact forces)_theta + P,   q1 = q0 + h v_theta,
 * and rigid contacts as impulses P on v1 (ImpulseContacts). Order 1 where they act, 2 elsewhere
 * with theta = 1/2 (doc/dynamics.md, "Rigid contact on velocities").
 */
class MoreauJean final : public TimeIntegrator {
public:
  explicit MoreauJean(const Model &model);

  std::string name() const override {
    return model.scene.time.row().word +
           std::string(": rigid contact and friction by impulses on velocities");
  }
  void start(LineState &state, const LoadCourse &loads) override;
  TimeStep advance(const LineState &from, const LoadCourse &loads, const double time,
                   LineState &to) override;
  void transfer(Archive &archive) override;
  std::string warning() const override;

private:
  /// A step on its way to its solution.
  struct Step {
    double h = 0.;                ///< its length [s]
    Vector forces_before, forces; ///< of loads, at its start and its end
    Vector stiff_before, momentum_before;
    Vector known; ///< forces of the equation of motion, divided by theta h, but for those of q1, v1
    Vector velocity_after;
  };

  void set_step(const double step);
  /// Forces of the loads behind the jump that there may be at @p time, the start of a step.
  const Vector &forces_after(const LoadCourse &loads, const double time);
  Step begin(const LineState &from, const LoadCourse &loads, const double time);
  /// What residuals of the step are measured by [N].
  double size_of(const Step &step, const LineState &from) const;
  /// What the equation of motion, divided by theta h, leaves at the end of the step but for the
  /// contacts' forces.
  /// @param low what rounding took from the unknowns; may be empty
  Vector unbalanced(Step &step, const LineState &from, const Vector &unknowns, const Vector &low);

  const Model &model;
  const double theta;
  std::vector<int> massless; ///< unknowns
  ImpulseContacts contacts;
  SparseMatrix effective; ///< K + C/(h theta) + M/(h theta)^2
  double effective_step = 0.;
  LoadCourse::Factors last_factors; ///< of the last end of a step
  double last_time = std::numeric_limits<double>::quiet_NaN();
  Vector last_forces;
  KeptProduct stiff, momentum;     ///< K q and M v
  const Vector stiffness_diagonal; ///< of K
};

} // namespace frictionbeam
