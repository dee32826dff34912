#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What `crossgrain solve` does besides errors: files, streams, determinism."""

import json
import os
import unittest

from program import CommandTest, box_triangles, sphere_triangles, stl_bytes, torus_triangles


class Solve(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("torus.stl", stl_bytes(torus_triangles()))

    def report(self, name):
        return json.loads((self.folder / name / "report.json").read_text())

    def report_without_costs(self, folder):
        report = json.loads((self.folder / folder / "report.json").read_text())
        del report["seconds"], report["peak_memory_bytes"], report["checksum"]
        for level in report["levels"]:
            del level["seconds"]
        return report

    def test_writes_two_files_into_a_folder_named_after_the_model(self):
        result = self.run_here("solve", "torus.stl", "--resolution", "8")
        self.assert_succeeds(result)
        self.assertEqual(self.names(), ["torus.frames", "torus.stl"])
        self.assertEqual(sorted(os.listdir(self.folder / "torus.frames")), ["field.vtu", "report.html", "report.json", "singularities.vtu", "surface.vtu"])

    def test_the_summary_is_a_result_and_progress_is_not(self):
        result = self.run_here("solve", "torus.stl", "--resolution", "8", "--progress")
        self.assertIn("torus.frames", result.stdout)
        rows = [line.split()[0] for line in result.stdout.splitlines()]
        for row in ("answer", "singular", "alignment", "energy", "files", "time"):
            self.assertEqual(rows.count(row), 1, row)
        self.assertFalse({"cells", "surface", "repair"} & set(rows))
        self.assertIn("level", result.stderr)
        self.assertNotIn("\x1b", result.stderr)
        self.assertNotIn("level", result.stdout)
        result = self.run_here("solve", "torus.stl", "--resolution", "8")
        self.assertEqual(result.stderr, "")

    def test_quiet_says_nothing(self):
        result = self.run_here("solve", "torus.stl", "--resolution", "8", "--quiet", "--progress", "--no-report")
        self.assert_succeeds(result)
        self.assertEqual(result.stdout + result.stderr, "")
        self.assertTrue((self.folder / "torus.frames" / "report.json").is_file())

    def test_cells_get_larger_where_memory_does_not_last_and_that_is_said(self):
        self.assert_succeeds(self.run_here("solve", "torus.stl", "--resolution", "128", "-o", "whole", "--no-report"))
        whole = self.report("whole")
        self.assertNotIn("limited", whole)
        cells_before = whole["levels"][-2]["active_cells"]
        memory = int(0.8 * whole["peak_memory_bytes"])
        result = self.run_here("solve", "torus.stl", "--resolution", "128", "-o", "out", "--max-memory", memory, "--quiet", "--no-report")
        self.assert_succeeds(result)
        self.assertEqual(result.stdout, "")
        self.assertIn("warning: torus.stl: memory: 64 cells along the longest side in place of 128", result.stderr)
        self.assertIn("allow more memory with --max-memory", result.stderr)
        report = self.report("out")
        self.assertEqual(report["levels"][-1]["active_cells"], cells_before)
        self.assertAlmostEqual(report["resolution"], 64)
        self.assertAlmostEqual(report["limited"]["resolution_asked"], 128)
        self.assertEqual(report["limited"]["memory_bytes"], memory)
        warning = report["warnings"][0]
        self.assertEqual((warning["kind"], warning["remedy"], warning["advice"]), ("memory_limited", "allow_memory", "allow more memory"))
        self.assertLess(report["peak_memory_bytes"], memory)

    def test_memory_is_given_in_units_of_1000_or_1024_or_in_bytes(self):
        for text, size in (("32M", 32e6), ("32MiB", 32 * 2**20), ("0.032GB", 32e6), ("32000000", 32e6)):
            result = self.run_here("solve", "torus.stl", "--resolution", "512", "-o", "out", "--max-memory", text, "--no-report")
            self.assert_succeeds(result)
            self.assertEqual(self.report("out")["limited"]["memory_bytes"], size)

    def test_what_to_expect_of_a_large_solve_is_said_and_reported(self):
        result = self.run_here("solve", "torus.stl", "--resolution", "96", "-o", "out")
        self.assertIn("expected", result.stdout)
        report = self.report("out")
        expected = report["expected"]
        for said, actual in ((expected["active_cells"], report["levels"][-1]["active_cells"]),
                             (expected["peak_memory_bytes"], report["peak_memory_bytes"])):
            self.assertLess(said, 1.5 * actual)
            self.assertGreater(said, actual / 1.5)
        self.assertLess(expected["after_seconds"], report["seconds"]["total"])
        self.assertLess(expected["after_seconds"], expected["seconds"])
        self.assertAlmostEqual(expected["resolution"], 96)
        self.assertLess(expected["depth"], report["levels"][-1]["depth"])

    def field_bytes(self, model, *arguments):
        self.assert_succeeds(self.run_here("solve", model, "-o", "out", "--no-report", *arguments))
        return (self.folder / "out" / "field.vtu").read_bytes()

    def test_the_result_does_not_depend_on_the_number_of_threads(self):
        field = self.field_bytes("torus.stl", "--resolution", 20, "--threads", 1)
        report = self.report_without_costs("out")
        self.assertTrue(field == self.field_bytes("torus.stl", "--resolution", 20, "--threads", 2))
        self.assertEqual(report, self.report_without_costs("out"))

    def test_the_seed_counts(self):
        # Most solids have one field, which relaxation finds to the bit from any seed. A sphere has many.
        self.write("sphere.stl", stl_bytes(sphere_triangles()))
        first = self.field_bytes("sphere.stl", "--resolution", 24)
        self.assertTrue(first == self.field_bytes("sphere.stl", "--resolution", 24, "--seed", 0))
        self.assertTrue(any(first != self.field_bytes("sphere.stl", "--resolution", 24, "--seed", seed)
                            for seed in range(1, 5)))

    def test_starts_from_an_earlier_field(self):
        self.assert_succeeds(self.run_here("solve", "torus.stl", "--resolution", "16", "-o", "a"))
        self.assert_succeeds(self.run_here("solve", "torus.stl", "--resolution", "16", "--from", "a", "-o", "b"))
        first, second = (self.report_without_costs(name)["energy"]["total"] for name in "ab")
        # It may only improve, but for the energy that rounding takes.
        self.assertLessEqual(second, first * 1.001)

    def test_the_cell_size_is_in_model_units(self):
        self.write("box.stl", stl_bytes(box_triangles((2, 1, 1.5))))
        self.assert_succeeds(self.run_here("solve", "box.stl", "--cell-size", "0.25"))
        self.assertEqual(self.report_without_costs("box.frames")["resolution"], 8)

    def test_edges_above_the_crease_angle_are_creases(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        for angle, curves in ((None, 12), ("89", 12), ("91", 0), ("180", 0)):
            with self.subTest(angle=angle):
                option = ["--crease-angle", angle] if angle else []
                self.assert_succeeds(self.run_here("solve", "box.stl", "-o", "out", "--resolution", "8", *option))
                self.assertEqual(self.report("out")["creases"]["curves"], curves)


if __name__ == "__main__":
    unittest.main()
