#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain streamlines`."""

import re
import resource
import signal
import subprocess
import unittest

import numpy as np
from field_reader import read_arrays
from program import PROGRAM, CommandTest, box_triangles, cylinder_triangles, medit_text, stl_bytes, tet_box, tilt

USAGE, INPUT, OUTPUT, INTERRUPTED = 2, 3, 4, 130
BOUNDARY, ARC, CLOSED, LONGEST, AMBIGUOUS, CROWDED = range(6)
VTK_POLY_LINE = 4


class Lines:
    """The lines of a file, with code of its own."""

    def __init__(self, path):
        self.arrays = read_arrays(path)
        ends = self.arrays["offsets"].astype(int)
        assert (self.arrays["types"] == VTK_POLY_LINE).all()
        assert (self.arrays["connectivity"] == np.arange(len(self.arrays["Points"]))).all()
        self.points = np.split(self.arrays["Points"], ends[:-1])
        self.tangents = np.split(self.arrays["tangent"].astype(float), ends[:-1])
        self.distances = np.split(self.arrays["distance"].astype(float), ends[:-1])

    def __len__(self):
        return len(self.points)

    def ends(self):
        return np.concatenate([self.arrays["first_end"], self.arrays["last_end"]])


class Streamlines(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("box.stl", stl_bytes(box_triangles((2, 1, 1.5))))
        self.copied_from_first("box", "box", lambda: self.assert_succeeds(
            self.run_here("solve", "box.stl", "--resolution", "8", "-o", "box", "--no-report")))

    def trace(self, *arguments, **options):
        return self.run_here("streamlines", "box", *arguments, **options)

    def lines(self, *arguments, file="box/streamlines.vtu"):
        result = self.trace(*arguments)
        self.assert_succeeds(result)
        return Lines(self.folder / file)

    def test_of_a_box_run_along_its_edges_from_face_to_face(self):
        lines = self.lines("--count", "100", "--spacing", "0")
        self.assertEqual(len(lines), 300)
        self.assertEqual(lines.arrays["seed"].tolist(), np.repeat(np.arange(100), 3).tolist())
        self.assertEqual(lines.arrays["axis"].tolist(), [0, 1, 2] * 100)
        self.assertTrue((lines.ends() == BOUNDARY).all())
        size = np.array([2, 1, 1.5])
        for axis, points, tangents, distances, length in zip(
                lines.arrays["axis"], lines.points, lines.tangents, lines.distances, lines.arrays["length"]):
            way = np.eye(3)[axis]
            np.testing.assert_allclose(points[-1] - points[0], size * way, atol=1e-4)
            np.testing.assert_allclose([points[0] @ way, points[-1] @ way], [0, size[axis]], atol=1e-9)
            np.testing.assert_allclose(tangents, np.tile(way, (len(points), 1)), atol=1e-4)
            self.assertAlmostEqual(length, size[axis], places=4)
            np.testing.assert_allclose(np.diff(distances), np.linalg.norm(np.diff(points, axis=0), axis=1), atol=1e-6)
            self.assertEqual(np.count_nonzero(distances == 0), 1)

    def test_of_a_field_without_a_surface_end_with_the_cells_at_most_one_further_out(self):
        (self.folder / "box/surface.vtu").unlink()
        lines = self.lines("--spacing", "0", "--count", "100")
        size, cell = np.array([2, 1, 1.5]), 2 / 8
        for axis, points in zip(lines.arrays["axis"], lines.points):
            for end, face in ((points[0], 0), (points[-1], size[axis])):
                self.assertLess(abs(end[axis] - face), cell + 1e-9)
        self.assert_fails(self.trace("--on", "surface"), USAGE, "no surface")

    def test_are_kept_apart(self):
        lines = self.lines("--spacing", "0.2")
        self.assertLess(len(lines), 60)
        for axis in range(3):
            places = np.array([points[0] for points, name in zip(lines.points, lines.arrays["axis"]) if name == axis])
            gaps = np.linalg.norm(places[:, None] - places, axis=2) + 10 * np.eye(len(places))
            self.assertGreater(gaps.min(), 0.99 * 0.2 * 2)
        self.assertGreater(len(self.lines("--spacing", "0.1")), len(lines))

    def test_seeds_may_be_spread_over_the_surface(self):
        lines = self.lines("--on", "surface", "--spacing", "0", "--count", "60")
        self.assertEqual(len(lines), 120)
        size = np.array([2, 1, 1.5])
        for axis, points, distances in zip(lines.arrays["axis"], lines.points, lines.distances):
            seed = points[np.flatnonzero(distances == 0)[0]]
            beside = np.minimum(seed, size - seed)
            self.assertLess(np.delete(beside, axis).min(), 2 / 8)
            self.assertTrue((seed > 0).all() and (seed < size).all())

    def test_seeds_may_be_spread_over_a_cut(self):
        for on, z in (("z", 0.75), ("z=0.3", 0.3)):
            lines = self.lines("--on", on, "--spacing", "0", "--count", "20")
            self.assertEqual(lines.arrays["axis"].tolist(), [0, 1] * 20)
            np.testing.assert_allclose(lines.arrays["Points"][:, 2], z, atol=1e-4)
        self.assert_fails(self.trace("--on", "z=1.6"), USAGE, "outside the part", "from 0 to 1.5")

    def test_of_tets_are_lines_in_the_tets_unless_the_grid_is_asked_for(self):
        self.write("box.mesh", medit_text(*tet_box()))
        self.assert_succeeds(self.run_here("solve", "box.mesh", "-o", "box"))
        on_tets = self.lines("--axes", "x")
        np.testing.assert_allclose(on_tets.arrays["length"], 2, atol=1e-9)
        np.testing.assert_array_equal(self.lines("--axes", "x", "--field", "tets").arrays["Points"],
                                      on_tets.arrays["Points"])
        self.lines("--axes", "x", "--field", "grid")

    def test_tets_that_are_not_there_are_missed(self):
        self.assert_fails(self.trace("--field", "tets"), INPUT, "box", "no field on tets")

    def test_go_through_the_seeds_that_are_given(self):
        self.write("seeds.txt", "0.3 0.4 0.5  # one\n\n1.9 0.1 1.4\n")
        lines = self.lines("seeds.txt", "-o", "lines.vtu", "--axes", "zx", file="lines.vtu")
        self.assertEqual(lines.arrays["seed"].tolist(), [0, 0, 1, 1])
        self.assertEqual(lines.arrays["axis"].tolist(), [0, 2, 0, 2])
        for seed, points, distances in zip(lines.arrays["seed"], lines.points, lines.distances):
            at_seed = points[np.flatnonzero(distances == 0)[0]].tolist()
            self.assertEqual(at_seed, [[0.3, 0.4, 0.5], [1.9, 0.1, 1.4]][seed])
        self.assert_succeeds(self.trace("-", "-o", "piped.vtu", "--axes", "xz",
                                        stdin=b"0.3 0.4 0.5\n1.9 0.1 1.4\n"))
        self.assertEqual((self.folder / "piped.vtu").read_bytes(), (self.folder / "lines.vtu").read_bytes())

    def test_seeds_outside_are_counted_and_told(self):
        self.write("seeds.txt", "0.3 0.4 0.5\n5 0 0\n-3 0 0\n")
        result = self.trace("seeds.txt")
        self.assert_succeeds(result)
        self.assertEqual(result.stderr, "crossgrain: 2 of 3 seeds are outside the field\n")
        self.assertEqual(Lines(self.folder / "box/streamlines.vtu").arrays["seed"].tolist(), [0, 0, 0])
        # Still in a cell, no longer in the solid.
        self.write("seeds.txt", "0.3 0.4 0.5\n-0.0001 0.5 0.5\n")
        self.assertIn("1 of 2 seeds", self.trace("seeds.txt").stderr)
        (self.folder / "box/surface.vtu").unlink()
        self.assertEqual(self.trace("seeds.txt").stderr, "")

    def test_without_any_line_the_run_ends_in_an_error_and_leaves_nothing(self):
        result = self.trace("-", stdin=b"5 0 0\n6 0 0\n")
        self.assert_fails(result, INPUT, "standard input: gives no line", "2 seeds", "2 are outside")
        self.assertNotIn("streamlines.vtu", [path.name for path in (self.folder / "box").iterdir()])

    def test_the_summary_has_the_numbers_of_the_file(self):
        result = self.trace("--count", "7", "--spacing", "0")
        self.assert_succeeds(result)
        self.assertEqual(result.stderr, "")
        lines = Lines(self.folder / "box/streamlines.vtu")
        self.assertRegex(result.stdout, re.compile(
            rf"^21 lines of 7 seeds, {len(lines.arrays['Points'])} points, .* long in all, traced in .* s\n"
            r"ends       42 at the boundary, 0 at singular arcs; 0 lines closed\n"
            r"result     box/streamlines.vtu\n$"))
        self.assertEqual(self.trace("--quiet").stdout, "")

    def test_of_a_cylinder_end_on_its_surface_and_go_round_where_the_field_does(self):
        self.write("cylinder.stl", stl_bytes(cylinder_triangles(segments=64)))
        self.assert_succeeds(self.run_here("solve", "cylinder.stl", "--resolution", "32", "-o", "cylinder", "--no-report"))
        self.assert_succeeds(self.run_here("streamlines", "cylinder", "--spacing", "0", "--count", "200"))
        lines = Lines(self.folder / "cylinder/streamlines.vtu")
        self.assertIn(ARC, lines.ends())
        radius, half_height, sagitta = 0.55, 0.7, 0.55 * (1 - np.cos(np.pi / 64))
        for first, last, points in zip(lines.arrays["first_end"], lines.arrays["last_end"], lines.points):
            local = points @ tilt().T
            off = np.maximum(np.hypot(local[:, 0], local[:, 1]) - radius, np.abs(local[:, 2]) - half_height)
            self.assertLess(off.max(), 1e-6)  # coordinates of the file are in single precision
            for end, at in ((first, off[0]), (last, off[-1])):
                if end == BOUNDARY:
                    self.assertGreater(at, -sagitta - 1e-6)

    def test_tangents_are_axes_of_the_frames_that_sample_gives(self):
        self.write("cylinder.stl", stl_bytes(cylinder_triangles()))
        self.assert_succeeds(self.run_here("solve", "cylinder.stl", "--resolution", "16", "-o", "cylinder", "--no-report"))
        self.assert_succeeds(self.run_here("streamlines", "cylinder", "--spacing", "0", "--count", "50"))
        lines = Lines(self.folder / "cylinder/streamlines.vtu")
        points, tangents = lines.arrays["Points"], lines.arrays["tangent"].astype(float)
        np.savetxt(self.folder / "points.txt", points, fmt="%.17g")
        self.assert_succeeds(self.run_here("sample", "cylinder", "points.txt", "-o", "frames.txt"))
        axes = np.loadtxt(self.folder / "frames.txt").reshape(-1, 3, 3)
        off = np.linalg.norm(np.cross(axes, tangents[:, None]), axis=2).min(axis=1)
        # Tangents are written in single precision. Ends may be seen from the cell across a closed face.
        inner = np.ones(len(points), bool)
        ends = lines.arrays["offsets"].astype(int)
        inner[[*(ends - 1), 0, *ends[:-1]]] = False
        self.assertLess(off[inner].max(), 1e-6)
        self.assertLess(np.percentile(off, 99), 1e-6)

    def test_the_pieces_of_a_line_go_along_its_tangents(self):
        lines = self.lines()
        for points, tangents in zip(lines.points, lines.tangents):
            pieces = np.diff(points, axis=0)
            pieces = pieces / np.linalg.norm(pieces, axis=1)[:, None]
            self.assertGreater(np.einsum("ij,ij->i", pieces, tangents[:-1]).min(), 0.99)
            self.assertGreater(np.einsum("ij,ij->i", pieces, tangents[1:]).min(), 0.99)

    def test_a_new_solve_takes_the_lines_of_the_old_one_away(self):
        self.lines()
        self.assert_succeeds(self.run_here("solve", "box.stl", "--resolution", "8", "-o", "box"))
        self.assertEqual(sorted(path.name for path in (self.folder / "box").iterdir() if path.name != "report.html"), ["field.vtu", "report.json", "singularities.vtu", "surface.vtu"])

    def test_files_that_would_be_overwritten_are_refused(self):
        self.write("seeds.txt", "0.3 0.4 0.5\n")
        before = (self.folder / "box/field.vtu").read_bytes()
        for arguments in (["seeds.txt", "-o", "./seeds.txt"], ["-o", "box/field.vtu"], ["-o", "-"], ["-o", ""]):
            self.assert_fails(self.trace(*arguments), USAGE)
        self.assertEqual((self.folder / "box/field.vtu").read_bytes(), before)

    def test_options_that_make_no_sense_are_refused(self):
        for arguments in (["--count", "0"], ["--axes", "xw"], ["--axes", "xx"], ["--axes", ""],
                          ["--on", "w"], ["--on", "none"], ["--on", ""], ["--spacing", "-1"],
                          ["--field", "cells"]):
            with self.subTest(arguments=arguments):
                self.assert_fails(self.trace(*arguments), USAGE)
        self.write("seeds.txt", "0.3 0.4 0.5\n")
        self.assert_fails(self.trace("seeds.txt", "--count", "3"), USAGE)
        self.assert_fails(self.trace("seeds.txt", "--on", "surface"), USAGE)

    def test_files_that_are_missing_or_wrong(self):
        self.assert_fails(self.run_here("streamlines", "none"), INPUT, "none")
        self.assert_fails(self.trace("none.txt"), INPUT, "none.txt")
        self.assert_fails(self.trace("-", stdin=b"0 0 0\n1 2\n"), INPUT, "standard input: line 2:")
        self.assert_fails(self.trace("-o", "none/lines.vtu"), OUTPUT, "none/lines.vtu")
        (self.folder / "box" / "field.vtu").write_bytes(b"<VTKFile>")
        self.assert_fails(self.trace(), INPUT, "field.vtu")

    def test_a_full_disk_leaves_nothing_and_an_earlier_result_as_it_was(self):
        def small_files_only():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

        self.lines("--count", "5")
        before = (self.folder / "box/streamlines.vtu").read_bytes()
        result = self.trace("--count", "3000", "--spacing", "0", preexec_fn=small_files_only)
        self.assert_fails(result, OUTPUT, "streamlines.vtu", "too large", "-o")
        self.assertEqual((self.folder / "box/streamlines.vtu").read_bytes(), before)
        self.assertEqual(sorted(path.name for path in (self.folder / "box").iterdir() if path.name != "report.html"),
                         ["field.vtu", "report.json", "singularities.vtu", "streamlines.vtu", "surface.vtu"])

    def test_interrupting_leaves_nothing(self):
        # Far more lines than can be traced before the signal.
        command = [PROGRAM, "streamlines", "box", "--count", "2000000", "--spacing", "0"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder) as process:
            try:
                process.communicate(timeout=2)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGINT)
            _, error = process.communicate(timeout=30)
        self.assertEqual(process.returncode, INTERRUPTED)
        self.assertEqual(error.count(b"\n"), 1)
        self.assertEqual(sorted(path.name for path in (self.folder / "box").iterdir() if path.name != "report.html"), ["field.vtu", "report.json", "singularities.vtu", "surface.vtu"])


if __name__ == "__main__":
    unittest.main()
