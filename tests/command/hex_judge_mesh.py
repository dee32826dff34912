# SPDX-License-Identifier: Apache-2.0
"""Hexahedra and the quads of their boundary as a file of Gmsh 4.1 has them, and what can be said of them without the model."""

from itertools import islice

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

# Corners: 0 1 2 3 around one face, 4 5 6 7 opposite. FACES look outward; NEIGHBOURS of each corner are right-handed.
FACES = np.array([(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])
NEIGHBOURS = np.array([(1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3)])
PLACES = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], float)  # in the unit cube

LINE, TRIANGLE, QUAD, TET, HEXAHEDRON, POINT = 1, 2, 3, 4, 5, 15  # Gmsh's types of elements
WIDTHS = {LINE: 2, TRIANGLE: 3, QUAD: 4, TET: 4, HEXAHEDRON: 8, POINT: 1}
DEEPEST = 12  # halvings of a hexahedron until its determinant's sign is known; after them it counts as invalid


class GmshFile:
    """`points` (n, 3); `elements` {type: (m, corners) from 0}; `entities` {type: (m,)}, the number of the entity of each;
    `volumes`, the surfaces around each volume; `names` {(dimension, number of the entity): name of its physical group}."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.lines = iter(file.read().split("\n"))
        self.volumes, self.names, groups, places, number_of, found = [], {}, {}, [], [], {}
        for line in self.lines:
            if line == "$MeshFormat" and not next(self.lines).startswith("4.1 0"):
                raise ValueError(f"{path} is not in text of Gmsh 4.1")
            elif line == "$PhysicalNames":
                for row in self.rows(int(next(self.lines))):
                    groups[int(row[0]), int(row[1])] = " ".join(row[2:]).strip('"')
            elif line == "$Entities":
                self.read_entities(groups)
            elif line == "$Nodes":
                for _ in range(int(next(self.lines).split()[0])):
                    count = int(next(self.lines).split()[3])
                    number_of += [int(line) for line in islice(self.lines, count)]
                    places += [line.split()[:3] for line in islice(self.lines, count)]
            elif line == "$Elements":
                for _ in range(int(next(self.lines).split()[0])):
                    _, entity, kind, count = map(int, next(self.lines).split())
                    rows = np.array([line.split()[1:] for line in islice(self.lines, count)], int).reshape(count, WIDTHS[kind])
                    found.setdefault(kind, []).append((entity, rows))
        self.points = np.array(places, float).reshape(-1, 3)
        index = np.zeros(max(number_of, default=0) + 1, int)
        index[number_of] = np.arange(len(number_of))
        self.elements = {kind: index[np.concatenate([rows for _, rows in blocks])] for kind, blocks in found.items()}
        self.entities = {kind: np.concatenate([np.full(len(rows), entity) for entity, rows in blocks]) for kind, blocks in found.items()}

    def rows(self, count):
        return [line.split() for line in islice(self.lines, count)]

    def read_entities(self, groups):
        counts = list(map(int, next(self.lines).split()))
        for dimension, count in enumerate(counts):
            for row in self.rows(count):
                at = 4 if dimension == 0 else 7
                physical = [int(word) for word in row[at + 1:at + 1 + int(row[at])]]
                self.names[dimension, int(row[0])] = " ".join(groups.get((dimension, tag), "") for tag in physical)
                if dimension == 3:
                    first = at + 2 + len(physical)
                    self.volumes.append([abs(int(word)) for word in row[first:]])


class HexFile:
    """`points`, `hexahedra` (n, 8), `quads` (m, 4) and `tags` (m,), the number of the face of each quad; 0 where the file names none."""

    def __init__(self, points, hexahedra, quads=(), tags=()):
        self.points, self.hexahedra = np.asarray(points, float), np.asarray(hexahedra, int).reshape(-1, 8)
        self.quads, self.tags = np.asarray(quads, int).reshape(-1, 4), np.asarray(tags, int)

    @classmethod
    def read(cls, path):
        file = GmshFile(path)
        tags = [tag_in(file.names.get((2, entity), "")) for entity in file.entities.get(QUAD, ())]
        return cls(file.points, file.elements.get(HEXAHEDRON, ()), file.elements.get(QUAD, ()), tags)

    def corners(self):
        return self.points[self.hexahedra]

    def volume(self):
        """Sum of the fluxes of x / 3 through the faces, which are bilinear: the mean of both ways to cut them into triangles."""
        a, b, c, d = np.moveaxis(self.points[self.hexahedra[:, FACES].reshape(-1, 4)] - self.points.mean(axis=0), 1, 0)
        return sum(np.einsum("ij,ij->", p, np.cross(q, r)) for p, q, r in ((a, b, c), (a, c, d), (a, b, d), (b, c, d))) / 12

    def scaled_jacobians(self):
        edges = self.corners()[:, NEIGHBOURS] - self.corners()[:, :, None]
        edges /= np.maximum(np.linalg.norm(edges, axis=3, keepdims=True), 1e-300)
        return np.linalg.det(edges).min(axis=1)

    def boundary(self):
        """Quads of one hexahedron, outward, and the number of quads of more than two hexahedra or on the same side of two."""
        quads = self.hexahedra[:, FACES].reshape(-1, 4)
        _, first, inverse, count = np.unique(np.sort(quads, axis=1), axis=0, return_index=True, return_inverse=True, return_counts=True)
        sides = np.zeros(len(count), int)
        np.add.at(sides, inverse, way_around(quads))
        return quads[np.sort(first[count == 1])], int(((count > 2) | ((count == 2) & (sides != 0))).sum())

    def tags_of(self, quads):
        """Those of the file's quads of the same corners; -1 where it has none."""
        tag_of = dict(zip(map(tuple, np.sort(self.quads, axis=1).tolist()), self.tags.tolist()))
        return np.array([tag_of.get(key, -1) for key in map(tuple, np.sort(quads, axis=1).tolist())], int)


def tag_in(name):
    """12 of a group called "face 12"; 0 of others."""
    words = name.split()
    return int(words[1]) if len(words) == 2 and words[0] == "face" else 0


def way_around(quads):
    """1 or -1 by the way in which each goes around from its least corner to the lower of its neighbours there."""
    turned = np.take_along_axis(quads, (quads.argmin(axis=1)[:, None] + np.arange(4)) % 4, axis=1)
    return np.where(turned[:, 1] < turned[:, 3], 1, -1)


def determinants(corners, places):
    """Of the trilinear maps of (n, 8, 3) corners at (m, 3) places of the unit cube: (n, m)."""
    u, w = places[:, None] * PLACES + (1 - places[:, None]) * (1 - PLACES), 2 * PLACES - 1
    slopes = np.stack([w[:, 0] * u[..., 1] * u[..., 2], u[..., 0] * w[:, 1] * u[..., 2], u[..., 0] * u[..., 1] * w[:, 2]], axis=1)
    return np.linalg.det(np.einsum("mak,nkc->nmac", slopes, corners))


def are_valid(corners):
    """Whether the determinant of the trilinear map of each (8, 3) is positive everywhere.

    It is quadratic in each variable, so its values at 27 places determine its 27 Bernstein coefficients, whose least is a bound. Where
    that is not positive but the corners' values are, the cube is halved in all directions.
    """
    thirds = np.stack(np.meshgrid(*[[0, 0.5, 1]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    to_bernstein = np.array([(1, 0, 0), (-0.5, 2, -0.5), (0, 0, 1)])
    coefficients = determinants(corners, thirds).reshape(-1, 3, 3, 3)
    coefficients = np.einsum("ai,bj,ck,nijk->nabc", to_bernstein, to_bernstein, to_bernstein, coefficients)
    rounding = 1e-13 * np.abs(coefficients).max(axis=(1, 2, 3), initial=0)
    owner, valid = np.arange(len(corners)), np.ones(len(corners), bool)
    first, last = np.array([(1, 0, 0), (0.5, 0.5, 0), (0.25, 0.5, 0.25)]), np.array([(0.25, 0.5, 0.25), (0, 0.5, 0.5), (0, 0, 1)])
    for depth in range(DEEPEST + 1):
        is_negative = coefficients[:, ::2, ::2, ::2].min(axis=(1, 2, 3)) <= rounding[owner]
        valid[owner[is_negative]] = False
        is_open = (coefficients.min(axis=(1, 2, 3)) <= rounding[owner]) & valid[owner]
        coefficients, owner = coefficients[is_open], owner[is_open]
        if depth == DEEPEST:
            valid[owner] = False
        parts = [np.einsum("ai,bj,ck,nijk->nabc", a, b, c, coefficients) for a in (first, last) for b in (first, last) for c in (first, last)]
        coefficients, owner = np.concatenate(parts), np.tile(owner, 8)
    return valid


def edges_of(faces):
    """All directed edges of (n, k) faces, each of which has its k edges in a row."""
    return np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)


def component_labels(count, pairs):
    pairs = np.asarray(pairs, int).reshape(-1, 2)
    return connected_components(coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(count, count)), directed=False)[1]


class ClosedSurface:
    """Topology of (n, k) faces: `shells`, sets of faces connected over edges; `euler`; `open_edges`, edges of other than two faces that
    go opposite ways; `pinched`, vertices around which faces are in more than one fan."""

    def __init__(self, faces):
        edges = edges_of(faces)
        owner = np.repeat(np.arange(len(faces)), faces.shape[1])
        keys, inverse, count = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True, return_counts=True)
        ways = np.bincount(inverse, np.where(edges[:, 0] < edges[:, 1], 1, -1), minlength=len(keys))
        self.is_open = (count != 2) | (ways != 0)
        self.open_edges = int(self.is_open.sum())
        order = np.argsort(inverse, kind="stable")
        starts = np.concatenate([[0], np.cumsum(count)])[:-1]
        two = starts[count == 2]
        self.labels = component_labels(len(faces), np.stack([owner[order[two]], owner[order[two + 1]]], axis=1))
        self.shells = int(self.labels.max(initial=-1)) + 1
        self.euler = len(np.unique(faces)) - len(keys) + len(faces)
        self.pinched = self.fans(faces, order, two) - len(np.unique(faces))

    @staticmethod
    def fans(faces, order, two):
        """The number of fans: sets of corners of faces around a vertex that are connected over edges of two faces."""
        width = faces.shape[1]
        corner = np.arange(faces.size).reshape(faces.shape)  # the edge k of a face begins at its corner k and ends at the next
        start, end = corner.reshape(-1), np.roll(corner, -1, axis=1).reshape(-1)
        one, other = order[two], order[two + 1]
        flat = faces.reshape(-1)
        same = flat[start[one]] == flat[start[other]]
        pairs = [np.stack([start[one], np.where(same, start[other], end[other])], axis=1),
                 np.stack([end[one], np.where(same, end[other], start[other])], axis=1)]
        return len(np.unique(component_labels(len(faces) * width, np.concatenate(pairs))))
