// SPDX-License-Identifier: LGPL-2.1-or-later
#include "results/spectrum/spectrum_response.h"

#include "base/number_text.h"
#include "results/frame/derived_cases.h"
#include "results/frame/frame_builder.h"
#include "results/spectrum/modal_combination.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace frictionbeam {

namespace {

using Sum = SpectrumSettings::Sum;

/// Modes of one frequency are one eigenspace, of which any basis is as good as another. [first,
/// last)
std::vector<std::pair<unsigned int, unsigned int>> eigenspaces(const std::vector<Mode> &modes) {
  constexpr double as_good_as_equal = 1e-5; // relative; nothing but a symmetry brings them so near
  std::vector<std::pair<unsigned int, unsigned int>> result;
  for (unsigned int k = 0; k < modes.size(); ++k)
    if (k > 0 &&
        modes[k].frequency - modes[k - 1].frequency <= as_good_as_equal * modes[k].frequency)
      result.back().second = k + 1;
    else
      result.emplace_back(k, k + 1);
  return result;
}

/// Of directions or groups, number by number.
Vector combined(const Sum how, const Vector &sum, const Vector &more) {
  return how == Sum::absolute ? Vector(sum.cwiseAbs() + more.cwiseAbs())
                              : Vector((sum.cwiseAbs2() + more.cwiseAbs2()).cwiseSqrt());
}

/// What the ground does in one direction: the periodic part of each eigenspace, and all that
/// follows the ground.
struct DirectionResponse {
  std::vector<Vector> periodic;
  Vector rigid;
};

class SpectrumResponse {
public:
  SpectrumResponse(const Model &model, const ModalAnalysis &analysis, Results &results,
                   const TakeModalResponse &take)
      : model(model), settings(model.scene.response), analysis(analysis), results(results),
        take(take), builder(model, true), zero(builder.make(analysis.at_rest().state)),
        n_numbers(numbers_of(zero).size()), spaces(eigenspaces(analysis.modes())),
        has_groups(std::any_of(model.scene.spectra.begin(), model.scene.spectra.end(),
                               [](const Spectrum &s) { return !s.supports.empty(); })) {
    for (unsigned int k = 0; k < analysis.modes().size(); ++k)
      shapes.push_back(numbers(analysis.of_mode(k)));
    for (const auto &space : spaces)
      frequencies.push_back(analysis.modes()[space.first].frequency);
    for (const Spectrum &spectrum : model.scene.spectra)
      for (const Mode &mode : analysis.modes())
        accelerations[&spectrum].push_back(spectrum.at(mode.frequency, settings.interpolation));
  }

  Frame operator()() {
    std::vector<DirectionResponse> responses;
    for (unsigned int d = 0; d < 3; ++d)
      responses.push_back(in_direction(d));
    return with_numbers(zero, settings.directions_first ? directions_first(responses)
                                                        : modes_first(responses));
  }

private:
  Vector numbers(const ModalAnalysis::Vibration &vibration) {
    return numbers_of(builder.make(vibration.state, vibration.accelerations));
  }

  DirectionResponse in_direction(const unsigned int d) {
    DirectionResponse response{std::vector<Vector>(spaces.size(), Vector::Zero(n_numbers)),
                               Vector::Zero(n_numbers)};
    std::vector<Vector> each(take ? shapes.size() : 0, Vector::Zero(n_numbers));
    Vector missing = Vector::Zero(n_numbers);
    const auto moves = [&](const Spectrum &spectrum) { return spectrum.factor[d] != 0.; };
    const std::vector<Spectrum> &spectra = model.scene.spectra;
    const auto n_moving = std::count_if(spectra.begin(), spectra.end(), moves);
    const bool any = n_moving > 0;
    adds_sizes = has_groups && n_moving > 1;
    for (const Spectrum &spectrum : spectra)
      if (moves(spectrum))
        add_spectrum(spectrum, d, response, each, missing);
    for (unsigned int k = 0; any && k < each.size(); ++k)
      take(k + 1, d, with_numbers(zero, each[k]));
    if (any && take && settings.missing_mass)
      take(0, d, with_numbers(zero, missing));
    return response;
  }

  void add_spectrum(const Spectrum &spectrum, const unsigned int d, DirectionResponse &response,
                    std::vector<Vector> &each, Vector &missing) {
    const std::vector<Mode> &modes = analysis.modes();
    const double factor = spectrum.factor[d];
    Vector left = analysis.support_motion(d, spectrum.supports), rigid = Vector::Zero(n_numbers);
    const Vector inertia = analysis.inertia(left);
    for (unsigned int space = 0; space < spaces.size(); ++space) {
      Vector periodic = Vector::Zero(n_numbers);
      for (unsigned int k = spaces[space].first; k < spaces[space].second; ++k) {
        const double gamma = modes[k].unknowns.dot(inertia), f = modes[k].frequency,
                     acceleration = accelerations.at(&spectrum)[k],
                     share = rigid_share(settings, f, acceleration, spectrum.at_zero_period());
        const Vector whole =
            factor * gamma * acceleration / std::pow(2. * dealii::numbers::PI * f, 2) * shapes[k];
        periodic += std::sqrt(1. - share * share) * whole;
        rigid += share * whole;
        left -= gamma * analysis.motion(k);
        results.excitations.push_back(
            {k + 1, d, spectrum.name, gamma, std::abs(factor) * acceleration, share});
        if (!each.empty())
          add_to_shape(whole, shapes[k], each[k]);
      }
      add(periodic, response.periodic[space]);
    }
    if (settings.missing_mass) {
      const Vector rest = factor * spectrum.at_zero_period() * numbers(analysis.of_inertia(left));
      rigid += rest;
      add_to_shape(rest, rest, missing);
    }
    add(rigid, response.rigid);
  }

  /// What moves alone keeps its signs, which cqc and the signed double sum multiply from mode to
  /// mode. Groups are added by sizes, which have none: close modes then act together, whatever the
  /// sign of their shapes, which is the safe side.
  void add(const Vector &share, Vector &sum) const {
    sum = adds_sizes ? combined(settings.groups, sum, share) : Vector(sum + share);
  }

  /// The same for one mode to be shown: with sizes, in the signs of its shape.
  void add_to_shape(const Vector &share, const Vector &shape, Vector &sum) const {
    add(share, sum);
    if (adds_sizes)
      sum = (shape.array() < 0.).select(-sum, sum);
  }

  Vector modes_first(const std::vector<DirectionResponse> &responses) const {
    Vector sum = Vector::Zero(n_numbers);
    for (const DirectionResponse &one : responses)
      sum = combined(settings.directions, sum, joined(one));
    return sum;
  }

  Vector directions_first(const std::vector<DirectionResponse> &responses) const {
    DirectionResponse all{std::vector<Vector>(spaces.size(), Vector::Zero(n_numbers)),
                          Vector::Zero(n_numbers)};
    for (const DirectionResponse &one : responses) {
      for (unsigned int space = 0; space < spaces.size(); ++space)
        all.periodic[space] =
            combined(settings.directions, all.periodic[space], one.periodic[space]);
      all.rigid = combined(settings.directions, all.rigid, one.rigid);
    }
    return joined(all);
  }

  Vector joined(const DirectionResponse &one) const {
    return combined(Sum::srss, combine_modes(one.periodic, frequencies, settings), one.rigid);
  }

  const Model &model;
  const SpectrumSettings &settings;
  const ModalAnalysis &analysis;
  Results &results;
  const TakeModalResponse &take;
  FrameBuilder builder;
  const Frame zero; ///< the line at rest
  const Eigen::Index n_numbers;
  const std::vector<std::pair<unsigned int, unsigned int>> spaces;
  const bool has_groups;
  bool adds_sizes = false;         ///< several groups in the direction at hand
  std::vector<Vector> shapes;      ///< numbers of the frames of the modes
  std::vector<double> frequencies; ///< of the eigenspaces
  /// Of each mode, whatever the direction: a spectrum of a record costs its oscillator each time
  /// [m/s2].
  std::map<const Spectrum *, std::vector<double>> accelerations;
};

/// Where Lindley and Yow's share would be above 1: RG 1.92 rev. 3 does not allow it there.
void remark_on_soft_modes(const Scene &scene, Results &results) {
  if (scene.response.rigid != SpectrumSettings::Rigid::lindley_yow)
    return;
  unsigned int highest = 0;
  for (const ModalExcitation &one : results.excitations)
    for (const Spectrum &spectrum : scene.spectra)
      if (spectrum.name == one.spectrum &&
          one.acceleration <
              std::abs(spectrum.factor[one.direction]) * spectrum.at_zero_period() * (1. - 1e-9))
        highest = std::max(highest, one.mode);
  if (highest > 0)
    results.remarks.push_back(
        "Lindley-Yow: at modes up to number " + std::to_string(highest) +
        " a spectrum lies below its zero-period acceleration, and these modes are taken for rigid "
        "there. NRC RG 1.92 rev. 3 does not allow the method for such modes; take gupta, or none.");
}

/// Without missing mass, what the modes leave out answers nothing: higher modes, and all mass at
/// supports, which is in no mode.
void remark_on_missing_mass(const Scene &scene, const ModalAnalysis &analysis, Results &results) {
  constexpr double negligible = 0.01; // of the mass
  if (scene.response.missing_mass)
    return;
  const auto text = [&](const double value, const char *const unit) {
    return rounded_number(value / scene.units.factor(unit), 3) + " " + scene.units.name(unit);
  };
  std::string list;
  for (const Spectrum &spectrum : scene.spectra)
    for (unsigned int d = 0; d < 3; ++d) {
      if (spectrum.factor[d] == 0.)
        continue;
      const double total = analysis.mass(analysis.support_motion(d, spectrum.supports));
      double left = total;
      for (const ModalExcitation &one : results.excitations)
        if (one.spectrum == spectrum.name && one.direction == d)
          left -= one.participation * one.participation;
      if (left > negligible * total)
        list += (list.empty() ? "" : "; ") + text(left, "kg") + " of " + text(total, "kg") +
                " in " + "xyz"[d] + " (Spectrum " + spectrum.name + ", " +
                text(left * std::abs(spectrum.factor[d]) * spectrum.at_zero_period(), "N") +
                " at its last acceleration)";
    }
  if (!list.empty())
    results.remarks.push_back(
        "The modes leave out mass, that at supports among it, whose forces are in no result: " +
        list + ". Set Response/Missing mass = true.");
}

/// From where on a curve that falls or rises to its last acceleration has it [Hz]; infinite of one
/// that has no other, and of a record.
double rigid_from(const Spectrum &spectrum) {
  const auto &curve = spectrum.curve;
  std::size_t first = curve.size() - 1;
  while (first > 0 && curve[first - 1].second == spectrum.at_zero_period())
    --first;
  return first > 0 ? curve[first].first : std::numeric_limits<double>::infinity();
}

/// Modes beyond the frequency from which on the ground's own acceleration is all there is move
/// together; squares take them as if they did not, and the more of them are asked for, the less
/// comes out.
void remark_on_rigid_modes(const Scene &scene, const ModalAnalysis &analysis, Results &results) {
  constexpr double negligible = 0.05; // of the mass
  if (scene.response.rigid != SpectrumSettings::Rigid::none ||
      scene.response.modes == SpectrumSettings::Modes::absolute)
    return;
  for (const Spectrum &spectrum : scene.spectra) {
    const double from = rigid_from(spectrum);
    const auto &modes = analysis.modes();
    const auto n = std::count_if(modes.begin(), modes.end(),
                                 [&](const Mode &mode) { return mode.frequency < from; });
    for (unsigned int d = 0; d < 3; ++d) {
      double sum = 0., largest = 0.;
      for (const ModalExcitation &one : results.excitations)
        if (one.spectrum == spectrum.name && one.direction == d && one.mode > n) {
          const double mass = one.participation * one.participation;
          sum += mass;
          largest = std::max(largest, mass);
        }
      const double total = analysis.mass(analysis.support_motion(d, spectrum.supports));
      if (!(sum - largest > negligible * total))
        continue;
      results.remarks.push_back(
          "Modes from number " + std::to_string(n + 1) + " on, with " +
          rounded_number(100. * sum / total, 2) + " % of the mass in " + "xyz"[d] +
          ", lie where Spectrum " + spectrum.name + " has its last acceleration (from " +
          rounded_number(from) +
          " Hz on). There all follow the ground together; squares of them give too little, the "
          "less the more of them there are. NRC RG 1.92 rev. 3 leaves them to the missing mass: " +
          (n > 0 ? "set Modes/Number = " + std::to_string(n) +
                       " with Response/Missing mass = true, or take a Rigid part."
                 : "take Response/Missing mass = true with a Rigid part."));
      return;
    }
  }
}

} // namespace

Frame spectrum_response(const Model &model, const ModalAnalysis &analysis, Results &results,
                        const TakeModalResponse &take) {
  Frame frame = SpectrumResponse(model, analysis, results, take)();
  remark_on_soft_modes(model.scene, results);
  remark_on_missing_mass(model.scene, analysis, results);
  remark_on_rigid_modes(model.scene, analysis, results);
  frame.name = spectrum_case;
  become_case(frame, true);
  frame.step = model.scene.steps.size();
  return frame;
}

} // namespace frictionbeam
