// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "creep.h"
#include "pipe_material.h"

namespace frictionbeam::section {

/**
 * One fibre of a pipe's wall, in plane stress: axial s_x, hoop s_h, shear tau. In
 *
 *   x = s_x - s_h/2,   s^2 = x^2 + 3/4 s_h^2 + 3 tau^2  (von Mises)
 *
 * inelastic strains e (axial), h (hoop plus half the axial) and g (shear) grow apart from each
 * other: creep by q = d(s)/s as q (x, 3/4 s_h, 3 tau), plastic flow by lambda = dp/R as
 * lambda (X, 3/4 B, 3 W), where X = x - H e_p, B = s_h - 4/3 H h_p, W = tau - H g_p/3 are free of
 * the back stress, and X^2 + 3/4 B^2 + 3 W^2 = R(p)^2.
 */
struct Fibre {
  /// At the start of a stage.
  struct Start {
    double trial;      ///< x if nothing flows
    double e, g, h, p; ///< plastic strains of the back stress; accumulated
    double primary;    ///< creep strain, at the start of the increment
    double share;      ///< of the increment's creep that belongs to the stage
  };

  /// At its end.
  struct End {
    double x, q, lambda; ///< stress; creep and flow
    double X, W, B, c;   ///< over c = 1 + H lambda
    double R, R_slope;
    double s, q_slope; ///< von Mises, dq/ds; 0 without creep
    double dp, primary;
  };

  /// Changes of the start and of tau, and what follows of them.
  struct Change {
    double trial = 0., e = 0., g = 0., h = 0., p = 0., tau = 0.;
  };
  struct Response {
    double x, e, g;          ///< stress; inelastic strains, all
    double e_p, g_p, h_p, p; ///< plastic ones
  };

  const Material &material;
  const Creep *creep; ///< null: none
  double E, hoop;

  /// @param guess of dp; 0: that of tension.
  void solve(const Start &start, const double tau, const double guess, End &end) const;
  Response change(const End &end, const double tau, const Change &given) const;

  /// A stress in tension that creeps away for this share of the increment, implicitly.
  double relaxed(const double stress, const double primary, const double share) const {
    Fibre alone = *this;
    alone.hoop = 0.;
    End end;
    end.lambda = 0.;
    alone.balance({stress, 0., 0., 0., 0., primary, share}, 0., end);
    return end.x;
  }

  /// Where a fibre without creep stands at a guess of dp and tau, which need not be in balance.
  struct Guess {
    double shear, by_tau; ///< g, and its derivative at constant dp
    double more, per_tau; ///< of dp to be in balance, by Newton's method; and by tau
    double by_dp;         ///< derivative of g
  };
  /// @param dp in: the guess, 0: that of tension; out: 0 if it does not yield
  Guess guess(const Start &start, const double tau, double &dp) const;

  /// Without creep: stress by trial and by tau; shear by tau. Shear by trial is -x_by_tau / E.
  struct Tangent {
    double x_by_trial, x_by_tau, g_by_tau;
  };
  Tangent plastic_tangent(const End &end) const;

private:
  class Search;
  void solve_plastic(const Start &start, const double tau, const double guess, End &end) const;
  /// Of R/S - 1 by dp. @param S_slope of S by lambda, times -S
  static double residual_slope(const End &end, const double S, const double S_slope) {
    return (end.R_slope + S_slope * (end.R - end.dp * end.R_slope) / (end.R * S * S)) / S;
  }
  /// Let all but flow be in balance at lambda; the norm of X, B, W.
  double balance(const Start &start, const double tau, End &end) const;
  /// Derivative of x by the fibre's balance at constant lambda.
  double balance_slope(const End &end) const {
    return 1. + E * (end.q + (end.s > 0. ? end.q_slope * end.x * end.x / end.s : 0.) +
                     end.lambda / end.c);
  }
};

inline double Fibre::balance(const Start &start, const double tau, End &end) const {
  const double H = material.H;
  end.c = 1. + H * end.lambda;
  const double factor = 1. + E * end.lambda / end.c;
  const double load = start.trial + E * H * end.lambda / end.c * start.e;
  const double others = 0.75 * hoop * hoop + 3. * tau * tau;
  end.x = load / factor;
  end.q = end.q_slope = end.primary = end.s = 0.;
  double low = 0., high = std::abs(end.x);
  if (creep != nullptr)
    for (int i = 0; i < 200; ++i) { // in the logarithm of x, from above
      end.s = std::sqrt(end.x * end.x + others);
      const Creep::Dose dose = (*creep)(end.s, start.primary);
      end.q = end.s > 0. ? start.share * dose.total / end.s : start.share * dose.slope;
      end.q_slope = end.s > 0. ? (start.share * dose.slope - end.q) / end.s : 0.;
      end.primary = start.share * dose.primary;
      if (load == 0.)
        break;
      const double all = factor + E * end.q;
      const double slope = 1. + (end.s > 0. ? E * end.q_slope * end.x * end.x / end.s / all : 0.);
      const double residual = std::log(end.x * all / load);
      (residual < 0. ? low : high) = std::abs(end.x);
      if (!(std::abs(residual) > 4e-16 * slope) || !(low < high))
        break;
      double next = std::abs(end.x) * std::exp(-residual / slope);
      if (!(next < high && next > low) || i > 30)
        next = low > 0. ? std::sqrt(low) * std::sqrt(high) : next < high ? next : high / 2.;
      if (next == std::abs(end.x))
        break;
      end.x = std::copysign(next, end.x);
    }
  end.X = (end.x - H * start.e) / end.c;
  end.W = (tau - H * start.g / 3.) / end.c;
  end.B = (hoop - 4. / 3. * H * start.h) / end.c;
  return std::sqrt(end.X * end.X + 0.75 * end.B * end.B + 3. * end.W * end.W);
}

/// R/S - 1 = 0 is nearly straight in dp; negative at 0, and it rises.
class Fibre::Search {
public:
  explicit Search(const double guess) : dp(guess) {}

  double dp;

  /// The next dp from the residual here and its slope; whether this one is good enough.
  bool finds(const double residual, const double slope) {
    if (is_last || std::abs(residual) < 5e-16 || n++ > 200)
      return true;
    (residual < 0. ? low : high) = dp;
    double next = dp - residual / slope;
    const bool is_newton = next > low && next < high;
    if (!is_newton)
      next = std::isinf(high) ? 2. * low : (low + high) / 2.;
    // The residual is square in the step: after a small one, it is nothing.
    is_last = std::abs(next - dp) <= (is_newton ? 1e-9 : 2e-16) * dp;
    dp = next;
    return false;
  }

private:
  double low = 0., high = std::numeric_limits<double>::infinity();
  bool is_last = false;
  int n = 0;
};

inline void Fibre::solve(const Start &start, const double tau, const double guess, End &end) const {
  end.lambda = end.dp = 0.;
  end.R = material.yield(start.p);
  end.R_slope = material.slope(start.p);
  if (creep == nullptr)
    return solve_plastic(start, tau, guess, end);
  const double H = material.H;
  double S = balance(start, tau, end);
  if (S <= end.R)
    return;
  for (Search search(guess > 0. ? guess : (S - end.R) / (E + H + end.R_slope));;) {
    end.dp = search.dp;
    end.R = material.yield(start.p + end.dp);
    end.R_slope = material.slope(start.p + end.dp);
    end.lambda = end.dp / end.R;
    S = balance(start, tau, end);
    const double x_slope = -E * end.X / (end.c * balance_slope(end));
    const double S_slope =
        (end.X * (H * end.X - x_slope) + H * (0.75 * end.B * end.B + 3. * end.W * end.W)) /
        end.c; // times -S, by lambda
    if (search.finds(end.R / S - 1., residual_slope(end, S, S_slope)))
      return;
  }
}

inline void Fibre::solve_plastic(const Start &start, const double tau, const double guess,
                                 End &end) const {
  const double H = material.H;
  const double X = start.trial - H * start.e, W = tau - H / 3. * start.g,
               B = hoop - 4. / 3. * H * start.h;
  const double others = 0.75 * B * B + 3. * W * W, square = X * X + others;
  end.q = end.q_slope = end.primary = end.s = 0.;
  double of_X = 1., of_others = 1.;
  if (square > end.R * end.R)
    for (Search search(guess > 0. ? guess : (std::sqrt(square) - end.R) / (E + H + end.R_slope));
         ;) {
      end.dp = search.dp;
      end.R = material.yield(start.p + end.dp);
      end.R_slope = material.slope(start.p + end.dp);
      end.lambda = end.dp / end.R;
      of_X = 1. / (1. + (E + H) * end.lambda);
      of_others = 1. / (1. + H * end.lambda);
      const double X2 = X * X * of_X * of_X, others2 = others * of_others * of_others;
      const double S = std::sqrt(X2 + others2);
      const double S_slope = (E + H) * X2 * of_X + H * others2 * of_others;
      if (search.finds(end.R / S - 1., residual_slope(end, S, S_slope)))
        break;
    }
  end.c = 1. + H * end.lambda;
  end.X = X * of_X;
  end.x = end.X * end.c + H * start.e;
  end.W = W * of_others;
  end.B = B * of_others;
}

inline Fibre::Guess Fibre::guess(const Start &start, const double tau, double &dp) const {
  const double H = material.H;
  const double X = start.trial - H * start.e, W = tau - H / 3. * start.g,
               B = hoop - 4. / 3. * H * start.h;
  const double others = 0.75 * B * B + 3. * W * W, square = X * X + others;
  double R = material.yield(start.p), slope = material.slope(start.p);
  if (square <= R * R) {
    dp = 0.;
    return {0., 0., 0., 0., 0.};
  }
  if (!(dp > 0.))
    dp = (std::sqrt(square) - R) / (E + H + slope);
  R = material.yield(start.p + dp);
  slope = material.slope(start.p + dp);
  const double of_R = 1. / R, lambda = dp * of_R, lambda_by_dp = (1. - lambda * slope) * of_R;
  const double of_X = 1. / (1. + (E + H) * lambda), of_others = 1. / (1. + H * lambda);
  const double X2 = X * X * of_X * of_X, others2 = others * of_others * of_others;
  const double of_S2 = 1. / (X2 + others2), of_S = std::sqrt(of_S2);
  const double S_by_lambda = (E + H) * X2 * of_X + H * others2 * of_others; // times -S
  const double residual_by_dp = (slope + R * S_by_lambda * lambda_by_dp * of_S2) * of_S;
  const double of_residual = 1. / residual_by_dp, W_now = 3. * W * of_others;
  return {lambda * W_now, 3. * lambda * of_others, (1. - R * of_S) * of_residual,
          R * W_now * of_others * of_S2 * of_S * of_residual, W_now * of_others * lambda_by_dp};
}

inline Fibre::Tangent Fibre::plastic_tangent(const End &end) const {
  if (end.lambda == 0.)
    return {1., 0., 0.};
  const double H = material.H, of_X = 1. / (1. + (E + H) * end.lambda), of_others = 1. / end.c;
  const double X2 = end.X * end.X;
  const double D = (E + H) * X2 * of_X + H * (end.R * end.R - X2) * of_others +
                   end.R * end.R * end.R_slope / (1. - end.lambda * end.R_slope);
  const double x = end.X * of_X, w = 3. * end.W * of_others, of_D = 1. / D;
  return {1. - E * (end.lambda * of_X + x * x * of_D), -E * x * w * of_D,
          3. * end.lambda * of_others + w * w * of_D};
}

inline Fibre::Response Fibre::change(const End &end, const double tau, const Change &given) const {
  const double H = material.H;
  const double x_over_s = end.s > 0. ? end.x / end.s : 0.;
  const double tau_over_s = end.s > 0. ? 3. * tau / end.s : 0.;
  // Balance: b_x dx + b_l dlambda = b.
  const double b_x = balance_slope(end), b_l = E * end.X / end.c;
  const double b = given.trial + E * end.lambda * H / end.c * given.e -
                   E * end.x * end.q_slope * tau_over_s * given.tau;
  double dx = b / b_x, dl = 0.;
  if (end.lambda > 0.) { // and the yield condition, halved: y_x dx + y_l dlambda = y
    const double own = 1. / (1. - end.lambda * end.R_slope);
    const double y_x = end.X / end.c;
    const double y_l = -end.R * end.R * (H / end.c + end.R_slope * own);
    const double y =
        (end.X * H * given.e - 3. * end.W * (given.tau - H / 3. * given.g) + end.B * H * given.h) /
            end.c +
        end.R * end.R_slope * own * given.p;
    const double determinant = b_x * y_l - b_l * y_x;
    dx = (b * y_l - b_l * y) / determinant;
    dl = (b_x * y - b * y_x) / determinant;
  }
  const double dq = end.q_slope * (x_over_s * dx + tau_over_s * given.tau);
  const double dX = (dx - H * given.e - H * end.X * dl) / end.c;
  const double dW = (given.tau - H / 3. * given.g - H * end.W * dl) / end.c;
  const double dB = (-4. / 3. * H * given.h - H * end.B * dl) / end.c;
  Response r;
  r.x = dx;
  r.e_p = dl * end.X + end.lambda * dX;
  r.g_p = 3. * (dl * end.W + end.lambda * dW);
  r.h_p = 0.75 * (dl * end.B + end.lambda * dB);
  r.p = end.lambda > 0.
            ? (end.R * dl + end.lambda * end.R_slope * given.p) / (1. - end.lambda * end.R_slope)
            : 0.;
  r.e = r.e_p + dq * end.x + end.q * dx;
  r.g = r.g_p + 3. * (dq * tau + end.q * given.tau);
  return r;
}

} // namespace frictionbeam::section
