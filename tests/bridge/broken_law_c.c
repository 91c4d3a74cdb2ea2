// SPDX-License-Identifier: LGPL-2.1-or-later

/*
 * Laws in C that the loader refuses, each with one fault, chosen when compiling. Without any, a law
 * that it takes: its stress is its state, which begins with the parameter and grows by one in every
 * increment.
 */
#include <frictionbeam/law_c.h>

#include <math.h>
#include <stddef.h>

#define NONE 1e300

const frictionbeam_c_parameter parameters[] = {{
#ifdef PARAMETER_NAME
    NULL,
#else
    "Start",
#endif
#ifdef UNIT
    "",
#else
    "N",
#endif
#ifdef DEFAULT_NAN
    NAN,
#elif defined(DEFAULT_OUTSIDE)
    -5.,
#else
    7.,
#endif
#ifdef MINIMUM_INFINITE
    -INFINITY,
#else
    0.,
#endif
#ifdef MAXIMUM_NAN
    NAN,
#else
    NONE,
#endif
    "first state"}};

int integrate(const frictionbeam_c_input *in, frictionbeam_c_output *out) {
  int i, n = FRICTIONBEAM_N_SUPPORT_STRAINS;
  out->new_state[0] = in->old_state[0] + 1.;
  for (i = 0; i < n; ++i)
    out->stress[i] = out->new_state[0];
  for (i = 0; i < n * n && in->tangent != FRICTIONBEAM_NO_TANGENT; ++i)
    out->tangent[i] = 0.;
#ifdef CONTACT_WRONG
  out->contact = 17;
#endif
  return FRICTIONBEAM_OK;
}

void initialize(const double *p, double *state) { state[0] = p[0]; }

void threshold(const frictionbeam_c_input *in, frictionbeam_c_threshold *form) {
  form->static_friction = in->parameters[0];
  form->slip_y = 77;
}

static const frictionbeam_c_law law = {
#ifdef VERSION_WRONG
    FRICTIONBEAM_LAW_C_VERSION + 1,
#else
    FRICTIONBEAM_LAW_C_VERSION,
#endif
#ifdef SIZE_WRONG
    12,
#else
    sizeof(frictionbeam_c_law),
#endif
#ifdef FAULT
    "the table of stiffnesses is missing",
#else
    NULL,
#endif
#ifdef NAME
    NULL,
#elif defined(CONTACT_WRONG)
    "wrong_contact",
#else
    "counter",
#endif
#ifdef REFERENCE
    NULL,
#else
    "a test",
#endif
#ifdef KIND_WRONG
    5,
#else
    FRICTIONBEAM_SUPPORT,
#endif
#ifdef STATES_WRONG
    1000,
#else
    1,
#endif
    1,
#ifdef LIST_TOO_LONG
    2000000000,
#else
    1,
#endif
#ifdef LIST_MISSING
    NULL,
#else
    parameters,
#endif
#ifdef INTEGRATE_MISSING
    NULL,
#else
    &integrate,
#endif
#ifdef PLACE_OUTSIDE
    NULL,
#else
    &initialize,
#endif
#if defined(BEGUN_AND_CLOSED) || defined(PLACE_OUTSIDE)
    &threshold
#else
    NULL
#endif
};

#ifdef SYMBOL_MISSING
const frictionbeam_c_law *another_name(void);
const frictionbeam_c_law *another_name(void) { return &law; }
#elif defined(NOTHING_AT_ALL)
const frictionbeam_c_law *frictionbeam_law_c(void) { return law.size > 0 ? NULL : &law; }
#else
const frictionbeam_c_law *frictionbeam_law_c(void) { return &law; }
#endif
