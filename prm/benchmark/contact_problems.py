# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact problems of rigid bodies in FCLIB's format: towers, walls, heaps, granular layers, boxes.

    /usr/bin/python3 prm/benchmark/contact_problems.py FOLDER

One step of time of bodies that touch: M v = H r + f, u = H^T v + w, f the momentum of the bodies as they
would move without contacts, w = 0. Components of a contact are normal, tangential (two in space). Each
problem is written twice, NAME_global.hdf5 as it is, and NAME.hdf5 condensed, W = H^T M^-1 H, q = H^T M^-1 f.
Forces of rigid bodies on more contacts than they need are not unique: W is singular. NAME is the kind
and its size; where it says "rest", nothing pushes or shakes the bodies.

Needs Debian's python3-h5py and python3-scipy.
"""
import argparse
import os

import h5py
import numpy as np
import scipy.sparse as sparse

GRAVITY, STEP = 9.81, 0.01  # m/s^2, s
DENSITY, FRICTION = 2000.0, 0.4
GROUND = -1


class Scene:
    """Bodies, each with its mass, moments of inertia about its own axes, place and velocity, and the points
    at which they touch."""

    def __init__(self, dimension, seed=1):
        self.dimension = dimension
        self.random = np.random.default_rng(seed)
        self.masses, self.inertias, self.places, self.velocities = [], [], [], []
        self.contacts = []  # (first, second, point, normal from the first into the second)

    def add_box(self, place, sizes):
        mass = DENSITY * np.prod(sizes)
        squares = np.square(sizes)
        return self.add(place, mass, mass / 12 * (squares.sum() - squares))

    def add_sphere(self, place, radius):
        mass = DENSITY * 4 / 3 * np.pi * radius**3
        return self.add(place, mass, np.full(3, 0.4 * mass * radius**2))

    def add_disc(self, place, radius):
        mass = DENSITY * np.pi * radius**2
        return self.add(place, mass, np.full(1, 0.5 * mass * radius**2))

    def add(self, place, mass, inertia):
        self.places.append(np.array(place, dtype=float))
        self.masses.append(mass)
        self.inertias.append(inertia)
        return len(self.places) - 1

    def touch(self, first, second, point, normal):
        self.contacts.append((first, second, np.asarray(point, float), np.asarray(normal, float)))

    def touch_on_face(self, first, second, low, high, level):
        """A level rectangle of contact, at its four corners."""
        for x in (low[0], high[0]):
            for y in (low[1], high[1]):
                self.touch(first, second, (x, y, level), (0, 0, 1))

    def touch_where_near(self, radius, slack):
        """Of spheres or discs of one radius."""
        places = np.array(self.places)
        for i in range(len(places)):
            apart = places[i + 1:] - places[i]
            distance = np.linalg.norm(apart, axis=1)
            for k in np.nonzero(distance <= 2 * radius * (1 + slack))[0]:
                normal = apart[k] / distance[k]
                self.touch(i, i + 1 + int(k), places[i] + radius * normal, normal)

    def touch_walls(self, radius, slack, walls):
        """@param walls (direction, sign, coordinate): the body is on the side of that sign."""
        for i, place in enumerate(self.places):
            for direction, sign, coordinate in walls:
                if sign * (place[direction] - coordinate) <= radius * (1 + slack):
                    normal = np.zeros(self.dimension)
                    normal[direction] = sign
                    self.touch(GROUND, i, place - radius * normal, normal)

    def move(self, acceleration, scatter):
        """Velocities after a step of gravity and of a sideways acceleration, both in parts of gravity,
        and by chance."""
        down = np.zeros(self.dimension)
        down[-1], down[0] = -1.0, acceleration
        for inertia in self.inertias:
            turning = scatter * self.random.standard_normal(len(inertia))
            chance = scatter * self.random.standard_normal(self.dimension)
            self.velocities.append(np.concatenate([down + chance, turning]) * GRAVITY * STEP)

    def problem(self):
        """(M, H, f): unknowns of a body are its velocity and its rotations."""
        n = 6 if self.dimension == 3 else 3
        M = sparse.diags(np.concatenate([np.concatenate([np.full(self.dimension, mass), inertia])
                                         for mass, inertia in zip(self.masses, self.inertias)])).tocsc()
        rows, columns, values = [], [], []
        for c, (first, second, point, normal) in enumerate(self.contacts):
            frame = frame_of(normal)
            for body, sign in ((first, -1.0), (second, 1.0)):
                if body == GROUND:
                    continue
                arm = point - self.places[body]
                for k, axis in enumerate(frame):
                    turning = np.cross(arm, axis) if self.dimension == 3 else [cross_in_plane(arm, axis)]
                    block = sign * np.concatenate([axis, turning])
                    rows += range(n * body, n * (body + 1))
                    columns += [self.dimension * c + k] * n
                    values += block.tolist()
        shape = (n * len(self.masses), self.dimension * len(self.contacts))
        H = sparse.csc_matrix((values, (rows, columns)), shape=shape)
        H.eliminate_zeros()
        return M, H, M @ np.concatenate(self.velocities)


def frame_of(normal):
    if len(normal) == 2:
        return [normal, np.array([normal[1], -normal[0]])]
    axis = np.eye(3)[np.argmin(np.abs(normal))]
    first = np.cross(normal, axis)
    first /= np.linalg.norm(first)
    return [normal, first, np.cross(normal, first)]


def cross_in_plane(a, b):
    return a[0] * b[1] - a[1] * b[0]


def tower(n_blocks, push=0.1, scatter=0.01):
    """Blocks one upon the other, four contacts each, pushed sideways a little."""
    scene = Scene(3)
    for i in range(n_blocks):
        block = scene.add_box((0, 0, 0.2 * i + 0.1), (1.0, 1.0, 0.2))
        scene.touch_on_face(block - 1, block, (-0.5, -0.5), (0.5, 0.5), 0.2 * i)
    scene.move(push, scatter)
    return scene


def crossed_tower(n_levels, push=0.15, scatter=0.02):
    """Levels of two bars each, across those beneath."""
    scene = Scene(3)
    length, width, height, half = 1.0, 0.2, 0.1, 0.35
    for level in range(n_levels):
        along = level % 2
        for side in (-half, half):
            place, sizes = [0, 0, height * (level + 0.5)], [width, width, height]
            place[1 - along], sizes[along] = side, length
            bar = scene.add_box(place, sizes)
            beneath = range(2 * level - 2, 2 * level) if level > 0 else (GROUND, GROUND)
            for crossing, other in zip(beneath, (-half, half)):
                centre = np.array([0.0, 0.0])
                centre[1 - along], centre[along] = side, other
                scene.touch_on_face(crossing, bar, centre - width / 2, centre + width / 2, height * level)
    scene.move(push, scatter)
    return scene


def wall(n_rows, n_bricks, push=0.3, scatter=0.1):
    """Bricks on two others each, struck so that some slide."""
    scene = Scene(3)
    length, depth, height = 0.4, 0.2, 0.15
    rows = []
    for row in range(n_rows):
        begin = 0.5 * length * (row % 2)
        rows.append([])
        for k in range(n_bricks - row % 2):
            left = begin + k * length
            brick = scene.add_box((left + length / 2, 0, height * (row + 0.5)), (length, depth, height))
            rows[-1].append((brick, left))
            below = rows[-2] if row > 0 else [(GROUND, left)]
            for other, other_left in below:
                low, high = max(left, other_left), min(left, other_left) + length
                if high > low + 1e-9:
                    scene.touch_on_face(other, brick, (low, -depth / 2), (high, depth / 2), height * row)
    scene.move(push, scatter)
    return scene


def heap(n_layers, push=0.1, scatter=0.05):
    """Cannon balls: a layer of k x k upon one of (k + 1) x (k + 1); balls of a layer touch, too."""
    scene = Scene(3)
    radius = 0.5
    for layer in range(n_layers):
        k = n_layers - layer
        for i in range(k):
            for j in range(k):
                scene.add_sphere((i + 0.5 * layer, j + 0.5 * layer, radius + layer / np.sqrt(2)), radius)
    scene.touch_where_near(radius, 1e-9)
    scene.touch_walls(radius, 1e-9, [(2, 1.0, 0.0)])
    scene.move(push, scatter)
    return scene


def plane_layer(n_columns, n_rows, push=0.3, scatter=0.3):
    """Discs in the plane, in a hexagonal packing of which every sixth is missing, dragged over the ground."""
    scene = Scene(2)
    radius = 0.5
    for row in range(n_rows):
        for column in range(n_columns):
            if row == 0 or scene.random.random() > 1 / 6:
                place = (column + 0.5 * (row % 2), radius + row * np.sqrt(0.75))
                scene.add_disc(place, radius)
    scene.touch_where_near(radius, 1e-9)
    scene.touch_walls(radius, 1e-9, [(1, 1.0, 0.0)])
    scene.move(push, scatter)
    return scene


def spread(random, n, sides, diameter):
    """Points in a box that have pushed each other about until they lie apart, nearly."""
    sides = np.asarray(sides)
    points = random.random((n, len(sides))) * (sides - diameter) + diameter / 2
    for _ in range(600):
        apart = points[:, None, :] - points[None, :, :]
        distance = np.linalg.norm(apart, axis=2) + 1e9 * np.eye(n)
        overlap = np.maximum(0.0, diameter - distance)
        points += 0.3 * ((overlap / distance)[:, :, None] * apart).sum(axis=1)
        points = np.clip(points, diameter / 2, sides - diameter / 2)
    return points


def granular_layer(n_spheres, push=0.2, scatter=0.5):
    """A loose layer of spheres, three or so deep, that shakes on the ground."""
    scene = Scene(3)
    side = np.sqrt(n_spheres / 3.0) * 1.02
    for point in spread(scene.random, n_spheres, (side, side, 2.7), 1.0):
        scene.add_sphere(point, 0.5)
    scene.touch_where_near(0.5, 0.01)
    scene.touch_walls(0.5, 0.01, [(2, 1.0, 0.0)])
    scene.move(push, scatter)
    return scene


def box(n_spheres, push=0.5, scatter=1.0):
    """Spheres close together in a box, moving by chance."""
    scene = Scene(3)
    side = (n_spheres / 1.05)**(1 / 3)
    for point in spread(scene.random, n_spheres, (side, side, side), 1.0):
        scene.add_sphere(point, 0.5)
    scene.touch_where_near(0.5, 0.01)
    scene.touch_walls(0.5, 0.01, [(d, 1.0, 0.0) for d in range(3)] + [(d, -1.0, side) for d in range(3)])
    scene.move(push, scatter)
    return scene


# With 0, 0 at the end: at rest, under their weight alone.
PROBLEMS = {
    "tower_4": (tower, 4), "tower_16": (tower, 16), "tower_60": (tower, 60), "tower_142": (tower, 142),
    "tower_rest_16": (tower, 16, 0, 0), "tower_rest_142": (tower, 142, 0, 0),
    "crossed_3": (crossed_tower, 3), "crossed_10": (crossed_tower, 10), "crossed_30": (crossed_tower, 30),
    "crossed_rest_30": (crossed_tower, 30, 0, 0),
    "wall_3": (wall, 3, 3), "wall_6": (wall, 6, 6), "wall_10": (wall, 10, 12),
    "wall_rest_10": (wall, 10, 12, 0, 0),
    "heap_2": (heap, 2), "heap_3": (heap, 3), "heap_5": (heap, 5), "heap_8": (heap, 8),
    "heap_rest_8": (heap, 8, 0, 0),
    "plane_layer_5": (plane_layer, 5, 2), "plane_layer_20": (plane_layer, 20, 5),
    "plane_layer_40": (plane_layer, 40, 10), "plane_layer_rest_40": (plane_layer, 40, 10, 0, 0),
    "layer_20": (granular_layer, 20), "layer_100": (granular_layer, 100),
    "layer_300": (granular_layer, 300), "layer_rest_300": (granular_layer, 300, 0, 0),
    "box_8": (box, 8), "box_60": (box, 60), "box_250": (box, 250)}


def write_matrix(group, name, matrix):
    matrix = matrix.tocsc()
    matrix.sort_indices()
    into = group.create_group(name)
    for key, value in (("m", matrix.shape[0]), ("n", matrix.shape[1]), ("nz", -1), ("nzmax", matrix.nnz),
                       ("p", matrix.indptr), ("i", matrix.indices)):
        into[key] = np.atleast_1d(np.asarray(value, dtype=np.int32))
    into["x"] = matrix.data


def write(path, kind, dimension, matrices, vectors):
    with h5py.File(path, "w") as file:
        group = file.create_group(kind)
        group["spacedim"] = np.array([dimension], dtype=np.int32)
        for name, matrix in matrices.items():
            write_matrix(group, name, matrix)
        for name, vector in vectors.items():
            group["vectors/" + name] = vector


def make(name):
    """(dimension, M, H, f, W, q, mu)"""
    function, *sizes = PROBLEMS[name]
    scene = function(*sizes)
    M, H, f = scene.problem()
    inverse = sparse.diags(1.0 / M.diagonal())
    W = (H.T @ inverse @ H).tocsc()
    W = ((W + W.T) / 2).tocsc()
    q = H.T @ (inverse @ f)
    return scene.dimension, M, H, f, W, q, np.full(len(scene.contacts), FRICTION)


def write_problem(name, folder):
    """In both forms. @return what there is to say of it"""
    dimension, M, H, f, W, q, mu = make(name)
    path = os.path.join(folder, name)
    write(path + ".hdf5", "fclib_local", dimension, {"W": W}, {"q": q, "mu": mu})
    write(path + "_global.hdf5", "fclib_global", dimension, {"M": M, "H": H},
          {"f": f, "w": np.zeros(len(q)), "mu": mu})
    return (f"{name}: {len(mu)} contacts in {dimension}D, {M.shape[0]} unknowns of bodies, "
            f"W {100 * W.nnz / len(q)**2:.3g} % full")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("folder")
    folder = parser.parse_args().folder
    os.makedirs(folder, exist_ok=True)
    for name in PROBLEMS:
        print(write_problem(name, folder))


if __name__ == "__main__":
    main()
