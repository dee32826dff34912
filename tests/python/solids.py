# SPDX-License-Identifier: Apache-2.0
"""Small solids for the tests of the Python package, made with NumPy alone."""

import itertools

import numpy as np


def box(size=(2.0, 1.0, 1.5)):
    """(8, 3) vertices and (12, 3) triangles, outward."""
    vertices = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]) * np.array(size)
    triangles = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]
    return vertices, np.array(triangles)


def ball(n=12):
    """A cube of n squares a side, its surface moved to the unit sphere."""
    step = np.linspace(-1, 1, n + 1)
    a, b = np.meshgrid(step, step, indexing="ij")
    vertices, triangles = [], []
    for axis, side in itertools.product(range(3), (-1, 1)):
        points = np.empty((n + 1, n + 1, 3))
        points[..., axis], points[..., (axis + 1) % 3], points[..., (axis + 2) % 3] = side, a, b
        index = np.arange((n + 1) ** 2).reshape(n + 1, n + 1) + len(vertices) * (n + 1) ** 2
        p, q, r, s = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
        two = np.concatenate([np.stack([p, q, r], -1).reshape(-1, 3), np.stack([p, r, s], -1).reshape(-1, 3)])
        triangles.append(two if side > 0 else two[:, ::-1])
        vertices.append(points.reshape(-1, 3))
    points = np.concatenate(vertices)
    return points / np.linalg.norm(points, axis=1)[:, None], np.concatenate(triangles)


def cube_of_tets(n=4, size=1.0):
    """n^3 cubes of six tets each: ((n+1)^3, 3) points and (6 n^3, 4) cells."""
    steps = np.array([1, n + 1, (n + 1) ** 2])
    z, y, x = np.meshgrid(*[np.arange(n + 1)] * 3, indexing="ij")
    points = np.stack([x, y, z], -1).reshape(-1, 3) * (size / n)
    first = (np.arange(n)[:, None, None] * steps[2] + np.arange(n)[None, :, None] * steps[1] + np.arange(n)[None, None, :]).ravel()
    paths = [np.cumsum([0, *steps[list(order)]]) for order in itertools.permutations(range(3))]
    return points, (first[:, None, None] + np.array(paths)[None]).reshape(-1, 4)


def ball_of_tets(n=3):
    """cube_of_tets moved onto the unit ball: a point keeps its direction and the share of its way out."""
    points, cells = cube_of_tets(n, 2.0)
    points = points - 1
    length = np.linalg.norm(points, axis=1)
    points[length > 0] *= (np.abs(points).max(axis=1)[length > 0] / length[length > 0])[:, None]
    return points, cells


def stl_bytes(vertices, triangles):
    records = np.zeros(len(triangles), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]))
    records["corners"] = vertices[triangles]
    return bytes(80) + np.uint32(len(records)).tobytes() + records.tobytes()


def medit_text(points, cells):
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
    lines += ["%.17g %.17g %.17g 0" % tuple(point) for point in points]
    lines += ["Tetrahedra", str(len(cells))] + ["%d %d %d %d 1" % tuple(cell + 1) for cell in cells]
    return "\n".join([*lines, "End", ""])
