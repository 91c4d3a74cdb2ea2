// SPDX-License-Identifier: LGPL-2.1-or-later
#include "section/fibre.h"

/**
 * Straight bar of rectangular section whose fibres yield: N, M_y and M_z together, with the axial
 * strain plane over the section,
 *   eps_i = eps + z_i kappa_y - y_i kappa_z,   N = sum a s,  M_y = sum a s z,  M_z = -sum a s y.
 * The height stands along the section's axis z (upright in a pipe that is not), the width along y.
 * Each is cut into equal strips with the two points of Gauss, so that area and moments of inertia
 * are exact. Shear forces and torsion are elastic, and do not yield; there is no creep, and
 * pressure does nothing.
 *
 * section/fibre.h has the law of a fibre, here without shear and hoop stress. Of each, the state
 * has its plastic strain and what has accumulated.
 */
namespace {

using namespace frictionbeam;
using section::Fibre;
using section::Material;

enum Parameter {
  youngs_modulus,
  height,
  width,
  shear_rigidity,
  torsional_rigidity,
  n_high,
  n_wide,
  n_own,
  n_parameters = n_own + section::n_material_parameters
};

constexpr int most_fibres = 2000;
constexpr double most_of_side = most_fibres / 2;

constexpr LawParameter own_parameters[n_own] = {
    {"Young's modulus", "Pa", 2e11, 1e-300, 1e300, "E"},
    {"Height", "m", 0.1, 1e-300, 1e300, "along the section's axis z"},
    {"Width", "m", 0.05, 1e-300, 1e300, "along its axis y"},
    {"Shear rigidity", "N", 1e8, 0., 1e300, "of shear forces, which are elastic"},
    {"Torsional rigidity", "N m2", 1e6, 0., 1e300, "of torsion, which is elastic"},
    {"Fibres along the height", "-", 32., 2., most_of_side,
     "an even number. Of the limit moment 32 miss 0.1 %, 64 0.02 %"},
    {"Fibres along the width", "-", 32., 2., most_of_side, "an even number; 2 where M_z is small"}};

constexpr auto rectangle_parameters = section::joined(own_parameters, section::material_parameters);

int count(const double number) { return static_cast<int>(std::lround(number)); }

/// Of a side of length 1 about its middle.
double place(const int i, const int n) {
  return (i / 2 + 0.5 + (i % 2 == 0 ? -0.5 : 0.5) / std::sqrt(3.)) / (n / 2) - 0.5;
}

enum State { plastic, accumulated, n_states_of_fibre };

/// Figures at a temperature.
struct Rectangle {
  Material material;
  double E, h, b, area; ///< the last of a fibre
  double rigidity[n_section_strains];
  int high, wide;

  Rectangle(const double *p, const double temperature)
      : material(p + n_own, temperature), h(p[height]), b(p[width]), high(count(p[n_high])),
        wide(count(p[n_wide])) {
    const double f = material.modulus_factor, A = b * h;
    E = f * p[youngs_modulus];
    area = A / (high * wide);
    rigidity[0] = E * A;
    rigidity[1] = rigidity[2] = f * p[shear_rigidity];
    rigidity[3] = f * p[torsional_rigidity];
    rigidity[4] = E * A * h * h / 12.;
    rigidity[5] = E * A * b * b / 12.;
  }

  /// Calls what(fibre, strain, z, y) for each fibre.
  template <class What>
  void for_each(const double *strain, const What &what) const {
    for (int k = 0; k < high; ++k) {
      const double z = h * place(k, high);
      for (int j = 0; j < wide; ++j) {
        const double y = b * place(j, wide);
        what(k * wide + j, strain[0] + z * strain[4] - y * strain[5], z, y);
      }
    }
  }

  /// Largest stress of elastic fibres over the yield stress, at a corner.
  double elastic_bound(const double *strain) const {
    return E * (std::abs(strain[0]) + (h * std::abs(strain[4]) + b * std::abs(strain[5])) / 2.) /
           material.first_yield();
  }
};

class FibreRectangle final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const Rectangle bar(in.parameters, in.temperature);
    if (!bar.material.is_possible)
      return LawStatus::failed;
    const int n = bar.high * bar.wide;
    const bool consistent = in.tangent == LawTangent::consistent;
    out.contact = ContactStatus::none;
    out.dissipation = out.stored_energy = out.error = 0.;
    for (int i = 0; i < n_section_strains; ++i)
      out.stress[i] = bar.rigidity[i] * in.strain[i];
    if (in.tangent != LawTangent::none) {
      std::fill(out.tangent, out.tangent + n_section_strains * n_section_strains, 0.);
      for (int i = 0; i < n_section_strains; ++i)
        out.tangent[(n_section_strains + 1) * i] = bar.rigidity[i];
    }
    const auto store = [&](std::initializer_list<int> components) {
      for (const int i : components)
        out.stored_energy += out.stress[i] * in.strain[i] / 2.;
    };
    if (bar.elastic_bound(in.strain) < 1. &&
        std::all_of(in.old_state, in.old_state + n_states_of_fibre * n,
                    [](const double x) { return x == 0.; })) {
      std::fill(out.new_state, out.new_state + n_states_of_fibre * n, 0.);
      store({0, 1, 2, 3, 4, 5});
      return LawStatus::ok;
    }

    store({1, 2, 3});
    constexpr int place_of[3] = {0, 4, 5};
    for (const int i : place_of) {
      out.stress[i] = 0.;
      if (consistent)
        out.tangent[(n_section_strains + 1) * i] = 0.;
    }
    const Material &material = bar.material;
    const double E = bar.E, H = material.H;
    const Fibre law{material, nullptr, E, 0.};
    bar.for_each(in.strain, [&](const int i, const double strain, const double z, const double y) {
      const double *const old = in.old_state + n_states_of_fibre * i;
      double *const now = out.new_state + n_states_of_fibre * i;
      Fibre::End end;
      law.solve({E * (strain - old[plastic]), old[plastic], 0., 0., old[accumulated], 0., 1.}, 0.,
                0., end);
      now[plastic] = old[plastic] + end.lambda * end.X;
      now[accumulated] = old[accumulated] + end.dp;
      const double arm[3] = {1., z, -y}; // strain and stress of the fibre by those of the section
      for (int k = 0; k < 3; ++k)
        out.stress[place_of[k]] += bar.area * arm[k] * end.x;
      const auto hardening = [&](const double *state) {
        return H * state[plastic] * state[plastic] / 2. + material.stored(state[accumulated]);
      };
      const double stored = hardening(now);
      out.stored_energy += bar.area * (end.x * end.x / (2. * E) + stored);
      if (end.dp > 0.)
        out.dissipation += bar.area * std::max(0., end.x * (now[plastic] - old[plastic]) -
                                                       (stored - hardening(old)));
      if (!consistent)
        return;
      const double stiffness = bar.area * E * law.plastic_tangent(end).x_by_trial;
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          out.tangent[n_section_strains * place_of[k] + place_of[l]] += stiffness * arm[k] * arm[l];
    });
    return std::all_of(out.stress, out.stress + n_section_strains,
                       [](const double s) { return std::isfinite(s); })
               ? LawStatus::ok
               : LawStatus::failed;
  }
};

constexpr FibreRectangle rectangle_law;

int n_rectangle_states(const double *p) {
  return n_states_of_fibre * count(p[n_high]) * count(p[n_wide]);
}

double rectangle_bound(const LawInput &in) {
  return Rectangle(in.parameters, in.temperature).elastic_bound(in.strain);
}

const char *rectangle_fault(const double *p) {
  if (count(p[n_high]) % 2 != 0 || count(p[n_wide]) % 2 != 0)
    return "even numbers of fibres, two in each strip: take one more";
  if (count(p[n_high]) * count(p[n_wide]) > most_fibres)
    return "2000 fibres: take fewer along the side about which it bends less";
  return section::fault_of_material(p + n_own);
}

void rectangle_report(const LawInput &in, const double *state, SectionReport &report) {
  const Rectangle bar(in.parameters, in.temperature);
  const double H = bar.material.H;
  bar.for_each(in.strain, [&](const int i, const double strain, const double, const double) {
    const double *const now = state + n_states_of_fibre * i;
    const double X = bar.E * (strain - now[plastic]) - H * now[plastic];
    report.utilization =
        std::max(report.utilization, std::abs(X) / bar.material.yield(now[accumulated]));
    report.plastic_strain = std::max(
        report.plastic_strain, section::gained(in, state, n_states_of_fibre * i + accumulated));
  });
}

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {frictionbeam::law_interface_version,
                                                       frictionbeam::LawKind::section,
                                                       frictionbeam::n_section_strains,
                                                       n_states_of_fibre *most_fibres,
                                                       true,
                                                       "fibre_rectangle",
                                                       "FrictionBeam, doc/inelastic.md",
                                                       n_parameters,
                                                       rectangle_parameters.data(),
                                                       &rectangle_law,
                                                       nullptr,
                                                       &n_rectangle_states,
                                                       &rectangle_bound,
                                                       nullptr,
                                                       &rectangle_report,
                                                       &rectangle_fault};
