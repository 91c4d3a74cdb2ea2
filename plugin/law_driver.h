// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/bound_law.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace frictionbeam::conformance {

using Vector = std::vector<double>;

struct Result {
  Vector stress, tangent, state;
  double dissipation = 0., stored = 0.;
  LawStatus status = LawStatus::ok;
  ContactStatus contact = ContactStatus::none;
  bool behind = false; ///< whether something is written behind the state
};

/// One increment of a strain path.
struct Increment {
  Vector strain, previous_strain, old_state;
  double time;
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Closed, around a square across the normal to either side, opened; likewise, and twisted;
/// opened, and closed again from elsewhere.
inline std::vector<std::vector<Vector>> ways_of(const double n, const double across) {
  std::vector<std::vector<Vector>> ways;
  for (const double turn : {across, -across})
    ways.push_back({{n, 0., 0., 0.},
                    {-n, 0., 0., 0.},
                    {-n, across, 0., 0.},
                    {-n, across, turn, 0.},
                    {-n, 0., turn, 0.},
                    {-n, 0., 0., 0.},
                    {n, 0., 0., 0.}});
  for (const double twist : {across, 100. * across})
    ways.push_back({{n, 0., 0., 0.},
                    {-n, 0., 0., 0.},
                    {-n, 0., 0., twist},
                    {-n, 0., 0., -twist},
                    {-n, 0., 0., 0.},
                    {n, 0., 0., 0.}});
  for (const int i : {1, 2}) {
    Vector away = {n, 0., 0., 0.}, closed = {-n, 0., 0., 0.};
    away[i] = closed[i] = across;
    ways.push_back({{n, 0., 0., 0.},
                    {-n, 0., 0., 0.},
                    {n, 0., 0., 0.},
                    away,
                    closed,
                    {-n, 0., 0., 0.},
                    {n, 0., 0., 0.}});
  }
  return ways;
}

/// A law with parameters, asked increment by increment; results that it does not write are no
/// numbers.
class LawDriver {
public:
  LawDriver(const LawDescription &law, const Vector &parameters)
      : law(law), parameters(parameters), n_states(n_internal_variables(law, parameters)),
        is_section(law.interface_version >= 2 && law.kind == LawKind::section),
        scale(law.n_strains, 1.) {
    if (!is_section)
      return;
    // Strains of like effect: an axial one, and the others over the radius.
    const Vector none(law.n_strains, 0.);
    const Vector rigidity =
        evaluate({none, none, Vector(n_states, 0.), 0.}, LawTangent::elastic).tangent;
    for (int i = 1; i < law.n_strains; ++i) {
      const double ratio = std::sqrt(rigidity[0] / rigidity[(law.n_strains + 1) * i]);
      if (std::isfinite(ratio) && ratio > 0.)
        scale[i] = ratio;
    }
  }

  static constexpr double pressures[3] = {0., 1e5, 1e6}; // [Pa]

  Increment from_rest() const {
    const Vector none(law.n_strains, 0.);
    return {none, none, Vector(n_states, 0.), 0.};
  }

  static constexpr double length = 0.5, time_increment = 0.25;

  /// What a law reads of an increment.
  struct Arrays {
    Vector rate, displacement;
    LawInput input{};

    Arrays(const LawDriver &driver, const Increment &increment, const double dt)
        : rate(driver.law.n_strains), displacement(3) {
      for (int i = 0; i < driver.law.n_strains; ++i)
        rate[i] =
            (increment.strain[i] - increment.previous_strain[i]) / (dt > 0. ? dt : time_increment);
      for (int i = 0; i < 3; ++i)
        displacement[i] = increment.strain[i] * length;
      input.parameters = driver.parameters.data();
      input.strain = increment.strain.data();
      input.strain_rate = rate.data();
      input.displacement = driver.law.kind == LawKind::support ? displacement.data() : nullptr;
      input.length = length;
      input.time = increment.time;
      input.time_increment = dt;
      input.temperature = 20.;
      input.old_state = increment.old_state.data();
      input.pressure = driver.pressure;
    }
  };

  /// Not a number until the law writes it.
  Result blank() const {
    return {Vector(law.n_strains, nan), Vector(law.n_strains * law.n_strains, nan),
            Vector(n_states + n_behind, nan)};
  }

  Result evaluate(const Increment &increment, const LawTangent tangent,
                  const double dt = time_increment) const {
    Arrays arrays(*this, increment, dt);
    arrays.input.tangent = tangent;
    Result result = blank();
    LawOutput output{result.stress.data(), result.tangent.data(), result.state.data(), 0.,
                     ContactStatus::none};
    output.stored_energy = nan;
    result.status = law.law->integrate(arrays.input, output);
    result.dissipation = output.dissipation;
    result.stored = output.stored_energy;
    result.contact = output.contact;
    result.behind = !std::all_of(result.state.begin() + n_states, result.state.end(),
                                 [](const double x) { return std::isnan(x); });
    result.state.resize(n_states);
    return result;
  }

  /// Rounding of stresses that are differences of strains times a rigidity.
  double rounding(const Increment &increment) const {
    double rigidity = 0.;
    for (const double x : evaluate(increment, LawTangent::elastic).tangent)
      rigidity = std::max(rigidity, std::abs(x));
    return 1e-15 * rigidity * size(increment.strain);
  }

  /// Entries of a column of the tangent that are not difference quotients of this step.
  /// @param column gets its largest entry, if that is above
  std::vector<bool> wrong_tangent(const Increment &increment, const Result &result, const int j,
                                  const double h, double &column) const {
    const int n = law.n_strains;
    const double rounding = (1e-14 * size(result.stress) + this->rounding(increment)) / h;
    const auto moved = [&](const double step) {
      Increment other = increment;
      other.strain[j] += step;
      return evaluate(other, LawTangent::none).stress;
    };
    const Vector up = moved(h), down = moved(-h);
    for (int i = 0; i < n; ++i)
      column = std::max(
          {column, std::abs(result.tangent[n * i + j]), std::abs(up[i] - down[i]) / (2 * h)});
    std::vector<bool> wrong(n, false);
    for (int i = 0; i < n; ++i) {
      const double forward = (up[i] - result.stress[i]) / h;
      const double backward = (result.stress[i] - down[i]) / h;
      wrong[i] = std::abs(forward - backward) <= 1e-3 * column + rounding && // no kink between
                 std::abs(result.tangent[n * i + j] - (forward + backward) / 2) >
                     1e-4 * column + std::abs(forward - backward) / 2 + 10. * rounding;
    }
    return wrong;
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

  const LawDescription &law;
  const Vector &parameters;
  const int n_states;
  const bool is_section;
  static constexpr int n_behind = 8; ///< places behind the state that no law writes
  Vector scale;                      ///< of each strain
  double pressure = 0.;
};

} // namespace frictionbeam::conformance
