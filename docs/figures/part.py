# SPDX-License-Identifier: Apache-2.0
"""The triangles of a part: normals, sharp edges, points spread over it, and what a plane does to it."""

import numpy as np

# Between faces that meet at a larger angle the edge is drawn; facets of curved faces differ by less.
SHARP_ANGLE_DEG = 20


def normals_of(corners):
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)


def sharp_edges(corners):
    """The end points of the edges between faces at a large angle, an array of shape (edges, 2, 3)."""
    points, index = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    triangles = index.reshape(-1, 3)
    edges = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    face = np.repeat(np.arange(len(triangles)), 3)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    edges, face = edges[order], face[order]
    pair = np.flatnonzero((edges[1:] == edges[:-1]).all(axis=1))
    normals = normals_of(corners)
    cosine = np.einsum("ij,ij->i", normals[face[pair]], normals[face[pair + 1]])
    return points[edges[pair[cosine < np.cos(np.radians(SHARP_ANGLE_DEG))]]]


def spread_points(corners, spacing, seed=1):
    """Points on the surface no closer to each other than `spacing`, and the normals there."""
    doubled_areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(doubled_areas, axis=1) / 2
    random = np.random.default_rng(seed)
    count = int(12 * areas.sum() / spacing**2)  # enough to leave no room for another point but rarely
    chosen = random.choice(len(corners), count, p=areas / areas.sum())
    u, v = random.random((2, count, 1))
    fold = u + v > 1
    u, v = np.where(fold, 1 - u, u), np.where(fold, 1 - v, v)
    a, b, c = np.moveaxis(corners[chosen], 1, 0)
    points = a + u * (b - a) + v * (c - a)
    kept = thinned(points, spacing)
    return points[kept], normals_of(corners)[chosen[kept]]


def thinned(points, spacing):
    """Greedily, in order: the indices of points at least `spacing` from every one kept before."""
    bins, kept = {}, []
    near = [(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]
    for index, (point, (i, j, k)) in enumerate(zip(points, np.floor(points / spacing).astype(int).tolist())):
        others = [p for di, dj, dk in near for p in bins.get((i + di, j + dj, k + dk), ())]
        if all(((point - other) ** 2).sum() >= spacing**2 for other in others):
            bins.setdefault((i, j, k), []).append(point)
            kept.append(index)
    return np.array(kept, int)


def clipped(corners, normal, offset):
    """The triangles of what lies where normal . x <= offset, and for each the triangle that it comes from."""
    pieces, origin = [], []
    distance = corners @ normal - offset
    for index, (triangle, d) in enumerate(zip(corners, distance)):
        if (d <= 0).all():
            polygon = list(triangle)
        elif (d > 0).all():
            continue
        else:
            polygon = []
            for i in range(3):
                j = (i + 1) % 3
                if d[i] <= 0:
                    polygon.append(triangle[i])
                if (d[i] <= 0) != (d[j] <= 0):
                    polygon.append(triangle[i] + d[i] / (d[i] - d[j]) * (triangle[j] - triangle[i]))
        for i in range(1, len(polygon) - 1):
            pieces.append((polygon[0], polygon[i], polygon[i + 1]))
            origin.append(index)
    return np.array(pieces).reshape(-1, 3, 3), np.array(origin, int)


def contour(corners, normal, offset):
    """The segments in which the plane normal . x = offset cuts the surface, an array of shape (segments, 2, 3)."""
    above = corners @ normal > offset
    crossing = np.flatnonzero(above.any(axis=1) & ~above.all(axis=1))
    segments = []
    for triangle in corners[crossing]:
        d = triangle @ normal - offset
        ends = [triangle[i] + d[i] / (d[i] - d[j]) * (triangle[j] - triangle[i])
                for i, j in ((0, 1), (1, 2), (2, 0)) if (d[i] > 0) != (d[j] > 0)]
        segments.append(ends)
    return np.array(segments).reshape(-1, 2, 3)
