// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef FRICTIONBEAM_LAW_C_H
#define FRICTIONBEAM_LAW_C_H

/**
 * @file
 * The interface of a constitutive law in plain C (C99), for laws in C, Fortran or any language that
 * can be called from C. It says what frictionbeam/law.h says, field by field, and is loaded by the
 * same door: a shared library that exports one function,
 * @code
 *   const frictionbeam_c_law *frictionbeam_law_c(void);
 * @endcode
 * is named in `Law libraries`, given to LawLibrary::load() or to frictionbeam-check-law.
 * prm/cookbook/coulomb_in_c.c is one in C, prm/cookbook/bilinear_section.f90 one in Fortran.
 */
#ifndef __cplusplus
#include <stdbool.h>
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Raised whenever anything in this header changes. */
#define FRICTIONBEAM_LAW_C_VERSION 1

/** frictionbeam_c_law::kind, and the number of strains and stresses that goes with it. */
enum {
  FRICTIONBEAM_SUPPORT = 0, /**< eps, gamma_y, gamma_z, chi to N, T_y, T_z [N], M_x [N m] */
  FRICTIONBEAM_SECTION = 1, /**< eps, gamma_y, gamma_z, chi, kappa_y, kappa_z to
                                 N, V_y, V_z [N], M_x, M_y, M_z [N m] */
  FRICTIONBEAM_N_SUPPORT_STRAINS = 4,
  FRICTIONBEAM_N_SECTION_STRAINS = 6
};

/** frictionbeam_c_output::contact; a law of sections leaves it 0. */
enum {
  FRICTIONBEAM_NONE = 0,
  FRICTIONBEAM_STICK = 1,
  FRICTIONBEAM_SLIP = 2,
  FRICTIONBEAM_OPEN = 3,
  FRICTIONBEAM_CLOSED = 4
};

/** frictionbeam_c_input::tangent: which d stress / d strain is wanted. */
enum {
  FRICTIONBEAM_NO_TANGENT = 0,         /**< leave frictionbeam_c_output::tangent untouched */
  FRICTIONBEAM_CONSISTENT_TANGENT = 1, /**< derivative of the stress that this call returns */
  FRICTIONBEAM_ELASTIC_TANGENT = 2     /**< of the closed, sticking contact, whatever the state */
};

/** What integrate() returns. After a failure the program tries a smaller increment. */
enum { FRICTIONBEAM_OK = 0, FRICTIONBEAM_FAILED = 1 };

/** One parameter: an entry of the parameter file. All figures are finite; +-1e300 is no bound. */
typedef struct frictionbeam_c_parameter {
  const char *name;
  const char *unit; /**< SI, "-" if none */
  double default_value;
  double minimum;
  double maximum;
  const char *meaning;
} frictionbeam_c_parameter;

/** What integrate() reads. Strains are total, at the end of the increment: a law that needs the
 *  increment keeps the last strain in its state. */
typedef struct frictionbeam_c_input {
  const double *parameters;   /**< in the order of frictionbeam_c_law::parameters */
  const double *strain;       /**< generalized strain at the end of the increment */
  const double *strain_rate;  /**< its mean rate over the increment [1/s]; zero in statics */
  const double *displacement; /**< support: of the second node relative to the first in local
                                   axes, 3 values [m]; section: null */
  double length;              /**< of the element [m] */
  double time;                /**< at the end of the increment [s] */
  double time_increment;      /**< [s]; 0 in statics */
  double temperature;         /**< at the end of the increment [degC] */
  const double *old_state;    /**< at the start of the increment */
  int tangent;                /**< which tangent to write */
  double pressure;            /**< section: inside the pipe over that outside, at the end [Pa] */
} frictionbeam_c_input;

/** What integrate() writes. The arrays belong to the caller. */
typedef struct frictionbeam_c_output {
  double *stress;       /**< n_strains values */
  double *tangent;      /**< tangent[i * n_strains + j] = d stress_i / d strain_j */
  double *new_state;    /**< n_states values; never old_state */
  double dissipation;   /**< in the increment, per unit length [J/m], >= 0; 0 at first */
  int contact;          /**< state at the end of the increment */
  double stored_energy; /**< section: free energy per unit length at the end [J/m]; 0 at first */
  double error; /**< estimate of what the increment's length leaves in the stress, as a share of
                     it; 0 at first */
} frictionbeam_c_output;

/** Closed form of a Coulomb law, as frictionbeam::FrictionThreshold has it; zeros at first. */
typedef struct frictionbeam_c_threshold {
  double static_friction;
  double dynamic_friction;   /**< <= static_friction */
  double gap;                /**< [m] */
  double axial_rigidity;     /**< [N], infinity for a rigid contact */
  double shear_rigidity_y;   /**< [N] */
  double shear_rigidity_z;   /**< [N] */
  double torsional_rigidity; /**< [N m2] */
  double patch_radius;       /**< [m]; 0: no limit */
  int slip_y, slip_z;        /**< places of the irreversible shear strains in the state */
  int twist;                 /**< place of the irreversible twist rate */
  int was_slipping;          /**< place of a flag, 1 if the contact slips, else 0 */
  bool varies;               /**< whether the coefficients depend on more than the parameters */
} frictionbeam_c_threshold;

/** Everything the program knows about a law before it calls it. It outlives the program's use. */
typedef struct frictionbeam_c_law {
  int version;           /**< FRICTIONBEAM_LAW_C_VERSION */
  int size;              /**< sizeof(frictionbeam_c_law) */
  const char *fault;     /**< null, or why there is no law: loading ends with these words */
  const char *name;      /**< as in the parameter file */
  const char *reference; /**< where the law is from */
  int kind;
  int n_states;          /**< 0 to 999 internal variables */
  int symmetric_tangent; /**< 1 if the consistent tangent is symmetric in every state, else 0 */
  int n_parameters;
  const frictionbeam_c_parameter *parameters;
  /** Stress, tangent and new state at the end of an increment. No memory of its own: equal calls
   *  give equal results. FRICTIONBEAM_OK or FRICTIONBEAM_FAILED. */
  int (*integrate)(const frictionbeam_c_input *input, frictionbeam_c_output *output);
  /** The state at the very start, n_states values; null if it is zero. The program then keeps one
   *  internal variable more, which says that the law has begun. Not together with threshold. */
  void (*initialize)(const double *parameters, double *state);
  /** The closed form of a friction law, or null. It is given what integrate() is given, with
   *  strain and displacement zero. */
  void (*threshold)(const frictionbeam_c_input *input, frictionbeam_c_threshold *threshold);
} frictionbeam_c_law;

/** What the library of a law exports. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const frictionbeam_c_law *
frictionbeam_law_c(void);

#ifdef __cplusplus
}
#endif

#endif
