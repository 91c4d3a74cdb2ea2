// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law_closed_form.h>
#include <frictionbeam/law_conformance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace frictionbeam {

namespace {

using Vector = std::vector<double>;

struct Result {
  Vector stress, tangent, state;
  double dissipation = 0.;
  LawStatus status = LawStatus::ok;
  ContactStatus contact = ContactStatus::none;
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
  LawReach reached;

  void walk(const double magnitude, const unsigned int seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Increment increment{Vector(law.n_strains, 0.), Vector(law.n_strains, 0.),
                        Vector(law.n_internal_variables, 0.), 0.};
    for (unsigned int step = 0; step < 40; ++step) {
      increment.previous_strain = increment.strain;
      if (step % 3 == 2) // a little way from where it is: what slips may stick
        for (double &e : increment.strain)
          e += 0.05 * magnitude * uniform(random);
      else {
        for (double &e : increment.strain)
          e = magnitude * uniform(random);
        increment.strain[0] -= 0.5 * magnitude; // more often in compression than open
      }
      increment.time += time_increment;
      const Result result = evaluate(increment, LawTangent::consistent);
      if (result.status != LawStatus::ok) {
        ++reached.failed;
        continue;
      }
      count(result);
      check_increment(increment, result);
      increment.old_state = result.state;
    }
  }

private:
  void count(const Result &result) {
    ++reached.increments;
    const ContactStatus contact = result.contact;
    reached.stick += contact == ContactStatus::stick;
    reached.slip += contact == ContactStatus::slip;
    reached.open += contact == ContactStatus::open;
    reached.closed += contact == ContactStatus::closed;
    const bool dissipates = result.dissipation > 0.;
    reached.dissipating += dissipates;
    reached.elastic += !dissipates && size(result.stress) > 0.;
  }

  static constexpr double length = 0.5, time_increment = 0.25;

  Result evaluate(const Increment &increment, const LawTangent tangent,
                  const double dt = time_increment) const {
    Vector rate(law.n_strains), displacement(3, 0.);
    for (int i = 0; i < law.n_strains; ++i)
      rate[i] = (increment.strain[i] - increment.previous_strain[i]) / time_increment;
    for (int i = 0; i < 3; ++i)
      displacement[i] = increment.strain[i] * length;
    // Not a number until the law writes it.
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Result result{Vector(law.n_strains, nan), Vector(law.n_strains * law.n_strains, nan),
                  Vector(law.n_internal_variables, nan)};
    const LawInput input{parameters.data(),
                         increment.strain.data(),
                         rate.data(),
                         law.kind == LawKind::support ? displacement.data() : nullptr,
                         length,
                         increment.time,
                         dt,
                         20.,
                         increment.old_state.data(),
                         tangent};
    LawOutput output{result.stress.data(), result.tangent.data(), result.state.data(), 0.,
                     ContactStatus::none};
    result.status = law.law->integrate(input, output);
    result.dissipation = output.dissipation;
    result.contact = output.contact;
    return result;
  }

  void violated(const std::string &what) {
    if (std::find(violations.begin(), violations.end(), what) == violations.end())
      violations.push_back(what);
  }

  /// Rounding of stresses that are differences of strains times a rigidity.
  double rounding(const Increment &increment) const {
    double rigidity = 0.;
    for (const double x : evaluate(increment, LawTangent::elastic).tangent)
      rigidity = std::max(rigidity, std::abs(x));
    return 1e-15 * rigidity * size(increment.strain);
  }

  static bool all_finite(const Vector &v) {
    return std::all_of(v.begin(), v.end(), [](const double x) { return std::isfinite(x); });
  }

  static double size(const Vector &v) {
    double sum = 0.;
    for (const double x : v)
      sum += x * x;
    return std::sqrt(sum);
  }

  void check_increment(const Increment &increment, const Result &result) {
    const Increment before = increment;
    for (const Vector *values : {&result.stress, &result.tangent, &result.state})
      if (!all_finite(*values))
        return violated("a result is not a finite number, or not written");
    const Result again = evaluate(increment, LawTangent::consistent);
    if (again.stress != result.stress || again.tangent != result.tangent ||
        again.state != result.state || again.dissipation != result.dissipation)
      violated("equal calls give different results: keep no memory in the law");
    const Result plain = evaluate(increment, LawTangent::none);
    const Result elastic = evaluate(increment, LawTangent::elastic);
    for (const Result *other : {&plain, &elastic})
      if (other->stress != result.stress || other->state != result.state)
        violated("stress or state depend on the tangent that is asked for");
    if (!std::all_of(plain.tangent.begin(), plain.tangent.end(),
                     [](const double x) { return std::isnan(x); }))
      violated("a tangent is written with LawTangent::none, where there may be no room for it");
    if (!all_finite(elastic.tangent))
      violated("the elastic tangent is not finite, or not written");
    if (increment.old_state != before.old_state)
      violated("the old state is written: write new_state only");
    if (result.dissipation < -1e-12 * size(result.stress) * size(increment.strain))
      violated("dissipation is negative");
    check_commit(increment, result);
    check_tangent(increment, result);
  }

  void check_commit(const Increment &increment, const Result &result) {
    Increment committed = increment;
    committed.old_state = result.state;
    const Result repeated = evaluate(committed, LawTangent::none);
    const double tolerance = 1e-9 * size(result.stress) + 2. * rounding(increment);
    for (int i = 0; i < law.n_strains; ++i)
      if (std::abs(repeated.stress[i] - result.stress[i]) > tolerance)
        violated("stress " + std::to_string(i) +
                 " changes when evaluated again after the commit: new_state does not belong to it");

    // An empty increment: nothing moves, no time passes.
    committed.previous_strain = committed.strain;
    const Result held = evaluate(committed, LawTangent::none, 0.);
    if (held.status != LawStatus::ok)
      return;
    if (held.dissipation >
        1e-9 * (result.dissipation + size(result.stress) * size(increment.strain)))
      violated("it dissipates when evaluated again after the commit though nothing moves: is the "
               "slip of the wrong sign?");
    committed.old_state = held.state;
    const Result still = evaluate(committed, LawTangent::none, 0.);
    for (int i = 0; i < law.n_internal_variables; ++i) {
      const double first = result.state[i] - increment.old_state[i];
      const double again = held.state[i] - result.state[i];
      const double further = still.state[i] - held.state[i]; // a rate falls to zero once
      if (first * again > 0. && std::abs(again) > 0.5 * std::abs(first) && again * further > 0. &&
          std::abs(further) > 0.5 * std::abs(again))
        violated("internal variable " + std::to_string(i) +
                 " goes on changing when evaluated again after the commit though nothing moves");
    }
  }

  void check_tangent(const Increment &increment, const Result &result) {
    const int n = law.n_strains;
    const double h = 1e-6 * size(increment.strain);
    const double rounding = (1e-14 * size(result.stress) + this->rounding(increment)) / h;
    for (int j = 0; j < n; ++j) {
      const auto moved = [&](const double step) {
        Increment other = increment;
        other.strain[j] += step;
        return evaluate(other, LawTangent::none).stress;
      };
      const Vector up = moved(h), down = moved(-h);
      double column = 0.;
      for (int i = 0; i < n; ++i)
        column = std::max(
            {column, std::abs(result.tangent[n * i + j]), std::abs(up[i] - down[i]) / (2 * h)});
      for (int i = 0; i < n; ++i) {
        const double forward = (up[i] - result.stress[i]) / h;
        const double backward = (result.stress[i] - down[i]) / h;
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

std::vector<std::string> check_law(const LawDescription &law, const std::vector<double> &parameters,
                                   LawReach &reached) {
  Checker checker(law, parameters);
  for (const double magnitude : {1e-6, 1e-3, 0.1, 1.})
    for (const unsigned int seed : {1u, 2u, 3u})
      checker.walk(magnitude, seed);
  reached = checker.reached;
  if (reached.increments == 0)
    checker.violations.push_back("it fails in every increment of the test");
  for (const std::string &fault : closed_form_faults(law, parameters))
    checker.violations.push_back(fault);
  return checker.violations;
}

std::vector<std::string> check_law(const LawDescription &law,
                                   const std::vector<double> &parameters) {
  LawReach reached;
  return check_law(law, parameters, reached);
}

} // namespace frictionbeam
