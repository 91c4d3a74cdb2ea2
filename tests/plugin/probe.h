// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <frictionbeam/law.h>
#include <frictionbeam/law_library.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

/// A support law with its parameters and its state, driven by strains.
class Probe {
public:
  using Strain = std::array<double, 4>;
  using Values = std::vector<std::pair<std::string, double>>;

  Probe(const frictionbeam::LawDescription &law, const Values &values, const double length = 1.)
      : law(law), parameters(default_parameters(law)), length(length),
        state(law.n_internal_variables, 0.), new_state(state) {
    for (const auto &[name, value] : values)
      parameters[parameter_index(law, name)] = value;
  }

  /// Stress, tangent and new state at the end of an increment from the committed state.
  void evaluate(const Strain &strain,
                const frictionbeam::LawTangent tangent = frictionbeam::LawTangent::consistent) {
    const double rate[4] = {};
    const double displacement[3] = {strain[0] * length, strain[1] * length, strain[2] * length};
    const frictionbeam::LawInput input{
        parameters.data(), strain.data(), rate, displacement, length, 0., 0., 20.,
        state.data(),      tangent};
    frictionbeam::LawOutput output{stress.data(), this->tangent.data(), new_state.data(), 0.,
                                   frictionbeam::ContactStatus::none};
    status = law.law->integrate(input, output);
    dissipation = output.dissipation;
    contact = output.contact;
  }

  void commit() { std::swap(state, new_state); }

  /// Evaluate and commit.
  void move(const Strain &strain) {
    evaluate(strain);
    commit();
  }

  const frictionbeam::LawDescription &law;
  std::vector<double> parameters;
  double length;
  std::vector<double> state, new_state;
  Strain stress{};
  std::array<double, 16> tangent{};
  double dissipation = 0.;
  frictionbeam::ContactStatus contact = frictionbeam::ContactStatus::none;
  frictionbeam::LawStatus status = frictionbeam::LawStatus::ok;
};
