# SPDX-License-Identifier: Apache-2.0
"""A binary STL file, its triangles clipped to the cells of a field, and which points it encloses."""

from pathlib import Path

import numpy as np

SMALLEST_PIECE = 1e-9  # of a cell face: below it a piece is rounding noise


class Surface:
    """Triangles (n, 3, 3) with `normals`, `areas`; `orientation` is -1 where the surface is inside out."""

    def __init__(self, path):
        data = Path(path).read_bytes()
        record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("zero", "<u2")])
        count = int.from_bytes(data[80:84], "little")
        self.triangles = np.frombuffer(data, record, count, 84)["corners"].astype(float)
        a, b, c = np.moveaxis(self.triangles, 1, 0)
        cross = np.cross(b - a, c - a)
        self.areas = 0.5 * np.linalg.norm(cross, axis=1)
        assert (self.areas > 0).all()
        self.normals = cross / (2 * self.areas[:, None])
        self.orientation = 1 if np.einsum("ij,ij->", a, np.cross(b, c)) > 0 else -1

    def topology(self):
        """Whether every edge has two triangles that run along it in opposite directions, and the components."""
        _, corner = np.unique(self.triangles.reshape(-1, 3) + 0.0, axis=0, return_inverse=True)
        corner = corner.reshape(-1, 3)
        edges = {}
        for t, (a, b, c) in enumerate(corner):
            for edge in ((a, b), (b, c), (c, a)):
                edges.setdefault(edge, []).append(t)
        watertight = all(len(uses) == 1 and (b, a) in edges for (a, b), uses in edges.items())
        component = list(range(len(corner)))

        def root(t):
            while component[t] != t:
                t = component[t]
            return t

        for (a, b), uses in edges.items():
            for t in uses + edges.get((b, a), []):
                component[root(t)] = root(uses[0])
        return watertight, len({root(t) for t in range(len(corner))})

    def inside(self, points):
        """By the winding number: the sum of solid angles (Van Oosterom and Strackee 1983) over 4 pi."""
        result = np.empty(len(points), bool)
        for k, point in enumerate(points):
            a, b, c = np.moveaxis(self.triangles - point, 1, 0)
            la, lb, lc = (np.linalg.norm(x, axis=1) for x in (a, b, c))
            numerator = np.einsum("ij,ij->i", a, np.cross(b, c))
            denominator = la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
            winding = np.arctan2(numerator, denominator).sum() / (2 * np.pi)
            result[k] = self.orientation * winding > 0.5
        return result

    def first_hit(self, origin, direction, nearest):
        """Distance and triangle of the first hit beyond `nearest`; (inf, None) where there is none."""
        distance, _ = self.crossings(np.arange(len(self.triangles)), origin, direction[None])
        distance = np.where(distance[0] > nearest, distance[0], np.inf)
        triangle = int(np.argmin(distance))
        return (distance[triangle], triangle) if np.isfinite(distance[triangle]) else (np.inf, None)

    def entered_along(self, chosen, origin, directions):
        """How often each segment from origin to origin + direction enters the solid through one of the chosen
        triangles, less how often it leaves it."""
        distance, entering = self.crossings(chosen, origin, directions)
        met = (distance >= 0) & (distance <= 1)
        return self.orientation * (met * np.where(entering, 1, -1)).sum(axis=1)

    def crossings(self, chosen, origin, directions):
        """For each direction and chosen triangle, t where origin + t direction meets it, any sign, NaN where it
        does not; and whether that is against the triangle's normal (Moeller and Trumbore 1997)."""
        a, b, c = np.moveaxis(self.triangles[chosen], 1, 0)
        s = origin - a
        q = np.cross(s, b - a)
        p = np.cross(directions[:, None], c - a)
        with np.errstate(divide="ignore", invalid="ignore"):
            determinant = np.einsum("tk,dtk->dt", b - a, p)
            u = np.einsum("tk,dtk->dt", s, p) / determinant
            v = directions @ q.T / determinant
            t = np.einsum("tk,tk->t", c - a, q) / determinant
        return np.where((u >= 0) & (v >= 0) & (u + v <= 1), t, np.nan), determinant > 0


def clipped(polygon, low, high):
    """The part of a polygon inside a box."""
    for axis in range(3):
        for sign, bound in ((1, low[axis]), (-1, -high[axis])):
            heights = [sign * p[axis] - bound for p in polygon]
            kept = []
            for k, p in enumerate(polygon):
                before, height, previous = heights[k - 1], heights[k], polygon[k - 1]
                if (before >= 0) != (height >= 0):
                    kept.append(previous + before / (before - height) * (p - previous))
                if height >= 0:
                    kept.append(p)
            polygon = kept
            if len(polygon) < 3:
                return []
    return polygon


def area_and_centroid(polygon):
    area, moment = 0.0, np.zeros(3)
    for b, c in zip(polygon[1:-1], polygon[2:]):
        part = 0.5 * np.linalg.norm(np.cross(b - polygon[0], c - polygon[0]))
        area += part
        moment += part / 3 * (polygon[0] + b + c)
    return area, moment / area if area > 0 else moment


def pieces_by_cell(surface, low, size):
    """For every cell the list of (triangle, area, centroid) of the surface inside it."""
    pieces = [[] for _ in size]
    high = low + size[:, None]
    for t, triangle in enumerate(surface.triangles):
        near = (triangle.max(axis=0) > low).all(axis=1) & (triangle.min(axis=0) < high).all(axis=1)
        for i in np.flatnonzero(near):
            polygon = clipped(list(triangle), low[i], high[i])
            if not polygon:
                continue
            area, centroid = area_and_centroid(polygon)
            if area > SMALLEST_PIECE * size[i] ** 2:
                pieces[i].append((t, area, centroid))
    return pieces
