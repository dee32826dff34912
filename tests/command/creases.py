# SPDX-License-Identifier: Apache-2.0
"""The sharp edges of a triangle surface, and the pieces of them inside the cells of a field."""

from collections import defaultdict

import numpy as np

SURE_DEG, LEAST_RADII = 80, 80
SHARP_COSINE, CORNER_COSINE, KNIFE_COSINE = np.cos(np.radians((35, 45, 45)))


class Creases:
    """`edges` [(start, end, tangent at start, tangent at end)], `corners` {point: how many edges meet there}."""

    def __init__(self, surface):
        points, corner = np.unique(surface.triangles.reshape(-1, 3) + 0.0, axis=0, return_inverse=True)
        uses = defaultdict(list)
        for t, triangle in enumerate(corner.reshape(-1, 3)):
            for a, b in zip(triangle, np.roll(triangle, -1)):
                uses[min(a, b), max(a, b)].append((t, 1 if a < b else -1))
        sharp = [edge for edge, of_edge in uses.items() if any(
            -s * r * surface.normals[t] @ surface.normals[u] < SHARP_COSINE
            for k, (t, s) in enumerate(of_edge) for u, r in of_edge[:k])]
        sharp = self.without_fading(surface, points, sharp, uses)
        self.knives = sorted(tuple(0.5 * (points[a] + points[b])) for a, b in sharp
                             if self.is_knife(surface, points, (a, b), uses[a, b]))
        around = defaultdict(list)
        for a, b in sharp:
            around[a].append(b)
            around[b].append(a)

        def direction(a, b):
            return (points[b] - points[a]) / np.linalg.norm(points[b] - points[a])

        def goes_on(v):
            return len(around[v]) == 2 and -direction(v, around[v][0]) @ direction(v, around[v][1]) > CORNER_COSINE

        def tangent(a, b):
            if not goes_on(a):
                return direction(a, b)
            other = next(c for c in around[a] if c != b)
            sum_ = direction(other, a) + direction(a, b)
            return sum_ / np.linalg.norm(sum_)

        self.edges = [(points[a], points[b], tangent(a, b), -tangent(b, a)) for a, b in sharp]
        self.corners = {tuple(points[v]): len(others) for v, others in around.items()
                        if len(others) > 1 and not goes_on(v)}
        ends = sum(len(others) for v, others in around.items() if not goes_on(v))
        self.curves = ends // 2 + self.loops(around, goes_on)

    @staticmethod
    def without_fading(surface, points, sharp, uses):
        """Without paths that end in nothing, are nowhere sure and are short, the shortest first."""
        def turn(edge):
            return max(np.arccos(np.clip(-s * r * surface.normals[t] @ surface.normals[u], -1, 1))
                       for k, (t, s) in enumerate(uses[edge]) for u, r in uses[edge][:k])

        def radii(edge):
            (t, _), (u, _) = uses[edge][:2]
            areas = [np.linalg.norm(np.cross(*(surface.triangles[k][1:] - surface.triangles[k][0]))) / 2 for k in (t, u)]
            return turn(edge) * 1.5 * ((points[edge[0]] - points[edge[1]]) ** 2).sum() / sum(areas)

        holding = {v for edge, of_edge in uses.items() if len(of_edge) != 2 for v in edge}
        left = {edge: (radii(edge), turn(edge)) for edge in sharp}
        while True:
            around = defaultdict(list)
            for edge in left:
                for v in edge:
                    around[v].append(edge)
            fading = []
            for start, (first, *others) in around.items():
                if others or start in holding:
                    continue
                path, at = [first], sum(first) - start
                while len(around[at]) == 2 and at not in holding:
                    path.append(next(edge for edge in around[at] if edge != path[-1]))
                    at = sum(path[-1]) - at
                length = sum(left[edge][0] for edge in path)
                if length < LEAST_RADII and max(left[edge][1] for edge in path) < np.radians(SURE_DEG):
                    fading.append((length, path))
            if not fading:
                return [edge for edge in sharp if edge in left]
            for edge in min(fading)[1]:
                del left[edge]

    @staticmethod
    def is_knife(surface, points, edge, uses):
        if len(uses) != 2 or uses[0][1] == uses[1][1]:
            return False
        (t, _), (u, _) = uses
        if surface.normals[t] @ surface.normals[u] >= -KNIFE_COSINE:
            return False
        ahead = (surface.triangles[u] - points[edge[0]]).sum(axis=0) @ surface.normals[t]
        return bool((ahead > 0) == (surface.orientation < 0))

    @staticmethod
    def loops(around, goes_on):
        """Closed curves that nothing interrupts."""
        seen, count = set(), 0
        for start in around:
            component, waiting = {start}, [start]
            while waiting and start not in seen:
                for other in around[waiting.pop()]:
                    if other not in component:
                        component.add(other)
                        waiting.append(other)
            count += start not in seen and all(goes_on(v) for v in component)
            seen |= component
        return count

    def length(self):
        return sum(np.linalg.norm(b - a) for a, b, _, _ in self.edges)

    def places(self, step):
        """[(point, tangent, length)] in the middles of equal parts of the edges, none longer than `step`."""
        for a, b, at_a, at_b in self.edges:
            length = np.linalg.norm(b - a)
            parts = max(1, int(np.ceil(length / step)))
            for t in (np.arange(parts) + 0.5) / parts:
                yield a + t * (b - a), blended(at_a, at_b, t), length / parts

    def by_cell(self, low, size):
        """For every cell the list of (tangent, length times cell size) of the edges inside; none where a corner is."""
        pieces = [[] for _ in size]
        high = low + size[:, None]
        with_corner = {i for point in self.corners
                       for i in np.flatnonzero((low <= point).all(axis=1) & (point < high).all(axis=1))}
        for a, b, at_a, at_b in self.edges:
            near = (np.maximum(a, b) > low).all(axis=1) & (np.minimum(a, b) < high).all(axis=1)
            for i in set(np.flatnonzero(near)) - with_corner:
                with np.errstate(divide="ignore", invalid="ignore"):
                    enters = np.where(a == b, -np.inf, np.minimum((low[i] - a) / (b - a), (high[i] - a) / (b - a)))
                    leaves = np.where(a == b, np.inf, np.maximum((low[i] - a) / (b - a), (high[i] - a) / (b - a)))
                first, last = max(0, enters.max()), min(1, leaves.min())
                if last > first:
                    pieces[i].append((blended(at_a, at_b, 0.5 * (first + last)),
                                      (last - first) * np.linalg.norm(b - a) * size[i]))
        return pieces


def blended(a, b, t):
    tangent = (1 - t) * a + t * b
    return tangent / np.linalg.norm(tangent)
