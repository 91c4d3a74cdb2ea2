// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law_conformance.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace frictionbeam {

namespace {

using Vector = std::vector<double>;

struct Result {
  Vector stress, tangent, state;
  double dissipation = 0.;
  LawStatus status = LawStatus::ok;
};

/// One increment of a strain path.
struct Increment {
  Vector strain, previous_strain, old_state;
  double time;
};

class Checker {
public:
  Checker(const LawDescription &law, const Vector &parameters) : law(law), parameters(parameters) {}

  std::vector<std::string> violations;

  void walk(const double magnitude, const unsigned int seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Increment increment{Vector(law.n_strains, 0.), Vector(law.n_strains, 0.),
                        Vector(law.n_internal_variables, 0.), 0.};
    for (unsigned int step = 0; step < 40; ++step) {
      increment.previous_strain = increment.strain;
      for (double &e : increment.strain)
        e = magnitude * uniform(random);
      increment.strain[0] -= 0.5 * magnitude; // more often in compression than open
      increment.time += time_increment;
      const Result result = evaluate(increment, LawTangent::consistent);
      if (result.status != LawStatus::ok)
        continue;
      check_increment(increment, result);
      increment.old_state = result.state;
    }
  }

private:
  static constexpr double length = 0.5, time_increment = 0.25;

  Result evaluate(const Increment &increment, const LawTangent tangent) const {
    Vector rate(law.n_strains), displacement(3, 0.);
    for (int i = 0; i < law.n_strains; ++i)
      rate[i] = (increment.strain[i] - increment.previous_strain[i]) / time_increment;
    for (int i = 0; i < 3; ++i)
      displacement[i] = increment.strain[i] * length;
    Result result{Vector(law.n_strains), Vector(law.n_strains * law.n_strains),
                  Vector(law.n_internal_variables)};
    const LawInput input{parameters.data(),
                         increment.strain.data(),
                         rate.data(),
                         law.kind == LawKind::support ? displacement.data() : nullptr,
                         length,
                         increment.time,
                         time_increment,
                         20.,
                         increment.old_state.data(),
                         tangent};
    LawOutput output{result.stress.data(), result.tangent.data(), result.state.data(), 0.,
                     ContactStatus::none};
    result.status = law.law->integrate(input, output);
    result.dissipation = output.dissipation;
    return result;
  }

  void violated(const std::string &what) {
    if (std::find(violations.begin(), violations.end(), what) == violations.end())
      violations.push_back(what);
  }

  static double size(const Vector &v) {
    double sum = 0.;
    for (const double x : v)
      sum += x * x;
    return std::sqrt(sum);
  }

  void check_increment(const Increment &increment, const Result &result) {
    const Increment before = increment;
    const Result again = evaluate(increment, LawTangent::consistent);
    if (again.stress != result.stress || again.tangent != result.tangent ||
        again.state != result.state || again.dissipation != result.dissipation)
      violated("equal calls give different results: keep no memory in the law");
    if (increment.old_state != before.old_state)
      violated("the old state is written: write new_state only");
    for (const Vector *values : {&result.stress, &result.tangent, &result.state})
      for (const double x : *values)
        if (!std::isfinite(x))
          violated("a result is not a finite number");
    if (result.dissipation < -1e-12 * size(result.stress) * size(increment.strain))
      violated("dissipation is negative");
    check_commit(increment, result);
    check_tangent(increment, result);
  }

  void check_commit(const Increment &increment, const Result &result) {
    Increment committed = increment;
    committed.old_state = result.state;
    const Result repeated = evaluate(committed, LawTangent::none);
    for (int i = 0; i < law.n_strains; ++i)
      if (std::abs(repeated.stress[i] - result.stress[i]) > 1e-9 * size(result.stress))
        violated("stress " + std::to_string(i) +
                 " changes when evaluated again after the commit: new_state does not belong to it");
  }

  void check_tangent(const Increment &increment, const Result &result) {
    const int n = law.n_strains;
    const double h = 1e-6 * size(increment.strain);
    for (int j = 0; j < n; ++j) {
      const auto moved = [&](const double step) {
        Increment other = increment;
        other.strain[j] += step;
        return evaluate(other, LawTangent::none).stress;
      };
      const Vector up = moved(h), down = moved(-h);
      double column = 0.;
      for (int i = 0; i < n; ++i)
        column = std::max({column, std::abs(result.tangent[n * i + j]), std::abs(up[i] - down[i]) / (2 * h)});
      for (int i = 0; i < n; ++i) {
        const double forward = (up[i] - result.stress[i]) / h;
        const double backward = (result.stress[i] - down[i]) / h;
        const double rounding = 1e-14 * size(result.stress) / h;
        if (std::abs(forward - backward) > 1e-3 * column + rounding)
          continue; // a kink lies between
        if (std::abs(result.tangent[n * i + j] - (forward + backward) / 2) >
            1e-4 * column + 10. * rounding)
          violated("tangent (" + std::to_string(i) + ", " + std::to_string(j) +
                   ") is not the derivative of the stress");
      }
      for (int i = 0; law.symmetric_tangent && i < n; ++i)
        if (std::abs(result.tangent[n * i + j] - result.tangent[n * j + i]) > 1e-9 * column)
          violated("the tangent is announced as symmetric and is not");
    }
  }

  const LawDescription &law;
  const Vector &parameters;
};

} // namespace

std::vector<std::string> check_law(const LawDescription &law,
                                   const std::vector<double> &parameters) {
  Checker checker(law, parameters);
  for (const double magnitude : {1e-6, 1e-3, 0.1, 1.})
    for (const unsigned int seed : {1u, 2u, 3u})
      checker.walk(magnitude, seed);
  return checker.violations;
}

} // namespace frictionbeam
