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
 * with theta = 1/2.
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
  void set_step(const double step);

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
