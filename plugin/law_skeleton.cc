// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A law to copy. It compiles, loads, and passes the conformance test: a one-way elastic support
// with viscous drag against sliding. Compile your copy with
//   find_package(FrictionBeam)  and  frictionbeam_add_law(my_law my_law.cc),
// or by hand with  g++ -std=c++17 -O2 -shared -fPIC -I<include> my_law.cc -o my_law.so
// (no deal.II: the same file then serves debug and release programs), check it with
//   frictionbeam-check-law my_law.so 'Drag=2'
// and name it in the parameter file:  set Law libraries = my_law.so
#include <frictionbeam/law.h>

#include <algorithm>

namespace {

using namespace frictionbeam;

// 1. The parameters: each once, with unit, default, bounds and meaning. The program makes entries
//    of the parameter file and their documentation out of this list.
enum Parameter { rigidity, drag, n_parameters };

constexpr LawParameter parameters[n_parameters] = {
    {"Axial rigidity", "N", 1e9, 0., 1e300, "ES of the element, in compression only"},
    {"Drag", "N s", 0., 0., 1e300, "shear force per rate of shear strain while in contact"}};

// 2. The law: stress, tangent and new internal variables from the strain at the end of the
//    increment and the old internal variables. No memory of its own, no exceptions; return
//    LawStatus::failed where it has no answer, and the program tries a smaller increment.
class Skeleton final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const double *const p = in.parameters;
    constexpr int n = n_support_strains;
    std::fill(out.stress, out.stress + n, 0.);
    if (in.tangent != LawTangent::none)
      std::fill(out.tangent, out.tangent + n * n, 0.);
    out.dissipation = 0.;

    const bool closed = in.strain[0] < 0.;
    out.contact = closed ? ContactStatus::closed : ContactStatus::open;
    if (closed) {
      out.stress[0] = p[rigidity] * in.strain[0];
      for (int i = 1; i <= 2; ++i) {
        out.stress[i] = p[drag] * in.strain_rate[i];
        out.dissipation += out.stress[i] * in.strain_rate[i] * in.time_increment;
      }
    }
    // 3. The tangent: the derivative of the stress above, or the elastic one if that is asked for.
    if (in.tangent != LawTangent::none && (closed || in.tangent == LawTangent::elastic)) {
      out.tangent[0] = p[rigidity];
      for (int i = 1; i <= 2; ++i)
        if (in.time_increment > 0.)
          out.tangent[(n + 1) * i] = p[drag] / in.time_increment;
    }
    return LawStatus::ok;
  }
};

constexpr Skeleton law;

} // namespace

// 4. What the program reads before it calls the law.
const frictionbeam::LawDescription frictionbeam_law = {
    frictionbeam::law_interface_version,
    frictionbeam::LawKind::support,
    frictionbeam::n_support_strains,
    0,                                      // internal variables
    true,                                   // symmetric tangent
    "skeleton",                             // the name in the parameter file
    "FrictionBeam, plugin/law_skeleton.cc", // where your law is from: author, title, doi
    n_parameters,
    parameters,
    &law,
    nullptr}; // a friction law may give its threshold in closed form here, see law_coulomb.cc
