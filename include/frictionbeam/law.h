// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/**
 * @file
 * The interface of a constitutive law, plain C++ without deal.II: one law is compiled once, into a
 * shared library of its own, and then loaded by debug and release programs alike.
 *
 * A law's library exports one constant object,
 * @code
 *   extern "C" const frictionbeam::LawDescription frictionbeam_law;
 * @endcode
 * plugin/law_skeleton.cc is a law that compiles and explains itself; start from a copy of it.
 */
namespace frictionbeam {

/// Raised whenever anything in this header changes that a compiled law depends on. Libraries from
/// oldest_law_interface_version on are loaded, others are refused. Version 1 had closed forms of
/// the parameters alone, `void (*threshold)(const double *parameters, FrictionThreshold &)`: ask
/// them by closed_form(), which knows both. Hosts of version 2 give no
/// LawInput::temperature_change, those of versions before 4 no old state to report().
inline constexpr int law_interface_version = 4;
inline constexpr int oldest_law_interface_version = 1;

/// What a law is evaluated on, and with that the meaning of its strains and stresses.
enum class LawKind : int {
  /// Friction element: 4 strains eps, gamma_y, gamma_z, chi (twist rate, rad/m); 4 stresses
  /// N, T_y, T_z [N], torsional moment M_x [N m]. Axis x from the pipe (first node) to the ground.
  support = 0,
  /// Beam section: 6 strains eps, gamma_y, gamma_z, chi, kappa_y, kappa_z [-, -, -, rad/m (3)];
  /// 6 stresses N, V_y, V_z [N], M_x, M_y, M_z [N m]. The strain is what causes stress and flow:
  /// the host has taken free strains of temperature and pressure off, so that no strain is no
  /// stress. N is the force in the wall. Of a law that has a parameter `Bend radius` and none
  /// `Bending rigidity`, so that a bend's flexibility is its own, y is towards the bend's centre
  /// there, z = x cross y.
  section = 1
};

inline constexpr int n_support_strains = 4;
inline constexpr int n_section_strains = 6;

/// State of a contact. A law of kind `section` reports `none`.
enum class ContactStatus : int { none = 0, stick = 1, slip = 2, open = 3, closed = 4 };

/// Which tangent d stress / d strain the caller wants.
enum class LawTangent : int {
  none = 0,       ///< no tangent: leave LawOutput::tangent untouched
  consistent = 1, ///< derivative of the stress that this very call returns
  elastic = 2     ///< the elastic stiffness of the closed, sticking contact, whatever the state
};

/// Outcome of LawBase::integrate. A failure makes the program cut the increment.
enum class LawStatus : int { ok = 0, failed = 1 };

/// One parameter of a law. The host turns it into an entry of the parameter file with bounds and
/// unit, and into documentation; the author writes it once, here.
struct LawParameter {
  const char *name;
  const char *unit; ///< SI, "-" if none
  double default_value;
  double minimum;
  double maximum;
  const char *meaning;
};

/// What integrate() reads. All arrays belong to the caller.
struct LawInput {
  const double *parameters;  ///< in the order of LawDescription::parameters
  const double *strain;      ///< generalized strain at the end of the increment
  const double *strain_rate; ///< its mean rate over the increment [1/s]; zero in statics. It is
                             ///< that of the middle: what a stress depends on it makes time steps
                             ///< of first order
  const double *displacement; ///< kind support: displacement of the second node relative to the
                              ///< first in local axes, 3 values [m]; otherwise null
  double length;              ///< length of the element [m]
  double time;                ///< at the end of the increment [s]
  double time_increment;      ///< [s]
  double temperature;         ///< of what it belongs to, at the end of the increment [degC]
  const double *old_state;    ///< internal variables at the start of the increment; zero at first
  LawTangent tangent;         ///< which tangent to write
  double pressure = 0.;       ///< kind section: inside the pipe over that outside, at the end [Pa]
  double temperature_change = 0.; ///< kind section: in the increment [K]
};

/// What integrate() writes. All arrays belong to the caller.
struct LawOutput {
  double *stress;     ///< n_strains values
  double *tangent;    ///< n_strains x n_strains, row-major: tangent[i*n+j] = d stress_i/d strain_j
  double *new_state;  ///< n_internal_variables values; never aliases old_state
  double dissipation; ///< energy dissipated in the increment per unit length [J/m], >= 0
  ContactStatus contact;     ///< state at the end of the increment
  double stored_energy = 0.; ///< kind section: free energy per unit length at the end [J/m]; what
                             ///< stored energy gains and dissipation is the work of the stress
  double error = 0.; ///< estimate of what the increment's length leaves in the stress, as a share
                     ///< of it; 0 where the answer does not depend on it
};

/// What a law of kind `section` tells of its state, for results: at its worst point.
struct SectionReport {
  double utilization = 0.;    ///< equivalent stress over the yield stress that is reached by now
  double plastic_strain = 0.; ///< accumulated equivalent plastic strain [-]
  double creep_strain = 0.;   ///< accumulated equivalent creep strain [-]
};

/// A law. Objects are stateless and constant: all data comes in through LawInput.
class LawBase {
public:
  /**
   * Integrate the law over one increment: stress, tangent and new internal variables at its end
   * from the strain there and the internal variables at its start. Equal calls give equal results.
   * Committing is the caller's swap of the two states; a failed step is the caller doing nothing.
   */
  virtual LawStatus integrate(const LawInput &input, LawOutput &output) const noexcept = 0;

protected:
  ~LawBase() = default;
};

/**
 * Closed form of a Coulomb law for the exact contact method, which needs no stiffness: N <= 0,
 * |T| <= static_friction |N|, slipping at dynamic_friction |N|. Rigidities are those of the
 * element, ES and GS [N]; infinity stands for a rigid contact. The method reads and writes the
 * law's own internal variables, so that steps of either kind follow each other: their places in the
 * state.
 *
 * The two coefficients may depend on temperature, rate, time and old state of the increment
 * (`varies`); all else depends on the parameters alone. Nothing depends on the strain: what does is
 * no cone, and has no closed form.
 */
struct FrictionThreshold {
  double static_friction;
  double dynamic_friction;   ///< <= static_friction
  double gap;                ///< [m], >= 0 open
  double axial_rigidity;     ///< [N], > 0
  double shear_rigidity_y;   ///< [N], > 0
  double shear_rigidity_z;   ///< [N], > 0
  double torsional_rigidity; ///< [N m2], >= 0
  double patch_radius;       ///< limits the torsional moment to f|N|r [m]; 0: no limit
  int slip_y, slip_z;        ///< places of the irreversible shear strains gamma_p
  int twist;                 ///< place of the irreversible twist rate
  int was_slipping;          ///< place of a flag, 1 if the contact slips, else 0
  bool varies; ///< whether the coefficients depend on more than the parameters; false at first
};

/// Everything the host knows about a law before it calls it.
struct LawDescription {
  int interface_version; ///< always first: law_interface_version of the compiled header
  LawKind kind;
  int n_strains;
  int n_internal_variables;
  bool symmetric_tangent; ///< true if the consistent tangent is symmetric in every state
  const char *name;       ///< as in the parameter file
  const char *reference;  ///< where the law is from
  int n_parameters;
  const LawParameter *parameters;
  const LawBase *law;
  /// The law's closed form, or null if it has none. It is given what integrate() is given, with
  /// strain and displacement zero.
  void (*threshold)(const LawInput &input, FrictionThreshold &threshold);

  // What follows is of version 2, of laws of kind `section` but for the last, and may be left out.

  /// How many of n_internal_variables these parameters need; null: all.
  int (*n_states)(const double *parameters) = nullptr;
  /**
   * Bound of the elastic response: below 1, a section whose internal variables are all zero answers
   * to this strain with `tangent elastic` times strain, and keeps them. Null: never known. A host
   * asks it before it integrates, so that a section without plastic history costs nothing. Of the
   * input neither old state nor rate is set.
   */
  double (*elastic_bound)(const LawInput &input) = nullptr;
  /// Integrate @p n sections at once, each as integrate() does; failed if one of them failed. Null:
  /// one by one.
  LawStatus (*integrate_all)(int n, const LawInput *inputs, LawOutput *outputs) = nullptr;
  /// What the state at the end of an increment is like. @p input is that of the increment, without
  /// rate; its old state is null, or one from before: plastic and creep strains are then those of
  /// the point that has gained most since.
  void (*report)(const LawInput &input, const double *new_state, SectionReport &report) = nullptr;
  /// Of both kinds: what is wrong with these parameters together, each within its bounds: what is
  /// allowed, ": " and what to try, in a few words; null: nothing. A host refuses them with these.
  const char *(*fault)(const double *parameters) = nullptr;
};

/// Closed form of a law of any version that is loaded; zeros if it has none.
inline FrictionThreshold closed_form(const LawDescription &law, const LawInput &input) {
  FrictionThreshold form{};
  if (law.threshold == nullptr)
    return form;
  if (law.interface_version == 1) {
    using OfParameters = void (*)(const double *, FrictionThreshold &);
    const auto of_any_kind = reinterpret_cast<void (*)()>(law.threshold);
    reinterpret_cast<OfParameters>(of_any_kind)(input.parameters, form);
  } else
    law.threshold(input, form);
  return form;
}

} // namespace frictionbeam

/// The object that a law's library exports.
extern "C" __attribute__((visibility("default")))
const frictionbeam::LawDescription frictionbeam_law;
