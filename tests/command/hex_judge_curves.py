# SPDX-License-Identifier: Apache-2.0
"""Corners, creases and faces of a model, and which of them hexahedra of a size can resolve.

A crease is an edge with more than 35 degrees between its faces; in a CAD file a curve between faces that are not tangent there; in a tet
mesh also a tagged edge of more than 15 degrees, unless it borders facets of a rounding that turn more. Chains of creases end in corners: where not two of them meet, or two at an angle.
"""

from collections import defaultdict

import numpy as np
from scipy.spatial import cKDTree

from hex_judge_mesh import component_labels, edges_of

CREASE_DEG, SOFT_DEG, CORNER_DEG = 35, 15, 45
SURE_DEG, LEAST_RADII = 80, 80  # a chain that ends in the smooth surface counts if it is as sharp somewhere, or as long
PARALLEL, FACET_TURNS = 0.9, (1.5, 2.7)  # cosine of edges beside a tagged one, and their turns over its own where a rounding begins: 2
TIP = 0.8  # radians that the angles of triangles around the tip of a cone lack of a full turn, at least
SHORTEST, NEAREST = 2.0, 1.0  # in hexahedra: lengths and distances of what they resolve
MEETING = 3.0  # in hexahedra: as far from a common corner two curves may be near each other, which they are at acute angles
SAMPLES = 10  # along one hexahedron


class Curve:
    """`points` (n, 3), a closed one with its first repeated; `at` (n,), the length up to each; `corners`, indices of both ends, None of a
    closed one without; `turns` (n - 1,), radians between the faces along it; `bounds`, the most of a scaled Jacobian there."""

    def __init__(self, points, corners, turns, bounds):
        self.points, self.corners, self.turns, self.bounds = points, corners, turns, bounds
        self.is_closed = corners is None
        steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
        self.at = np.concatenate([[0], np.cumsum(steps)])
        self.length = float(self.at[-1])
        self.tangents = np.diff(points, axis=0) / np.maximum(steps, 1e-300)[:, None]
        self.is_resolved = True

    def place(self, at):
        at = np.asarray(at, float)
        if self.is_closed:
            at = at % self.length
        return np.stack([np.interp(at, self.at, self.points[:, axis]) for axis in range(3)], axis=-1)

    def samples(self, step):
        count = max(2, int(np.ceil(self.length / step)) + 1)
        return np.linspace(0, self.length, count)


class Face:
    """`number` in the file; `triangles`, `area`; `perimeter`, and of it `soft`, where it is tangent to another face; `is_resolved`."""

    def __init__(self, number, triangles, area, perimeter, soft, curve_edges):
        self.number, self.triangles, self.area, self.perimeter, self.soft = number, triangles, area, perimeter, soft
        self.curve_edges = curve_edges
        self.is_resolved = True


class Features:
    """`curves`, `faces`; `corners` (n, 3) with `resolved_corners` (n,); `face_of` and `patch_of` each triangle: patches are what creases
    divide, so that faces tangent to each other are in one."""

    def __init__(self, model, size):
        self.model, self.size = model, size
        self.find_edges()
        hard = self.hard_edges()
        self.chain(hard)
        self.patch_of = component_labels(len(model.triangles), self.beside[~hard & self.has_two])
        self.make_faces(hard)
        self.resolve()

    def find_edges(self):
        """`edges` (m, 2), ascending, with the triangles `beside` them, `turns` between their normals, whether they are `convex`."""
        triangles, normals = self.model.triangles, self.model.normals
        owner = np.repeat(np.arange(len(triangles)), 3)
        self.edges, inverse, count = np.unique(np.sort(edges_of(triangles), axis=1), axis=0, return_inverse=True, return_counts=True)
        order = np.argsort(inverse, kind="stable")
        starts = np.cumsum(count) - count
        self.beside = np.stack([owner[order[starts]], owner[order[starts + np.minimum(count - 1, 1)]]], axis=1)
        self.has_two = count == 2
        one, other = self.beside.T
        self.turns = np.arctan2(np.linalg.norm(np.cross(normals[one], normals[other]), axis=1), (normals[one] * normals[other]).sum(axis=1))
        centres = self.model.corners().mean(axis=1)
        self.convex = ((centres[other] - centres[one]) * normals[one]).sum(axis=1) < 0
        self.lengths = np.linalg.norm(self.model.points[self.edges[:, 0]] - self.model.points[self.edges[:, 1]], axis=1)
        areas = self.model.areas[one] + self.model.areas[other]
        self.radii = self.turns * 1.5 * self.lengths ** 2 / np.maximum(areas, 1e-300)

    def hard_edges(self):
        numbers = {tuple(edge): k for k, edge in enumerate(self.edges.tolist())}
        lines = np.array([numbers.get(tuple(line), -1) for line in np.sort(self.model.lines, axis=1).tolist()], int)
        on_surface = lines >= 0
        lines, curves = lines[on_surface], self.model.line_curves[on_surface]
        hard = np.zeros(len(self.edges), bool)
        self.on_curves = np.zeros(len(self.edges), bool)  # of the file, or creases; no seams
        if self.model.is_cad:
            for curve in np.unique(curves):
                on = lines[curves == curve]
                is_seam = (self.model.numbers[self.beside[on, 0]] == self.model.numbers[self.beside[on, 1]]).all()
                sharp = self.turns[on] >= np.radians(CREASE_DEG if is_seam else SOFT_DEG)
                hard[on] = self.lengths[on][sharp].sum() > 0.5 * self.lengths[on].sum()
                self.on_curves[on] = hard[on] | ~is_seam
            return hard
        tagged = np.array([k for k in lines[self.turns[lines] >= np.radians(SOFT_DEG)].tolist() if not self.is_tangent(k)], int)
        hard = self.turns >= np.radians(CREASE_DEG)
        hard[tagged] = True
        self.drop_fading(hard, set(tagged.tolist()))
        self.on_curves[:] = hard
        return hard

    def is_tangent(self, edge):
        """Whether a parallel edge beside this one turns twice as much, as between the facets of a rounding that begins here."""
        points = self.model.points
        beside = self.model.triangles[np.isin(self.model.triangles, self.edges[edge]).any(axis=1)]
        near = np.isin(self.edges, beside).all(axis=1) & ~np.isin(self.edges, self.edges[edge]).any(axis=1)
        ways = points[self.edges[:, 1]] - points[self.edges[:, 0]]
        cosines = np.abs(ways @ ways[edge]) / (self.lengths * self.lengths[edge])
        ratios = self.turns[near & (cosines > PARALLEL)] / self.turns[edge]
        return bool(((ratios > FACET_TURNS[0]) & (ratios < FACET_TURNS[1])).any())

    def strands(self, hard):
        """{vertex: hard edges there}."""
        around = defaultdict(list)
        for k in np.flatnonzero(hard).tolist():
            for vertex in self.edges[k].tolist():
                around[vertex].append(k)
        return around

    def drop_fading(self, hard, kept):
        """The shortest first, since what is left may be joined to another one."""
        while True:
            around, fading = self.strands(hard), []
            for vertex, first in around.items():
                if len(first) != 1:
                    continue
                path, at = [first[0]], self.edges[first[0]].sum() - vertex
                while len(around[at]) == 2:
                    path.append(next(k for k in around[at] if k != path[-1]))
                    at = self.edges[path[-1]].sum() - at
                radii = self.radii[path].sum()
                if radii < LEAST_RADII and self.turns[path].max() < np.radians(SURE_DEG) and not kept.intersection(path):
                    fading.append((radii, path))
            if not fading:
                return
            hard[min(fading)[1]] = False

    def chain(self, hard):
        points, around = self.model.points, self.strands(hard)
        ends = [vertex for vertex, at in around.items() if len(at) != 2 or self.bend(vertex, at) > np.radians(CORNER_DEG)]
        corner_of = {vertex: k for k, vertex in enumerate(ends)}
        self.corners = points[ends] if ends else np.zeros((0, 3))
        self.curves, left = [], set(np.flatnonzero(hard).tolist())
        self.curve_of = np.full(len(self.edges), -1)
        starts = [(vertex, k) for vertex in ends for k in around[vertex]] + [(None, k) for k in sorted(left)]
        for vertex, k in starts:
            if k not in left:
                continue
            first = vertex if vertex is not None else int(self.edges[k, 0])
            chain, at, path = [first], int(self.edges[k].sum() - first), [k]
            while at != first and at not in corner_of:
                chain.append(at)
                path.append(next(n for n in around[at] if n != path[-1]))
                at = int(self.edges[path[-1]].sum() - at)
            left.difference_update(path)
            self.curve_of[path] = len(self.curves)
            corners = (corner_of[first], corner_of[at]) if first in corner_of else None
            self.curves.append(Curve(points[[*chain, at]], corners, self.turns[path], self.bounds(path)))
        self.corners = np.concatenate([self.corners, points[self.tips(around)].reshape(-1, 3)])

    def bend(self, vertex, at):
        one, other = (self.model.points[self.edges[k].sum() - vertex] - self.model.points[vertex] for k in at)
        return np.pi - np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other)

    def bounds(self, path):
        """The most that a scaled Jacobian can be at an edge: the sine of its angle, shared by the best number of hexahedra."""
        angles = np.pi + np.where(self.convex[path], -1, 1) * self.turns[path]
        return np.max([np.where(angles / k < np.pi, np.sin(angles / k), 0) for k in (1, 2, 3, 4)], axis=0)

    def tips(self, around):
        edges = self.model.corners() - np.roll(self.model.corners(), 1, axis=1)  # to each corner from the one before
        out, back = -np.roll(edges, -1, axis=1), edges
        angles = np.arctan2(np.linalg.norm(np.cross(out, back), axis=2), (out * back).sum(axis=2))
        sums = np.bincount(self.model.triangles.reshape(-1), angles.reshape(-1), minlength=len(self.model.points))
        return [v for v in np.flatnonzero(sums < 2 * np.pi - TIP).tolist() if v not in around]

    def make_faces(self, hard):
        """Those of the file's numbers; without them, or where creases divide them, what creases divide."""
        numbers = self.model.numbers
        if self.model.is_cad:
            _, self.face_of = np.unique(numbers, return_inverse=True)
        else:
            self.on_curves |= numbers[self.beside[:, 0]] != numbers[self.beside[:, 1]]
            self.face_of = component_labels(len(self.model.triangles), self.beside[~self.on_curves & self.has_two])
        self.faces = []
        beside = self.face_of[self.beside]
        for face in range(self.face_of.max(initial=-1) + 1):
            triangles = np.flatnonzero(self.face_of == face)
            border = np.flatnonzero((beside == face).any(axis=1) & (self.on_curves & (hard | (beside[:, 0] != beside[:, 1]))))
            self.faces.append(Face(int(numbers[triangles[0]]), triangles, float(self.model.areas[triangles].sum()),
                                   float(self.lengths[border].sum()), float(self.lengths[border[~hard[border]]].sum()), border[hard[border]]))

    def resolve(self):
        size = self.size
        samples = [curve.samples(size / SAMPLES) for curve in self.curves]
        trees = [cKDTree(curve.place(at)) for curve, at in zip(self.curves, samples)]
        boxes = [(curve.points.min(axis=0) - NEAREST * size, curve.points.max(axis=0)) for curve in self.curves]
        for a, curve in enumerate(self.curves):
            near = np.zeros(len(samples[a]), bool)
            for b, tree in enumerate(trees):
                if a != b and (boxes[a][0] <= boxes[b][1]).all() and (boxes[b][0] <= boxes[a][1]).all():
                    near |= self.near(curve, self.curves[b], samples[a], tree)
            curve.is_resolved = curve.length >= SHORTEST * size and near.mean() < 0.5 and longest_run(near, samples[a]) < size
        self.resolved_corners = np.array([self.is_corner_resolved(k, trees) for k in range(len(self.corners))], bool)
        for face in self.faces:
            lengths, owners = self.lengths[face.curve_edges], self.curve_of[face.curve_edges]
            kept = sum(length for length, owner in zip(lengths, owners) if self.curves[owner].is_resolved)
            face.is_resolved = 2 * face.area >= face.perimeter * size and (not len(lengths) or kept >= 0.5 * lengths.sum())

    def near(self, curve, other, at, tree):
        """Where another curve is within a hexahedron of one, but for where they meet: from a common corner on as long as they stay near."""
        near = tree.query(curve.place(at), distance_upper_bound=NEAREST * self.size)[0] < NEAREST * self.size
        for end, order in ((0, np.arange(len(at))), (1, np.arange(len(at))[::-1])):
            if curve.corners and other.corners and curve.corners[end] in other.corners:
                far = np.flatnonzero(~near[order])
                meeting = order[:far[0] if len(far) else len(at)]
                near[meeting[np.abs(at[meeting] - at[order[0]]) <= MEETING * self.size]] = False
        return near

    def is_corner_resolved(self, k, trees):
        """Not within a hexahedron of another corner or of a curve that does not end there, and with a resolved curve if it has any."""
        others = np.delete(self.corners, k, axis=0)
        if len(others) and np.linalg.norm(others - self.corners[k], axis=1).min() < NEAREST * self.size:
            return False
        own = [curve.is_resolved for curve in self.curves if curve.corners and k in curve.corners]
        away = [tree.query(self.corners[k])[0] for curve, tree in zip(self.curves, trees) if not (curve.corners and k in curve.corners)]
        return min(away, default=np.inf) >= NEAREST * self.size and (any(own) or not own)


def longest_run(flags, at):
    """The length of the longest run of set flags at samples along a curve."""
    longest = start = 0
    for k, flag in enumerate(flags):
        if not flag:
            start = k + 1
        elif k >= start:
            longest = max(longest, at[k] - at[start])
    return longest
