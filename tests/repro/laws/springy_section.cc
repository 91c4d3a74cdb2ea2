// SPDX-License-Identifier: LGPL-2.1-or-later
// A user's own law of sections: elastic, by the rigidities that the section has.
#include <frictionbeam/law.h>

#include <algorithm>

namespace {

using namespace frictionbeam;

constexpr LawParameter parameters[] = {{"Axial rigidity", "N", 1., 0., 1e300, "EA"},
                                       {"Torsional rigidity", "N m2", 1., 0., 1e300, "GJ"},
                                       {"Bending rigidity", "N m2", 1., 0., 1e300, "EI"},
                                       {"Softness", "-", 1., 1., 1e3, "divides all of them"}};

class Springy final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const double *const p = in.parameters;
    const double rigidity[n_section_strains] = {p[0], 0., 0., p[1], p[2], p[2]};
    if (in.tangent != LawTangent::none)
      std::fill(out.tangent, out.tangent + n_section_strains * n_section_strains, 0.);
    for (int i = 0; i < n_section_strains; ++i) {
      out.stress[i] = rigidity[i] / p[3] * in.strain[i];
      if (in.tangent != LawTangent::none)
        out.tangent[(n_section_strains + 1) * i] = rigidity[i] / p[3];
    }
    out.dissipation = 0.;
    out.contact = ContactStatus::none;
    return LawStatus::ok;
  }
};
constexpr Springy law;

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {frictionbeam::law_interface_version,
                                                       frictionbeam::LawKind::section,
                                                       frictionbeam::n_section_strains,
                                                       0,
                                                       true,
                                                       "springy_section",
                                                       "the test's own",
                                                       4,
                                                       parameters,
                                                       &law,
                                                       nullptr};
