// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/disc_projection.h>
#include <frictionbeam/law_closed_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace frictionbeam {

namespace {

using Strain = std::array<double, n_support_strains>;

constexpr double element_length = 0.5; // [m]

/// Where a closed form is asked.
struct Instant {
  double temperature = 20., rate = 0., time = 1., time_increment = 0.25; // degC, 1/s, s, s
  double normal_rate = 0.;                                               // 1/s
};

/// Strain rates there.
Strain rates_at(const Instant &instant) {
  return {instant.normal_rate, instant.rate, -instant.rate, 0.};
}

/// What a law is given there, but for strain and displacement.
LawInput input_at(const Instant &instant, const std::vector<double> &parameters,
                  const double *const strain, const double *const strain_rate,
                  const double *const displacement, const std::vector<double> &old_state) {
  return {parameters.data(),
          strain,
          strain_rate,
          displacement,
          element_length,
          instant.time,
          instant.time_increment,
          instant.temperature,
          old_state.data(),
          LawTangent::none};
}

FrictionThreshold form_at(const LawDescription &law, const std::vector<double> &parameters,
                          const Instant &instant, const std::vector<double> &old_state) {
  const Strain zero{}, strain_rate = rates_at(instant);
  return closed_form(
      law, input_at(instant, parameters, zero.data(), strain_rate.data(), zero.data(), old_state));
}

/// The state of a contact that has slipped, with @p memory in what is none of the form's places.
std::vector<double> state_of(const FrictionThreshold &places, const unsigned int n_variables,
                             const double old_slip, const double was_slipping,
                             const double memory) {
  std::vector<double> state(n_variables, memory);
  state[places.slip_y] = old_slip;
  state[places.slip_z] = -0.5 * old_slip;
  state[places.twist] = 0.7 * old_slip;
  state[places.was_slipping] = was_slipping;
  return state;
}

std::string text_of(const Instant &instant) {
  std::ostringstream text;
  text << "temperature " << instant.temperature << " degC, rates of " << instant.rate << " 1/s";
  if (instant.normal_rate != 0.)
    text << ", along the normal of " << instant.normal_rate << " 1/s";
  if (instant.time != Instant().time)
    text << ", at " << instant.time << " s";
  if (instant.time_increment == 0.)
    text << ", in statics";
  return text.str();
}

/// Coefficients that no contact has.
void add_faults_of_coefficients(const FrictionThreshold &t, const std::string &where,
                                std::vector<std::string> &faults) {
  std::ostringstream text;
  if (!(t.static_friction >= 0. && std::isfinite(t.static_friction)))
    text << "a static coefficient below 0 or not finite, read " << t.static_friction;
  else if (!(t.dynamic_friction >= 0. && t.dynamic_friction <= t.static_friction))
    text << "a dynamic coefficient outside of 0 to the static one, read " << t.dynamic_friction;
  else
    return;
  faults.push_back("its closed form has " + text.str() + where);
}

/// What does not depend on the strain: moduli, places.
std::vector<std::string> faults_of_numbers(const LawDescription &law, const FrictionThreshold &t) {
  std::vector<std::string> faults;
  const auto require = [&faults](const bool condition, const std::string &what,
                                 const double value) {
    std::ostringstream text;
    text << "its closed form has " << what << ", read " << value;
    if (!condition)
      faults.push_back(text.str());
  };
  const std::string places = place_faults(law, t);
  if (!places.empty())
    faults.push_back(places);
  add_faults_of_coefficients(t, "", faults);
  require(std::isfinite(t.gap), "a gap that is not finite", t.gap);
  require(t.axial_rigidity > 0., "an axial rigidity not above 0", t.axial_rigidity);
  require(t.shear_rigidity_y > 0., "a shear rigidity not above 0", t.shear_rigidity_y);
  require(t.shear_rigidity_z > 0., "a shear rigidity not above 0", t.shear_rigidity_z);
  require(t.torsional_rigidity >= 0. && std::isfinite(t.torsional_rigidity),
          "a torsional rigidity below 0 or not finite", t.torsional_rigidity);
  require(t.patch_radius >= 0. && std::isfinite(t.patch_radius),
          "a patch radius below 0 or not finite", t.patch_radius);
  return faults;
}

bool same_but_coefficients(const FrictionThreshold &a, const FrictionThreshold &b) {
  return a.gap == b.gap && a.axial_rigidity == b.axial_rigidity &&
         a.shear_rigidity_y == b.shear_rigidity_y && a.shear_rigidity_z == b.shear_rigidity_z &&
         a.torsional_rigidity == b.torsional_rigidity && a.patch_radius == b.patch_radius &&
         a.slip_y == b.slip_y && a.slip_z == b.slip_z && a.twist == b.twist &&
         a.was_slipping == b.was_slipping && a.varies == b.varies;
}

/// A form that depends on more than the parameters says so, and in its coefficients alone.
std::vector<std::string> faults_of_dependence(const LawDescription &law,
                                              const std::vector<double> &parameters,
                                              const FrictionThreshold &at_rest) {
  std::vector<Instant> instants;
  for (double temperature = -250.; temperature <= 1500.; temperature += 50.)
    instants.push_back({temperature});
  for (const double rate : {1e-6, 1e-3, 0.3, 10., -0.3})
    instants.push_back({20., rate});
  for (const double time : {0., 100., 1e7})
    instants.push_back({20., 0., time});
  instants.push_back({20., 0., 1., 0.}); // as in statics
  for (const Instant &instant : instants)
    for (const double old_slip : {0., 2e-4})
      for (const double memory : {0., 1e-2, 1.}) {
        const FrictionThreshold form =
            form_at(law, parameters, instant,
                    state_of(at_rest, law.n_internal_variables, old_slip, 0., memory));
        if (!same_but_coefficients(form, at_rest))
          return {"its closed form depends in more than its coefficients on what is not a "
                  "parameter (" +
                  text_of(instant) + "): it may not"};
        if (!at_rest.varies && (form.static_friction != at_rest.static_friction ||
                                form.dynamic_friction != at_rest.dynamic_friction))
          return {"its closed form depends on more than the parameters (" + text_of(instant) +
                  ") and does not say so: set FrictionThreshold::varies"};
      }
  return {};
}

/// One call of the law, and the same increment by its closed form.
class Comparison {
public:
  Comparison(const LawDescription &law, const std::vector<double> &parameters,
             const FrictionThreshold &at_rest)
      : law(law), parameters(parameters), form(at_rest), new_state(law.n_internal_variables, 0.) {}

  std::vector<std::string> faults;

  /// Compare on strains from a tenth of the stick limit to ten times the limit, open and closed,
  /// from rest and from slip, until something is wrong; at more instants below and above the limit.
  void run() {
    run_at_two_temperatures();
    for (const Instant &other :
         {Instant{-200.}, Instant{350.}, Instant{700.}, Instant{1200.}, Instant{20., 0., 0.},
          Instant{20., 0., 100.}, Instant{20., 0., 1e7}, Instant{20., 0., 1., 0.},
          Instant{20., 0., 1., 0.25, -0.2}}) {
      old_state = state_of(form, law.n_internal_variables, 0., 0., 0.);
      instant = other;
      form = form_at(law, parameters, instant, old_state);
      std::vector<std::string> beyond; // what its formula is meant for
      add_faults_of_coefficients(form, "", beyond);
      for (const double share : {0.9, 1.1})
        if (faults.empty() && beyond.empty())
          compare({-1e-2 - form.gap / element_length, 0., 0., 0.}, share, 0.3);
    }
  }

private:
  void run_at_two_temperatures() {
    std::vector<double> memories = {0.};
    if (law.n_internal_variables > 4)
      memories.push_back(1e-2);
    for (const double temperature : {20., 150.})
      for (const double rate : {0., 0.3})
        for (const double old_slip : {0., 2e-4})
          for (const double was_slipping : {0., 1.})
            for (const double memory : memories)
              for (const double press : {-1e-2, -1e-5, 1e-4}) {
                old_state =
                    state_of(form, law.n_internal_variables, old_slip, was_slipping, memory);
                instant = {temperature, rate};
                form = form_at(law, parameters, instant, old_state);
                if (faults.empty())
                  add_faults_of_coefficients(form, " (" + text_of(instant) + ")", faults);
                for (const double share : {0.1, 0.9, 1.1, 10.})
                  for (const double angle : {0.3, 2., 4.4})
                    if (faults.empty())
                      compare({press - form.gap / element_length, 0., 0., 0.}, share, angle);
              }
  }

  LawStatus evaluate(const Strain &strain, const LawTangent kind) {
    const Strain strain_rate = rates_at(instant);
    const double displacement[3] = {strain[0] * element_length, strain[1] * element_length,
                                    strain[2] * element_length};
    LawInput input =
        input_at(instant, parameters, strain.data(), strain_rate.data(), displacement, old_state);
    input.tangent = kind;
    LawOutput output{stress.data(), tangent.data(), new_state.data(), 0., ContactStatus::none};
    return law.law->integrate(input, output);
  }

  void compare(Strain strain, const double share, const double angle) {
    if (evaluate(strain, LawTangent::elastic) != LawStatus::ok)
      return;
    // A rigid contact has no stiffness of its own: what the law takes for it is not judged.
    const double k[2] = {rigidity(form.shear_rigidity_y, 1), rigidity(form.shear_rigidity_z, 2)};
    const double opening = strain[0] + form.gap / element_length;
    const double N =
        opening >= 0.
            ? 0.
            : (std::isfinite(form.axial_rigidity) ? form.axial_rigidity * opening : stress[0]);
    const double stick =
        old_state[form.was_slipping] != 0. ? form.dynamic_friction : form.static_friction;
    // A share of the limit in the direction given, on top of the old slip.
    const double reach = stick > 0. ? share * stick * std::abs(N) : share;
    const double trial[2] = {reach * std::cos(angle), reach * std::sin(angle)};
    // Where the strains of friction drown in the rounding of the slip, nothing can be told.
    if (std::max(k[0], k[1]) * old_state[form.slip_y] * 1e-15 > 1e-10 * reach)
      return;
    strain[1] = old_state[form.slip_y] + trial[0] / k[0];
    strain[2] = old_state[form.slip_z] + trial[1] / k[1];
    // The twist likewise, beyond the patch's limit where the friction is beyond its own.
    const double limit = form.patch_radius * stick * std::abs(N);
    const bool turns = form.torsional_rigidity > 0.; // else there is nothing that a patch limits
    const double moment = !turns       ? 0.
                          : limit > 0. ? share * limit
                                       : form.torsional_rigidity * share * 1e-3;
    strain[3] = old_state[form.twist] + (turns ? moment / form.torsional_rigidity : 0.);
    for (const double x : {N, reach, moment, limit, stick, k[0], k[1], form.torsional_rigidity,
                           form.dynamic_friction, strain[1], strain[2], strain[3]})
      if (x != 0. && !(std::abs(x) > 1e-100 && std::abs(x) < 1e150))
        return; // products beyond what numbers can tell
    if (evaluate(strain, LawTangent::none) != LawStatus::ok)
      return;
    judge(strain, N, trial, k, stick, moment);
  }

  void say(const std::string &what, const double found, const double expected) {
    if (!faults.empty()) // the first one tells enough
      return;
    std::ostringstream text;
    text << "its closed form disagrees with integrate(): " << what << ' ' << expected
         << " by the closed form, " << found << " by integrate()";
    if (text_of(instant) != text_of(Instant()))
      text << " (" << text_of(instant)
           << "; threshold() has them in its LawInput, and says so by FrictionThreshold::varies)";
    faults.push_back(text.str());
  }

  void judge(const Strain &strain, const double N, const double (&trial)[2], const double (&k)[2],
             const double stick, const double twisting) {
    const double size = std::hypot(trial[0], trial[1]);
    const bool slips = N < 0. && (size > stick * -N || stick == 0.);
    std::array<double, 2> T = {0., 0.};
    if (N < 0. && !slips)
      T = {trial[0], trial[1]};
    else if (slips && form.dynamic_friction > 0.) {
      const DiscProjection disc(trial, k, form.dynamic_friction * -N);
      T = {disc.point[0], disc.point[1]};
    }
    const double tolerance = 1e-9 * (std::abs(N) + size);
    if (!(std::abs(stress[0] - N) <= tolerance) || (N < 0.) != (stress[0] < 0.))
      say("N =", stress[0], N);
    for (int i = 0; i < 2; ++i)
      if (!(std::abs(stress[1 + i] - T[i]) <= tolerance))
        say(i == 0 ? "T_y =" : "T_z =", stress[1 + i], T[i]);
    const double turned = form.patch_radius * (slips ? form.dynamic_friction : stick) * -N;
    const double moment = N >= 0.                                                 ? 0.
                          : form.patch_radius > 0. && std::abs(twisting) > turned ? turned
                          : form.torsional_rigidity > 0.                          ? twisting
                                                                                  : 0.;
    const double moment_tolerance = 1e-9 * std::abs(twisting) + tolerance * form.patch_radius +
                                    1e-15 * form.torsional_rigidity * std::abs(strain[3]);
    if (!(std::abs(stress[3] - moment) <= moment_tolerance))
      say("M =", stress[3], moment);
    if (slips != (new_state[form.was_slipping] != 0.))
      say("slip", new_state[form.was_slipping], slips ? 1. : 0.);
    for (int i = 0; (N >= 0. || stick > 0.) && i < 2; ++i) {
      const int place = i == 0 ? form.slip_y : form.slip_z;
      const double slip = N >= 0. ? strain[1 + i] : old_state[place] + (trial[i] - T[i]) / k[i];
      if (!(std::abs(new_state[place] - slip) <= 1e-9 * (std::abs(old_state[place]) + size / k[i])))
        say(i == 0 ? "irreversible strain in y" : "irreversible strain in z", new_state[place],
            slip);
    }
    if (form.torsional_rigidity > 0.) {
      const double twist =
          N >= 0. ? strain[3]
                  : old_state[form.twist] + (twisting - moment) / form.torsional_rigidity;
      if (!(std::abs(new_state[form.twist] - twist) <=
            1e-9 * (std::abs(strain[3]) + std::abs(old_state[form.twist]))))
        say("irreversible twist rate", new_state[form.twist], twist);
    }
    judge_memory();
  }

  /// The exact method writes its places and nothing else.
  void judge_memory() {
    for (int i = 0; i < law.n_internal_variables; ++i)
      if (!form.varies && i != form.slip_y && i != form.slip_z && i != form.twist &&
          i != form.was_slipping && new_state[i] != old_state[i])
        say("internal variable " + std::to_string(i) + ", which is none of its places,",
            new_state[i], old_state[i]);
  }

  double rigidity(const double of_form, const int i) const {
    return std::isfinite(of_form) ? of_form : tangent[n_support_strains * i + i];
  }

  const LawDescription &law;
  const std::vector<double> &parameters;
  FrictionThreshold form;
  Instant instant;
  std::vector<double> old_state, new_state;
  Strain stress{};
  std::array<double, n_support_strains * n_support_strains> tangent{};
};

} // namespace

std::string place_faults(const LawDescription &law, const FrictionThreshold &form) {
  std::map<int, std::string> names;
  for (const auto &[name, place] :
       {std::make_pair("slip_y", form.slip_y), std::make_pair("slip_z", form.slip_z),
        std::make_pair("twist", form.twist), std::make_pair("was_slipping", form.was_slipping)}) {
    if (place < 0 || place >= law.n_internal_variables)
      return std::string("its closed form has the place ") + name +
             " outside of the state, which has " + std::to_string(law.n_internal_variables) +
             " internal variables, read " + std::to_string(place);
    const auto [other, is_new] = names.emplace(place, name);
    if (!is_new)
      return "its closed form has the place " + std::to_string(place) + " twice, for " +
             other->second + " and " + name;
  }
  return "";
}

FrictionThreshold closed_form_at_rest(const LawDescription &law,
                                      const std::vector<double> &parameters) {
  // Places of a law that does not keep to its own number of internal variables read this.
  return form_at(law, parameters, {20., 0., 0., 0.},
                 std::vector<double>(law.n_internal_variables + 1, 0.));
}

std::vector<std::string> closed_form_faults(const LawDescription &law,
                                            const std::vector<double> &parameters) {
  if (law.threshold == nullptr)
    return {};
  if (law.kind != LawKind::support)
    return {"it has a closed form, which is for laws of supports alone: set "
            "LawDescription::threshold to null"};
  const FrictionThreshold form = closed_form_at_rest(law, parameters);
  std::vector<std::string> faults = faults_of_numbers(law, form);
  if (faults.empty())
    faults = faults_of_dependence(law, parameters, form);
  if (!faults.empty())
    return faults;
  Comparison comparison(law, parameters, form);
  comparison.run();
  return comparison.faults;
}

} // namespace frictionbeam
