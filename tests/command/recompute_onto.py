#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Recomputes the numbers that `onto` of report.json has, from the mesh and onto.frames alone, with formulas other than
the program's: energies from gradients of coefficients in each tet, singular faces from matchings of axes.

    recompute_onto.py MESH.mesh FOLDER

Meshes without faults, and text as `crossgrain` and tests write it: a keyword a line.
"""

import json
import sys
from pathlib import Path

import numpy as np

from field_reader import read_arrays
from frame_math import coefficients, matching
from recompute_singularity import graph_faults

SMOOTH_DEG = 15
ARC_COSINE_DEG = 2e-6  # what the arc cosine of a double leaves of a small angle


def read_medit(path):
    """Vertices and tets numbered from 0, of positive volume."""
    lines = [line.strip() for line in Path(path).read_text().split("\n")]

    def section(keyword):
        begin = lines.index(keyword) + 2
        return np.array([row.split() for row in lines[begin:begin + int(lines[begin - 1])]], float)

    vertices, tets = section("Vertices")[:, :3], section("Tetrahedra")[:, :4].astype(int) - 1
    edges = vertices[tets[:, 1:]] - vertices[tets[:, :1]]
    inverted = np.linalg.det(edges) < 0
    tets[inverted] = tets[inverted][:, [0, 1, 3, 2]]
    return vertices, tets


def angles_deg(cosines):
    return np.degrees(np.arccos(np.clip(cosines, 0, 1)))


def summary(angles):
    if len(angles) == 0:
        return None, None, None
    return angles.mean(), np.percentile(angles, 95), angles.max()


class OntoRecomputation:
    def __init__(self, mesh, folder):
        self.folder = Path(folder)
        self.vertices, self.tets = read_medit(mesh)
        self.axes = np.loadtxt(Path(folder) / "onto.frames").reshape(-1, 3, 3)
        assert len(self.axes) == len(self.vertices)
        identity = np.eye(3)
        assert np.abs(self.axes @ np.swapaxes(self.axes, 1, 2) - identity).max() < 1e-14
        assert np.abs(np.linalg.det(self.axes) - 1).max() < 1e-14
        self.find_faces()

    def find_faces(self):
        corners = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])
        faces = self.tets[:, corners].reshape(-1, 3)
        _, index, count = np.unique(np.sort(faces, 1), axis=0, return_index=True, return_counts=True)
        self.inner, self.boundary = faces[index[count == 2]], faces[index[count == 1]]

    def dirichlet(self):
        """1/2 sum over tets of volume |grad h|^2."""
        h = coefficients(4, self.axes)
        edges = self.vertices[self.tets[:, 1:]] - self.vertices[self.tets[:, :1]]
        gradients = np.linalg.solve(edges, h[self.tets[:, 1:]] - h[self.tets[:, :1]])
        return float(((np.linalg.det(edges) / 6) * (gradients**2).sum(axis=(1, 2))).sum() / 2)

    def edge_sum(self):
        pairs = self.tets[:, [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]].reshape(-1, 2)
        pairs = np.unique(np.sort(pairs, 1), axis=0)
        h = coefficients(4, self.axes)
        return float(((h[pairs[:, 0]] - h[pairs[:, 1]]) ** 2).sum())

    def singular(self, faces):
        """Faces around which the matchings of neighbouring frames do not come to the identity."""
        count = 0
        for a, b, c in np.sort(faces, 1):
            turn = matching(self.axes[c], self.axes[a]) @ matching(self.axes[b], self.axes[c]) @ \
                matching(self.axes[a], self.axes[b])
            count += np.trace(turn) < 2.99
        return count

    def singular_edges(self):
        """How many edges inside have tets all around whose frames, matched one to the next, do not come back as they were;
        and their length."""
        arrays = read_arrays(self.folder / "onto.vtu")
        cells = len(arrays["offsets"])
        # The tets of the file, which are those of the mesh; point data come first under the same names.
        axes = np.stack([arrays[f"axis_{name}"][-cells:] for name in "uvw"], axis=1).astype(float)
        corners = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])
        faces = {}
        for tet, vertices in enumerate(np.sort(self.tets[:, corners], 2)):
            for face in vertices.tolist():
                faces.setdefault(tuple(face), []).append(tet)
        across, at_edge = {}, {}
        for (a, b, c), tets in faces.items():
            for edge in ((a, b), (a, c), (b, c)):
                at_edge.setdefault(edge, []).append(tets)
            if len(tets) == 2:
                p, q = tets
                across[p, q] = matching(axes[p], axes[q])
                across[q, p] = across[p, q].T
        singular = [edge for edge, pairs in at_edge.items()
                    if all(len(pair) == 2 for pair in pairs) and not self.matches_around(pairs, across)]
        return len(singular), float(sum(np.linalg.norm(self.vertices[a] - self.vertices[b]) for a, b in singular))

    @staticmethod
    def matches_around(pairs, across):
        """Whether the matchings over pairs of neighbours, which make up a ring, come to the identity."""
        next_to = {}
        for p, q in pairs:
            next_to.setdefault(p, []).append(q)
            next_to.setdefault(q, []).append(p)
        first = now = pairs[0][0]
        before, turn = next_to[first][1], np.eye(3)
        while True:
            one, other = next_to[now]
            before, now = now, other if one == before else one
            turn = across[before, now] @ turn
            if now == first:
                return np.trace(turn) > 2.99

    def alignment(self):
        """Summaries of the angles at smooth vertices and at the others."""
        a, b, c = (self.vertices[self.boundary[:, k]] for k in range(3))
        area = np.cross(b - a, c - a)
        normal = area / np.linalg.norm(area, axis=1, keepdims=True)
        at = [[] for _ in self.vertices]
        for face, vertices in enumerate(self.boundary):
            for vertex in vertices:
                at[vertex].append(face)
        smooth, others = [], []
        for vertex, faces in enumerate(at):
            if not faces:
                continue
            mean = area[faces].sum(0)
            mean /= np.linalg.norm(mean)
            if angles_deg(normal[faces] @ mean).max() < SMOOTH_DEG:
                smooth.append(np.abs(self.axes[vertex] @ mean).max())
            else:
                others += [np.abs(self.axes[vertex] @ normal[face]).max() for face in faces]
        return summary(angles_deg(np.array(smooth))), summary(angles_deg(np.array(others)))

    def evaluation(self):
        """Energies, singular faces, and angles between frames and normals, in the form of `onto` in report.json."""
        normal, crease = (dict(zip(("mean", "p95", "max"), values)) for values in self.alignment())
        return {
            "dirichlet": self.dirichlet(),
            "edge_sum": self.edge_sum(),
            "singular": {"interior_faces": self.singular(self.inner), "boundary_faces": self.singular(self.boundary)},
            "normal_deg": normal,
            "crease_deg": crease,
        }

    def disagreements(self, onto):
        """One line for each number of the report that is not what the files say."""
        normal, crease = self.alignment()
        expected = {("vertices",): (len(self.vertices), 0), ("tets",): (len(self.tets), 0)}
        for name in ("dirichlet", "edge_sum"):
            value = getattr(self, name)()
            # A field without any turn has an energy of rounding.
            expected[name,] = value, 1e-9 * value + 1e-12 * len(self.tets)
        expected["singular", "interior_faces"] = self.singular(self.inner), 0
        expected["singular", "boundary_faces"] = self.singular(self.boundary), 0
        for name, values in (("normal_deg", normal), ("crease_deg", crease)):
            for key, value in zip(("mean", "p95", "max"), values):
                expected[name, key] = value, ARC_COSINE_DEG
        faults = []
        for path, (value, tolerance) in expected.items():
            reported = onto
            for key in path:
                reported = reported[key]
            agrees = reported == value if value is None or reported is None else abs(reported - value) <= tolerance
            if not agrees:
                faults.append(f"onto.{'.'.join(path)}: {reported} in the report, {value} recomputed")
        return faults + self.singular_edge_faults(onto["singularity"])

    def singular_edge_faults(self, section):
        """The graph is in a file of its own; the edges are those around which the frames of onto.vtu do not match."""
        faults = graph_faults("onto.singularity", section, self.folder / "onto_singularities.vtu")
        count, length = self.singular_edges()
        if section["edges"] != count or abs(section["length"] - length) > 1e-9 * length:
            faults.append(f"onto.singularity: {section['edges']} edges, {count} recomputed")
        return faults


if __name__ == "__main__":
    report = json.loads((Path(sys.argv[2]) / "report.json").read_text())
    found = OntoRecomputation(sys.argv[1], sys.argv[2]).disagreements(report["onto"])
    print("\n".join(found) or "the report says what the files say")
    sys.exit(1 if found else 0)
