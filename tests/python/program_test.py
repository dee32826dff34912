# SPDX-License-Identifier: Apache-2.0
"""Results of the Python package are those of the program to the bit.

CROSSGRAIN_PROGRAM names the program, CROSSGRAIN_CAD_FILES the one that makes CAD files, if it was built.
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import crossgrain as cg
import numpy as np
from solids import ball, ball_of_tets, cube_of_tets, medit_text, stl_bytes

PROGRAM = os.environ["CROSSGRAIN_PROGRAM"]
CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
MODELS = Path(__file__).parents[2] / "models"

# Real models of others, read in place where they are.
REAL_MODELS = sorted(path for path in (Path(__file__).parents[3] / "shared" / "models" / "good").glob("*")
                     if path.suffix.lower() in (".stl", ".obj", ".ply", ".step", ".stp", ".mesh", ".msh", ".vtk"))

# By day these stand for all: a surface, a CAD file and tets.
if os.environ.get("CROSSGRAIN_NIGHTLY") != "1":
    REAL_MODELS = [path for path in REAL_MODELS if path.name in ("torus.obj", "s11o_cube_cyl.stp", "rod.msh")]

# What differs from run to run, forecasts made from it, and sums of files that have it; the files are compared.
OF_THE_RUN = ("seconds", "expected", "peak_memory_bytes", "bytes", "checksum")


def same_in_all_runs(value):
    if isinstance(value, dict):
        return {key: same_in_all_runs(item) for key, item in value.items() if key not in OF_THE_RUN}
    return [same_in_all_runs(item) for item in value] if isinstance(value, list) else value


class Results(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="crossgrain-python-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def solved_by_program(self, *arguments):
        subprocess.run([PROGRAM, "solve", *map(str, arguments), "-o", "program.frames", "--quiet"], cwd=self.folder, check=True, timeout=120)

    def assert_same(self, field):
        """All files but for times; the one with the report, and the page that holds it, are compared as JSON."""
        field.write(self.folder / "python.frames")
        python, program = self.folder / "python.frames", self.folder / "program.frames"
        self.assertEqual(sorted(path.name for path in python.iterdir()), sorted(path.name for path in program.iterdir()))
        for path in program.iterdir():
            if path.suffix == ".json":
                self.assertEqual(*[same_in_all_runs(json.loads((folder / path.name).read_text())) for folder in (python, program)])
            elif path.suffix != ".html":
                self.assertEqual(path.read_bytes(), (python / path.name).read_bytes(), path.name)
        np.testing.assert_array_equal(getattr(field, "grid", field).quaternions, getattr(cg.read(program), "grid", cg.read(program)).quaternions)

    def test_of_a_surface_are_the_same(self):
        model = MODELS / "bracket.stl"
        self.solved_by_program(model, "--resolution", 32)
        self.assert_same(cg.solve(str(model), resolution=32, threads=1))

    def test_of_degree_three_and_other_options_are_the_same(self):
        model = MODELS / "bracket.stl"
        self.solved_by_program(model, "--resolution", 24, "--degree", 3, "--seed", 7)
        self.assert_same(cg.solve(str(model), resolution=24, degree=3, seed=7))

    def test_under_constraints_are_the_same(self):
        model, constraints = MODELS / "bracket.stl", self.folder / "axes.json"
        constraints.write_text(json.dumps({"schema": 1, "points": [{"at": [30, 10, 10], "axis": [1, 2, 3]}]}), encoding="utf-8")
        self.solved_by_program(model, "--resolution", 24, "--constraints", constraints)
        self.assert_same(cg.solve(str(model), resolution=24, constraints=constraints))

    def test_of_tets_are_the_same(self):
        mesh = self.folder / "cube.mesh"
        mesh.write_text(medit_text(*cube_of_tets(6, 3.0)), encoding="utf-8")
        self.solved_by_program(mesh)
        self.assert_same(cg.solve(str(mesh)))

    def test_of_tets_prepared_and_repaired_are_the_same(self):
        mesh = self.folder / "ball.mesh"
        mesh.write_text(medit_text(*ball_of_tets(4)), encoding="utf-8")
        self.solved_by_program(mesh, "--prepare", "--repair")
        field = cg.solve(str(mesh), prepare=True, repair=True)
        self.assert_same(field)
        written = cg.read(self.folder / "program.frames")
        np.testing.assert_array_equal(written.quaternions, field.quaternions)
        np.testing.assert_array_equal(written.matchings.axes, field.matchings.axes)

    @unittest.skipUnless(CAD_FILES, "built without OpenCASCADE")
    def test_of_a_cad_file_are_the_same(self):
        subprocess.run([CAD_FILES, self.folder], check=True, stdout=subprocess.DEVNULL)
        model = sorted(self.folder.glob("*.step"))[0]
        self.solved_by_program(model, "--resolution", 32)
        self.assert_same(cg.solve(str(model), resolution=32))

    @unittest.skipUnless(REAL_MODELS, "the real models are not here")
    def test_of_real_models_are_the_same(self):
        for model in REAL_MODELS:
            if model.suffix.lower() in (".step", ".stp") and not CAD_FILES:
                continue
            with self.subTest(model=model.name):
                self.solved_by_program(model, "--resolution", 24, "--force")
                self.assert_same(cg.solve(str(model), resolution=24))

    def test_of_arrays_are_those_of_their_file(self):
        surface = cg.read_surface(MODELS / "bracket.stl")
        field = cg.solve(surface.vertices, surface.triangles, resolution=20)
        np.testing.assert_array_equal(field.quaternions, cg.solve(MODELS / "bracket.stl", resolution=20).quaternions)

    def test_of_samples_are_the_same(self):
        self.solved_by_program(MODELS / "bracket.stl", "--resolution", 32)
        points = np.random.default_rng(0).uniform(-10, 110, (500, 3))
        np.savetxt(self.folder / "points.txt", points, "%.17g")
        printed = subprocess.run([PROGRAM, "sample", "program.frames", "points.txt"], cwd=self.folder, capture_output=True, check=True, text=True)
        expected = np.loadtxt(printed.stdout.splitlines()).reshape(-1, 3, 3)
        np.testing.assert_array_equal(cg.read(self.folder / "program.frames").sample(points), expected)

    def test_in_a_folder_are_one_result_to_the_program(self):
        field = cg.solve(*ball(), resolution=16)
        field.write(self.folder / "ball.frames")
        field.streamlines(count=3).write(self.folder / "ball.frames" / "streamlines.vtu")
        subprocess.run([PROGRAM, "render", "ball.frames", "--size", "64x64", "--streamlines", "-o", "ball.png"], cwd=self.folder,
                       check=True, timeout=60)
        field.streamlines(count=3).write(self.folder / "elsewhere.vtu")

    def test_of_a_check_are_the_same(self):
        (self.folder / "ball.stl").write_bytes(stl_bytes(*ball()))
        self.solved_by_program("ball.stl", "--resolution", 24)
        printed = subprocess.run([PROGRAM, "check", "program.frames", "--json"], cwd=self.folder, capture_output=True, check=False, text=True)
        answer = cg.read(self.folder / "program.frames").check()
        self.assertEqual((answer.verdict, answer.sentence), (json.loads(printed.stdout)["verdict"], json.loads(printed.stdout)["answer"]))


if __name__ == "__main__":
    unittest.main()
