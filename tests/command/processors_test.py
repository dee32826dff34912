#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Results are the same to the bit on all processors: of two, four and eight doubles a vector, with and without fused
multiply-add in the C library. All are played on this one.

CROSSGRAIN_CAD_FILES is the program that makes CAD files; without it Crossgrain was built without OpenCASCADE.
"""

import json
import os
import re
import shutil
import subprocess
import unittest
from pathlib import Path

import numpy as np
from program import (TIME_LIMIT, CommandTest, cylinder_triangles, medit_text, of_the_day, stl_bytes, tet_box, tilt,
                     without_costs)

CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
MODELS = Path(__file__).resolve().parents[2] / "models"
SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared"))

# Doubles in a vector, and what the GNU C library shall not use.
PROCESSORS = [("8", ""), ("4", "-FMA"), ("2", "-FMA,-FMA4,-AVX2,-AVX"), ("8", "-AVX2")]


def environment_of(processor):
    doubles, left_out = processor
    return {**os.environ, "CROSSGRAIN_VECTOR_DOUBLES": doubles, "GLIBC_TUNABLES": "glibc.cpu.hwcaps=" + left_out}


def content_of(path, solve):
    """The bytes of a file, without the name of the solve and what it took."""
    if path.name == "report.json":
        return json.dumps(without_costs(json.loads(path.read_text())))
    content = path.read_bytes().replace(solve.encode(), b"")
    if path.name == "report.html":
        content = re.sub(rb'(<script id="crossgrain-report"[^>]*>).*?</script>', rb"\1", content, flags=re.DOTALL)
    return content


class Processors(CommandTest):
    def results(self, processor, model, *arguments):
        """Names and contents of all files, and what commands print."""
        environment = environment_of(processor)
        run = lambda *command: self.run_here(*command, env=environment)
        self.assert_succeeds(run("solve", model, "-o", "out", "--quiet", "--force", *arguments))
        self.assert_succeeds(run("streamlines", "out", "-o", "out/lines.vtu", "--quiet"))
        answer = run("check", "out", "--json")
        self.assertIn(answer.returncode, (0, 1, 3), answer.stderr)
        folder = self.folder / "out"
        solve = json.loads((folder / "report.json").read_text())["solve"]
        return {path.name: content_of(path, solve) for path in folder.iterdir()} | {"check": answer.stdout.replace(solve, "")}

    def assert_same_on_all(self, model, *arguments):
        expected = self.results(PROCESSORS[0], model, *arguments)
        for processor in PROCESSORS[1:]:
            with self.subTest(model=str(model), processor=processor):
                results = self.results(processor, model, *arguments)
                self.assertEqual(results.keys(), expected.keys())
                self.assertEqual([name for name in results if results[name] != expected[name]], [])

    def test_surfaces(self):
        self.write("part.stl", stl_bytes(cylinder_triangles()))
        self.assert_same_on_all("part.stl", "--resolution", 24)

    def test_tets(self):
        vertices, tets = tet_box(cells=(5, 4, 4))
        self.write("part.mesh", medit_text(vertices @ tilt(), tets))
        for degree in (3, 4):
            self.assert_same_on_all("part.mesh", "--degree", degree)

    def assert_same_hexahedra(self, model, *arguments):
        """The mesh of each processor; the report has times of its own."""
        meshes = set()
        for processor in PROCESSORS:
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            run = self.run_here("hex", model, "-o", "out", "--quiet", *arguments, env=environment_of(processor))
            self.assertIn(run.returncode, (0, 1), run.stderr)
            meshes.add((self.folder / "out" / "hexahedra.mesh").read_bytes())
        self.assertEqual(len(meshes), 1)

    def test_hexahedra(self):
        vertices, tets = tet_box(cells=(4, 3, 3))
        x, y, z = vertices.T
        # Curved, so that the vertices of its hexahedra are smoothed.
        bent = np.stack([x + 0.15 * y * z, y * (1 + 0.25 * x) + 0.1 * x * x, z * (1 + 0.1 * y) - 0.1 * x * y], axis=1)
        self.write("bent.mesh", medit_text(bent @ tilt(), tets))
        self.assert_same_hexahedra("bent.mesh", "--size", 0.2)

    @unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")
    def test_tets_that_are_made(self):
        self.write("part.stl", stl_bytes(cylinder_triangles()))
        models = ["part.stl", *([MODELS / "wedge.step"] if CAD_FILES else [])]
        for model in models:
            meshes = set()
            for processor in PROCESSORS[:2]:
                (self.folder / "made.mesh").unlink(missing_ok=True)
                self.assert_succeeds(self.run_here("tets", model, "-o", "made.mesh", "--quiet",
                                                   env=environment_of(processor)))
                meshes.add((self.folder / "made.mesh").read_bytes())
            self.assertEqual(len(meshes), 1, model)

    @unittest.skipUnless(CAD_FILES, "built without OpenCASCADE")
    def test_cad_files(self):
        subprocess.run([CAD_FILES, self.folder], capture_output=True, timeout=TIME_LIMIT, check=True)
        for model in of_the_day(("rounded.brep", "sleeve.step"), "sleeve.step"):
            self.assert_same_on_all(model, "--resolution", 16)

    @unittest.skipUnless(CAD_FILES and SHARED.is_dir(), "without the shared models")
    def test_cad_files_whose_triangles_once_differed(self):
        for model in of_the_day(("i02o_m2.step", "base_interface_AP214.STEP"), "i02o_m2.step"):
            self.assert_same_on_all(SHARED / "models" / "good" / model, "--resolution", 64)

    def test_their_sines_are_not_the_same(self):
        """What the others show: that the C library heeds its setting here."""
        with open("/proc/cpuinfo", encoding="utf-8") as processor:
            if not re.search(r"\bfma\b", processor.read()):
                self.skipTest("this processor has no fused multiply-add")
        code = "import math; print(sum(hash(math.sin(0.001 * k)) for k in range(100000)))"
        sums = {subprocess.run(["/usr/bin/python3", "-c", code], env=environment_of(processor), capture_output=True,
                               timeout=TIME_LIMIT, check=True).stdout for processor in PROCESSORS}
        self.assertEqual(len(sums), 2)


if __name__ == "__main__":
    unittest.main()
