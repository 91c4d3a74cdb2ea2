// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace frictionbeam {

/// What stands above the entries that --print-parameters lists.
inline constexpr char parameter_notes[] =
    R"(# All entries of a parameter file, with their defaults. A file holds any number of parts
# '<Kind> <name>': here stands one of each kind, called 'name'. Steps are taken in the
# order of the file. Units are SI unless an entry says otherwise; angles are in degrees.
# Entries of a support's law stand in the support: those of 'coulomb' are shown.
# Files may be included: include <file>. In 'Quantities', entries have names of your own:
#   set <name> = what at where, step NAME, time T; scale F; unit U; reference R; source TEXT
# what: ux uy uz rx ry rz [m, rad] and vx vy vz [m/s] wx wy wz [rad/s] at a point;
# N Vy Vz Mx My Mz [N, N m] of the pipe at a point, local axes, N > 0 in tension ('before P' or
# 'after P' where they jump, 'pipe NAME' at a branch), N_mean the mean of N before and after;
# fx fy fz mx my mz [N, N m] at a support, spring or point: the force of what holds the pipe there
# on the pipe; fn ft1 ft2 [N] gap slip1 slip2 [m] work [J] at a friction support (name.1, name.2,
# ... of a repeated one), wear [J], the integral of fn |slip rate|, and impulse [N s], of fn,
# impacts included (a guide, line stop or stop that is a pair, name.plus and name.minus, has fx to
# mz, work and wear of both, the others of either); sum_normal sum_friction [N] n_stick n_slip
# n_open of all friction supports or of one part; slip_length [m] of the zone of supports that slip
# and begins at the lowest x;
# frequency N [Hz] of mode N; of a stress code, flexibility sif_in sif_out at a point,
# SL SE [Pa] at a point, utilization; max_error [m, or relative] in scenes with an exact solution.
# |what| is its absolute value.
# Without a step, the last one is meant; without a time, the end of the step. Over an interval:
#   set <name> = max what at where, from T1, to T2        or min, mean, integral, change, rate
#   set <name> = time_of slip at SUPPORT, from T1         or stick, open, closed
)";

} // namespace frictionbeam
