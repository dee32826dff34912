#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain hex` of models of several solids: what it calls a success, what it says otherwise, and whether that helps.

CROSSGRAIN_CAD_FILES is the program that makes CAD files; without it Crossgrain was built without OpenCASCADE.
"""

import json
import os
import subprocess
import unittest

import numpy as np

from program import TIME_LIMIT, CommandTest, box_triangles, medit_text, stl_bytes, tet_box

CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
NOT_ALL_HEX, APPROXIMATE = 6, 7


class HexSolidsTest(CommandTest):
    def hex(self, *arguments, code=0):
        """The line about the hexahedra; the report is kept."""
        self.result = self.run_here("hex", *arguments, "-o", "out", "--no-report")
        self.assertEqual(self.result.returncode, code, self.result.stdout + self.result.stderr)
        self.report = json.loads((self.folder / "out/report.json").read_text())
        return next(line for line in self.result.stdout.splitlines() if line.startswith("hexahedra"))


# Boxes need no more tets.
FEW = ("--size", "1", "--tet-size", "1")


class OfTriangles(HexSolidsTest):
    def test_touching_bodies_are_united(self):
        low, high = box_triangles((4.0, 4.0, 2.0)), box_triangles((2.0, 2.0, 2.0)) + (0.7, 0.9, 2)
        self.write("two.stl", stl_bytes(np.concatenate([low, high])))
        self.hex("two.stl", *FEW)
        self.assertEqual(self.report["hexahedra"]["bodies"], 1)
        self.assertAlmostEqual(self.report["hexahedra"]["volume"], 40, 5)
        self.assertEqual(self.result.stderr.count("warning: "), 1, self.result.stderr)
        self.assertRegex(self.result.stderr, "warning: two.stl: touching components: 1, at .*; merged into the surface around all that they enclose")

    def test_bodies_apart_are_two_parts_of_one_mesh(self):
        self.write("two.stl", stl_bytes(np.concatenate([box_triangles((2.0, 2.0, 2.0)), box_triangles((2.0, 2.0, 2.0)) + (3, 0, 0)])))
        self.assertRegex(self.hex("two.stl", *FEW), "all-hex: 16 hexahedra in 2 bodies, mean edge 1")

    def test_bodies_that_meet_in_an_edge_or_a_point_are_told_so_once_in_words_of_hexahedra(self):
        box = box_triangles((2.0, 2.0, 2.0))
        for place, where in (((2, 2, 0), "an edge, where hexahedra of both share no vertices, at 2 2 1"), ((2, 2, 2), "a point, where .*, at 2 2 2")):
            with self.subTest(where):
                self.write("two.stl", stl_bytes(np.concatenate([box, box + place])))
                self.assertRegex(self.hex("two.stl", *FEW), "all-hex: 16 hexahedra in 2 bodies, mean edge 1")
                self.assertRegex(self.result.stderr, f"warning: two.stl: (solids|bodies) 1 and 2 meet only in {where}\n")
                self.assertEqual([w["kind"] for w in self.report["warnings"]], ["touching_solids"])

    def test_copies_of_a_body_are_left_out_and_told(self):
        box = box_triangles((2.0, 2.0, 2.0))
        for copies in (2, 3):
            with self.subTest(copies=copies):
                self.write("copies.stl", stl_bytes(np.concatenate([box] * copies + [box + (5, 0, 0)])))
                self.assertRegex(self.hex("copies.stl", *FEW), "all-hex: 16 hexahedra in 2 bodies, mean edge 1")
                self.assertIn(f"duplicated triangles: {12 * (copies - 1)} repeated", self.result.stderr)

    def test_bodies_in_one_place_are_one_however_their_faces_are_cut(self):
        box = box_triangles((2.0, 2.0, 2.0))
        middles = box.mean(axis=1, keepdims=True)
        finer = np.concatenate([np.concatenate([box[:, [k, (k + 1) % 3]], middles], axis=1) for k in range(3)])
        self.write("twice.stl", stl_bytes(np.concatenate([box, finer])))
        self.assertIn("all-hex: 8 hexahedra, mean edge 1", self.hex("twice.stl", *FEW))

    def test_what_is_warned_of_before_the_work_is_not_said_again(self):
        triangles = box_triangles((2.0, 2.0, 2.0))
        at_origin = np.argwhere((triangles == 0).all(axis=2))
        triangles[tuple(at_origin[0])] = 1e-17  # a crack, which is merged
        self.write("cracked.stl", stl_bytes(triangles))
        self.assertRegex(self.hex("cracked.stl", *FEW), "all-hex: 8 hexahedra, mean edge 1")
        warnings = [line for line in self.result.stderr.splitlines() if "warning: " in line]
        self.assertEqual(len(warnings), 1, warnings)
        self.assertRegex(warnings[0], "cracks: ")


class OfTets(HexSolidsTest):
    def test_regions_that_share_no_vertices_are_no_success_until_they_do(self):
        vertices, tets = tet_box((4, 4, 4), (2.0, 2.0, 2.0))
        both = np.concatenate([vertices, vertices + (2, 0, 0)])
        cells = np.concatenate([tets, tets + len(vertices)])
        self.write("apart.mesh", medit_text(both, cells))
        line = self.hex("apart.mesh", "--size", "1", code=NOT_ALL_HEX)
        self.assertRegex(line, "partial.*touch.*; mesh them together, with common vertices")
        _, first, number = np.unique(np.round(both, 9), axis=0, return_index=True, return_inverse=True)
        self.write("joined.mesh", medit_text(both[first], number.reshape(-1)[cells]))
        self.assertRegex(self.hex("joined.mesh", "--size", "1"), "all-hex: 16 hexahedra, mean edge 1$")


@unittest.skipUnless(CAD_FILES, "built without OpenCASCADE")
class OfCadFiles(HexSolidsTest):
    def setUp(self):
        super().setUp()
        subprocess.run([CAD_FILES, self.folder], capture_output=True, timeout=TIME_LIMIT, check=True)

    def test_touching_solids_are_a_success_once_they_are_glued(self):
        line = self.hex("stacked.brep", "--cells", "8", "--tet-size", "4", code=NOT_ALL_HEX)
        self.assertRegex(line, "partial.* in 2 bodies, mean edge [0-9.]+; solids that touch are meshed apart, as warned; glue them with --glue$")
        self.assertRegex(self.result.stderr, "warning: stacked.brep: solids 1 and 2 touch.*; glue them with --glue; else the mesh is partial \\(exit code 6\\)\n")
        self.assertNotIn("merge equal vertices", self.result.stdout + self.result.stderr)
        self.assertEqual(self.result.stderr.count("warning: "), 1, self.result.stderr)
        line = self.hex("stacked.brep", "--cells", "8", "--tet-size", "4", "--glue")
        self.assertRegex(line, r"all-hex: \d+ hexahedra, mean edge [0-9.]+$")
        self.assertEqual(self.report["hexahedra"]["bodies"], 1)
        self.assertGreater(self.report["hexahedra"]["interface_faces"], 0)

    def test_overlapping_solids_are_a_success_once_they_are_glued(self):
        line = self.hex("overlapping.brep", "--cells", "8", "--tet-size", "4", code=NOT_ALL_HEX)
        self.assertRegex(line, "partial.*; solids overlap, as warned; .*--glue")
        self.assertEqual((self.result.stdout + self.result.stderr).count("solids 1 and 2 overlap, and both are meshed whole"), 1)
        self.assertRegex(self.hex("overlapping.brep", "--cells", "15", "--tet-size", "4", "--glue"), r"all-hex: \d+ hexahedra, mean edge [0-9.]+$")

    def test_a_copy_of_the_faces_of_a_solid_is_no_second_mesh(self):
        for name in ("own_shell.brep", "turned_shell.brep"):
            with self.subTest(name):
                line = self.hex(name, "--cells", "6", "--tet-size", "2.8", "--map-only", code=APPROXIMATE)
                self.assertIn("approximate: 128 hexahedra", line)
                self.assertEqual(self.report["hexahedra"]["bodies"], 1)
                self.assertIn("shells of faces that bound another body already, left out: 1", self.result.stderr)


if __name__ == "__main__":
    unittest.main()
