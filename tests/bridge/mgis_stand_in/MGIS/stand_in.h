// SPDX-License-Identifier: LGPL-2.1-or-later

/*
 * A STAND-IN for MGIS' bindings to C, for machines without MGIS: no code of MGIS, but functions of
 * the same names and arguments as far as plugin/bridge/mgis_law.c calls them (read in MGIS' headers
 * bindings/c/include/MGIS, versions 2 and 3), over four behaviours of our own (mgis_stand_in.c).
 * It shows that the law compiles and what it does with what it is given; not that MGIS gives that.
 */
#ifndef MGIS_STAND_IN_H
#define MGIS_STAND_IN_H

#include <stddef.h>

typedef double mgis_real;
typedef size_t mgis_size_type;

typedef enum { MGIS_SUCCESS, MGIS_FAILURE } mgis_exit_flag;
typedef struct {
  mgis_exit_flag exit_status;
  const char *msg;
} mgis_status;

typedef enum {
  MGIS_BV_GENERALBEHAVIOUR = 0,
  MGIS_BV_STANDARDSTRAINBASEDBEHAVIOUR = 1,
  MGIS_BV_STANDARDFINITESTRAINBEHAVIOUR = 2,
  MGIS_BV_COHESIVEZONEMODEL = 3
} mgis_bv_BehaviourType;
typedef enum {
  MGIS_BV_SCALAR = 0,
  MGIS_BV_VECTOR = 1,
  MGIS_BV_STENSOR = 2,
  MGIS_BV_TENSOR = 3
} mgis_bv_VariableType;

typedef struct mgis_bv_Behaviour mgis_bv_Behaviour;
typedef struct mgis_bv_BehaviourData mgis_bv_BehaviourData;
typedef struct mgis_bv_State mgis_bv_State;

/* In the order of MGIS; what the law does not touch is left out. */
typedef struct {
  const mgis_real *gradients, *thermodynamic_forces, *mass_density, *material_properties,
      *internal_state_variables, *stored_energy, *dissipated_energy, *external_state_variables;
} mgis_bv_InitialStateView;
typedef struct {
  const mgis_real *gradients;
  mgis_real *thermodynamic_forces;
  const mgis_real *mass_density, *material_properties;
  mgis_real *internal_state_variables, *stored_energy, *dissipated_energy;
  const mgis_real *external_state_variables;
} mgis_bv_StateView;
typedef struct {
  char *error_message;
  mgis_real dt;
  mgis_real *K, *rdt, *speed_of_sound;
  mgis_bv_InitialStateView s0;
  mgis_bv_StateView s1;
} mgis_bv_BehaviourDataView;

mgis_status mgis_bv_load_behaviour(mgis_bv_Behaviour **, const char *const, const char *const,
                                   const char *const);
mgis_status mgis_bv_free_behaviour(mgis_bv_Behaviour **);
mgis_status mgis_bv_behaviour_get_behaviour_type(mgis_bv_BehaviourType *const,
                                                 const mgis_bv_Behaviour *const);
mgis_status mgis_bv_behaviour_get_gradients_size(mgis_size_type *const,
                                                 const mgis_bv_Behaviour *const);
mgis_status mgis_bv_behaviour_get_thermodynamic_forces_size(mgis_size_type *const,
                                                            const mgis_bv_Behaviour *const);
mgis_status mgis_bv_behaviour_get_tangent_operator_array_size(mgis_size_type *const,
                                                              const mgis_bv_Behaviour *const);
mgis_status mgis_bv_behaviour_get_number_of_material_properties(mgis_size_type *const,
                                                                const mgis_bv_Behaviour *const);
mgis_status mgis_bv_behaviour_get_material_property_name(const char **,
                                                         const mgis_bv_Behaviour *const,
                                                         const mgis_size_type);
mgis_status mgis_bv_behaviour_get_material_property_type(mgis_bv_VariableType *const,
                                                         const mgis_bv_Behaviour *const,
                                                         const mgis_size_type);
mgis_status mgis_bv_behaviour_get_internal_state_variables_size(mgis_size_type *const,
                                                                const mgis_bv_Behaviour *const);
mgis_status
mgis_bv_behaviour_get_number_of_external_state_variables(mgis_size_type *const,
                                                         const mgis_bv_Behaviour *const);
mgis_status mgis_bv_behaviour_get_external_state_variable_name(const char **,
                                                               const mgis_bv_Behaviour *const,
                                                               const mgis_size_type);
mgis_status mgis_bv_behaviour_has_lower_physical_bound(int *const, const mgis_bv_Behaviour *const,
                                                       const char *const);
mgis_status mgis_bv_behaviour_has_upper_physical_bound(int *const, const mgis_bv_Behaviour *const,
                                                       const char *const);
mgis_status mgis_bv_behaviour_get_lower_physical_bound(long double *const,
                                                       const mgis_bv_Behaviour *const,
                                                       const char *const);
mgis_status mgis_bv_behaviour_get_upper_physical_bound(long double *const,
                                                       const mgis_bv_Behaviour *const,
                                                       const char *const);
mgis_status mgis_bv_behaviour_computes_dissipated_energy(int *const,
                                                         const mgis_bv_Behaviour *const);

mgis_status mgis_bv_allocate_behaviour_data(mgis_bv_BehaviourData **,
                                            const mgis_bv_Behaviour *const);
mgis_status mgis_bv_behaviour_data_get_state_0(mgis_bv_State **, mgis_bv_BehaviourData *const);
mgis_status mgis_bv_behaviour_data_get_state_1(mgis_bv_State **, mgis_bv_BehaviourData *const);
mgis_status mgis_bv_behaviour_data_set_time_increment(mgis_bv_BehaviourData *const,
                                                      const mgis_real);
mgis_status mgis_bv_free_behaviour_data(mgis_bv_BehaviourData **);

mgis_status mgis_bv_state_get_gradient_by_offset(mgis_real **, mgis_bv_State *const,
                                                 const mgis_size_type);
mgis_status mgis_bv_state_get_thermodynamic_force_by_offset(mgis_real **, mgis_bv_State *const,
                                                            const mgis_size_type);
mgis_status mgis_bv_state_set_material_property_by_offset(mgis_bv_State *const,
                                                          const mgis_size_type, const mgis_real);
mgis_status mgis_bv_state_get_internal_state_variables(mgis_real **, mgis_bv_State *const);
mgis_status mgis_bv_state_set_scalar_external_state_variable_by_name(mgis_bv_State *const,
                                                                     const char *const,
                                                                     const mgis_real);

mgis_status mgis_bv_make_behaviour_data_view(mgis_bv_BehaviourDataView *const,
                                             mgis_bv_BehaviourData *const);
mgis_status mgis_bv_integrate(int *const, mgis_bv_BehaviourDataView *const,
                              const mgis_bv_Behaviour *const);

#endif
