#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain sample` and `crossgrain spectrum`."""

import json
import unittest

import numpy as np
from program import CommandTest, box_triangles, run, stl_bytes

USAGE, INPUT, OUTPUT = 2, 3, 4


class Sample(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("box.stl", stl_bytes(box_triangles((2, 1, 1.5))))
        self.assert_succeeds(self.run_here("solve", "box.stl", "--resolution", "8", "-o", "box"))

    def sample(self, text, *arguments):
        return self.run_here("sample", "box", "-", *arguments, stdin=text.encode())

    def test_gives_nine_numbers_a_line_that_make_a_frame(self):
        result = self.sample("0.3 0.4 0.5\n1.9 0.1 1.4\n# a comment\n\n  1 0.5 0.75  # the middle\n")
        self.assert_succeeds(result)
        lines = result.stdout.splitlines()
        self.assertEqual(lines.pop(0), "# written by Crossgrain: ux uy uz vx vy vz wx wy wz")
        self.assertEqual(len(lines), 3)
        for line in lines:
            axes = np.array([float(word) for word in line.split(" ")]).reshape(3, 3)
            np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)
            self.assertGreater(np.linalg.det(axes), 0)
            # The box's own frame: every axis along a coordinate axis.
            np.testing.assert_allclose(np.abs(axes).max(axis=1), 1, atol=1e-5)
        self.assertEqual(result.stderr, "crossgrain: 0 of 3 points are outside the field\n")

    def test_takes_points_as_arguments_with_and_without_a_minus_sign(self):
        for words in (["-1", "0.5", "-2"], ["-.5", "-1e-3", "+2", "0.3", "0.4", "0.5"], ["-inf", "0", "0"], ["1", "2"],
                      ["1", "2", "3", "4"], ["1", "2", "x"]):
            with self.subTest(words=words):
                result = self.run_here("sample", "box", *words, "-o", "frames.txt")
                if "-inf" in words or "x" in words or len(words) % 3:
                    self.assert_fails(result, USAGE, "try 'crossgrain sample --help'")
                    continue
                self.assert_succeeds(result)
                points = np.array(words, float).reshape(-1, 3)
                lines = [" ".join(map(repr, point)) for point in points.tolist()]
                self.assertEqual((self.folder / "frames.txt").read_text(), self.sample("\n".join(lines) + "\n").stdout)

    def test_numbers_have_the_digits_that_read_back_as_the_same_bits(self):
        for word in self.sample("0.3 0.4 0.5\n").stdout.splitlines()[1].split():
            self.assertEqual(f"{float(word):.17g}", word)

    def test_counts_and_lists_points_outside(self):
        result = self.sample("5 0 0\n1 0.5 0.5\n0 -9 0.1\n", "--outside", "outside.txt")
        self.assert_succeeds(result)
        self.assertEqual(len(result.stdout.splitlines()), 1 + 3)
        self.assertIn("2 of 3 points are outside", result.stderr)
        self.assertIn("1 of 1 point is outside", self.sample("9 9 9\n").stderr)
        self.assertEqual(np.loadtxt(self.folder / "outside.txt").tolist(), [[5, 0, 0], [0, -9, 0.1]])

    def test_a_file_has_what_standard_output_has(self):
        points = self.write("points.txt", "0.3 0.4 0.5\r\n1.1 0.2 0.3\r\n")
        shown = self.run_here("sample", "box", points).stdout
        self.assert_succeeds(self.run_here("sample", "box", points, "-o", "frames.txt"))
        self.assertEqual((self.folder / "frames.txt").read_text(), shown)

    def test_files_that_would_be_overwritten_are_refused(self):
        self.write("points.txt", "0.3 0.4 0.5\n")
        for files in (["-o", "points.txt"], ["--outside", "./points.txt"], ["-o", "same.txt", "--outside", "same.txt"]):
            self.assert_fails(self.run_here("sample", "box", "points.txt", *files), USAGE)
        self.assertEqual((self.folder / "points.txt").read_text(), "0.3 0.4 0.5\n")

    def test_a_wrong_line_is_named(self):
        for text, line in [("0 0 0\n1 2\n", 2), ("0 0 0 0\n", 1), ("# x\n\n0 0 x\n", 3), ("nan 0 0\n", 1)]:
            with self.subTest(text=text):
                self.write("points.txt", text)
                result = self.run_here("sample", "box", "points.txt", "-o", "frames.txt", "--outside", "o.txt")
                self.assert_fails(result, INPUT, f"points.txt: line {line}:")
                self.assertEqual(self.names(), ["box", "box.stl", "points.txt"])

    def test_files_that_are_missing_or_wrong(self):
        self.assert_fails(self.run_here("sample", "none", "-", stdin=b"0 0 0\n"), INPUT, "none")
        self.assert_fails(self.run_here("sample", "box", "none.txt"), INPUT, "none.txt")
        self.assert_fails(self.sample(""), INPUT, "standard input")
        self.assert_fails(self.sample("0 0 0\n", "-o", "none/frames.txt"), OUTPUT, "none/frames.txt")
        (self.folder / "box" / "field.vtu").write_bytes(b"<VTKFile>")
        self.assert_fails(self.sample("0 0 0\n"), INPUT, "field.vtu")


class Spectrum(CommandTest):
    def spectrum(self, *arguments, **options):
        result = self.run_here("spectrum", "--json", *arguments, **options)
        self.assert_succeeds(result)
        return json.loads(result.stdout)

    def test_has_the_documented_keys(self):
        keys = ["degree", "matrix", "eigenvalues", "null_space", "linear", "constant"]
        self.assertEqual(list(self.spectrum("--preset", "cube")), keys)

    def test_of_presets_is_what_the_design_says(self):
        expected = {
            ("3", "plane"): [0, 0, 1, 1, 1, 1, 1],
            ("3", "cube"): [0, 2, 2, 2, 3, 3, 3],
            ("3", "cylinder"): np.array([8, 8, 11, 11, 13, 13, 16]) / 16,
            ("3", "sphere"): [5 / 7] * 7,
            ("4", "cube"): [1.75, 2, 2, 2, 2.125, 2.125, 3, 3, 3],
        }
        for (degree, preset), eigenvalues in expected.items():
            with self.subTest(degree=degree, preset=preset):
                report = self.spectrum("--degree", degree, "--preset", preset)
                np.testing.assert_allclose(report["eigenvalues"], eigenvalues, atol=1e-12)
                np.testing.assert_allclose(np.linalg.eigvalsh(report["matrix"]), eigenvalues, atol=1e-12)

    def test_of_a_file_takes_weights_and_lengths_of_normals_do_not_count(self):
        self.write("normals.txt", "# three planes\n1 0 0\n0 2 0 1\n0 0 -0.5 1.0\n")
        of_file, of_preset = self.spectrum("normals.txt"), self.spectrum("--preset", "cube")
        for key in ("matrix", "linear", "constant"):
            np.testing.assert_allclose(of_file[key], of_preset[key], atol=1e-13)
        doubled = self.spectrum("-", stdin=b"1 0 0 2\n0 1 0 2\n0 0 1 2\n")
        np.testing.assert_allclose(doubled["matrix"], 2 * np.array(of_preset["matrix"]), atol=1e-13)

    def test_as_text_holds_the_same_numbers(self):
        text = run("spectrum", "--degree", "3", "--preset", "cylinder").stdout
        lines = text.splitlines()
        self.assertEqual(len(lines), 1 + 7 + 1 + 1 + 1 + 2)
        np.testing.assert_allclose([float(word) for word in lines[9].split()],
                                   np.array([8, 8, 11, 11, 13, 13, 16]) / 16, atol=1e-11)

    def test_a_wrong_line_is_named(self):
        for text in ("1 0\n", "0 0 0\n", "1 0 0 0\n", "1 0 0 -1\n", "1 0 0 1 1\n", "1 0 x\n"):
            with self.subTest(text=text):
                self.write("normals.txt", "1 1 1\n" + text)
                self.assert_fails(self.run_here("spectrum", "normals.txt"), INPUT, "normals.txt: line 2:")


if __name__ == "__main__":
    unittest.main()
