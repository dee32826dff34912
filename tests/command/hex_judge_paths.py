# SPDX-License-Identifier: Apache-2.0
"""Which corners and creases of a model the boundary of a mesh keeps: corners by a vertex, creases by an unbroken path of edges."""

from collections import defaultdict

import numpy as np
from scipy.spatial import cKDTree

from hex_judge_mesh import edges_of

KEPT = 0.12  # hexahedra that vertices and edges may be off, beyond what straight edges cut off
SAMPLES = 9  # on an edge, and on the part of a curve beside it
BREAK = 1.0  # hexahedra that a break of a path costs of the length that it keeps


class KeptFeatures:
    """`corners` (n,), whether each is kept; `curves`, whether each is, and `shares` of their lengths; `sagittas` {edge of the boundary:
    what it cuts off of a crease}."""

    def __init__(self, features, points, quads):
        self.size, self.points = features.size, points
        self.edges = np.unique(np.sort(edges_of(quads), axis=1), axis=0)
        self.used = np.unique(quads)
        self.tree = cKDTree(points[self.used])
        self.sagittas = {}
        self.corners = np.zeros(0, bool)
        if len(features.corners):
            self.corners = self.tree.query(features.corners)[0] <= KEPT * self.size
        self.curves, self.shares = [], []
        for curve in features.curves:
            is_kept, share = self.judge(curve, features.corners)
            self.curves.append(is_kept)
            self.shares.append(share)

    def judge(self, curve, corners):
        starts, ends, lengths = self.steps_along(curve, corners)
        span = curve.length
        ways = defaultdict(list)
        for start, end, length in zip(starts, ends, lengths):
            ways[start].append((end, length))
        if curve.is_closed:
            is_kept = goes_around(ways, span)
        else:
            is_kept = goes_through(ways, {node for node in ways if node[1] == 0}, span)
        return is_kept, 1.0 if is_kept else self.best_share(starts, ends, lengths, span)

    def steps_along(self, curve, corners):
        """Edges of the boundary that run along a curve: the nodes (vertex, place on the curve) where they start and end, and their
        lengths along it. At a corner the place is 0 or the whole length. Edges are turned to go forward."""
        near = self.near_curve(curve)
        places = {vertex: {at} for vertex, at in near.items()}
        if not curve.is_closed:
            for corner, at in zip(curve.corners, (0.0, curve.length)):
                for k in self.tree.query_ball_point(corners[corner], KEPT * self.size):
                    vertex = int(self.used[k])
                    others = places.setdefault(vertex, set())
                    if abs(near.get(vertex, at) - at) < self.size:  # the nearest place is the corner's surroundings
                        others.discard(near.get(vertex))
                    others.add(at)
        pairs = [(int(a), one, int(b), other) for a, b in self.edges if a in places and b in places
                 for one in places[a] for other in places[b]]
        starts, ends, lengths = [], [], []
        for a, one, b, other in pairs:
            way = other - one
            if curve.is_closed:
                way -= curve.length * np.round(way / curve.length)
            if way < 0:
                a, one, b, other, way = b, other, a, one, -way
            sagitta = self.runs_along(curve, a, b, one, way)
            if sagitta is not None:
                self.sagittas[min(a, b), max(a, b)] = max(sagitta, self.sagittas.get((min(a, b), max(a, b)), 0))
                starts.append((a, one))
                ends.append((b, other))
                lengths.append(way)
        return starts, ends, lengths

    def near_curve(self, curve):
        """{vertex: place on the curve} of vertices that are as near as kept ones."""
        at = curve.samples(self.size / 4)
        close = {int(k) for found in self.tree.query_ball_point(curve.place(at), (KEPT + 0.2) * self.size) for k in found}
        if not close:
            return {}
        vertices = self.used[sorted(close)]
        places, distances = nearest_places(curve, self.points[vertices], self.size / SAMPLES)
        return {int(v): float(at) for v, at, d in zip(vertices, places, distances) if d <= KEPT * self.size}

    def runs_along(self, curve, a, b, start, way):
        """What a straight edge cuts off, k e^2 / 8, where no point of it or of the curve's part beside it is farther than that and
        KEPT from the other; None elsewhere."""
        one, other = self.points[[a, b]]
        edge = np.linalg.norm(other - one)
        if way < 0.2 * edge or way > 2 * edge:
            return None
        cuts = start + way * np.linspace(0, 1, SAMPLES)
        part = curve.place(cuts)
        tangents = np.diff(part, axis=0)
        tangents /= np.maximum(np.linalg.norm(tangents, axis=1, keepdims=True), 1e-300)
        turn = np.linalg.norm(np.diff(tangents, axis=0), axis=1).sum() * (SAMPLES - 1) / (SAMPLES - 2)
        sagitta = min(turn, np.pi) * edge / 8
        limit = sagitta + KEPT * self.size
        off_edge = distances_to_polyline(part, np.stack([one, other]))[0]
        off_curve = distances_to_polyline(one + np.linspace(0, 1, SAMPLES)[:, None] * (other - one), part)[0]
        return sagitta if max(off_edge.max(), off_curve.max()) <= limit else None

    def best_share(self, starts, ends, lengths, span):
        """The most of a curve's length beside edges that follow each other, each break at the price of a hexahedron."""
        order = sorted(range(len(starts)), key=lambda k: (starts[k][1], ends[k][1]))
        best_at, reached = defaultdict(lambda: -np.inf), []  # by node; [(place, best up to there)]
        best = 0.0
        for k in order:
            jump = max((value for place, value in reached if place <= starts[k][1] + 1e-9 * span), default=0.0)
            value = max(best_at[starts[k]], jump - BREAK * self.size, 0.0) + lengths[k]
            best_at[ends[k]] = max(best_at[ends[k]], value)
            reached.append((starts[k][1] + lengths[k], value))
            best = max(best, value)
        return max(0.0, min(best, span) / span - 1e-12)


def goes_through(ways, starts, span):
    """Whether steps lead from a node at the start to one at the end."""
    seen, waiting = set(starts), list(starts)
    while waiting:
        for end, _ in ways.get(waiting.pop(), ()):
            if end[1] == span:
                return True
            if end not in seen:
                seen.add(end)
                waiting.append(end)
    return False


def goes_around(ways, span):
    """Whether steps lead from some node around a closed curve back to it. All ways around use a node within the longest step of its
    beginning."""
    longest = max((length for steps in ways.values() for _, length in steps), default=0)
    for first in [node for node in ways if node[1] <= longest]:
        seen, waiting = {first}, [(first, 0.0)]
        while waiting:
            node, travelled = waiting.pop()
            for end, length in ways.get(node, ()):
                if end == first and abs(travelled + length - span) < 0.5 * span:
                    return True
                if end not in seen and travelled + length < 1.5 * span:
                    seen.add(end)
                    waiting.append((end, travelled + length))
    return False


def distances_to_polyline(points, line):
    """Distances of (n, 3) points to segments in a row, and the (segment, share of it) of the nearest places."""
    starts, ways = line[:-1], np.diff(line, axis=0)
    shares = np.einsum("nkj,kj->nk", points[:, None] - starts, ways) / np.maximum((ways ** 2).sum(axis=1), 1e-300)
    shares = np.clip(shares, 0, 1)
    distances = np.linalg.norm(points[:, None] - starts - shares[..., None] * ways, axis=2)
    nearest = distances.argmin(axis=1)
    rows = np.arange(len(points))
    return distances[rows, nearest], nearest, shares[rows, nearest]


def nearest_places(curve, points, spacing):
    """Places of a curve nearest to points, and how far they are; `spacing` is less than what lies between two parts of the curve."""
    dense = curve.samples(spacing)
    _, first = cKDTree(curve.place(dense)).query(points)
    places, distances = np.zeros(len(points)), np.zeros(len(points))
    for k, middle in enumerate(dense[first]):
        low, high = np.searchsorted(curve.at, (middle - spacing, middle + spacing))
        low, high = max(0, low - 1), min(len(curve.at) - 1, high)
        found, segment, share = distances_to_polyline(points[k:k + 1], curve.points[low:high + 1])
        segment = low + segment[0]
        distances[k] = found[0]
        places[k] = curve.at[segment] + share[0] * (curve.at[segment + 1] - curve.at[segment])
    if curve.is_closed:
        places %= curve.length
    return places, distances
