#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""report.html: that it shows the field that stands in the files beside it."""

import json
import unittest

import numpy as np

from field_reader import Field
from page_reader import Page
from program import CommandTest, cylinder_triangles, medit_text, stl_bytes, tet_box, torus_triangles
from recompute_singularity import Graph

PLANE, CONFLICTED = 1, 5


class PageTest(CommandTest):
    def solve(self, name, *arguments):
        self.copied_from_first("out", (name, *arguments), lambda: self.assert_succeeds(
            self.run_here("solve", name, "-o", "out", "--quiet", *map(str, arguments))))
        self.page = Page(self.folder / "out" / "report.html")
        self.field = Field(self.folder / "out" / "field.vtu")

    def origin(self):
        return np.array(self.page.header["origin"])


class OfACylinder(PageTest):
    def setUp(self):
        super().setUp()
        self.write("cylinder.stl", stl_bytes(cylinder_triangles()))
        self.solve("cylinder.stl", "--resolution", 24)

    def test_needs_no_other_file(self):
        self.assertEqual(self.page.fetched, [])

    def test_holds_the_report(self):
        report = json.loads((self.folder / "out" / "report.json").read_text())
        # The page cannot hold its own checksum, nor that of the report, which has it.
        del report["checksum"]
        self.assertEqual(report["files"].pop()["name"], "report.html")
        self.assertEqual(self.page.report, report)

    def test_has_every_cell_with_its_place_frame_and_class(self):
        cells, arrays = self.page.header["cells"], self.page.arrays
        self.assertEqual((cells["total"], cells["shown"], cells["merged_to"]), (len(self.field),) * 2 + (None,))
        low = self.origin() + cells["low"] + cells["unit"] * arrays["cell_corner"]
        np.testing.assert_allclose(low, self.field.low, atol=1e-12)
        np.testing.assert_allclose(cells["unit"] * arrays["cell_size"], self.field.size, rtol=1e-12)
        np.testing.assert_allclose(arrays["cell_frame"] / 32767, self.field.arrays["frame"], atol=1e-4)
        np.testing.assert_array_equal(arrays["cell_class"], self.field.arrays["constraint_class"])
        for page_name, name in (("cell_energy_density", "energy_density"), ("cell_alignment_deg", "alignment_deg")):
            np.testing.assert_allclose(self.page.bfloat(page_name), self.field.arrays[name], rtol=1 / 256)

    def test_draws_the_surface_with_its_creases(self):
        arrays = self.page.arrays
        corners = arrays["surface_vertices"][arrays["surface_triangles"]].astype(float)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        asked = cylinder_triangles()
        volume = np.einsum("ij,ij->", corners[:, 0], normals) / 6
        expected = np.einsum("ij,ij->", asked[:, 0], np.cross(asked[:, 1] - asked[:, 0], asked[:, 2] - asked[:, 0])) / 6
        self.assertAlmostEqual(volume, expected, delta=1e-5 * expected)
        self.assertEqual(len(self.page.lines("crease_points", "crease_starts")), 2)

    def test_draws_the_arcs_of_the_file_of_singularities(self):
        graph = Graph(self.folder / "out" / "singularities.vtu")
        self.assertEqual(list(self.page.arrays["arc_index"]), list(graph.arrays["index"]))
        self.assertEqual(list(self.page.arrays["arc_type"]), list(graph.arrays["type"]))
        self.assertEqual(list(self.page.arrays["arc_verdict"]), list(graph.arrays["verdict"]))
        low, high = self.field.low.min(axis=0), (self.field.low + self.field.size[:, None]).max(axis=0)
        for line in self.page.lines("arc_points", "arc_starts"):
            self.assertTrue((low <= line + self.origin()).all() and (line + self.origin() <= high).all())
        arrays = self.page.arrays
        self.assertEqual(len(arrays["arc_wall"]), len(arrays["arc_points"]))
        self.assertGreater(arrays["arc_wall"].min(initial=1), 0)
        self.assertEqual(len(arrays["mark_points"]), len(arrays["mark_shape"]))
        ends = arrays["mark_directions"][arrays["mark_shape"] == 1]
        np.testing.assert_allclose(np.linalg.norm(ends, axis=1), 1, atol=1e-6)

    def test_forms_are_nothing_for_the_frame_that_meets_them(self):
        arrays = self.page.arrays
        cells = arrays["form_cell"]
        self.assertTrue((np.diff(cells.astype(int)) > 0).all())
        self.assertEqual(set(cells[arrays["cell_class"][cells] != PLANE]),
                         set(np.flatnonzero(arrays["cell_class"] > PLANE)))
        h = self.field.arrays["coefficients"][cells].astype(float)
        matrix = np.zeros((len(cells), 9, 9))
        upper = np.triu_indices(9)
        matrix[:, upper[0], upper[1]] = matrix[:, upper[1], upper[0]] = arrays["form_matrix"]
        energy = (np.einsum("ki,kij,kj->k", h, matrix, h) - 2 * np.einsum("ki,ki->k", arrays["form_linear"], h)
                  + arrays["form_constant"]) / arrays["form_weight"]
        self.assertTrue((energy > -1e-5).all())
        # (20/3) t^2 for an axis that is t off the normal; fifteen degrees are nowhere exceeded on planes.
        self.assertLess(energy[arrays["cell_class"][cells] == PLANE].max(), 20 / 3 * np.radians(15) ** 2)

    def test_has_numbers_at_the_corners_of_cells_with_surface(self):
        arrays = self.page.arrays
        self.assertEqual(set(arrays["corner_cell"]), set(np.flatnonzero(arrays["cell_class"])))
        angles = self.page.bfloat("corner_alignment_deg")
        self.assertTrue(((angles >= 0) & (angles < 55)).all())

    def test_streamlines_stay_inside(self):
        lines = self.page.lines("streamline_points", "streamline_starts")
        arrays = self.page.arrays
        self.assertEqual({len(arrays["streamline_axis"]), len(arrays["streamline_set"])}, {len(lines)})
        self.assertEqual((set(arrays["streamline_axis"]), set(arrays["streamline_set"])), ({0, 1, 2}, {0, 1}))
        self.assertGreater(len(lines), 20)
        points = np.concatenate(lines) + self.origin()
        low, high = np.array(self.page.header["low"]), np.array(self.page.header["high"])
        self.assertTrue((points >= self.origin() + low - 1e-4).all() and (points <= self.origin() + high + 1e-4).all())


class OfTets(PageTest):
    def setUp(self):
        super().setUp()
        self.vertices, self.tets = tet_box((5, 4, 4), (5.0, 4.0, 4.0))
        self.write("box.mesh", medit_text(self.vertices, self.tets))
        self.copied_from_first("out", "box.mesh", lambda: self.assert_succeeds(
            self.run_here("solve", "box.mesh", "-o", "out", "--quiet")))
        self.page = Page(self.folder / "out" / "report.html")

    def test_shows_the_tets_and_the_lines_on_them(self):
        arrays = self.page.arrays
        corners = arrays["tet_points"][arrays["tet_corners"]].astype(float)
        edges = corners[:, 1:] - corners[:, :1]
        self.assertAlmostEqual(np.linalg.det(edges).sum() / 6, 80, delta=1e-4)
        np.testing.assert_allclose(corners.mean(axis=1) + self.origin(), self.vertices[self.tets].mean(axis=1), atol=1e-5)
        np.testing.assert_allclose(np.linalg.norm(arrays["tet_frame"] / 32767, axis=1), 1, atol=1e-4)
        graph = Graph(self.folder / "out" / "onto_singularities.vtu")
        self.assertEqual(list(arrays["arc_index"]), list(graph.arrays["index"]))
        start = Graph(self.folder / "out" / "singularities.vtu")
        self.assertEqual(list(arrays["grid_arc_index"]), list(start.arrays["index"]))

    def test_has_numbers_at_each_vertex_of_the_boundary(self):
        arrays = self.page.arrays
        self.assertEqual(len(arrays["surface_triangles"]), 2 * 2 * (5 * 4 + 5 * 4 + 4 * 4))
        self.assertEqual(len(arrays["surface_alignment_deg"]), len(arrays["surface_vertices"]))
        # A box has the frames of its faces.
        self.assertLess(self.page.bfloat("surface_alignment_deg").max(), 1)


class OfALargeField(PageTest):
    def test_merges_cells_until_there_are_few_enough(self):
        self.write("torus.stl", stl_bytes(torus_triangles()))
        self.solve("torus.stl", "--resolution", 150)
        cells = self.page.header["cells"]
        self.assertEqual(cells["total"], len(self.field))
        self.assertLessEqual(cells["shown"], 200000)
        self.assertEqual(cells["shown"], len(self.page.arrays["cell_corner"]))
        volume = (self.page.arrays["cell_size"].astype(float) * cells["unit"]) ** 3
        self.assertGreaterEqual(volume.sum(), 0.999 * (self.field.size ** 3).sum())
        if cells["merged_to"]:
            self.assertAlmostEqual((self.page.arrays["cell_size"] * cells["unit"]).min(), cells["merged_to"])
            self.assertEqual(len(self.page.arrays["form_cell"]), 8000)


class WithAndWithout(PageTest):
    def setUp(self):
        super().setUp()
        self.write("torus.stl", stl_bytes(torus_triangles()))

    def test_is_the_same_whatever_the_number_of_threads(self):
        scenes = []
        for threads in (1, 2):
            self.solve("torus.stl", "--resolution", 24, "--threads", threads)
            scenes.append((self.page.header, {name: a.tobytes() for name, a in self.page.arrays.items()}))
        self.assertTrue(scenes[0] == scenes[1])

    def test_is_left_out_where_asked_and_an_earlier_one_goes(self):
        self.solve("torus.stl", "--resolution", 16)
        self.assert_succeeds(self.run_here("solve", "torus.stl", "-o", "out", "--quiet", "--resolution", "16", "--no-report"))
        self.assertFalse((self.folder / "out" / "report.html").exists())
        self.assertTrue((self.folder / "out" / "report.json").exists())

    def test_holds_a_name_that_would_end_its_elements(self):
        name = "a<script>&lt;!--.stl"
        (self.folder / "torus.stl").rename(self.folder / name)
        self.solve(name, "--resolution", 16)
        self.assertEqual(self.page.report["model"]["path"], name)


if __name__ == "__main__":
    unittest.main()
