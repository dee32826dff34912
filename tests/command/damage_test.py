#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Damaged surfaces: the field follows that of the sound part, each fault is told with its place, and where there is no
inside that is said."""

import json
import os
import re
import unittest
from pathlib import Path

import numpy as np
from damage import anywhere, flipped, moebius_band, sheet, subdivided
from program import CommandTest, box_triangles, cylinder_triangles, run, sphere_triangles, stl_bytes

INPUT = 3
BAD = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared")) / "models" / "bad"

# File: exit code, and words of the error, or the kinds and numbers of what is found.
OUTCOMES = {
    "angle_block.STL": (0, {"cracks": 166}),
    "capsule.obj": (0, {"degenerate triangles": 200}),
    "cube-hex.msh": (INPUT, ["hexahedra"]),
    "empty.ply": (INPUT, ["empty"]),
    "fan3.obj": (INPUT, ["encloses nothing", "3 triangles"]),
    "invalid.off": (INPUT, ["vertex 20"]),
    "joined_tetrahedra.obj": (0, {"internal sheets": 1}),
    "malformed.obj": (INPUT, ["vertex 12"]),
    "moebius.obj": (INPUT, ["encloses nothing", "one-sided", "448"]),
    "not_convex.obj": (0, {"non-manifold edges": 12, "stray facets": 4}),
    "obj_points.obj": (INPUT, ["no triangles"]),
    "p01.mesh": (0, {}),
    "soup.stl": (INPUT, ["encloses nothing", "soup of 100 triangles"]),
    "stl_empty_bin.stl": (INPUT, ["no triangles"]),
    "two_spheres.obj": (0, {"overlapping components": 1}),
    "wallhole.obj": (0, {}),
    "whitespace.off": (0, {}),
}


class BadFiles(CommandTest):
    @unittest.skipUnless(BAD.is_dir(), f"{BAD} is not there")
    def test_each_gives_a_field_or_one_line(self):
        for name, (code, expected) in OUTCOMES.items():
            with self.subTest(name=name):
                folder = self.folder / f"{name}.frames"
                result = run("solve", BAD / name, "-o", folder, "--resolution", 24, "--no-report")
                if code != 0:
                    self.assert_fails(result, code, name, *expected)
                    continue
                self.assert_succeeds(result)
                found = json.loads((folder / "report.json").read_text())["input"]["findings"]
                self.assertEqual({finding["kind"]: finding["count"] for finding in found}, expected)
                lists = ["2568 regions for 2568 tets"] if name == "p01.mesh" else []
                self.assertEqual(len(result.stderr.splitlines()), len(found) + len(lists))
                for words in lists:
                    self.assertIn(words, result.stderr)

    @unittest.skipUnless(BAD.is_dir(), f"{BAD} is not there")
    def test_no_file_is_forgotten(self):
        self.assertEqual({path.name for path in BAD.iterdir()} - {"MANIFEST.tsv"}, set(OUTCOMES))


class Damage(CommandTest):
    """Every damaged part lies turned at random, with a size of its own."""

    @classmethod
    def setUpClass(cls):
        centre = np.array([1.0, 0.5, 0.75])
        cls.box = subdivided(box_triangles() - centre, 2)
        cls.cylinder = subdivided(cylinder_triangles(segments=24))
        cls.ball = sphere_triangles(16, 32)

    def setUp(self):
        super().setUp()
        self.random = np.random.default_rng(len(self.id()))
        self.put, self.size = anywhere(self.random)

    def solve(self, triangles, name):
        self.write(name + ".stl", stl_bytes(self.put(triangles)))
        result = self.run_here("solve", name + ".stl", "-o", name, "--resolution", "16", "--no-report")
        self.assert_succeeds(result)
        report = json.loads((self.folder / name / "report.json").read_text())
        findings = report["input"]["findings"]
        # One line each, with the number and the place.
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), len(findings))
        for line, finding in zip(lines, findings):
            self.assertIn(f"{name}.stl: {finding['kind']}: ", line)
            self.assertIn(str(finding["count"]), line)
            said = np.array(re.search(r"\bat (\S+) (\S+) ([^\s;]+)", line).groups(), float)
            np.testing.assert_allclose(said, finding["place"], rtol=0, atol=1e-4 * np.abs(finding["place"]).max())
            self.assertTrue(line.endswith("; " + finding["done_text"]), line)
        found = [warning["text"] for warning in report["warnings"] if warning["kind"] == "surface_finding"]
        self.assertEqual([line.split(f"{name}.stl: ", 1)[1] for line in lines], found)
        return report

    def assert_follows(self, damaged, sound, expected, active_cells=0, energy=1e-6):
        """The findings, and cells and energy like those of the sound part up to these shares of them. `expected` has
        numbers of kinds; None stands for any number."""
        report, clean = self.solve(damaged, "damaged"), self.solve(sound, "sound")
        found = {finding["kind"]: finding["count"] for finding in report["input"]["findings"]}
        self.assertEqual(set(found), set(expected), found)
        for kind, count in expected.items():
            if count is not None:
                self.assertEqual(found[kind], count, kind)
        cells, clean_cells = (r["levels"][-1]["active_cells"] for r in (report, clean))
        self.assertLessEqual(abs(cells - clean_cells), active_cells * clean_cells)
        total, clean_total = (r["energy"]["total"] for r in (report, clean))
        self.assertLessEqual(abs(total - clean_total), energy * (clean_total + self.size))
        return report

    def assert_refused(self, triangles, *words):
        self.write("none.stl", stl_bytes(self.put(triangles)))
        self.assert_fails(self.run_here("solve", "none.stl"), INPUT, "none.stl", "encloses nothing", *words)
        self.assertEqual(self.names(), ["none.stl"])

    def test_a_sound_part_has_no_findings(self):
        report = self.solve(self.cylinder, "sound")
        self.assertEqual(report["input"], {"triangles_solved": len(self.cylinder), "closed": True, "findings": []})

    def test_facets_flipped(self):
        for sound in (self.box, self.cylinder):
            damaged, count = flipped(sound, 0.1, self.random)
            report = self.assert_follows(damaged, sound, {"flipped facets": count})
            self.assertTrue(report["input"]["closed"])
            self.assertFalse(report["model"]["watertight"])

    def test_a_void_stays_a_void_with_facets_flipped(self):
        sound = np.concatenate([self.ball, 0.5 * self.ball[:, ::-1]])
        damaged, count = flipped(sound, 0.1, self.random)
        self.assert_follows(damaged, sound, {"flipped facets": count})

    def test_holes(self):
        self.assert_follows(np.delete(self.box, [3, 77, 150], axis=0), self.box, {"holes": 3}, 0.01, 0.05)
        self.assert_follows(np.delete(self.cylinder, [7, 200], axis=0), self.cylinder, {"holes": 2}, 0.01, 0.05)

    def test_soup_with_equal_corners_is_no_soup(self):
        # An STL file is one: each triangle has corners of its own.
        self.assert_follows(self.random.permutation(self.cylinder), self.cylinder, {}, 0, 1e-3)

    def test_soup_with_corners_nearly_equal(self):
        jitter = 1e-5 * self.random.normal(size=self.cylinder.shape)
        for share in (0, 0.1):
            damaged, count = flipped(self.cylinder + jitter, share, self.random)
            kinds = {"triangle soup": len(damaged), "cracks": None, "self-intersections": None}
            self.assert_follows(damaged, self.cylinder, kinds | ({"flipped facets": count} if share else {}), 0.01, 0.05)

    def test_triangles_duplicated(self):
        twice = np.concatenate([self.cylinder, self.cylinder])
        self.assert_follows(twice, self.cylinder, {"duplicated triangles": len(self.cylinder)})
        some = np.concatenate([self.cylinder, self.cylinder[::5]])
        self.assert_follows(some, self.cylinder, {"duplicated triangles": len(self.cylinder[::5])})

    def test_degenerate_triangles(self):
        a, b, _ = np.moveaxis(self.box[::9], 1, 0)
        self.assert_follows(np.concatenate([self.box, np.stack([a, b, b], axis=1)]), self.box,
                            {"degenerate triangles": len(a)})

    def test_a_stray_fin(self):
        a, b, c = self.box[0]
        fin = np.array([[a, b, (a + b) / 2 + np.cross(b - a, c - a)]])
        self.assert_follows(np.concatenate([self.box, fin]), self.box, {"stray facets": 1, "non-manifold edges": 1})

    def test_open_sheets_beside_and_inside(self):
        for place in ([3, 0, 0], [0.1, 0.05, 0.02]):
            self.assert_follows(np.concatenate([self.box, sheet() + place]), self.box, {"open sheets": 1})

    def test_a_moebius_band_beside_a_box(self):
        self.assert_follows(np.concatenate([self.box, 0.4 * moebius_band() + [3, 0, 0]]), self.box, {"one-sided sheets": 1})

    def test_a_part_inside_out_beside_another(self):
        smaller = 0.8 * self.box + [3, 0, 0]
        self.assert_follows(np.concatenate([self.box, smaller[:, ::-1]]), np.concatenate([self.box, smaller]),
                            {"inside-out parts": 1})

    def test_two_balls_that_overlap_are_one_solid(self):
        shift = np.array([1.1, 0.2, 0.3])
        report = self.solve(np.concatenate([self.ball, self.ball + shift]), "both")
        self.assertEqual([finding["kind"] for finding in report["input"]["findings"]], ["overlapping components"])
        self.assertTrue(report["input"]["closed"])
        # The centre of each lies in the solid, and so does the lens between them.
        points = self.put(np.array([[0, 0, 0], shift, shift / 2]))
        text = "\n".join(" ".join(map(repr, map(float, point))) for point in points)
        self.assertIn("0 of 3 ", run("sample", self.folder / "both", "-", stdin=text.encode()).stderr)

    def test_two_boxes_that_touch(self):
        self.put = lambda triangles: triangles
        report = self.solve(np.concatenate([self.box, self.box + [2, 0.25, 0.125]]), "both")
        self.assertEqual([(finding["kind"], finding["count"]) for finding in report["input"]["findings"]],
                         [("touching components", 1)])

    def test_random_triangles_are_refused_whatever_their_number(self):
        for count in (1000, 4000):
            with self.subTest(count=count):
                self.assert_refused(np.random.default_rng(7).random((count, 3, 3)), f"soup of {count} triangles")

    def test_what_has_no_inside_is_refused(self):
        self.assert_refused(sheet(), "open sheet of 128 triangles")
        self.assert_refused(moebius_band(), "one-sided", "80 triangles")
        self.assert_refused(self.random.normal(size=(200, 1, 3)) + 0.3 * self.random.normal(size=(200, 3, 3)),
                            "soup of 200 triangles")
        self.assert_refused(self.ball[self.ball.mean(axis=1)[:, 2] > 0.75], "open sheet")


if __name__ == "__main__":
    unittest.main()
