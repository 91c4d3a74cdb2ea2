// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/bound_law.h>
#include <frictionbeam/law_library.h>

#include "../check.h"

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

/// A law of sections with its parameters and its state, driven by strains, by stresses, or by some
/// of either.
class SectionProbe {
public:
  using Six = std::array<double, 6>;
  using Values = std::map<std::string, double>;
  enum Component { N, Vy, Vz, T, My, Mz };

  SectionProbe(const frictionbeam::LawDescription &law, const Values &values)
      : law(law, law_parameters(law, values)), state(this->law.n_internal_variables(), 0.),
        new_state(state) {}

  /// To the end of an increment from the committed state.
  bool evaluate(const double dt = 0.,
                const frictionbeam::LawTangent wanted = frictionbeam::LawTangent::consistent) {
    const Six rate{};
    frictionbeam::LawOutput output{stress.data(), tangent.data(), new_state.data(), 0.,
                                   frictionbeam::ContactStatus::none};
    increment.length = dt;
    increment.time = time + dt;
    const auto status =
        law.integrate(strain.data(), rate.data(), 1., increment, state.data(), wanted, output);
    dissipation = output.dissipation;
    stored = output.stored_energy;
    error = output.error;
    return status == frictionbeam::LawStatus::ok;
  }

  void commit() {
    std::swap(state, new_state);
    time += increment.length;
  }

  /// Evaluate and commit.
  bool move(const Six &to, const double dt = 0.) {
    strain = to;
    const bool has_answer = evaluate(dt);
    commit();
    return has_answer;
  }

  /// Find the strains at which these stresses are reached, the others as they are; and commit.
  /// @param spring stress falls with the strain by as much
  bool reach(const std::map<int, double> &wanted, const double dt = 0., const double spring = 0.) {
    for (int iteration = 0; iteration < 100; ++iteration) {
      if (!evaluate(dt))
        return false;
      double A[6][7] = {}, size = 0.;
      for (int i = 0; i < 6; ++i)
        if (wanted.count(i) == 0)
          A[i][i] = 1.;
        else {
          for (int j = 0; j < 6; ++j)
            A[i][j] = wanted.count(j) == 0 ? 0. : tangent[6 * i + j] + (i == j ? spring : 0.);
          A[i][6] = wanted.at(i) - spring * strain[i] - stress[i];
        }
      solve(A);
      for (int i = 0; i < 6; ++i) {
        strain[i] += A[i][6];
        size = std::max(size, std::abs(A[i][6]) / (1e-3 + std::abs(strain[i])));
      }
      if (!(size > 1e-14)) {
        const bool has_answer = std::isfinite(size) && evaluate(dt);
        commit();
        return has_answer;
      }
      if (iteration > 30 && size < 1e-12) {
        commit();
        return true;
      }
    }
    return false;
  }

  /// Largest difference of the tangent to difference quotients, and to its transpose, over its
  /// largest entry.
  std::array<double, 2> tangent_errors(const double h) {
    evaluate(increment.length);
    const Six at = strain;
    const auto C = tangent;
    std::array<double, 2> result{};
    double size = 0.;
    for (int j = 0; j < 6; ++j) {
      strain = at;
      strain[j] += h;
      evaluate(increment.length, frictionbeam::LawTangent::none);
      const Six up = stress;
      strain[j] -= 2. * h;
      evaluate(increment.length, frictionbeam::LawTangent::none);
      for (int i = 0; i < 6; ++i) {
        size = std::max(size, std::abs(C[6 * i + j]));
        result[0] = std::max(result[0], std::abs((up[i] - stress[i]) / (2. * h) - C[6 * i + j]));
        result[1] = std::max(result[1], std::abs(C[6 * j + i] - C[6 * i + j]));
      }
    }
    strain = at;
    return {result[0] / size, result[1] / size};
  }

  frictionbeam::BoundLaw law;
  frictionbeam::LawIncrement increment; ///< temperature and pressure may be set
  std::vector<double> state, new_state;
  Six strain{}, stress{};
  std::array<double, 36> tangent{};
  double dissipation = 0., stored = 0., error = 0., time = 0.;

private:
  /// Gauss with pivots; the answer is the last column.
  static void solve(double (&A)[6][7]) {
    for (int c = 0; c < 6; ++c) {
      int pivot = c;
      for (int i = c + 1; i < 6; ++i)
        if (std::abs(A[i][c]) > std::abs(A[pivot][c]))
          pivot = i;
      for (int j = 0; j < 7; ++j)
        std::swap(A[c][j], A[pivot][j]);
      for (int i = 0; i < 6; ++i) {
        const double factor = i == c ? 0. : A[i][c] / A[c][c];
        for (int j = c; j < 7; ++j)
          A[i][j] -= factor * A[c][j];
      }
    }
    for (int i = 0; i < 6; ++i)
      A[i][6] /= A[i][i];
  }
};

inline const double pi = std::acos(-1.);

/// A thin tube, whose ring of fibres has the radius r and the area 2 pi r t exactly.
struct Tube {
  double r = 0.1, t = 0.005, E = 2e11, nu = 0.3, sy = 2e8;

  double A() const { return 2. * pi * r * t; }
  double Np() const { return A() * sy; }
  double Mp() const { return 4. * r * r * t * sy; }
  double ey() const { return sy / E; }
  double ky() const { return ey() / r; }
  double outer() const { return std::sqrt(r * r + r * t); }
  double inner() const { return std::sqrt(r * r - r * t); }
  double wall() const { return outer() - inner(); }
  /// That makes this hoop stress.
  double pressure(const double hoop) const { return 2. * hoop * wall() / (outer() + inner()); }

  SectionProbe::Values values(const SectionProbe::Values &more = {}) const {
    SectionProbe::Values result{{"Young's modulus", E},
                                {"Poisson ratio", nu},
                                {"Outside diameter", 2. * outer()},
                                {"Wall thickness", wall()},
                                {"Yield stress", sy},
                                {"Fibres", 63.},
                                {"Radii", 1.}};
    for (const auto &[name, value] : more)
      result[name] = value;
    return result;
  }
  SectionProbe::Values of_the_whole() const {
    const double G = E / (2. * (1. + nu)), I = pi * r * r * r * t;
    return {{"Axial rigidity", E * A()},
            {"Shear rigidity", G * A() / 2.},
            {"Torsional rigidity", 2. * G * I},
            {"Bending rigidity", E * I},
            {"Outside diameter", 2. * r + t},
            {"Wall thickness", t},
            {"Yield stress", sy}};
  }
};

/// Prints what was reached, for the page.
inline void near(const char *what, const double value, const double reference,
                 const double tolerance) {
  std::cout << what << ": " << std::setprecision(9) << value << ", exact " << reference << ", "
            << std::setprecision(2) << (reference == 0. ? value : value / reference - 1.) << '\n';
  CHECK_NEAR(value, reference, tolerance);
}
