#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain fit`: hexahedra that roughly fill a part are put onto it, judged by independent code (hex_judge.py)."""

import json
import unittest

import numpy as np

from hex_judge import judged
from hex_judge_test import disc_points
from page_reader import Page
from program import CommandTest, box_triangles, stl_bytes

USAGE, INPUT, PARTIAL, APPROXIMATE = 2, 3, 6, 7
PLACES = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]


def blocks(cells, size, without=()):
    """Points and hexahedra of a lattice, `without` those at some places."""
    number = np.arange(np.prod(np.add(cells, 1))).reshape(np.add(cells, 1))
    points = np.stack(np.meshgrid(*[np.linspace(0, s, n + 1) for n, s in zip(cells, size)], indexing="ij"), axis=-1).reshape(-1, 3)
    places = [place for place in np.ndindex(*cells) if place not in without]
    return points, np.array([[number[tuple(np.add(place, corner))] for corner in PLACES] for place in places])


def rod(radius, height, around=16, rings=2, layers=5):
    """A square of hexahedra inside rings of them, in layers: an O-grid."""
    discs = np.array(disc_points(around, rings))
    side = around // 4
    # A corner of the square is its first point behind a diagonal.
    square = np.array([[(2 * i - side) / side, (2 * j - side) / side] for j in range(side + 1) for i in range(side + 1)]) * 0.5
    flat = np.concatenate([square, discs[1:].reshape(-1, 2)])
    rim = [int(np.argmin(np.linalg.norm(square - point, axis=1))) for point in discs[0]]

    def at(ring, k):
        return rim[k % around] if ring == 0 else len(square) + (ring - 1) * around + k % around

    quads = [[j * (side + 1) + i, j * (side + 1) + i + 1, (j + 1) * (side + 1) + i + 1, (j + 1) * (side + 1) + i]
             for j in range(side) for i in range(side)]
    quads += [[at(r, k), at(r + 1, k), at(r + 1, k + 1), at(r, k + 1)] for r in range(rings) for k in range(around)]
    points = np.concatenate([np.column_stack([radius * flat, np.full(len(flat), height * z / layers)]) for z in range(layers + 1)])
    return points, np.array([[v + (z + top) * len(flat) for top in (0, 1) for v in quad] for z in range(layers) for quad in quads])


def medit(points, hexahedra, regions=None):
    return ("MeshVersionFormatted 2\nDimension 3\nVertices\n%d\n" % len(points) + "".join("%r %r %r 0\n" % tuple(map(float, p)) for p in points)
            + "Hexahedra\n%d\n" % len(hexahedra) + "".join(" ".join(map(str, [*np.add(h, 1), region])) + "\n" for h, region in zip(hexahedra, regions or [0] * len(hexahedra))) + "End\n")


def abaqus(points, hexahedra):
    return ("*NODE\n" + "".join("%d,%r,%r,%r\n" % (k + 1, *map(float, p)) for k, p in enumerate(points)) + "*ELEMENT, TYPE=C3D8\n"
            + "".join(",".join(map(str, [k + 1, *np.add(h, 1)])) + "\n" for k, h in enumerate(hexahedra)))


def cylinder(radius, height, segments=64):
    """About z from 0, outward."""
    angles = 2 * np.pi * np.append(np.arange(segments), 0) / segments
    rim = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), np.zeros(segments + 1)])
    up = np.array([0, 0, height])
    triangles = []
    for a, b in zip(rim, rim[1:]):
        triangles += [(a, b, b + up), (a, b + up, a + up), (0 * up, b, a), (up, a + up, b + up)]
    return np.array(triangles)


def slanted_box():
    """4 x 3, and 2.3 high at x = 0, 2.7 at x = 4."""
    triangles = box_triangles((4, 3, 1))
    triangles[:, :, 2] *= 2.3 + triangles[:, :, 0] / 10
    return triangles


class FitTest(CommandTest):
    def fit(self, mesh, model, *arguments):
        return self.run_here("fit", mesh, model, "-o", "fitted", *arguments)

    def report(self):
        return json.loads((self.folder / "fitted" / "report.json").read_text())["hexahedra"]

    def judged(self, model):
        return judged(self.folder / "fitted" / "hexahedra.msh", self.folder / model, self.report()["size"])


class Fitted(FitTest):
    def test_blocks_get_the_slanted_face_of_a_box(self):
        self.write("box.stl", stl_bytes(slanted_box()))
        self.write("mesh.mesh", medit(*blocks((8, 6, 5), (4, 3, 2.5))))
        result = self.fit("mesh.mesh", "box.stl", "--unit", "mm")
        self.assert_succeeds(result)
        self.assertRegex(result.stdout, r"(?m)^model      4 x 3 x 2.7 mm from 0 0 0; 12 triangles$")
        self.assertRegex(result.stdout, r"(?m)^hexahedra  all-hex: 240 hexahedra, mean edge 0\.5")
        self.assertRegex(result.stdout, r"(?m)^features   8 of 8 corners, 12 of 12 creases, 6 of 6 faces kept$")
        self.assertRegex(result.stdout, r"(?m)^way        fitted to the model$")
        self.assertRegex(result.stdout, r"(?m)^files      fitted: report.html, hexahedra.vtu, hexahedra.mesh, hexahedra.msh, hexahedra.inp, report.json$")
        verdict = self.judged("box.stl")
        self.assertEqual(verdict.outcome, "all_hex", verdict.reasons)
        self.assertEqual(verdict.figures["creases"]["kept"], 12)
        self.assertEqual(self.report()["fit_tries"][0]["way"], "as_mapped")
        page = Page(self.folder / "fitted" / "report.html")
        self.assertEqual(page.header["hexahedra"]["total"], 240)
        self.assertEqual(set(page.arrays["surface_face"]), set(range(1, 7)))
        self.assertIn(result.stdout.split("\n")[1], self.run_here("check", "fitted").stdout)

    def test_hexahedra_that_are_inverted_are_untangled(self):
        self.write("box.stl", stl_bytes(slanted_box()))
        points, hexahedra = blocks((8, 6, 5), (4, 3, 2.5))
        random = np.random.default_rng(1)
        inside = np.flatnonzero(((points > 0.01) & (points < (3.99, 2.99, 2.49))).all(axis=1))
        points[random.choice(inside, 12, replace=False)] += random.normal(0, 0.6, (12, 3))
        self.write("mesh.mesh", medit(points, hexahedra))
        result = self.fit("mesh.mesh", "box.stl")
        self.assert_succeeds(result)
        self.assertGreater(self.report()["scaled_jacobian_before"]["inverted"], 20)
        self.assertEqual(self.judged("box.stl").outcome, "all_hex")

    def test_an_o_grid_gets_onto_a_cylinder_of_another_size_in_any_format(self):
        self.write("rod.stl", stl_bytes(cylinder(1, 2)))
        points, hexahedra = rod(0.93, 1.9)
        self.write("mesh.inp", abaqus(points, hexahedra))
        self.write("mesh.mesh", medit(points, hexahedra[:, [4, 5, 6, 7, 0, 1, 2, 3]]))  # left-handed
        outputs = []
        for mesh in ("mesh.inp", "mesh.mesh"):
            result = self.fit(mesh, "rod.stl", "--threads", str(1 + len(outputs)))
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            verdict = self.judged("rod.stl")
            self.assertEqual(verdict.outcome, "all_hex", verdict.reasons)
            outputs.append(np.array(verdict.mesh.points))
            self.assertEqual("left-handed" in result.stderr, mesh == "mesh.mesh", result.stderr)
        np.testing.assert_array_equal(*outputs)

    def test_hexahedra_keep_their_order_and_the_result_can_be_fitted_again(self):
        self.write("box.stl", stl_bytes(slanted_box()))
        points, hexahedra = blocks((4, 3, 2), (4, 3, 2.5))
        self.write("mesh.mesh", medit(points, hexahedra, [7] * 12 + [9] * 12))
        result = self.fit("mesh.mesh", "box.stl")
        self.assert_succeeds(result)
        self.assertIn("faces between the 2 regions of the mesh have moved", result.stdout)
        again = self.run_here("fit", "fitted", "box.stl", "--quiet")
        self.assertEqual((again.returncode, again.stdout, again.stderr), (0, "", ""))
        self.assertEqual(self.names(), ["box.fitted", "box.stl", "fitted", "mesh.mesh"])
        lines = (self.folder / "fitted" / "hexahedra.mesh").read_text().split("Hexahedra\n")[1].splitlines()[1:25]
        np.testing.assert_array_equal(np.array([line.split()[:8] for line in lines], int) - 1, hexahedra)
        self.assertEqual([line.split()[8] for line in lines], ["7"] * 12 + ["9"] * 12)


class Short(FitTest):
    def test_what_a_mesh_lacks_is_named_and_may_be_accepted(self):
        self.write("rod.stl", stl_bytes(cylinder(1, 2)))
        points, hexahedra = blocks((2, 2, 2), (1.4, 1.4, 2))
        self.write("mesh.mesh", medit(points - [0.7, 0.7, 0], hexahedra))
        result = self.fit("mesh.mesh", "rod.stl")
        self.assertEqual(result.returncode, APPROXIMATE, result.stdout)
        self.assertIn("approximate: ", result.stdout)
        self.assertEqual(self.fit("mesh.mesh", "rod.stl", "--accept", "approximate").returncode, 0)

    def test_thin_layers_take_little_memory(self):
        self.write("box.stl", stl_bytes(slanted_box()))
        points, hexahedra = blocks((4, 4, 4), (4, 3, 2.5))
        layers = np.array([0, 1e-5, 2e-5, 3e-5, 1])
        self.write("mesh.mesh", medit(layers[np.round(4 * points / (4, 3, 2.5)).astype(int)] * (4, 3, 2.5), hexahedra))
        result = self.fit("mesh.mesh", "box.stl", "--max-memory", "300MB", "--no-report")
        self.assertIn(result.returncode, (0, PARTIAL, APPROXIMATE), result.stderr)
        self.assertNotIn("memory", result.stderr)

    def test_a_hole_that_the_model_has_not_makes_it_partial(self):
        self.write("box.stl", stl_bytes(box_triangles((4, 3, 3))))
        self.write("mesh.mesh", medit(*blocks((4, 3, 3), (4, 3, 3), without=[(1, 1, 0), (1, 1, 1), (1, 1, 2)])))
        result = self.fit("mesh.mesh", "box.stl")
        self.assertEqual(result.returncode, PARTIAL, result.stdout)
        self.assertIn("partial: 33 hexahedra, mean edge 1; it has 1 tunnel, the model 0 tunnels",
                      result.stdout)
        self.assertTrue((self.folder / "fitted" / "hexahedra.partial.msh").exists())


class Refused(FitTest):
    def setUp(self):
        super().setUp()
        self.write("box.stl", stl_bytes(box_triangles((4, 3, 3))))

    def refused(self, mesh, *words, name="mesh.mesh", model="box.stl"):
        self.write(name, mesh)
        self.assert_fails(self.fit(name, model), INPUT, *words)
        self.assertFalse((self.folder / "fitted").exists())

    def test_are_meshes_in_another_unit_with_both_boxes(self):
        points, hexahedra = blocks((4, 3, 3), (4, 3, 3))
        self.refused(medit(25.4 * points, hexahedra), "mesh.mesh: the hexahedra reach from 0 0 0 to 101.6 76.2 76.2, the model from 0 0 0 to 4 3 3; "
                     "give both in the same unit and place")

    def test_are_hexahedra_in_one_place_with_counts(self):
        points, hexahedra = blocks((4, 3, 3), (4, 3, 3))
        self.refused(medit(points, np.concatenate([hexahedra, hexahedra[:1]])),
                     "mesh.mesh: these hexahedra are no mesh to be fitted: they have 6 faces of three or more of them, or on one side of two")

    def test_are_hexahedra_without_extent(self):
        points, hexahedra = blocks((4, 4, 4), (4, 3, 3))
        ends = np.where(points > 0.9 * points.max(axis=0), points, 0)
        for flat in (np.where(np.arange(len(points))[:, None] == 0, 1.0, 0.0) * (4, 3, 3), ends):
            self.refused(medit(flat, hexahedra), "mesh.mesh: these hexahedra are no mesh to be fitted: half of their edges have no length")

    def test_are_files_of_something_else(self):
        self.refused("solid a\n", "is named .mesh but begins like an STL file", name="mesh.mesh")
        self.refused("*NODE\n1,0,0,0\n", "the file has no hexahedra", name="mesh.inp")
        self.assert_fails(self.fit("box.stl", "mesh.inp"), USAGE, "box.stl holds no hexahedra: the mesh comes first")
        self.assert_fails(self.fit("none.mesh", "box.stl"), INPUT, "none.mesh: ")
        self.assert_fails(self.run_here("fit", "mesh.inp"), USAGE, "MODEL")


if __name__ == "__main__":
    unittest.main()
