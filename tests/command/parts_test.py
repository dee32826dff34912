#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Whole runs on real parts: those that ship with the project, and the surfaces of a collection kept beside it.

The collection is the folder that CROSSGRAIN_SHARED names, ../shared beside the project by default; its tests are skipped
where it is absent.
"""

import json
import os
import struct
import unittest
from pathlib import Path

import numpy as np

from program import CommandTest, by_night, of_the_day

PROJECT = Path(__file__).resolve().parents[2]
COLLECTION = Path(os.environ.get("CROSSGRAIN_SHARED", PROJECT.parent / "shared")) / "models" / "good"
SURFACES = ["1002_tray_bottom.STL", "featuretype.ply", "platonic_shelf.obj", "round.stl", "spot.ply", "torus.obj"]
THIN_WALLED = ["1002_tray_bottom.STL", "round.stl"]
THICK = ["torus.obj"]
# By day these stand for all: a thin wall, a thick one, and flat faces.
CHOSEN = ["round.stl", "torus.obj", "platonic_shelf.obj"]
FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def read_facets(path):
    return np.frombuffer(path.read_bytes(), FACET, offset=84)


def random_rotation(seed):
    w, x, y, z = (lambda q: q / np.linalg.norm(q))(np.random.default_rng(seed).normal(size=4))
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


class PartTest(CommandTest):
    def solve(self, model, *arguments, output="out"):
        result = self.run_here("solve", model, "-o", output, "--quiet", "--no-report", *arguments)
        self.assert_succeeds(result)
        return json.loads((self.folder / output / "report.json").read_text())


class ShippedParts(PartTest):
    def test_every_part_follows_its_surface(self):
        for part in sorted((PROJECT / "models").glob("*.stl")):
            with self.subTest(part.name):
                report = self.solve(part, "--resolution", "48")
                self.assertTrue(report["model"]["watertight"])
                self.assertLess(report["alignment_deg"]["mean"], 1)

    @by_night
    def test_a_further_cell_of_the_bracket_takes_less_than_220_bytes(self):
        cells, memory = [], []
        for resolution in (128, 256):
            report = self.solve(PROJECT / "models" / "bracket.stl", "--resolution", resolution)
            cells.append(report["levels"][-1]["active_cells"])
            memory.append(report["peak_memory_bytes"])
        self.assertLess(memory[1] - memory[0], 220 * (cells[1] - cells[0]))

    def test_the_turned_bracket_has_the_energy_of_the_upright_one(self):
        facets = read_facets(PROJECT / "models" / "bracket.stl")
        extent = float(np.ptp(facets["corners"].reshape(-1, 3), axis=0).max())
        for cells in of_the_day((60, 63, 64), 63):
            energies = []
            for seed in of_the_day((None, 1, 2), None, 1):
                turned = facets.copy()
                if seed is not None:
                    turned["corners"] = facets["corners"] @ random_rotation(seed).T
                self.write("turned.stl", bytes(80) + struct.pack("<I", len(turned)) + turned.tobytes())
                energies.append(self.solve("turned.stl", "--cell-size", extent / cells)["energy"]["total"])
            for energy in energies[1:]:
                with self.subTest(cells=cells):
                    self.assertLess(abs(energy / energies[0] - 1), 0.06)


@unittest.skipUnless(COLLECTION.is_dir(), f"no collection of models at {COLLECTION}")
class CollectedSurfaces(PartTest):
    def test_every_surface_is_followed_within_3_degrees_and_thin_walls_are_told_of(self):
        for name in of_the_day(SURFACES, *CHOSEN):
            with self.subTest(name):
                report = self.solve(COLLECTION / name, "--resolution", "64")
                alignment = report["alignment_deg"]
                self.assertLess(alignment["mean"], 3)
                self.assertLess(alignment["excluded_share"], 0.25)
                if name in THIN_WALLED + THICK:
                    kinds = [warning["kind"] for warning in report["warnings"]]
                    self.assertEqual("thin_walls" in kinds, name in THIN_WALLED, report["warnings"])

    def test_one_thread_and_two_give_the_same_bytes(self):
        for name in of_the_day(SURFACES, *CHOSEN):
            with self.subTest(name):
                fields = []
                for threads in (1, 2):
                    self.solve(COLLECTION / name, "--resolution", "48", "--threads", threads, output="out")
                    fields.append((self.folder / "out" / "field.vtu").read_bytes())
                self.assertEqual(fields[0], fields[1])


if __name__ == "__main__":
    unittest.main()
