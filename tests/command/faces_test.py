#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The faces of a CAD model on the command line: in the report, in pictures, in warnings, and how well hexahedra fit them.

CROSSGRAIN_CAD_FILES is the program that makes the files; without it Crossgrain was built without OpenCASCADE.
"""

import json
import math
import os
import subprocess
import unittest
from collections import Counter

from hex_pictures_test import legend_of
from hex_test import medit_section
from program import TIME_LIMIT, CommandTest

CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
APPROXIMATE = 7  # exit code


@unittest.skipUnless(CAD_FILES, "built without OpenCASCADE")
class Faces(CommandTest):
    def setUp(self):
        super().setUp()
        subprocess.run([CAD_FILES, str(self.folder)], check=True, stdout=subprocess.DEVNULL, timeout=TIME_LIMIT)

    def report_of(self, command, model, *arguments, code=0):
        result = self.run_here(command, model, *arguments, "-o", "out", "--no-report")
        if "there is no program that makes tets" in result.stderr:
            self.skipTest("nothing makes tets")
        self.assertEqual(result.returncode, code, result.stderr)
        self.printed = result.stdout
        return json.loads((self.folder / "out/report.json").read_text())

    def warnings_of(self, report, kind):
        return [warning["text"] for warning in report["warnings"] if warning["kind"] == kind]

    def legend(self, *arguments):
        self.assert_succeeds(self.run_here("render", "out", "--colour", "face", "--size", "800x600", "-o", "a.png", *arguments))
        return legend_of(self.folder / "a.png")

    def test_a_solve_lists_those_of_a_cad_file_and_pictures_show_them(self):
        faces = self.report_of("solve", "plate.step", "--resolution", "12")["faces"]
        self.assertEqual([face["number"] for face in faces], list(range(1, 8)))
        hole = [face for face in faces if face["kind"] == "cylinder"]
        self.assertEqual(len(hole), 1)
        self.assertAlmostEqual(hole[0]["area"], 100 * math.pi, places=6)
        self.assertAlmostEqual(hole[0]["centre"][0], 20, places=6)
        self.assertIsNone(hole[0]["quads"])
        self.assertIn("Faces (7)", self.legend())

    def test_hexahedra_are_measured_against_the_cad_model(self):
        report = self.report_of("hex", "plate.step", "--size", "4")
        hexahedra = report["hexahedra"]
        self.assertEqual(hexahedra["model"], "cad")
        self.assertAlmostEqual(hexahedra["model_volume"], 12000 - 250 * math.pi, places=5)
        self.assertAlmostEqual(hexahedra["model_area"], 2 * (1200 - 25 * math.pi) + 1400 + 100 * math.pi, places=5)
        tags = Counter(int(tag) for tag in medit_section(self.folder / "out/hexahedra.mesh", "Quadrilaterals", 5)[:, 4])
        self.assertEqual({face["number"]: face["quads"] for face in report["faces"]}, dict(tags))
        self.assertIn("Faces (7)", self.legend("--hexahedra"))

    def test_a_face_narrower_than_the_hexahedra_gets_a_row_of_quads(self):
        report = self.report_of("hex", "chamfered.step", "--size", "3")
        narrow = [face for face in report["faces"] if round(face["area"], 2) == round(0.4 * math.sqrt(2) * 30, 2)]
        self.assertEqual([face["quads"] for face in narrow], [10])
        self.assertEqual(self.warnings_of(report, "faces_without_quads"), [])
        hexahedra = report["hexahedra"]
        self.assertEqual((hexahedra["outcome"], hexahedra["features"]["lacking"]), ("all-hex", []))
        self.assertEqual([hexahedra["fit_tries"][0]["lacking"] > 0, hexahedra["fit_tries"][hexahedra["best_fit"]]["way"]], [True, "snapped"])
        self.assertGreater(hexahedra["scaled_jacobian"]["min"], 0.7)
        self.assertIn("6 of 6 faces kept", self.printed)

    def test_hexahedra_that_miss_much_of_the_volume_are_told(self):
        report = self.report_of("hex", "cylinder.step", "--size", "10", "--map-only", code=APPROXIMATE)  # as wide as the cylinder
        hexahedra = report["hexahedra"]
        self.assertAlmostEqual(hexahedra["model_volume"], 500 * math.pi, places=4)
        missed = 100 * (1 - hexahedra["volume"] / hexahedra["model_volume"])
        self.assertGreater(missed, 10)
        self.assertTrue(hexahedra["reason"].endswith(f"its volume is {missed:.2g} % below the model's"), hexahedra["reason"])
        self.assertEqual(hexahedra["remedy"], "use_hex_size")
        self.assertIn(f"; {hexahedra['reason']}; try --size {hexahedra['remedy_number']:g} (about ", self.printed)
        self.assertEqual(hexahedra["outcome"], "approximate")


if __name__ == "__main__":
    unittest.main()
