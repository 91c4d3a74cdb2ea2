// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "fibre_section.h"

namespace frictionbeam::section {

/// SDIRK2: the first stage is at gamma; the second begins at the start and this much of what the
/// first added.
constexpr double gamma_stage = 0.29289321881345247560, // 1 - 1/sqrt(2)
    whole_carry = (1. - gamma_stage) / gamma_stage;

using FibreStrains = double[n_fibre_strains];

/// A pipe in the course of an increment: at its start, in the first stage, at its end. Without
/// creep the end alone is looked at.
struct PipeCourse {
  const FibrePipe &start, &first, &end;
};

/**
 * One ring over an increment: one implicit step, or with creep the two of SDIRK2 (R. Alexander,
 * SIAM J. Numer. Anal. 14, 1977, 1006-1021, doi:10.1137/0714068): of order 2, L-stable, with
 * weights that make relaxation exact. Strains, pressure and temperature are straight over the
 * increment, time hardening is its mean over it.
 */
class RingIncrement {
public:
  RingIncrement(const PipeCourse &course, const FibrePlaces &places, const int number,
                const Creep *creep, const double *old_state)
      : course(course), pipe(course.end), places(places), number(number), n(pipe.layout.fibres),
        r(pipe.radius[number]), ring(n, pipe.G, {pipe.material, creep, pipe.E, pipe.hoop}),
        first(n, course.first.G, {course.first.material, creep, course.first.E, pipe.hoop}),
        old(old_state) {}

  /// One implicit step; whether there is an answer.
  bool step(const FibreStrains &strain) {
    begin(ring, strain, 1.);
    return ring.solve(r * strain[twist] - ring_state(0), ring_state(2));
  }

  /// Two stages.
  bool creep(const FibreStrains &old_strain, const double old_hoop, const FibreStrains &strain) {
    two_stages = true;
    FibreStrains middle;
    for (int k = 0; k < n_fibre_strains; ++k)
      middle[k] = old_strain[k] + gamma_stage * (strain[k] - old_strain[k]);
    first.fibre.hoop = old_hoop + gamma_stage * (pipe.hoop - old_hoop);
    begin(first, middle, gamma_stage);
    if (!first.solve(r * middle[twist] - ring_state(0), ring_state(2)))
      return false;
    begin(ring, strain, gamma_stage);
    set_weights(old_strain, old_hoop);
    double shear = 0.;
    for (int i = 0; i < n; ++i) {
      Fibre::Start &s = ring.start[i];
      s.share = 1. - gamma_stage * carry[i];
      s.trial -= pipe.E * carry[i] * first.axial(i);
      s.e += carry[i] * first.end[i].lambda * first.end[i].X;
      s.g += carry[i] * first.plastic_shear(i);
      s.h += carry[i] * first.plastic_hoop(i);
      s.p += carry[i] * first.end[i].dp;
      shear += carry[i] * first.shear(i);
    }
    if (!ring.solve(r * strain[twist] - ring_state(0) - shear / n, first.tau))
      return false;
    estimate_error();
    return true;
  }

  void write(double *state, LawOutput &out) const;
  void add_tangent(double *tangent) const;

  double error = 0., size = 0.; ///< largest ones of stress [Pa]

private:
  double ring_state(const int k) const { return old[pipe.layout.of_ring(number) + k]; }
  double z(const int i) const { return r * places.z[i]; }
  double y(const int i) const { return r * places.y[i]; }
  double strain_of(const int i, const FibreStrains &strain) const {
    return strain[axial_strain] + z(i) * strain[curvature_y] - y(i) * strain[curvature_z];
  }

  /// Starts of the fibres from the old state.
  void begin(Ring &stage, const FibreStrains &strain, const double share) const {
    const FibreLayout &at = pipe.layout;
    for (int i = 0; i < n; ++i) {
      const double *const f = old + at.of_fibre(number, i);
      const double e = at.g < 0 ? 0. : at.e < 0 ? f[0] : f[at.e];
      stage.start[i] = {stage.fibre.E * (strain_of(i, strain) - f[0]) - stage.fibre.hoop / 2.,
                        e,
                        at.g < 0 ? 0. : f[at.g],
                        at.h < 0 ? 0. : f[at.h],
                        f[1],
                        at.primary < 0 ? 0. : f[at.primary],
                        share};
    }
  }

  void set_weights(const FibreStrains &old_strain, const double old_hoop);
  void estimate_error();
  /// Work of the stage's stress on the inelastic strains of a fibre [J/m3].
  double work(const Ring &stage, const int i) const {
    return stage.end[i].x * stage.axial(i) + stage.fibre.hoop * stage.hoop(i) +
           stage.tau * stage.shear(i);
  }

  const PipeCourse &course;
  const FibrePipe &pipe; ///< at the end
  const FibrePlaces &places;
  const int number, n;
  const double r;
  Ring ring, first;
  double carry[most_fibres];                                   ///< times what the first stage added
  double old_x[most_fibres], old_q[most_fibres], old_tau = 0.; ///< at the start of the increment
  double relaxed[most_fibres][2]; ///< a stress that relaxes alone, after the stages
  double alone[most_fibres][2]; ///< q of a stress that relaxes alone, in the stages, over its first
  bool two_stages = false;
  const double *const old;
};

/**
 * What of the first stage the second begins with. SDIRK2's own is (1 - gamma) / gamma; times phi,
 *   phi = (s0 - s - E d(s)) / ((1 - gamma) (E d(s1) - E d(s))) = 1 + O(h),
 * it is still of order 2, and a stress s0 that relaxes by a power, to s1 in the first stage, ends
 * at the exact s = s0 (1 + (n-1) E d(s0)/s0)^(-1/(n-1)), however long the increment. n is that of
 * the doses at s0.
 */
inline void RingIncrement::set_weights(const FibreStrains &old_strain, const double old_hoop) {
  const Creep &creep = *ring.fibre.creep;
  const double E = pipe.E;
  old_tau = course.start.G * (r * old_strain[twist] - ring_state(0));
  for (int i = 0; i < n; ++i) {
    const double *const f = old + pipe.layout.of_fibre(number, i);
    const double x = course.start.E * (strain_of(i, old_strain) - f[0]) - old_hoop / 2.;
    const double s = std::sqrt(x * x + 0.75 * old_hoop * old_hoop + 3. * old_tau * old_tau);
    const double primary = ring.start[i].primary;
    const Creep::Dose dose = creep(s, primary);
    old_x[i] = x;
    old_q[i] = s > 0. ? dose.total / s : 0.;
    size = std::max(size, s);
    double phi = 1.;
    alone[i][0] = alone[i][1] = old_q[i];
    relaxed[i][0] = relaxed[i][1] = s;
    if (E * dose.slope > 1e-4 && s > 0.) {
      const double power = dose.slope * s / dose.total - 1., amount = E * dose.total / s;
      const double exact =
          s * std::exp(-(power < 1e-8 ? amount : std::log1p(power * amount) / power));
      const double middle = ring.fibre.relaxed(s, primary, gamma_stage);
      const double at_middle = creep(middle, primary).total, at_end = creep(exact, primary).total;
      const double difference = at_middle - at_end;
      relaxed[i][0] = middle;
      relaxed[i][1] = exact;
      alone[i][0] = at_middle / s;
      alone[i][1] = at_end / s;
      phi = difference > 0. ? ((s - exact) / E - at_end) / ((1. - gamma_stage) * difference) : 0.;
      phi = std::clamp(phi, gamma_stage / (1. - gamma_stage), 1.5);
    }
    carry[i] = whole_carry * phi;
  }
}

/**
 * What the rates of creep at the start and in both stages tell of the next term of the series, or
 * if that is less, of the term that SDIRK2 has; of the rates, or if that is less and relaxation is
 * exact, of what they differ by from it. And what doses that do not come evenly make of a stress
 * that changes from the first stage to the end, but for what it relaxes alone.
 */
inline void RingIncrement::estimate_error() {
  const auto smaller = [](const double k0, const double k1, const double k2) {
    const double bend = (k2 - k1) / (1. - gamma_stage) - (k1 - k0) / gamma_stage;
    return std::min(0.081 * std::abs(bend), gamma_stage * std::abs(k2 - k1));
  };
  double shear[3] = {}, shear_delayed[2] = {};
  const Creep &creep = *ring.fibre.creep;
  for (int i = 0; i < n; ++i) {
    const Fibre::End &a = first.end[i], &b = ring.end[i];
    const double share = ring.start[i].share;
    const double k0 = old_q[i] * old_x[i], k1 = a.q * a.x / gamma_stage, k2 = b.q * b.x / share;
    const double by_rates = smaller(k0, k1, k2),
                 by_others = smaller(0., k1 - alone[i][0] * old_x[i], k2 - alone[i][1] * old_x[i]);
    // Differences may vanish by chance: where the rates say that much happens, they are believed.
    const double share_of_stress = pipe.E * by_rates / std::max(b.s, std::abs(old_x[i]));
    double known = creep.relaxes_by_power()
                       ? std::min(by_rates, by_others + share_of_stress * by_rates)
                       : by_rates;
    if (!creep.comes_evenly()) {
      const double primary = ring.start[i].primary, way = std::copysign(1. - gamma_stage, old_x[i]);
      const Creep::Delayed from = creep.delayed(a.s, primary), to = creep.delayed(b.s, primary),
                           alone_from = creep.delayed(relaxed[i][0], primary),
                           alone_to = creep.delayed(relaxed[i][1], primary);
      const auto off = [&](double Creep::Delayed::*kind) {
        const double change = (to.*kind * b.x - from.*kind * a.x) / way,
                     of_alone =
                         (alone_to.*kind * relaxed[i][1] - alone_from.*kind * relaxed[i][0]) /
                         (1. - gamma_stage);
        return creep.relaxes_by_one_power()
                   ? std::min(std::abs(change),
                              std::abs(change - of_alone) + share_of_stress * std::abs(change))
                   : std::abs(change);
      };
      known += off(&Creep::Delayed::secondary) + off(&Creep::Delayed::primary);
      const double whole = 3. / (1. - gamma_stage) / n;
      shear_delayed[0] += whole * (to.secondary * ring.tau - from.secondary * first.tau);
      shear_delayed[1] += whole * (to.primary * ring.tau - from.primary * first.tau);
    }
    error = std::max(error, pipe.E * known);
    shear[0] += 3. * old_q[i] * old_tau / n;
    shear[1] += 3. * a.q * first.tau / gamma_stage / n;
    shear[2] += 3. * b.q * ring.tau / share / n;
    size = std::max(size, b.s);
  }
  error = std::max(error, std::sqrt(3.) * pipe.G *
                              (smaller(shear[0], shear[1], shear[2]) + std::abs(shear_delayed[0]) +
                               std::abs(shear_delayed[1])));
}

inline void RingIncrement::write(double *state, LawOutput &out) const {
  const FibreLayout &at = pipe.layout;
  const Material &m = ring.fibre.material;
  const double area = pipe.area[number], E = pipe.E, hoop = pipe.hoop;
  double lost = 0., springs = 0., hardening = 0., old_hardening = 0., shear = 0., hoop_strain = 0.,
         axial_strain = 0.;
  bool flows = false;
  for (int i = 0; i < n; ++i) {
    const Fibre::End &end = ring.end[i];
    const double *const f = old + at.of_fibre(number, i);
    double *const now = state + at.of_fibre(number, i);
    const auto sum = [&](double (Ring::*part)(int) const) {
      return (two_stages ? carry[i] * (first.*part)(i) : 0.) + (ring.*part)(i);
    };
    const double stress = end.x + hoop / 2.;
    out.stress[0] += area / n * stress;
    out.stress[4] += area / n * stress * z(i);
    out.stress[5] -= area / n * stress * y(i);
    springs += stress * stress / (2. * E);
    now[0] = f[0] + sum(&Ring::axial);
    now[1] = f[1] + (two_stages ? carry[i] * first.end[i].dp : 0.) + end.dp;
    flows = flows || now[1] != f[1] || two_stages;
    if (m.hardens_isotropically()) {
      hardening += m.stored(now[1]);
      old_hardening += m.stored(f[1]);
    }
    lost += (two_stages ? carry[i] * work(first, i) : 0.) + work(ring, i);
    shear += sum(&Ring::shear);
    hoop_strain += sum(&Ring::hoop);
    axial_strain += now[0];
    if (at.g >= 0) {
      now[at.g] = f[at.g] + sum(&Ring::plastic_shear);
      now[at.h] = f[at.h] + sum(&Ring::plastic_hoop);
      const int place_of_e = at.e >= 0 ? at.e : 0;
      if (at.e >= 0)
        now[at.e] = f[at.e] + (two_stages ? carry[i] * first.end[i].lambda * first.end[i].X : 0.) +
                    end.lambda * end.X;
      const auto stored = [&](const double *s) {
        return m.H * (s[place_of_e] * s[place_of_e] / 2. + 2. / 3. * s[at.h] * s[at.h] +
                      s[at.g] * s[at.g] / 6.);
      };
      hardening += stored(now);
      old_hardening += stored(f);
    }
    if (at.creep >= 0)
      now[at.creep] =
          f[at.creep] +
          (two_stages ? carry[i] * first.end[i].q * first.end[i].s + end.q * end.s : 0.);
    if (at.primary >= 0)
      now[at.primary] =
          f[at.primary] + (two_stages ? carry[i] * first.end[i].primary + end.primary : 0.);
  }
  out.stress[3] += area * r * ring.tau;
  double *const of_ring = state + at.of_ring(number);
  of_ring[0] = ring_state(0) + shear / n;
  of_ring[1] = ring_state(1) + hoop_strain / n;
  of_ring[2] = ring.tau;
  out.stored_energy += area * ((springs + hardening) / n + ring.tau * ring.tau / (2. * pipe.G) -
                               hoop * (of_ring[1] - axial_strain / n / 2.));
  if (flows)
    out.dissipation += area * std::max(0., lost / n - (hardening - old_hardening) / n);
}

inline void RingIncrement::add_tangent(double *tangent) const {
  const double E = pipe.E, area = pipe.area[number];
  Fibre::Change unit_trial, unit_tau;
  unit_trial.trial = unit_tau.tau = 1.;
  // What shear follows at constant tau, per unit of each strain; what one of tau brings.
  double first_shear[n_fibre_strains] = {}, first_by_tau = 0.;
  double first_tau[n_fibre_strains] = {};
  if (two_stages) {
    for (int i = 0; i < n; ++i) {
      const double of_strain[n_fibre_strains] = {1., 0., z(i), -y(i)};
      const double g = first.fibre.change(first.end[i], first.tau, unit_trial).g;
      for (int k = 0; k < n_fibre_strains; ++k)
        first_shear[k] += gamma_stage * first.fibre.E * of_strain[k] * g / n;
      first_by_tau += first.fibre.change(first.end[i], first.tau, unit_tau).g / n;
    }
    for (int k = 0; k < n_fibre_strains; ++k)
      first_tau[k] =
          ((k == twist ? gamma_stage * r : 0.) - first_shear[k]) / (1. / first.G + first_by_tau);
  }
  double C[n_fibre_strains][n_fibre_strains] = {}; // at constant tau
  double of_tau[n_fibre_strains] = {};             // stresses per tau
  double shear[n_fibre_strains] = {}, by_tau = 1. / pipe.G;
  for (int i = 0; i < n; ++i) {
    const double of_strain[n_fibre_strains] = {1., 0., z(i), -y(i)};
    Fibre::Tangent one = {0., 0., 0.};
    if (ring.at_apex) // fibres go on as they did
      one.x_by_trial = 1. / (1. + E * ring.end[i].lambda);
    else if (two_stages) {
      const Fibre::Response more = ring.fibre.change(ring.end[i], ring.tau, unit_tau);
      one = {0., more.x, more.g};
    } else
      one = ring.fibre.plastic_tangent(ring.end[i]);
    by_tau += one.g_by_tau / n;
    Fibre::Response started, started_by_tau; // first stage, per trial and per tau
    if (two_stages) {
      started = first.fibre.change(first.end[i], first.tau, unit_trial);
      started_by_tau = first.fibre.change(first.end[i], first.tau, unit_tau);
    }
    for (int k = 0; k < n_fibre_strains; ++k) {
      double dx = E * of_strain[k] * one.x_by_trial, dg = -of_strain[k] * one.x_by_tau;
      if (two_stages) {
        const double by_trial = gamma_stage * first.fibre.E * of_strain[k];
        const auto carried = [&](double Fibre::Response::*part) {
          return carry[i] * (by_trial * started.*part + first_tau[k] * started_by_tau.*part);
        };
        Fibre::Change given;
        given.trial = E * (of_strain[k] - carried(&Fibre::Response::e));
        given.e = carried(&Fibre::Response::e_p);
        given.g = carried(&Fibre::Response::g_p);
        given.h = carried(&Fibre::Response::h_p);
        given.p = carried(&Fibre::Response::p);
        const Fibre::Response response = ring.fibre.change(ring.end[i], ring.tau, given);
        dx = response.x;
        dg = response.g + carried(&Fibre::Response::g);
      }
      shear[k] += dg / n;
      for (int l = 0; l < n_fibre_strains; ++l)
        C[l][k] += area / n * of_strain[l] * dx;
    }
    for (int l = 0; l < n_fibre_strains; ++l)
      of_tau[l] += area / n * of_strain[l] * one.x_by_tau;
  }
  of_tau[twist] = area * r;
  for (int k = 0; k < n_fibre_strains; ++k) {
    const double tau = ring.at_apex ? 0. : ((k == twist ? r : 0.) - shear[k]) / by_tau;
    for (int l = 0; l < n_fibre_strains; ++l)
      tangent[n_section_strains * fibre_strain_place[l] + fibre_strain_place[k]] +=
          C[l][k] + of_tau[l] * tau;
  }
}

} // namespace frictionbeam::section
