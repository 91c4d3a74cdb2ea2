// SPDX-License-Identifier: LGPL-2.1-or-later
#include "section/ellipsoid_return.h"

/**
 * Section of a pipe that yields as a whole (TEDEL; Cast3M's TUYAU). With r the mean radius, t the
 * wall, A = 2 pi r t, I = pi r^3 t, J = 2 I,
 *
 *   s = (aN N/A, aT T r/J, aM My r/I, aM Mz r/I, ap p r/t),   s_eq = |s - x| <= R(p),
 *
 * with the back stress x = H e and associated flow e' = p' (s - x) / R; the generalized plastic
 * strains are A ds/dS e, so that A R p' is the work of s - x on them. aM is multiplied by
 * max(1, (8/9) / lambda^(2/3)), lambda = t R_bend / r^2, in an elbow. Shear forces are elastic.
 *
 * The end of the increment is the point of the ellipsoid that is nearest in the elastic metric:
 * each component is (s* - x*) / (1 + (k + H) dp / R), k its elastic stiffness over e, and what is
 * left is one equation in dp. stored_energy has the springs, what hardening stores, and the
 * potential of a pressure that stays.
 */
namespace {

using namespace frictionbeam;

enum Parameter {
  EA,
  GA,
  GJ,
  EI,
  diameter,
  wall,
  bend_radius,
  a_N,
  a_T,
  a_M,
  a_p,
  n_own,
  n_parameters = n_own + section::n_material_parameters
};

constexpr LawParameter own_parameters[n_own] = {
    {"Axial rigidity", "N", 1., 0., 1e300, "Young's modulus times the metal's area"},
    {"Shear rigidity", "N", 1., 0., 1e300, "shear modulus times the effective shear area"},
    {"Torsional rigidity", "N m2", 1., 0., 1e300, "shear modulus times the torsion constant"},
    {"Bending rigidity", "N m2", 1., 0., 1e300, "Young's modulus times the moment of inertia"},
    {"Outside diameter", "m", 0.2, 1e-300, 1e300, "of the pipe"},
    {"Wall thickness", "m", 0.005, 1e-300, 1e300, "of the pipe, below half its diameter"},
    {"Bend radius", "m", 0., 0., 1e300, "of an elbow's axis; 0: straight"},
    {"Axial coefficient", "-", 1., 0., 1e3, "aN"},
    {"Torsion coefficient", "-", 1.7320508075688772, 0., 1e3, "aT"},
    {"Bending coefficient", "-", section::pi / 4., 0., 1e3, "aM of a straight pipe"},
    {"Pressure coefficient", "-", 0., 0., 1e3, "ap; 0: pressure does not yield"}};

constexpr auto global_parameters = section::joined(own_parameters, section::material_parameters);

constexpr int n = 4;                   ///< components that flow: N, M_x, M_y, M_z; then p
constexpr int place[n] = {0, 3, 4, 5}; ///< among the stresses
enum State { flow, hoop_flow = n, accumulated, n_states };

using Return = section::EllipsoidReturn<n + 1>;

/// The section at the end of an increment, before it flows.
struct Section {
  section::Material material;
  double rigidity[n_section_strains]; ///< of each strain
  double A, a[n];                     ///< s = a S
  double k[n + 1] = {};               ///< stiffness of s over e [Pa]
  double hoop;                        ///< ap p r/t [Pa]
  bool is_possible;

  Section(const double *p, const double temperature, const double pressure)
      : material(p + n_own, temperature) {
    const double f = material.modulus_factor, t = p[wall], r = (p[diameter] - t) / 2.;
    const double all[n_section_strains] = {p[EA], p[GA], p[GA], p[GJ], p[EI], p[EI]};
    for (int i = 0; i < n_section_strains; ++i)
      rigidity[i] = f * all[i];
    A = 2. * section::pi * r * t;
    const double I = section::pi * r * r * r * t;
    const double lambda = t * p[bend_radius] / (r * r);
    const double g = lambda > 0. ? std::max(1., 8. / 9. / std::cbrt(lambda * lambda)) : 1.;
    a[0] = p[a_N] / A;
    a[1] = p[a_T] * r / (2. * I);
    a[2] = a[3] = p[a_M] * g * r / I;
    for (int i = 0; i < n; ++i)
      k[i] = A * a[i] * a[i] * rigidity[place[i]];
    hoop = p[a_p] * pressure * r / t;
    is_possible = material.is_possible && r > 0. && p[diameter] > 2. * t;
  }
};

class GlobalPlastic final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const Section section(in.parameters, in.temperature, in.pressure);
    if (!section.is_possible)
      return LawStatus::failed;
    const section::Material &m = section.material;
    const double *const old = in.old_state;
    double trial[n + 1];
    for (int i = 0; i < n; ++i)
      trial[i] = section.a[i] * section.rigidity[place[i]] * in.strain[place[i]] -
                 (section.k[i] + m.H) * old[flow + i];
    trial[n] = section.hoop - m.H * old[hoop_flow];
    const Return to(m, section.k, trial, old[accumulated]);
    if (!to.converged)
      return LawStatus::failed;

    for (const int i : {1, 2})
      out.stress[i] = section.rigidity[i] * in.strain[i];
    double lost = 0., squares = 0., old_squares = 0.;
    out.stored_energy = 0.;
    for (int i = 0; i < n; ++i) {
      const double e = old[flow + i] + to.lambda * to.xi[i];
      const double K = section.rigidity[place[i]];
      out.stress[place[i]] =
          section.a[i] > 0. ? (to.xi[i] + m.H * e) / section.a[i] : K * in.strain[place[i]];
      lost += section.a[i] * out.stress[place[i]] * (e - old[flow + i]);
      squares += e * e;
      old_squares += old[flow + i] * old[flow + i];
      out.new_state[flow + i] = e;
    }
    const double hoop = old[hoop_flow] + to.lambda * to.xi[n];
    lost += section.hoop * (hoop - old[hoop_flow]);
    squares += hoop * hoop;
    old_squares += old[hoop_flow] * old[hoop_flow];
    out.new_state[hoop_flow] = hoop;
    out.new_state[accumulated] = old[accumulated] + to.dp;

    const double hardening = m.H * squares / 2. + m.stored(old[accumulated] + to.dp);
    const double old_hardening = m.H * old_squares / 2. + m.stored(old[accumulated]);
    out.dissipation =
        to.dp > 0. ? section.A * std::max(0., lost - (hardening - old_hardening)) : 0.;
    out.stored_energy = section.A * (hardening - section.hoop * hoop);
    for (int i = 0; i < n_section_strains; ++i)
      if (section.rigidity[i] > 0.)
        out.stored_energy += out.stress[i] * out.stress[i] / section.rigidity[i] / 2.;
    out.contact = ContactStatus::none;
    if (in.tangent != LawTangent::none)
      write_tangent(section, to, old[accumulated] + to.dp,
                    in.tangent == LawTangent::consistent && to.dp > 0., out.tangent);
    return LawStatus::ok;
  }

private:
  static void write_tangent(const Section &section, const Return &to, const double p,
                            const bool flows, double *tangent) {
    const section::Material &m = section.material;
    std::fill(tangent, tangent + n_section_strains * n_section_strains, 0.);
    for (int i = 0; i < n_section_strains; ++i)
      tangent[(n_section_strains + 1) * i] = section.rigidity[i];
    if (!flows)
      return;
    const double D = to.denominator(m, section.k, p);
    double direction[n];
    for (int i = 0; i < n; ++i)
      direction[i] = section.a[i] * section.rigidity[place[i]] * to.xi[i] / to.alpha[i];
    for (int i = 0; i < n; ++i) {
      tangent[(n_section_strains + 1) * place[i]] *= (1. + to.lambda * m.H) / to.alpha[i];
      for (int j = 0; j < n; ++j)
        tangent[n_section_strains * place[i] + place[j]] -=
            section.A * direction[i] * direction[j] / D;
    }
  }
};

constexpr GlobalPlastic global_law;

/// Equivalent stress of these generalized plastic strains over the yield stress.
double utilization(const LawInput &in, const double *state) {
  const Section section(in.parameters, in.temperature, in.pressure);
  const double hoop = section.hoop - section.material.H * state[hoop_flow];
  double sum = hoop * hoop;
  for (int i = 0; i < n; ++i) {
    const double xi = section.a[i] * section.rigidity[place[i]] * in.strain[place[i]] -
                      (section.k[i] + section.material.H) * state[flow + i];
    sum += xi * xi;
  }
  return std::sqrt(sum) / section.material.yield(state[accumulated]);
}

double global_bound(const LawInput &in) {
  const double zero[n_states] = {};
  return utilization(in, zero);
}

const char *global_fault(const double *p) {
  return section::fault_of(p + n_own, p[diameter], p[wall]);
}

void global_report(const LawInput &in, const double *state, SectionReport &report) {
  report.utilization = utilization(in, state);
  report.plastic_strain = section::gained(in, state, accumulated);
}

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {
    frictionbeam::law_interface_version,
    frictionbeam::LawKind::section,
    frictionbeam::n_section_strains,
    n_states,
    true,
    "global_plastic",
    "Criterion of TEDEL as in Cast3M's TUYAU (notices CARA and VMIS of its manual, CEA)",
    n_parameters,
    global_parameters.data(),
    &global_law,
    nullptr,
    nullptr,
    &global_bound,
    nullptr,
    &global_report,
    &global_fault};
