#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`solve --repair`, judged from the written files by code of its own (judge_matchings.py).

The meshes of Hex-Me-If-You-Can and of models/good are in the folder that CROSSGRAIN_SHARED names, ../shared beside the project by
default; their tests are skipped where they are absent.
"""

import copy
import itertools
import json
import lzma
import os
import re
import shutil
import signal
import subprocess
import time
import unittest
import zlib
from pathlib import Path

import numpy as np

import tet_solids
from field_reader import read_arrays
from frame_math import CUBE_ROTATIONS
from judge_matchings import MatchedField, differences, read_frames
from judge_mesh import rotations_of
from poisson_map import read_medit
from program import (PROGRAM, CommandTest, box_triangles, medit_text, of_the_day, stl_bytes, tet_box, tilt,
                     without_costs)
from recompute_singularity import Graph

USAGE, INPUT, INTERRUPTED = 2, 3, 130
SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared"))
FORMATS = "mesh,fra,perm"
NORMAL_TOLERANCE = 1e-9
LONGEST_END_SECONDS = 3  # on a busy machine; 0.1 on a quiet one


class RepairTest(CommandTest):
    def solve(self, *arguments, folder="out", key=None):
        """The report; solves with one key are one."""
        def make():
            made = self.run_here("solve", *arguments, "-o", folder, "--verbose")
            self.assert_succeeds(made)
            return made

        result = self.copied_from_first(folder, (*key, *arguments), make) if key else make()
        self.summary, self.messages = result.stdout, result.stderr
        return json.loads((self.folder / folder / "report.json").read_text())

    def repaired(self, vertices, tets, *arguments):
        self.write("solid.mesh", medit_text(vertices @ tilt(), tets))
        return self.solve("solid.mesh", "--repair", "--write", FORMATS, "--no-report", *arguments, key=(vertices.tobytes(), tets.tobytes()))

    def files(self, folder):
        """All files but for what a run takes."""
        content = {path.name: path.read_bytes() for path in (self.folder / folder).iterdir()}
        report = without_costs(json.loads(content.pop("report.json")))
        report["onto"]["repair"].pop("seconds", None)
        report.pop("expected", None)
        return content, report

    def assert_files_agree(self, folder):
        """onto.perm, onto.fra and onto_singularities.vtu are those of the arrays in onto.vtu."""
        path = self.folder / folder
        arrays = read_arrays(path / "onto.vtu")
        tets = arrays["connectivity"].reshape(-1, 4)
        behind = arrays["matching"].reshape(-1, 4, 3).astype(int)
        field = MatchedField(path)
        np.testing.assert_array_equal(field.tets, tets)
        np.testing.assert_allclose(rotations_of(arrays["tet_frame"]), read_frames(path / "onto.fra"), atol=1e-15)
        for k, name in enumerate("uvw"):
            np.testing.assert_allclose(arrays[f"axis_{name}"], field.frames[:, :, k], atol=1e-7)
        for t, k in np.ndindex(field.beside.shape):
            expected = np.zeros(3, int)
            if field.beside[t, k] >= 0:
                rotation = CUBE_ROTATIONS[field.matching[t, k]]
                expected = np.rint((np.abs(rotation).argmax(axis=0) + 1) * rotation.sum(axis=0)).astype(int)
            self.assertEqual(behind[t, k].tolist(), expected.tolist(), (t, k))
        self.assert_arcs_are_the_singular_edges(field, path)

    def assert_arcs_are_the_singular_edges(self, field, path):
        graph = Graph(path / "onto_singularities.vtu")
        edges = []
        for arc in graph.arcs:
            names = graph.arrays["vertex"][arc].tolist()
            edges += [tuple(sorted(pair)) for pair in zip(names[:-1], names[1:])]
        self.assertEqual(sorted(edges), sorted(tuple(field.edges[edge].tolist()) for edge in field.turns))

    def assert_judged_alike(self, report, folder="out"):
        """Edges and vertices without hexahedra are as many as the report says, and at its places."""
        found = differences(self.folder / folder, report)
        self.assertEqual(found, [], "\n".join(found))

    def assert_check_says(self, report, folder="out"):
        checked = json.loads(self.run_here("check", folder, "--json").stdout)
        self.assertEqual((checked["verdict"], checked["reasons"]), (report["verdict"], report["reasons"]))
        self.assertEqual(checked["tets"], report["onto"]["singularity"])


def six_volumes(points, tets):
    return np.linalg.det(points[tets][:, 1:] - points[tets][:, :1])


SOLIDS = {
    "ball": lambda: tet_solids.ball(4),
    "box": lambda: tet_box((4, 3, 3)),
    "angle_iron": lambda: tet_solids.angle_iron(2),
    "prism": lambda: tet_solids.triangular_prism(2),
    "pyramid": lambda: tet_solids.square_pyramid(2),
    "wedge_of_42_degrees": lambda: tet_solids.wedge(42, 2),
}


class FilesOfRepairedFields(RepairTest):
    def test_agree_with_one_another(self):
        for name, solid in SOLIDS.items():
            with self.subTest(name):
                self.repaired(*solid(), "--prepare")
                self.assert_files_agree("out")

    def test_have_matchings_that_are_not_the_nearest(self):
        report = self.repaired(*tet_solids.ball(4), "--prepare")
        field = MatchedField(self.folder / "out")
        self.assertGreater((field.nearest != field.matching).sum(), 0)
        self.assertGreater(report["onto"]["repair"]["changed_faces"], 0)
        self.assertEqual(report["onto"]["singularity"]["edges"], len(field.turns))
        self.assertAlmostEqual(report["onto"]["singularity"]["length"], sum(field.length[edge] for edge in field.turns))

    def test_have_frames_with_an_axis_along_the_normal_at_every_face_of_the_surface(self):
        for name, solid in SOLIDS.items():
            with self.subTest(name):
                self.repaired(*solid(), "--prepare")
                field = MatchedField(self.folder / "out")
                axes = field.frames[field.surface_tets]
                nearest = np.abs(np.einsum("nij,ni->nj", axes, field.normals)).argmax(axis=1)
                off = np.cross(axes[np.arange(len(axes)), :, nearest], field.normals)
                self.assertLess(np.linalg.norm(off, axis=1).max(), NORMAL_TOLERANCE)

    def test_have_vertices_moved_within_flat_parts_of_the_surface_and_inside_only(self):
        for name, solid in SOLIDS.items():
            with self.subTest(name):
                report = self.repaired(*solid(), "--prepare")
                repaired, tets = read_medit(self.folder / "out" / "onto.mesh")
                self.solve("solid.mesh", "--prepare", "--write", FORMATS, "--no-report", folder="plain")
                plain, same = read_medit(self.folder / "plain" / "onto.mesh")
                np.testing.assert_array_equal(tets, same)
                moved = (repaired != plain).any(axis=1)
                self.assertEqual(report["onto"]["repair"]["moved_vertices"], moved.sum())
                field = MatchedField(self.folder / "out")
                self.assertLess(abs(six_volumes(repaired, tets).sum() / six_volumes(plain, tets).sum() - 1), 1e-12)
                self.assertGreater(six_volumes(repaired, tets).min(), 0)
                for face, normal in zip(field.surface, field.normals):
                    off = (repaired[face] - plain[face]) @ normal
                    self.assertLess(np.abs(off).max(), 1e-12)

    def test_do_not_depend_on_the_run_or_the_threads(self):
        self.write("ball.mesh", medit_text(*tet_solids.ball(3)))
        files = []
        for folder, threads in (("one", 1), ("again", 1), ("two", 2)):
            self.solve("ball.mesh", "--prepare", "--repair", "--write", FORMATS, "--no-report", "--threads", threads, folder=folder)
            content, report = self.files(folder)
            files.append((content, report))
        for other in files[1:]:
            self.assertEqual(*[sorted(content) for content, _ in (files[0], other)])
            for name, content in files[0][0].items():
                self.assertEqual(content, other[0][name], name)
            self.assertEqual(files[0][1], other[1])


class AnswersAboutRepairedFields(RepairTest):
    def test_are_those_of_another_judge(self):
        for (name, solid), prepare in itertools.product(SOLIDS.items(), ((), ("--prepare",))):
            with self.subTest(name, prepare=prepare):
                report = self.repaired(*solid(), *prepare)
                self.assert_judged_alike(report)
                self.assert_check_says(report)

    def test_that_it_can_be_meshed_come_after_faults(self):
        report = self.repaired(*tet_solids.wedge(42, 2), "--prepare")
        repair = report["onto"]["repair"]
        self.assertGreater(repair["faults_before"], 0)
        self.assertEqual((repair["faults"], report["verdict"]), (0, "meshable"))
        plain = self.solve("solid.mesh", "--prepare", folder="plain")
        self.assertNotEqual(plain["verdict"], "meshable")

    def test_that_it_cannot_be_meshed_name_the_places(self):
        # Each tet at the sharp edge has two faces on the surface, so no matching can change there.
        report = self.repaired(*tet_solids.wedge(30, 2))
        self.assert_judged_alike(report)
        self.assertGreater(report["onto"]["repair"]["faults"], 0)
        self.assertEqual(report["verdict"], "not_meshable")
        self.assertIn("corner", [reason["kind"] for reason in report["reasons"]])

    def test_that_are_changed_are_found(self):
        report = self.repaired(*tet_solids.wedge(42, 2), "--prepare")
        section = report["onto"]["singularity"]
        for path, value in [(["repair", "faults"], 2), (["singularity", "edges"], section["edges"] + 1),
                            (["singularity", "corner_list", 0, "verdict"], "not_meshable"),
                            (["singularity", "corner_list", 0, "verdict"], "undecided")]:
            changed = copy.deepcopy(report)
            part = changed["onto"]
            for key in path[:-1]:
                part = part[key]
            part[path[-1]] = value
            with self.subTest(path):
                self.assertEqual(len(differences(self.folder / "out", changed)), 1)

    def test_stay_the_same_in_a_copied_folder(self):
        report = self.repaired(*tet_solids.ball(4), "--prepare")
        shutil.copytree(self.folder / "out", self.folder / "copy")
        shutil.rmtree(self.folder / "out")
        self.assert_check_says(report, "copy")

    def test_tell_what_was_repaired(self):
        report = self.repaired(*tet_solids.ball(4), "--prepare")
        repair, edges = report["onto"]["repair"], report["onto"]["singularity"]["edges"]
        words = f"places where no hexahedra can meet: {repair['faults']} (before {repair['faults_before']})"
        self.assertIn(words, self.summary)
        self.assertIn(words, self.run_here("check", "out").stdout)
        self.assertIn(f"singular edges: {edges} (before {repair['edges_before']})", self.summary)


class CommandsOnRepairedFields(RepairTest):
    def test_work(self):
        report = self.repaired(*tet_solids.ball(4), "--prepare")
        self.assert_succeeds(self.run_here("render", "out", "--size", "64x64", "-o", "ball.png"))
        self.assert_succeeds(self.run_here("streamlines", "out", "--count", "5"))
        self.assert_succeeds(self.run_here("render", "out", "--size", "64x64", "--streamlines", "-o", "lines.png"))
        self.write("points.txt", "0.1 0.2 0.3\n")
        sampled = self.run_here("sample", "out", "points.txt")
        self.assert_succeeds(sampled)
        self.assertEqual(len(sampled.stdout.splitlines()[-1].split()), 9)
        self.assertEqual(json.loads(self.run_here("check", "out", "--json").stdout)["verdict"], report["verdict"])

    def test_show_it_in_a_page(self):
        self.write("ball.mesh", medit_text(*tet_solids.ball(3)))
        report = self.solve("ball.mesh", "--prepare", "--repair")
        page = (self.folder / "out" / "report.html").read_text()
        self.assertIn('"changed_faces"', page)
        self.assertIn(report["solve"], page)

    def test_may_solve_its_mesh_again(self):
        self.repaired(*tet_solids.ball(4), "--prepare")
        again = self.solve("out/onto.mesh", "--repair", "--write", FORMATS, folder="again")
        self.assertEqual((again["onto"]["repair"]["faults"], again["onto"]["repair"]["moved_vertices"]), (0, 0))
        one, other = ((self.folder / folder / "onto.mesh").read_bytes() for folder in ("out", "again"))
        self.assertEqual(one, other)


class Kinds(RepairTest):
    """Meshes and options for which there is more than one surface or field."""

    def write_regions(self, vertices, tets, is_beyond):
        text = medit_text(vertices, tets).splitlines()
        first = text.index("Tetrahedra") + 2
        for t, beyond in enumerate(is_beyond):
            text[first + t] = text[first + t].rsplit(" ", 1)[0] + f" {8 if beyond else 3}"
        self.write("regions.mesh", "\n".join([*text, ""]))

    def test_of_two_regions(self):
        vertices, tets = tet_box((4, 3, 3))
        self.write_regions(vertices, tets, vertices[tets].mean(axis=1)[:, 0] >= 1)
        report = self.solve("regions.mesh", "--prepare", "--repair", "--write", FORMATS)
        self.assertEqual(report["verdict"], "meshable")
        self.assertEqual(len(report["regions"]), 2)

    def test_of_degree_three(self):
        self.write("ball.mesh", medit_text(*tet_solids.ball(3)))
        self.assertIn("repair", self.solve("ball.mesh", "--prepare", "--repair", "--degree", "3", "--no-report")["onto"])

    def off_oblique_wall(self, model, *arguments):
        """The report, and the largest angle of frames beside a wall between two regions off it."""
        vertices, tets = tet_box((4, 4, 4))
        across = (vertices / vertices.max(axis=0)) @ np.array([1, -1, 0])  # the wall is a plane of the tets' faces, x = y in cells
        self.write_regions(vertices, tets, across[tets].mean(axis=1) > 0)
        report = self.solve(model, *arguments, "--prepare", "--repair", "--write", FORMATS)
        points, cells = read_medit(self.folder / "out" / "onto.mesh")
        axes = read_frames(self.folder / "out" / "onto.fra").transpose(0, 2, 1)
        at_wall = (np.abs(((points / points.max(axis=0)) @ np.array([1, -1, 0]))[cells]) < 1e-9).sum(axis=1) == 3
        self.assertGreater(at_wall.sum(), 20)
        normal = np.array([1, -1, 0]) / vertices.max(axis=0)
        cosines = np.abs(axes[at_wall] @ (normal / np.linalg.norm(normal))).max(axis=1)
        return report, np.degrees(np.arccos(np.minimum(1, cosines))).max()

    def test_keep_frames_to_an_oblique_wall_between_regions(self):
        self.assertLess(self.off_oblique_wall("regions.mesh")[1], 1e-4)
        self.write("box.stl", stl_bytes(box_triangles()))
        self.assertLess(self.off_oblique_wall("box.stl", "--onto", "regions.mesh")[1], 1e-4)

    def test_let_frames_ignore_the_wall_of_a_union(self):
        report, off = self.off_oblique_wall("regions.mesh", "--union")
        self.assertGreater(off, 10)
        self.assertTrue(report["onto"]["united"])
        self.assertLess(report["onto"]["crease_deg"]["max"], 0.01)
        self.assertLess(report["onto"]["dirichlet"], 1e-6)

    def test_of_a_surface_with_tets_of_their_own(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        self.write("box.mesh", medit_text(*tet_box()))
        report = self.solve("box.stl", "--onto", "box.mesh", "--prepare", "--repair", "--write", FORMATS)
        self.assertEqual((report["verdict"], report["onto"]["repair"]["faults"]), ("meshable", 0))

    def test_of_a_single_tet(self):
        report = self.repaired(np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float), np.array([(0, 1, 2, 3)]))
        self.assertGreater(report["onto"]["repair"]["faults"], 0)
        self.assert_succeeds(self.run_here("check", "out"))


class WrongUse(RepairTest):
    def test_of_repair_without_tets_is_told_in_a_line(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        self.assert_fails(self.run_here("solve", "box.stl", "--repair", "-o", "out"), USAGE, "--repair", "--onto", "--help")
        self.assertEqual(self.names(), ["box.stl"])

    def test_of_repair_with_constraints_is_told_in_a_line(self):
        self.write("axes.json", json.dumps({"schema": 1, "points": [{"at": [0.1, 0.1, 0.1], "axis": [1, 2, 3]}]}))
        self.write("ball.mesh", medit_text(*tet_solids.ball(4)))
        result = self.run_here("solve", "ball.mesh", "--repair", "--constraints", "axes.json", "-o", "out")
        self.assert_fails(result, USAGE, "--repair", "--constraints", "--help")

    def test_of_tets_without_volume_is_told_in_a_line(self):
        vertices, tets = tet_box((2, 2, 2))
        inside = int(np.flatnonzero((vertices == np.array([1.0, 0.5, 0.75])).all(axis=1))[0])
        vertices[inside] = vertices[inside - 1]
        self.write("flat.mesh", medit_text(vertices, tets))
        result = self.run_here("solve", "flat.mesh", "--repair", "-o", "out", "--quiet")
        self.assertEqual(result.returncode, INPUT, result.stderr)
        last = result.stderr.splitlines()[-1]
        self.assertTrue(last.startswith("crossgrain: flat.mesh: "), last)
        self.assertIn("without volume", last)
        self.assertEqual(self.names(), ["flat.mesh"])


    def test_of_tets_that_overlap_is_told_in_a_line(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0.2, 0.2, 0.9)]
        self.write("fold.mesh", medit_text(np.array(points, float), np.array([(0, 1, 2, 3), (0, 1, 2, 4)])))
        result = self.run_here("solve", "fold.mesh", "--repair", "-o", "out", "--quiet")
        self.assertEqual(result.returncode, INPUT, result.stderr)
        self.assertIn("overlap", result.stderr.splitlines()[-1])
        self.assertEqual(self.names(), ["fold.mesh"])

    def test_of_a_tet_pushed_through_its_side_tells_how_many_are_inverted(self):
        vertices, tets = tet_box((2, 2, 2))
        inside = int(np.flatnonzero((vertices == np.array([1.0, 0.5, 0.75])).all(axis=1))[0])
        vertices[inside] += (1.2, 0, 0)
        edges = vertices[tets[:, 1:]] - vertices[tets[:, :1]]
        count = int((np.linalg.det(edges) <= 0).sum())
        self.write("through.mesh", medit_text(vertices, tets))
        result = self.run_here("solve", "through.mesh", "--repair", "-o", "out", "--quiet")
        self.assertEqual(result.returncode, INPUT, result.stderr)
        self.assertRegex(result.stderr.splitlines()[-1], rf": {count} of {len(tets)} tets are inverted or flat, the first at \S+ \S+ \S+: tets overlap")


class DamagedFolders(RepairTest):
    def setUp(self):
        super().setUp()
        self.repaired(*tet_solids.ball(3), "--prepare")
        self.path = self.folder / "out" / "onto.vtu"
        self.arrays = read_arrays(self.path)

    def replace(self, name, values):
        """Puts other values in an array of onto.vtu, with the same number of bytes in each of its blocks."""
        data = self.path.read_bytes()
        tag = data.index(b"<AppendedData")
        start = data.index(b"_", tag) + 1
        header = data[:tag].decode()
        offsets = {match[1]: int(match[2]) for match in re.finditer(r'Name="(\w+)"[^>]*offset="(\d+)"', header)}
        ends = sorted(offsets.values())
        packed = zlib.compress(values.tobytes())
        block = np.array([1, values.nbytes, 0, len(packed)], "<u8").tobytes() + packed
        at = offsets[name]
        after = next((end for end in ends if end > at), None)
        body = data[start:]
        close = body.rindex(b"</AppendedData>")
        end = close - len(body[:close]) + len(body[:close].rstrip()) if after is None else after
        shift = len(block) - (end - at)
        moved = re.sub(r'offset="(\d+)"', lambda m: f'offset="{int(m[1]) + (shift if int(m[1]) > at else 0)}"', header)
        self.path.write_bytes(moved.encode() + data[tag:start] + body[:at] + block + body[end:])

    def assert_refused(self):
        for command in (("check", "out"), ("streamlines", "out"), ("render", "out", "--size", "64x64", "-o", "out.png")):
            self.assert_fails(self.run_here(*command), INPUT, "onto.vtu", "is damaged")

    def test_with_an_array_as_it_was_are_read(self):
        self.replace("matching", self.arrays["matching"])
        self.assert_succeeds(self.run_here("check", "out"))

    def test_with_axes_that_are_no_rotation_are_refused(self):
        matching = self.arrays["matching"].copy().reshape(-1, 4, 3)
        inner = tuple(np.argwhere((matching != 0).all(axis=2))[0])
        for wrong in ((1, 1, 3), (1, 2, -3), (0, 2, 3), (1, 2, 4), (-128, 2, 3)):
            with self.subTest(wrong):
                changed = matching.copy()
                changed[inner] = wrong
                self.replace("matching", changed)
                self.assert_refused()

    def test_with_other_axes_on_the_two_sides_of_a_face_are_refused(self):
        matching = self.arrays["matching"].copy().reshape(-1, 4, 3)
        for side in np.argwhere((matching != 0).all(axis=2))[[0, -1]]:
            changed = matching.copy()
            now = changed[tuple(side)]
            changed[tuple(side)] = (now[1], now[2], now[0])
            self.replace("matching", changed)
            self.assert_refused()

    def test_with_axes_behind_the_surface_are_refused(self):
        matching = self.arrays["matching"].copy().reshape(-1, 4, 3)
        matching[tuple(np.argwhere((matching == 0).all(axis=2))[0])] = (1, 2, 3)
        self.replace("matching", matching)
        self.assert_refused()

    def test_with_frames_that_are_none_are_refused(self):
        for wrong in (np.nan, 2.0):
            frames = self.arrays["tet_frame"].copy()
            frames[7, 0] = wrong
            self.replace("tet_frame", frames)
            self.assert_refused()


class Stopped(RepairTest):
    def test_in_the_repair_leaves_the_field_on_the_grid(self):
        # Faults that no matching mends are searched longest.
        self.write("wedge.mesh", medit_text(*tet_solids.wedge(30, 3)))
        process = subprocess.Popen([PROGRAM, "solve", "wedge.mesh", "--repair", "-o", "out", "--progress"], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, cwd=self.folder)
        self.addCleanup(lambda: process.poll() is None and process.kill())
        while "tets:" not in (line := process.stderr.readline().decode()):  # written when the repair begins
            self.assertNotEqual(line, "", "ended before the repair")
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        began = time.monotonic()
        _, errors = process.communicate(timeout=100)
        if process.returncode == 0:
            self.skipTest("the repair had ended")
        self.assertLess(time.monotonic() - began, LONGEST_END_SECONDS)
        self.assertEqual(process.returncode, INTERRUPTED)
        self.assertIn(b"none on the tets", errors)
        report = json.loads((self.folder / "out" / "report.json").read_text())
        self.assertTrue(report["unfinished"]["tets_missing"])
        self.assertNotIn("onto.vtu", [path.name for path in (self.folder / "out").iterdir()])


@unittest.skipUnless((SHARED / "hexme").is_dir(), f"no meshes in {SHARED / 'hexme'}")
class HexMe(RepairTest):
    def test_meshes_are_judged_alike(self):
        for name in of_the_day(("s02c_prism", "s04c_tetrahedron", "n09c_pyramid", "s17c_sphere"), "s02c_prism", "n09c_pyramid"):
            with self.subTest(name):
                self.write(name + ".vtk", lzma.decompress((SHARED / "hexme" / (name + ".vtk.xz")).read_bytes()))
                report = self.solve(name + ".vtk", "--prepare", "--repair", "--write", FORMATS, "--no-report")
                self.assert_judged_alike(report)
                self.assert_check_says(report)
                self.assert_files_agree("out")


@unittest.skipUnless((SHARED / "models" / "good").is_dir(), f"no models in {SHARED / 'models' / 'good'}")
class ThinModels(RepairTest):
    def test_are_repaired(self):
        for name in of_the_day(("plate.msh", "rod.msh"), "rod.msh"):
            with self.subTest(name):
                report = self.solve(SHARED / "models" / "good" / name, "--prepare", "--repair", "--write", FORMATS, "--no-report")
                self.assert_judged_alike(report)
                self.assert_check_says(report)


if __name__ == "__main__":
    unittest.main()
