// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/generated/generated.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace frictionbeam::generated {

namespace {

/**
 * m x'' + k1 x + T = 0 with T = k2 (x - x_p), |T| <= F: exact, from event to event. While it
 * sticks, x swings about k2 x_p/(k1+k2) with frequency sqrt((k1+k2)/m); while it slips in direction
 * s, about -s F/k1 with sqrt(k1/m). Slip begins where |x - x_p| = F/k2 and ends where the velocity
 * is zero.
 */
class ExactOscillator {
public:
  ExactOscillator(const double m, const double k1, const double k2, const double F, const double x0,
                  const double v0, const double end_time)
      : delta(F / k2) {
    const double w_stick = std::sqrt((k1 + k2) / m), w_slip = std::sqrt(k1 / m);
    double t = 0., x = x0, v = v0, x_p = x0; // no friction force at the start
    bool sticks = true;
    double last_slip = 0.; // its direction
    while (t < end_time) {
      Phase phase{t, 0., 0., 0., 0.};
      double duration;
      if (sticks) {
        phase.w = w_stick;
        phase.centre = k2 * x_p / (k1 + k2);
        set(phase, x, v);
        duration = time_to_leave(phase, x_p, last_slip);
      } else {
        const double s = std::copysign(1., v);
        phase.w = w_slip;
        phase.centre = -s * F / k1;
        set(phase, x, v);
        // Zero velocity: w t + angle at the next multiple of pi.
        duration = time_to_angle(phase, s > 0. ? 0. : pi);
        if (std::isfinite(duration))
          x_p = phase.at(t + duration) - s * delta;
        last_slip = s;
      }
      phases.push_back(phase);
      if (!std::isfinite(duration))
        break;
      t += duration;
      x = phase.at(t);
      v = sticks ? phase.velocity_at(t) : 0.;
      sticks = !sticks;
    }
  }

  double operator()(const double t) const {
    auto phase = std::upper_bound(phases.begin(), phases.end(), t,
                                  [](const double time, const Phase &p) { return time < p.start; });
    return (phase == phases.begin() ? phase : phase - 1)->at(t);
  }

private:
  static constexpr double pi = 3.14159265358979323846;

  /// x = centre + amplitude cos(w (t - start) + angle)
  struct Phase {
    double start, w, centre, amplitude, angle;
    double at(const double t) const {
      return centre + amplitude * std::cos(w * (t - start) + angle);
    }
    double velocity_at(const double t) const {
      return -amplitude * w * std::sin(w * (t - start) + angle);
    }
  };

  static void set(Phase &phase, const double x, const double v) {
    phase.amplitude = std::hypot(x - phase.centre, v / phase.w);
    phase.angle = std::atan2(-v / phase.w, x - phase.centre);
  }

  /// Time from the phase's start until its argument is @p angle, modulo 2 pi; more than zero.
  static double time_to_angle(const Phase &phase, const double angle) {
    double difference = std::fmod(angle - phase.angle, 2. * pi);
    if (difference <= 0.)
      difference += 2. * pi;
    return difference / phase.w;
  }

  /// Time until |x - x_p| = delta on the way out; infinite if the motion stays inside. It starts at
  /// rest on the side of the last slip, if there was one, and only touches that side again.
  double time_to_leave(const Phase &phase, const double x_p, const double last_slip) const {
    double earliest = std::numeric_limits<double>::infinity();
    for (const double s : {1., -1.}) {
      const double cosine = (x_p + s * delta - phase.centre) / phase.amplitude;
      if (s == last_slip || !(std::abs(cosine) < 1.))
        continue;
      // Outwards: velocity of the sign of s, so sin(argument) of the opposite one.
      earliest = std::min(earliest, time_to_angle(phase, -s * std::acos(cosine)));
    }
    return earliest;
  }

  double delta;
  std::vector<Phase> phases;
};

} // namespace

void declare_oscillator(ParameterReader &in) {
  in.declare_number("Mass", 1., "kg", positive, 1e300, "On the spring.");
  in.declare_number("Spring stiffness", 1., "N/m", positive, 1e300, "k1, to the ground.");
  in.declare_number("Friction stiffness", 1., "N/m", positive, 1e300,
                    "k2, of the friction support while it sticks.");
  in.declare_number("Friction force", 1., "N", positive, 1e300, "F_D, at which it slips.");
  in.declare_number("Initial displacement", 10., "m", -1e300, 1e300,
                    "From the relaxed spring; the friction support starts without force.");
  in.declare_number("Initial velocity", 0.5, "m/s", -1e300, 1e300, "Along x.");
  in.declare_number("End time", 20., "s", positive, 1e300, "Of the analysis.");
}

void build_oscillator(const ParameterReader &in, const LawLibrary &laws, Scene &scene) {
  const double m = in.number("Mass"), k1 = in.number("Spring stiffness"),
               k2 = in.number("Friction stiffness"), F = in.number("Friction force"),
               x0 = in.number("Initial displacement"), v0 = in.number("Initial velocity"),
               end_time = in.number("End time");
  constexpr double friction = 0.5;

  scene.free_motions = {{true, false, false, false, false, false}};
  scene.points = {{"mass", Point3(0., 0., 0.)}};
  scene.monitors = {"mass"};
  scene.masses = {{"block", {"mass"}, m}};
  scene.springs = {{"spring", "mass", "", {{k1, 0., 0., 0., 0., 0.}}}};
  FrictionSupport slider = coulomb_support(laws, "slider", friction, k2, k2, F / friction);
  slider.placement.points = {"mass"};
  scene.supports = {slider};
  scene.initial = {{{"mass"}, {}, {{x0, 0., 0., 0., 0., 0.}}, {{v0, 0., 0., 0., 0., 0.}}, ""}};
  LoadStep step;
  step.name = "swing";
  step.transient = true;
  step.duration = end_time;
  scene.steps = {step};

  const ExactOscillator exact(m, k1, k2, F, x0, v0, end_time);
  scene.exact = ExactHistory{"mass", 0, exact};
  Quantity error;
  error.name = "max_error";
  error.what = "max_error";
  error.where = "mass";
  error.reference = 0.;
  error.source = "exact solution, event by event";
  scene.quantities = {error};
}

} // namespace frictionbeam::generated
