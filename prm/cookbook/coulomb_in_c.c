// SPDX-License-Identifier: LGPL-2.1-or-later

/*
 * Coulomb friction on a unilateral contact, in C: with ES, GS the rigidities of the element,
 *   N = ES eps if negative, else N = T = 0;  T = GS (gamma - gamma_p),  |T| <= f |N|.
 * Compile it with
 *   cc -std=c99 -O2 -shared -fPIC -I include prm/cookbook/coulomb_in_c.c -o coulomb_in_c.so -lm
 * check it with  frictionbeam-check-law coulomb_in_c.so  and name it in the parameter file:
 *   set Law libraries = coulomb_in_c.so
 */
#include <frictionbeam/law_c.h>

#include <math.h>
#include <string.h>

enum { ES, GS, FRICTION, N_PARAMETERS };

static const frictionbeam_c_parameter parameters[N_PARAMETERS] = {
    {"Axial rigidity", "N", 1e9, 1., 1e300, "ES of the element, in compression"},
    {"Shear rigidity", "N", 1e9, 1., 1e300, "GS of the element"},
    {"Friction coefficient", "-", 0.3, 0., 100., "f"}};

enum { SLIP_Y, SLIP_Z, TWIST, WAS_SLIPPING, N_STATES };
enum { N = FRICTIONBEAM_N_SUPPORT_STRAINS };

/* T on the circle of radius limit, in the direction of the trial; gamma_p grows by what is cut off.
 */
static void slide(const double *p, const double trial[2], const double size, const double limit,
                  double C[N][N], frictionbeam_c_output *out) {
  int i, j;
  for (i = 0; i < 2; ++i) {
    const double direction = trial[i] / size;
    out->stress[1 + i] = limit * direction;
    out->new_state[i] += (trial[i] - out->stress[1 + i]) / p[GS];
    C[1 + i][0] = -p[FRICTION] * p[ES] * direction;
    for (j = 0; j < 2; ++j)
      C[1 + i][1 + j] = p[GS] * limit / size * ((i == j) - direction * trial[j] / size);
  }
  out->dissipation = limit * (size - limit) / p[GS];
}

static int integrate(const frictionbeam_c_input *in, frictionbeam_c_output *out) {
  const double *const p = in->parameters;
  const double *const strain = in->strain;
  double C[N][N] = {{0.}};
  int i;

  memset(out->stress, 0, N * sizeof(double));
  if (strain[0] >= 0.) { /* open: the slip follows the node */
    for (i = 0; i < 3; ++i)
      out->new_state[i] = strain[1 + i];
    out->new_state[WAS_SLIPPING] = 0.;
    out->contact = FRICTIONBEAM_OPEN;
  } else {
    const double limit = p[FRICTION] * -p[ES] * strain[0];
    const double trial[2] = {p[GS] * (strain[1] - in->old_state[SLIP_Y]),
                             p[GS] * (strain[2] - in->old_state[SLIP_Z])};
    const double size = hypot(trial[0], trial[1]);
    const int slips = size > limit || p[FRICTION] == 0.;
    memcpy(out->new_state, in->old_state, N_STATES * sizeof(double));
    out->new_state[WAS_SLIPPING] = slips;
    out->stress[0] = p[ES] * strain[0];
    C[0][0] = p[ES];
    if (slips && limit > 0.)
      slide(p, trial, size, limit, C, out);
    else
      for (i = 0; i < 2; ++i) {
        if (slips)
          out->new_state[i] = strain[1 + i];
        else
          out->stress[1 + i] = trial[i];
        C[1 + i][1 + i] = slips ? 0. : p[GS];
      }
    out->contact = p[FRICTION] == 0. ? FRICTIONBEAM_CLOSED
                   : slips           ? FRICTIONBEAM_SLIP
                                     : FRICTIONBEAM_STICK;
  }
  if (in->tangent == FRICTIONBEAM_ELASTIC_TANGENT) {
    memset(C, 0, sizeof(C));
    C[0][0] = p[ES];
    C[1][1] = C[2][2] = p[GS];
  }
  if (in->tangent != FRICTIONBEAM_NO_TANGENT)
    memcpy(out->tangent, C, sizeof(C));
  return FRICTIONBEAM_OK;
}

/* The closed form: with it the exact method takes the law for what it is. */
static void threshold(const frictionbeam_c_input *in, frictionbeam_c_threshold *form) {
  form->static_friction = form->dynamic_friction = in->parameters[FRICTION];
  form->axial_rigidity = in->parameters[ES];
  form->shear_rigidity_y = form->shear_rigidity_z = in->parameters[GS];
  form->slip_y = SLIP_Y;
  form->slip_z = SLIP_Z;
  form->twist = TWIST;
  form->was_slipping = WAS_SLIPPING;
}

static const frictionbeam_c_law law = {FRICTIONBEAM_LAW_C_VERSION,
                                       sizeof(frictionbeam_c_law),
                                       NULL, /* fault */
                                       "coulomb_in_c",
                                       "FrictionBeam, prm/cookbook/coulomb_in_c.c",
                                       FRICTIONBEAM_SUPPORT,
                                       N_STATES,
                                       0, /* symmetric tangent */
                                       N_PARAMETERS,
                                       parameters,
                                       &integrate,
                                       NULL, /* the state begins with zeros */
                                       &threshold};

const frictionbeam_c_law *frictionbeam_law_c(void) { return &law; }
