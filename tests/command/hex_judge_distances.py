# SPDX-License-Identifier: Apache-2.0
"""Distances between the boundary of a mesh and the surface of a model, both ways, and what straight edges cut off of the surface."""

import numpy as np
from scipy.spatial import cKDTree

PARTS = 3  # of each side of a quad, for samples and for its triangles
FIRST_NEAREST = 16  # pieces of triangles that are looked at: about two rings around a point
PAIRS = 30000  # of points and triangles in one step: their arrays stay in the cache
UV = np.stack(np.meshgrid(*[np.linspace(0, 1, PARTS + 1)] * 2, indexing="ij"), axis=-1).reshape(-1, 2)
WEIGHTS = np.stack([(1 - UV[:, 0]) * (1 - UV[:, 1]), UV[:, 0] * (1 - UV[:, 1]), UV[:, 0] * UV[:, 1], (1 - UV[:, 0]) * UV[:, 1]], axis=1)
CELLS = np.array([(k, k + PARTS + 1, k + PARTS + 2, k + 1) for i in range(PARTS) for k in range(i * (PARTS + 1), i * (PARTS + 1) + PARTS)])
TRIANGLES = np.concatenate([CELLS[:, [0, 1, 2]], CELLS[:, [0, 2, 3]]])


class NearestTriangle:
    """Finds the nearest of (n, 3, 3) triangles."""

    def __init__(self, corners, longest):
        self.corners = corners
        pieces, self.owner = cut(corners, longest)
        self.pieces, self.centres = pieces, pieces.mean(axis=1)
        self.radius = np.linalg.norm(pieces - self.centres[:, None], axis=2).max()
        self.tree = cKDTree(self.centres)

    def query(self, points):
        """Distances, indices of triangles and (k, 3) weights of their corners at the nearest places."""
        points = np.asarray(points, float)
        distances, nearest = np.full(len(points), np.inf), np.zeros(len(points), int)
        open_, count = np.arange(len(points)), FIRST_NEAREST
        while len(open_):
            count = min(count, len(self.centres))
            far, found = self.tree.query(points[open_], k=count)
            far, found = far.reshape(len(open_), count), found.reshape(len(open_), count)
            limit = to_triangles(points[open_], self.pieces[found[:, 0]])[0]
            row, column = np.nonzero(far - self.radius <= limit[:, None])
            to = np.concatenate([to_triangles(points[open_[row[part]]], self.pieces[found[row[part], column[part]]])[0]
                                 for part in np.array_split(np.arange(len(row)), 1 + len(row) // PAIRS)])
            best = np.lexsort((to, row))[np.searchsorted(row, np.arange(len(open_)))]
            distances[open_], nearest[open_] = to[best], self.owner[found[row[best], column[best]]]
            is_sure = (far[:, -1] >= distances[open_] + self.radius) | (count == len(self.centres))
            open_, count = open_[~is_sure], 4 * count
        _, weights = to_triangles(points, self.corners[nearest])
        return distances, nearest, weights


def cut(corners, longest):
    """Triangles cut at the middle of their longest edges until none is longer, with the index of the one that each is of."""
    owner, done, owners = np.arange(len(corners)), [], []
    while len(corners):
        lengths = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
        is_long = lengths.max(axis=1) > longest
        done.append(corners[~is_long])
        owners.append(owner[~is_long])
        corners, owner = corners[is_long], owner[is_long]
        turn = (lengths[is_long].argmax(axis=1)[:, None] + np.arange(3)) % 3
        a, b, c = np.moveaxis(np.take_along_axis(corners, turn[..., None], axis=1), 1, 0)
        middle = (a + b) / 2
        corners = np.concatenate([np.stack([a, middle, c], axis=1), np.stack([middle, b, c], axis=1)])
        owner = np.tile(owner, 2)
    return np.concatenate(done), np.concatenate(owners)


def to_triangles(points, corners):
    """Distances of (..., 3) points to (..., 3, 3) triangles, and the weights of the corners at the nearest places."""
    first = corners[..., 0, :]
    u, w, v = corners[..., 1, :] - first, corners[..., 2, :] - first, points - first
    uu, uw, ww, uv, wv, vv = (np.einsum("...k,...k->...", x, y) for x, y in ((u, u), (u, w), (w, w), (u, v), (w, v), (v, v)))
    square = np.maximum(uu * ww - uw * uw, 1e-300)
    s, t = (ww * uv - uw * wv) / square, (uu * wv - uw * uv) / square
    best = np.where((s >= 0) & (t >= 0) & (s + t <= 1), vv - s * uv - t * wv, np.inf)
    along, other = wv - uv - uw + uu, uu - 2 * uw + ww  # of the side opposite to the first corner
    on_u, on_w, on_other = (np.clip(x / np.maximum(y, 1e-300), 0, 1) for x, y in ((uv, uu), (wv, ww), (along, other)))
    for square, on in ((vv - 2 * on_u * uv + on_u * on_u * uu, (on_u, 0)), (vv - 2 * on_w * wv + on_w * on_w * ww, (0, on_w)),
                       (vv - 2 * uv + uu - 2 * on_other * along + on_other * on_other * other, (1 - on_other, on_other))):
        is_nearer = square < best
        best, s, t = np.where(is_nearer, square, best), np.where(is_nearer, on[0], s), np.where(is_nearer, on[1], t)
    return np.sqrt(np.maximum(best, 0)), np.stack([1 - s - t, s, t], axis=-1)


class PatchNormals:
    """Normals of the surface at its vertices, of each patch apart, from the angles of the triangles around them."""

    def __init__(self, features):
        model = features.model
        corners = model.corners()
        out, back = np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners
        angles = np.arctan2(np.linalg.norm(np.cross(out, back), axis=2), (out * back).sum(axis=2))
        keys = features.patch_of[:, None] * len(model.points) + model.triangles
        _, self.key = np.unique(keys, return_inverse=True)
        self.key = self.key.reshape(-1, 3)
        self.normals = np.zeros((self.key.max() + 1, 3))
        np.add.at(self.normals, self.key, angles[..., None] * model.normals[:, None])
        self.normals /= np.maximum(np.linalg.norm(self.normals, axis=1, keepdims=True), 1e-300)

    def at(self, triangles, weights):
        normals = (self.normals[self.key[triangles]] * weights[..., None]).sum(axis=1)
        return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)


class SurfaceDistances:
    """`mesh_to_model` and `model_to_mesh`, each with `distances`, what is `excess` beyond what straight edges cut off, areas as `weights`
    and `places`; `face_of_quad`, the face of the model that each quad lies on."""

    def __init__(self, features, points, quads, sagittas):
        self.features, self.size, self.corners = features, features.size, points[quads]
        model = features.model
        self.nearest = NearestTriangle(model.corners(), self.size / 2)
        grid = np.einsum("gk,qkd->qgd", WEIGHTS, self.corners)
        _, first, inverse = np.unique(np.round(grid.reshape(-1, 3) / (1e-9 * self.size)), axis=0, return_index=True, return_inverse=True)
        distances, triangles, _ = self.nearest.query(grid.reshape(-1, 3)[first])
        distances, triangles = distances[inverse], triangles[inverse].reshape(len(quads), -1)
        self.assign(grid, triangles)
        self.allowances = self.cut_off() + self.along_creases(quads, sagittas)
        areas = quad_areas(self.corners)
        self.mesh_to_model = self.figures(distances, np.repeat(self.allowances, len(UV)), np.repeat(areas / len(UV), len(UV)),
                                          grid.reshape(-1, 3))
        parts = grid[:, TRIANGLES].reshape(-1, 3, 3)
        pieces = self.nearest.pieces
        ends = np.unique(pieces.reshape(-1, 3), axis=0)
        samples = np.concatenate([pieces.mean(axis=1), ends])
        sides = pieces[:, 1:] - pieces[:, :1]
        weights = np.concatenate([np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1) / 2, np.zeros(len(ends))])
        distances, nearest, _ = NearestTriangle(parts, self.size).query(samples)
        self.model_to_mesh = self.figures(distances, self.allowances[nearest // len(TRIANGLES)], weights, samples)
        self.quad_areas = areas

    def assign(self, grid, triangles):
        """Each quad to the face that most of its inner samples are nearest to, among those that look its way."""
        inner = np.flatnonzero(((UV > 0) & (UV < 1)).all(axis=1))
        a, b, c, d = np.moveaxis(self.corners, 1, 0)
        normals = np.cross(c - a, d - b)
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        candidates = triangles[:, inner]
        agree = (self.features.model.normals[candidates] * normals[:, None]).sum(axis=2)
        faces = self.features.face_of[candidates]
        votes = np.where(faces[:, :, None] == faces[:, None], np.maximum(agree, 1e-3)[:, None], 0).sum(axis=2)
        best = votes.argmax(axis=1)
        rows = np.arange(len(faces))
        self.face_of_quad, self.patch_of_quad = faces[rows, best], self.features.patch_of[candidates[rows, best]]

    def cut_off(self):
        """What a quad cuts off of its smooth patch: k e^2 / 8 for both diagonals, e the side of the square with that diagonal. That is
        the depth of the middle of a parallelogram whose corners lie on a quadric; k d^2 is the change of normals along a diagonal d."""
        normals = PatchNormals(self.features)
        found = np.zeros(len(self.corners))
        for patch in np.unique(self.patch_of_quad):
            quads = np.flatnonzero(self.patch_of_quad == patch)
            triangles = np.flatnonzero(self.features.patch_of == patch)
            search = NearestTriangle(self.features.model.corners()[triangles], self.size / 2)
            corners = self.corners[quads]
            _, nearest, weights = search.query(corners.reshape(-1, 3))
            at = normals.at(triangles[nearest], weights).reshape(-1, 4, 3)
            for one, other in ((0, 2), (1, 3)):
                change = ((corners[:, other] - corners[:, one]) * (at[:, other] - at[:, one])).sum(axis=1)
                found[quads] += np.abs(change) / 16
        return found

    @staticmethod
    def along_creases(quads, sagittas):
        """The most that an edge of each quad cuts off of a crease."""
        edges = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2), axis=2)
        return np.array([max(sagittas.get(tuple(edge), 0.0) for edge in quad) for quad in edges.tolist()])

    def figures(self, distances, allowances, weights, places):
        excess = np.maximum(distances - allowances, 0)
        worst, worst_excess = int(distances.argmax()), int(excess.argmax())
        return {"most": distances[worst] / self.size, "p99": weighted_percentile(distances, weights, 0.99) / self.size,
                "excess_most": excess[worst_excess] / self.size, "excess_p99": weighted_percentile(excess, weights, 0.99) / self.size,
                "place": places[worst].tolist(), "excess_place": places[worst_excess].tolist()}


def quad_areas(corners):
    """Of the four triangles between the middle and the sides."""
    middle = corners.mean(axis=1, keepdims=True)
    return np.linalg.norm(np.cross(corners - middle, np.roll(corners, -1, axis=1) - middle), axis=2).sum(axis=1) / 2


def weighted_percentile(values, weights, share):
    order = np.argsort(values)
    total = np.cumsum(weights[order])
    return float(values[order[np.searchsorted(total, share * total[-1])]])
