#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fields on tet meshes: `solve MESH.mesh`, `--onto` and `--boundary`, files with faults, and the numbers of the report.

The comparison meshes are in the folder that CROSSGRAIN_SHARED names, ../shared beside the project by default; their tests
are skipped where it is absent.
"""

import json
import lzma
import os
import re
import resource
import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np

from field_reader import read_arrays
from program import (CommandTest, box_triangles, medit_text, of_the_day, stl_bytes, tet_box, tilt, torus_triangles, vtk_text,
                     without_solve)
from recompute_onto import OntoRecomputation

USAGE, INPUT, OUTPUT = 2, 3, 4
SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared"))
ONTO_FILES = ["field.vtu", "onto.frames", "onto.vtu", "onto_singularities.vtu", "report.html", "report.json", "singularities.vtu", "surface.vtu"]
ONTO_KEYS = ["boundary", "crease_deg", "dirichlet", "edge_length", "edge_length_needed", "edge_sum", "inverted_tets",
             "left_out_tets", "normal_deg", "outside_vertices", "seconds", "singular", "singularity", "start",
             "tets", "unfollowed_share", "united", "unused_vertices", "vertices"]


class OntoTest(CommandTest):
    def write_box(self, name="box.mesh", **shape):
        vertices, tets = tet_box(**shape)
        self.write(name, medit_text(vertices, tets))
        return vertices, tets

    def solve(self, *arguments, folder="out"):
        """The report."""
        result = self.run_here("solve", *arguments, "-o", folder)
        self.assert_succeeds(result)
        return json.loads((self.folder / folder / "report.json").read_text())

    def onto_frames(self, folder="out"):
        return np.loadtxt(self.folder / folder / "onto.frames", ndmin=2).reshape(-1, 3, 3)

    def files(self, folder="out"):
        return sorted(os.listdir(self.folder / folder))

    def assert_finite(self, folder="out"):
        """No NaN or infinity in any file."""
        for name in ("onto.frames", "report.json"):
            text = (self.folder / folder / name).read_text()
            self.assertIsNone(re.search(r"nan|\binf", text, re.IGNORECASE), name)
        for name in ("onto.vtu", "field.vtu"):
            for key, values in read_arrays(self.folder / folder / name).items():
                self.assertTrue(np.isfinite(values).all(), f"{name}: {key}")


class TetsAsModel(OntoTest):
    def test_there_are_six_files(self):
        vertices, tets = self.write_box()
        result = self.run_here("solve", "box.mesh")
        self.assert_succeeds(result)
        self.assertEqual(self.files("box.frames"), ONTO_FILES)
        self.assertEqual(len(self.onto_frames("box.frames")), len(vertices))
        for name in self.files("box.frames"):
            self.assertIn(name, result.stdout)
        onto = json.loads((self.folder / "box.frames" / "report.json").read_text())["onto"]
        self.assertEqual(sorted(onto), ONTO_KEYS)
        self.assertEqual((onto["vertices"], onto["tets"]), (len(vertices), len(tets)))
        self.assert_finite("box.frames")

    def test_a_vtk_file_does_as_well(self):
        vertices, tets = self.write_box()
        self.write("box.vtk", vtk_text(vertices, tets))
        self.solve("box.mesh", "--resolution", 16, folder="medit")
        self.solve("box.vtk", "--resolution", 16, folder="vtk")
        for name in ("field.vtu", "onto.frames"):
            self.assertEqual(without_solve((self.folder / "medit" / name).read_bytes()),
                             without_solve((self.folder / "vtk" / name).read_bytes()))
        medit, vtk = (read_arrays(self.folder / folder / "onto.vtu") for folder in ("medit", "vtk"))
        # Of the two only Medit says a region of each tet.
        np.testing.assert_array_equal(medit.pop("region"), 1)
        self.assertEqual(list(medit), list(vtk))
        for name, values in medit.items():
            np.testing.assert_array_equal(values, vtk[name])

    def test_warnings_of_a_reader_are_in_the_report_and_on_standard_error(self):
        vertices, tets = tet_box()
        # Of curved tets; whose nodes beyond the corners do not matter here.
        curved = np.hstack([tets, tets, tets[:, :2]])
        self.write("box.mesh", medit_text(vertices, curved).replace("Tetrahedra", "TetrahedraP2"))
        result = self.run_here("solve", "box.mesh", "--resolution", 16, "--quiet", "-o", "out")
        self.assert_succeeds(result)
        warning = f"tets of higher order: {len(tets)};"
        self.assertIn("warning: box.mesh: " + warning, result.stderr)
        report = json.loads((self.folder / "out" / "report.json").read_text())
        told = [(found["kind"], found["file"]) for found in report["warnings"] if found["text"].startswith(warning)]
        self.assertEqual(told, [("curved_tets", "box.mesh")], report["warnings"])

    def test_a_box_has_its_own_frame_at_every_vertex(self):
        vertices, tets = tet_box()
        self.write("box.mesh", medit_text(vertices @ tilt(), tets))
        report = self.solve("box.mesh", "--resolution", 24)
        # Rows are axes; the box's own are the rows of the rotation.
        cosines = np.abs(self.onto_frames() @ tilt().T)
        self.assertLess(np.degrees(np.arccos(np.clip(cosines.max(axis=2), 0, 1))).max(), 0.1)
        self.assertEqual(report["onto"]["singular"], {"interior_faces": 0, "boundary_faces": 0})
        self.assertEqual(report["model"]["triangles"], 2 * 2 * (4 * 3 + 4 * 3 + 3 * 3))
        self.assertEqual(report["warnings"], [])

    def test_cells_are_twice_as_large_as_the_edges_unless_told(self):
        vertices, tets = self.write_box(cells=(24, 12, 18))
        corners = vertices[tets]
        volume = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).mean() / 6
        edge = (6 * np.sqrt(2) * volume) ** (1 / 3)  # of a regular tet of that volume
        self.assertAlmostEqual(2 / self.solve("box.mesh")["resolution"], 2 * edge, places=9)
        self.assertEqual(self.solve("box.mesh", "--resolution", 10)["resolution"], 10)
        self.assertEqual(self.solve("box.mesh", "--cell-size", 0.25)["resolution"], 8)

    def test_the_result_does_not_depend_on_the_vectors_of_the_processor(self):
        # Cells that are cut, inside and held to a normal, in lanes beside each other.
        vertices, tets = tet_box(cells=(8, 6, 7))
        self.write("box.mesh", medit_text(vertices @ tilt(), tets))
        for degree in (3, 4):
            results = set()
            for doubles in ("2", "4", "8"):
                environment = {**os.environ, "CROSSGRAIN_VECTOR_DOUBLES": doubles}
                self.assert_succeeds(self.run_here("solve", "box.mesh", "-o", "out", "--degree", degree, env=environment))
                results.add(tuple((self.folder / "out" / name).read_bytes() for name in ("field.vtu", "onto.frames")))
            self.assertEqual(len(results), 1)

    def test_a_box_settles(self):
        # Its energy is nothing but rounding, of either sign.
        vertices, tets = tet_box(cells=(15, 6, 4), size=(1.5, 0.6, 0.4))
        self.write("box.mesh", medit_text(vertices, tets))
        self.assertEqual(self.solve("box.mesh")["warnings"], [])

    def test_what_only_the_grid_does_not_resolve_is_no_warning(self):
        vertices, tets = tet_box(cells=(16, 16, 2))
        vertices[:, 2] *= 0.1
        self.write("plate.mesh", medit_text(vertices, tets))
        report = self.solve("plate.mesh")
        self.assertGreater(report["walls"]["thin_share"], 0.5)
        self.assertEqual(report["warnings"], [])

    def test_the_field_on_the_grid_is_that_of_the_boundary_as_a_surface(self):
        vertices, tets = self.write_box()
        self.solve("box.mesh", "--resolution", 12)
        faces = {}
        for tet in tets:
            for opposite in range(4):
                face = [tet[k] for k in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))[opposite]]
                faces.setdefault(tuple(sorted(face)), []).append(face)
        boundary = [uses[0] for uses in faces.values() if len(uses) == 1]
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
        lines += ["f " + " ".join(str(v + 1) for v in face) for face in boundary]
        self.write("box.obj", "\n".join(lines) + "\n")
        self.solve("box.obj", "--resolution", 12, folder="surface")
        # Triangles in another order: sums over the surface round otherwise.
        axes = [read_arrays(self.folder / folder / "field.vtu")["axis_u"] for folder in ("out", "surface")]
        self.assertEqual(axes[0].shape, axes[1].shape)
        np.testing.assert_allclose(np.abs(axes[0]).max(axis=1), np.abs(axes[1]).max(axis=1), atol=1e-4)

    def test_the_result_does_not_depend_on_the_number_of_threads(self):
        self.write_box(cells=(7, 6, 5))
        results = []
        for threads in (1, 2):
            self.solve("box.mesh", "--threads", threads, "--seed", 3)
            results.append([(self.folder / "out" / name).read_bytes()
                            for name in ("onto.frames", "onto.vtu", "field.vtu")])
        self.assertTrue(results[0] == results[1])

    def test_progress_tells_of_the_tets(self):
        vertices, _ = self.write_box()
        result = self.run_here("solve", "box.mesh", "--progress")
        self.assert_succeeds(result)
        lines = [line for line in result.stderr.splitlines() if line.startswith("tets")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith(f"tets: {len(vertices)} vertices, sweep "), lines)

    def test_sample_takes_the_folder(self):
        self.write_box()
        self.solve("box.mesh")
        result = self.run_here("sample", "out", "-", stdin=b"1 0.5 0.75\n")
        self.assert_succeeds(result)
        self.assertEqual(np.loadtxt(result.stdout.splitlines()).shape, (9,))

    def test_starts_from_an_earlier_field(self):
        self.write_box()
        self.solve("box.mesh", folder="first")
        report = self.solve("box.mesh", "--from", "first")
        self.assertEqual(report["warnings"], [])
        self.assertEqual(self.files(), ONTO_FILES)


class Onto(OntoTest):
    def test_carries_the_field_of_a_surface(self):
        vertices, _ = self.write_box("tets.mesh")
        self.write("box.stl", stl_bytes(box_triangles()))
        report = self.solve("box.stl", "--onto", "tets.mesh")
        self.assertEqual(report["model"]["triangles"], 12)
        self.assertEqual(report["model"]["path"], "box.stl")
        self.assertEqual(report["onto"]["outside_vertices"], 0)
        self.assertEqual(len(self.onto_frames()), len(vertices))
        self.assertEqual(self.files(), ONTO_FILES)
        np.testing.assert_allclose(np.abs(self.onto_frames()).max(axis=2), 1, atol=1e-5)

    def test_vertices_beyond_the_surface_are_counted_and_warned_of(self):
        vertices, tets = tet_box(cells=(8, 6, 6))
        # A fifth beyond each face of the surface: more than a cell.
        self.write("tets.mesh", medit_text(1.2 * vertices - 0.1 * np.array([2, 1, 1.5]), tets))
        self.write("box.stl", stl_bytes(box_triangles()))
        report = self.solve("box.stl", "--onto", "tets.mesh", "--resolution", 40)
        outside = report["onto"]["outside_vertices"]
        self.assertGreater(outside, 50)
        warnings = [warning for warning in report["warnings"] if warning["kind"] == "vertices_outside"]
        self.assertEqual(len(warnings), 1, report["warnings"])
        self.assertIn(f"in no cell: {outside} of {len(vertices)}", warnings[0]["text"])
        self.assert_finite()
        np.testing.assert_allclose(np.abs(self.onto_frames()).max(axis=2), 1, atol=1e-3)

    def test_a_surface_in_another_unit_is_refused(self):
        self.write_box("tets.mesh")
        self.write("inches.stl", stl_bytes(25.4 * box_triangles()))
        result = self.run_here("solve", "inches.stl", "--onto", "tets.mesh", "-o", "out")
        self.assert_fails(result, INPUT, "tets.mesh", "inches.stl", "same unit")

    def test_tets_beside_the_surface_are_refused(self):
        vertices, tets = tet_box(cells=(4, 4, 4))
        self.write("tets.mesh", medit_text(vertices + 10, tets))
        self.write("box.stl", stl_bytes(box_triangles()))
        result = self.run_here("solve", "box.stl", "--onto", "tets.mesh", "-o", "out")
        self.assert_fails(result, INPUT, "tets.mesh", "place")
        self.assertFalse((self.folder / "out").exists())

    def test_creases_are_free_where_told(self):
        # A plate of one layer: only its creases know where its sides are.
        self.write_box("plate.mesh", cells=(6, 5, 1), size=(1.2, 1.0, 0.2))
        # The surface of another solid, turned against the plate about the direction across it.
        turn = np.array([[np.cos(0.5), np.sin(0.5), 0], [-np.sin(0.5), np.cos(0.5), 0], [0, 0, 1]])
        self.write("turned.stl", stl_bytes((box_triangles((4, 4, 4)) - 2) @ turn))
        report = self.solve("turned.stl", "--onto", "plate.mesh", "--boundary", "smooth-only", "--resolution", 16)
        self.assertEqual(report["onto"]["boundary"], "smooth-only")
        self.assertLess(report["onto"]["normal_deg"]["max"], 1e-5)
        self.assertGreater(report["onto"]["crease_deg"]["max"], 25)
        report = self.solve("turned.stl", "--onto", "plate.mesh", "--boundary", "all", "--resolution", 16)
        self.assertEqual(report["onto"]["boundary"], "all")
        self.assertLess(report["onto"]["crease_deg"]["max"], 1)
        explicit = (self.folder / "out" / "onto.frames").read_bytes()
        self.solve("turned.stl", "--onto", "plate.mesh", "--resolution", 16)
        self.assertTrue(explicit == (self.folder / "out" / "onto.frames").read_bytes())


class WrongUsage(OntoTest):
    def setUp(self):
        super().setUp()
        self.write_box()
        self.write("box.stl", stl_bytes(box_triangles()))
        self.before = self.names()

    def refuse(self, code, *arguments, words):
        with self.subTest(arguments=arguments):
            self.assert_fails(self.run_here("solve", *arguments, "-o", "out/deep"), code, *words)
            self.assertEqual(self.names(), self.before)

    def test_onto_and_boundary_where_they_make_no_sense(self):
        self.refuse(USAGE, "box.mesh", "--onto", "box.mesh", words=["--onto", "--help"])
        self.refuse(USAGE, "box.stl", "--boundary", "all", words=["--boundary", "--help"])
        for word in ("creases", "", "0", "ALL"):
            self.refuse(USAGE, "box.mesh", "--boundary", word, words=["--boundary", word, "--help"])
        self.refuse(USAGE, "box.stl", "--onto", "", words=["--onto", "--help"])

    def test_files_of_tets_that_are_none(self):
        self.refuse(INPUT, "box.stl", "--onto", "none.mesh", words=["none.mesh", "no such file"])
        self.refuse(INPUT, "none.stl", "--onto", "box.mesh", words=["none.stl", "no such file"])
        self.refuse(INPUT, "box.stl", "--onto", "box.stl", words=["box.stl", ".mesh"])
        self.refuse(INPUT, "box.stl", "--onto", ".", words=["folder"])

    def test_the_output_is_looked_at_before_the_tets(self):
        (self.folder / "out" / "onto.vtu").mkdir(parents=True)
        self.write("rubbish.mesh", "rubbish")
        self.before = self.names()
        self.assert_fails(self.run_here("solve", "rubbish.mesh", "-o", "out"), OUTPUT, "onto.vtu")


class Faults(OntoTest):
    def refuse(self, content, *words):
        self.write("faulty.mesh", content)
        self.write("box.stl", stl_bytes(box_triangles()))
        before = self.names()
        for arguments in (["faulty.mesh"], ["box.stl", "--onto", "faulty.mesh"]):
            with self.subTest(arguments=arguments):
                result = self.run_here("solve", *arguments, "-o", "out/deep")
                self.assert_fails(result, INPUT, "faulty.mesh", *words)
                self.assertEqual(self.names(), before)

    def accept(self, vertices, tets, *warnings):
        """The report of a mesh that gives exactly these warnings: each a tuple of words."""
        self.write("faulty.mesh", medit_text(vertices, tets))
        # Of cells so small that there is no word on thin walls.
        report = self.solve("faulty.mesh", "--cell-size", 0.125)
        self.assertEqual(len(report["warnings"]), len(warnings), report["warnings"])
        for words, warning in zip(warnings, report["warnings"]):
            for word in words:
                self.assertIn(word, warning["text"])
        self.assertEqual(len(self.onto_frames()), len(vertices))
        self.assert_finite()
        return report

    def test_a_vertex_that_is_no_number(self):
        vertices, tets = tet_box()
        for value in (float("nan"), float("inf")):
            vertices[17, 1] = value
            # The header has four lines.
            self.refuse(medit_text(vertices, tets), f"line {4 + 17 + 1}: ")

    def test_a_coordinate_too_large_to_square(self):
        vertices, tets = tet_box()
        vertices[17, 1] = 1e200
        self.refuse(medit_text(vertices, tets), "vertex 17")

    def test_an_index_out_of_range(self):
        vertices, tets = tet_box()
        for index in (len(vertices), -1):
            tets[5, 2] = index
            self.refuse(medit_text(vertices, tets), f"line {4 + len(vertices) + 2 + 5 + 1}: ", str(index + 1))

    def test_a_face_of_three_tets(self):
        vertices, tets = tet_box()
        face, first = tets[0, :3], len(vertices)
        apexes = [[0.5, 0.5, 9], [0.5, 0.5, 8]]
        self.refuse(medit_text([*vertices, *apexes], [*tets, [*face, first], [*face, first + 1]]), "face", "tets, among them 0",
                    *(str(vertex) for vertex in face))

    def test_no_tets(self):
        self.refuse("MeshVersionFormatted 2\nDimension 3\nVertices\n1\n0 0 0 0\nEnd\n", "no tets")
        self.refuse("MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                    "Triangles\n1\n1 2 3 0\nEnd\n", "1 triangle ")

    def test_elements_of_other_shapes(self):
        vertices, tets = tet_box()
        hexahedra = "Hexahedra\n1\n1 2 3 4 5 6 7 8 0\nEnd\n"
        self.refuse(medit_text(vertices, tets).replace("End\n", hexahedra), "hexahedra (1)")

    def test_a_file_cut_short(self):
        text = medit_text(*tet_box())
        for share in (0.1, 0.5, 0.95):
            self.refuse(text[:int(share * len(text))])

    def test_an_empty_file(self):
        self.refuse("", "empty")
        self.refuse("\n\n# nothing\n")

    def test_foreign_files(self):
        self.refuse(stl_bytes(box_triangles()))
        self.refuse(b"\x01\x00\x00\x00\x03\x00\x00\x00" + bytes(100))

    def test_tets_without_any_volume(self):
        vertices, tets = tet_box()
        vertices[:, 2] = 0
        self.refuse(medit_text(vertices, tets), "volume", "tet 0")

    def test_inverted_tets(self):
        vertices, tets = tet_box()
        tets[[7, 20, 50]] = tets[[7, 20, 50]][:, [0, 1, 3, 2]]
        report = self.accept(vertices, tets, ("inverted", "3", "tet 7"))
        self.assertEqual(report["onto"]["inverted_tets"], 3)

    def test_flat_tets(self):
        vertices, tets = tet_box()
        # Four corners of a square on the boundary, and one that names a vertex twice.
        flat = [[0, 1, 5, 6], [0, 1, 6, 6]]
        report = self.accept(vertices, [*tets, *flat], ("without volume", "2", f"tet {len(tets)}"))
        self.assertEqual(report["onto"]["left_out_tets"], 2)
        self.assertEqual(report["onto"]["tets"], len(tets))

    def test_vertices_of_no_tet(self):
        vertices, tets = tet_box()
        report = self.accept([*vertices[:3], [9, 9, 9], *vertices[3:], [1, 0.5, 0.75]], np.where(tets < 3, tets, tets + 1),
                             ("of no tet", "2", "vertex 3"))
        self.assertEqual(report["onto"]["unused_vertices"], 2)

    def test_a_tet_named_twice(self):
        vertices, tets = tet_box()
        report = self.accept(vertices, [*tets, tets[4][[1, 2, 0, 3]]], ("same vertices", "1", f"tet {len(tets)}"))
        self.assertEqual(report["onto"]["tets"], len(tets))

    def test_an_edge_where_the_solid_touches_itself(self):
        vertices, tets = tet_box((3, 3, 3), (1, 1, 1))
        # A second cube shares four vertices with the first, those of one edge.
        place = {tuple(np.round(vertex, 9)): i for i, vertex in enumerate(vertices)}
        number = []
        for vertex in vertices + [1, 1, 0]:
            number.append(place.setdefault(tuple(np.round(vertex, 9)), len(place)))
        self.accept(list(place), [*tets, *np.array(number)[tets]], ("non-manifold edges: 3 of more than two triangles",),
                    ("touches itself", "edges", "3", f"{number[0]} and {number[16]}", "counted from 0"))

    def test_two_components_each_have_their_own_frame(self):
        vertices, tets = tet_box()
        turned = vertices @ tilt() + [4, 0, 0]
        report = self.accept([*vertices, *turned], [*tets, *(tets + len(vertices))])
        self.assertEqual(report["model"]["components"], 2)
        frames = self.onto_frames()
        np.testing.assert_allclose(np.abs(frames[:len(vertices)]).max(axis=2), 1, atol=1e-5)
        np.testing.assert_allclose(np.abs(frames[len(vertices):] @ tilt().T).max(axis=2), 1, atol=1e-5)

    def test_a_sliver_of_next_to_no_volume_stays_finite(self):
        vertices, tets = tet_box()
        inside = [i for i, v in enumerate(vertices) if (v > 0.1).all() and (v < [1.9, 0.9, 1.4]).all()][0]
        tet = next(tet for tet in tets if inside in tet)
        others = vertices[[i for i in tet if i != inside]]
        normal = np.cross(others[1] - others[0], others[2] - others[0])
        normal /= np.linalg.norm(normal)
        height = (vertices[inside] - others[0]) @ normal
        vertices[inside] -= (height - 1e-9 * np.sign(height)) * normal
        self.write("sliver.mesh", medit_text(vertices, tets))
        self.solve("sliver.mesh")
        self.assert_finite()


class ReplacedResults(OntoTest):
    def setUp(self):
        super().setUp()
        self.write_box()
        self.write("box.stl", stl_bytes(box_triangles()))
        self.solve("box.mesh")

    def test_a_field_without_tets_takes_the_files_of_tets_away(self):
        (self.folder / "out" / "notes.txt").write_text("mine")
        self.solve("box.stl", "--resolution", 8, "--force")
        self.assertEqual(self.files(), ["field.vtu", "notes.txt", "report.html", "report.json", "singularities.vtu", "surface.vtu"])

    def test_a_run_that_fails_takes_nothing_away(self):
        def small_files_only():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

        files = {name: (self.folder / "out" / name).read_bytes() for name in self.files()}
        runs = [(INPUT, ["none.stl"], {}), (USAGE, ["box.stl", "--cell-size", "1"], {}),
                (OUTPUT, ["box.stl", "--resolution", "24"], {"preexec_fn": small_files_only}),
                (INPUT, ["none.mesh"], {}),
                (OUTPUT, ["box.mesh", "--resolution", "24"], {"preexec_fn": small_files_only})]
        for code, arguments, options in runs:
            with self.subTest(arguments=arguments):
                self.assert_fails(self.run_here("solve", *arguments, "-o", "out", "--quiet", **options), code)
                self.assertEqual({name: (self.folder / "out" / name).read_bytes() for name in self.files()}, files)


class Numbers(OntoTest):
    def assert_recomputable(self, mesh, *arguments):
        report = self.solve(mesh, *arguments)
        self.assertEqual(OntoRecomputation(self.folder / mesh, self.folder / "out").disagreements(report["onto"]), [])
        return report

    def write_drum(self):
        """A cylinder about a tilted axis: the squares around the middle of a box made circles."""
        vertices, tets = tet_box((6, 6, 5), (2, 2, 2))
        x, y = vertices[:, 0] - 1, vertices[:, 1] - 1
        radius = np.maximum(np.abs(x), np.abs(y))
        along_x = np.abs(x) >= np.abs(y)
        signed = np.where(along_x, x, y)
        with np.errstate(invalid="ignore"):
            angle = np.where(radius > 0, np.pi / 4 * np.where(along_x, y, x) / signed, 0)
        near, far = signed * np.cos(angle), signed * np.sin(angle)
        round_vertices = np.stack([np.where(along_x, near, far), np.where(along_x, far, near), vertices[:, 2]], axis=1)
        self.write("drum.mesh", medit_text(round_vertices @ tilt(), tets))

    def test_every_number_of_a_cylinder_is_recomputed(self):
        self.write_drum()
        report = self.assert_recomputable("drum.mesh")
        self.assertGreater(report["onto"]["singular"]["interior_faces"], 0)

    def test_every_number_of_degree_3_is_recomputed(self):
        self.write_drum()
        self.assert_recomputable("drum.mesh", "--degree", 3, "--boundary", "smooth-only")

    def test_every_number_of_a_box_is_recomputed(self):
        self.write_box()
        self.assert_recomputable("box.mesh")

    def test_a_number_that_is_off_by_a_little_is_found(self):
        self.write_drum()
        onto = self.solve("drum.mesh")["onto"]
        recomputation = OntoRecomputation(self.folder / "drum.mesh", self.folder / "out")
        for path in (["vertices"], ["tets"], ["dirichlet"], ["edge_sum"], ["singular", "interior_faces"],
                     ["singular", "boundary_faces"], ["crease_deg", "mean"], ["crease_deg", "max"], ["normal_deg", "max"]):
            changed = json.loads(json.dumps(onto))
            section = changed
            for key in path[:-1]:
                section = section[key]
            value = section[path[-1]]
            section[path[-1]] = value + 1 if isinstance(value, int) else 1.001 * value + 1e-5
            self.assertEqual(len(recomputation.disagreements(changed)), 1, path)


@unittest.skipUnless((SHARED / "comparison").is_dir() and (SHARED / "tools" / "evaluate.py").is_file(),
                     f"no comparison meshes in {SHARED}")
class ComparisonMeshes(OntoTest):
    # A little above what was reached when this was written.
    MOST_ENERGY = {"sphere20k": 53.8, "cylinder20k": 29.84, "part20k": 28.5}

    def test_energies_stay_as_low_as_they_were_and_are_those_of_the_evaluator(self):
        for name in of_the_day(self.MOST_ENERGY, "part20k"):
            with self.subTest(name):
                packed = SHARED / "comparison" / f"{name}.mesh.xz"
                self.write(f"{name}.mesh", lzma.decompress(packed.read_bytes()))
                onto = self.solve(f"{name}.mesh", folder=name)["onto"]
                said = subprocess.run([sys.executable, SHARED / "tools" / "evaluate.py", self.folder / f"{name}.mesh",
                                       self.folder / name / "onto.frames"], capture_output=True, check=True, timeout=60)
                judged = json.loads(said.stdout)
                self.assertLess(judged["dirichlet"], self.MOST_ENERGY[name])
                self.assertLess(judged["orthonormality"], 1e-14)
                self.assertEqual((onto["vertices"], onto["tets"]), (judged["vertices"], judged["tets"]))
                self.assertEqual(onto["singular"], judged["singular"])
                for key in ("dirichlet", "edge_sum"):
                    self.assertAlmostEqual(onto[key] / judged[key], 1, delta=1e-6)
                for angle in ("normal_deg", "crease_deg"):
                    for key, value in judged[angle].items():
                        # Below 2e-6 degrees arc cosines are rounding.
                        self.assertAlmostEqual(onto[angle][key], value, delta=3e-6) if value is not None \
                            else self.assertIsNone(onto[angle][key])


if __name__ == "__main__":
    unittest.main()
