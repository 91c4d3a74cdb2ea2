// SPDX-License-Identifier: LGPL-2.1-or-later

/*
 * A behaviour that MFront generated for its interface "generic", as a law, by MGIS' bindings to C
 * (2.0 or later); built by frictionbeam_add_mgis(), which writes frictionbeam_mgis.h with what it
 * was told. The law's state is the internal state variables, the thermodynamic forces and the
 * gradients at the end of the last increment, the last temperature, and a flag, 1 once it has
 * begun.
 *
 * Kind support: a cohesive zone model, traction [Pa] by opening displacement [m], normal component
 * first; force = traction times area, no torsional moment. Kind section: a general behaviour whose
 * gradients are the six generalized strains and whose forces are the six stresses, in our order and
 * units. Material properties are the law's parameters; the temperature comes in kelvin.
 *
 * The tangent operator comes in blocks, one of each force by each gradient, each row by row: six
 * scalars or one symmetric tensor are one matrix, two vectors are four matrices of three by three.
 */
#include <frictionbeam/law_c.h>

#include "frictionbeam_mgis.h"

#include <MGIS/Behaviour/Behaviour.h>
#include <MGIS/Behaviour/BehaviourData.h>
#include <MGIS/Behaviour/BehaviourDataView.h>
#include <MGIS/Behaviour/Integrate.h>
#include <MGIS/Behaviour/State.h>

#include <stdio.h>
#include <string.h>

#if FRICTIONBEAM_MGIS_IS_SECTION
enum { KIND = FRICTIONBEAM_SECTION, IS_SUPPORT = 0, N_STRAINS = FRICTIONBEAM_N_SECTION_STRAINS };
enum { N = 6, N_OWN = 0 };
#define MGIS_TYPE MGIS_BV_GENERALBEHAVIOUR
#else
enum { KIND = FRICTIONBEAM_SUPPORT, IS_SUPPORT = 1, N_STRAINS = FRICTIONBEAM_N_SUPPORT_STRAINS };
enum { N = 3, N_OWN = 1 }; /* the area is our own parameter */
#define MGIS_TYPE MGIS_BV_COHESIVEZONEMODEL
#endif

static const struct {
  const char *name;
  double value;
} defaults[] = {FRICTIONBEAM_MGIS_DEFAULTS{NULL, 0.}};

static const int block_sizes[] = {FRICTIONBEAM_MGIS_GRADIENTS}; /* components of each gradient */
enum { N_BLOCKS = sizeof(block_sizes) / sizeof(block_sizes[0]) };

static mgis_bv_Behaviour *behaviour;
static mgis_size_type n_isvs;
static int loses; /* whether the behaviour says what it dissipates */
static frictionbeam_c_law law;
enum { MOST_PARAMETERS = 200 };
static frictionbeam_c_parameter list[MOST_PARAMETERS];
static char fault[1000];

static int is_good(const mgis_status status) { return status.exit_status == MGIS_SUCCESS; }

/* Places within the state, behind the internal state variables. */
enum { AT_FORCES = 0, AT_GRADIENTS = N, AT_TEMPERATURE = 2 * N, HAS_BEGUN, N_MORE };

/* What an integration is given. */
typedef struct Increment {
  const double *properties;
  const double *gradients; /* at the end */
  const double *old_state; /* null: of the material that nothing has happened to */
  double temperature[2];   /* [K] at the start and at the end */
  double length;           /* [s] */
  double operator_wanted;  /* MGIS: 0 none, 1 elastic, 4 consistent */
} Increment;

/* Properties, temperature and old state into one of the two states of MGIS' data. */
static int fill(mgis_bv_State *state, const Increment *in, const double temperature) {
  mgis_size_type i;
  double *to;
  for (i = 0; i + N_OWN < (mgis_size_type)law.n_parameters; ++i)
    if (!is_good(mgis_bv_state_set_material_property_by_offset(state, i, in->properties[i])))
      return 0;
  if (!is_good(mgis_bv_state_set_scalar_external_state_variable_by_name(state, "Temperature",
                                                                        temperature)))
    return 0;
  if (in->old_state == NULL)
    return 1;
  if (n_isvs > 0) {
    if (!is_good(mgis_bv_state_get_internal_state_variables(&to, state)))
      return 0;
    memcpy(to, in->old_state, n_isvs * sizeof(double));
  }
  if (!is_good(mgis_bv_state_get_thermodynamic_force_by_offset(&to, state, 0)))
    return 0;
  memcpy(to, in->old_state + n_isvs + AT_FORCES, N * sizeof(double));
  if (!is_good(mgis_bv_state_get_gradient_by_offset(&to, state, 0)))
    return 0;
  memcpy(to, in->old_state + n_isvs + AT_GRADIENTS, N * sizeof(double));
  return 1;
}

/* The blocks of the tangent operator as one matrix, row by row. */
static void put_together(const double *blocks, double *matrix) {
  int a, b, i, j, row = 0;
  for (a = 0; a < N_BLOCKS; row += block_sizes[a++]) {
    int column = 0;
    for (b = 0; b < N_BLOCKS; column += block_sizes[b++])
      for (i = 0; i < block_sizes[a]; ++i)
        for (j = 0; j < block_sizes[b]; ++j)
          matrix[N * (row + i) + column + j] = *blocks++;
  }
}

/* Results into new_state (if not null), stiffness (if wanted) and lost; returns whether there are.
 */
static int integrate_data(mgis_bv_BehaviourData *data, const Increment *in, double *new_state,
                          double *stiffness, double *lost) {
  mgis_bv_State *before, *after;
  mgis_bv_BehaviourDataView view;
  double *forces, *gradients, *isvs = NULL;
  int result = -1;
  if (!is_good(mgis_bv_behaviour_data_get_state_0(&before, data)) ||
      !is_good(mgis_bv_behaviour_data_get_state_1(&after, data)) ||
      !is_good(mgis_bv_behaviour_data_set_time_increment(data, in->length)) ||
      !fill(before, in, in->temperature[0]) || !fill(after, in, in->temperature[1]) ||
      !is_good(mgis_bv_state_get_gradient_by_offset(&gradients, after, 0)) ||
      !is_good(mgis_bv_state_get_thermodynamic_force_by_offset(&forces, after, 0)) ||
      (n_isvs > 0 && !is_good(mgis_bv_state_get_internal_state_variables(&isvs, after))))
    return 0;
  memcpy(gradients, in->gradients, N * sizeof(double));
  if (!is_good(mgis_bv_make_behaviour_data_view(&view, data)))
    return 0;
  view.K[0] = in->operator_wanted;
  if (!is_good(mgis_bv_integrate(&result, &view, behaviour)) || result != 1)
    return 0; /* 0 are results that MGIS calls unreliable */
  if (in->operator_wanted != 0.)
    put_together(view.K, stiffness);
  *lost = loses ? *view.s1.dissipated_energy : 0.; /* it began with 0 */
  if (new_state != NULL) {
    if (n_isvs > 0)
      memcpy(new_state, isvs, n_isvs * sizeof(double));
    memcpy(new_state + n_isvs + AT_FORCES, forces, N * sizeof(double));
    memcpy(new_state + n_isvs + AT_GRADIENTS, in->gradients, N * sizeof(double));
  }
  return 1;
}

static int integrate_once(const Increment *in, double *new_state, double *stiffness, double *lost) {
  mgis_bv_BehaviourData *data = NULL;
  int result;
  if (!is_good(mgis_bv_allocate_behaviour_data(&data, behaviour)))
    return 0;
  result = integrate_data(data, in, new_state, stiffness, lost);
  mgis_bv_free_behaviour_data(&data);
  return result;
}

static int integrate(const frictionbeam_c_input *in, frictionbeam_c_output *out) {
  /* Support: gradients are displacements, strain times length; forces are tractions times area. */
  const double by_strain = IS_SUPPORT ? in->length : 1.,
               by_force = IS_SUPPORT ? in->parameters[0] : 1.;
  const double *const old = in->old_state + n_isvs;
  const double kelvin = in->temperature + 273.15;
  const int has_begun = old[HAS_BEGUN] != 0.;
  double gradients[N], stiffness[N * N], lost = 0.;
  Increment increment;
  int i, j;

  for (i = 0; i < N; ++i)
    gradients[i] = by_strain * in->strain[i];
  increment.properties = in->parameters + N_OWN;
  increment.gradients = gradients;
  increment.old_state = in->old_state;
  increment.temperature[0] = has_begun ? old[AT_TEMPERATURE] + 273.15 : kelvin;
  increment.temperature[1] = kelvin;
  increment.length = in->time_increment;
  increment.operator_wanted = in->tangent == FRICTIONBEAM_CONSISTENT_TANGENT ? 4. : 0.;
  if (!integrate_once(&increment, out->new_state, stiffness, &lost))
    return FRICTIONBEAM_FAILED;
  out->new_state[n_isvs + AT_TEMPERATURE] = in->temperature;
  out->new_state[n_isvs + HAS_BEGUN] = 1.;
  out->dissipation = lost * by_force / by_strain;
  for (i = 0; i < N_STRAINS; ++i)
    out->stress[i] = i < N ? by_force * out->new_state[n_isvs + AT_FORCES + i] : 0.;
  if (IS_SUPPORT)
    out->contact = out->stress[0] < 0. ? FRICTIONBEAM_CLOSED : FRICTIONBEAM_OPEN;

  if (in->tangent == FRICTIONBEAM_ELASTIC_TANGENT) { /* just closed, untouched before */
    for (i = 0; i < N; ++i)
      gradients[i] = IS_SUPPORT && i == 0 ? -1e-12 : 0.;
    increment.old_state = NULL;
    increment.temperature[0] = kelvin;
    increment.operator_wanted = 1.;
    if (!integrate_once(&increment, NULL, stiffness, &lost))
      return FRICTIONBEAM_FAILED;
  }
  if (in->tangent != FRICTIONBEAM_NO_TANGENT)
    for (i = 0; i < N_STRAINS; ++i)
      for (j = 0; j < N_STRAINS; ++j)
        out->tangent[N_STRAINS * i + j] =
            i < N && j < N ? by_force * by_strain * stiffness[N * i + j] : 0.;
  return FRICTIONBEAM_OK;
}

/* The behaviour's bounds of a property, or none. */
static void bound(frictionbeam_c_parameter *p) {
  int has = 0;
  long double value;
  p->minimum = -1e300;
  p->maximum = 1e300;
  if (is_good(mgis_bv_behaviour_has_lower_physical_bound(&has, behaviour, p->name)) && has &&
      is_good(mgis_bv_behaviour_get_lower_physical_bound(&value, behaviour, p->name)))
    p->minimum = (double)value;
  has = 0;
  if (is_good(mgis_bv_behaviour_has_upper_physical_bound(&has, behaviour, p->name)) && has &&
      is_good(mgis_bv_behaviour_get_upper_physical_bound(&value, behaviour, p->name)))
    p->maximum = (double)value;
}

static int list_properties(const mgis_size_type n) {
  const size_t n_all = n + N_OWN;
  mgis_size_type i;
  size_t j, k;
  mgis_bv_VariableType type;
  if (n_all > MOST_PARAMETERS) {
    sprintf(fault, "the behaviour '%.200s' has %lu material properties, expected %d at most.",
            FRICTIONBEAM_MGIS_BEHAVIOUR, (unsigned long)n, MOST_PARAMETERS - N_OWN);
    return 0;
  }
  if (N_OWN > 0) {
    const frictionbeam_c_parameter area = {
        "Contact area", "m2", 1., 1e-300, 1e300, "force is traction times this area"};
    list[0] = area;
  }
  law.parameters = list;
  law.n_parameters = (int)n_all;
  for (i = 0; i < n; ++i) {
    frictionbeam_c_parameter *const p = list + N_OWN + i;
    if (!is_good(mgis_bv_behaviour_get_material_property_name(&p->name, behaviour, i)) ||
        !is_good(mgis_bv_behaviour_get_material_property_type(&type, behaviour, i)) ||
        type != MGIS_BV_SCALAR)
      return 0;
    p->unit = "SI";
    p->meaning = "material property of the MFront behaviour " FRICTIONBEAM_MGIS_BEHAVIOUR;
    bound(p);
    p->default_value = p->minimum > 0. ? p->minimum : p->maximum < 0. ? p->maximum : 0.;
  }
  for (j = 0; defaults[j].name != NULL; ++j) {
    for (k = 0; k < n_all && strcmp(list[k].name, defaults[j].name) != 0; ++k)
      ;
    if (k == n_all) {
      sprintf(fault,
              "DEFAULTS names '%.200s', which is no material property of the behaviour '%s'.",
              defaults[j].name, FRICTIONBEAM_MGIS_BEHAVIOUR);
      return 0;
    }
    list[k].default_value = defaults[j].value;
  }
  return 1;
}

/* Load and look at the behaviour; what is wrong stands in fault. */
static void load(void) {
  mgis_bv_BehaviourType type;
  mgis_size_type n_gradients, n_forces, n_stiffness, n_properties, n_variables, i;
  const char *variable = "";
  const mgis_status status =
      mgis_bv_load_behaviour(&behaviour, FRICTIONBEAM_MGIS_LIBRARY, FRICTIONBEAM_MGIS_BEHAVIOUR,
                             FRICTIONBEAM_MGIS_HYPOTHESIS);
  if (!is_good(status)) {
    sprintf(fault,
            "MGIS does not load the behaviour '%.200s' from '%.300s' (%.300s). Expected a library "
            "that 'mfront --interface=generic' built.",
            FRICTIONBEAM_MGIS_BEHAVIOUR, FRICTIONBEAM_MGIS_LIBRARY, status.msg);
    return;
  }
  sprintf(fault, "MGIS does not describe the behaviour '%.200s'.", FRICTIONBEAM_MGIS_BEHAVIOUR);
  if (!is_good(mgis_bv_behaviour_get_behaviour_type(&type, behaviour)) ||
      !is_good(mgis_bv_behaviour_get_gradients_size(&n_gradients, behaviour)) ||
      !is_good(mgis_bv_behaviour_get_thermodynamic_forces_size(&n_forces, behaviour)) ||
      !is_good(mgis_bv_behaviour_get_tangent_operator_array_size(&n_stiffness, behaviour)) ||
      !is_good(mgis_bv_behaviour_get_number_of_material_properties(&n_properties, behaviour)) ||
      !is_good(mgis_bv_behaviour_get_internal_state_variables_size(&n_isvs, behaviour)) ||
      !is_good(mgis_bv_behaviour_computes_dissipated_energy(&loses, behaviour)) ||
      !is_good(mgis_bv_behaviour_get_number_of_external_state_variables(&n_variables, behaviour)))
    return;
  if (type != MGIS_TYPE || n_gradients != N || n_forces != N || n_stiffness != N * N) {
    sprintf(fault,
            "the behaviour '%.200s' is of MGIS' type %d with %lu gradients, %lu forces and %lu "
            "entries of the tangent operator; a law of its kind needs %s: type %d, %d, %d and %d.",
            FRICTIONBEAM_MGIS_BEHAVIOUR, (int)type, (unsigned long)n_gradients,
            (unsigned long)n_forces, (unsigned long)n_stiffness,
            IS_SUPPORT ? "a cohesive zone model in three dimensions"
                       : "a general behaviour of six generalized strains and stresses",
            (int)MGIS_TYPE, N, N, N * N);
    return;
  }
  for (i = 0; i < n_variables; ++i)
    if (!is_good(mgis_bv_behaviour_get_external_state_variable_name(&variable, behaviour, i)) ||
        strcmp(variable, "Temperature") != 0) {
      sprintf(fault,
              "the behaviour '%.200s' wants the external state variable '%.200s'; there is the "
              "Temperature alone.",
              FRICTIONBEAM_MGIS_BEHAVIOUR, variable);
      return;
    }
  if (n_isvs + N_MORE > 999) {
    sprintf(fault, "the behaviour '%.200s' has %lu internal state variables, expected %d at most.",
            FRICTIONBEAM_MGIS_BEHAVIOUR, (unsigned long)n_isvs, 999 - N_MORE);
    return;
  }
  sprintf(fault, "a material property of the behaviour '%.200s' is no scalar.",
          FRICTIONBEAM_MGIS_BEHAVIOUR);
  if (list_properties(n_properties))
    fault[0] = '\0';
}

#if defined(__GNUC__)
/* When the library is closed. */
__attribute__((destructor)) static void forget(void) {
  if (behaviour != NULL)
    mgis_bv_free_behaviour(&behaviour);
}
#endif

const frictionbeam_c_law *frictionbeam_law_c(void) {
  if (law.version == 0) {
    load();
    law.version = FRICTIONBEAM_LAW_C_VERSION;
    law.size = sizeof(law);
    law.fault = fault[0] != '\0' ? fault : NULL;
    law.name = FRICTIONBEAM_MGIS_NAME;
    law.reference = FRICTIONBEAM_MGIS_REFERENCE;
    law.kind = KIND;
    law.n_states = (int)n_isvs + N_MORE;
    law.integrate = &integrate;
  }
  return &law;
}
