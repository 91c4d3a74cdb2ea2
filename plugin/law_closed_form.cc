// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/disc_projection.h>
#include <frictionbeam/law_closed_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

namespace frictionbeam {

namespace {

using Strain = std::array<double, n_support_strains>;

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
  std::set<int> places;
  for (const auto &[name, place] :
       {std::make_pair("slip_y", t.slip_y), std::make_pair("slip_z", t.slip_z),
        std::make_pair("twist", t.twist), std::make_pair("was_slipping", t.was_slipping)}) {
    require(place >= 0 && place < law.n_internal_variables,
            std::string("the place ") + name + " outside of the state, which has " +
                std::to_string(law.n_internal_variables) + " internal variables",
            place);
    require(places.insert(place).second, std::string("the place ") + name + " twice", place);
  }
  require(t.static_friction >= 0. && std::isfinite(t.static_friction),
          "a static coefficient below 0 or not finite", t.static_friction);
  require(t.dynamic_friction >= 0. && t.dynamic_friction <= t.static_friction,
          "a dynamic coefficient outside of 0 to the static one", t.dynamic_friction);
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

/// One call of the law, and the same increment by its closed form.
class Comparison {
public:
  Comparison(const LawDescription &law, const std::vector<double> &parameters,
             const FrictionThreshold &form)
      : law(law), parameters(parameters), form(form), old_state(law.n_internal_variables, 0.),
        new_state(old_state) {}

  std::set<std::string> faults;

  /// Compare on strains from a tenth of the stick limit to ten times the limit, open and closed,
  /// from rest and from slip.
  void run() {
    for (const double temperature : {20., 150.})
      for (const double rate : {0., 0.3})
        for (const double press : {-1e-2, -1e-5, 1e-4})
          for (const double old_slip : {0., 2e-4})
            for (const double was_slipping : {0., 1.})
              for (const double share : {0.1, 0.9, 1.1, 10.})
                for (const double angle : {0.3, 2., 4.4})
                  compare({press - form.gap / length, 0., 0., 0.}, share, angle, old_slip,
                          was_slipping, temperature, rate);
  }

private:
  static constexpr double length = 0.5;

  LawStatus evaluate(const Strain &strain, const double temperature, const double rate,
                     const LawTangent kind) {
    const double strain_rate[n_support_strains] = {0., rate, -rate, 0.};
    const double displacement[3] = {strain[0] * length, strain[1] * length, strain[2] * length};
    const LawInput input{
        parameters.data(), strain.data(),    strain_rate, displacement, length, 1., 0.25,
        temperature,       old_state.data(), kind};
    LawOutput output{stress.data(), tangent.data(), new_state.data(), 0., ContactStatus::none};
    return law.law->integrate(input, output);
  }

  void compare(Strain strain, const double share, const double angle, const double old_slip,
               const double was_slipping, const double temperature, const double rate) {
    old_state[form.slip_y] = old_slip;
    old_state[form.slip_z] = -0.5 * old_slip;
    old_state[form.was_slipping] = was_slipping;
    if (evaluate(strain, temperature, rate, LawTangent::elastic) != LawStatus::ok)
      return;
    // A rigid contact has no stiffness of its own: what the law takes for it is not judged.
    const double k[2] = {rigidity(form.shear_rigidity_y, 1), rigidity(form.shear_rigidity_z, 2)};
    const double opening = strain[0] + form.gap / length;
    const double N =
        opening >= 0.
            ? 0.
            : (std::isfinite(form.axial_rigidity) ? form.axial_rigidity * opening : stress[0]);
    const double stick = was_slipping != 0. ? form.dynamic_friction : form.static_friction;
    // A share of the limit in the direction given, on top of the old slip.
    const double reach = stick > 0. ? share * stick * std::abs(N) : share;
    const double trial[2] = {reach * std::cos(angle), reach * std::sin(angle)};
    // Where the strains of friction drown in the rounding of the slip, nothing can be told.
    if (std::max(k[0], k[1]) * old_slip * 1e-15 > 1e-10 * reach)
      return;
    strain[1] = old_state[form.slip_y] + trial[0] / k[0];
    strain[2] = old_state[form.slip_z] + trial[1] / k[1];
    // The twist likewise, beyond the patch's limit where the friction is beyond its own.
    const double limit = form.patch_radius * stick * std::abs(N);
    const bool turns = form.torsional_rigidity > 0.; // else there is nothing that a patch limits
    const double moment = !turns       ? 0.
                          : limit > 0. ? share * limit
                                       : form.torsional_rigidity * share * 1e-3;
    strain[3] = turns ? moment / form.torsional_rigidity : 0.;
    if (evaluate(strain, temperature, rate, LawTangent::none) != LawStatus::ok)
      return;
    judge(N, trial, k, stick, moment, temperature, rate);
  }

  void judge(const double N, const double (&trial)[2], const double (&k)[2], const double stick,
             const double twisting, const double temperature, const double rate) {
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
    const auto say = [&](const std::string &what, const double found, const double expected) {
      std::ostringstream text;
      text << "its closed form disagrees with integrate(): " << what << ' ' << expected
           << " by the closed form, " << found << " by integrate()";
      if (temperature != 20. || rate != 0.)
        text << " (temperature " << temperature << " degC, rates of " << rate
             << " 1/s, which a closed form cannot know)";
      if (faults.empty()) // the first one tells enough
        faults.insert(text.str());
    };
    if (std::abs(stress[0] - N) > tolerance || (N < 0.) != (stress[0] < 0.))
      say("N =", stress[0], N);
    for (int i = 0; i < 2; ++i)
      if (std::abs(stress[1 + i] - T[i]) > tolerance)
        say(i == 0 ? "T_y =" : "T_z =", stress[1 + i], T[i]);
    const double turned = form.patch_radius * (slips ? form.dynamic_friction : stick) * -N;
    const double moment = N >= 0.                                                 ? 0.
                          : form.patch_radius > 0. && std::abs(twisting) > turned ? turned
                          : form.torsional_rigidity > 0.                          ? twisting
                                                                                  : 0.;
    if (std::abs(stress[3] - moment) > 1e-9 * std::abs(twisting) + tolerance * form.patch_radius)
      say("M =", stress[3], moment);
    if (N < 0. && slips != (new_state[form.was_slipping] != 0.))
      say("slip", new_state[form.was_slipping], slips ? 1. : 0.);
    for (int i = 0; N < 0. && stick > 0. && i < 2; ++i) {
      const int place = i == 0 ? form.slip_y : form.slip_z;
      const double slip = old_state[place] + (trial[i] - T[i]) / k[i];
      if (std::abs(new_state[place] - slip) > 1e-9 * (std::abs(old_state[place]) + size / k[i]))
        say(i == 0 ? "irreversible strain in y" : "irreversible strain in z", new_state[place],
            slip);
    }
  }

  double rigidity(const double of_form, const int i) const {
    return std::isfinite(of_form) ? of_form : tangent[n_support_strains * i + i];
  }

  const LawDescription &law;
  const std::vector<double> &parameters;
  const FrictionThreshold &form;
  std::vector<double> old_state, new_state;
  Strain stress{};
  std::array<double, n_support_strains * n_support_strains> tangent{};
};

} // namespace

std::vector<std::string> closed_form_faults(const LawDescription &law,
                                            const std::vector<double> &parameters) {
  if (law.threshold == nullptr)
    return {};
  FrictionThreshold form{};
  law.threshold(parameters.data(), form);
  std::vector<std::string> faults = faults_of_numbers(law, form);
  if (!faults.empty())
    return faults;
  Comparison comparison(law, parameters, form);
  comparison.run();
  return {comparison.faults.begin(), comparison.faults.end()};
}

} // namespace frictionbeam
