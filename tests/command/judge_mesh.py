# SPDX-License-Identifier: Apache-2.0
"""A field on tets as `solve X --write quaternions` writes it: tets, surface, the tets around each edge, and matchings.

Nothing here is taken from the program but the files: onto.vtu for points and tets, onto_tets.quaternions for frames.
"""

from pathlib import Path

import numpy as np

from field_reader import read_arrays
from frame_math import CUBE_ROTATIONS

# Edges of a tet of positive volume: about the direction from i to j it spans, right-handed, the way from k to l.
TET_EDGES = np.array([(0, 1, 2, 3), (0, 2, 3, 1), (0, 3, 1, 2), (1, 2, 0, 3), (1, 3, 2, 0), (2, 3, 0, 1)])
# The face opposite each vertex, its normal outward.
TET_FACES = np.array([(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)])

IDENTITY = int(np.argmax([np.trace(g) for g in CUBE_ROTATIONS]))


def number_of(rotations):
    """The numbers of cube rotations (..., 3, 3), or of those nearest to other matrices."""
    return np.argmax(np.einsum("gij,...ij->...g", CUBE_ROTATIONS, rotations), axis=-1)


PRODUCTS = number_of(np.einsum("aij,bjk->abik", CUBE_ROTATIONS, CUBE_ROTATIONS))


def rotations_of(quaternions):
    """Matrices with the axes of each frame as columns."""
    w, x, y, z = quaternions.T
    return np.stack([np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)], -1),
                     np.stack([2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)], -1),
                     np.stack([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], -1)], -2)


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def read_field(folder):
    """The TetField of a folder."""
    arrays = read_arrays(Path(folder) / "onto.vtu")
    return TetField(arrays["Points"].reshape(-1, 3), arrays["connectivity"].reshape(-1, 4),
                    rotations_of(np.loadtxt(Path(folder) / "onto_tets.quaternions", ndmin=2)))


class TetField:
    """`points`, `tets` of positive volume, `frames` with axes as columns.

    beside[t, k] is the tet across the face opposite vertex k, -1 at the surface, and matching[t, k] the cube rotation g that
    makes a vector with components c in the frame of t one with components g c in the frame of that tet.

    edges has the ascending pairs of vertices. A slot is an edge of one tet, 6 t + its number in TET_EDGES; edge_of, begin and
    end have its edge and the vertices k and l between which, right-handed about the edge, the tet lies. after[slot] is the
    next slot around the edge, -1 at the surface, and turn[slot] the matching on the way there. sectors are the slots after
    the surface: one at each of its edges, where the solid does not touch itself.
    """

    def __init__(self, points, tets, frames):
        self.points, self.tets, self.frames = np.array(points, float), np.array(tets, int), frames
        corners = self.points[self.tets]
        inverted = np.linalg.det(corners[:, 1:] - corners[:, :1]) < 0
        self.tets[inverted] = self.tets[inverted][:, [0, 1, 3, 2]]
        self.find_faces()
        self.find_surface()
        self.find_edges()
        self.find_sizes()

    def find_faces(self):
        count = len(self.tets)
        faces = np.sort(self.tets[:, TET_FACES], axis=2).reshape(-1, 3)
        order = np.lexsort(faces.T)
        same = (faces[order[1:]] == faces[order[:-1]]).all(axis=1)
        one, other = order[:-1][same], order[1:][same]
        beside = np.full(4 * count, -1)
        beside[one], beside[other] = other // 4, one // 4
        self.beside = beside.reshape(count, 4)
        inner = np.flatnonzero(beside >= 0)
        here, there = self.frames[inner // 4], self.frames[beside[inner]]
        matching = np.full(4 * count, IDENTITY)
        matching[inner] = number_of(np.einsum("nji,njk->nik", there, here))
        self.matching = matching.reshape(count, 4)

    def find_edges(self):
        ways = self.tets[:, TET_EDGES].reshape(-1, 4)
        leaving = np.tile(TET_EDGES[:, 2], len(self.tets))  # the way leaves through the face opposite its begin
        entering = np.tile(TET_EDGES[:, 3], len(self.tets))
        back = ways[:, 0] > ways[:, 1]
        ways[back] = ways[back][:, [1, 0, 3, 2]]
        leaving, entering = np.where(back, entering, leaving), np.where(back, leaving, entering)
        self.leaving, self.entering = leaving, entering
        self.edges, self.edge_of = np.unique(ways[:, :2], axis=0, return_inverse=True)
        self.edge_of = self.edge_of.ravel()
        self.begin, self.end = ways[:, 2], ways[:, 3]
        tet = np.arange(len(ways)) // 6
        following = self.beside[tet, leaving]
        slots = 6 * following[:, None] + np.arange(6)
        place = np.argmax(self.edge_of[slots] == self.edge_of[:, None], axis=1)
        self.after = np.where(following >= 0, 6 * following + place, -1)
        self.turn = self.matching[tet, leaving]
        self.number = {tuple(edge): i for i, edge in enumerate(self.edges.tolist())}
        self.length = np.linalg.norm(self.points[self.edges[:, 1]] - self.points[self.edges[:, 0]], axis=1)
        self.first = np.full(len(self.edges), -1)
        self.first[self.edge_of[::-1]] = np.arange(len(ways))[::-1]
        self.sectors = np.flatnonzero(self.beside[tet, entering] < 0)
        self.inside = np.ones(len(self.edges), bool)
        self.inside[self.edge_of[self.sectors]] = False

    def find_surface(self):
        tet, corner = np.nonzero(self.beside < 0)
        self.surface = self.tets[tet[:, None], TET_FACES[corner]]
        self.surface_tets = tet
        a, b, c = np.moveaxis(self.points[self.surface], 1, 0)
        double = np.cross(b - a, c - a)
        self.area = np.linalg.norm(double, axis=1) / 2
        self.normals = unit(double)
        self.face_of = np.full((len(self.tets), 4), -1)
        self.face_of[tet, corner] = np.arange(len(tet))
        self.on_surface = np.zeros(len(self.points), bool)
        self.on_surface[self.surface] = True

    def find_sizes(self):
        """Sizes of cells: inside, the mean edge of the tets at an edge; on the surface, the mean of its edges at a vertex."""
        of_tets = self.length[self.edge_of].reshape(-1, 6).mean(axis=1)
        self.edge_size = np.bincount(self.edge_of, np.repeat(of_tets, 6)) / np.bincount(self.edge_of)
        ends = self.edges[~self.inside]
        count = np.bincount(ends.ravel(), minlength=len(self.points))
        sums = np.bincount(ends.ravel(), np.repeat(self.length[~self.inside], 2), len(self.points))
        self.surface_size = sums / np.maximum(1, count)

    def faces_beside_sectors(self):
        """The last slot of the way from each of `sectors`, and the faces of the surface where these ways begin and end."""
        last = self.sectors.copy()
        while (going := self.after[last] >= 0).any():
            last[going] = self.after[last[going]]
        return last, self.face_of[self.sectors // 6, self.entering[self.sectors]], self.face_of[last // 6, self.leaving[last]]

    def way(self, slot):
        """The slots from one around its edge, to the surface or until they repeat."""
        slots = [slot]
        while self.after[slots[-1]] >= 0 and self.after[slots[-1]] != slot:
            slots.append(int(self.after[slots[-1]]))
        return slots

    def singular_edges(self):
        """{edge: number of the product of the matchings around it}, of edges inside where that is not the identity; the
        product is in the frame of the tet of first[edge]."""
        closed = np.flatnonzero(self.inside)
        start = self.first[closed]
        product, slot, going = np.full(len(closed), IDENTITY), start.copy(), np.ones(len(closed), bool)
        while going.any():
            product[going] = PRODUCTS[self.turn[slot[going]], product[going]]
            slot[going] = self.after[slot[going]]
            going &= slot != start
        return {int(e): int(g) for e, g in zip(closed, product) if g != IDENTITY}

    def unfollowed_share(self, degrees):
        """Share of the surface's area whose normal is further than this from the axes of its tet's frame."""
        cosine = np.abs(np.einsum("nij,ni->nj", self.frames[self.surface_tets], self.normals)).max(axis=1)
        return float(self.area[np.degrees(np.arccos(np.clip(cosine, 0, 1))) > degrees].sum() / self.area.sum())
