// SPDX-License-Identifier: LGPL-2.1-or-later
#include "law_driver.h"

#include <frictionbeam/law_closed_form.h>
#include <frictionbeam/law_conformance.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace frictionbeam {

namespace {

using namespace conformance;

class Checker : public LawDriver {
public:
  using LawDriver::LawDriver;

  std::vector<std::string> violations;
  LawReach reached;

  void walk(const double magnitude, const unsigned int seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Increment increment = from_rest();
    pressure = pressures[seed % 3];
    for (unsigned int step = 0; step < 40; ++step) {
      increment.previous_strain = increment.strain;
      if (step % 3 == 2) // a little way from where it is: what slips may stick
        for (int i = 0; i < law.n_strains; ++i)
          increment.strain[i] += 0.05 * magnitude * scale[i] * uniform(random);
      else {
        for (int i = 0; i < law.n_strains; ++i)
          increment.strain[i] = magnitude * scale[i] * uniform(random);
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

  /// What a law of sections tells besides: its elastic bound, its energies, many at once.
  void check_section(const double magnitude, const unsigned int seed) {
    if (!is_section)
      return;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    pressure = pressures[seed % 3];
    check_elastic_tangent();
    Increment increment = from_rest();
    for (unsigned int draw = 0; draw < 20; ++draw) {
      for (int i = 0; i < law.n_strains; ++i)
        increment.strain[i] = magnitude * scale[i] * uniform(random);
      check_elastic_bound(increment);
      check_all_at_once(increment);
    }
    for (const double dt : {0., time_increment})
      check_energy(increment.strain, dt);
  }

  /// A law of supports tells no stored energy. On a way from where it is open back to there it
  /// stores nothing: the work of its stress is what it dissipates, but for what it lets go at once
  /// where it breaks loose.
  void check_support(const double magnitude) {
    if (law.kind != LawKind::support)
      return;
    for (const double time : {0., time_increment})
      for (const double across : {0.1, 1.})
        for (const std::vector<Vector> &way : ways_of(magnitude, across * magnitude)) {
          const double once = made_energy(way, time, 100), twice = made_energy(way, time, 200);
          // What the increments make of it halves with them.
          if (std::abs(2. * twice - once) > most_lost && std::abs(twice) > most_lost / 2.)
            violated("on a way that begins and ends open, its stress does other work than it "
                     "dissipates: " +
                     std::string(twice > 0.
                                     ? "its dissipation is too large, or it makes energy out "
                                       "of nothing"
                                     : "its dissipation is too small"));
        }
  }

private:
  static constexpr double most_lost = 0.1; ///< of the work that was done either way

  /// Whether a result is of numbers; said if not.
  bool is_finite(const Result &result) {
    const bool all =
        all_finite(result.stress) && all_finite(result.state) && std::isfinite(result.dissipation);
    if (!all)
      violated("a result is not a finite number, or not written, in statics (time_increment is 0: "
               "do not divide by it), in a small step or where nothing moves");
    return all;
  }

  /// Dissipation less work of the stress, over the sum of what the work moved, along a way. 0 if it
  /// is not open at either end.
  /// @param time each side takes
  double made_energy(const std::vector<Vector> &corners, const double time, const int n_steps) {
    Increment increment = from_rest();
    increment.strain = corners[0];
    Result last = evaluate(increment, LawTangent::none, 0.);
    const auto is_free = [](const Result &result) {
      return result.status == LawStatus::ok && result.contact == ContactStatus::open &&
             size(result.stress) == 0.;
    };
    if (!is_free(last))
      return 0.;
    const bool twists = std::any_of(corners.begin(), corners.end(),
                                    [](const Vector &corner) { return corner[3] != 0.; });
    double made = 0., moved = 0.;
    for (std::size_t corner = 1; corner < corners.size(); ++corner)
      for (int step = 1; step <= n_steps; ++step) {
        const double place = double(step) / n_steps;
        increment.previous_strain = increment.strain;
        for (int i = 0; i < law.n_strains; ++i)
          increment.strain[i] = (1. - place) * corners[corner - 1][i] + place * corners[corner][i];
        increment.old_state = last.state;
        increment.time += time / n_steps;
        const Result now = evaluate(increment, LawTangent::none, time / n_steps);
        if (now.status != LawStatus::ok || !is_finite(now))
          return 0.;
        if (now.contact == ContactStatus::stick && !twists &&
            now.dissipation > 1e-9 * size(now.stress) * size(increment.strain))
          violated("it says that it sticks, and dissipates");
        for (int i = 0; i < law.n_strains; ++i) {
          const double work = (last.stress[i] + now.stress[i]) / 2. *
                              (increment.strain[i] - increment.previous_strain[i]);
          made -= work;
          moved += std::abs(work);
        }
        made += now.dissipation;
        last = now;
      }
    return is_free(last) && moved > 0. ? made / moved : 0.;
  }

  void check_elastic_bound(const Increment &increment) {
    if (law.elastic_bound == nullptr)
      return;
    Arrays arrays(*this, increment, time_increment);
    if (!(law.elastic_bound(arrays.input) < 1.))
      return;
    const Result result = evaluate(increment, LawTangent::elastic);
    const double tolerance = 1e-10 * size(result.stress) + 2. * rounding(increment);
    bool is_elastic = result.status == LawStatus::ok && result.dissipation == 0. &&
                      result.state == increment.old_state;
    for (int i = 0; i < law.n_strains && is_elastic; ++i) {
      double stress = 0.;
      for (int j = 0; j < law.n_strains; ++j)
        stress += result.tangent[law.n_strains * i + j] * increment.strain[j];
      is_elastic = std::abs(stress - result.stress[i]) <= tolerance;
    }
    if (!is_elastic)
      violated("its elastic bound is below 1 where it does not answer by its elastic tangent, or "
               "does not keep a state of zero");
  }

  /// Modes and spectra go by the elastic tangent; at rest there is no other.
  void check_elastic_tangent() {
    constexpr double same = 1e-6; // of what it is beside
    const Increment increment = from_rest();
    const Result elastic = evaluate(increment, LawTangent::elastic, 0.),
                 consistent = evaluate(increment, LawTangent::consistent, 0.);
    if (elastic.status != LawStatus::ok || consistent.status != LawStatus::ok ||
        consistent.state != increment.old_state)
      return;
    const int n = law.n_strains;
    const Vector &of_rest = consistent.tangent;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (!(std::abs(elastic.tangent[n * i + j] - of_rest[n * i + j]) <=
              same * std::sqrt(std::abs(of_rest[(n + 1) * i] * of_rest[(n + 1) * j]))))
          return violated("at rest its elastic tangent, by which modes and spectra go, is not its "
                          "consistent one");
  }

  void check_all_at_once(const Increment &increment) {
    if (law.integrate_all == nullptr)
      return;
    constexpr int n = 3;
    std::vector<Increment> increments(n, increment);
    std::vector<Arrays> arrays; // what each reads
    std::vector<LawInput> inputs;
    std::vector<Result> results(n, blank());
    std::vector<LawOutput> outputs;
    arrays.reserve(n);
    for (int k = 0; k < n; ++k) {
      for (double &e : increments[k].strain)
        e *= 1. - 0.4 * k;
      arrays.emplace_back(*this, increments[k], time_increment);
      inputs.push_back(arrays.back().input);
      inputs.back().tangent = LawTangent::consistent;
      outputs.push_back({results[k].stress.data(), results[k].tangent.data(),
                         results[k].state.data(), 0., ContactStatus::none});
    }
    law.integrate_all(n, inputs.data(), outputs.data());
    for (int k = 0; k < n; ++k) {
      results[k].state.resize(n_states);
      const Result one = evaluate(increments[k], LawTangent::consistent);
      if (one.status == LawStatus::ok &&
          (one.stress != results[k].stress || one.tangent != results[k].tangent ||
           one.state != results[k].state || one.dissipation != outputs[k].dissipation))
        violated("many at once are not what each is by itself");
    }
  }

  /// Work of the stress less dissipation and gain of stored energy there and half way back, over
  /// the sum of what the work moved; halves with the increments.
  double lost_energy(const Vector &strain, const double dt, const int n_steps) {
    Increment increment = from_rest();
    Result last = evaluate(increment, LawTangent::none, 0.);
    const double at_rest = last.stored;
    double kept = 0., moved = 0.;
    for (int step = 1; step <= n_steps; ++step) {
      const double place = 1.5 * step / n_steps;
      increment.previous_strain = increment.strain;
      for (int i = 0; i < law.n_strains; ++i)
        increment.strain[i] = (place < 1. ? place : 2. - place) * strain[i];
      increment.old_state = last.state;
      increment.time += dt / n_steps;
      const Result now = evaluate(increment, LawTangent::none, dt / n_steps);
      if (now.status != LawStatus::ok || !is_finite(now) || std::isnan(now.stored))
        return 0.; // no answer, or it is not told
      double work = 0.;
      for (int i = 0; i < law.n_strains; ++i)
        work += (last.stress[i] + now.stress[i]) / 2. *
                (increment.strain[i] - increment.previous_strain[i]);
      kept += work - now.dissipation;
      moved += std::abs(work);
      last = now;
    }
    return moved > 0. ? (kept - (last.stored - at_rest)) / moved : 0.;
  }

  void check_energy(const Vector &strain, const double dt) {
    const double once = lost_energy(strain, dt, 300), twice = lost_energy(strain, dt, 600);
    if (std::abs(2. * twice - once) > 2e-3 || std::abs(twice) > 2e-2)
      violated("the work of the stress is not what stored_energy gains and dissipation, however "
               "small the increments");
  }

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

  void violated(const std::string &what) {
    if (std::find(violations.begin(), violations.end(), what) == violations.end())
      violations.push_back(what);
  }

  void check_increment(const Increment &increment, const Result &result) {
    const Increment before = increment;
    for (const Vector *values : {&result.stress, &result.tangent, &result.state})
      if (!all_finite(*values))
        return violated("a result is not a finite number, or not written");
    if (result.behind)
      violated("more internal variables are written than there are");
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
    if (!is_section)
      check_elastic_tangent(elastic.tangent);
    if (increment.old_state != before.old_state)
      violated("the old state is written: write new_state only");
    if (result.dissipation < -1e-12 * size(result.stress) * size(increment.strain))
      violated("dissipation is negative");
    check_commit(increment, result);
    check_tangent(increment, result);
  }

  /// That of a support is a stiffness: symmetric, and nothing makes energy by it.
  void check_elastic_tangent(const Vector &C) {
    const int n = law.n_strains;
    const double rounding = 1e-9 * size(C);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (std::abs(C[n * i + j] - C[n * j + i]) > rounding || C[n * i + i] < -rounding ||
            C[n * i + j] * C[n * i + j] >
                C[n * i + i] * C[n * j + j] + rounding * std::abs(C[n * i + j]))
          return violated("the elastic tangent is no stiffness: it is not symmetric, or negative");
  }

  void check_commit(const Increment &increment, const Result &result) {
    Increment committed = increment;
    committed.old_state = result.state;
    // What creeps does not stand still while time passes.
    const Result repeated = evaluate(committed, LawTangent::none, is_section ? 0. : time_increment);
    const double tolerance = 1e-9 * size(result.stress) + 2. * rounding(increment);
    for (int i = 0; i < law.n_strains; ++i)
      if (std::abs(repeated.stress[i] - result.stress[i]) > tolerance)
        violated("stress " + std::to_string(i) +
                 " changes when evaluated again after the commit: new_state does not belong to it");

    // An empty increment: nothing moves, no time passes.
    committed.previous_strain = committed.strain;
    const Result held = evaluate(committed, LawTangent::none, 0.);
    if (held.status != LawStatus::ok || !is_finite(held))
      return;
    if (held.dissipation >
        1e-9 * (result.dissipation + size(result.stress) * size(increment.strain)))
      violated("it dissipates when evaluated again after the commit though nothing moves: is the "
               "slip of the wrong sign?");
    committed.old_state = held.state;
    const Result still = evaluate(committed, LawTangent::none, 0.);
    for (int i = 0; i < n_states; ++i) {
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
    for (int j = 0; j < n; ++j) {
      const double h = 1e-6 * size(increment.strain);
      double column = 0.;
      std::vector<bool> wrong = wrong_tangent(increment, result, j, h, column);
      if (std::find(wrong.begin(), wrong.end(), true) != wrong.end()) {
        // Of a law with many points kinks may lie on either side. They are not all nearer still.
        const std::vector<bool> closer = wrong_tangent(increment, result, j, h / 100., column);
        for (int i = 0; i < n; ++i)
          wrong[i] = wrong[i] && closer[i];
      }
      for (int i = 0; i < n; ++i)
        if (wrong[i])
          violated("tangent (" + std::to_string(i) + ", " + std::to_string(j) +
                   ") is not the derivative of the stress");
      for (int i = 0; law.symmetric_tangent && i < n; ++i)
        if (std::abs(result.tangent[n * i + j] - result.tangent[n * j + i]) > 1e-9 * column)
          violated("the tangent is announced as symmetric and is not");
    }
  }
};

} // namespace

std::vector<std::string> check_law(const LawDescription &law, const std::vector<double> &parameters,
                                   LawReach &reached) {
  const int n_states = n_internal_variables(law, parameters);
  if (n_states < 0 || n_states > law.n_internal_variables)
    return {"it needs " + std::to_string(n_states) + " internal variables and announces " +
            std::to_string(law.n_internal_variables)};
  Checker checker(law, parameters);
  for (const double magnitude : {1e-6, 1e-3, 0.1, 1.})
    for (const unsigned int seed : {1u, 2u, 3u})
      checker.walk(magnitude, seed);
  for (const double magnitude : {1e-6, 1e-4, 1e-3, 1e-2})
    for (const unsigned int seed : {1u, 2u, 3u})
      checker.check_section(magnitude, seed);
  for (const double magnitude : {1e-6, 1e-3, 0.1, 1.})
    checker.check_support(magnitude);
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
