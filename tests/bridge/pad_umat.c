// SPDX-License-Identifier: LGPL-2.1-or-later

/*
 * A UMAT in C with Fortran's calling convention, for NTENS = 3: an interface that is elastic in
 * compression and bears no tension, with Coulomb friction, PROPS = K_n, K_t [Pa], f. STATEV are the
 * two slips. It sees to its arguments, as a UMAT in Fortran might, and asks for a shorter increment
 * where the strain is not small, PNEWDT.
 */
#include <math.h>
#include <string.h>

void umat_(double *stress, double *statev, double *ddsdde, double *sse, double *spd, double *scd,
           double *rpl, double *ddsddt, double *drplde, double *drpldt, double *stran,
           double *dstran, double *time, double *dtime, double *temp, double *dtemp, double *predef,
           double *dpred, char *cmname, int *ndi, int *nshr, int *ntens, int *nstatv, double *props,
           int *nprops, double *coords, double *drot, double *pnewdt, double *celent,
           double *dfgrd0, double *dfgrd1, int *noel, int *npt, int *layer, int *kspt, int *kstep,
           int *kinc) {
  const double K[3] = {props[0], props[1], props[1]}, f = props[2];
  double trial[2], size, limit;
  int i, j;
  (void)sse, (void)scd, (void)rpl, (void)ddsddt, (void)drplde, (void)drpldt, (void)time;
  (void)dtime, (void)temp, (void)dtemp, (void)predef, (void)dpred, (void)coords, (void)drot;
  (void)celent, (void)dfgrd0, (void)dfgrd1, (void)noel, (void)npt, (void)layer, (void)kspt;
  if (*ndi != 1 || *nshr != 2 || *ntens != 3 || *nstatv != 2 || *nprops != 3 || *kstep != 1 ||
      strncmp(cmname, "PAD ", 4) != 0 || cmname[79] != ' ' || (*kinc != 1 && *kinc != 2) ||
      stran[0] + dstran[0] > 1e3) {
    *pnewdt = 0.5;
    return;
  }
  memset(ddsdde, 0, 9 * sizeof(double));
  memset(stress, 0, 3 * sizeof(double));
  if (stran[0] + dstran[0] >= 0.) {
    for (i = 0; i < 2; ++i)
      statev[i] = stran[1 + i] + dstran[1 + i];
    return;
  }
  stress[0] = K[0] * (stran[0] + dstran[0]);
  ddsdde[0] = K[0];
  limit = f * -stress[0];
  for (i = 0; i < 2; ++i)
    trial[i] = K[1 + i] * (stran[1 + i] + dstran[1 + i] - statev[i]);
  size = hypot(trial[0], trial[1]);
  for (i = 0; i < 2; ++i) {
    const double direction = size > 0. ? trial[i] / size : 0.;
    stress[1 + i] = size > limit ? limit * direction : trial[i];
    ddsdde[(1 + i) + 3 * (1 + i)] = K[1 + i];
    if (size <= limit)
      continue;
    ddsdde[(1 + i) + 3 * 0] = -f * K[0] * direction; /* row of the shear, column of the normal */
    for (j = 0; j < 2; ++j)
      ddsdde[(1 + i) + 3 * (1 + j)] =
          K[1] * limit / size * ((i == j) - direction * trial[j] / size);
    statev[i] += (trial[i] - stress[1 + i]) / K[1 + i];
  }
  if (size > limit)
    *spd += limit * (size - limit) / K[1];
}
