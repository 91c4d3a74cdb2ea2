// SPDX-License-Identifier: LGPL-2.1-or-later
#include "section/oval_increment.h"

/**
 * Section of a pipe bend whose wall ovalises, T. von Karman's (Z. VDI 55 (1911) 1889-1895) beyond
 * yield: modes of ovalisation are unknowns of the law, points of the wall are in plane stress
 * (section/oval_pipe.h has the strains, section/oval_point.h the metal, section/oval_increment.h
 * the equations). Both planes of bending, axial force, torsion, pressure, which also holds the
 * section round. A bend of finite length ovalises less towards its ends (section/oval_ends.h).
 *
 * The axes are those of the bend: y towards its centre, z = x cross y. Shear forces are elastic.
 * With `Bend radius` = 0 it is a straight pipe. stored_energy has the springs, what hardening
 * stores, and the potential of a pressure that stays.
 */
namespace {

using namespace frictionbeam;
using section::OvalPipe;
using section::OvalShapes;

constexpr LawParameter own_parameters[section::n_oval_parameters] = {
    {"Young's modulus", "Pa", 2e11, 1e-300, 1e300, "E"},
    {"Poisson ratio", "-", 0.3, -0.99, 0.5, "nu"},
    {"Outside diameter", "m", 0.2, 1e-300, 1e300, "of the pipe"},
    {"Wall thickness", "m", 0.005, 1e-300, 1e300,
     "of the pipe; in a bend at most 0.4 of the mean radius"},
    {"Shear rigidity", "N", 1e8, 0., 1e300, "of shear forces, which are elastic"},
    {"Bend radius", "m", 0., 0., 1e300, "of the bend's axis; 0: straight"},
    {"Bend length", "m", 0., 0., 1e300,
     "of its axis, between straight pipes; 0: long, its ends hold no oval"},
    {"Place in bend", "-", 0.5, 0., 1., "part of the way from the bend's beginning"},
    {"Modes", "-", 8., 2., section::highest_mode, "of ovalisation, from 2 waves round to as many"},
    {"Points round", "-", 31., 7., section::most_stations,
     "the circumference; odd, and 3 and more than twice the modes"},
    {"Layers", "-", 2., 1., section::most_layers,
     "of the wall, two points in each; an even number has its plastic moment exactly"}};

constexpr auto oval_parameters = section::joined(own_parameters, section::material_parameters);

/// Largest equivalent stress over the yield stress of the wall with these strains and this state,
/// as far as it is wanted.
double utilization(const OvalPipe &pipe, const OvalShapes &shapes,
                   const section::OvalStrains &strain, const section::OvalUnknowns &unknown,
                   const double *state) {
  using namespace section;
  double result = 0.;
  for (int i = 0; i < pipe.layout.stations; ++i) {
    double strains[n_station_strains];
    station_strains(pipe, shapes, i, strain, unknown, strains);
    for (int j = 0; j < pipe.layout.points; ++j)
      result = std::max(result, OvalPoint(pipe, point_strain(pipe, j, strains),
                                          state + pipe.layout.of_point(i, j))
                                    .utilization());
  }
  return result;
}

constexpr double no_state[section::most_oval_states] = {};

/// Of a section that has never flowed.
double elastic_utilization(const OvalPipe &pipe, const OvalShapes &shapes,
                           const section::OvalStrains &strain) {
  section::OvalUnknowns unknown;
  answer_elastically(pipe, shapes, strain, unknown);
  return utilization(pipe, shapes, strain, unknown, no_state);
}

/// No less than elastic_utilization() without modes' phases: a sum of the largest stresses.
double elastic_bound_of(const OvalPipe &pipe, const section::OvalStrains &strain) {
  const double s_x = pipe.E * strain.axial + pipe.nu * pipe.hoop, s_h = pipe.hoop,
               tau = pipe.G * pipe.radius[pipe.layout.points - 1] * strain.twist;
  return (std::sqrt(s_x * s_x - s_x * s_h + s_h * s_h + 3. * tau * tau) +
          pipe.stress_of_bending() * std::hypot(strain.in_plane, strain.out_of_plane)) /
         pipe.material.first_yield();
}

bool is_zero(const double *state, const int n) {
  return std::all_of(state, state + n, [](const double x) { return x == 0.; });
}

class OvalisingPipe final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    using namespace section;
    const OvalPipe pipe(in.parameters, in.temperature, in.pressure);
    if (!pipe.is_possible || pipe.bursts)
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
    const OvalStrains strain(pipe, in.strain);
    const int n_states = pipe.layout.size();
    const bool has_flowed = !is_zero(in.old_state, n_states);
    const OvalShapes shapes(pipe);
    if (!has_flowed &&
        (elastic_bound_of(pipe, strain) < 1. || elastic_utilization(pipe, shapes, strain) < 1.)) {
      std::fill(out.new_state, out.new_state + n_states, 0.);
      for (int i = 0; i < n_section_strains; ++i)
        out.stored_energy += out.stress[i] * in.strain[i] / 2.;
      return LawStatus::ok;
    }
    for (const int i : {1, 2})
      out.stored_energy += out.stress[i] * in.strain[i] / 2.;
    for (const int i : {0, 3, 4, 5})
      out.stress[i] = 0.;
    OvalIncrement increment(pipe, shapes, strain, in.old_state, out.new_state);
    if (!increment.solve())
      return LawStatus::failed;
    increment.write(out);
    if (in.tangent == LawTangent::consistent)
      increment.add_tangent(out.tangent);
    return std::all_of(out.stress, out.stress + n_section_strains,
                       [](const double s) { return std::isfinite(s); })
               ? LawStatus::ok
               : LawStatus::failed;
  }
};

constexpr OvalisingPipe oval_law;

int n_oval_states(const double *p) { return section::OvalLayout(p).size(); }

double oval_bound(const LawInput &in) {
  const OvalPipe pipe(in.parameters, in.temperature, in.pressure);
  if (!pipe.is_possible)
    return std::numeric_limits<double>::infinity();
  return elastic_bound_of(pipe, section::OvalStrains(pipe, in.strain));
}

const char *oval_fault(const double *p) {
  using namespace section;
  const double diameter = p[oval_diameter], wall = p[oval_wall], bend = p[oval_bend_radius];
  const int n = static_cast<int>(std::lround(p[oval_stations]));
  if (n % 2 == 0 || n < 2 * std::lround(p[oval_highest_mode]) + 3)
    return "an odd number of points round, 3 and more than twice the modes, so that each mode is "
           "seen and no direction is favoured: take more 'Points round', or fewer 'Modes'";
  if (const char *const fault = fault_of(p + n_oval_parameters, diameter, wall))
    return fault;
  if (bend > 0. && bend <= diameter / 2.)
    return "a bend radius above half the outside diameter: a larger radius of the bend";
  constexpr double thickest = 0.4; // of the mean radius: the ring is one of thin walls
  if (bend > 0. && wall > thickest * (diameter - wall) / 2.)
    return "in a bend a wall of at most 0.4 of the mean radius, for its ring is a thin one: a "
           "thinner wall, or Law = global_plastic or an elastic section for so thick a bend, which "
           "hardly ovalises";
  return nullptr;
}

void oval_report(const LawInput &in, const double *state, SectionReport &report) {
  using namespace section;
  const OvalPipe pipe(in.parameters, in.temperature, in.pressure);
  const OvalLayout &at = pipe.layout;
  const OvalShapes shapes(pipe);
  const OvalStrains strain(pipe, in.strain);
  if (is_zero(state, at.size())) {
    report.utilization = elastic_utilization(pipe, shapes, strain);
    return;
  }
  OvalUnknowns unknown;
  std::copy(state, state + 2 * at.modes, unknown.mode);
  for (int i = 0; i < at.stations; ++i) {
    std::copy(state + at.of_station(i), state + at.of_station(i) + 2, unknown.own[i]);
    for (int j = 0; j < at.points; ++j)
      report.plastic_strain =
          std::max(report.plastic_strain, gained(in, state, at.of_point(i, j) + 3));
  }
  report.utilization = utilization(pipe, shapes, strain, unknown, state);
}

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {
    frictionbeam::law_interface_version,
    frictionbeam::LawKind::section,
    frictionbeam::n_section_strains,
    frictionbeam::section::most_oval_states,
    true,
    "ovalising_pipe",
    "T. von Karman, Z. VDI 55 (1911) 1889-1895, with plasticity; FrictionBeam, doc/inelastic.md",
    frictionbeam::section::n_oval_parameters + frictionbeam::section::n_material_parameters,
    oval_parameters.data(),
    &oval_law,
    nullptr,
    &n_oval_states,
    &oval_bound,
    nullptr,
    &oval_report,
    &oval_fault};
