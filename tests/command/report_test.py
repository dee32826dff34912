#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""report.json: its keys, and that its numbers are what the model and field.vtu say."""

import json
import resource
import time
import unittest

import numpy as np
from program import CommandTest, box_triangles, by_night, cylinder_triangles, stl_bytes, tilt, torus_triangles
from recompute_report import IN_NO_WAY, disagreements

KEYS = {
    "": ["schema", "program", "solve", "verdict", "answer", "reasons", "model", "degree", "resolution", "levels", "energy", "alignment_deg", "spectrum", "singularity",
         "seconds", "peak_memory_bytes", "version", "faces", "input", "creases", "walls", "coarser", "files", "warnings",
         "checksum"],
    "model": ["path", "triangles", "bounding_box", "watertight", "components"],
    "input": ["triangles_solved", "closed", "findings"],
    "energy": ["smoothness", "boundary", "unavoidable", "total", "deviation_max"],
    "alignment_deg": ["mean", "p95", "max", "excluded_share"],
    "spectrum": ["plane", "axis", "frame", "free", "conflicted"],
    "singularity": ["edges", "length", "arcs", "nodes", "boundary_ends", "unresolved_loops", "unresolved_stubs", "crease_hooks", "short_arcs", "contacts",
                    "verdict", "not_meshable_arcs", "not_meshable_nodes", "undecided_nodes", "arc_list", "node_list", "crease_list",
                    "corner_list"],
    "seconds": ["read", "grid", "solve", "write", "total"],
}


class Report(CommandTest):
    def solve(self, triangles, *arguments):
        """The report of a model, and the seconds that the program took."""
        self.write("part.stl", stl_bytes(triangles))
        start = time.monotonic()
        self.assert_succeeds(self.run_here("solve", self.folder / "part.stl", "-o", "out", "--no-report", *arguments))
        elapsed = time.monotonic() - start
        return json.loads((self.folder / "out" / "report.json").read_text()), elapsed

    def assert_recomputable(self, triangles, *arguments):
        self.solve(triangles, *arguments)
        self.assertEqual(disagreements(self.folder / "part.stl", self.folder / "out"), [])

    def test_every_number_of_a_cylinder_is_recomputed(self):
        self.assert_recomputable(cylinder_triangles(), "--resolution", "8")

    def test_every_number_of_a_torus_is_recomputed(self):
        self.assert_recomputable(torus_triangles(), "--resolution", "9")

    @by_night
    def test_every_number_of_a_bumpy_torus_is_recomputed(self):
        triangles = torus_triangles(around=36, across=18)
        points, corner = np.unique(triangles.reshape(-1, 3).round(9), axis=0, return_inverse=True)
        points += np.random.default_rng(5).uniform(-0.02, 0.02, points.shape)
        self.assert_recomputable(points[corner.ravel()].reshape(-1, 3, 3), "--resolution", "10")
        # Of 226 edges sharper than 35 degrees, seven are parts of curves that lead from one to another.
        self.assertEqual(json.loads((self.folder / "out" / "report.json").read_text())["creases"]["curves"], 5)

    def test_every_number_of_a_surface_inside_out_is_recomputed(self):
        self.assert_recomputable(torus_triangles()[:, ::-1], "--resolution", "8")

    def test_every_number_of_degree_3_is_recomputed(self):
        self.assert_recomputable(cylinder_triangles(), "--resolution", "7", "--degree", "3")

    def test_every_number_of_a_thin_wall_is_recomputed(self):
        self.assert_recomputable(box_triangles((2, 1.5, 0.12)) @ tilt(), "--resolution", "10")

    def test_every_number_of_a_flat_pyramid_is_recomputed(self):
        rim = 2 * np.pi * np.arange(5) / 5
        base = np.column_stack([np.cos(rim), np.sin(rim), np.zeros(5)])
        apex, foot = np.array([0.1, 0, 0.7]), np.zeros(3)
        sides = zip(base, np.roll(base, -1, axis=0))
        triangles = np.array([t for a, b in sides for t in ((a, b, apex), (b, a, foot))]) @ tilt()
        self.assert_recomputable(triangles, "--resolution", "9")
        creases = json.loads((self.folder / "out" / "report.json").read_text())["creases"]
        self.assertEqual((creases["crowded_corners"], creases["knife_edges"]), (1, 5))
        np.testing.assert_allclose(creases["crowded_corner_places"], [apex @ tilt()], atol=1e-6)

    def test_a_number_that_is_off_by_a_little_is_found(self):
        report, _ = self.solve(torus_triangles(), "--resolution", "8")
        changed = []
        for section in ("energy", "alignment_deg", "spectrum", "singularity", "walls"):
            for key, value in report[section].items():
                if key in IN_NO_WAY and section == "singularity":
                    continue
                if isinstance(value, str):
                    report[section][key] = "meshable" if value == "undecided" else "undecided"
                    changed.append(f"{section}.{key}")
                    continue
                if isinstance(value, list):
                    for item in value[:1]:
                        item["place"][0] += 1
                        changed.append(f"{section}.{key}[0].place")
                    continue
                if isinstance(value, bool):
                    report[section][key] = not value
                else:
                    report[section][key] = value + 1 if isinstance(value, int) else 1.01 * value + 1e-9
                changed.append(f"{section}.{key}")
        (self.folder / "out" / "report.json").write_text(json.dumps(report))
        found = {line.split(":")[0] for line in disagreements(self.folder / "part.stl", self.folder / "out")}
        self.assertEqual([name for name in changed if name not in found], [])

    def test_has_the_keys_of_the_design_in_their_order(self):
        report, _ = self.solve(box_triangles(), "--resolution", "8")
        for section, keys in KEYS.items():
            self.assertEqual(list(report[section] if section else report), keys)
        for level in report["levels"]:
            self.assertEqual(list(level), ["depth", "cells", "active_cells", "sweeps", "energy", "seconds"])
            self.assertGreater(level["sweeps"], 0)
        self.assertEqual(report["schema"], 4)

    def test_times_and_memory_are_possible(self):
        report, elapsed = self.solve(torus_triangles(), "--resolution", "24")
        seconds = report["seconds"]
        parts = sum(value for name, value in seconds.items() if name != "total")
        self.assertGreater(min(seconds.values()), 0)
        self.assertLessEqual(parts, seconds["total"])
        self.assertLessEqual(seconds["total"], elapsed)
        self.assertLessEqual(sum(level["seconds"] for level in report["levels"]), seconds["total"])
        self.assertGreater(report["peak_memory_bytes"], 1 << 20)
        # The system counts the largest of all finished children in KiB.
        largest = 1024 * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        self.assertLessEqual(report["peak_memory_bytes"], largest)


if __name__ == "__main__":
    unittest.main()
