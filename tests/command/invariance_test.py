# SPDX-License-Identifier: Apache-2.0
"""A solve of a real model has the same lines and energy however its triangles are listed and however large it is. Quarter turns are tested
on made models (tests/solve/invariance_test.cpp): coarse cells in thin walls have other lines then.

The surfaces in models/, and those of CROSSGRAIN_SHARED, ../shared beside the project by default, where they are there.
"""

import json
import os
import unittest
from pathlib import Path

import numpy as np

from program import CommandTest, of_the_day

PROJECT = Path(__file__).resolve().parents[2]
SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", PROJECT.parent / "shared"))
MODELS = [PROJECT / "models" / "bracket.stl", PROJECT / "models" / "housing.stl", SHARED / "models" / "good" / "1002_tray_bottom.STL",
          SHARED / "models" / "good" / "round.stl"]

# Relative difference of energies that are sums in another order.
ROUNDING = 1e-6


def corners_of(path):
    """The triangles of an STL file as an array (n, 3, 3)."""
    data = path.read_bytes()
    if data[:5] == b"solid" and b"facet" in data[:1000]:
        words = [line.split() for line in data.decode().splitlines()]
        return np.array([line[1:] for line in words if line[:1] == ["vertex"]], dtype=np.float32).reshape(-1, 3, 3)
    rows = np.frombuffer(data, np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("mark", "<u2")]), offset=84)
    return rows["corners"].copy()


def stl_of(corners):
    rows = np.zeros(len(corners), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("mark", "<u2")]))
    rows["corners"] = corners
    return bytes(80) + np.uint32(len(rows)).tobytes() + rows.tobytes()


class InvarianceTest(CommandTest):
    def solved(self, corners):
        self.write("model.stl", stl_of(corners))
        self.assert_succeeds(self.run_here("solve", "model.stl", "--resolution", "40", "-o", "out", "--no-report", "--quiet"))
        report = json.loads((self.folder / "out" / "report.json").read_text())
        graph = report["singularity"]
        lines = sorted(arc["index"] for arc in graph["arc_list"])
        return lines, graph["nodes"], graph["boundary_ends"], report["energy"]["total"]

    def compare(self, tolerance, change):
        """`change` gives other triangles and the factor by which the energy grows."""
        compared = 0
        for path in of_the_day(MODELS, "bracket.stl", "round.stl"):
            if not path.exists():
                continue
            compared += 1
            with self.subTest(path.name):
                corners = corners_of(path)
                *graph, energy = self.solved(corners)
                changed, factor = change(corners)
                *other_graph, other_energy = self.solved(changed)
                self.assertEqual(other_graph, graph)
                self.assertLessEqual(abs(other_energy / (factor * energy) - 1), tolerance)
        self.assertGreaterEqual(compared, 1)

    def test_the_order_of_triangles_and_their_first_corner_do_not_matter(self):
        chance = np.random.default_rng(1)

        def shuffled(corners):
            corners = corners[chance.permutation(len(corners))]
            return np.array([np.roll(triangle, shift, axis=0) for triangle, shift in zip(corners, chance.integers(3, size=len(corners)))]), 1

        self.compare(ROUNDING, shuffled)

    def test_triangles_listed_twice_do_not_matter(self):
        self.compare(ROUNDING, lambda corners: (np.concatenate([corners, corners[::7]]), 1))

    def test_a_scale_by_a_power_of_two_does_not_matter(self):
        self.compare(0, lambda corners: (corners / 64, 1 / 64))


if __name__ == "__main__":
    unittest.main()
