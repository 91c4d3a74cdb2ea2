// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law.h>

#include <algorithm>
#include <cmath>

/**
 * A snubber along the normal: nothing in static steps, free in slow motion, stiff in fast motion.
 * A static step, which takes no time, is the slowest motion: one that was locked lets go in it.
 *
 * With a locking velocity of 0 it locks as soon as time passes. Otherwise, while the rate of its
 * length stays below the locking velocity (and its change below the locking acceleration, where one
 * is given) it follows with a drag force against the motion at most. Above, it locks: a spring k
 * from where it locked, with a dead band b on either side, F = k (d - d_lock
 * -+ b). It lets go when its force has come back to zero, or has gone through zero since the
 * last increment, and the motion is slow again: never while its force keeps its sign. It pulls and
 * pushes. The state is that of the end of the increment, the rate that of its middle: order 1
 * in time at locking and with drag.
 */
namespace {

using namespace frictionbeam;

enum Parameter { stiffness, velocity, acceleration, dead_band, drag, n_parameters };

constexpr LawParameter parameters[n_parameters] = {
    {"Locked stiffness", "N/m", 1e10, 1e-300, 1e300,
     "k, when it is locked; the default is as good as rigid for a pipe"},
    {"Locking velocity", "m/s", 0., 0., 1e300,
     "above which it locks; 0: in any motion that takes time"},
    {"Locking acceleration", "m/s2", 0., 0., 1e300,
     "above which it locks too; 0: by velocity alone"},
    {"Dead band", "m", 0., 0., 1e300, "b, play on either side when it is locked"},
    {"Drag", "N s/m", 0., 0., 1e300, "force per velocity when it is free"}};

enum State { is_locked, position, rate_before, side, n_states }; // side: of its force, -1, 0, 1

class Snubber final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const double *const p = in.parameters;
    const double l = in.length, d = l * in.strain[0], rate = l * in.strain_rate[0],
                 dt = in.time_increment;
    std::fill(out.stress, out.stress + n_support_strains, 0.);
    if (in.tangent != LawTangent::none)
      std::fill(out.tangent, out.tangent + n_support_strains * n_support_strains, 0.);
    if (in.tangent == LawTangent::elastic && dt > 0.)
      out.tangent[0] = p[stiffness] * l;
    std::copy(in.old_state, in.old_state + n_states, out.new_state);
    out.new_state[rate_before] = dt > 0. ? rate : 0.;
    out.dissipation = 0.;

    const double change = dt > 0. ? std::abs(rate - in.old_state[rate_before]) / dt : 0.;
    const bool fast =
        std::abs(rate) > p[velocity] || (p[acceleration] > 0. && change > p[acceleration]);
    const double before = d - rate * dt;
    bool locked = in.old_state[is_locked] != 0. && dt > 0.;
    double lock = in.old_state[position];
    if (!locked && fast) {
      locked = true;
      lock = before;
    }
    const double stretch = d - lock;
    const double force = p[stiffness] * (stretch > p[dead_band]    ? stretch - p[dead_band]
                                         : stretch < -p[dead_band] ? stretch + p[dead_band]
                                                                   : 0.);
    if (locked && !fast && (force == 0. || force * in.old_state[side] < 0.))
      locked = false;
    out.new_state[side] = !locked || force == 0. ? 0. : std::copysign(1., force);
    out.new_state[is_locked] = locked ? 1. : 0.;
    out.new_state[position] = locked ? lock : d;
    out.contact = locked ? ContactStatus::stick : ContactStatus::slip;
    if (locked) {
      out.stress[0] = force;
      if (in.tangent == LawTangent::consistent && force != 0.)
        out.tangent[0] = p[stiffness] * l;
    } else {
      out.stress[0] = p[drag] * rate;
      out.dissipation = p[drag] * rate * rate * dt / l;
      if (in.tangent == LawTangent::consistent && dt > 0.)
        out.tangent[0] = p[drag] * l / dt;
    }
    return LawStatus::ok;
  }
};

constexpr Snubber law;

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {
    frictionbeam::law_interface_version,
    frictionbeam::LawKind::support,
    frictionbeam::n_support_strains,
    n_states,
    true,
    "snubber",
    "Mechanical and hydraulic snubbers, locking by velocity or acceleration",
    n_parameters,
    parameters,
    &law,
    nullptr};
