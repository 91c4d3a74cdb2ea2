// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/disc_projection.h>
#include <frictionbeam/law.h>

#include <algorithm>
#include <cmath>
#include <limits>

/**
 * Coulomb friction with unilateral contact on the generalized stresses of the friction element
 * (Millard, Prost, Ricard, SMiRT 7, 1983, sections 2.1 to 2.3). With g the gap, l the length:
 *
 *   N = ES (eps + g/l) if negative, else N = T = 0 (open; plastic slip then follows the node);
 *   T* = GS (gamma - gamma_p),  T = T* while |T*| <= f |N|,
 *   else T is the point of |T| = f |N| nearest to T* in the norm of GS^-1 (return mapping) and
 *   gamma_p grows by GS^-1 (T* - T): with equal shear rigidities along T*, no normal strain.
 *
 * A contact that slips obeys the dynamic coefficient until it sticks again. Torsion is elastic, or
 * limited by f |N| r if a patch radius r is given.
 */
namespace {

using namespace frictionbeam;

enum Parameter { ES, GS, shear_ratio, f_static, f_dynamic, gap, GJ, patch_radius, n_parameters };

constexpr double infinity = 1e300;

constexpr LawParameter parameters[n_parameters] = {
    {"Axial rigidity", "N", 0., 0., infinity,
     "ES of the friction element; ES over its length is the contact's normal stiffness. 0: rigid "
     "(return mapping alone then takes 1e9 N)"},
    {"Shear rigidity", "N", 0., 0., infinity,
     "GS_y of the friction element; GS over its length is the tangential stiffness. 0: rigid "
     "(return mapping alone then takes 1e9 N)"},
    {"Shear rigidity ratio", "-", 1., 1e-6, 1e6,
     "GS_z over GS_y: along t1 of a support over along its t2; of a body in space along t2 over "
     "along t1"},
    {"Friction coefficient", "-", 0.3, 0., 100., "f at which sticking ends"},
    {"Dynamic friction coefficient", "-", -1., -1., 100.,
     "f while slipping, never above the other; -1: equal to it"},
    {"Gap", "m", 0., 0., infinity, "distance to travel before contact"},
    {"Torsional rigidity", "N m2", 0., 0., infinity, "GJ about the contact's normal"},
    {"Patch radius", "m", 0., 0., infinity, "limits the torsional moment to f|N|r; 0: no limit"}};

enum State { slip_y, slip_z, twist, was_slipping, n_states };

double dynamic_coefficient(const double *p) {
  return p[f_dynamic] < 0. ? p[f_static] : std::min(p[f_dynamic], p[f_static]);
}

const char *fault(const double *p) {
  if (p[f_dynamic] == -1. || (p[f_dynamic] >= 0. && p[f_dynamic] <= p[f_static]))
    return nullptr;
  return "a Dynamic friction coefficient from 0 to the Friction coefficient, or -1: a Friction "
         "coefficient as large, or leaving Dynamic friction coefficient out";
}

/// Rigidity of the return mapping: it needs a finite one where the user wants a rigid contact.
double finite(const double rigidity) { return rigidity > 0. ? rigidity : 1e9; }

class Coulomb final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const double *const p = in.parameters;
    const double ES = finite(p[::ES]), GS = finite(p[::GS]);
    const double k[2] = {GS, GS * p[shear_ratio]};
    const double opening = in.strain[0] + p[gap] / in.length;
    double tangent[n_support_strains][n_support_strains] = {};
    const double old_slip[2] = {in.old_state[slip_y], in.old_state[slip_z]};

    std::fill(out.stress, out.stress + n_support_strains, 0.);
    out.dissipation = 0.;
    if (opening >= 0.) {
      out.new_state[slip_y] = in.strain[1];
      out.new_state[slip_z] = in.strain[2];
      out.new_state[twist] = in.strain[3];
      out.new_state[was_slipping] = 0.;
      out.contact = ContactStatus::open;
    } else {
      const double N = ES * opening;
      const double dynamic = dynamic_coefficient(p);
      const double trial[2] = {k[0] * (in.strain[1] - old_slip[0]),
                               k[1] * (in.strain[2] - old_slip[1])};
      const double size = std::hypot(trial[0], trial[1]);
      const double f = in.old_state[was_slipping] != 0. ? dynamic : p[f_static];
      const bool slips = size > f * -N || f == 0.;
      out.stress[0] = N;
      tangent[0][0] = ES;
      std::copy(old_slip, old_slip + 2, out.new_state);
      if (!slips) {
        for (int i = 0; i < 2; ++i) {
          out.stress[1 + i] = trial[i];
          tangent[1 + i][1 + i] = k[i];
        }
      } else
        slide(in, trial, k, dynamic, f, N, out, tangent);
      out.new_state[was_slipping] = slips ? 1. : 0.;
      out.contact = p[f_static] == 0. ? ContactStatus::closed
                    : slips           ? ContactStatus::slip
                                      : ContactStatus::stick;
      turn(in, (slips ? dynamic : p[f_static]), N, out, tangent);
    }

    if (in.tangent == LawTangent::elastic) {
      const double diagonal[n_support_strains] = {ES, k[0], k[1], p[GJ]};
      for (int i = 0; i < n_support_strains; ++i)
        for (int j = 0; j < n_support_strains; ++j)
          out.tangent[n_support_strains * i + j] = i == j ? diagonal[i] : 0.;
    } else if (in.tangent == LawTangent::consistent)
      std::copy(&tangent[0][0], &tangent[0][0] + n_support_strains * n_support_strains,
                out.tangent);
    return LawStatus::ok;
  }

private:
  /// Return to the circle of radius f|N|, with stress, state, dissipation and tangent. Where the
  /// contact lets go of a larger friction, what is stored down to that of sliding is lost.
  /// @param held coefficient up to which it has held
  static void slide(const LawInput &in, const double (&trial)[2], const double (&k)[2],
                    const double f, const double held, const double N, LawOutput &out,
                    double (&tangent)[n_support_strains][n_support_strains]) {
    const double g = f * -N, part_held = held > f ? held * -N / std::hypot(trial[0], trial[1]) : 0.;
    const auto let_go = [&](const int i, const double force) {
      const double lost = held > f ? part_held * trial[i] - force : 0.;
      out.dissipation += lost * lost / (2. * k[i]);
    };
    if (g == 0.) { // frictionless: the slip follows the node
      for (int i = 0; i < 2; ++i) {
        out.new_state[i] = in.strain[1 + i];
        let_go(i, 0.);
      }
      return;
    }
    const DiscProjection on_disc(trial, k, g);
    for (int i = 0; i < 2; ++i) {
      let_go(i, on_disc.point[i]);
      const double slip = (trial[i] - on_disc.point[i]) / k[i];
      out.stress[1 + i] = on_disc.point[i];
      out.new_state[i] = in.old_state[i] + slip;
      out.dissipation += slip * on_disc.point[i];
      for (int j = 0; j < 2; ++j)
        tangent[1 + i][1 + j] = on_disc.by_trial[i][j] * k[j];
      tangent[1 + i][0] = on_disc.by_radius[i] * -f * finite(in.parameters[ES]);
    }
  }

  /// Torsional moment about the normal: elastic, limited by f|N|r if there is a patch.
  static void turn(const LawInput &in, const double f, const double N, LawOutput &out,
                   double (&tangent)[n_support_strains][n_support_strains]) {
    const double *const p = in.parameters;
    const double trial = p[GJ] * (in.strain[3] - in.old_state[twist]);
    const double limit = f * -N * p[patch_radius];
    out.new_state[twist] = in.old_state[twist];
    if (p[patch_radius] == 0. || std::abs(trial) <= limit) {
      out.stress[3] = trial;
      tangent[3][3] = p[GJ];
    } else {
      out.stress[3] = std::copysign(limit, trial);
      tangent[3][0] = std::copysign(f * p[patch_radius] * finite(p[ES]), -trial);
      const double slip = (trial - out.stress[3]) / p[GJ];
      out.new_state[twist] += slip;
      out.dissipation += out.stress[3] * slip;
    }
  }
};

constexpr Coulomb law;

double or_rigid(const double rigidity) {
  return rigidity > 0. ? rigidity : std::numeric_limits<double>::infinity();
}

void threshold(const LawInput &in, FrictionThreshold &t) {
  const double *const p = in.parameters;
  t.static_friction = p[f_static];
  t.dynamic_friction = dynamic_coefficient(p);
  t.gap = p[gap];
  t.axial_rigidity = or_rigid(p[ES]);
  t.shear_rigidity_y = or_rigid(p[GS]);
  t.shear_rigidity_z = or_rigid(p[GS]) * p[shear_ratio];
  t.torsional_rigidity = p[GJ];
  t.patch_radius = p[patch_radius];
  t.slip_y = slip_y;
  t.slip_z = slip_z;
  t.twist = twist;
  t.was_slipping = was_slipping;
}

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {
    frictionbeam::law_interface_version,
    frictionbeam::LawKind::support,
    frictionbeam::n_support_strains,
    n_states,
    false,
    "coulomb",
    "A. Millard, J. M. Prost, A. Ricard, Friction finite elements for numerical analysis of piping "
    "systems, SMiRT 7, Chicago, 1983",
    n_parameters,
    parameters,
    &law,
    &threshold,
    nullptr,
    nullptr,
    nullptr,
    nullptr,
    &fault};
