#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain solve --output-level` and `--clip`: part of a field in field.vtu, the report of all of it."""

import json
import unittest

import numpy as np
from field_reader import Field
from program import CommandTest, box_triangles, medit_text, stl_bytes, tet_box, torus_triangles, without_costs, without_solve

USAGE, INPUT = 2, 3
RESOLUTION = ("--resolution", "24")


class PartOfAField(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("torus.stl", stl_bytes(torus_triangles()))

    def solve(self, name, *arguments):
        result = self.run_here("solve", "torus.stl", "-o", name, "--no-report", *RESOLUTION, *arguments)
        self.assert_succeeds(result)
        return result

    def field(self, name, *arguments):
        self.solve(name, *arguments)
        return Field(self.folder / name / "field.vtu")

    def report_without_costs(self, name):
        return without_costs(json.loads((self.folder / name / "report.json").read_text()))

    def test_no_cell_is_finer_than_the_output_level_and_every_leaf_is_in_one(self):
        whole = self.field("whole")
        level = int(whole.depth.max()) - 1
        part = self.field("part", "--output-level", level)
        self.assertEqual(int(part.depth.max()), level)
        volumes = np.zeros(len(part))
        for i in range(len(whole)):
            volumes[part.containing(int(whole.depth[i]), whole.place[i])] += whole.size[i] ** 3
        self.assertTrue((volumes > 0).all())
        self.assertTrue((volumes <= part.size**3 * (1 + 1e-9)).all())
        full = np.isclose(volumes, part.size**3)
        self.assertGreater(full.sum(), 0)
        self.assertTrue(full[part.arrays["is_boundary"] == 0].all(), "cells without surface are full")

    def test_the_report_and_its_summary_are_of_the_whole_field(self):
        summaries = [[line for line in self.solve("out", *arguments).stdout.splitlines() if not line.startswith("cost")]
                     for arguments in ([], ["--output-level", 3], ["--clip", "0,-inf,-inf,inf,inf,inf"])]
        self.assertEqual(summaries[0], summaries[1])
        self.assertEqual(summaries[0], summaries[2])
        reports = []
        for name, arguments in (("whole", []), ("part", ["--output-level", 3, "--clip", "0,0,0,1,1,1"])):
            self.solve(name, *arguments)
            reports.append(self.report_without_costs(name))
        self.assertEqual(*reports)

    def test_a_box_leaves_exactly_the_cells_that_meet_it(self):
        whole = self.field("whole")
        low, high = np.array([-0.31, 0.1, -5]), np.array([0.2, 0.77, 0.05])
        part = self.field("part", "--clip=" + ",".join(map(str, [*low, *high])))
        size = whole.size[:, None]
        meets = ((whole.low <= high) & (whole.low + size >= low)).all(axis=1)
        expected = {cell for cell, i in whole.index.items() if meets[i]}
        self.assertTrue(0 < len(expected) < len(whole))
        self.assertEqual(set(part.index), expected)
        self.assertLess(len(part.arrays["Points"]), len(whole.arrays["Points"]))

    def test_a_box_may_begin_with_a_minus_sign(self):
        self.assertEqual(self.field("a", "--clip", "-1,-1,-1,0,0,0").index,
                         self.field("b", "--clip=-1,-1,-1,0,0,0").index)

    def test_both_together_clip_the_merged_cells(self):
        merged = self.field("merged", "--output-level", 4)
        part = self.field("part", "--output-level", 4, "--clip", "0.2,-1,-1,0.3,1,1")
        meets = (merged.low[:, 0] <= 0.3) & (merged.low[:, 0] + merged.size >= 0.2)
        self.assertEqual(set(part.index), {cell for cell, i in merged.index.items() if meets[i]})

    def test_the_bytes_do_not_depend_on_the_number_of_threads(self):
        contents = []
        for threads in (1, 2):
            self.solve("out", "--output-level", 4, "--clip", "-1,-1,-1,0.3,1,1", "--threads", threads)
            contents.append((self.folder / "out" / "field.vtu").read_bytes())
        self.assertTrue(contents[0] == contents[1])

    def test_a_box_in_the_hole_writes_all_cells_and_warns(self):
        whole = self.field("whole")
        result = self.solve("part", "--clip", "-0.01,-0.01,-0.01,0.01,0.01,0.01")
        self.assertIn("warning", result.stdout)
        self.assertIn("clip", result.stdout)
        self.assertIn("clip_missed", [warning["kind"] for warning in self.report_without_costs("part")["warnings"]])
        self.assertEqual(Field(self.folder / "part" / "field.vtu").index, whole.index)

    def test_a_box_beside_the_model_is_refused_before_the_solve(self):
        result = self.run_here("solve", "torus.stl", "-o", "out", "--clip", "100,100,100,200,200,200")
        self.assert_fails(result, USAGE, "torus.stl", "--clip", "unit")
        self.assertEqual(self.names(), ["torus.stl"])

    def test_a_part_is_sampled_with_the_rest_outside(self):
        self.solve("part", "--output-level", 4, "--clip", "0,-inf,-inf,inf,inf,inf")
        points = "".join(f"{x} {y} {z}\n" for x, y, z in torus_triangles().mean(axis=1))
        result = self.run_here("sample", "part", "-", stdin=points.encode())
        self.assert_succeeds(result)
        frames = np.loadtxt(result.stdout.splitlines())
        axes = frames.reshape(-1, 3, 3)
        np.testing.assert_allclose(axes @ axes.transpose(0, 2, 1), np.broadcast_to(np.eye(3), axes.shape), atol=1e-12)
        outside = int(result.stderr.split()[1])
        self.assertTrue(0.4 * len(axes) < outside < 0.6 * len(axes), "half of the torus is not there")

    def test_a_field_of_merged_cells_can_be_started_from(self):
        self.solve("whole")
        self.solve("merged", "--output-level", 3)
        self.solve("again", "--from", "merged")
        first, second = (self.report_without_costs(name)["energy"]["total"] for name in ("whole", "again"))
        # It may only improve, but for what rounding takes.
        self.assertLess(second, 1.001 * first)

    def test_a_field_that_is_clipped_is_not_started_from(self):
        self.solve("part", "--clip", "0,-inf,-inf,inf,inf,inf")
        before = self.names()
        result = self.run_here("solve", "torus.stl", "-o", "again", "--from", "part")
        self.assert_fails(result, INPUT, "part", "--clip")
        self.assertEqual(self.names(), before)


class PartOfAFieldOnTets(CommandTest):
    def test_what_is_written_for_tets_is_whole(self):
        self.write("box.mesh", medit_text(*tet_box()))
        contents = []
        for arguments in ([], ["--output-level", "2", "--clip", "0,0,0,0.1,0.1,0.1"]):
            self.assert_succeeds(self.run_here("solve", "box.mesh", "-o", "out", *arguments))
            contents.append([without_solve((self.folder / "out" / name).read_bytes())
                             for name in ("onto.frames", "onto.vtu", "field.vtu")])
        self.assertEqual(contents[0][:2], contents[1][:2])
        self.assertLess(len(contents[1][2]), len(contents[0][2]))


class WrongParts(CommandTest):
    def test_boxes_and_levels_that_are_none_are_refused(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        for arguments in (["--output-level", "-1"], ["--output-level", "20"], ["--output-level", "x"],
                          ["--output-level", "1.5"], ["--clip", "0,0,0,1,1"], ["--clip", "0,0,0,1,1,1,1"],
                          ["--clip", "0,0,0,1,1,1,"], ["--clip", "0,0,0,1,,1"], ["--clip", "0,0,0,1,one,1"],
                          ["--clip", "0,0,0,1,nan,1"], ["--clip", "0,0,0,1,1,1mm"], ["--clip", "0 0 0 1 1 1"],
                          ["--clip", ""], ["--clip", "0,0,1,1,1,0"], ["--clip", "2,0,0,1,1,1"]):
            with self.subTest(arguments=arguments):
                self.assert_fails(self.run_here("solve", "box.stl", *arguments), USAGE, arguments[0], "--help")
        self.assertEqual(self.names(), ["box.stl"])


if __name__ == "__main__":
    unittest.main()
