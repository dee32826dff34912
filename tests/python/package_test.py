# SPDX-License-Identifier: Apache-2.0
"""The Python package as its users see it. Needs NumPy alone; what needs other packages is skipped where they are missing."""

import gc
import itertools
import os
import pickle
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).parent))
import crossgrain as cg
import numpy as np
from crossgrain import _interface, _library, _options
from solids import ball, ball_of_tets, box, cube_of_tets, medit_text


class WithFolder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="crossgrain-python-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)


def alignment(frames):
    """The largest entry of each axis; 1 for coordinate axes."""
    return np.abs(frames).max(axis=-1)


def nearest_matrices(frames, tets):
    """For each pair of tets the signed permutation without a reflection after which the frame of the second is nearest to the first."""
    signed = [np.diag(signs)[list(order)] for order in itertools.permutations(range(3)) for signs in itertools.product((1, -1), repeat=3)]
    turns = np.array([matrix for matrix in signed if np.linalg.det(matrix) > 0], float)
    both = frames[tets[:, 0]] @ frames[tets[:, 1]].transpose(0, 2, 1)
    return turns[np.einsum("fij,rij->fr", both, turns).argmax(axis=1)]


class Fields(WithFolder):
    @classmethod
    def setUpClass(cls):
        cls.box = cg.solve(*box(), resolution=16)
        cls.ball = cg.solve(*ball(), resolution=20)

    def test_in_a_box_follow_it(self):
        field, n = self.box, len(self.box)
        self.assertEqual((field.frames.shape, field.centers.shape, field.sizes.shape), ((n, 3, 3), (n, 3), (n,)))
        self.assertGreater(alignment(field.frames).min(), 0.9999)
        self.assertTrue(((field.centers > -0.2) & (field.centers < 2.2)).all())
        self.assertEqual(field.check().verdict, "meshable")
        self.assertEqual(field.degree, 4)

    def test_have_orthonormal_right_handed_frames_that_are_their_quaternions(self):
        frames = self.ball.frames
        np.testing.assert_allclose(frames @ frames.transpose(0, 2, 1), np.broadcast_to(np.eye(3), frames.shape), atol=1e-12)
        np.testing.assert_allclose(np.linalg.det(frames), 1, atol=1e-12)
        w, x, y, z = self.ball.quaternions.astype(float).T
        first = np.stack([w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)], 1)
        np.testing.assert_allclose(frames[:, 0], first, atol=1e-6)

    def test_give_arrays_that_are_read_only_and_made_once(self):
        for name in ("frames", "centers", "sizes", "levels", "quaternions", "energy_density", "alignment_deg", "on_boundary",
                     "constraint_classes"):
            array = getattr(self.box, name)
            self.assertEqual(len(array), len(self.box))
            self.assertFalse(array.flags.writeable, name)
            self.assertFalse(array.flags.owndata and name in ("quaternions", "energy_density"), name)
        self.assertIs(self.box.frames, self.box.frames)
        self.assertIsNone(self.box.regions)

    def test_live_as_long_as_their_views(self):
        field = cg.solve(*box(), resolution=8)
        density = field.energy_density
        expected = density.copy()
        del field
        gc.collect()
        cg.solve(*ball(6), resolution=8)
        np.testing.assert_array_equal(density, expected)

    def test_are_sampled_anywhere(self):
        points = np.random.default_rng(1).uniform(-1.2, 1.2, (3000, 3))
        samples = self.ball.sample_all(points)
        np.testing.assert_array_equal(self.ball.sample(points), samples.frames)
        np.testing.assert_array_equal(self.ball.sample(points, threads=1), samples.frames)
        np.testing.assert_array_equal(self.ball.sample(points[7]), samples.frames[7])
        inside = np.linalg.norm(points, axis=1) < 0.9
        self.assertTrue(samples.in_active_cell[inside].all())
        self.assertFalse(samples.in_active_cell[np.linalg.norm(points, axis=1) > 1.3].any())
        self.assertEqual(self.ball.sample(np.zeros((0, 3))).shape, (0, 3, 3))
        self.assertTrue((samples.singular_distance >= 0).all() and (samples.deviation >= 0).all())

    def test_have_singular_arcs_of_valence_three_in_a_ball(self):
        graph = self.ball.singularities
        self.assertGreater(len(graph.arcs), 0)
        for arc in graph.arcs:
            self.assertEqual((arc.points.shape[1], len(arc.axes), len(arc.vertices)), (3, len(arc.points), len(arc.points)))
            if arc.type == "regular":
                self.assertEqual(arc.valence, 3)
            for node in arc.nodes or ():
                self.assertIn(graph.arcs.index(arc), graph.nodes[node].arcs)
        self.assertEqual(len(graph.arcs), self.ball.report["singularity"]["arcs"])

    def test_answer_as_the_report_does(self):
        for field in (self.box, self.ball):
            answer = field.check()
            self.assertEqual(answer.verdict, field.report["verdict"])
            self.assertEqual(str(answer), field.report["answer"])
            self.assertEqual(len(answer.reasons), len(field.report["reasons"]))

    def test_are_read_as_they_were_written(self):
        report = self.ball.write(self.folder / "ball.frames")
        self.assertTrue((self.folder / "ball.frames" / "report.html").exists())
        again = cg.read(self.folder / "ball.frames")
        for name in ("quaternions", "centers", "energy_density", "constraint_classes"):
            np.testing.assert_array_equal(getattr(again, name), getattr(self.ball, name))
        self.assertEqual(again.report["energy"], report["energy"])
        self.assertFalse(cg.is_clipped(self.folder / "ball.frames"))
        self.ball.write(self.folder / "part.frames", clip=[0, 0, 0, 1, 1, 1], level=4, page=False)
        self.assertTrue(cg.is_clipped(self.folder / "part.frames"))
        self.assertFalse((self.folder / "part.frames" / "report.html").exists())
        self.assertLess(len(cg.read(self.folder / "part.frames")), len(self.ball))

    def test_are_drawn_and_shown_on_pages(self):
        self.ball.render(self.folder / "ball.png", cut=("y", 0.1), view="front", size=(200, 150), colour="energy")
        self.assertEqual((self.folder / "ball.png").read_bytes()[:4], b"\x89PNG")
        self.ball.render(self.folder / "cut.png", cut="x", size=(200, 150))
        self.assertNotEqual((self.folder / "cut.png").read_bytes(), (self.folder / "ball.png").read_bytes())
        with self.assertRaises(TypeError):
            self.ball.render(self.folder / "cut.png", cut="w")
        self.ball.write_page(self.folder / "ball.html")
        self.assertIn(b"crossgrain-scene", (self.folder / "ball.html").read_bytes())

    def test_start_from_another_field(self):
        again = cg.solve(*ball(), resolution=20, start=self.ball)
        self.assertLess(abs(again.report["energy"]["total"] / self.ball.report["energy"]["total"] - 1), 0.05)

    def test_have_lines_along_their_axes(self):
        lines = self.box.streamlines([[1, 0.5, 0.75], [9, 9, 9]])
        self.assertEqual((len(lines), lines.outside_seeds), (3, 1))
        self.assertEqual(sorted(round(line.length, 3) for line in lines), [1, 1.5, 2])
        self.assertEqual({line.first_end for line in lines}, {"boundary"})
        on_cut = self.box.streamlines(on="y", count=9, spacing_sides=0.1)
        on_cut.write(self.folder / "lines.vtu")
        self.assertEqual(len(cg.read_streamlines(self.folder / "lines.vtu")), len(on_cut))
        self.box.render(self.folder / "lines.png", streamlines=on_cut, size=(200, 150))

    def test_of_degree_three_have_seven_coefficients(self):
        field = cg.solve(*box(), resolution=8, degree=3)
        coefficients = field.coefficients()
        self.assertEqual(coefficients.shape, (len(field), 7))
        np.testing.assert_allclose(np.linalg.norm(coefficients, axis=1), 1, atol=1e-12)
        self.assertEqual(field.coefficients(4).shape, (len(field), 9))


class RepairedFields(WithFolder):
    @classmethod
    def setUpClass(cls):
        cls.plain = cg.solve_onto(*ball_of_tets(), prepare=True)
        cls.field = cls.plain.repaired()

    def test_have_other_matchings_on_the_same_mesh(self):
        np.testing.assert_array_equal(self.field.cells, self.plain.cells)
        moved = (self.field.points != self.plain.points).any(axis=1).sum()
        self.assertEqual(moved, self.field.report["onto"]["repair"]["moved_vertices"])
        self.assertGreater(moved, 0)
        np.testing.assert_array_equal(self.plain.repaired(moves_vertices=False).points, self.plain.points)
        np.testing.assert_array_equal(self.field.matchings.tets, self.plain.matchings.tets)
        repair = self.field.report["onto"]["repair"]
        self.assertNotIn("repair", self.plain.report["onto"])
        self.assertGreater(repair["moves"], 0)
        nearest = nearest_matrices(self.plain.frames, self.plain.matchings.tets)
        np.testing.assert_array_equal(self.plain.matchings.matrices, nearest)
        changed = (self.field.matchings.matrices != nearest).any(axis=(1, 2)).sum()
        self.assertEqual(changed, repair["changed_faces"])
        self.assertGreater(changed, 0)

    def test_have_the_matchings_of_their_perm_file(self):
        self.field.write(self.folder / "ball.frames", formats=["perm", "fra"])
        rows = (self.folder / "ball.frames" / "onto.perm").read_text().splitlines()[2:]
        matchings = self.field.matchings
        turning = ~matchings.are_identities
        expected = np.column_stack([matchings.tets[turning], matchings.axes[turning]])
        self.assertEqual(sorted(rows), sorted(" ".join(map(str, row)) for row in expected.tolist()))
        frames = np.array([row.split() for row in (self.folder / "ball.frames" / "onto.fra").read_text().splitlines()[2:]], float)
        np.testing.assert_allclose(frames.reshape(-1, 3, 3), self.field.frames, atol=1e-15)

    def test_are_read_to_the_bit(self):
        self.field.write(self.folder / "ball.frames")
        again = cg.read(self.folder / "ball.frames")
        np.testing.assert_array_equal(again.quaternions, self.field.quaternions)
        np.testing.assert_array_equal(again.matchings.axes, self.field.matchings.axes)
        self.assertEqual(again.report["onto"]["repair"], self.field.report["onto"]["repair"])
        self.assertEqual(again.check().sentence, self.field.check().sentence)
        self.assertEqual(len(again.singularities.arcs), len(self.field.singularities.arcs))

    def test_do_not_depend_on_threads(self):
        one = self.plain.repaired(threads=1)
        np.testing.assert_array_equal(one.quaternions, self.field.quaternions)
        np.testing.assert_array_equal(one.matchings.axes, self.field.matchings.axes)

    def test_come_from_solves_too(self):
        solved = cg.solve(cg.TetMesh(*ball_of_tets()), prepare=True, repair=True)
        np.testing.assert_array_equal(solved.quaternions, self.field.quaternions)
        still = cg.RepairOptions(moves_vertices=False)
        carried = cg.carry_onto(cg.solve(*ball(), resolution=12), *ball_of_tets(), prepare=cg.MapPreparationOptions(), repair=still)
        self.assertIn("repair", carried.report["onto"])
        self.assertIn("prepared", carried.report["onto"])

    def test_keep_vertices_on_request(self):
        moved, still = (self.plain.repaired(moves_vertices=moves).report["onto"]["repair"] for moves in (True, False))
        self.assertGreater(moved["moved_vertices"], 0)
        self.assertEqual(still["moved_vertices"], 0)

    def test_refuse_what_they_cannot_take(self):
        with self.assertRaisesRegex(cg.UsageError, "threads"):
            self.plain.repaired(threads=-1)
        for wrong in ({"moves_vertices": None}, {"weights": 3}, {"options": cg.SolveOptions()}):
            with self.assertRaises(TypeError):
                self.plain.repaired(**wrong)
        for wrong in ({"prepare": True}, {"repair": True}):
            with self.assertRaisesRegex(cg.UsageError, "carry_onto"):
                cg.solve(*box(), **wrong)

    def test_are_none_of_tets_without_volume(self):
        points, cells = cube_of_tets(2)
        points[13] = points[12]  # the one inside comes to lie on a side
        with self.assertRaisesRegex(cg.InputError, "without volume"):
            cg.solve_onto(points, cells, repair=True)


class FieldsOnTets(WithFolder):
    @classmethod
    def setUpClass(cls):
        cls.field = cg.solve_onto(*cube_of_tets(5))

    def test_have_frames_of_tets_and_vertices(self):
        field = self.field
        self.assertEqual((field.frames.shape, field.vertex_frames.shape), ((750, 3, 3), (216, 3, 3)))
        self.assertGreater(alignment(field.frames).min(), 0.999)
        np.testing.assert_array_equal(field.points, cube_of_tets(5)[0])
        self.assertEqual(field.check().verdict, "meshable")
        self.assertEqual(len(field.singularities.arcs), 0)
        self.assertGreater(len(field.grid), 0)
        self.assertEqual((len(field.quaternions), len(field.vertex_quaternions)), (750, 216))

    def test_have_matchings_that_carry_frames_across_faces(self):
        matchings, frames = self.field.matchings, self.field.frames
        self.assertEqual(len(matchings), (4 * 750 - 6 * 2 * 25) // 2)
        renamed = matchings.matrices @ frames[matchings.tets[:, 1]]
        self.assertGreater(np.einsum("fka,fka->fk", renamed, frames[matchings.tets[:, 0]]).min(), 0.99)
        both = [np.intersect1d(self.field.cells[a], self.field.cells[b]) for a, b in matchings.tets[:50]]
        np.testing.assert_array_equal(both, matchings.faces[:50])
        self.assertEqual(matchings.are_identities.sum(), (matchings.axes == [1, 2, 3]).all(axis=1).sum())

    def test_are_read_as_they_were_written(self):
        self.field.write(self.folder / "cube.frames", formats=["perm", "fra"])
        names = {path.suffix for path in (self.folder / "cube.frames").iterdir()}
        self.assertLessEqual({".perm", ".fra", ".vtu", ".json"}, names)
        again = cg.read(self.folder / "cube.frames")
        self.assertIsInstance(again, cg.TetField)
        np.testing.assert_allclose(again.vertex_frames, self.field.vertex_frames, atol=1e-12)

    def test_come_from_a_field_on_a_grid_too(self):
        field = cg.solve(*box((1, 1, 1)), resolution=10)
        carried = cg.carry_onto(field, *cube_of_tets(3))
        self.assertEqual(len(carried), 162)

    def test_may_be_of_tets_prepared_for_a_map(self):
        points, cells = cube_of_tets(2)
        tets = cg.TetMesh(points, cells)
        self.assertIsNone(tets.parents)
        prepared = tets.prepared_for_map()
        np.testing.assert_array_equal(prepared.points[:len(points)], points)
        corners = lambda its_points, its_cells: its_points[its_cells[:, 1:]] - its_points[its_cells[:, :1]]
        volumes = np.bincount(prepared.parents, np.linalg.det(corners(prepared.points, prepared.cells)), len(cells))
        np.testing.assert_allclose(volumes, np.linalg.det(corners(tets.points, tets.cells)), atol=1e-15)
        field = cg.solve_onto(prepared)
        self.assertEqual(field.report["onto"]["prepared"]["tets_before"], len(cells))
        self.assertEqual(len(field.frames), len(prepared.cells))
        field.write(self.folder / "prepared.frames", formats=["mesh", "fra"], hex_size=0.25)
        rows = (self.folder / "prepared.frames" / "onto.fra").read_text().splitlines()[2:]
        axes = np.array([row.split() for row in rows], float)
        np.testing.assert_allclose(np.linalg.norm(axes, axis=1), 4)
        self.assertEqual(len(cg.read_tets(self.folder / "prepared.frames" / "onto.mesh").cells), len(prepared.cells))

    def test_keep_regions(self):
        points, cells = cube_of_tets(4)
        regions = (points[cells].mean(axis=1)[:, 0] > 0.5).astype(np.int16) + 3
        field = cg.solve_onto(cg.TetMesh(points, cells, regions=regions))
        np.testing.assert_array_equal(field.regions, regions)
        self.assertEqual(len(field.report["regions"]), 2)


@unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")
class MadeTets(WithFolder):
    def test_fill_a_box_and_know_its_faces_and_edges(self):
        tets = cg.make_tets(*box((2, 1, 1.5)), size=0.4, maker="gmsh")
        corners = tets.points[tets.cells]
        volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
        self.assertGreater(volumes.min(), 0)
        self.assertAlmostEqual(volumes.sum(), 3, 9)
        self.assertEqual(set(tets.face_tags), set(range(1, 7)))
        self.assertEqual(len(tets.feature_faces), len(tets.face_tags))
        self.assertTrue(tets.edges_are_stated.all())
        ends = tets.points[tets.feature_edges]
        self.assertAlmostEqual(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum(), 4 * 4.5, 9)
        self.assertEqual(cg.solve_onto(tets).check().verdict, "meshable")

    def test_are_written_and_read(self):
        tets = cg.make_tets(*ball(8), edges=6)
        for name in ("ball.mesh", "ball.msh"):
            tets.write(self.folder / name)
            again = cg.read_tets(self.folder / name)
            np.testing.assert_array_equal(again.points, tets.points)
            np.testing.assert_array_equal(again.cells, tets.cells)
            np.testing.assert_array_equal(again.face_tags, tets.face_tags)

    def test_of_an_open_surface_fill_the_hole(self):
        vertices, triangles = box()
        tets = cg.make_tets(vertices, triangles[1:])
        corners = tets.points[tets.cells]
        volume = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).sum() / 6
        self.assertAlmostEqual(volume, np.prod(np.ptp(np.asarray(vertices), axis=0)), 9)

    def test_by_a_program_that_is_missing_say_so(self):
        with mock.patch.dict(os.environ, PATH="/nowhere"), self.assertRaisesRegex(cg.InputError, "not in PATH.*install gmsh"):
            cg.make_tets(*box(), maker="gmsh")


def content(handle, name, kind):
    """What an option of a handle has, as text or numbers."""
    if kind == _interface.TEXT:
        return _library.text_from("options_get_text", handle, name.encode())
    rows = _library.made("numbers", "options_get_numbers", handle, name.encode())
    count = _library.library.crossgrain_numbers_rows(rows)
    return _library.array_view(rows, _library.library.crossgrain_numbers_data(rows), float, (count,)).tolist()


class Options(unittest.TestCase):
    def test_have_the_defaults_of_the_library(self):
        kinds = [cg.SolveOptions, cg.ReadOptions, cg.TetTagOptions, cg.OutputOptions, cg.StreamlineOptions,
                 cg.PictureOptions, cg.MapPreparationOptions, cg.RepairOptions]
        for kind in kinds:
            types = _options.types_of(kind._kind)
            # Python sets for_page itself.
            self.assertEqual([name for name in types if name != "for_page"], [name for name, _ in _options.flattened(kind())], kind.__name__)
            handle = _library.made("options", "options_new", kind._kind)
            python = _options.handle_of(kind())
            for name, its_type in types.items():
                self.assertEqual(content(python, name, its_type), content(handle, name, its_type), name)

    def test_reach_the_library(self):
        options = cg.SolveOptions(resolution=8)
        options.crease_angle_deg = 0
        with self.assertRaisesRegex(cg.UsageError, "the angle of creases"):
            cg.solve(*box(), options=options)

    def test_that_do_not_exist_are_a_type_error(self):
        with self.assertRaisesRegex(TypeError, "colour"):
            cg.Field.render(cg.solve(*box(), resolution=8), "a.png", color="energy")
        with self.assertRaises(TypeError):
            cg.SolveOptions(resolutoin=3)  # pylint: disable=unexpected-keyword-arg
        with self.assertRaisesRegex(AttributeError, "resolutoin"):
            cg.SolveOptions().resolutoin = 3
        for wrong in (cg.HexOptions(), {}, None, 5):
            options = cg.HexMeshingOptions()
            options.solve = wrong
            with self.assertRaisesRegex(TypeError, "SolveOptions"):
                _options.handle_of(options)
        with self.assertRaisesRegex(TypeError, "SolveOptions"):
            cg.solve(*box(), options=cg.ReadOptions())

    def test_of_any_integer_are_kept(self):
        for seed in (2**63, 2**64 - 1):
            self.assertGreater(len(cg.solve(*box(), resolution=8, seed=seed)), 0)
        with self.assertRaises(cg.UsageError):
            cg.solve(*box(), resolution=8, seed=2**64)

    def test_of_writing_say_whether_there_is_a_page(self):
        field = cg.solve(*box(), resolution=8)
        with tempfile.TemporaryDirectory() as folder:
            for name, arguments, has_page in [("a", {}, True), ("b", {"options": cg.OutputOptions()}, False),
                                              ("c", {"options": cg.OutputOptions(), "page": True}, True), ("d", {"page": False}, False)]:
                field.write(f"{folder}/{name}", **arguments)
                self.assertEqual(Path(f"{folder}/{name}/report.html").exists(), has_page)
        with self.assertRaisesRegex(cg.UsageError, "resolution"):
            cg.solve(*box(), resolution=1.5)


class Errors(WithFolder):
    def test_name_the_file_and_the_place(self):
        path = self.folder / "broken.obj"
        path.write_text("v 0 0 0\nv 1 0 x\n", encoding="utf-8")
        with self.assertRaises(cg.InputError) as caught:
            cg.solve(path)
        self.assertEqual((caught.exception.file, caught.exception.place), (str(path), "line 2"))
        self.assertIn(caught.exception.text, str(caught.exception))

    def test_of_a_model_that_can_be_read_name_its_file_too(self):
        path = self.folder / "sheet.obj"
        path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
        flat = self.folder / "flat.mesh"
        flat.write_text(medit_text(np.zeros((4, 3)), np.array([[0, 1, 2, 3]])), encoding="utf-8")
        for model in (path, flat):
            with self.assertRaises(cg.InputError) as caught:
                cg.solve(str(model))
            self.assertEqual(caught.exception.file, str(model))
            self.assertTrue(str(caught.exception).startswith(f"{model}: "))

    def test_are_of_the_kinds_that_python_knows(self):
        self.assertTrue(issubclass(cg.InputError, ValueError) and issubclass(cg.OutputError, OSError))
        with self.assertRaises(cg.InputError):
            cg.solve("missing.stl")
        with self.assertRaises(cg.InputError):
            cg.read(self.folder / "missing.frames")
        with self.assertRaises(cg.OutputError) as caught:
            cg.solve(*box(), resolution=8).write("/proc/no.frames")
        self.assertIn("/proc", str(caught.exception))
        with self.assertRaises(cg.UsageError):
            cg.solve(*box(), resolution=2)
        with self.assertRaises(cg.UsageError):
            cg.solve(*box(), resolution=8).sample([[0, 0, np.nan]])
        with self.assertRaises(cg.InputError):
            cg.solve(np.zeros((3, 3)), [[0, 1, 2]])

    def test_protect_folders_of_others(self):
        (self.folder / "mine").mkdir()
        (self.folder / "mine" / "thesis.txt").write_text("years", encoding="utf-8")
        field = cg.solve(*box(), resolution=8)
        with self.assertRaisesRegex(cg.OutputError, "thesis.txt"):
            field.write(self.folder / "mine")
        field.write(self.folder / "mine", foreign_files="keep", page=False)
        self.assertTrue((self.folder / "mine" / "thesis.txt").exists())

    def test_protect_results_that_were_changed(self):
        field = cg.solve(*box(), resolution=8)
        field.write(self.folder / "box.frames", page=False)
        surface = self.folder / "box.frames" / "surface.vtu"
        surface.write_bytes(surface.read_bytes() + b"mine")
        for foreign_files in ("refuse", "keep"):
            with self.assertRaisesRegex(cg.OutputError, "surface.vtu', which was changed"):
                field.write(self.folder / "box.frames", foreign_files=foreign_files)
        field.write(self.folder / "box.frames", foreign_files="replace")
        self.assertFalse(surface.read_bytes().endswith(b"mine"))

    def test_of_pickling_say_what_to_do_instead(self):
        with self.assertRaisesRegex(TypeError, "write"):
            pickle.dumps(cg.solve(*box(), resolution=8))


class Arguments(unittest.TestCase):
    """Values that C would cut to a size, read as something else or follow as an address."""

    @classmethod
    def setUpClass(cls):
        cls.field = cg.solve(*ball(6), resolution=8)

    def test_that_are_integers_out_of_range_are_refused(self):
        vertices, triangles = box()
        for call in (lambda: cg.coefficients(np.eye(3)[None], degree=2**32 + 3), lambda: cg.Constraints().add_face(2**32 + 3),
                     lambda: cg.Surface(vertices, triangles, creases=[(vertices, vertices, 2**40, True)]),
                     lambda: self.field.sample([[0, 0, 0]], threads=-1), lambda: self.field.sample([[0, 0, 0]], threads=2**32 + 1),
                     lambda: self.field.streamlines(count=-1), lambda: cg.read("nowhere", max_memory_bytes=-1)):
            self.assertRaises(cg.UsageError, call)

    def test_of_another_type_are_type_errors(self):
        field = self.field
        for call in (lambda: field.sample([[0, 0, 0]], threads="a"), lambda: field.sample([[0, 0, 0]], threads=1.5),
                     lambda: field.streamlines(count=1.5), lambda: field.streamlines(on="x", position="a"),
                     lambda: cg.Constraints().add_point([0, 0, 0], [1, 0, 0], "heavy"), lambda: cg.Constraints().add_face(1.5),
                     lambda: cg.Constraints().add_point([[1], [2, 3]], [1, 0, 0]), lambda: field.render("a.png", singularities=field),
                     lambda: field.render("a.png", streamlines=field.singularities), lambda: field.streamlines(surface=cg.TetMesh(*cube_of_tets(2))),
                     lambda: field.streamlines(surface=box()[0]), lambda: cg.solve(*box(), start=5), lambda: cg.carry_onto(None, *cube_of_tets(2)),
                     lambda: cg.SingularityGraph(None), lambda: cg.Answer(None), lambda: cg.Streamlines(None), lambda: cg.Matchings(None),
                     lambda: cg.Field(None), lambda: cg.TetField(field._handle), lambda: cg.solve(5), lambda: cg.solve(None)):
            self.assertRaises(TypeError, call)

    def test_that_contradict_are_refused(self):
        self.assertRaises(cg.UsageError, self.field.streamlines, [[0, 0, 0]], on="x")
        self.assertRaises(cg.UsageError, cg.solve, cg.TetMesh(*cube_of_tets(2)), read_options=cg.ReadOptions())

    def test_with_a_zero_byte_are_refused(self):
        for call in (lambda: cg.spectrum("cube\0x"), lambda: cg.solve("part.stl\0"), lambda: self.field.render("a.png", view="front\0x")):
            self.assertRaises(cg.UsageError, call)

    def test_of_one_point_are_taken(self):
        sample = self.field.sample_all([0, 0, 0])
        self.assertEqual((sample.frames.shape, bool(sample.in_active_cell)), ((3, 3), True))


class Constraints(unittest.TestCase):
    def test_are_added_by_several_threads(self):
        constraints = cg.Constraints()

        def add_many():
            for _ in range(3000):
                constraints.add_point([0, 0, 0], [1, 0, 0])
        threads = [threading.Thread(target=add_many) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(cg.solve(*ball(6), resolution=8, constraints=constraints).report["constraints"]["points"]["count"], 12000)

    def test_turn_the_frames(self):
        axes = np.array([1, 1, 1]) / np.sqrt(3)
        constraints = cg.Constraints().add_point([0, 0, 0], axes, weight=1000)
        frame = cg.solve(*ball(8), resolution=12, constraints=constraints).sample([0, 0, 0])
        self.assertGreater(np.abs(frame @ axes).max(), 0.97)

    def test_that_are_wrong_are_input_errors(self):
        for wrong in (cg.Constraints().add_point([0, 0, 0], [0, 0, 0]), cg.Constraints().add_point([0, 0, 0], [1, 0, 0], -1),
                      cg.Constraints().add_face(5), cg.Constraints().add_polyline([[0, 0, 0]]),
                      cg.Constraints().add_stress([9, 9, 9], [1, 2, 3, 0, 0, 0])):
            with self.assertRaises(cg.InputError):
                cg.solve(*box(), resolution=8, constraints=wrong)


class Spectra(unittest.TestCase):
    def test_of_a_plane_are_exact(self):
        np.testing.assert_allclose(cg.spectrum("plane", degree=3).eigenvalues, [0, 0, 1, 1, 1, 1, 1], atol=1e-12)
        form = cg.spectrum([[0, 0, 2.0]], degree=4)
        np.testing.assert_allclose(form.matrix, cg.spectrum("plane").matrix, atol=1e-12)

    def test_vanish_on_the_coefficients_of_frames_that_follow_the_normals(self):
        form, h = cg.spectrum(np.eye(3)), cg.coefficients(np.eye(3)[None, [2, 0, 1]])[0]
        self.assertAlmostEqual(h @ form.matrix @ h - 2 * form.linear @ h + form.constant, 0, 12)


class Progress(unittest.TestCase):
    def test_is_told_on_the_thread_that_solves(self):
        heard = []
        cg.solve(*box(), resolution=16, progress=lambda progress: heard.append((progress.phase, threading.current_thread())))
        self.assertIn("solve", [phase for phase, _ in heard])
        self.assertEqual({thread for _, thread in heard}, {threading.main_thread()})

    def test_that_raises_cancels_and_is_raised(self):
        def stop(progress):
            raise LookupError(progress.phase)
        for make in (lambda: cg.solve(*box(), resolution=24, progress=stop), lambda: in_thread(lambda: cg.solve(*box(), resolution=24, progress=stop))):
            with self.assertRaises(LookupError):
                make()


def in_thread(work):
    """What work() returns or raises on a thread of its own."""
    outcome = []

    def run():
        try:
            outcome.append((work(), None))
        except Exception as error:  # pylint: disable=broad-except
            outcome.append((None, error))
    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    if outcome[0][1]:
        raise outcome[0][1]
    return outcome[0][0]


# Sends Ctrl-C while the computation runs, and prints the processor time until KeyboardInterrupt comes: the process may have to wait for other
# programs, and its own work until then is the same on a busy machine.
INTERRUPTED = """
import os, signal, sys, threading, time
sys.path.insert(0, {tests!r})
import numpy as np
import crossgrain as cg
from solids import ball
sent = []
def interrupt():
    sent.append(time.process_time())
    os.kill(os.getpid(), signal.SIGINT)
{before}
timer = threading.Timer({after}, interrupt)
timer.start()
try:
    {work}
except KeyboardInterrupt:
    print(time.process_time() - sent[0])
else:
    print("finished")
# The field is as before.
assert len(cg.solve(*ball(6), resolution=8)) > 0
"""


class Threads(unittest.TestCase):
    def interrupted(self, work, before="", after=0.7):
        code = INTERRUPTED.format(tests=str(Path(__file__).parent), work=work, before=before, after=after)
        result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=100, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotEqual(result.stdout, "finished\n")
        self.assertLess(float(result.stdout), 1)

    def test_let_ctrl_c_end_a_solve(self):
        self.interrupted("cg.solve(*ball(40), resolution=300)")

    def test_survive_signals_at_any_moment(self):
        """An alarm that raises comes at random moments of many calls, among them the first and the last."""
        code = f"""
import random, signal, sys
sys.path.insert(0, {str(Path(__file__).parent)!r})
import numpy as np, crossgrain as cg
from solids import ball
class Alarm(Exception): pass
def ring(*_): raise Alarm
field = cg.solve(*ball(6), resolution=8)
points = np.zeros((3000, 3))
signal.signal(signal.SIGALRM, ring)
rung, moments = 0, random.Random(1)
for _ in range(1000):
    try:
        signal.setitimer(signal.ITIMER_REAL, moments.uniform(1e-6, 2e-3))
        field.sample(points)
        signal.setitimer(signal.ITIMER_REAL, 0)
    except Alarm:
        rung += 1
signal.setitimer(signal.ITIMER_REAL, 0)
print(rung > 100 and field.sample(points).shape)
"""
        result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=100, check=False)
        self.assertEqual((result.returncode, result.stdout), (0, "(3000, 3, 3)\n"), result.stderr)

    def test_end_with_the_interpreter(self):
        for progress in ("None", "repr"):
            code = f"""
import sys, threading, time
sys.path.insert(0, {str(Path(__file__).parent)!r})
import crossgrain as cg
from solids import ball
def solve():
    try:
        cg.solve(*ball(40), resolution=100, progress={progress})
    except cg.Interrupted:
        pass  # at the end; a daemon thread must not write to the standard streams then
threading.Thread(target=solve, daemon=True).start()
time.sleep(0.5)
"""
            result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=100, check=False)
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_let_ctrl_c_end_a_sampling(self):
        self.interrupted("field.sample(points)", "field, points = cg.solve(*ball(), resolution=16), np.random.default_rng(0).uniform(-1, 1, (20000000, 3))")

    def test_solve_at_once_to_the_same_bits(self):
        alone = cg.solve(*ball(), resolution=24)
        fields = []
        threads = [threading.Thread(target=lambda: fields.append(cg.solve(*ball(), resolution=24))) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for field in fields:
            np.testing.assert_array_equal(field.quaternions, alone.quaternions)

    def test_run_while_a_field_is_sampled(self):
        field = cg.solve(*ball(), resolution=16)
        points = np.random.default_rng(0).uniform(-1, 1, (300000, 3))
        field.sample(points[:10])
        count, done = 0, threading.Event()
        thread = threading.Thread(target=lambda: (field.sample(points), done.set()))
        thread.start()
        while not done.is_set():
            count += 1
            time.sleep(0.001)
        thread.join()
        self.assertGreater(count, 3)


class Memory(unittest.TestCase):
    def test_is_flat_over_many_solves(self):
        """CROSSGRAIN_SOLVES is how many, 200 unless it says otherwise."""
        vertices, triangles = box()

        def resident():
            return int(Path("/proc/self/statm").read_text(encoding="utf-8").split()[1]) * resource.getpagesize()

        def solve_many(count):
            for _ in range(count):
                field = cg.solve(vertices, triangles, resolution=6)
                field.sample(field.centers[:5])
                len(field.singularities.arcs), field.frames, field.report  # pylint: disable=expression-not-assigned

        solve_many(100)
        before = resident()
        solve_many(int(os.environ.get("CROSSGRAIN_SOLVES", "200")))
        self.assertLess(resident() - before, 4e6)


if __name__ == "__main__":
    unittest.main()
