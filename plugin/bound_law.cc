// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/bound_law.h>

#include <frictionbeam/law_closed_form.h>

#include <cmath>

namespace frictionbeam {

BoundLaw::BoundLaw(const LawDescription &law, const std::vector<double> &parameters)
    : law(&law), values(parameters) {
  if (law.threshold == nullptr)
    return;
  form = closed_form_at_rest(law, values);
  is_constant = !form.varies;
  if (form.varies) // that of another instant is not to be believed
    form = {};
}

bool BoundLaw::is_rigid_along_normal() const {
  return has_closed_form() && std::isinf(form.axial_rigidity);
}

LawStatus BoundLaw::integrate(const double *strain, const double *strain_rate,
                              const double element_length, const LawIncrement &increment,
                              const double *old_state, const LawTangent tangent,
                              LawOutput &output) const {
  double displacement[3];
  for (int d = 0; d < 3; ++d)
    displacement[d] = strain[d] * element_length;
  LawInput input{};
  input.parameters = values.data();
  input.strain = strain;
  input.strain_rate = strain_rate;
  input.displacement = law->kind == LawKind::support ? displacement : nullptr;
  input.length = element_length;
  input.time = increment.time;
  input.time_increment = increment.length;
  input.temperature = increment.temperature;
  input.old_state = old_state;
  input.tangent = tangent;
  input.pressure = increment.pressure;
  return law->law->integrate(input, output);
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
