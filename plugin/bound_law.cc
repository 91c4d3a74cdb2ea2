// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/bound_law.h>

#include <frictionbeam/law_closed_form.h>

#include "number_text.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace frictionbeam {

namespace {

/// Whether a law is compiled with what version 2 tells of sections: an older one ends before it.
bool tells_of_sections(const LawDescription &law) {
  return law.interface_version >= 2 && law.kind == LawKind::section;
}

/// Parameters that a law can be given, before it is asked anything.
const std::vector<double> &checked(const LawDescription &law,
                                   const std::vector<double> &parameters) {
  const auto refuse = [&](const std::string &read, const std::string &allowed,
                          const std::string &attempt) {
    throw std::invalid_argument("The law '" + std::string(law.name) + "' is given " + read +
                                "\n  allowed: " + allowed + "\n  try:     " + attempt);
  };
  if (parameters.size() != static_cast<std::size_t>(law.n_parameters))
    refuse(std::to_string(parameters.size()) + " parameters",
           std::to_string(law.n_parameters) + " of them, in the law's order", "law_parameters()");
  for (int p = 0; p < law.n_parameters; ++p) {
    const LawParameter &parameter = law.parameters[p];
    if (!(parameters[p] >= parameter.minimum && parameters[p] <= parameter.maximum))
      refuse("'" + std::string(parameter.name) + "' of " + text_of(parameters[p]),
             text_of(parameter.minimum) + " to " + text_of(parameter.maximum) + " " +
                 parameter.unit,
             "its default, " + text_of(parameter.default_value));
  }
  if (const auto fault = fault_of(law, parameters))
    refuse("parameters that it cannot take together", fault->allowed, fault->attempt);
  return parameters;
}

} // namespace

std::optional<LawFault> fault_of(const LawDescription &law, const std::vector<double> &parameters) {
  const bool tells = law.interface_version >= 2 && law.fault != nullptr;
  const char *const text = tells ? law.fault(parameters.data()) : nullptr;
  if (text == nullptr)
    return {};
  const std::string fault = text;
  const std::size_t colon = fault.find(": ");
  if (colon == std::string::npos)
    return LawFault{fault, "other values"};
  return LawFault{fault.substr(0, colon), fault.substr(colon + 2)};
}

unsigned int n_internal_variables(const LawDescription &law,
                                  const std::vector<double> &parameters) {
  return tells_of_sections(law) && law.n_states != nullptr ? law.n_states(parameters.data())
                                                           : law.n_internal_variables;
}

BoundLaw::BoundLaw(const LawDescription &law, const std::vector<double> &parameters)
    : law(&law), values(checked(law, parameters)),
      n_variables(frictionbeam::n_internal_variables(law, parameters)) {
  for (int i = 0; i < law.n_parameters && law.kind == LawKind::support; ++i)
    if (std::string("Gap") == law.parameters[i].name)
      travel = values[i];
  if (law.threshold == nullptr)
    return;
  form = closed_form_at_rest(law, values);
  travel = form.gap;
  is_constant = !form.varies;
  if (form.varies) // that of another instant is not to be believed
    form = {};
}

bool BoundLaw::is_rigid_along_normal() const {
  return has_closed_form() && std::isinf(form.axial_rigidity);
}

LawInput BoundLaw::input_of(const double *strain, const double element_length,
                            const LawIncrement &increment) const {
  LawInput input{};
  input.parameters = values.data();
  input.strain = strain;
  input.length = element_length;
  input.time = increment.time;
  input.time_increment = increment.length;
  input.temperature = increment.temperature;
  input.pressure = increment.pressure;
  input.temperature_change = increment.temperature_change;
  return input;
}

LawStatus BoundLaw::integrate(const double *strain, const double *strain_rate,
                              const double element_length, const LawIncrement &increment,
                              const double *old_state, const LawTangent tangent,
                              LawOutput &output) const {
  double displacement[3];
  for (int d = 0; d < 3; ++d)
    displacement[d] = strain[d] * element_length;
  LawInput input = input_of(strain, element_length, increment);
  input.strain_rate = strain_rate;
  input.displacement = law->kind == LawKind::support ? displacement : nullptr;
  input.old_state = old_state;
  input.tangent = tangent;
  return law->law->integrate(input, output);
}

double BoundLaw::elastic_bound(const double *strain, const double element_length,
                               const LawIncrement &increment) const {
  if (!tells_of_sections(*law) || law->elastic_bound == nullptr)
    return std::numeric_limits<double>::infinity();
  const double no_rate[n_section_strains] = {};
  LawInput input = input_of(strain, element_length, increment);
  input.strain_rate = no_rate;
  return law->elastic_bound(input);
}

SectionReport BoundLaw::report(const double *strain, const double element_length,
                               const LawIncrement &increment, const double *new_state,
                               const double *const since) const {
  SectionReport result;
  if (!tells_of_sections(*law) || law->report == nullptr) {
    if (n_internal_variables() > 0) // else nothing can flow
      result.utilization = result.plastic_strain = result.creep_strain =
          std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  const double no_rate[n_section_strains] = {};
  LawInput input = input_of(strain, element_length, increment);
  input.strain_rate = no_rate;
  const bool knows_since = law->interface_version >= 4;
  input.old_state = knows_since ? since : nullptr;
  law->report(input, new_state, result);
  if (since != nullptr && !knows_since) {
    // By how much its largest strains have grown, wherever they are.
    SectionReport then;
    law->report(input, since, then);
    result.plastic_strain -= then.plastic_strain;
    result.creep_strain -= then.creep_strain;
  }
  return result;
}

BoundLaw::Answer BoundLaw::answer_at_rest(const std::vector<double> &strain,
                                          const double element_length, const LawTangent tangent,
                                          const double temperature) const {
  const std::size_t n = law->n_strains;
  const std::vector<double> no_rate(n, 0.), zero(n_internal_variables() + 1, 0.);
  Answer answer{std::vector<double>(n, 0.), std::vector<double>(n * n, 0.), zero};
  LawOutput output{answer.stress.data(), answer.tangent.data(), answer.state.data(), 0.,
                   ContactStatus::none};
  integrate(strain.data(), no_rate.data(), element_length, {0., 0., temperature}, zero.data(),
            tangent, output);
  return answer;
}

} // namespace frictionbeam
