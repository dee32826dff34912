# SPDX-License-Identifier: Apache-2.0
"""ParaView opens every kind of file that the program writes for it, and finds what the reports say.

CROSSGRAIN_PROGRAM names the program. Needs Debian's python3-paraview, which the other tests do not.
"""

import json
import shutil
import sys
import unittest
from pathlib import Path

from program import CommandTest, medit_text, run
from tet_solids import angle_iron

HERE = Path(__file__).resolve().parent
MODELS = HERE.parent.parent / "models"
CUBE, TET, LINE, TRIANGLE = 12, 10, 4, 5


@unittest.skipIf(shutil.which("pvpython") is None, "needs pvpython (Debian's python3-paraview)")
class ParaView(CommandTest):
    def solved(self, model, *options):
        result = self.run_here("solve", model, "-o", "out", "--quiet", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads((self.folder / "out" / "report.json").read_text())

    def found(self):
        paths = sorted((self.folder / "out").glob("*.vtu"))
        result = run("--force-offscreen-rendering", HERE / "open_files.py", *paths, program="pvpython")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return {Path(path).name: found for path, found in json.loads(result.stdout.splitlines()[-1]).items()}

    def expect_graph(self, found, graph):
        self.assertEqual((found["cells"], found["types"] in ([], [LINE])), (graph["arcs"], True))
        for array in ("index", "type", "verdict", "length", "closed", "on_boundary"):
            self.assertIn(array, found["cell_arrays"])

    def expect_axes(self, found):
        for axis in ("axis_u", "axis_v", "axis_w"):
            low, high = found["cell_arrays"][axis]
            self.assertAlmostEqual(low, 1, 5)
            self.assertAlmostEqual(high, 1, 5)

    def test_opens_a_field_on_a_grid(self):
        for degree in (3, 4):
            report = self.solved(MODELS / "bracket.stl", "--resolution", 48, "--degree", degree)
            self.assertEqual(self.run_here("streamlines", "out", "--quiet").returncode, 0)
            found = self.found()
            self.assertEqual(set(found), {"field.vtu", "singularities.vtu", "streamlines.vtu", "surface.vtu"})
            field = found["field.vtu"]
            self.assertEqual((field["cells"], field["types"]), (report["levels"][-1]["active_cells"], [CUBE]))
            self.expect_axes(field)
            self.assertLessEqual(field["cell_arrays"]["alignment_deg"][1], 55)
            self.expect_graph(found["singularities.vtu"], report["singularity"])
            self.assertEqual(found["surface.vtu"]["types"], [LINE, TRIANGLE])
            self.assertEqual(found["streamlines.vtu"]["types"], [LINE])

    def test_opens_a_field_on_tets(self):
        self.write("iron.mesh", medit_text(*angle_iron()))
        report = self.solved("iron.mesh")
        found = self.found()
        self.assertIn("onto.vtu", found)
        onto = found["onto.vtu"]
        self.assertEqual((onto["cells"], onto["points"], onto["types"]),
                         (report["onto"]["tets"], report["onto"]["vertices"], [TET]))
        self.expect_axes(onto)
        self.expect_graph(found["onto_singularities.vtu"], report["onto"]["singularity"])

    def test_opens_parts_of_a_field(self):
        self.solved(MODELS / "wedge.stl", "--resolution", 32, "--output-level", 4)
        self.assertEqual(self.found()["field.vtu"]["types"], [CUBE])


if __name__ == "__main__":
    sys.exit(unittest.main())
