#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of Siconos (Debian's python3-siconos) on the bouncing bar of prm/verification/bouncing_bar.prm, for
`frictionbeam chart`: prints max_error, 'seconds' (matrices, model, time steps) and 'unknowns'.

  siconos_run.py CELL_LENGTH [THETA [STEP [MASS]]]

Moreau-Jean with an LCP for the impact law of Newton, e = 0; linear cells with the consistent mass matrix
(MASS = lumped: lumped), time step STEP times what a wave needs for a cell. THETA = 0.5, STEP = 0.7 and the
consistent mass are its best settings here, as they are ours. Its matrices are dense; its sparse ones, which Python
cannot pass but C++ can, took three times as long at 100 cells.
"""
import os
import sys
import time

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
import siconos.kernel as siconos

MODULUS, DENSITY, LENGTH, GRAVITY, HEIGHT, DURATION = 900.0, 1.0, 10.0, 10.0, 5.0, 32.0 / 3.0
SPEED = (MODULUS / DENSITY) ** 0.5


def exact(t):
    """The lower end by characteristics: prm/verification/bouncing_bar.prm."""
    period = 16.0 / 3.0
    t = t - np.floor(t / period) * period
    t = np.where(t > 8.0 / 3.0, period - t, t)
    k = np.floor(1.5 * (t - 1.0))
    s = t - 1.0 - k / 1.5
    free = -5.0 - 10.0 * (t - 1.0) - 5.0 * (t - 1.0) ** 2 + 20.0 * s + 10.0 * s**2 + (2.0 * k - 1.0) * 80.0 / 9.0
    return np.where(t < 1.0, -5.0 * t**2, np.where(t < 5.0 / 3.0, -5.0, free))


def run(cell, theta, ratio, lumped):
    n = round(LENGTH / cell)
    start = time.perf_counter()
    stiffness, mass = np.zeros((n + 1, n + 1)), np.zeros((n + 1, n + 1))
    for i in range(n):
        both = slice(i, i + 2)
        stiffness[both, both] += MODULUS / cell * np.array([[1.0, -1.0], [-1.0, 1.0]])
        mass[both, both] += DENSITY * cell * (np.eye(2) / 2.0 if lumped else np.array([[2.0, 1.0], [1.0, 2.0]]) / 6.0)
    n_steps = int(np.ceil(DURATION / (ratio * cell / SPEED)))
    step = DURATION / n_steps
    bar = siconos.LagrangianLinearTIDS(np.zeros(n + 1), np.zeros(n + 1), mass)
    bar.setKPtr(stiffness)
    bar.setFExtPtr(-GRAVITY * mass.sum(axis=1))
    lower_end = np.zeros((1, n + 1))
    lower_end[0, 0] = 1.0
    floor = siconos.Interaction(siconos.NewtonImpactNSL(0.0),
                                siconos.LagrangianLinearTIR(lower_end, np.array([HEIGHT])))
    model = siconos.NonSmoothDynamicalSystem(0.0, DURATION)
    model.insertDynamicalSystem(bar)
    model.link(floor, bar)
    stepping = siconos.TimeStepping(model, siconos.TimeDiscretisation(0.0, step), siconos.MoreauJeanOSI(theta),
                                    siconos.LCP())
    q = bar.q()
    low = np.zeros(n_steps + 1)
    for k in range(1, n_steps + 1):
        stepping.computeOneStep()
        low[k] = q[0]
        stepping.nextStep()
    seconds = time.perf_counter() - start
    error = np.abs(low - exact(step * np.arange(n_steps + 1))).max() / HEIGHT
    return error, seconds, n + 1


arguments = sys.argv[1].split(":") if len(sys.argv) == 2 else sys.argv[1:]
defaults = ["0.1", "0.5", "0.7", "consistent"]
arguments += defaults[len(arguments):]
error, seconds, unknowns = run(float(arguments[0]), float(arguments[1]), float(arguments[2]), arguments[3] == "lumped")
print("seconds =", seconds)
print("unknowns =", unknowns)
print("max_error =", error)
