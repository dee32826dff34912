#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain solve --constraints` as its users see it."""

import json
import unittest

import numpy as np
from program import CommandTest, box_triangles, medit_text, stl_bytes, tet_box

INPUT, USAGE, LIMIT = 3, 2, 5


def nearest_axis_deg(frame, axis):
    cosines = np.abs(np.asarray(frame).reshape(3, 3) @ (np.asarray(axis) / np.linalg.norm(axis)))
    return np.degrees(np.arccos(min(1.0, cosines.max())))


class Constraints(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("box.stl", stl_bytes(box_triangles()))

    def constrain(self, **lists):
        self.write("c.json", json.dumps({"schema": 1, **lists}))

    def report(self, folder="box.frames"):
        return json.loads((self.folder / folder / "report.json").read_text())

    def solve(self, *arguments):
        return self.run_here("solve", "box.stl", "--resolution", 24, "--constraints", "c.json", *arguments)

    def sampled(self, points):
        self.write("points.txt", "".join(" ".join(repr(float(x)) for x in p) + "\n" for p in points))
        result = self.run_here("sample", "box.frames", "points.txt")
        self.assert_succeeds(result)
        return np.loadtxt(result.stdout.splitlines(), ndmin=2).tolist()

    def test_a_twist_that_fades_slowly_is_written_with_the_exit_code_of_a_limit(self):
        self.write("plate.stl", stl_bytes(box_triangles((1, 1, 0.02))))
        across = np.radians(40)
        self.constrain(points=[{"at": [0.5, 0.5, 0.01], "weight": 1000, "frame": [
            [np.cos(across), np.sin(across), 0], [-np.sin(across), np.cos(across), 0], [0, 0, 1]]}])
        result = self.run_here("solve", "plate.stl", "--resolution", 100, "--constraints", "c.json", "--quiet")
        self.assert_fails(result, LIMIT, "plate.stl: the energy had not settled when the sweeps ran out", "--from")
        kinds = [warning["kind"] for warning in self.report("plate.frames")["warnings"]]
        self.assertIn("not_settled", kinds)
        self.assert_succeeds(self.run_here("check", "plate.frames"))

    def test_turn_the_field_and_report_what_sampling_finds(self):
        places, axis = [[0.6, 0.5, 0.7], [1.5, 0.4, 0.6]], [1, 1, 0]
        self.constrain(points=[{"at": places, "axis": axis}])
        result = self.solve()
        self.assert_succeeds(result)
        self.assertIn("points ", result.stdout)
        angles = [nearest_axis_deg(frame, axis) for frame in self.sampled(places)]
        self.assertLess(max(angles), 2)
        points = self.report()["constraints"]["points"]
        self.assertEqual((points["count"], points["outside"]), (2, 0))
        self.assertAlmostEqual(points["angle_deg"]["mean"], np.mean(angles), places=4)
        self.assertAlmostEqual(points["angle_deg"]["max"], max(angles), places=4)

    def test_stresses_and_polylines_are_reported_as_sampling_finds_them(self):
        stress = [[3.0, 1.0, 0.0, 0.0, 0.0, 0.8]]
        places = [[1.0, 0.5, 0.75]]
        ends = np.array([[0.3, 0.3, 0.4], [0.8, 0.7, 0.9]])
        self.constrain(stresses=[{"at": places, "stress": stress}],
                       polylines=[{"points": ends.tolist(), "axis": "tangent", "weight": 2}])
        self.assert_succeeds(self.solve())
        xx, yy, zz, yz, xz, xy = stress[0]
        values, vectors = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        gaps = np.array([values[1] - values[0], min(values[1] - values[0], values[2] - values[1]),
                         values[2] - values[1]]) / (max(values[2], 0) - min(values[0], 0))
        frame = self.sampled(places)[0]
        angles = [nearest_axis_deg(frame, vectors[:, k]) for k in range(3) if gaps[k] >= 0.1]
        constraints = self.report()["constraints"]
        self.assertAlmostEqual(constraints["stresses"]["angle_deg"]["mean"], np.mean(angles), places=4)
        length = np.linalg.norm(ends[1] - ends[0])
        self.assertAlmostEqual(constraints["polylines"]["length"], length, places=9)
        parts = int(np.ceil(length / (2.0 / 24)))
        middles = [ends[0] + (k + 0.5) / parts * (ends[1] - ends[0]) for k in range(parts)]
        angles = [nearest_axis_deg(frame, ends[1] - ends[0]) for frame in self.sampled(middles)]
        self.assertAlmostEqual(constraints["polylines"]["angle_deg"]["mean"], np.mean(angles), places=4)
        self.assertAlmostEqual(constraints["polylines"]["angle_deg"]["max"], max(angles), places=4)

    def test_the_result_does_not_depend_on_the_number_of_threads(self):
        self.constrain(points=[{"at": [1, 0.5, 0.7], "frame": [[1, 1, 0], [1, -1, 0], [0, 0, 1]]}],
                       polylines=[{"points": [[0.2, 0.2, 0.2], [1.8, 0.8, 1.3]], "axis": "tangent"}])
        files = []
        for threads in (1, 2):
            self.assert_succeeds(self.solve("--threads", threads))
            files.append((self.folder / "box.frames" / "field.vtu").read_bytes())
        self.assertTrue(files[0] == files[1])

    def test_what_is_outside_is_warned_of_even_where_nothing_else_is_said(self):
        self.constrain(points=[{"at": [[1, 0.5, 0.7], [1, 0.5, 70]], "axis": [1, 1, 1]}])
        result = self.solve("--quiet")
        self.assert_succeeds(result)
        self.assertEqual(result.stdout, "")
        self.assertEqual(result.stderr.count("\n"), 1)
        self.assertIn("c.json: constraints outside the solid: 1 of 2 points, the first at 1 0.5 70", result.stderr)
        self.assertEqual(self.report()["constraints"]["points"]["outside"], 1)
        found = [warning for warning in self.report()["warnings"] if warning["kind"] == "constraints_outside"]
        self.assertEqual([(warning["file"], "outside the solid" in warning["text"]) for warning in found], [("c.json", True)])

    def test_faults_name_the_line_and_leave_nothing(self):
        self.write("c.json", '{\n"schema": 1,\n"points": [\n{"at": [0, 0, 0], "axis": [1, 0, 0], "weight": -1}]}')
        self.assert_fails(self.solve(), INPUT, "c.json: line 4: ", "weight", "positive")
        self.write("c.json", '{\n"schema": 1,\n]')
        self.assert_fails(self.solve(), INPUT, "c.json: line 3: ", "not JSON")
        self.constrain(faces=[{"face": 3, "axis": "normal"}])
        self.assert_fails(self.solve(), INPUT, "crossgrain: c.json: line 1: ", "no numbered faces")
        self.constrain(points=[{"at": [1000, 500, 700], "axis": [1, 0, 0]}])
        self.assert_fails(self.solve(), INPUT, "crossgrain: c.json: ", "same unit")
        self.assert_fails(self.run_here("solve", "box.stl", "--constraints", "none.json"), INPUT, "none.json")
        self.assert_fails(self.run_here("solve", "box.stl", "--constraints", ""), USAGE, "--constraints")
        self.assertEqual(self.names(), ["box.stl", "c.json"])

    def test_act_on_tets_and_know_the_tags_of_their_boundary(self):
        vertices, tets = tet_box((8, 4, 6))
        text = medit_text(vertices, tets)
        top = np.flatnonzero(vertices[:, 2] == vertices[:, 2].max())
        corners = set(top.tolist())
        faces = sorted({tuple(sorted(int(v) for v in tet if v in corners)) for tet in tets})
        faces = [face for face in faces if len(face) == 3]
        tagged = "\n".join(["Triangles", str(len(faces)), *(f"{a + 1} {b + 1} {c + 1} 5" for a, b, c in faces), "End", ""])
        self.write("box.mesh", text.replace("End\n", tagged))
        self.constrain(points=[{"at": [1, 0.5, 0.75], "frame": [[1, 1, 0], [1, -1, 0], [0, 0, 1]]}],
                       faces=[{"face": 5, "axis": [3, 1, 0], "weight": 0.5}])
        self.assert_succeeds(self.run_here("solve", "box.mesh", "--constraints", "c.json"))
        report = self.report()["constraints"]
        self.assertEqual(report["faces"]["count"], 1)
        self.assertAlmostEqual(report["faces"]["area"], 2.0, places=4)
        middle = np.flatnonzero(np.linalg.norm(vertices - [1, 0.5, 0.75], axis=1) < 1e-9)[0]
        frames = np.loadtxt(self.folder / "box.frames" / "onto.frames")
        self.assertLess(nearest_axis_deg(frames[middle], [1, 1, 0]), 3)
        self.constrain(faces=[{"face": 6, "axis": "normal"}])
        self.assert_fails(self.run_here("solve", "box.mesh", "--constraints", "c.json"), INPUT, "c.json: line 1: ",
                          "has no face 6, only 0 and 5")


if __name__ == "__main__":
    unittest.main()
