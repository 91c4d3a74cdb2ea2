// SPDX-License-Identifier: LGPL-2.1-or-later
#include "section/ring_increment.h"

#include <optional>

/**
 * Straight pipe of fibres that yield and creep. The axial strain is plane over the section, the
 * hoop stress follows from the pressure, p r/t, and the shear stress is one over each ring of
 * fibres, because the wall's axial balance asks for it; section/fibre.h has the law of a fibre,
 * section/fibre_ring.h the shear's equation. Shear forces are elastic, and do not yield.
 *
 * Without creep an increment is one implicit step, with creep two (section/ring_increment.h).
 *
 * stored_energy has the springs, what hardening stores, and the potential of a pressure that stays.
 */
namespace {

using namespace frictionbeam;
using section::FibrePipe;

constexpr LawParameter own_parameters[section::n_fibre_parameters] = {
    {"Young's modulus", "Pa", 2e11, 1e-300, 1e300, "E"},
    {"Poisson ratio", "-", 0.3, -0.99, 0.5, "of E / (2 (1 + nu)) in torsion"},
    {"Outside diameter", "m", 0.2, 1e-300, 1e300, "of the pipe"},
    {"Wall thickness", "m", 0.005, 1e-300, 1e300, "of the pipe, below half its diameter"},
    {"Shear rigidity", "N", 1e8, 0., 1e300, "of shear forces, which are elastic"},
    {"Fibres", "-", 63., 5., section::most_fibres,
     "round the circumference; odd ones are as good as twice as many. 15: 0.4 % of the limit "
     "moment, 31: 0.1 %, 63: 0.02 %"},
    {"Radii", "-", 2., 1., 2., "through the wall: 1 thin, 2 Gauss points"}};

constexpr auto plain_parameters = section::joined(own_parameters, section::material_parameters);

constexpr auto all_parameters() {
  std::array<LawParameter, section::n_all_fibre_parameters> result{};
  for (std::size_t i = 0; i < plain_parameters.size(); ++i)
    result[i] = plain_parameters[i];
  for (int i = 0; i < section::n_creep_parameters; ++i)
    result[plain_parameters.size() + i] = section::creep_parameters[i];
  return result;
}
constexpr auto fibre_parameters = all_parameters();

class FibreLaw final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    using namespace section;
    const double *const p = in.parameters;
    const FibrePipe pipe(p, in.temperature, in.pressure);
    if (!pipe.is_possible)
      return LawStatus::failed;
    out.contact = ContactStatus::none;
    out.dissipation = out.stored_energy = out.error = 0.;
    for (int i = 0; i < n_section_strains; ++i)
      out.stress[i] = pipe.rigidity[i] * in.strain[i];
    if (in.tangent != LawTangent::none) {
      std::fill(out.tangent, out.tangent + n_section_strains * n_section_strains, 0.);
      for (int i = 0; i < n_section_strains; ++i)
        out.tangent[(n_section_strains + 1) * i] = pipe.rigidity[i];
    }
    const FibreLayout &at = pipe.layout;
    if (at.creep < 0 && pipe.elastic_bound(in.strain) < 1. &&
        std::all_of(in.old_state, in.old_state + at.size(), [](double x) { return x == 0.; })) {
      std::fill(out.new_state, out.new_state + at.size(), 0.);
      for (int i = 0; i < n_section_strains; ++i)
        out.stored_energy += out.stress[i] * in.strain[i] / 2.;
      return LawStatus::ok;
    }

    if (pipe.bursts)
      return LawStatus::failed;
    const Creep creep(p + n_fibre_parameters + n_material_parameters, in.time, in.time_increment,
                      in.temperature, in.temperature_change);
    FibreStrains strain, old_strain = {};
    for (int k = 0; k < n_fibre_strains; ++k)
      strain[k] = in.strain[fibre_strain_place[k]];
    if (at.first > 0) {
      std::copy(in.old_state, in.old_state + n_fibre_strains, old_strain);
      std::copy(strain, strain + n_fibre_strains, out.new_state);
      out.new_state[n_fibre_strains] = pipe.hoop;
    }

    for (const int i : fibre_strain_place)
      out.stress[i] = 0.;
    const bool consistent = in.tangent == LawTangent::consistent;
    for (const int i : fibre_strain_place)
      if (consistent)
        out.tangent[(n_section_strains + 1) * i] = 0.;
    for (const int i : {1, 2})
      out.stored_energy += out.stress[i] * in.strain[i] / 2.;
    std::optional<FibrePipe> at_start, at_first;
    if (creep.is_on && in.temperature_change != 0.) {
      at_start.emplace(p, in.temperature - in.temperature_change, in.pressure);
      at_first.emplace(p, in.temperature - (1. - gamma_stage) * in.temperature_change, in.pressure);
    }
    const PipeCourse course{at_start ? *at_start : pipe, at_first ? *at_first : pipe, pipe};
    const FibrePlaces places(at.fibres);
    double error = 0., size = 0.;
    for (int j = 0; j < at.rings; ++j) {
      RingIncrement ring(course, places, j, creep.is_on ? &creep : nullptr, in.old_state);
      if (!(creep.is_on ? ring.creep(old_strain, in.old_state[n_fibre_strains], strain)
                        : ring.step(strain)))
        return LawStatus::failed;
      ring.write(out.new_state, out);
      if (consistent)
        ring.add_tangent(out.tangent);
      error = std::max(error, ring.error);
      size = std::max(size, ring.size);
    }
    out.error = size > 0. ? error / size : 0.;
    return std::all_of(out.stress, out.stress + n_section_strains,
                       [](const double s) { return std::isfinite(s); })
               ? LawStatus::ok
               : LawStatus::failed;
  }
};

constexpr FibreLaw fibre_law;

int n_fibre_states(const double *p) { return section::FibreLayout(p).size(); }

/// A section that creeps is never only elastic, and has to know its last strains.
double fibre_bound(const LawInput &in) {
  const FibrePipe pipe(in.parameters, in.temperature, in.pressure);
  const double bound = pipe.elastic_bound(in.strain);
  return pipe.layout.creep >= 0 ? std::max(1., bound) : bound;
}

const char *fibre_fault(const double *p) {
  const int n = static_cast<int>(std::lround(p[section::n_fibres]));
  if (n < 15 && n % 2 == 0)
    return "an odd number of fibres, or 15 and more: an even number so small depends on the "
           "direction of bending, take one more in 'Fibres'";
  return section::fault_of(p + section::n_fibre_parameters, p[section::outside_diameter],
                           p[section::wall_thickness]);
}

void fibre_report(const LawInput &in, const double *state, SectionReport &report) {
  using namespace section;
  const FibrePipe pipe(in.parameters, in.temperature, in.pressure);
  const FibreLayout &at = pipe.layout;
  if (std::all_of(state, state + at.size(), [](const double x) { return x == 0.; })) {
    report.utilization = pipe.elastic_bound(in.strain); // nothing has flowed, as in most sections
    return;
  }
  const FibrePlaces places(at.fibres);
  const double H = pipe.material.H;
  for (int j = 0; j < at.rings; ++j) {
    const double r = pipe.radius[j], tau = pipe.G * (r * in.strain[3] - state[at.of_ring(j)]);
    for (int i = 0; i < at.fibres; ++i) {
      const double *const f = state + at.of_fibre(j, i);
      const double strain =
          in.strain[0] + r * (places.z[i] * in.strain[4] - places.y[i] * in.strain[5]);
      const double e = at.g < 0 ? 0. : f[at.e < 0 ? 0 : at.e], g = at.g < 0 ? 0. : f[at.g],
                   h = at.h < 0 ? 0. : f[at.h];
      const double X = pipe.E * (strain - f[0]) - pipe.hoop / 2. - H * e, W = tau - H * g / 3.,
                   B = pipe.hoop - 4. / 3. * H * h;
      report.utilization =
          std::max(report.utilization,
                   std::sqrt(X * X + 3. * W * W + 0.75 * B * B) / pipe.material.yield(f[1]));
      const int fibre = at.of_fibre(j, i);
      report.plastic_strain = std::max(report.plastic_strain, gained(in, state, fibre + 1));
      if (at.creep >= 0)
        report.creep_strain = std::max(report.creep_strain, gained(in, state, fibre + at.creep));
    }
  }
}

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {
    frictionbeam::law_interface_version,
    frictionbeam::LawKind::section,
    frictionbeam::n_section_strains,
    frictionbeam::section::most_fibre_states,
    false, // with creep and torsion together; symmetric else
    "fibre_pipe",
    "FrictionBeam, doc/inelastic.md",
    frictionbeam::section::n_all_fibre_parameters,
    fibre_parameters.data(),
    &fibre_law,
    nullptr,
    &n_fibre_states,
    &fibre_bound,
    nullptr,
    &fibre_report,
    &fibre_fault};
