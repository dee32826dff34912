#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The seamless map of seamless_map.py on fields whose map is known, and against a dense solution without gauge or cut."""

import json
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import poisson_map
import tet_solids
from frame_math import CUBE_ROTATIONS
from judge_mesh import IDENTITY, TET_FACES, TetField, number_of
from program import medit_text, tet_box, tilt
from seamless_map import Elimination, MatchedField, SeamlessMap

ROUNDING = 1e-8  # of determinants, from the residual of the solution


def rotations_about_z(angles):
    c, s, zero = np.cos(angles), np.sin(angles), np.zeros_like(angles)
    return np.stack([np.stack([c, s, zero], -1), np.stack([-s, c, zero], -1), np.stack([zero, zero, zero + 1], -1)], -2)


def three_kites(times=1):
    """A prism over an equilateral triangle, and axes that turn by a quarter around the line through its middle."""
    outline = [(0, 0)] + [(np.cos(a), np.sin(a)) for a in np.pi / 6 * np.array([-1, 3, 7])]
    points, tets = tet_solids.refined(*tet_solids.prism(outline, 1, [(0, 1, 2), (0, 2, 3), (0, 3, 1)]), times)
    centre = points[tets].mean(axis=1)
    return points, tets, rotations_about_z((np.arctan2(centre[:, 1], centre[:, 0]) + np.pi / 2) / 4)


def nearest_rows(points, tets, axes):
    return rows_of(TetField(points, tets, np.swapaxes(axes, 1, 2)))


def rows_of(field):
    """The rows of a .perm file of a field's matchings."""
    tet, corner = np.nonzero((field.beside > np.arange(len(field.tets))[:, None]) & (field.matching != IDENTITY))
    rotation = CUBE_ROTATIONS[field.matching[tet, corner]]
    place = np.argmax(np.abs(rotation), axis=1)
    sign = np.take_along_axis(rotation, place[:, None, :], axis=1)[:, 0]
    return np.concatenate([np.stack([tet, field.beside[tet, corner]], axis=1), sign * (place + 1)], axis=1).astype(int)


def renamed(rows, field, names):
    """The matchings after the axes of each tet got other names, as rotations of the cube by number."""
    other = MatchedField(field.points, field.tets, np.swapaxes(field.frames, 1, 2), rows)
    g = CUBE_ROTATIONS[names]
    turned = number_of(g[other.beside] @ CUBE_ROTATIONS[other.matching] @ np.swapaxes(g, 1, 2)[:, None])
    other.matching = np.where(other.beside >= 0, turned, IDENTITY)
    return rows_of(other)


class DenseMap:
    """Determinants of the map with all coordinates of all corners, and a translation at each inner face, as unknowns."""

    def __init__(self, field):
        self.field = field
        tet, corner = np.nonzero(field.beside > np.arange(len(field.tets))[:, None])
        self.face, self.first = {}, 12 * len(field.tets)
        for number, (t, c) in enumerate(zip(tet.tolist(), corner.tolist())):
            other = int(field.beside[t, c])
            self.face[t, c] = (number, True)
            self.face[other, field.beside[other].tolist().index(t)] = (number, False)
        self.size = self.first + 3 * len(tet)
        equations = [*self.of_faces(), *self.of_edges(), *self.of_surface()]
        _, values, rows = np.linalg.svd(np.array(equations))
        self.null_space = rows[(values > 1e-9).sum():].T
        self.solve()

    def u(self, tet, vertex):
        corner = self.field.tets[tet].tolist().index(vertex)
        return np.eye(self.size)[12 * tet + 3 * corner:][:3]

    def across(self, tet, corner, forms):
        """Forms in the frame of a tet, in that of the one beyond a face: u' = g u + t."""
        number, forward = self.face[tet, corner]
        g = CUBE_ROTATIONS[self.field.matching[tet, corner]]
        t = np.eye(self.size)[self.first + 3 * number:][:3]
        return g @ forms + t if forward else g @ (forms - t)

    def of_faces(self):
        for (tet, corner), (_, forward) in self.face.items():
            if forward:
                for vertex in np.delete(self.field.tets[tet], corner):
                    yield from self.across(tet, corner, self.u(tet, vertex)) - self.u(self.field.beside[tet, corner], vertex)

    def of_edges(self):
        """The way around an edge brings a point back to itself: its ends if it is singular, all space if not."""
        field, singular = self.field, self.field.singular_edges()
        for edge in np.flatnonzero(field.inside):
            start = int(field.first[edge])
            points = [self.u(start // 6, vertex) for vertex in field.edges[edge]]
            for point in points if edge in singular else [*points, np.zeros((3, self.size))]:
                image = point
                for slot in field.way(start):
                    image = self.across(slot // 6, int(field.leaving[slot]), image)
                yield from image - point

    def of_surface(self):
        field = self.field
        for tet, face, normal in zip(field.surface_tets, field.surface, field.normals):
            axis = int(np.argmax(np.abs(field.frames[tet].T @ normal)))
            for vertex in face[1:]:
                yield self.u(tet, vertex)[axis] - self.u(tet, face[0])[axis]

    def solve(self):
        field = self.field
        corners = field.points[field.tets]
        edges = corners[:, 1:] - corners[:, :1]
        weight = np.sqrt(np.linalg.det(edges))
        differences = np.zeros((len(edges), 3, 3, self.size))  # of tets: along edge e, of coordinate i
        for tet, i, e in np.ndindex(len(edges), 3, 3):
            differences[tet, e, i, 12 * tet + 3 * (e + 1) + i], differences[tet, e, i, 12 * tet + i] = 1, -1
        gradient = np.einsum("nje,neis->nijs", np.linalg.inv(edges), differences)
        matrix = (weight[:, None, None, None] * gradient).reshape(-1, self.size) @ self.null_space
        target = (weight[:, None, None] * np.swapaxes(field.frames, 1, 2)).ravel()
        found = self.null_space @ np.linalg.lstsq(matrix, target, rcond=1e-10)[0]
        self.determinants = np.linalg.det(gradient @ found)


class KnownMaps(unittest.TestCase):
    def test_of_a_box_with_constant_frames_is_the_identity(self):
        points, tets = tet_box()
        found = SeamlessMap(MatchedField(points @ tilt(), tets, np.repeat(tilt()[None], len(tets), 0), None))
        np.testing.assert_allclose(found.determinants, 1, atol=ROUNDING)
        np.testing.assert_allclose(found.jacobians, np.swapaxes(found.cut.frames, 1, 2), atol=ROUNDING)
        self.assertFalse(found.cut.singular.any())

    def test_of_three_kites_has_no_flip(self):
        points, tets, axes = three_kites(2)
        found = SeamlessMap(MatchedField(points, tets, axes, None))
        on_line = np.hypot(points[:, 0], points[:, 1]) < 1e-9
        np.testing.assert_array_equal(found.cut.singular, on_line[found.field.edges].all(axis=1))
        self.assertGreater(found.determinants.min(), 0.3)

    def test_is_the_dense_one_on_three_kites(self):
        field = MatchedField(*three_kites(1), None)
        self.assertEqual(len(field.singular_edges()), 2)
        np.testing.assert_allclose(SeamlessMap(field).determinants, DenseMap(field).determinants, atol=ROUNDING)

    def test_is_the_dense_one_with_any_matchings(self):
        points, tets = tet_box((2, 2, 2))
        axes = np.repeat(np.eye(3)[None], len(tets), 0)
        for seed in range(2):
            field = TetField(points, tets, axes)
            inner = np.argwhere(field.beside > np.arange(len(tets))[:, None])
            for tet, corner in np.random.default_rng(seed).permutation(inner)[:4]:
                field.matching[tet, corner] = 1 + (IDENTITY + 7 * seed) % 23
            field = MatchedField(points, tets, axes, rows_of(field))
            self.assertGreater(len(field.singular_edges()), 4)
            np.testing.assert_allclose(SeamlessMap(field).determinants, DenseMap(field).determinants, atol=ROUNDING)

    def test_does_not_depend_on_the_names_of_axes(self):
        points, tets, axes = three_kites(2)
        rows = nearest_rows(points, tets, axes)
        field = MatchedField(points, tets, axes, rows)
        names = np.random.default_rng(1).integers(24, size=len(tets))
        other = MatchedField(points, tets, CUBE_ROTATIONS[names] @ axes, renamed(rows, field, names))
        np.testing.assert_allclose(SeamlessMap(other).determinants, SeamlessMap(field).determinants, atol=ROUNDING)

    def test_follows_the_matchings_given_and_not_the_frames(self):
        points, tets, axes = three_kites(2)
        rows = nearest_rows(points, tets, axes)
        turns = rotations_about_z(np.random.default_rng(2).uniform(-1, 1, len(tets)))
        shaken = SeamlessMap(MatchedField(points, tets, axes @ turns, rows)).cut.singular
        np.testing.assert_array_equal(shaken, SeamlessMap(MatchedField(points, tets, axes, rows)).cut.singular)
        self.assertTrue((SeamlessMap(MatchedField(points, tets, axes @ turns, None)).cut.singular != shaken).any())

    def test_is_flat_beside_a_face_that_is_turned(self):
        points, tets = tet_box((4, 4, 4))
        axes = np.repeat(np.eye(3)[None], len(tets), 0)
        field = TetField(points, tets, axes)
        inside = ~field.on_surface[field.tets[:, TET_FACES]].any(axis=2)
        tet, corner = np.argwhere(inside & (field.beside >= 0))[0]
        found = SeamlessMap(MatchedField(points, tets, axes, np.array([[tet, field.beside[tet, corner], 2, -1, 3]])))
        self.assertEqual(found.cut.singular.sum(), 3)
        np.testing.assert_allclose(found.determinants[[tet, field.beside[tet, corner]]], 0, atol=ROUNDING)

    def test_refuses_reflections_and_tets_that_are_no_neighbours(self):
        points, tets = tet_box()
        axes = np.repeat(np.eye(3)[None], len(tets), 0)
        other = int(TetField(points, tets, axes).beside[0].max())
        for row in ([0, other, -1, 2, 3], [0, len(tets) - 1, 1, 2, 3]):
            with self.assertRaises(ValueError):
                MatchedField(points, tets, axes, np.array([row]))


class Eliminations(unittest.TestCase):
    def test_leave_the_null_space_of_all_equations(self):
        rng = random.Random(3)
        for _ in range(50):
            size, count = rng.randint(2, 8), rng.randint(1, 8)
            rows = np.array([[rng.choice((0, 0, 0, 1, -1, 2, 3)) for _ in range(size)] for _ in range(count)])
            elimination = Elimination()
            for row in rows:
                elimination.impose({i: int(x) for i, x in enumerate(row) if x})
            forms = [elimination.reduced({i: 1}) for i in range(size)]
            left = sorted({unknown for form in forms for unknown in form})
            basis = np.array([[float(form.get(unknown, 0)) for unknown in left] for form in forms]).reshape(size, -1)
            np.testing.assert_allclose(rows @ basis, 0, atol=1e-12)
            rank = np.linalg.matrix_rank(rows)
            self.assertEqual((len(left), np.linalg.matrix_rank(basis) if left else 0), (size - rank, size - rank))


class OffAxisFaces(unittest.TestCase):
    def counted(self, corner_of_face, degrees):
        """Of a box where the frame of one boundary tet is turned about the z axis."""
        points, tets = tet_box((4, 4, 4), (1, 1, 1))
        axes = np.repeat(np.eye(3)[None], len(tets), 0)
        field = TetField(points, tets, axes)
        tet = field.surface_tets[[sorted(face) for face in field.surface.tolist()].index(corner_of_face(field))]
        axes[tet] = rotations_about_z(np.radians(degrees))
        return poisson_map.off_axis(MatchedField(points, tets, axes, None))

    def middle(self, field):
        """A face at x = 1 that meets no edge of the box."""
        inside = (np.abs(field.points[field.surface][..., 1:] - 0.5) < 0.4).all(axis=(1, 2))
        return sorted(field.surface[inside & (field.normals[:, 0] > 0.9)][0].tolist())

    def rim(self, field):
        """A face at x = 1 with an edge of the box along y."""
        low = (field.points[field.surface][..., 2] < 1e-9).sum(axis=1) == 2
        return sorted(field.surface[low & (field.normals[:, 0] > 0.9)][0].tolist())

    def test_are_counted_beyond_ten_degrees_apart_at_creases(self):
        self.assertEqual(self.counted(self.middle, 9), (0, 0))
        self.assertEqual(self.counted(self.middle, 11), (1, 0))
        self.assertEqual(self.counted(self.rim, 11), (0, 1))


class Command(unittest.TestCase):
    def test_says_the_same_of_files_and_of_folders(self):
        points, tets, axes = three_kites(2)
        rows = nearest_rows(points, tets, axes)
        with tempfile.TemporaryDirectory(prefix="crossgrain-poisson-") as folder:
            for name in ("before/kites", "after/kites"):
                path = Path(folder) / name
                path.mkdir(parents=True)
                (path / "onto.mesh").write_text(medit_text(points, tets))
                lines = [" ".join(f"{2 * x:.17g}" for x in axis) for axis in axes.reshape(-1, 3)]  # scaled, as for CubeCover
                (path / "onto.fra").write_text("\n".join(["FRA 1", f"{len(tets)} 3 1", *lines, ""]))
                lines = [" ".join(map(str, row)) for row in rows.tolist()]
                (path / "onto.perm").write_text("\n".join(["PERM 1", f"{len(tets)} {len(rows)} 3", *lines, ""]))
            one = json.loads(self.printed(path))
            other = json.loads(self.printed(*(path / f"onto.{kind}" for kind in ("mesh", "fra", "perm"))))
            table = self.printed("--compare", *(Path(folder) / name for name in ("before", "after")))
        for figures in (one, other):
            del figures["seconds"]
        self.assertEqual(one, other)
        self.assertEqual((one["tets"], one["singular_edges"], one["flips"]), (len(tets), 4, 0))
        self.assertIn(f"| kites | {len(tets)} → {len(tets)} | 4 → 4 |", table)

    def printed(self, *arguments):
        command = [sys.executable, str(Path(__file__).with_name("poisson_map.py")), *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout


if __name__ == "__main__":
    unittest.main()
