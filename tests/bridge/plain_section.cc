// SPDX-License-Identifier: LGPL-2.1-or-later
// An elastic section that tells no more than it must: neither a bound of what is elastic, nor a
// report, nor an energy.
#include <frictionbeam/law.h>

#include <algorithm>

namespace {

using namespace frictionbeam;

constexpr LawParameter parameters[] = {{"Axial rigidity", "N", 1e9, 0., 1e300, "EA"},
                                       {"Shear rigidity", "N", 1e8, 0., 1e300, "GA, of both"},
                                       {"Torsional rigidity", "N m2", 1e6, 0., 1e300, "GJ"},
                                       {"Bending rigidity", "N m2", 1e6, 0., 1e300, "EI, of both"}};

struct PlainSection final : LawBase {
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    constexpr int parameter_of[] = {0, 1, 1, 2, 3, 3};
    if (in.tangent != LawTangent::none)
      std::fill(out.tangent, out.tangent + 36, 0.);
    for (int i = 0; i < 6; ++i) {
      const double stiffness = in.parameters[parameter_of[i]];
      out.stress[i] = stiffness * in.strain[i];
      if (in.tangent != LawTangent::none)
        out.tangent[7 * i] = stiffness;
    }
    return LawStatus::ok;
  }
};

constexpr PlainSection law;

} // namespace

const LawDescription frictionbeam_law = {law_interface_version,
                                         LawKind::section,
                                         n_section_strains,
                                         0,
                                         true,
                                         "plain_section",
                                         "a test",
                                         4,
                                         parameters,
                                         &law,
                                         nullptr};
