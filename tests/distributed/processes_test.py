# SPDX-License-Identifier: Apache-2.0
"""crossgrain-mpi as its users see it: results, checkpoints and faults, beside `crossgrain`.

CROSSGRAIN_MPI_PROGRAM names the program, CROSSGRAIN_PROGRAM the one for a process alone; CROSSGRAIN_MPIRUN starts it.
CROSSGRAIN_BREAKS is how many solves are broken off, 2 unless it says otherwise, CROSSGRAIN_SEED when.
"""

import importlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "command"))
import numpy as np
from field_reader import read_arrays
from page_reader import Page
from program import CommandTest, by_night, of_the_day, run

MPI_PROGRAM = os.environ["CROSSGRAIN_MPI_PROGRAM"]
MPIRUN = os.environ.get("CROSSGRAIN_MPIRUN", "mpirun")
MODELS = Path(__file__).parents[2] / "models"
BRACKET = MODELS / "bracket.stl"
# Here processes share a level of so many cells or more, in place of 200,000. The bracket has 18,165 at this resolution, in five blocks,
# and 10,506 at the other.
SHARED_CELLS, SHARED, NOT_SHARED = 12000, 48, 40
# The bracket has 228,655 cells at this one: enough to be shared anywhere.
SHARED_ANYWHERE = 190

# What differs from run to run: times, forecasts made from them, and sums of files. The name of the solve is a sum of all cells.
OF_THE_RUN = ("seconds", "expected", "threads", "peak_memory_bytes", "files", "checksum")

# The number of cells decides the order of sweeps, so it holds for a process alone too.
os.environ.setdefault("CROSSGRAIN_BLOCKED_CELLS", str(SHARED_CELLS))
# The superuser may run OpenMPI only if the first two say so; by the third, processes that wait leave their core to others.
ENVIRONMENT = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}
START = [MPIRUN, "-q", "--oversubscribe", "--bind-to", "none"]


def without_number_of_cells(environment):
    """The environment in which processes share levels as they do for users."""
    return {name: value for name, value in environment.items() if name != "CROSSGRAIN_BLOCKED_CELLS"}


def same_in_all_runs(value):
    """A report without OF_THE_RUN."""
    if isinstance(value, dict):
        return {key: same_in_all_runs(item) for key, item in value.items() if key not in OF_THE_RUN}
    return [same_in_all_runs(item) for item in value] if isinstance(value, list) else value


def cells_in(folder):
    """{name: values} of field.vtu, or of all pieces; corners in place of points and indices."""
    files = [folder / piece.get("Source") for piece in ElementTree.parse(folder / "field.pvtu").iter("Piece")] if (
        folder / "field.pvtu").exists() else [folder / "field.vtu"]
    parts = []
    for file in files:
        arrays = read_arrays(file)
        arrays["corners"] = arrays.pop("Points")[arrays.pop("connectivity")]
        del arrays["offsets"]
        parts.append(arrays)
    of_whole = ("crossgrain_schema", "degree", "root_cube", "output_level")
    return {name: values if name in of_whole else np.concatenate([part[name] for part in parts]) for name, values in parts[0].items()}


def stl_of(triangles):
    records = np.zeros(len(triangles), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]))
    records["corners"] = triangles
    return bytes(80) + np.uint32(len(records)).tobytes() + records.tobytes()


def sphere(across, open_above=2.0):
    """Triangles of a unit sphere, without those above a height."""
    u = np.linspace(0, np.pi, across // 2 + 1)
    v = np.linspace(0, 2 * np.pi, across + 1)
    points = np.stack([np.outer(np.sin(u), np.cos(v)), np.outer(np.sin(u), np.sin(v)), np.outer(np.cos(u), np.ones_like(v))], -1)
    points[0], points[-1], points[:, -1] = (0, 0, 1), (0, 0, -1), points[:, 0]
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    triangles = np.concatenate([np.stack([a, b, c], 2).reshape(-1, 3, 3), np.stack([a, c, d], 2).reshape(-1, 3, 3)])
    areas = np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1)
    return triangles[(areas > 1e-9) & (triangles[:, :, 2].max(axis=1) < open_above)]


def box(size):
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]) * np.array(size)
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return np.array([[corners[f[0]], corners[f[i]], corners[f[i + 1]]] for f in faces for i in (1, 2)])


def import_or_skip(test, name):
    try:
        return importlib.import_module(name)
    except ImportError:
        return test.skipTest(f"{name} is not installed")


def why_none_start():
    """Empty if mpirun can start processes here."""
    try:
        started = subprocess.run([*START, "-n", "2", "true"], capture_output=True, text=True, timeout=60, check=False, env=ENVIRONMENT)
    except (OSError, subprocess.TimeoutExpired) as error:
        return str(error)
    return "" if started.returncode == 0 else started.stderr


NONE_START = why_none_start()

@unittest.skipIf(NONE_START, f"mpirun cannot start processes: {NONE_START}")
class ProcessesTest(CommandTest):
    def together(self, processes, *arguments, **options):
        command = [*START, "-n", str(processes), MPI_PROGRAM, *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False, cwd=self.folder, **{"env": ENVIRONMENT, **options})

    def solved_alone(self, model, *options):
        def make():
            result = self.run_here("solve", model, "-o", "alone", "--quiet", "--no-report", *options)
            self.assert_succeeds(result)
            return result
        return self.copied_from_first("alone", ("alone", *options), make) if model == BRACKET else make()

    def assert_same_as_alone(self, folder):
        """Cells, frames and all other numbers, but for times."""
        here, alone = self.folder / folder, self.folder / "alone"
        reports = [same_in_all_runs(json.loads((path / "report.json").read_text())) for path in (here, alone)]
        self.assertEqual(*reports)
        for name in ("singularities.vtu", "surface.vtu"):
            self.assertEqual(*[(path / name).read_bytes().split(b"</UnstructuredGrid>")[-1] for path in (here, alone)], name)
        cells, expected = cells_in(here), cells_in(alone)
        self.assertEqual(cells.keys(), expected.keys())
        for name, values in expected.items():
            np.testing.assert_array_equal(cells[name], values, name)

    def assert_same_on(self, numbers, model, *options, is_shared=True):
        alone = self.solved_alone(model, *options)
        for processes in numbers:
            result = self.together(processes, "solve", model, "-o", "together", "--quiet", "--no-report", "--threads", 1, "--force", *options)
            self.assertEqual((result.returncode, result.stderr), (0, alone.stderr))
            self.assertEqual((self.folder / "together" / "field.pvtu").exists(), is_shared)
            self.assert_same_as_alone("together")

    def assert_ends(self, result, code, *words):
        """Exit code and one line."""
        self.assertEqual(result.returncode, code, result.stderr)
        lines = [line for line in result.stderr.splitlines() if line.startswith("crossgrain: ")]
        self.assertEqual(len(lines), 1, result.stderr)
        for word in words:
            self.assertIn(word, lines[0])


class Fields(ProcessesTest):
    @by_night
    def test_of_a_part_with_creases_are_the_same_on_any_number_of_processes(self):
        self.assert_same_on((5,), BRACKET, "--resolution", SHARED)

    def test_are_the_same_on_so_many_processes_that_some_have_no_cells(self):
        # Eight blocks of 4096 cells: the first process has none.
        self.assert_same_on((9,), self.write("box.stl", stl_of(box((1, 1, 1)))), "--resolution", 48)

    def test_of_degree_3_inside_a_curved_surface_are_the_same(self):
        self.assert_same_on((3,), self.write("sphere.stl", stl_of(sphere(48))), "--resolution", 48, "--degree", 3)

    @by_night
    def test_inside_an_open_surface_are_the_same(self):
        self.assert_same_on((2,), self.write("open.stl", stl_of(sphere(32, 0.8))), "--resolution", 50)

    @by_night
    def test_in_a_thin_wall_are_the_same(self):
        self.assert_same_on((2,), self.write("wall.stl", stl_of(box((4, 3, 0.02)))), "--resolution", 190)

    def test_too_small_to_share_are_the_same(self):
        self.assert_same_on((3,), BRACKET, "--resolution", NOT_SHARED, is_shared=False)

    def test_under_constraints_are_the_same(self):
        self.write("axes.json", json.dumps({"schema": 1, "points": [{"at": [30, 10, 10], "axis": [1, 2, 3]}], "polylines": [
            {"points": [[20, 10, 5], [60, 20, 20], [100, 60, 10]], "axis": "tangent", "weight": 3}]}))
        self.assert_same_on((3,), BRACKET, "--resolution", SHARED, "--constraints", "axes.json")


class Pieces(ProcessesTest):
    OPTIONS = ("--resolution", SHARED, "--quiet", "--no-report", "--threads", 1)

    def solve_in_pieces(self, *options):
        result = self.together(3, "solve", BRACKET, "-o", "together", *self.OPTIONS, *options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def solved_in_pieces(self, *options):
        self.copied_from_first("together", ("together", *options), lambda: self.solve_in_pieces(*options))

    def names_in_result(self):
        return sorted(path.name for path in (self.folder / "together").iterdir())

    def test_are_read_by_every_command_as_one_field(self):
        self.solved_alone(BRACKET, "--resolution", SHARED)
        self.solved_in_pieces()
        self.write("points.txt", "10 10 3\n100 40 7\n60 20 4\n-5 0 0\n")
        for field in ("alone", "together"):
            self.assert_succeeds(self.run_here("sample", field, "points.txt", "-o", f"{field}.txt"))
            self.assert_succeeds(self.run_here("render", field, "--size", "200x150", "-o", f"{field}.png"))
            self.assert_succeeds(self.run_here("solve", BRACKET, "--from", field, "--resolution", 40, "-o", f"{field}-again", "--no-report", "--quiet"))
        self.assertEqual(*[self.run_here("check", field).stdout for field in ("alone", "together")])
        for name in ("{}.txt", "{}.png", "{}-again/field.vtu"):
            self.assertEqual(*[(self.folder / name.format(field)).read_bytes() for field in ("alone", "together")])

    def test_are_opened_by_vtk(self):
        vtk = import_or_skip(self, "vtkmodules.vtkIOXML")
        self.solved_in_pieces()
        reader = vtk.vtkXMLPUnstructuredGridReader()
        reader.SetFileName(str(self.folder / "together" / "field.pvtu"))
        reader.Update()
        cells = cells_in(self.folder / "together")
        grid = reader.GetOutput()
        self.assertEqual(grid.GetNumberOfCells(), len(cells["level"]))
        for name in ("axis_u", "level", "energy_density"):
            values = grid.GetCellData().GetArray(name)
            np.testing.assert_array_equal(np.array([values.GetTuple(i) for i in range(0, len(cells[name]), 997)]).squeeze(), cells[name][::997])

    @by_night
    def test_hold_merged_cells_as_one_process_merges_them(self):
        self.solved_alone(BRACKET, "--resolution", SHARED, "--output-level", 5)
        self.solved_in_pieces("--output-level", 5)
        self.assert_same_as_alone("together")

    @by_night
    def test_are_shown_on_a_page_with_merged_cells(self):
        result = self.together(2, "solve", BRACKET, "-o", "together", "--resolution", SHARED_ANYWHERE, "--quiet", "--threads", 1,
                               env=without_number_of_cells(ENVIRONMENT))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("field_1.vtu", self.names_in_result())
        page = Page(self.folder / "together" / "report.html")
        shown = page.header["cells"]
        self.assertEqual(shown["total"], page.report["levels"][-1]["active_cells"])
        self.assertLessEqual(shown["shown"], 200000)
        self.assertLess(shown["shown"], shown["total"])
        self.assertIsNotNone(shown["merged_to"])

    def test_are_gathered_for_a_clip(self):
        options = ("--resolution", SHARED, "--clip", "20,0,0,60,30,20")
        self.solved_alone(BRACKET, *options)
        self.solved_in_pieces(*options[2:])
        self.assertIn("field.vtu", self.names_in_result())
        self.assert_same_as_alone("together")

    def test_replace_and_are_replaced(self):
        self.solved_in_pieces()
        pieces = ["field.pvtu", "field_0.vtu", "field_1.vtu", "field_2.vtu", "report.json", "singularities.vtu", "surface.vtu"]
        self.assertEqual(self.names_in_result(), pieces)
        self.assertEqual(self.together(2, "solve", BRACKET, "-o", "together", *self.OPTIONS).returncode, 0)
        self.assertEqual(self.names_in_result(), [name for name in pieces if name != "field_2.vtu"])
        self.assert_succeeds(self.run_here("solve", BRACKET, "-o", "together", *self.OPTIONS))
        self.assertEqual(self.names_in_result(), ["field.vtu", *pieces[-3:]])
        self.solve_in_pieces()
        self.assertEqual(self.names_in_result(), pieces)

    def test_that_are_missing_or_of_another_solve_are_named(self):
        self.solved_in_pieces()
        piece = self.folder / "together" / "field_1.vtu"
        content = piece.read_bytes()
        self.assert_succeeds(self.run_here("solve", BRACKET, "-o", "other", "--resolution", 40, "--quiet", "--no-report"))
        shutil.copy(self.folder / "other" / "field.vtu", piece)
        self.assert_ends(self.run_here("check", "together"), 3, "field_1.vtu", "another solve")
        self.assert_ends(self.together(3, "solve", BRACKET, "-o", "together", *self.OPTIONS), 4, "field_1.vtu", "was changed")
        piece.write_bytes(content[:len(content) // 2])
        self.assert_ends(self.run_here("check", "together"), 3, "field_1.vtu", "cut short")
        piece.unlink()
        self.assert_ends(self.run_here("check", "together"), 3, "field_1.vtu")

    def test_that_cannot_be_written_are_told_once_and_keep_the_earlier_result(self):
        self.assert_succeeds(self.run_here("solve", BRACKET, "-o", "together", "--resolution", 40, "--quiet", "--no-report"))
        before = (self.folder / "together" / "field.vtu").read_bytes()
        (self.folder / "together" / "field_1.vtu").mkdir()
        self.assert_ends(self.together(3, "solve", BRACKET, "-o", "together", *self.OPTIONS, "--force"), 4, "field_1.vtu", "is a folder")
        (self.folder / "together" / "field_1.vtu").rmdir()
        (self.folder / "together" / "field_1.vtu").write_text("mine")
        self.assert_ends(self.together(3, "solve", BRACKET, "-o", "together", *self.OPTIONS), 4, "field_1.vtu", "did not write")
        self.assertEqual((self.folder / "together" / "field.vtu").read_bytes(), before)
        self.assertEqual(self.names_in_result(), ["field.vtu", "field_1.vtu", "report.json", "singularities.vtu", "surface.vtu"])


class Breaks(ProcessesTest):
    OPTIONS = ("--resolution", SHARED, "--quiet", "--no-report", "--threads", 1)

    def test_at_any_moment_lose_nothing_on_another_number_of_processes(self):
        self.solved_alone(BRACKET, "--resolution", SHARED)
        moments = random.Random(int(os.environ.get("CROSSGRAIN_SEED", "7")))
        for processes, afterwards in of_the_day([(2, 3), (3, 1)], (2, 3)) * (int(os.environ.get("CROSSGRAIN_BREAKS", "2")) // 2):
            command = [*START, "-n", str(processes), MPI_PROGRAM, "solve", str(BRACKET), "-o", "broken", *map(str, self.OPTIONS),
                       "--checkpoint", "kept", "--checkpoint-minutes", "0"]
            shutil.rmtree(self.folder / "kept", ignore_errors=True)
            job = subprocess.Popen(command, cwd=self.folder, env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(moments.uniform(0.3, 1.5))
            ranks = subprocess.run(["pgrep", "-P", str(job.pid)], capture_output=True, text=True, check=False).stdout.split()
            if ranks:
                subprocess.run(["kill", "-9", moments.choice(ranks)], check=False)
            job.wait(60)
            restart = ("--restart", "kept") if (self.folder / "kept").is_dir() else ()
            result = self.together(afterwards, "solve", BRACKET, "-o", "together", "--force", *self.OPTIONS, *restart)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assert_same_as_alone("together")

    def test_are_healed_only_by_the_same_model_and_options(self):
        made = self.together(2, "solve", BRACKET, "-o", "first", "--resolution", SHARED, "--quiet", "--no-report", "--checkpoint", "kept")
        self.assertEqual(made.returncode, 0, made.stderr)
        other = self.together(2, "solve", MODELS / "wedge.stl", "-o", "second", "--quiet", "--restart", "kept")
        self.assert_ends(other, 3, "another model")
        creased = self.together(2, "solve", BRACKET, "-o", "second", "--resolution", SHARED, "--crease-angle", 100, "--quiet", "--restart", "kept")
        self.assert_ends(creased, 3, "other options", "give the same")
        start = next((self.folder / "kept").glob("start-*"))
        os.truncate(start, start.stat().st_size - 1)
        cut = self.together(2, "solve", BRACKET, "-o", "second", "--resolution", SHARED, "--quiet", "--restart", "kept")
        self.assert_ends(cut, 3, start.name, "cut short", "without --restart")
        start.unlink()
        anew = self.together(2, "solve", BRACKET, "-o", "second", "--resolution", SHARED, "--quiet", "--no-report", "--restart", "kept")
        self.assertEqual(anew.returncode, 0, anew.stderr)
        missing = self.together(2, "solve", BRACKET, "-o", "third", "--quiet", "--resolution", SHARED, "--restart", "nowhere")
        self.assert_ends(missing, 3, "nowhere", "--checkpoint")
        self.assertFalse((self.folder / "third").exists())


class Faults(ProcessesTest):
    def of_two(self, first, second, program=MPI_PROGRAM):
        """The job of a process with some arguments and another with others."""
        command = [*START, "-n", "1", MPI_PROGRAM, *map(str, first), ":", "-n", "1", program, *map(str, second)]
        return subprocess.run(command, capture_output=True, text=True, timeout=60, check=False, cwd=self.folder, env=ENVIRONMENT)

    def test_of_an_input_that_one_process_cannot_read_are_told_once(self):
        self.assert_ends(self.of_two(("solve", BRACKET, "-o", "out"), ("solve", "missing.stl", "-o", "out")), 3, "process 1", "missing.stl")
        self.assertEqual(self.names(), [])

    def test_of_models_and_options_that_differ_are_told_once(self):
        self.write("ball.stl", stl_of(sphere(16)))
        options = ("-o", "out", "--resolution", 32)
        for other in (("ball.stl", *options), (BRACKET, *options, "--seed", 7)):
            result = self.of_two(("solve", BRACKET, *options), ("solve", *other))
            self.assert_ends(result, 3, "process 1 has another model or other options than process 0")
        self.assertEqual(self.names(), ["ball.stl"])

    def test_of_the_model_are_told_once(self):
        self.assert_ends(self.together(3, "solve", "missing.stl", "-o", "out"), 3, "missing.stl")

    def test_of_usage_are_told_once(self):
        self.assert_ends(self.together(2), 2, "crossgrain-mpi --help")
        self.assert_ends(self.together(2, "solve", BRACKET, "--resolution", "many"), 2, "--resolution")

    def test_of_versions_that_differ_are_told(self):
        other = shutil.copy(MPI_PROGRAM, self.folder / "other")
        with open(other, "ab") as file:
            file.write(b"another build")
        self.assert_ends(self.of_two(("solve", BRACKET), ("solve", BRACKET), other), 2, "process 1", "install one version")

    def test_of_output_are_told_once(self):
        (self.folder / "full").write_bytes(b"")
        self.assert_ends(self.together(2, "solve", BRACKET, "--resolution", 320, "--quiet", "-o", "full"), 4, "full")

    def test_of_memory_are_told_once(self):
        self.assert_ends(self.together(2, "solve", BRACKET, "--resolution", 4096, "--quiet", "-o", "out", "--max-memory", "20MB"), 5, "--max-memory")


class Interruptions(ProcessesTest):
    def test_end_the_solve_with_one_line_and_leave_nothing(self):
        for name in of_the_day((signal.SIGINT, signal.SIGTERM), "SIGINT"):
            with self.subTest(name.name):
                command = [*START, "-n", "2", MPI_PROGRAM, "solve", str(BRACKET), "--resolution", "768", "-o", "out", "--threads", "1"]
                job = subprocess.Popen(command, cwd=self.folder, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                self.addCleanup(job.stdout.close)
                self.addCleanup(job.stderr.close)
                self.assertTrue(job.stdout.readline().startswith("model "))
                job.send_signal(name)
                _, errors = job.communicate(timeout=60)
                self.assertEqual([line for line in errors.splitlines() if line.startswith("crossgrain")], ["crossgrain: interrupted"])
                # The code is that of mpirun, which the signal ends.
                self.assertNotEqual(job.returncode, 0)
                self.assertEqual(self.names(), [])


class Help(ProcessesTest):
    def test_and_version_are_printed_once(self):
        self.assertEqual(self.together(3, "--version").stdout.count("crossgrain-mpi"), 1)
        self.assertEqual(self.together(2, "solve", "--help").stdout.count("--restart DIR"), 1)


if __name__ == "__main__":
    unittest.main()
