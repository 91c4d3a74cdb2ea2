// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "impulse_contacts.h"
#include "motion_products.h"

#include <frictionbeam/analysis/line_factorization.h>

namespace frictionbeam {

/**
 * The generalized-alpha family in the form of Arnold and Bruels (Multibody Syst. Dyn. 18 (2007)
 * 185-202): the equation of motion holds at the end of the step with the acceleration A, and
 *   (1 - alpha_m) a1 + alpha_m a0 = (1 - alpha_f) A1 + alpha_f A0,
 *   q1 = q0 + h v0 + h^2 ((1/2 - beta) a0 + beta a1),   v1 = v0 + h ((1 - gamma) a0 + gamma a1).
 * Newmark's method is alpha_m = alpha_f = 0, a = A.
 *
 * With `impulses`, rigid contacts act by impulses P outside of the accelerations (Bruels, Acary,
 * Cardona, CMAME 281 (2014) 131-161): M w = P, v1 gains w and q1 gains h (beta/gamma) w. (There it
 * is h/2, the same without numerical damping; with beta/gamma, q1 and v1 hang together as without
 * impact, and the step is one static contact problem.) Without, all contacts are friction elements
 * of finite stiffness with their return mapping. Either way elements of finite stiffness are
 * followed to second order.
 */
class AlphaScheme final : public TimeIntegrator {
public:
  struct Parameters {
    double alpha_m = 0., alpha_f = 0., beta = 0.25, gamma = 0.5;
    bool impulses = false;
    std::string name;
  };
  static Parameters newmark(const TimeSettings &settings);
  /// Of Chung and Hulbert, by the spectral radius (J. Appl. Mech. 60 (1993) 371-375).
  static Parameters generalized_alpha(const TimeSettings &settings);
  static Parameters nonsmooth(const TimeSettings &settings);

  AlphaScheme(const Model &model, const Parameters &parameters);

  std::string name() const override { return p.name; }
  void start(LineState &state, const LoadCourse &loads) override;
  TimeStep advance(const LineState &from, const LoadCourse &loads, const double time,
                   LineState &to) override;
  void transfer(Archive &archive) override;
  std::string warning() const override;

private:
  void set_step(const double step);
  Vector contact_forces(const LineState &state) const;
  /// Where friction elements would not carry, at the displacements of @p state, the contact forces
  /// that it has, since another method took them for rigid: give them the elastic shear that does,
  /// and the line the displacements at which they balance what they balanced.
  void settle(LineState &state, const Vector &imposed) const;

  const Model &model;
  const Parameters p;
  const double ratio; ///< (1 - alpha_m)/(1 - alpha_f)
  const std::vector<bool> has_mass;
  std::unique_ptr<EquilibriumSolver> return_mapping; ///< null with impulses
  ImpulseContacts contacts;
  LineFactorization mass;
  SparseMatrix effective; ///< K + gamma/(beta h) C + ratio/(beta h^2) M
  Vector diagonal;        ///< of it
  double effective_step = 0.;
  KeptProduct stiff, momentum;     ///< K q and M v
  const Vector stiffness_diagonal; ///< of K
};

} // namespace frictionbeam
