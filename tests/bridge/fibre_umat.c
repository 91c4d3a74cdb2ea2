// SPDX-License-Identifier: LGPL-2.1-or-later

/*
 * A UMAT in C with Fortran's calling convention, for NTENS = 1: perfect plasticity with thermal
 * expansion, PROPS = E, yield stress [Pa], alpha [1/K]. STATEV(1) is the plastic strain, STATEV(2)
 * the thermal strain since KINC = 1: it is the sum of what DTEMP adds.
 */
#include <math.h>

void my_umat(double *stress, double *statev, double *ddsdde, double *sse, double *spd, double *scd,
             double *rpl, double *ddsddt, double *drplde, double *drpldt, double *stran,
             double *dstran, double *time, double *dtime, double *temp, double *dtemp,
             double *predef, double *dpred, char *cmname, int *ndi, int *nshr, int *ntens,
             int *nstatv, double *props, int *nprops, double *coords, double *drot, double *pnewdt,
             double *celent, double *dfgrd0, double *dfgrd1, int *noel, int *npt, int *layer,
             int *kspt, int *kstep, int *kinc) {
  const double E = props[0], yield = props[1];
  const double thermal = statev[1] + props[2] * *dtemp;
  /* From the stress before, as a UMAT that is written in increments. */
  const double trial = *stress + E * (*dstran - props[2] * *dtemp);
  (void)scd, (void)rpl, (void)ddsddt, (void)drplde, (void)drpldt, (void)time, (void)dtime;
  (void)temp, (void)predef, (void)dpred, (void)cmname, (void)coords, (void)drot, (void)celent;
  (void)dfgrd0, (void)dfgrd1, (void)noel, (void)layer, (void)kspt, (void)kstep, (void)kinc;
  if (*ndi != 1 || *nshr != 0 || *ntens != 1 || *nstatv != 2 || *nprops != 3 || *npt < 1 ||
      *npt > 16) {
    *pnewdt = 0.5;
    return;
  }
  *stress = fabs(trial) > yield ? copysign(yield, trial) : trial;
  *ddsdde = fabs(trial) > yield ? 0. : E;
  if (fabs(trial) > yield) {
    statev[0] += (trial - *stress) / E;
    *spd += *stress * (trial - *stress) / E;
  }
  statev[1] = thermal;
  *sse = *stress * *stress / (2. * E);
  (void)stran;
}
