// SPDX-License-Identifier: LGPL-2.1-or-later

/*
 * The stand-in's behaviours, all "in" libStandIn.so: Cohesive, Coulomb friction of an interface;
 * Section, an elastic section whose axial force feels the bending about y and the temperature, six
 * scalars; Vectors, the same with gradients of two vectors; Strain and Field, which no law can be.
 */
#include <MGIS/stand_in.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 6 };

struct mgis_bv_Behaviour {
  const char *name;
  mgis_bv_BehaviourType type;
  mgis_size_type n, n_isvs, n_properties, n_variables;
  const char *properties[4], *variables[2];
  int loses, (*integrate)(mgis_bv_BehaviourDataView *);
};
struct mgis_bv_State {
  mgis_real gradients[MOST], forces[MOST], properties[4], isvs[2], variables[1], lost;
  mgis_size_type n_isvs;
};
struct mgis_bv_BehaviourData {
  mgis_real dt, K[MOST * MOST], rdt;
  mgis_bv_State s0, s1;
};

/* Normal first; properties K_n, K_t, f; internal state variables: the slips. */
static int cohesive(mgis_bv_BehaviourDataView *d) {
  const mgis_real *const p = d->s0.material_properties, *const u = d->s1.gradients;
  const int wanted = (int)d->K[0];
  mgis_real *const t = d->s1.thermodynamic_forces, K[9] = {0.}, trial[2];
  const mgis_real limit = p[2] * -p[0] * u[0];
  mgis_real size;
  int i, j;
  if (u[0] > 1e3 || d->s1.material_properties[0] != p[0])
    return -1;
  memset(t, 0, 3 * sizeof(*t));
  if (u[0] < -1e3) /* done, and unreliable */
    return 0;
  for (i = 0; i < 2; ++i)
    trial[i] = p[1] * (u[1 + i] - d->s0.internal_state_variables[i]);
  size = hypot(trial[0], trial[1]);
  *d->s1.dissipated_energy = *d->s0.dissipated_energy;
  if (u[0] >= 0.) {
    for (i = 0; i < 2; ++i)
      d->s1.internal_state_variables[i] = u[1 + i];
  } else {
    t[0] = p[0] * u[0];
    K[0] = p[0];
    for (i = 0; i < 2; ++i) {
      const mgis_real direction = size > 0. ? trial[i] / size : 0.;
      t[1 + i] = size > limit ? limit * direction : trial[i];
      K[3 * (1 + i) + 1 + i] = p[1];
      d->s1.internal_state_variables[i] = u[1 + i] - t[1 + i] / p[1];
      if (size <= limit || wanted == 1)
        continue;
      K[3 * (1 + i)] = -p[2] * p[0] * direction;
      for (j = 0; j < 2; ++j)
        K[3 * (1 + i) + 1 + j] = p[1] * limit / size * ((i == j) - direction * trial[j] / size);
    }
    if (size > limit)
      *d->s1.dissipated_energy += limit * (size - limit) / p[1];
  }
  if (wanted != 0)
    memcpy(d->K, K, sizeof(K));
  return 1;
}

/* N = EA (eps - 1e-5 (T - 293.15 K)) + c kappa_y, M_y = EI kappa_y; properties EA, EI, c. The force
 * is that before plus what is added, so that what is handed over from before is seen. */
static int section(mgis_bv_BehaviourDataView *d) {
  const mgis_real *const p = d->s0.material_properties;
  const mgis_real rigidity[6] = {p[0], p[0], p[0], p[1], p[1], p[1]};
  mgis_real change[6];
  int i;
  for (i = 0; i < 6; ++i) {
    change[i] = d->s1.gradients[i] - d->s0.gradients[i];
    d->s1.thermodynamic_forces[i] = d->s0.thermodynamic_forces[i] + rigidity[i] * change[i];
  }
  d->s1.thermodynamic_forces[0] +=
      p[2] * change[4] -
      p[0] * 1e-5 * (d->s1.external_state_variables[0] - d->s0.external_state_variables[0]);
  if (d->K[0] != 0.) {
    memset(d->K, 0, 36 * sizeof(mgis_real));
    for (i = 0; i < 6; ++i)
      d->K[7 * i] = rigidity[i];
    d->K[4] = p[2];
  }
  return 1;
}

/* The same; its tangent operator are four blocks of three by three. */
static int vectors(mgis_bv_BehaviourDataView *d) {
  const mgis_real wanted = d->K[0];
  const mgis_real *const p = d->s0.material_properties;
  int i;
  section(d);
  if (wanted != 0.) {
    memset(d->K, 0, 36 * sizeof(mgis_real));
    for (i = 0; i < 3; ++i) {
      d->K[4 * i] = p[0];
      d->K[27 + 4 * i] = p[1];
    }
    d->K[9 + 1] = p[2];
  }
  return 1;
}

#define OF_SECTION                                                                                 \
  { "AxialRigidity", "BendingRigidity", "Coupling", NULL }
static mgis_bv_Behaviour behaviours[] = {
    {"Cohesive",
     MGIS_BV_COHESIVEZONEMODEL,
     3,
     2,
     3,
     1,
     {"NormalStiffness", "TangentialStiffness", "FrictionCoefficient", NULL},
     {"Temperature", NULL},
     1,
     &cohesive},
    {"Section",
     MGIS_BV_GENERALBEHAVIOUR,
     6,
     0,
     3,
     1,
     OF_SECTION,
     {"Temperature", NULL},
     0,
     &section},
    {"Vectors",
     MGIS_BV_GENERALBEHAVIOUR,
     6,
     0,
     3,
     1,
     OF_SECTION,
     {"Temperature", NULL},
     0,
     &vectors},
    {"Strain",
     MGIS_BV_STANDARDSTRAINBASEDBEHAVIOUR,
     6,
     0,
     3,
     1,
     OF_SECTION,
     {"Temperature", NULL},
     0,
     &section},
    {"Field",
     MGIS_BV_GENERALBEHAVIOUR,
     6,
     0,
     3,
     2,
     OF_SECTION,
     {"Temperature", "Porosity"},
     0,
     &section}};

static mgis_status status(const int is_good, const char *message) {
  mgis_status result;
  result.exit_status = is_good ? MGIS_SUCCESS : MGIS_FAILURE;
  result.msg = message;
  return result;
}

mgis_status mgis_bv_load_behaviour(mgis_bv_Behaviour **b, const char *const library,
                                   const char *const name, const char *const hypothesis) {
  size_t i;
  *b = NULL;
  for (i = 0; i < sizeof(behaviours) / sizeof(behaviours[0]); ++i)
    if (strcmp(behaviours[i].name, name) == 0)
      *b = behaviours + i;
  return status(*b != NULL && strcmp(library, "libStandIn.so") == 0 &&
                    strcmp(hypothesis, "Tridimensional") == 0,
                "the stand-in has no such behaviour");
}

mgis_status mgis_bv_free_behaviour(mgis_bv_Behaviour **b) {
  *b = NULL;
  return status(1, "");
}

#define GETTER(name, Type, value)                                                                  \
  mgis_status name(Type *const v, const mgis_bv_Behaviour *const b) {                              \
    *v = value;                                                                                    \
    return status(1, "");                                                                          \
  }
GETTER(mgis_bv_behaviour_get_behaviour_type, mgis_bv_BehaviourType, b->type)
GETTER(mgis_bv_behaviour_get_gradients_size, mgis_size_type, b->n)
GETTER(mgis_bv_behaviour_get_thermodynamic_forces_size, mgis_size_type, b->n)
GETTER(mgis_bv_behaviour_get_tangent_operator_array_size, mgis_size_type, b->n * b->n)
GETTER(mgis_bv_behaviour_get_number_of_material_properties, mgis_size_type, b->n_properties)
GETTER(mgis_bv_behaviour_get_internal_state_variables_size, mgis_size_type, b->n_isvs)
GETTER(mgis_bv_behaviour_get_number_of_external_state_variables, mgis_size_type, b->n_variables)
GETTER(mgis_bv_behaviour_computes_dissipated_energy, int, b->loses)

mgis_status mgis_bv_behaviour_get_material_property_name(const char **v,
                                                         const mgis_bv_Behaviour *const b,
                                                         const mgis_size_type i) {
  *v = b->properties[i];
  return status(i < b->n_properties, "no such property");
}
mgis_status mgis_bv_behaviour_get_material_property_type(mgis_bv_VariableType *const v,
                                                         const mgis_bv_Behaviour *const b,
                                                         const mgis_size_type i) {
  *v = MGIS_BV_SCALAR;
  return status(i < b->n_properties, "no such property");
}
mgis_status mgis_bv_behaviour_get_external_state_variable_name(const char **v,
                                                               const mgis_bv_Behaviour *const b,
                                                               const mgis_size_type i) {
  *v = b->variables[i];
  return status(i < b->n_variables, "no such variable");
}

/* Friction has bounds 0 and 10, stiffnesses and rigidities 1 and none. */
static int is_friction(const char *name) { return strcmp(name, "FrictionCoefficient") == 0; }
mgis_status mgis_bv_behaviour_has_lower_physical_bound(int *const v,
                                                       const mgis_bv_Behaviour *const b,
                                                       const char *const name) {
  *v = b != NULL && strcmp(name, "Coupling") != 0;
  return status(1, "");
}
mgis_status mgis_bv_behaviour_has_upper_physical_bound(int *const v,
                                                       const mgis_bv_Behaviour *const b,
                                                       const char *const name) {
  *v = b != NULL && is_friction(name);
  return status(1, "");
}
mgis_status mgis_bv_behaviour_get_lower_physical_bound(long double *const v,
                                                       const mgis_bv_Behaviour *const b,
                                                       const char *const name) {
  *v = is_friction(name) ? 0.L : 1.L;
  return status(b != NULL, "");
}
mgis_status mgis_bv_behaviour_get_upper_physical_bound(long double *const v,
                                                       const mgis_bv_Behaviour *const b,
                                                       const char *const name) {
  *v = 10.L;
  return status(b != NULL && is_friction(name), "no bound");
}

mgis_status mgis_bv_allocate_behaviour_data(mgis_bv_BehaviourData **d,
                                            const mgis_bv_Behaviour *const b) {
  *d = calloc(1, sizeof(**d));
  if (*d == NULL)
    return status(0, "no memory");
  (*d)->s0.n_isvs = (*d)->s1.n_isvs = b->n_isvs;
  return status(1, "");
}
mgis_status mgis_bv_behaviour_data_get_state_0(mgis_bv_State **s, mgis_bv_BehaviourData *const d) {
  *s = &d->s0;
  return status(1, "");
}
mgis_status mgis_bv_behaviour_data_get_state_1(mgis_bv_State **s, mgis_bv_BehaviourData *const d) {
  *s = &d->s1;
  return status(1, "");
}
mgis_status mgis_bv_behaviour_data_set_time_increment(mgis_bv_BehaviourData *const d,
                                                      const mgis_real dt) {
  d->dt = dt;
  return status(1, "");
}
mgis_status mgis_bv_free_behaviour_data(mgis_bv_BehaviourData **d) {
  free(*d);
  *d = NULL;
  return status(1, "");
}

mgis_status mgis_bv_state_get_gradient_by_offset(mgis_real **v, mgis_bv_State *const s,
                                                 const mgis_size_type i) {
  *v = s->gradients + i;
  return status(1, "");
}
mgis_status mgis_bv_state_get_thermodynamic_force_by_offset(mgis_real **v, mgis_bv_State *const s,
                                                            const mgis_size_type i) {
  *v = s->forces + i;
  return status(1, "");
}
mgis_status mgis_bv_state_set_material_property_by_offset(mgis_bv_State *const s,
                                                          const mgis_size_type i,
                                                          const mgis_real v) {
  s->properties[i] = v;
  return status(1, "");
}
mgis_status mgis_bv_state_get_internal_state_variables(mgis_real **v, mgis_bv_State *const s) {
  *v = s->isvs;
  return status(s->n_isvs > 0, "no internal state variables declared");
}
mgis_status mgis_bv_state_set_scalar_external_state_variable_by_name(mgis_bv_State *const s,
                                                                     const char *const name,
                                                                     const mgis_real v) {
  s->variables[0] = v;
  return status(strcmp(name, "Temperature") == 0, "no such variable");
}

mgis_status mgis_bv_make_behaviour_data_view(mgis_bv_BehaviourDataView *const v,
                                             mgis_bv_BehaviourData *const d) {
  memset(v, 0, sizeof(*v));
  v->dt = d->dt;
  v->K = d->K;
  v->rdt = &d->rdt;
  v->s0.gradients = d->s0.gradients;
  v->s0.thermodynamic_forces = d->s0.forces;
  v->s0.material_properties = d->s0.properties;
  v->s0.internal_state_variables = d->s0.isvs;
  v->s0.dissipated_energy = &d->s0.lost;
  v->s0.external_state_variables = d->s0.variables;
  v->s1.gradients = d->s1.gradients;
  v->s1.thermodynamic_forces = d->s1.forces;
  v->s1.material_properties = d->s1.properties;
  v->s1.internal_state_variables = d->s1.isvs;
  v->s1.dissipated_energy = &d->s1.lost;
  v->s1.external_state_variables = d->s1.variables;
  return status(1, "");
}
mgis_status mgis_bv_integrate(int *const result, mgis_bv_BehaviourDataView *const v,
                              const mgis_bv_Behaviour *const b) {
  *result = b->integrate(v);
  return status(*result == 0 || *result == 1, "behaviour integration failed");
}
