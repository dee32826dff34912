#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every command that reads a model says how large it is, in which unit; sizes that do not suit it are refused before the work."""

import json
import re
import time
import unittest

from program import CommandTest, box_triangles, medit_text, stl_bytes, tet_box
from tets_test import MAKERS

USAGE, LIMIT = 2, 5
AT_ONCE_S = 20


class ModelLine(CommandTest):
    BOX = "2 x 1 x 1.5{} from 0 0 0; "

    def setUp(self):
        super().setUp()
        self.write("box.stl", stl_bytes(box_triangles()))
        self.write("box.mesh", medit_text(*tet_box()))

    def first_lines(self, *arguments):
        result = self.run_here(*arguments)
        self.assert_succeeds(result)
        return result.stdout.splitlines()

    def test_comes_first_in_each_command_that_reads_a_model(self):
        surface, tets = self.BOX.format(" (no unit)") + "12 triangles", self.BOX.format(" (no unit)") + "216 tets, 1 region"
        cases = [(["solve", "box.stl", "--resolution", "8"], surface), (["solve", "box.mesh"], tets), (["hex", "box.mesh", "--cells", "4"], tets)]
        if MAKERS:
            cases += [(["tets", "box.stl", "--edges", "4"], surface), (["solve", "box.stl", "--tet-size", "0.5"], surface),
                      (["hex", "box.stl", "--cells", "4"], surface)]
        for arguments, model in cases:
            with self.subTest(arguments):
                lines = self.first_lines(*arguments, "-o", "out.mesh" if arguments[0] == "tets" else "out")
                self.assertEqual(lines[0], "model      " + model)
                self.assertEqual([line for line in lines[1:] if line.startswith("model")], [])

    def test_is_that_of_the_surface_with_onto_beside_the_tets(self):
        lines = self.first_lines("solve", "box.stl", "--onto", "box.mesh", "-o", "out")
        self.assertEqual(lines[0], "onto       " + self.BOX.format(" (no unit)") + "216 tets, 1 region")
        self.assertEqual(lines[1], "model      " + self.BOX.format(" (no unit)") + "12 triangles")

    def test_has_the_unit_that_the_user_names_and_so_has_the_report(self):
        for model in ("box.stl", "box.mesh"):
            lines = self.first_lines("solve", model, "--unit", "inch", "--resolution", "8", "-o", "out")
            self.assertIn(self.BOX.format(" inch"), lines[0])
            report = json.loads((self.folder / "out/report.json").read_text())
            self.assertEqual(report["model"]["unit"], "inch")
        self.first_lines("hex", "box.mesh", "--unit", "m", "--cells", "4", "-o", "out")
        self.assertEqual(json.loads((self.folder / "out/report.json").read_text())["model"]["unit"], "m")
        self.assertIn("\n** lengths in m\n", (self.folder / "out/hexahedra.inp").read_text())

    def test_is_absent_where_nothing_shall_be_printed(self):
        self.assertEqual(self.first_lines("solve", "box.stl", "--resolution", "8", "--quiet"), [])

    def test_names_units_that_there_are(self):
        self.assert_fails(self.run_here("solve", "box.stl", "--unit", "yard"), USAGE, "--unit", "um, mm, cm, m, inch or foot")


class WrongSizes(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("small.stl", stl_bytes(box_triangles((0.2, 0.1, 0.15))))
        self.write("large.stl", stl_bytes(box_triangles((200, 100, 150))))
        self.write("small.mesh", medit_text(*tet_box(size=(0.2, 0.1, 0.15))))

    def refuse(self, code, arguments, *words):
        with self.subTest(arguments):
            before = self.names()
            start = time.monotonic()
            self.assert_fails(self.run_here(*arguments), code, *words)
            self.assertLess(time.monotonic() - start, AT_ONCE_S)
            self.assertEqual(self.names(), before)

    def test_larger_than_the_part_are_refused_with_its_size_and_a_question(self):
        across = "which is 0.2 across; sizes are in the unit of the model (none is named; metres?); "
        self.refuse(USAGE, ["hex", "small.stl", "--size", "3"], "small.stl", "hexahedra of 3 are too large", across, "; try --size 0.01")
        self.refuse(USAGE, ["hex", "small.stl", "--size", "0.01", "--tet-size", "3"], "tets of 3 are too large", across, "--tet-size")
        self.refuse(USAGE, ["hex", "small.mesh", "--size", "3"], "small.mesh", across)
        self.refuse(USAGE, ["tets", "small.stl", "--size", "3", "-o", "out.mesh"], "tets of 3 are too large", across, "try --size ")
        self.refuse(USAGE, ["solve", "small.stl", "--tet-size", "3"], "tets of 3 are too large", across, "try --tet-size 0.01")
        self.refuse(USAGE, ["solve", "small.stl", "--cell-size", "3"], "cells of 3 are too large", across, "try --cell-size ")
        self.refuse(USAGE, ["hex", "large.stl", "--size", "1e9"], "which is 200 across; sizes are in the unit of the model (none is named); try --")
        self.refuse(USAGE, ["hex", "small.stl", "--size", "3", "--unit", "m"], "hexahedra of 3 m", "0.2 m across")

    def test_beyond_any_memory_are_refused_with_the_size_of_the_part(self):
        across = "which is 200 across"
        for size in ("0.003", "1e-300", "1e-308", "1e-320"):
            self.refuse(USAGE, ["hex", "large.stl", "--size", size], "too small", across, "try --size ")
            self.refuse(USAGE, ["hex", "large.stl", "--size", "10", "--tet-size", size], "tets of", "too small", across, "--tet-size")
            self.refuse(USAGE, ["tets", "large.stl", "--size", size], "too small", across, "try --size ")
        self.refuse(USAGE, ["solve", "large.stl", "--cell-size", "1e-9"], "too small", across, "try --cell-size ")

    def test_more_than_are_made_are_refused_with_the_option_that_helps(self):
        self.refuse(LIMIT, ["hex", "large.stl", "--size", "0.3"], "which is 200 across", "--size", "--cells")
        self.refuse(LIMIT, ["hex", "large.stl", "--cells", "1000"], "--cells")
        self.refuse(LIMIT, ["tets", "large.stl", "--edges", "1000"], "200 across", "--edges")


class ThinParts(CommandTest):
    def warnings_of(self, *arguments):
        result = self.run_here("hex", *arguments, "-o", "out", "--no-report", "--progress")
        self.assertIn(result.returncode, (0, 6), result.stderr)
        listed = [w for w in json.loads((self.folder / "out/report.json").read_text())["warnings"] if w["kind"] == "thin_part"]
        lines = [line for line in result.stderr.splitlines() if "fit across most of the part" in line]
        self.assertEqual(len(lines), len(listed))
        if lines:
            self.assertLess(result.stderr.index(lines[0]), result.stderr.index("solving the field"))
        return lines

    def test_with_less_than_two_hexahedra_across_are_a_warning_before_the_work(self):
        self.write("plate.mesh", medit_text(*tet_box((6, 6, 1), (6.0, 6.0, 0.5))))
        self.assertRegex(self.warnings_of("plate.mesh", "--size", "0.5")[0],
                         "less than 2 hexahedra of 0.5 .* 0.5 thick there: most walls may get one$")
        self.assertEqual(self.warnings_of("plate.mesh", "--size", "0.25"), [])

    def test_with_two_of_them_across_most_are_none_though_one_side_is_short(self):
        self.write("cube.mesh", medit_text(*tet_box((4, 4, 4), (2.0, 2.0, 2.0))))
        self.assertEqual(self.warnings_of("cube.mesh", "--cells", "2"), [])


if __name__ == "__main__":
    unittest.main()
