#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Hexahedra in pictures and in the page, judged from the files beside them."""

import json
import shutil
import unittest
import zlib

import numpy as np

from hex_test import medit_section, scaled_jacobians
from page_reader import Page
from program import CommandTest, medit_text, tet_box, tilt

USAGE, INPUT = 2, 3


def legend_of(path):
    """The text under the key Description of a PNG file."""
    data = path.read_bytes()
    at = 8
    while at < len(data):
        size, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        body = data[at + 8:at + 8 + size]
        if kind == b"iTXt" and body.startswith(b"Description\0"):
            packed, text = body[12], body[14:].split(b"\0", 2)[2]
            return (zlib.decompress(text) if packed else text).decode()
        at += 12 + size
    raise AssertionError(f"{path} has no description")


class HexPictures(CommandTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.shared = CommandTest()
        cls.shared.setUp()
        cls.addClassCleanup(cls.shared.doCleanups)
        vertices, tets = tet_box()
        cls.shared.write("box.mesh", medit_text(vertices @ tilt(), tets))
        result = cls.shared.run_here("hex", "box.mesh", "--size", "0.25", "--quiet", "-o", "box.hexahedra")
        assert result.returncode == 0, result.stderr

    def setUp(self):
        super().setUp()
        shutil.copytree(self.shared.folder / "box.hexahedra", self.folder / "box.hexahedra")
        mesh = self.folder / "box.hexahedra/hexahedra.mesh"
        self.vertices = medit_section(mesh, "Vertices", 4)[:, :3]
        self.corners = medit_section(mesh, "Hexahedra", 9)[:, :8].astype(int) - 1
        self.shapes = scaled_jacobians(self.vertices, self.corners)

    def render(self, *arguments):
        result = self.run_here("render", "box.hexahedra", "--hexahedra", "--size", "400x300", "-o", "a.png", *arguments)
        self.assert_succeeds(result)
        self.assertEqual(result.stderr, "")
        return legend_of(self.folder / "a.png")

    def refused(self, *arguments, code):
        result = self.run_here("render", *arguments, "-o", "none.png")
        self.assertEqual(result.returncode, code)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertNotIn("none.png", self.names())
        return result.stderr

    def test_tets_without_tags_have_no_colours_of_faces(self):
        self.assertIn("no faces", self.refused("box.hexahedra", "--hexahedra", "--colour", "face", code=INPUT))

    def test_the_legend_tells_their_number_and_the_worst_shape(self):
        legend = self.render()
        self.assertIn(f"All-hex: {len(self.corners)} hexahedra\n", legend)
        self.assertIn(f"worst {self.shapes.min():.2g}\n", legend)
        self.assertNotIn("shown", legend)

    def test_the_picture_is_named_after_the_folder_and_the_folder_stays_as_it_is(self):
        before = {path.name: path.read_bytes() for path in (self.folder / "box.hexahedra").iterdir()}
        self.assert_succeeds(self.run_here("render", "box.hexahedra", "--hexahedra", "--size", "100x80"))
        self.assertIn("box.png", self.names())
        self.assertEqual(before, {path.name: path.read_bytes() for path in (self.folder / "box.hexahedra").iterdir()})

    def test_a_cut_removes_the_hexahedra_whose_centres_are_in_front_of_it(self):
        centres = self.vertices[self.corners].mean(axis=1)
        # Views of cuts are from +x, -y and +z.
        for axis, sign in enumerate((1, -1, 1)):
            low, high = centres[:, axis].min(), centres[:, axis].max()
            for share in (0.31, 0.62):
                at = low + share * (high - low)
                expected = int((sign * centres[:, axis] < sign * at).sum())
                self.assertIn(f"\n{expected} hexahedra shown\n", self.render("--cut", f"{'xyz'[axis]}={at}"))

    def test_a_limit_leaves_those_of_worse_shapes(self):
        limit = float(np.median(self.shapes))
        expected = int((self.shapes < limit).sum())
        self.assertIn(f"\n{expected} hexahedra shown, below {limit:.3g}\n", self.render("--below", str(limit)))
        self.assertIn(f"\n{len(self.shapes)} hexahedra shown, below 2\n", self.render("--below", "2"))

    def test_a_limit_that_none_is_below_is_an_error_with_the_worst(self):
        worst = self.shapes.min()
        self.assertIn(f"no hexahedron has a scaled Jacobian below {worst - 0.1:g}: the worst has {worst:.4g}",
                      self.refused("box.hexahedra", "--below", f"{worst - 0.1:g}", code=USAGE))

    def test_they_are_drawn_where_there_are_any_unless_the_field_is_asked_for(self):
        def legend(*arguments):
            self.assert_succeeds(self.run_here("render", "box.hexahedra", "--size", "400x300", "-o", "b.png", *arguments))
            return legend_of(self.folder / "b.png")
        self.assertEqual(legend(), self.render())
        for option in (("--field", "tets"), ("--frames", "boxes"), ("--colour", "alignment")):
            self.assertNotIn("All-hex", legend(*option))

    def test_the_bytes_are_the_same_for_any_number_of_threads(self):
        contents = set()
        for threads in (1, 2, 3):
            self.render("--cut", "x", "--threads", threads)
            contents.add((self.folder / "a.png").read_bytes())
        self.assertEqual(len(contents), 1)

    def test_a_partial_mesh_is_told_so_with_the_reason(self):
        report = self.folder / "box.hexahedra/report.json"
        content = json.loads(report.read_text())
        content["hexahedra"] |= {"outcome": "partial", "reason": "no map: one tet stays inverted"}
        report.write_text(json.dumps(content, indent=2))
        legend = self.render()
        self.assertIn("Partial mesh: ", legend)
        self.assertIn("no map: one tet stays inverted\n", legend)

    def test_a_folder_without_hexahedra_is_told_in_one_line(self):
        (self.folder / "empty").mkdir()
        self.assertEqual(self.refused("empty", "--hexahedra", code=INPUT), "crossgrain: empty: has no hexahedra; make them with 'crossgrain hex'\n")
        (self.folder / "box.hexahedra/hexahedra.vtu").unlink()
        self.assertEqual(self.refused("box.hexahedra", "--hexahedra", code=INPUT),
                         "crossgrain: box.hexahedra: has no hexahedra; make them with 'crossgrain hex'\n")

    def test_a_damaged_file_is_told_in_one_line(self):
        path = self.folder / "box.hexahedra/hexahedra.vtu"
        path.write_bytes(path.read_bytes()[:-300])
        self.assertIn("box.hexahedra/hexahedra.vtu: ", self.refused("box.hexahedra", "--hexahedra", code=INPUT))

    def test_options_of_fields_are_refused(self):
        for option in (("--field", "tets"), ("--range", "0,1"), ("--frames", "boxes"), ("--streamlines",)):
            self.assertIn(" exclude each other", self.refused("box.hexahedra", "--hexahedra", *option, code=USAGE))
        self.assertIn("by face", self.refused("box.hexahedra", "--hexahedra", "--colour", "energy", code=USAGE))
        self.assertIn("only one region", self.refused("box.hexahedra", "--colour", "region", code=USAGE))
        self.assertIn(" exclude each other", self.refused("box.hexahedra", "--below", "0.5", "--field", "tets", code=USAGE))
        self.assertIn("leaves no hexahedron", self.refused("box.hexahedra", "--hexahedra", "--view", "right", "--cut", f"x={self.vertices[:, 0].min() + 1e-3}", code=USAGE))

    def test_the_page_has_all_of_them_with_their_shapes(self):
        page = Page(self.folder / "box.hexahedra/report.html")
        points = page.arrays["hex_points"] + np.array(page.header["origin"])
        corners = page.arrays["hex_corners"]
        self.assertEqual(page.header["hexahedra"]["total"], len(self.corners))
        self.assertEqual(page.header["hexahedra"]["inverted"], 0)
        self.assertAlmostEqual(page.header["hexahedra"]["mean"], self.shapes.mean(), places=9)
        np.testing.assert_allclose(points[corners], self.vertices[self.corners], atol=1e-5)
        np.testing.assert_allclose(page.arrays["hex_shape"], self.shapes, atol=1e-6)


if __name__ == "__main__":
    unittest.main()
