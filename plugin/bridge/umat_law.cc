// SPDX-License-Identifier: LGPL-2.1-or-later
//
// An Abaqus-type UMAT (Fortran calling convention, small strains) as a law; built by
// frictionbeam_add_umat(), which writes frictionbeam_umat.h with what it was told. The law's state
// is that of its material points, each STATEV, STRESS, STRAN and the energies SSE, SPD, SCD, and
// then the last temperature and a flag, 1 once the law has begun.
//
// Kind support: one point with the three components of a traction-separation law (NTENS = 3, normal
// and two shears; NDI = 1, NSHR = 2), STRAN = separation over a thickness, force = stress times
// area, no torsional moment. Kind section: a pipe of 16 fibres, each in uniaxial stress (NTENS =
// 1); they lie on the radius that gives the ring's second moment of area, sqrt((D^2 + d^2) / 8).
// Shear and torsion are elastic.
#include <frictionbeam/law.h>

#include "frictionbeam_umat.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <iterator>

extern "C" void FRICTIONBEAM_UMAT_SYMBOL(
    double *stress, double *statev, double *ddsdde, double *sse, double *spd, double *scd,
    double *rpl, double *ddsddt, double *drplde, double *drpldt, double *stran, double *dstran,
    double *time, double *dtime, double *temp, double *dtemp, double *predef, double *dpred,
    char *cmname, int *ndi, int *nshr, int *ntens, int *nstatv, double *props, int *nprops,
    double *coords, double *drot, double *pnewdt, double *celent, double *dfgrd0, double *dfgrd1,
    int *noel, int *npt, int *layer, int *kspt, int *jstep, int *kinc, std::size_t cmname_length);

namespace {

using namespace frictionbeam;

constexpr bool is_section = FRICTIONBEAM_UMAT_IS_SECTION;
constexpr int n_tensor = is_section ? 1 : 3, n_points = is_section ? 16 : 1;
constexpr int n_statev = FRICTIONBEAM_UMAT_STATES;
constexpr int n = is_section ? n_section_strains : n_support_strains;

constexpr LawParameter parameters[] = {
#if FRICTIONBEAM_UMAT_IS_SECTION
    {"Outside diameter", "m", 0.2191, 1e-6, 1e6, "of the pipe"},
    {"Wall thickness", "m", 0.0063, 1e-9, 1e6, "of the pipe, at most half its diameter"},
    {"Shear modulus", "Pa", 8e10, 0., 1e300, "of shear and torsion, which are elastic"},
    {"Shear area ratio", "-", 0.5, 0., 1., "effective shear area over the metal's area"}
#else
    {"Contact area", "m2", 1., 1e-300, 1e300, "force is stress times this area"},
    {"Thickness", "m", 1., 1e-300, 1e300, "STRAN is the separation over this thickness"}
#endif
    FRICTIONBEAM_UMAT_PARAMETERS};

constexpr int n_parameters = std::size(parameters);
constexpr int n_own = is_section ? 4 : 2; ///< parameters of the adapter; PROPS are the others
constexpr int n_props = n_parameters - n_own;

/// Places within a point's part of the state.
enum Place {
  at_stress = n_statev,
  at_strain = at_stress + n_tensor,
  at_energies = at_strain + n_tensor,
  point_size = at_energies + 3
};
/// Places within the state.
enum State { last_temperature = n_points * point_size, has_begun, n_states };
static_assert(n_states <= 1000, "a law has at most 1000 internal variables");

/// The increment as a UMAT is told of it.
struct Increment {
  double time, time_increment, length, temperature, temperature_change;
  bool is_first;
};

/**
 * Call the UMAT at one point.
 * @param point the point's part of the state, at the increment's start; at its end afterwards
 * @param strain at the end of the increment
 * @param stiffness DDSDDE, column by column
 * @return whether it has an answer: it asks for no shorter step, and all of it is finite
 */
bool call_umat(const Increment &increment, const double *props_given, const double *strain,
               const int number, double *point, double (&stiffness)[n_tensor * n_tensor]) {
  double change[n_tensor], props[n_props + 1] = {};
  for (int i = 0; i < n_tensor; ++i)
    change[i] = strain[i] - point[at_strain + i];
  std::copy(props_given, props_given + n_props, props);
  std::fill(std::begin(stiffness), std::end(stiffness), 0.);
  double rpl = 0., by_temperature[n_tensor] = {}, rpl_by_strain[n_tensor] = {},
         rpl_by_temperature = 0.;
  const double start = increment.time - increment.time_increment;
  double time[2] = {start, start}, time_increment = increment.time_increment;
  double temperature = increment.temperature - increment.temperature_change,
         temperature_change = increment.temperature_change;
  double predefined[1] = {}, predefined_change[1] = {}, place[3] = {};
  double rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, gradient_0[9], gradient_1[9];
  std::copy(rotation, rotation + 9, gradient_0);
  std::copy(rotation, rotation + 9, gradient_1);
  char name[80];
  std::fill(name, name + 80, ' ');
  for (std::size_t i = 0; i < std::min<std::size_t>(80, sizeof(FRICTIONBEAM_UMAT_NAME) - 1); ++i)
    name[i] = static_cast<char>(std::toupper(FRICTIONBEAM_UMAT_NAME[i]));
  int ndi = 1, nshr = n_tensor - 1, ntens = n_tensor, nstatv = n_statev, nprops = n_props;
  int element = 1, point_number = number, layer = 1, section_point = 1, step[4] = {1, 1, 0, 0};
  int increment_number = increment.is_first ? 1 : 2;
  double shorter = 1., length = increment.length, old_strain[n_tensor];
  std::copy(point + at_strain, point + at_strain + n_tensor, old_strain);

  FRICTIONBEAM_UMAT_SYMBOL(point + at_stress, point, stiffness, point + at_energies,
                           point + at_energies + 1, point + at_energies + 2, &rpl, by_temperature,
                           rpl_by_strain, &rpl_by_temperature, old_strain, change, time,
                           &time_increment, &temperature, &temperature_change, predefined,
                           predefined_change, name, &ndi, &nshr, &ntens, &nstatv, props, &nprops,
                           place, rotation, &shorter, &length, gradient_0, gradient_1, &element,
                           &point_number, &layer, &section_point, step, &increment_number, 80);

  std::copy(strain, strain + n_tensor, point + at_strain);
  const auto is_finite = [](const double x) { return std::isfinite(x); };
  return shorter >= 1. && std::all_of(point, point + point_size, is_finite) &&
         std::all_of(std::begin(stiffness), std::end(stiffness), is_finite);
}

double lost(const double *point) { return point[at_energies + 1] + point[at_energies + 2]; }

#if FRICTIONBEAM_UMAT_IS_SECTION

enum Parameter { diameter, wall, shear_modulus, shear_ratio };

/// Sum of the fibres; returns whether all have an answer.
bool answer(const LawInput &in, const Increment &increment, const bool from_nothing, double *state,
            double *stress, double *tangent, double &dissipation) {
  const double *const p = in.parameters;
  const double D = p[diameter], d = std::max(0., D - 2. * p[wall]);
  const double pi = std::acos(-1.), area = pi / 4. * (D * D - d * d);
  const double radius = std::sqrt((D * D + d * d) / 8.);
  const double GA = p[shear_modulus] * p[shear_ratio] * area,
               GJ = p[shear_modulus] * area * radius * radius;
  const double elastic[n] = {0., GA, GA, GJ, 0., 0.};
  for (int i = 0; i < n; ++i) {
    stress[i] = elastic[i] * in.strain[i];
    tangent[(n + 1) * i] = elastic[i];
  }
  for (int i = 0; i < n_points; ++i) {
    const double angle = 2. * pi * (i + 0.5) / n_points;
    // Share of each generalized strain in the fibre's: eps + z kappa_y - y kappa_z.
    const double share[n] = {1., 0., 0., 0., radius * std::cos(angle), -radius * std::sin(angle)};
    double strain[1] = {0.}, stiffness[1];
    for (int j = 0; j < n && !from_nothing; ++j)
      strain[0] += share[j] * in.strain[j];
    double *const point = state + i * point_size;
    const double before = lost(point);
    if (!call_umat(increment, p + n_own, strain, i + 1, point, stiffness))
      return false;
    dissipation += (lost(point) - before) * area / n_points;
    for (int j = 0; j < n; ++j) {
      stress[j] += share[j] * point[at_stress] * area / n_points;
      for (int k = 0; k < n; ++k)
        tangent[n * j + k] += share[j] * share[k] * stiffness[0] * area / n_points;
    }
  }
  return true;
}

#else

enum Parameter { area, thickness };

/// The interface; returns whether it has an answer.
bool answer(const LawInput &in, const Increment &increment, const bool from_nothing, double *state,
            double *stress, double *tangent, double &dissipation) {
  const double *const p = in.parameters;
  const double ratio = in.length / p[thickness];
  double strain[n_tensor] = {-1e-12, 0., 0.}, stiffness[n_tensor * n_tensor];
  for (int i = 0; i < n_tensor && !from_nothing; ++i)
    strain[i] = ratio * in.strain[i];
  const double before = lost(state);
  if (!call_umat(increment, p + n_own, strain, 1, state, stiffness))
    return false;
  dissipation += (lost(state) - before) * p[area] / ratio;
  for (int i = 0; i < n_tensor; ++i) {
    stress[i] = p[area] * state[at_stress + i];
    for (int j = 0; j < n_tensor; ++j)
      tangent[n * i + j] = p[area] * ratio * stiffness[i + n_tensor * j];
  }
  return true;
}

#endif

class Umat final : public LawBase {
public:
  LawStatus integrate(const LawInput &in, LawOutput &out) const noexcept override {
    const bool is_first = in.old_state[has_begun] == 0.;
    const double change = is_first ? 0. : in.temperature - in.old_state[last_temperature];
    const Increment increment{in.time, in.time_increment, in.length, in.temperature,
                              change,  is_first};
    std::copy(in.old_state, in.old_state + n_states, out.new_state);
    out.new_state[last_temperature] = in.temperature;
    out.new_state[has_begun] = 1.;
    out.dissipation = 0.;
    double stress[n] = {}, tangent[n * n] = {};
    if (!answer(in, increment, false, out.new_state, stress, tangent, out.dissipation))
      return LawStatus::failed;
    std::copy(stress, stress + n, out.stress);
    out.contact = is_section       ? ContactStatus::none
                  : stress[0] < 0. ? ContactStatus::closed
                                   : ContactStatus::open;
    if (in.tangent == LawTangent::elastic) { // of the material that nothing has happened to
      const Increment first{0., 0., in.length, in.temperature, 0., true};
      double state[n_states] = {}, unused = 0.;
      std::fill(tangent, tangent + n * n, 0.);
      if (!answer(in, first, true, state, stress, tangent, unused))
        return LawStatus::failed;
    }
    if (in.tangent != LawTangent::none)
      std::copy(tangent, tangent + n * n, out.tangent);
    return LawStatus::ok;
  }
};

constexpr Umat law;

} // namespace

const frictionbeam::LawDescription frictionbeam_law = {frictionbeam::law_interface_version,
                                                       is_section ? frictionbeam::LawKind::section
                                                                  : frictionbeam::LawKind::support,
                                                       n,
                                                       n_states,
                                                       FRICTIONBEAM_UMAT_IS_SYMMETRIC,
                                                       FRICTIONBEAM_UMAT_NAME,
                                                       FRICTIONBEAM_UMAT_REFERENCE,
                                                       n_parameters,
                                                       parameters,
                                                       &law,
                                                       nullptr};
