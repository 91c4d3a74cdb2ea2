# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contact problem of a rack in condensed form, summed up by itself: u = W r + q, mu.

A model of its own for the racks of rack_family.prm, written from their description and not from the
program: straight Timoshenko beams of 12 x 12, one 6 x 6 block a node, the chain eliminated from its
start. W = H K^-1 H^T, q = H K^-1 f for weight and heating at once. Contact frame: N = +z, T1 = +x,
T2 = +y; r_N >= 0 carries the pipe.

Needs numpy.
"""
import numpy as np

DIAMETER, WALL = 0.3239, 0.0095  # m
E, NU, DENSITY, EXPANSION = 2e11, 0.3, 7850.0, 1.2e-5
CONTENTS, GRAVITY, HEATING = 100.0, 9.81, 100.0

X, Y, Z = np.eye(3)
FRAME = (2, 0, 1)  # N, T1, T2 as displacements of a node


class Layout:
    """Nodes one after the other along the route, and the nodes that lie on a rest."""

    def __init__(self):
        self.nodes = [np.zeros(3)]
        self.rests = []

    def lay(self, way, n_cells):
        begin = self.nodes[-1]
        self.nodes += [begin + (i + 1) / n_cells * way for i in range(n_cells)]

    def rest(self):
        self.rests.append(len(self.nodes) - 1)


def plant_span(layout, i):
    turn = 1.0 if (i // 10) % 2 == 0 else -1.0
    if i % 10 == 9:
        layout.lay(3 * turn * Y, 4)
        layout.lay(3 * X, 2)
        layout.rest()
        layout.lay(3 * X, 2)
        layout.lay(-3 * turn * Y, 4)
    elif i % 10 == 4:
        layout.lay(3 * X, 2)
        layout.lay(1.5 * turn * Z, 2)
        layout.lay(3 * X, 2)
    else:
        layout.lay(6 * X, 4)


def planar_span(layout, i):
    if i % 10 == 9:
        for way in (3 * Y, 6 * X, -3 * Y):
            layout.lay(way, 4)
    else:
        layout.lay(6 * X, 4)


def lay_out(kind, n):
    layout = Layout()
    for i in range(n - 1):
        (plant_span if kind == "plant" else planar_span)(layout, i)
        if i < n - 2:
            layout.rest()
    return layout


def bending(length, EI, shear_stiffness):
    """Deflection and rotation of either end in one plane, w' = psi without shear."""
    phi = 12 * EI / (shear_stiffness * length**2)
    L = length
    return EI / (L**3 * (1 + phi)) * np.array(
        [[12, 6 * L, -12, 6 * L],
         [6 * L, (4 + phi) * L * L, -6 * L, (2 - phi) * L * L],
         [-12, -6 * L, 12, -6 * L],
         [6 * L, (2 - phi) * L * L, -6 * L, (4 + phi) * L * L]])


def element(begin, end):
    """Stiffness and load of a cell in global axes: ux uy uz rx ry rz of either node."""
    inner = DIAMETER - 2 * WALL
    area = np.pi / 4 * (DIAMETER**2 - inner**2)
    inertia = np.pi / 64 * (DIAMETER**4 - inner**4)
    G = E / (2 * (1 + NU))
    shear = 2 * (1 + NU) / (4 + 3 * NU) * G * area
    length = np.linalg.norm(end - begin)
    along = (end - begin) / length
    across = np.cross(Z, along) if abs(along[2]) < 0.5 else np.cross(X, along)
    across /= np.linalg.norm(across)
    axes = np.array([along, across, np.cross(along, across)])

    K = np.zeros((12, 12))
    for dofs, stiffness in (((0, 6), E * area / length), ((3, 9), G * 2 * inertia / length)):
        K[np.ix_(dofs, dofs)] = stiffness * np.array([[1, -1], [-1, 1]])
    plane = bending(length, E * inertia, shear)
    K[np.ix_((1, 5, 7, 11), (1, 5, 7, 11))] = plane
    turned = np.diag([1, -1, 1, -1])  # a rotation about y deflects towards -z
    K[np.ix_((2, 4, 8, 10), (2, 4, 8, 10))] = turned @ plane @ turned

    weight = axes @ (-GRAVITY * (DENSITY * area + CONTENTS) * Z)  # per length, own axes
    load = np.zeros(12)
    load[0:3] = load[6:9] = length / 2 * weight
    moment = length**2 / 12
    load[5], load[11] = moment * weight[1], -moment * weight[1]
    load[4], load[10] = -moment * weight[2], moment * weight[2]
    thermal = E * area * EXPANSION * HEATING
    load[0] -= thermal
    load[6] += thermal

    T = np.kron(np.eye(4), axes)
    return T.T @ K @ T, T.T @ load


def assemble(nodes):
    """Diagonal blocks, blocks above them, loads, of all nodes but the anchored ends."""
    n = len(nodes)
    diagonal, upper, load = np.zeros((n, 6, 6)), np.zeros((n, 6, 6)), np.zeros((n, 6))
    for i in range(n - 1):
        K, f = element(nodes[i], nodes[i + 1])
        diagonal[i] += K[:6, :6]
        diagonal[i + 1] += K[6:, 6:]
        upper[i] = K[:6, 6:]
        load[i] += f[:6]
        load[i + 1] += f[6:]
    return diagonal[1:-1], upper[1:-1], load[1:-1]


def solve_chain(diagonal, upper, right_hand_side):
    """Block elimination from the start; the right-hand side holds many columns and is used up."""
    n = len(diagonal)
    pivot = [diagonal[0]]
    x = right_hand_side
    for i in range(1, n):
        step = np.linalg.solve(pivot[-1], upper[i - 1]).T
        pivot.append(diagonal[i] - step @ upper[i - 1])
        x[i] -= step @ x[i - 1]
    x[n - 1] = np.linalg.solve(pivot[n - 1], x[n - 1])
    for i in range(n - 2, -1, -1):
        x[i] = np.linalg.solve(pivot[i], x[i] - upper[i] @ x[i + 1])
    return x


class Rack:
    """A rack of one of the two families, without guides."""

    def __init__(self, kind, n):
        layout = lay_out(kind, n)
        self.diagonal, self.upper, self.load = assemble(layout.nodes)
        self.rows = [(node - 1, axis) for node in layout.rests for axis in FRAME]
        self.n_contacts = len(layout.rests)

    def condensed(self):
        """W and q."""
        m = len(self.rows)
        columns = np.zeros((len(self.diagonal), 6, m + 1))
        columns[:, :, m] = self.load
        for k, (node, axis) in enumerate(self.rows):
            columns[node, axis, k] = 1.0
        x = solve_chain(self.diagonal, self.upper, columns)
        answer = np.array([x[node, axis] for node, axis in self.rows])
        W = answer[:, :m]
        return (W + W.T) / 2, answer[:, m].copy()

    def motion(self, r):
        """u of the rests under loads and forces together: W r + q cancels most of its digits."""
        force = self.load.copy()[:, :, None]
        for value, (node, axis) in zip(r, self.rows):
            force[node, axis, 0] += value
        x = solve_chain(self.diagonal, self.upper, force)
        return np.array([x[node, axis, 0] for node, axis in self.rows])

    def stiffness(self):
        """Of the line at each rest, the mean over its three directions: a force per motion."""
        own = np.array([self.diagonal[node][axis, axis] for node, axis in self.rows])
        return np.repeat(own.reshape(-1, 3).mean(axis=1), 3)
