// SPDX-License-Identifier: LGPL-2.1-or-later
#include <frictionbeam/law.h>

#include <algorithm>

/**
 * Elastic section of a pipe, equal about both axes:
 *   N = EA eps,  V = GA_s gamma,  M_x = GJ chi,  M_y = EI kappa_y,  M_z = EI kappa_z.
 */
namespace {

using namespace frictionbeam;

enum Parameter { EA, GA, GJ, EI, n_parameters };

constexpr LawParameter parameters[n_parameters] = {
    {"Axial rigidity", "N", 1., 0., 1e300, "Young's modulus times the metal's area"},
    {"Shear rigidity", "N", 1., 0., 1e300, "shear modulus times the effective shear area"},
    {"Torsional rigidity", "N m2", 1., 0., 1e300, "shear modulus times the torsion constant"},
    {"Bending rigidity", "N m2", 1., 0., 1e300, "Young's modulus times the moment of inertia"}};

class ElasticSection final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const double *const p = in.parameters;
    const double rigidity[n_section_strains] = {p[EA], p[GA], p[GA], p[GJ], p[EI], p[EI]};
    for (int i = 0; i < n_section_strains; ++i)
      out.stress[i] = rigidity[i] * in.strain[i];
    if (in.tangent != LawTangent::none) {
      std::fill(out.tangent, out.tangent + n_section_strains * n_section_strains, 0.);
      for (int i = 0; i < n_section_strains; ++i)
        out.tangent[(n_section_strains + 1) * i] = rigidity[i];
    }
    out.dissipation = 0.;
    out.stored_energy = 0.;
    for (int i = 0; i < n_section_strains; ++i)
      out.stored_energy += out.stress[i] * in.strain[i] / 2.;
    out.contact = ContactStatus::none;
    return LawStatus::ok;
  }
};

constexpr ElasticSection law;

double never_inelastic(const LawInput &) { return 0.; }

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {
    frictionbeam::law_interface_version,
    frictionbeam::LawKind::section,
    frictionbeam::n_section_strains,
    0,
    true,
    "elastic_section",
    "S. P. Timoshenko, Philosophical Magazine 41 (1921) 744-746, doi:10.1080/14786442108636264",
    n_parameters,
    parameters,
    &law,
    nullptr,
    nullptr,
    &never_inelastic};
