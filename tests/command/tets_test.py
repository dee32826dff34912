#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain tets` and `solve --tets`: what they write is measured by independent code; failures are one line and leave nothing.

CROSSGRAIN_CAD_FILES is the program that makes CAD files. Tests that need gmsh or Netgen are skipped where they are not installed.
"""

import json
import os
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

from program import (PROGRAM, TIME_LIMIT, CommandTest, box_triangles, medit_text, no_more_processes, of_the_day, sphere_triangles,
                     stl_bytes, tet_box)
from tagged_mesh import TaggedMesh

CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared")) / "models"
ROOT = Path(__file__).resolve().parents[2]
HAS_GMSH = shutil.which("gmsh") is not None
HAS_NETGEN = (Path(PROGRAM).parents[2] / "libexec" / "crossgrain" / "crossgrain_netgen").exists()
MAKERS = [name for name, there in (("gmsh", HAS_GMSH), ("netgen", HAS_NETGEN)) if there]
USAGE, INPUT, OUTPUT, LIMIT, INTERRUPTED = 2, 3, 4, 5, 130

STEP = "ISO-10303-21;\nEND-ISO-10303-21;\n"


def volume_of(mesh):
    corners = mesh.vertices[mesh.tets]
    return np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).sum() / 6


class TetsTest(CommandTest):
    """A test with a folder for temporary files besides its own, in which nothing may stay."""

    def setUp(self):
        super().setUp()
        self.places = tempfile.TemporaryDirectory(prefix="crossgrain-places-")
        self.addCleanup(self.places.cleanup)
        self.environment = {**os.environ, "TMPDIR": self.places.name}

    def tets(self, model, *arguments, **options):
        options.setdefault("env", self.environment)
        result = self.run_here("tets", model, *arguments, **options)
        self.assertEqual(os.listdir(self.places.name), [])
        return result

    def made(self, model, *arguments):
        self.assert_succeeds(self.tets(model, "-o", "out.mesh", *arguments))
        return TaggedMesh(self.folder / "out.mesh")

    def with_gmsh(self, script):
        """The environment in which `gmsh` is this script."""
        (self.folder / "bin").mkdir(exist_ok=True)
        self.write("bin/gmsh", f"#!/bin/sh\n{script}\n").chmod(0o755)
        return {**self.environment, "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"}

    def assert_sound(self, mesh):
        self.assertGreater(mesh.volumes().min(), 0)
        self.assertEqual(len(np.unique(mesh.tets)), len(mesh.vertices))
        tagged = [tuple(sorted(triangle)) for triangle in mesh.triangles.tolist()]
        self.assertEqual(len(tagged), len(set(tagged)))
        self.assertEqual(set(tagged), mesh.boundary())
        edges = [tuple(sorted(edge)) for edge in mesh.edges.tolist()]
        self.assertEqual(len(edges), len(set(edges)))


@unittest.skipUnless(MAKERS, "neither gmsh nor Netgen is installed")
class Made(TetsTest):
    def test_a_box_is_filled_and_its_faces_and_edges_are_tagged(self):
        self.write("box.stl", stl_bytes(box_triangles((2, 1, 1.5))))
        for maker in MAKERS:
            with self.subTest(maker):
                mesh = self.made("box.stl", "--by", maker, "--size", "0.3")
                self.assert_sound(mesh)
                self.assertAlmostEqual(mesh.volumes().sum(), 3, 6)
                self.assertEqual(set(mesh.triangle_tags), set(range(1, 7)))
                self.assertEqual(len(set(mesh.edge_tags[mesh.ridges])), 12)
                # Each tag has one plane, and each edge lies on two of them.
                for tag in range(1, 7):
                    corners = mesh.vertices[mesh.triangles[mesh.triangle_tags == tag]].reshape(-1, 3)
                    self.assertLess(np.ptp(corners, axis=0).min(), 1e-9)
                lengths = np.linalg.norm(np.subtract(*(mesh.vertices[mesh.edges[:, k]] for k in (0, 1))), axis=1)
                self.assertAlmostEqual(lengths.sum(), 4 * (2 + 1 + 1.5), 6)
                self.assertLess(lengths.max(), 0.48)

    def test_the_summary_tells_what_was_made(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        result = self.tets("box.stl")
        self.assert_succeeds(result)
        mesh = TaggedMesh(self.folder / "box.mesh")
        self.assertIn(f"{len(mesh.tets)} on {len(mesh.vertices)} vertices, in 1 region", result.stdout)
        self.assertIn(f"mean ratio {mesh.mean_ratios().min():.3g} at worst", result.stdout)
        self.assertIn("of 6 patches", result.stdout)
        self.assertIn("result     box.mesh", result.stdout)
        self.assertEqual(result.stderr, "")
        self.assertEqual(self.tets("box.stl", "--quiet").stdout, "")

    def test_smaller_tets_are_more(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        coarse, fine = (len(self.made("box.stl", "--edges", n).tets) for n in (5, 9))
        self.assertGreater(fine, 2 * coarse)

    def test_a_mesh_for_gmsh_holds_the_same_tets(self):
        self.write("sphere.stl", stl_bytes(sphere_triangles()))
        mesh = self.made("sphere.stl", "--edges", "6")
        self.assert_succeeds(self.tets("sphere.stl", "--edges", "6", "-o", "out.msh"))
        lines = (self.folder / "out.msh").read_text().splitlines()
        elements = [line.split() for line in lines[lines.index("$Elements") + 2:lines.index("$EndElements")]]
        tets = np.array([row[5:] for row in elements if row[1] == "4"], int) - 1
        np.testing.assert_array_equal(tets, mesh.tets)

    def test_solving_the_file_and_solving_with_tets_is_the_same(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        self.assert_succeeds(self.tets("box.stl", "--size", "0.3", "-o", "tets.mesh"))
        self.assert_succeeds(self.run_here("solve", "tets.mesh", "-o", "one", "--quiet", "--no-report"))
        result = self.run_here("solve", "box.stl", "--tet-size", "0.3", "-o", "other", "--write", "fra", "--no-report", env=self.environment)
        self.assert_succeeds(result)
        self.assertEqual(os.listdir(self.places.name), [])
        self.assertEqual((self.folder / "one" / "onto.frames").read_bytes().split(b"\n", 1)[1],
                         (self.folder / "other" / "onto.frames").read_bytes().split(b"\n", 1)[1])
        report = json.loads((self.folder / "other" / "report.json").read_text())
        self.assertEqual(report["model"]["path"], "box.stl")
        self.assertTrue((self.folder / "other" / "onto.fra").exists())

    def test_options_that_contradict_each_other_are_refused(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        self.assert_fails(self.tets("box.stl", "--size", "1", "--edges", "3"), USAGE, "--edges", "--size")
        self.assert_fails(self.tets("box.stl", "--glue"), USAGE, "--glue is for CAD files")
        self.assert_fails(self.tets("box.stl", "-o", "out.vtk"), USAGE, "out.vtk", ".mesh or .msh")
        self.assert_fails(self.run_here("solve", "box.stl", "--tets", "--onto", "x.mesh"), USAGE, "--onto")
        self.assert_fails(self.run_here("solve", "x.mesh", "--tets"), USAGE, "--tets is not for")

    def test_files_of_others_are_not_replaced_unless_they_are_named(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        self.write("box.mesh", "mine")
        self.assert_fails(self.tets("box.stl"), OUTPUT, "box.mesh", "did not write it")
        self.assertEqual((self.folder / "box.mesh").read_text(), "mine")
        self.assert_succeeds(self.tets("box.stl", "-o", "box.mesh"))
        self.assert_succeeds(self.tets("box.stl"))
        self.write("box.mesh", (self.folder / "box.mesh").read_text() + "# mine\n")
        self.assert_fails(self.tets("box.stl"), OUTPUT, "box.mesh", "was changed since Crossgrain wrote it", "-o")
        self.assertIn("# mine", (self.folder / "box.mesh").read_text())

    def test_models_of_the_project_become_good_tets(self):
        for name in of_the_day(("bracket", "wedge"), "wedge"):
            for maker in MAKERS:
                with self.subTest(name=name, maker=maker):
                    mesh = self.made(ROOT / "models" / f"{name}.stl", "--by", maker, "--edges", "10", "--per-circle", "12")
                    self.assert_sound(mesh)
                    self.assertGreater(mesh.mean_ratios().min(), 0.05)
                    self.assertGreater(mesh.mean_ratios().mean(), 0.7)

    def test_shared_models_become_good_tets(self):
        models = [path for path in (SHARED / "good").glob("*") if path.suffix.lower() in (".stl", ".obj", ".ply")]
        if not models:
            self.skipTest("no shared models")
        # By day a smooth surface and one with creases.
        for model in of_the_day(models, "torus.obj", "platonic_shelf.obj"):
            for maker in MAKERS:
                with self.subTest(model=model.name, maker=maker):
                    mesh = self.made(model, "--by", maker, "--edges", "8", "--per-circle", "12")
                    self.assert_sound(mesh)
                    self.assertGreater(mesh.mean_ratios().min(), 0.01)


@unittest.skipUnless(MAKERS and CAD_FILES, "no gmsh and no Netgen, or built without OpenCASCADE")
class MadeOfCad(TetsTest):
    def setUp(self):
        super().setUp()
        subprocess.run([CAD_FILES, self.folder], capture_output=True, timeout=TIME_LIMIT, check=True)

    def test_a_cylinder_has_its_three_faces(self):
        for maker in MAKERS:
            with self.subTest(maker):
                mesh = self.made("cylinder.step", "--by", maker)
                self.assert_sound(mesh)
                self.assertAlmostEqual(mesh.volumes().sum() / (np.pi * 25 * 20), 1, delta=0.03)
                middles = mesh.vertices[mesh.triangles].mean(axis=1) - [3, 4, 5]
                side = np.hypot(middles[:, 0], middles[:, 1]) > 4.9
                is_end = (np.abs(middles[:, 2]) < 1e-6) | (np.abs(middles[:, 2] - 20) < 1e-6)
                tags = {name: set(mesh.triangle_tags[chosen]) for name, chosen in
                        (("side", side & ~is_end), ("bottom", np.abs(middles[:, 2]) < 1e-6),
                         ("top", np.abs(middles[:, 2] - 20) < 1e-6))}
                self.assertEqual(sorted(tag for one in tags.values() for tag in one), [1, 2, 3])
                rims = mesh.vertices[mesh.edges[mesh.ridges]].reshape(-1, 3) - [3, 4, 5]
                np.testing.assert_allclose(np.hypot(rims[:, 0], rims[:, 1]), 5, atol=1e-6)

    def test_constraints_on_faces_hold_on_made_tets(self):
        self.write("c.json", '{"schema": 1, "faces": [{"face": 1, "axis": "normal"}]}')
        self.assert_succeeds(self.run_here("solve", "plate.step", "--tets", "--constraints", "c.json", "-o", "out", "--no-report"))
        report = json.loads((self.folder / "out" / "report.json").read_text())
        self.assertEqual(report["constraints"]["faces"]["count"], 1)
        self.assertLess(report["constraints"]["faces"]["angle_deg"]["mean"], 5)

    def test_the_report_has_the_unit_of_the_file(self):
        for tets in ((), ("--tets",), ("--tets", "--prepare")):
            with self.subTest(tets):
                self.assert_succeeds(self.run_here("solve", "plate.step", *tets, "-o", "out", "--resolution", 16, "--force", "--no-report"))
                model = json.loads((self.folder / "out" / "report.json").read_text())["model"]
                self.assertEqual((model["unit"], model["file_unit"]), ("mm", "mm"))

    def test_glued_solids_are_regions_of_one_mesh(self):
        mesh = self.made("pocket.step", "--glue")
        self.assert_sound(mesh)
        self.assertEqual(set(mesh.regions), {1, 2})

    def test_an_open_shell_names_its_hole(self):
        self.assert_fails(self.tets("open.brep"), INPUT, "open.brep", "1 hole: ", "close these holes first")

    def test_a_damaged_file_is_told_by_the_reader(self):
        text = (self.folder / "plate.step").read_text()
        self.write("cut.step", text[:len(text) // 2])
        self.assert_fails(self.tets("cut.step"), INPUT, "cut.step", "cut short")


class Refused(TetsTest):
    def test_holes_are_filled_and_told_with_the_place_of_the_largest(self):
        triangles = sphere_triangles()
        middles = triangles.mean(axis=1)
        is_gone = (np.linalg.norm(middles - [0, 0, 1], axis=1) < 0.3) | (np.linalg.norm(middles - [1, 0, 0], axis=1) < 0.5)
        self.write("open.stl", stl_bytes(triangles[~is_gone]))
        result = self.tets("open.stl")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("holes: 2, the largest", result.stderr)
        self.assertIn("filled with triangles", result.stderr)
        place = np.array(result.stderr.split("around, at ")[1].split(";")[0].split(), float)
        self.assertLess(np.linalg.norm(place - [1, 0, 0]), 0.5)
        volume = volume_of(TaggedMesh(self.folder / "open.mesh"))
        self.assertGreater(volume, 3.5)
        self.assertLess(volume, 4.19)

    def test_parts_that_overlap_are_united_and_told_where(self):
        boxes = np.concatenate([box_triangles((2, 2, 2)), box_triangles((2, 2, 2)) + [1.1, 0.7, 0.9]])
        self.write("two.stl", stl_bytes(boxes))
        result = self.tets("two.stl")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("overlapping components: 1, at", result.stderr)
        self.assertAlmostEqual(volume_of(TaggedMesh(self.folder / "two.mesh")), 16 - 0.9 * 1.3 * 1.1, 6)

    def test_a_surface_around_nothing_is_told(self):
        self.write("sheet.stl", stl_bytes(box_triangles()[:2]))
        self.assert_fails(self.tets("sheet.stl"), INPUT, "sheet.stl", "encloses nothing")

    def test_a_tet_mesh_needs_no_tets(self):
        self.write("a.mesh", medit_text(*tet_box()))
        self.assert_fails(self.tets("a.mesh", "-o", "b.mesh"), INPUT, "a.mesh", "holds tets already")

    def test_a_mesh_of_hexahedra_is_told_so(self):
        self.write("a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n1\n0 0 0 0\nHexahedra\n1\n1 1 1 1 1 1 1 1 0\nEnd\n")
        self.assert_fails(self.tets("a.mesh", "-o", "b.mesh"), INPUT, "a.mesh: line 7: hexahedra (1), but only tets can be used")

    def test_too_many_tets_are_told_before_the_work(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        begin = time.monotonic()
        self.assert_fails(self.tets("box.stl", "--size", "1e-3"), LIMIT, "are to be expected", "--size or --edges")
        self.assertLess(time.monotonic() - begin, 20)


class WithoutPrograms(TetsTest):
    def test_one_line_says_what_to_install(self):
        alone = shutil.copy(PROGRAM, self.folder / "alone")
        self.write("box.stl", stl_bytes(box_triangles()))
        environment = {**self.environment, "PATH": ""}
        result = self.tets("box.stl", program=str(alone), env=environment)
        self.assert_fails(result, INPUT, "box.stl", "no program that makes tets", "install gmsh")
        result = self.tets("box.stl", "--by", "gmsh", program=str(alone), env=environment)
        self.assert_fails(result, INPUT, "box.stl", "gmsh", "not in PATH", "install gmsh")
        result = self.tets("box.stl", "--by", "netgen", program=str(alone), env=environment)
        self.assert_fails(result, INPUT, "box.stl", "crossgrain_netgen is not installed", "crossgrain-netgen")
        self.assertFalse((self.folder / "box.mesh").exists())

    def test_neither_the_program_nor_the_library_link_netgen(self):
        linked = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True, timeout=TIME_LIMIT, check=True).stdout
        for name in ("libnglib", "libmpi", "libpython", "libGL", "libtcl"):
            self.assertNotIn(name, linked)


class WithAFaultyGmsh(TetsTest):
    def setUp(self):
        super().setUp()
        self.write("box.stl", stl_bytes(box_triangles()))

    def failed(self, script, *arguments):
        result = self.tets("box.stl", "--by", "gmsh", *arguments, env=self.with_gmsh(script))
        self.assertFalse((self.folder / "box.mesh").exists())
        return result

    def test_a_crash_is_one_line(self):
        self.assert_fails(self.failed("kill -SEGV $$"), INPUT, "box.stl", "gmsh crashed on it (Segmentation fault)", "--size", "--by")

    def test_an_error_is_passed_on(self):
        self.assert_fails(self.failed("echo 'Error   : No elements in volume 1'"), INPUT, "gives up on it (No elements in volume 1)")

    def test_what_it_prints_cannot_break_the_line(self):
        self.assert_fails(self.failed("printf 'Error   : a\\033[2Jb\\001c\\n'; yes | head -c 100000"), INPUT, "gives up on it (a [2Jb c)")

    def test_its_time_is_limited(self):
        begin = time.monotonic()
        self.assert_fails(self.failed("sleep 1000; true", "--seconds", "0.5"), LIMIT, "did not finish within 0.5 s", "--seconds")
        self.assertLess(time.monotonic() - begin, 30)

    def test_a_system_without_processes_left_is_told(self):
        Path(self.places.name).chmod(0o777)
        result = self.run_without_privileges("tets", "box.stl", "--by", "gmsh", "--threads", "1", env=self.with_gmsh("true"), preexec_fn=no_more_processes)
        self.assert_fails(result, LIMIT, "box.stl", "starts no more processes", "ulimit -u")

    def test_a_file_that_the_system_cuts_off_is_told(self):
        def little_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
        result = self.tets("box.stl", "--by", "gmsh", env=self.with_gmsh('yes > "$(dirname "$1")/tets.msh"; kill -XFSZ $$'),
                           preexec_fn=little_files)
        self.assert_fails(result, OUTPUT, self.places.name, "temporary files cannot be written", "TMPDIR")

    def test_no_place_for_temporary_files_is_told(self):
        environment = {**self.with_gmsh("true"), "TMPDIR": "/proc/self"}
        self.assert_fails(self.tets("box.stl", "--by", "gmsh", env=environment), OUTPUT, "temporary files cannot be written", "TMPDIR")

    @unittest.skipUnless(HAS_GMSH, "gmsh is not installed")
    def test_a_failure_with_new_triangles_is_followed_by_the_given_ones_with_a_warning(self):
        script = f'test -e once || {{ touch once; exit 1; }}\nexec {shutil.which("gmsh")} "$@"'
        result = self.tets("box.stl", "--by", "gmsh", env=self.with_gmsh(script))
        self.assert_succeeds(result)
        self.assertIn("warning: box.stl: gmsh makes no tets of it, so the tets were made in another way", result.stderr)
        self.assertEqual(len(TaggedMesh(self.folder / "box.mesh").triangles), 12)

    def test_what_it_has_started_ends_with_it_and_with_the_program(self):
        script = f"sleep 1000 & echo $! > {self.folder}/process; wait"
        for end in ("its time", signal.SIGINT, signal.SIGKILL):
            with self.subTest(end=str(end)):
                note, deadline = self.folder / "process", time.monotonic() + TIME_LIMIT
                note.unlink(missing_ok=True)
                seconds = "0.5" if end == "its time" else "600"
                process = subprocess.Popen([PROGRAM, "tets", "box.stl", "--by", "gmsh", "--seconds", seconds], cwd=self.folder,
                                           env=self.with_gmsh(script), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                self.addCleanup(process.kill)
                while not (note.exists() and note.read_text().endswith("\n")):
                    self.assertLess(time.monotonic(), deadline)
                    time.sleep(0.01)
                if end != "its time":
                    process.send_signal(end)
                process.wait(TIME_LIMIT)
                while os.path.exists(f"/proc/{int(note.read_text())}"):
                    self.assertLess(time.monotonic(), deadline)
                    time.sleep(0.01)

    def test_an_interrupt_ends_it_and_leaves_nothing(self):
        for command in ("tets", "solve"):
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(command=command, number=number.name):
                    environment = self.with_gmsh(f"echo $$ > {self.folder}/process; sleep 1000; true")
                    extra = [] if command == "tets" else ["--tets", "-o", "out"]
                    process = subprocess.Popen([PROGRAM, command, "box.stl", *extra], cwd=self.folder, env=environment,
                                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                    self.addCleanup(process.kill)
                    note = self.folder / "process"
                    deadline = time.monotonic() + TIME_LIMIT
                    while not (note.exists() and note.read_text().endswith("\n")):
                        self.assertLess(time.monotonic(), deadline)
                        time.sleep(0.01)
                    process.send_signal(number)
                    output, errors = process.communicate(timeout=TIME_LIMIT)
                    self.assert_fails(subprocess.CompletedProcess([], process.returncode, output, errors), INTERRUPTED, "interrupted")
                    while os.path.exists(f"/proc/{int(note.read_text())}"):
                        self.assertLess(time.monotonic(), deadline)
                        time.sleep(0.01)
                    self.assertEqual(os.listdir(self.places.name), [])
                    self.assertEqual(self.names(), ["bin", "box.stl", "process"])
                    note.unlink()


if __name__ == "__main__":
    unittest.main()
