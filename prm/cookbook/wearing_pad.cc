// SPDX-License-Identifier: LGPL-2.1-or-later
// A support law of one's own: a rest whose friction grows with the way it has slipped, as a dry pad
// does whose coating wears off. See doc/cookbook/own_law.md.
#include <frictionbeam/law.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace frictionbeam;

enum Parameter { stiffness, fresh, worn, wear_length, n_parameters };

constexpr LawParameter parameters[n_parameters] = {
    {"Rigidity", "N", 1e9, 1., 1e300, "of the element, normal and tangential"},
    {"Fresh friction", "-", 0.1, 0., 10., "coefficient of the coated pad"},
    {"Worn friction", "-", 0.4, 0., 10., "coefficient when the coating has gone"},
    {"Wear length", "m", 0.05, 1e-9, 1e300, "way of slip over which 63 % of the coating goes"}};

/// Internal variables: irreversible shear strains and the way slipped so far [m].
enum State { slip_y, slip_z, way, n_states };

class WearingPad final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const double *const p = in.parameters;
    std::fill(out.stress, out.stress + n_support_strains, 0.);
    double tangent[n_support_strains][n_support_strains] = {};
    out.dissipation = 0.;
    out.new_state[slip_y] = in.old_state[slip_y];
    out.new_state[slip_z] = in.old_state[slip_z];
    out.new_state[way] = in.old_state[way];

    if (in.strain[0] >= 0.) { // lifted off: the next contact begins where it comes down
      out.new_state[slip_y] = in.strain[1];
      out.new_state[slip_z] = in.strain[2];
      out.contact = ContactStatus::open;
    } else {
      const double N = p[stiffness] * in.strain[0];
      // The coefficient is that of the way at the start of the increment.
      const double f =
          p[worn] + (p[fresh] - p[worn]) * std::exp(-in.old_state[way] / p[wear_length]);
      const double trial[2] = {p[stiffness] * (in.strain[1] - in.old_state[slip_y]),
                               p[stiffness] * (in.strain[2] - in.old_state[slip_z])};
      const double size = std::hypot(trial[0], trial[1]), limit = -f * N;
      out.stress[0] = N;
      tangent[0][0] = p[stiffness];
      if (size <= limit) {
        out.contact = ContactStatus::stick;
        for (int i = 0; i < 2; ++i) {
          out.stress[1 + i] = trial[i];
          tangent[1 + i][1 + i] = p[stiffness];
        }
      } else {
        out.contact = ContactStatus::slip;
        const double direction[2] = {trial[0] / size, trial[1] / size};
        const double slipped = (size - limit) / p[stiffness]; // a strain
        for (int i = 0; i < 2; ++i) {
          out.stress[1 + i] = limit * direction[i];
          out.new_state[i] = in.old_state[i] + slipped * direction[i];
          tangent[1 + i][0] = -f * p[stiffness] * direction[i];
          for (int j = 0; j < 2; ++j)
            tangent[1 + i][1 + j] =
                p[stiffness] * limit / size * ((i == j ? 1. : 0.) - direction[i] * direction[j]);
        }
        out.new_state[way] = in.old_state[way] + slipped * in.length;
        out.dissipation = limit * slipped;
      }
    }
    if (in.tangent == LawTangent::elastic) {
      std::fill(&tangent[0][0], &tangent[0][0] + n_support_strains * n_support_strains, 0.);
      for (int i = 0; i < 3; ++i)
        tangent[i][i] = p[stiffness];
    }
    if (in.tangent != LawTangent::none)
      std::copy(&tangent[0][0], &tangent[0][0] + n_support_strains * n_support_strains,
                out.tangent);
    return LawStatus::ok;
  }
};

const WearingPad law;

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {
    frictionbeam::law_interface_version,
    frictionbeam::LawKind::support,
    frictionbeam::n_support_strains,
    n_states,
    false, // the tangent of a slipping contact is not symmetric
    "wearing_pad",
    "FrictionBeam cookbook; an exponential wear of the coating, as an example",
    n_parameters,
    parameters,
    &law,
    nullptr}; // no threshold in closed form: Newton's method evaluates it
