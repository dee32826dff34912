# SPDX-License-Identifier: Apache-2.0
"""A tet mesh with tags as `crossgrain tets` writes it (Medit), read and measured by code that shares nothing with the program."""

import itertools

import numpy as np


class TaggedMesh:
    """vertices; edges, triangles and tets, from 0, with their numbers in edge_tags, triangle_tags and regions; ridges, places of
    edges."""

    def __init__(self, path):
        words = [line.split() for line in path.read_text().splitlines()]
        sections = {}
        at = 0
        while at < len(words):
            name = words[at][0] if words[at] else ""
            at += 1
            if name in ("Vertices", "Edges", "Ridges", "Triangles", "Tetrahedra"):
                count = int(words[at][0])
                sections[name] = np.array(words[at + 1:at + 1 + count], float)
                at += count + 1
        self.vertices = sections["Vertices"][:, :3]
        self.edges, self.edge_tags = self._elements(sections, "Edges", 2)
        self.triangles, self.triangle_tags = self._elements(sections, "Triangles", 3)
        self.tets, self.regions = self._elements(sections, "Tetrahedra", 4)
        self.ridges = sections.get("Ridges", np.zeros((0, 1))).astype(int)[:, 0] - 1

    @staticmethod
    def _elements(sections, name, corners):
        rows = sections.get(name, np.zeros((0, corners + 1))).astype(int)
        return rows[:, :corners] - 1, rows[:, corners]

    def volumes(self):
        a, b, c, d = (self.vertices[self.tets[:, k]] for k in range(4))
        return np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) / 6

    def mean_ratios(self):
        """12 (3 V)^(2/3) over the sum of squared edges: 1 for a regular tet."""
        squares = sum(((self.vertices[self.tets[:, i]] - self.vertices[self.tets[:, j]])**2).sum(axis=1)
                      for i, j in itertools.combinations(range(4), 2))
        return 12 * np.cbrt(3 * np.maximum(self.volumes(), 0))**2 / squares

    def radius_ratios(self):
        """Three times the radius of the inscribed sphere over that of the circumscribed one: 1 for a regular tet."""
        a, b, c, d = (self.vertices[self.tets[:, k]] for k in range(4))
        areas = sum(np.linalg.norm(np.cross(q - p, r - p), axis=1) / 2
                    for p, q, r in ((a, b, c), (a, b, d), (a, c, d), (b, c, d)))
        volumes = self.volumes()
        inner = 3 * volumes / areas
        u, v, w = b - a, c - a, d - a
        centres = ((u**2).sum(axis=1)[:, None] * np.cross(v, w) + (v**2).sum(axis=1)[:, None] * np.cross(w, u)
                   + (w**2).sum(axis=1)[:, None] * np.cross(u, v)) / (12 * volumes[:, None])
        return 3 * inner / np.linalg.norm(centres, axis=1)

    def boundary(self):
        """The faces of one tet, as sorted corners; of inner faces, those between two regions too."""
        faces = np.concatenate([np.sort(self.tets[:, list(corners)], axis=1) for corners in itertools.combinations(range(4), 3)])
        regions = np.tile(self.regions, 4)
        order = np.lexsort(faces.T[::-1])
        faces, regions = faces[order], regions[order]
        same = np.all(faces[1:] == faces[:-1], axis=1)
        is_inner = np.zeros(len(faces), bool)
        is_inner[1:] |= same & (regions[1:] == regions[:-1])
        is_inner[:-1] |= same & (regions[1:] == regions[:-1])
        return {tuple(face) for face in faces[~is_inner]}
