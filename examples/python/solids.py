# SPDX-License-Identifier: Apache-2.0
"""Solids for the examples, made with NumPy alone."""

import itertools

import numpy as np


def extrusion(outline, height):
    """Vertices and triangles of a plate: a convex outline, (n, 2), anticlockwise, extruded along z."""
    n = len(outline)
    vertices = np.concatenate([np.c_[outline, np.zeros(n)], np.c_[outline, np.full(n, height)]])
    fan = np.array([(0, i, i + 1) for i in range(1, n - 1)])
    i, j = np.arange(n), (np.arange(n) + 1) % n
    sides = np.concatenate([np.stack([i, j, j + n], 1), np.stack([i, j + n, i + n], 1)])
    return vertices, np.concatenate([fan[:, ::-1], fan + n, sides])


def cylinder(radius=1.0, height=2.0, segments=64):
    """Vertices and triangles of a cylinder about z."""
    angle = 2 * np.pi * np.arange(segments) / segments
    return extrusion(radius * np.c_[np.cos(angle), np.sin(angle)], height)


def cube_of_tets(n=8, size=1.0):
    """n^3 cubes of six tets each: ((n+1)^3, 3) points and (6 n^3, 4) cells."""
    steps = np.array([1, n + 1, (n + 1) ** 2])
    z, y, x = np.meshgrid(*[np.arange(n + 1)] * 3, indexing="ij")
    points = np.stack([x, y, z], -1).reshape(-1, 3) * (size / n)
    first = (np.arange(n)[:, None, None] * steps[2] + np.arange(n)[None, :, None] * steps[1] + np.arange(n)[None, None, :]).ravel()
    paths = [np.cumsum([0, *steps[list(order)]]) for order in itertools.permutations(range(3))]
    return points, (first[:, None, None] + np.array(paths)[None]).reshape(-1, 4)


def cylinder_of_tets(n=10, radius=1.0, height=2.0):
    """A cylinder of tets: a cube of them, whose squares across z are moved to circles."""
    points, cells = cube_of_tets(n, 2.0)
    x, y = points[:, 0] - 1, points[:, 1] - 1
    largest, length = np.maximum(abs(x), abs(y)), np.hypot(x, y)
    scale = np.divide(largest, length, out=np.ones_like(length), where=length > 0)
    return np.c_[radius * scale * x, radius * scale * y, height / 2 * points[:, 2]], cells
