// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "fibre.h"

namespace frictionbeam::section {

constexpr int most_fibres = 255;

/**
 * A thin ring of fibres under one shear stress, for the axial balance of the wall asks for it: what
 * is left of their laws is one equation,
 *   tau/G + mean of the fibres' g = trial,
 * whose left side rises with tau by 1/G at least.
 */
struct Ring {
  int n;
  double G;
  Fibre fibre;
  Fibre::Start start[most_fibres];
  Fibre::End end[most_fibres];
  double tau = 0.;
  /// Nothing but shear, at its limit: tau does not change, and fibres flow as they did.
  bool at_apex = false;

  Ring(const int n, const double G, const Fibre &fibre) : n(n), G(G), fibre(fibre) {}

  /// @param trial shear strain of the ring less the inelastic one at the start.
  /// @param guess of tau; 0: none
  /// @return whether there is an answer.
  bool solve(const double trial, const double guess) {
    at_apex = false;
    tau = guess;
    return fibre.material.is_perfect() ? solve_perfect(trial) : solve_any(trial);
  }

  double plastic_shear(const int i) const { return 3. * end[i].lambda * end[i].W; }
  double shear(const int i) const { return 3. * end[i].q * tau + plastic_shear(i); }
  double axial(const int i) const { return end[i].q * end[i].x + end[i].lambda * end[i].X; }
  double plastic_hoop(const int i) const { return 0.75 * end[i].lambda * end[i].B; }
  double hoop(const int i) const { return 0.75 * end[i].q * fibre.hoop + plastic_hoop(i); }

private:
  bool solve_any(const double trial);
  bool approach(const double trial);
  bool solve_perfect(const double trial);
  void set_perfect(const double Q, const double R, const double more);
};

/// Newton's method on tau and the dp of all fibres at once, without creep: next to nothing is left
/// for the nested search, which makes sure of the answer. @return whether it has converged; if not,
/// tau is as it was
inline bool Ring::approach(const double trial) {
  constexpr int most = 12;
  constexpr double small_change = 1e-8; // whose square is rounding
  const double first = tau;
  double more[most_fibres], per_tau[most_fibres];
  for (int k = 0; k < most; ++k) {
    double rest = 0., slope = 0.;
    for (int i = 0; i < n; ++i) {
      const Fibre::Guess at = fibre.guess(start[i], tau, end[i].dp);
      rest += at.shear + at.by_dp * at.more;
      slope += at.by_tau + at.by_dp * at.per_tau;
      more[i] = at.more;
      per_tau[i] = at.per_tau;
    }
    const double change = (trial - tau / G - rest / n) / (1. / G + slope / n);
    tau += change;
    bool is_small = std::abs(change) <= small_change * std::abs(tau);
    for (int i = 0; i < n; ++i) {
      const double of_dp = more[i] + per_tau[i] * change;
      is_small = is_small && std::abs(of_dp) <= small_change * end[i].dp;
      end[i].dp = std::max(end[i].dp + of_dp, 0.);
    }
    if (is_small)
      return true;
    if (!std::isfinite(tau))
      break;
  }
  tau = first;
  return false;
}

inline bool Ring::solve_any(const double trial) {
  Fibre::Change of_tau;
  of_tau.tau = 1.;
  for (int i = 0; i < n; ++i)
    end[i].dp = 0.;
  const auto residual = [&](double &slope) {
    double sum = 0.;
    slope = 0.;
    for (int i = 0; i < n; ++i) {
      fibre.solve(start[i], tau, end[i].dp, end[i]);
      sum += shear(i);
      if (fibre.creep != nullptr)
        slope += fibre.change(end[i], tau, of_tau).g;
      else if (end[i].lambda > 0.)
        slope += fibre.plastic_tangent(end[i]).g_by_tau;
    }
    slope = 1. / G + slope / n;
    return tau / G + sum / n - trial;
  };
  bool is_sheared = trial != 0.;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i) {
    is_sheared = is_sheared || start[i].g != 0.;
    least = std::min(least, fibre.material.yield(start[i].p));
  }
  double slope;
  if (!is_sheared) {
    tau = 0.;
    const double rest = residual(slope);
    return std::isfinite(rest);
  }
  const double elastic = G * trial;
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  if (tau == 0.)
    tau = fibre.material.H > 0. ? elastic
                                : std::copysign(std::min(std::abs(elastic), least / 2.), elastic);
  if (fibre.creep == nullptr && !approach(trial))
    for (int i = 0; i < n; ++i)
      end[i].dp = 0.;
  bool is_last = false;
  for (int i = 0; i < 200; ++i) {
    const double rest = residual(slope);
    if (!std::isfinite(rest))
      return false;
    if (is_last || rest == 0.)
      return true;
    (rest < 0. ? low : high) = tau;
    // The other bound follows from the least slope.
    if (rest < 0.)
      high = std::min(high, tau - 1.0001 * G * rest);
    else
      low = std::max(low, tau - 1.0001 * G * rest);
    double next = tau - rest / slope;
    const bool is_newton = next > low && next < high;
    if (!is_newton)
      next = (low + high) / 2.;
    if (next == tau || std::abs(rest) <= 1e-16 * std::abs(trial))
      return true;
    is_last = std::abs(next - tau) <= (is_newton ? 1e-9 : 4e-16) * std::abs(tau);
    tau = next;
  }
  return false;
}

/// With Q^2 = R^2 - 3/4 s_h^2 - 3 tau^2 a fibre that yields has |x| = Q, lambda = (|x*|/Q - 1)/E.
inline bool Ring::solve_perfect(const double trial) {
  const double R = fibre.material.first_yield(), E = fibre.E,
               others = 0.75 * fibre.hoop * fibre.hoop;
  const double largest = R * R - others;
  if (!(largest > 0.))
    return false;
  const double limit = std::sqrt(largest / 3.), wanted = std::abs(trial);
  double size = 0.;
  for (int i = 0; i < n; ++i)
    size = std::max(size, std::abs(start[i].trial));
  // Sum of lambda, and of (1 + E lambda) of those that yield.
  const auto flow = [&](const double Q, double &yielding) {
    double sum = 0.;
    for (int i = 0; i < n; ++i) {
      const double over = std::abs(start[i].trial);
      sum += over > Q ? over : 0.;
      yielding += over > Q ? 1. : 0.;
    }
    return sum / Q;
  };
  /// Of a shear stress of this size.
  const auto residual = [&](const double size_of_tau, const double Q, double &slope) {
    double yielding = 0.;
    const double sum = flow(Q, yielding);
    slope = 1. / G + 3. * (sum - yielding) / (E * n) +
            9. * size_of_tau * size_of_tau * sum / (E * Q * Q * n);
    return size_of_tau / G + 3. * size_of_tau * (sum - yielding) / (E * n) - wanted;
  };

  tau = 0.;
  double Q = std::sqrt(largest), value = 0., slope;
  if (wanted > 0.) {
    // From tau as long as it is well below its limit, from Q as soon as that is small.
    const double middle = 0.7 * limit;
    const bool from_tau = residual(middle, std::sqrt(largest - 3. * middle * middle), slope) >= 0.;
    if (!from_tau && (size <= 1e-14 * R || residual(limit, 1e-150 * R, slope) < 0.)) {
      const double elastic = G * wanted;
      at_apex = elastic > limit;
      tau = std::copysign(std::min(elastic, limit), trial);
      set_perfect(at_apex ? R : std::sqrt(largest - 3. * tau * tau), R,
                  at_apex ? (wanted - limit / G) / (3. * limit) : 0.);
      return true;
    }
    double low = from_tau ? 0. : std::sqrt(1e-300), high = from_tau ? middle : 1.;
    const double Q_of_middle = std::sqrt(largest - 3. * middle * middle);
    // Unknown: tau, or 1/Q, in which the flow is straight where Q is small.
    if (!from_tau) {
      low = 1. / Q_of_middle;
      high = std::numeric_limits<double>::infinity();
    }
    double unknown = from_tau ? std::min(middle, G * wanted) : low;
    for (int i = 0; i < 300; ++i) {
      value = from_tau ? unknown : std::sqrt(std::max(0., largest - 1. / (unknown * unknown)) / 3.);
      Q = from_tau ? std::sqrt(largest - 3. * unknown * unknown) : 1. / unknown;
      const double rest = residual(value, Q, slope);
      if (!from_tau)
        slope *= 1. / (3. * value * unknown * unknown * unknown);
      if (rest == 0.)
        break;
      (rest < 0. ? low : high) = unknown;
      double next = unknown - rest / slope;
      if (!(next > low && next < high))
        next = std::isinf(high) ? 2. * low : (low + high) / 2.;
      if (std::abs(next - unknown) <= 2e-16 * unknown || next == low || next == high)
        break;
      unknown = next;
    }
    tau = std::copysign(value, trial);
  }
  set_perfect(Q, R, 0.);
  return true;
}

inline void Ring::set_perfect(const double Q, const double R, const double more) {
  for (int i = 0; i < n; ++i) {
    Fibre::End &e = end[i];
    const double trial = start[i].trial, over = std::abs(trial);
    const bool yields = over > Q;
    e.q = e.q_slope = e.primary = e.s = e.R_slope = 0.;
    e.c = 1.;
    e.R = R;
    e.lambda = yields ? (over / Q - 1.) / fibre.E : more;
    e.x = e.X = yields ? std::copysign(Q, trial) : trial / (1. + fibre.E * more);
    e.W = tau;
    e.B = fibre.hoop;
    e.dp = e.lambda * R;
  }
}

} // namespace frictionbeam::section
