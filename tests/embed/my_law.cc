// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A user's law: a sliding pad whose friction coefficient falls with the load,
//   |T| <= g(N) = f |N| / (1 + |N|/N_half),  without resistance to lifting off.
#include <frictionbeam/law.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace frictionbeam;

enum Parameter { axial_rigidity, shear_rigidity, friction, half_load, n_parameters };

constexpr LawParameter parameters[n_parameters] = {
    {"Axial rigidity", "N", 1e9, 0., 1e300, "ES of the element, in compression"},
    {"Shear rigidity", "N", 1e9, 0., 1e300, "GS of the element"},
    {"Friction coefficient", "-", 0.2, 0., 10., "of the unloaded pad"},
    {"Half load", "N", 1e4, 1e-300, 1e300, "load at which the coefficient has halved"}};

enum State { slip_y, slip_z, n_states };

class Pad final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const double *const p = in.parameters;
    constexpr int n = n_support_strains;
    double C[n][n] = {};
    std::fill(out.stress, out.stress + n, 0.);
    std::copy(in.strain + 1, in.strain + 3, out.new_state); // open: slip follows the node
    out.dissipation = 0.;
    out.contact = ContactStatus::open;
    if (in.strain[0] < 0.) {
      const double k = p[shear_rigidity], N = p[axial_rigidity] * in.strain[0];
      const double relative = 1. - N / p[half_load];
      const double g = p[friction] * -N / relative;
      const double dg_dN = -p[friction] / (relative * relative);
      const double trial[2] = {k * (in.strain[1] - in.old_state[slip_y]),
                               k * (in.strain[2] - in.old_state[slip_z])};
      const double size = std::hypot(trial[0], trial[1]);
      const bool slips = size > g;
      const double scale = slips ? g / size : 1.;
      out.stress[0] = N;
      C[0][0] = p[axial_rigidity];
      for (int i = 0; i < 2; ++i) {
        out.stress[1 + i] = scale * trial[i];
        out.new_state[i] = in.strain[1 + i] - out.stress[1 + i] / k;
        C[1 + i][1 + i] = scale * k;
        if (!slips)
          continue;
        const double direction = trial[i] / size;
        C[1 + i][0] = dg_dN * p[axial_rigidity] * direction;
        for (int j = 0; j < 2; ++j)
          C[1 + i][1 + j] -= scale * k * direction * trial[j] / size;
      }
      if (slips)
        out.dissipation = g * (size - g) / k;
      out.contact = slips ? ContactStatus::slip : ContactStatus::stick;
    }
    if (in.tangent == LawTangent::elastic) {
      std::fill(&C[0][0], &C[0][0] + n * n, 0.);
      C[0][0] = p[axial_rigidity];
      C[1][1] = C[2][2] = p[shear_rigidity];
    }
    if (in.tangent != LawTangent::none)
      std::copy(&C[0][0], &C[0][0] + n * n, out.tangent);
    return LawStatus::ok;
  }
};

constexpr Pad law;

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {frictionbeam::law_interface_version,
                                                       frictionbeam::LawKind::support,
                                                       frictionbeam::n_support_strains,
                                                       n_states,
                                                       false, // symmetric tangent
                                                       "pad",
                                                       "FrictionBeam, doc/embedding.md",
                                                       n_parameters,
                                                       parameters,
                                                       &law,
                                                       nullptr};
