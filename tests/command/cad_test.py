#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""CAD files on the command line: they are solved, nothing is printed that should not be, and the module for them is loaded
for them only.

CROSSGRAIN_CAD_FILES is the program that makes the files; without it Crossgrain was built without OpenCASCADE.
"""

import json
import os
import shutil
import subprocess
import unittest

from program import PROGRAM, TIME_LIMIT, CommandTest, box_triangles, stl_bytes

CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
INPUT = 3


class WithoutTheModule(CommandTest):
    def test_a_program_away_from_its_module_names_the_packages(self):
        alone = shutil.copy(PROGRAM, self.folder / "alone")
        self.write("part.step", "ISO-10303-21;\nEND-ISO-10303-21;\n")
        result = subprocess.run([alone, "solve", "part.step"], cwd=self.folder, capture_output=True, text=True,
                                timeout=TIME_LIMIT, check=False)
        self.assert_fails(result, INPUT, "part.step", "libocct-data-exchange-dev", "crossgrain_cad.so")

    def test_the_program_itself_links_no_opencascade(self):
        linked = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True, timeout=TIME_LIMIT, check=True).stdout
        self.assertIn("libc.so", linked)
        self.assertNotIn("libTK", linked)


@unittest.skipUnless(CAD_FILES, "built without OpenCASCADE")
class WithTheModule(CommandTest):
    def setUp(self):
        super().setUp()
        subprocess.run([CAD_FILES, self.folder], capture_output=True, timeout=TIME_LIMIT, check=True)

    def solve(self, model, *arguments):
        result = self.run_here("solve", model, "-o", "out", *arguments)
        self.assert_succeeds(result)
        return result, json.loads((self.folder / "out" / "report.json").read_text())

    def test_every_format_gives_a_field_that_follows_the_part(self):
        for name in ("plate.step", "inch.stp", "plate.iges", "plate.brep"):
            with self.subTest(name):
                result, report = self.solve(name, "--resolution", "32", "--quiet")
                self.assertEqual((result.stdout, result.stderr), ("", ""))
                self.assertTrue(report["model"]["watertight"])
                self.assertAlmostEqual(report["model"]["bounding_box"]["high"][0], 40, 6)
                self.assertLess(report["alignment_deg"]["mean"], 3)

    def test_constraints_name_faces_by_their_numbers(self):
        self.write("c.json", '{"schema": 1, "faces": [{"face": 1, "axis": "normal"}]}')
        _, report = self.solve("plate.step", "--resolution", "16", "--constraints", "c.json")
        faces = report["constraints"]["faces"]
        self.assertEqual(faces["count"], 1)
        self.assertGreater(faces["area"], 0)
        self.assertLess(faces["angle_deg"]["mean"], 5)
        self.write("c.json", '{"schema": 1,\n"faces": [{"face": 999, "axis": "normal"}]}')
        result = self.run_here("solve", "plate.step", "--constraints", "c.json")
        self.assert_fails(result, INPUT, "crossgrain: c.json:2: ", "no face 999, only 1 to")

    def test_the_report_names_the_units(self):
        model = self.solve("inch.stp", "--resolution", "8")[1]["model"]
        self.assertEqual((model["unit"], model["file_unit"]), ("mm", "inch"))
        model = self.solve("plate.brep", "--resolution", "8")[1]["model"]
        self.assertNotIn("unit", model)
        self.assertNotIn("file_unit", model)

    def test_finer_cells_get_finer_triangles(self):
        coarse = self.solve("cylinder.brep", "--resolution", "8")[1]["model"]["triangles"]
        by_size = self.solve("cylinder.brep", "--cell-size", "0.2", "--output-level", "2")[1]["model"]["triangles"]
        self.assertGreater(by_size, coarse)

    def test_what_reading_found_is_told_on_standard_error_and_in_the_report(self):
        result, report = self.solve("loose.brep", "--resolution", "8", "--quiet")
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertIn("crossgrain: warning: the file has no solids", result.stderr)
        self.assertEqual([w for w in report["warnings"] if "no solids" in w], report["warnings"][:1])

    def test_one_thread_and_two_give_the_same_bytes(self):
        fields = []
        for threads in (1, 2):
            self.solve("rounded.brep", "--resolution", "16", "--threads", threads)
            fields.append((self.folder / "out" / "field.vtu").read_bytes())
        self.assertEqual(fields[0], fields[1])

    def test_a_damaged_file_gives_one_line(self):
        self.write("bad.step", "ISO-10303-21;\nHEADER;\nnonsense\nENDSEC;\nEND-ISO-10303-21;\n")
        self.assert_fails(self.run_here("solve", "bad.step"), INPUT, "bad.step", "export it again")

    def test_the_module_is_loaded_for_cad_files_only(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        for name, loaded in (("box.stl", False), ("box.brep", True)):
            with self.subTest(name):
                result = self.run_here("solve", name, "--resolution", "8", "--quiet",
                                       env={**os.environ, "LD_DEBUG": "files"})
                self.assertEqual("libTKernel" in result.stderr, loaded)


if __name__ == "__main__":
    unittest.main()
