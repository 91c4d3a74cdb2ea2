// SPDX-License-Identifier: LGPL-2.1-or-later
// A law whose description is drawn at random by the number in FUZZ_LAW: what a library may say of
// itself, right or wrong.
#include <frictionbeam/law.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

namespace {

using namespace frictionbeam;

std::mt19937_64 random_bits(std::getenv("FUZZ_LAW") != nullptr
                                ? std::strtoull(std::getenv("FUZZ_LAW"), nullptr, 10)
                                : 0);

std::size_t below(const std::size_t n) { return random_bits() % n; }

double any_number() {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double numbers[] = {0.,   1.,        -1., 1e300, -1e300, 1e-300, inf,
                            -inf, inf - inf, 1e6, 0.3,   2.,     1e30,   -0.};
  return numbers[below(sizeof(numbers) / sizeof(numbers[0]))];
}

const char *any_text(const char *const right) {
  const char *const texts[] = {nullptr,    "",  "\n", "=", "set", "a b",
                               "\xff\xfe", "m", "-",  "#", "end"};
  return below(8) != 0 ? right : texts[below(sizeof(texts) / sizeof(texts[0]))];
}

int any_count(const int right) {
  const int counts[] = {-1, 0, 1, 3, 5, 1000, 2147483647, -2147483647};
  return below(6) != 0 ? right : counts[below(sizeof(counts) / sizeof(counts[0]))];
}

const int wrong_answers = static_cast<int>(below(4));

class Law final : public LawBase {
public:
  LawStatus integrate(const LawInput &input, LawOutput &output) const noexcept override {
    for (int i = 0; i < n_support_strains; ++i) {
      output.stress[i] = wrong_answers == 1 ? std::nan("") : 1e6 * input.strain[i];
      for (int j = 0; j < n_support_strains && input.tangent != LawTangent::none; ++j)
        output.tangent[n_support_strains * i + j] = i == j ? (wrong_answers == 2 ? -1e6 : 1e6) : 0.;
    }
    output.dissipation = wrong_answers == 3 ? -1. : 0.;
    output.contact = ContactStatus::stick;
    return LawStatus::ok;
  }
};
const Law law;

const LawParameter parameters[2] = {
    {any_text("Strength"), any_text("N"), any_number(), any_number(), any_number(),
     any_text("Of it.")},
    {any_text("Weakness"), any_text("-"), 1., 0., 2., any_text("Of it.")}};

FrictionThreshold form{}; // drawn once: equal calls give equal results
void threshold(const LawInput &input, FrictionThreshold &result) {
  result = form;
  if (form.varies && form.gap == 0.)
    result.static_friction += 0.001 * input.temperature;
}

/// A closed form, and the internal variables that it speaks of: right, or nearly so.
void add_form(LawDescription &law) {
  law.threshold = &threshold;
  law.n_internal_variables = any_count(4);
  for (double *const number :
       {&form.static_friction, &form.dynamic_friction, &form.gap, &form.axial_rigidity,
        &form.shear_rigidity_y, &form.shear_rigidity_z, &form.torsional_rigidity})
    *number = below(4) == 0 ? any_number() : number == &form.gap ? 0. : 1e6;
  int place = 0;
  for (int *const one : {&form.slip_y, &form.slip_z, &form.twist, &form.was_slipping})
    *one = any_count(place++);
  form.varies = below(3) == 0;
}

LawDescription description() {
  const int versions[] = {law_interface_version, law_interface_version + 1, 0, -1};
  LawDescription result = {};
  result.interface_version = below(10) != 0 ? law_interface_version : versions[below(4)];
  result.kind = below(8) != 0 ? LawKind::support : static_cast<LawKind>(below(5));
  result.n_strains = any_count(n_support_strains);
  result.n_internal_variables = any_count(0);
  result.symmetric_tangent = below(2) == 0;
  result.name = any_text("fuzz");
  result.reference = any_text("none");
  const int n = static_cast<int>(below(3));
  result.n_parameters = below(12) != 0 ? n : -1;
  result.parameters = n > 0 && below(12) != 0 ? parameters : n > 0 ? nullptr : parameters;
  result.law = below(12) != 0 ? &law : nullptr;
  result.threshold = nullptr;
  if (below(3) == 0)
    add_form(result);
  return result;
}

} // namespace

extern const LawDescription frictionbeam_law;
const LawDescription frictionbeam_law = description();
