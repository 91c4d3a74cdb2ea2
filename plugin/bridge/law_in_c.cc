// SPDX-License-Identifier: LGPL-2.1-or-later
#include "law_in_c.h"

#include <cmath>
#include <cstddef>

namespace frictionbeam {

namespace {

// A closed form is a bare function in both languages, and called as it is: what it reads and writes
// must lie where it looks. A reference is passed as a pointer is.
#define SAME_PLACE(cpp, c, field)                                                                  \
  static_assert(offsetof(cpp, field) == offsetof(c, field) &&                                      \
                sizeof(cpp::field) == sizeof(c::field))
// What C does not know stands behind.
static_assert(offsetof(LawInput, temperature_change) == sizeof(frictionbeam_c_input));
SAME_PLACE(LawInput, frictionbeam_c_input, parameters);
SAME_PLACE(LawInput, frictionbeam_c_input, strain);
SAME_PLACE(LawInput, frictionbeam_c_input, strain_rate);
SAME_PLACE(LawInput, frictionbeam_c_input, displacement);
SAME_PLACE(LawInput, frictionbeam_c_input, length);
SAME_PLACE(LawInput, frictionbeam_c_input, time);
SAME_PLACE(LawInput, frictionbeam_c_input, time_increment);
SAME_PLACE(LawInput, frictionbeam_c_input, temperature);
SAME_PLACE(LawInput, frictionbeam_c_input, old_state);
SAME_PLACE(LawInput, frictionbeam_c_input, tangent);
SAME_PLACE(LawInput, frictionbeam_c_input, pressure);
static_assert(sizeof(FrictionThreshold) == sizeof(frictionbeam_c_threshold));
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, static_friction);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, dynamic_friction);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, gap);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, axial_rigidity);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, shear_rigidity_y);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, shear_rigidity_z);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, torsional_rigidity);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, patch_radius);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, slip_y);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, slip_z);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, twist);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, was_slipping);
SAME_PLACE(FrictionThreshold, frictionbeam_c_threshold, varies);
#undef SAME_PLACE

static_assert(static_cast<int>(LawKind::support) == FRICTIONBEAM_SUPPORT &&
              static_cast<int>(LawKind::section) == FRICTIONBEAM_SECTION &&
              n_support_strains == FRICTIONBEAM_N_SUPPORT_STRAINS &&
              n_section_strains == FRICTIONBEAM_N_SECTION_STRAINS);
static_assert(static_cast<int>(ContactStatus::stick) == FRICTIONBEAM_STICK &&
              static_cast<int>(ContactStatus::slip) == FRICTIONBEAM_SLIP &&
              static_cast<int>(ContactStatus::open) == FRICTIONBEAM_OPEN &&
              static_cast<int>(ContactStatus::closed) == FRICTIONBEAM_CLOSED);
static_assert(static_cast<int>(LawTangent::none) == FRICTIONBEAM_NO_TANGENT &&
              static_cast<int>(LawTangent::consistent) == FRICTIONBEAM_CONSISTENT_TANGENT &&
              static_cast<int>(LawTangent::elastic) == FRICTIONBEAM_ELASTIC_TANGENT);

using ThresholdInCpp = decltype(LawDescription::threshold);

ThresholdInCpp in_cpp(const frictionbeam_c_law &law) {
  if (law.threshold == nullptr)
    return nullptr;
  return reinterpret_cast<ThresholdInCpp>(reinterpret_cast<void (*)()>(law.threshold));
}

std::string fault_of_figures(const frictionbeam_c_law &law) {
  for (int i = 0; i < law.n_parameters; ++i) {
    const frictionbeam_c_parameter &p = law.parameters[i];
    const bool is_finite =
        std::isfinite(p.default_value) && std::isfinite(p.minimum) && std::isfinite(p.maximum);
    if (!is_finite)
      return "the default " + std::to_string(p.default_value) + " or a bound, " +
             std::to_string(p.minimum) + " to " + std::to_string(p.maximum) +
             ", of its parameter " +
             (p.name != nullptr ? "'" + std::string(p.name) + "'" : "number " + std::to_string(i)) +
             " is not finite. Give numbers; 1e300 or -1e300 where there is no bound.";
  }
  return {};
}

} // namespace

std::string faults_of_law_in_c(const frictionbeam_c_law *law) {
  if (law == nullptr)
    return "its frictionbeam_law_c() returns null. Return the address of a frictionbeam_c_law that "
           "stays.";
  if (law->version != FRICTIONBEAM_LAW_C_VERSION)
    return "it was compiled for version " + std::to_string(law->version) +
           " of the law interface in C, this program has version " +
           std::to_string(FRICTIONBEAM_LAW_C_VERSION) +
           ". Compile it again with the header frictionbeam/law_c.h of this program, and set "
           "frictionbeam_c_law::version to FRICTIONBEAM_LAW_C_VERSION.";
  if (law->size != static_cast<int>(sizeof(frictionbeam_c_law)))
    return "its frictionbeam_c_law has " + std::to_string(law->size) + " bytes, expected " +
           std::to_string(sizeof(frictionbeam_c_law)) +
           ". Set frictionbeam_c_law::size to sizeof(frictionbeam_c_law); in another language than "
           "C give all fields in their order, with C's types.";
  if (law->fault != nullptr)
    return std::string(law->fault);
  if (law->integrate == nullptr)
    return "it has no integrate(). Set frictionbeam_c_law::integrate to the function that gives "
           "the "
           "stress.";
  if (law->kind != FRICTIONBEAM_SUPPORT && law->kind != FRICTIONBEAM_SECTION)
    return "its kind is " + std::to_string(law->kind) +
           ", expected FRICTIONBEAM_SUPPORT (0) or FRICTIONBEAM_SECTION (1). Set "
           "frictionbeam_c_law::kind.";
  if (law->n_states < 0 || law->n_states > 999)
    return "it has " + std::to_string(law->n_states) +
           " internal variables, expected 0 to 999. Set frictionbeam_c_law::n_states.";
  if (law->n_parameters < 0 || law->n_parameters > 1000 ||
      (law->n_parameters > 0 && law->parameters == nullptr))
    return "it announces " + std::to_string(law->n_parameters) + " parameters" +
           (law->parameters == nullptr ? " without a list" : "") +
           ", expected 0 to 1000 in a list. Set frictionbeam_c_law::n_parameters and parameters "
           "together.";
  if (law->initialize != nullptr && law->threshold != nullptr)
    return "it has both a first state and a closed form, whose methods begin from zero. Set "
           "frictionbeam_c_law::initialize or threshold to null.";
  return fault_of_figures(*law);
}

LawInC::LawInC(const frictionbeam_c_law &law) : law(law) {
  for (int i = 0; i < law.n_parameters; ++i) {
    const frictionbeam_c_parameter &p = law.parameters[i];
    parameters.push_back({p.name, p.unit, p.default_value, p.minimum, p.maximum, p.meaning});
  }
  of_law.interface_version = law_interface_version;
  of_law.kind = static_cast<LawKind>(law.kind);
  of_law.n_strains = law.kind == FRICTIONBEAM_SECTION ? n_section_strains : n_support_strains;
  of_law.n_internal_variables = law.n_states + (law.initialize != nullptr ? 1 : 0);
  of_law.symmetric_tangent = law.symmetric_tangent != 0;
  of_law.name = law.name;
  of_law.reference = law.reference;
  of_law.n_parameters = law.n_parameters;
  of_law.parameters = parameters.data();
  of_law.law = this;
  of_law.threshold = in_cpp(law);
}

LawStatus LawInC::integrate(const LawInput &in, LawOutput &out) const noexcept {
  const std::size_t n_states = law.n_states;
  double begin[1000]; // faults_of_law_in_c() lets no more pass
  const double *old_state = in.old_state;
  if (law.initialize != nullptr) {
    if (in.old_state[n_states] == 0.) {
      law.initialize(in.parameters, begin);
      old_state = begin;
    }
    out.new_state[n_states] = 1.;
  }
  const frictionbeam_c_input input = {in.parameters,     in.strain,
                                      in.strain_rate,    in.displacement,
                                      in.length,         in.time,
                                      in.time_increment, in.temperature,
                                      old_state,         static_cast<int>(in.tangent),
                                      in.pressure};
  frictionbeam_c_output output = {};
  output.stress = out.stress;
  output.tangent = out.tangent;
  output.new_state = out.new_state;
  output.stored_energy = out.stored_energy; // what it does not tell stays as it is
  output.error = out.error;
  const int status = law.integrate(&input, &output);
  if (output.contact < FRICTIONBEAM_NONE || output.contact > FRICTIONBEAM_CLOSED)
    return LawStatus::failed;
  out.dissipation = output.dissipation;
  out.contact = static_cast<ContactStatus>(output.contact);
  out.stored_energy = output.stored_energy;
  out.error = output.error;
  return status == FRICTIONBEAM_OK ? LawStatus::ok : LawStatus::failed;
}

} // namespace frictionbeam
