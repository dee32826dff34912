#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Unions of boxes, cylinders and spheres at random angles, as surfaces that cross each other: `hex --lattice` ends with a documented exit
code, and what it calls all-hex is valid and fills what distances to the solids themselves tell, which no code of the program does.

CROSSGRAIN_UNIONS is the number of them, 200 by night; CROSSGRAIN_SEED the number of the first.
"""

import collections
import json
import os
import unittest

import numpy as np

from hex_judge_mesh import HexFile, are_valid
from program import NIGHTLY, CommandTest, stl_bytes

# By day two that take seconds: a box, two cylinders and a sphere, and three spheres.
UNIONS = int(os.environ.get("CROSSGRAIN_UNIONS", "200" if NIGHTLY else "2"))
SEED = int(os.environ.get("CROSSGRAIN_SEED", "1" if NIGHTLY else "8"))

ALL_HEX, INPUT, PARTIAL, APPROXIMATE = 0, 3, 6, 7
CELLS, SEGMENTS, SAMPLES = 14, 48, 40000
# In hexahedra: what the program allows, what edges cut off a sphere of the least radius, and its triangles.
MOST_OFF, MOST_VOLUME = 0.45, 0.06


def rotation(random):
    turned, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turned[0] *= np.sign(np.linalg.det(turned))
    return turned


class Solid:
    """`triangles` outward, and `distance` to the solid, negative inside."""

    def __init__(self, kind, size, frame, middle):
        self.kind, self.size, self.frame, self.middle = kind, np.asarray(size), frame, middle
        self.triangles = {"box": self.box, "cylinder": self.cylinder, "sphere": self.sphere}[kind]() @ frame + middle

    def box(self):
        x, y, z = self.size
        corners = np.array([[(-x, x)[k & 1], (-y, y)[k >> 1 & 1], (-z, z)[k >> 2]] for k in range(8)])
        quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
        return np.array([corners[[q[0], q[k], q[k + 1]]] for q in quads for k in (1, 2)])

    def cylinder(self):
        radius, half = self.size
        angles = 2 * np.pi * np.arange(SEGMENTS + 1) / SEGMENTS
        ring = np.stack([radius * np.cos(angles), radius * np.sin(angles), 0 * angles], axis=1)
        up = np.array([0, 0, half])
        triangles = []
        for a, b in zip(ring, ring[1:]):
            triangles += [(a - up, b - up, b + up), (a - up, b + up, a + up), (up, a + up, b + up), (-up, b - up, a - up)]
        return np.array(triangles)

    def sphere(self):
        rows, columns = SEGMENTS // 2, SEGMENTS
        theta, phi = np.pi * np.arange(rows + 1) / rows, 2 * np.pi * np.arange(columns) / columns
        at = np.array([[(np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)) for p in phi] for t in theta]) * self.size[0]
        at[0], at[-1] = (0, 0, self.size[0]), (0, 0, -self.size[0])
        triangles = []
        for i in range(rows):
            for j in range(columns):
                a, b, c, d = at[i, j], at[i + 1, j], at[i + 1, (j + 1) % columns], at[i, (j + 1) % columns]
                triangles += ([(a, b, d)] if i > 0 else []) + ([(b, c, d)] if i + 1 < rows else [])
        return np.array(triangles)

    def distance(self, points):
        at = (points - self.middle) @ self.frame.T
        if self.kind == "sphere":
            return np.linalg.norm(at, axis=1) - self.size[0]
        if self.kind == "cylinder":
            off = np.stack([np.hypot(at[:, 0], at[:, 1]) - self.size[0], np.abs(at[:, 2]) - self.size[1]], axis=1)
        else:
            off = np.abs(at) - self.size
        return np.linalg.norm(np.maximum(off, 0), axis=1) + np.minimum(off.max(axis=1), 0)


def random_union(seed):
    """Two to five solids, each with its middle in one before."""
    random = np.random.default_rng(seed)
    solids = []
    for _ in range(random.integers(2, 6)):
        kind = random.choice(["box", "cylinder", "sphere"])
        size = random.uniform(0.35, 1, {"box": 3, "cylinder": 2, "sphere": 1}[kind])
        frame = rotation(random)
        middle = np.zeros(3)
        if solids:
            base = solids[random.integers(len(solids))]
            middle = base.triangles[random.integers(len(base.triangles))].mean(axis=0)
        solids.append(Solid(kind, size, frame, middle))
    return solids


class Unions(CommandTest):
    def judge(self, solids, folder):
        mesh = HexFile.read(folder / "hexahedra.msh")
        report = json.loads((folder / "report.json").read_text())["hexahedra"]
        self.assertTrue(are_valid(mesh.corners()).all())
        quads, crowded = mesh.boundary()
        self.assertEqual(crowded, 0)

        def distance(points):
            return np.min([solid.distance(points) for solid in solids], axis=0)

        places = np.concatenate([mesh.points[np.unique(quads)], mesh.points[quads].mean(axis=1)])
        self.assertLess(np.abs(distance(places)).max(), MOST_OFF * report["size"])
        low, high = np.min([s.triangles.min(axis=(0, 1)) for s in solids], axis=0), np.max([s.triangles.max(axis=(0, 1)) for s in solids], axis=0)
        inside = distance(np.random.default_rng(1).uniform(low, high, (SAMPLES, 3))) < 0
        volume = inside.mean() * np.prod(high - low)
        self.assertLess(abs(mesh.volume() / volume - 1), MOST_VOLUME)

    def test_they_end_and_what_is_called_all_hex_fills_them(self):
        ends = collections.Counter()
        for seed in range(SEED, SEED + UNIONS):
            with self.subTest(seed=seed):
                solids = random_union(seed)
                self.write("parts.stl", stl_bytes(np.concatenate([solid.triangles for solid in solids])))
                result = self.run_here("hex", "parts.stl", "--lattice", "--cells", CELLS, "-o", "out", "--force", "--no-report", "--quiet")
                ends[result.returncode] += 1
                self.assertIn(result.returncode, (ALL_HEX, PARTIAL, APPROXIMATE), result.stderr)
                if result.returncode == ALL_HEX:
                    self.judge(solids, self.folder / "out")
        print(f"exit codes of {UNIONS} unions: {dict(sorted(ends.items()))}")
        self.assertGreater(ends[ALL_HEX], 0.5 * UNIONS - 1)


if __name__ == "__main__":
    unittest.main()
