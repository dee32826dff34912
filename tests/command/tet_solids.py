# SPDX-License-Identifier: Apache-2.0
"""Small solids of tets for the judge: coarse ones by hand, each tet cut into eight as often as wanted."""

import itertools

import numpy as np

from program import tet_box

CUTS = [(0, 4, 5, 6), (1, 4, 7, 8), (2, 5, 7, 9), (3, 6, 8, 9), (4, 5, 6, 8), (4, 5, 7, 8), (5, 6, 8, 9), (5, 7, 8, 9)]


def refined(vertices, tets, times):
    """Cuts every tet at the middles of its edges."""
    for _ in range(times):
        edges = np.sort(tets[:, list(itertools.combinations(range(4), 2))].reshape(-1, 2), axis=1)
        pairs, number = np.unique(edges, axis=0, return_inverse=True)
        corners = np.concatenate([tets, len(vertices) + number.reshape(-1, 6)], axis=1)
        vertices = np.concatenate([vertices, vertices[pairs].mean(axis=1)])
        tets = corners[:, CUTS].reshape(-1, 4)
    return vertices, tets


def prism(outline, height, triangles):
    """A prism over triangles of an outline in the plane, each cut into three tets in the order of its vertices."""
    count = len(outline)
    vertices = np.array([(x, y, z) for z in (0, height) for x, y in outline], float)
    tets = [(a, b, c, c + count) for a, b, c in map(sorted, triangles)]
    tets += [(a, b, b + count, c + count) for a, b, c in map(sorted, triangles)]
    tets += [(a, a + count, b + count, c + count) for a, b, c in map(sorted, triangles)]
    return vertices, np.array(tets)


def wedge(degrees, times=3):
    """A prism over a right-angled triangle with this angle."""
    return refined(*prism([(0, 0), (2, 0), (2, 2 * np.tan(np.radians(degrees)))], 1.5, [(0, 1, 2)]), times)


def angle_iron(times=3):
    """An L-shaped solid."""
    outline = [(x, y) for y in range(3) for x in range(3)]
    squares = [(0, 1, 3, 4), (1, 2, 4, 5), (3, 4, 6, 7)]
    return refined(*prism(outline, 1, [t for a, b, c, d in squares for t in ((a, b, d), (a, c, d))]), times)


def ball(cells):
    """The unit ball: a cube of so many cells a side, its points moved along their directions."""
    vertices, tets = tet_box((cells,) * 3, (2.0, 2.0, 2.0))
    vertices = vertices - 1
    length = np.linalg.norm(vertices, axis=1)
    vertices[length > 0] *= (np.abs(vertices).max(axis=1)[length > 0] / length[length > 0])[:, None]
    return vertices, tets


def square_pyramid(times=3):
    vertices = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (0, 0, 1.4)])
    return refined(vertices, np.array([(0, 1, 2, 4), (0, 2, 3, 4)]), times)


def triangular_prism(times=3):
    return refined(*prism([(0, 0), (2, 0), (1, 1.7)], 2, [(0, 1, 2)]), times)
