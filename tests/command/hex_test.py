#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain hex`, judged from the files that it writes."""

import itertools
import json
import signal
import subprocess
import unittest

import numpy as np

from field_reader import read_arrays
from frame_math import CUBE_ROTATIONS
from program import PROGRAM, CommandTest, box_triangles, cylinder_triangles, medit_text, stl_bytes, tet_box, tilt

USAGE, INPUT, OUTPUT, NOT_ALL_HEX, APPROXIMATE, INTERRUPTED = 2, 3, 4, 6, 7, 130
FILES = [f"hexahedra.{ending}" for ending in ("inp", "mesh", "msh", "vtu")]

TIP, RIM = np.array([0, 0, 1.0]), np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], float)
OCTAHEDRON = np.array([*[(RIM[k], RIM[(k + 1) % 4], TIP) for k in range(4)], *[(RIM[(k + 1) % 4], RIM[k], -TIP) for k in range(4)]])

# Corners of a hexahedron with their three neighbours, right-handed.
NEIGHBOURS = ((1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3))


def star_triangles():
    """A prism over a star of five points."""
    rim = np.array([(np.cos(np.pi * k / 5), np.sin(np.pi * k / 5)) for k in range(10)]) * np.where(np.arange(10) % 2, 0.4, 1.0)[:, None]
    low, high = (np.column_stack([rim, np.full(10, z)]) for z in (0.0, 0.5))
    triangles = []
    for k in range(10):
        n = (k + 1) % 10
        triangles += [(low[k], low[n], high[n]), (low[k], high[n], high[k]), ((0, 0, 0), low[n], low[k]), ((0, 0, 0.5), high[k], high[n])]
    return np.array(triangles)


def medit_section(path, name, width):
    words = path.read_text().split()
    at = words.index(name)
    count = int(words[at + 1])
    return np.array(words[at + 2:at + 2 + count * width], dtype=float).reshape(count, width)


def scaled_jacobians(vertices, hexahedra):
    corners = vertices[hexahedra]
    least = np.full(len(hexahedra), np.inf)
    for k, neighbours in enumerate(NEIGHBOURS):
        edges = corners[:, neighbours] - corners[:, k:k + 1]
        edges /= np.linalg.norm(edges, axis=2, keepdims=True)
        least = np.minimum(least, np.linalg.det(edges))
    return least


def transitions(tets, coordinates):
    """For each inner face whether its translation is whole, and its vertices in the map of one tet, turned and moved to that of the other."""
    faces = {}
    for t, tet in enumerate(tets.tolist()):
        for opposite in range(4):
            corners = sorted((k for k in range(4) if k != opposite), key=lambda k, tet=tet: tet[k])
            faces.setdefault(tuple(tet[k] for k in corners), []).append(coordinates[t, corners])
    for sides in faces.values():
        if len(sides) == 2:
            before, after = sides
            turned = before @ np.swapaxes(CUBE_ROTATIONS, 1, 2)
            moved = turned + (after[0] - turned[:, :1])
            best = np.abs(moved - after).max(axis=(1, 2)).argmin()
            translation = after[0] - turned[best, 0]
            yield bool((translation == np.round(translation)).all()), moved[best], after


def grid_points_in(points, tets, grid):
    """Places of the points of the grid in all tets, each once."""
    found = []
    for corners, places in zip(grid, points[tets]):
        low, high = np.ceil(corners.min(axis=0)).astype(int), np.floor(corners.max(axis=0)).astype(int)
        matrix = (corners[1:] - corners[0]).T
        for point in itertools.product(*(range(a, b + 1) for a, b in zip(low, high))):
            weights = np.linalg.solve(matrix, point - corners[0])
            if weights.min() > -1e-9 and weights.sum() < 1 + 1e-9:
                found.append(places[0] + weights @ (places[1:] - places[0]))
    return {tuple(np.round(place, 6) + 0.0) for place in found}


class HexTest(CommandTest):
    def hexahedra(self, *arguments, code=0):
        """The section of the report about hexahedra, and the mesh."""
        self.result = self.run_here("hex", *arguments, "-o", "out", "--no-report")
        self.assertEqual(self.result.returncode, code, self.result.stderr)
        self.report = json.loads((self.folder / "out/report.json").read_text())
        mesh = self.folder / "out/hexahedra.mesh"
        if not mesh.exists():
            return self.report["hexahedra"]
        self.vertices = medit_section(mesh, "Vertices", 4)[:, :3]
        self.corners = medit_section(mesh, "Hexahedra", 9)[:, :8].astype(int) - 1
        return self.report["hexahedra"]

    def write_box(self):
        vertices, tets = tet_box()
        self.write("box.mesh", medit_text(vertices @ tilt(), tets))

    def test_a_box_of_tets_becomes_its_bricks(self):
        self.write_box()
        made = self.hexahedra("box.mesh", "--size", "0.25")
        self.assertEqual(made["outcome"], "all-hex")
        self.assertEqual(made["hexahedra"], 8 * 4 * 6)
        self.assertEqual(len(self.corners), 8 * 4 * 6)
        self.assertAlmostEqual(made["volume"], 3.0, places=6)
        rows = [line.split()[0] for line in self.result.stdout.splitlines()]
        self.assertEqual(rows, ["model", "expected", "hexahedra", "worst", "fit", "features", "way", "files", "time"])
        self.assertIn("hexahedra  all-hex: 192 hexahedra, mean edge 0.25\nworst      scaled Jacobian 1 at ", self.result.stdout)
        self.assertIn("fit        volume within 0.001 % and area within 0.001 % of the tets; ", self.result.stdout)
        self.assertEqual(sorted(set(FILES) & {path.name for path in (self.folder / "out").iterdir()}), FILES)

    def test_the_report_has_the_shapes_of_the_file(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        made = self.hexahedra("box.stl", "--cells", "5", "--tet-size", "0.35")
        quality = scaled_jacobians(self.vertices, self.corners)
        self.assertEqual(made["hexahedra"], len(quality))
        self.assertAlmostEqual(made["scaled_jacobian"]["min"], quality.min(), places=9)
        self.assertAlmostEqual(made["scaled_jacobian"]["mean"], quality.mean(), places=9)
        self.assertEqual(made["scaled_jacobian"]["inverted"], 0)

    def test_the_report_tells_the_attempts(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        made = self.hexahedra("box.stl", "--cells", "5", "--tet-size", "0.3")
        tets, repair = made["attempts"]
        self.assertEqual((tets["kind"], repair["kind"], made["best_attempt"]), ("tets", "repair", 1))
        self.assertAlmostEqual(tets["tet_size"], 0.3)
        self.assertEqual(tets["tets"], self.report["onto"]["tets"])
        self.assertEqual(repair["outcome"], "all-hex")
        self.assertEqual(self.report["seconds"]["read"], tets["tet_seconds"])
        self.assertIn(f"way        attempt 1 of 1: field on {self.report['onto']['tets']} tets of at most 0.3, repaired\n", self.result.stdout)
        self.assertRegex(self.result.stdout, r"expected .* tets of 0\.3 \(--tet-size\)\n")
        self.assert_succeeds(self.run_here("check", "out"))

    def test_an_octahedron_is_filled_though_four_faces_meet_in_its_corners(self):
        self.write("octahedron.stl", stl_bytes(OCTAHEDRON))
        made = self.hexahedra("octahedron.stl", "--cells", "9", "--tet-size", "0.4")
        self.assertEqual((made["features"]["creases"], made["features"]["corners"]), ({"all": 12, "kept": 12}, {"all": 6, "kept": 6}))
        self.assertGreater(made["scaled_jacobian"]["min"], 0)
        self.assertIn("expected   about ", self.result.stdout)
        self.assertLessEqual(made["largest_distance"], 0.1 * made["used_size"])

    def write_fan(self):
        """Five tets around an axis, which have no map."""
        tips = [(0, 0, 1.5), (0, 0, 0)]
        rim = [(np.cos(2 * np.pi * k / 5), np.sin(2 * np.pi * k / 5), 0) for k in range(5)]
        self.write("fan.mesh", medit_text(np.array(tips + rim), np.array([(0, 1, 2 + k, 2 + (k + 1) % 5) for k in range(5)])))

    def test_five_tets_around_an_axis_have_no_map_which_all_output_says(self):
        self.write_fan()
        made = self.hexahedra("fan.mesh", "--cells", "3", "--map-only", code=NOT_ALL_HEX)
        self.assertEqual((made["outcome"], made["hexahedra"]), ("none", 0))
        self.assertIn("inverted", made["detail"])
        self.assertTrue(all(np.isfinite(place).all() for place in made["places"]))
        self.assertIn("hexahedra  none: ", self.result.stdout)
        self.assertIn(made["reason"], self.result.stdout)
        self.assertNotIn("--tet-size", self.result.stdout, "no tets are made of a mesh of tets")
        # A mesh of nothing has no files, and a field that hexahedra fit locally is no consolation.
        self.assertEqual(self.files_of_hexahedra(), [])
        self.assertNotIn("hexahedra.", self.result.stdout.split("\nfiles ", 1)[1])
        checked = self.run_here("check", "out").stdout
        self.assertTrue(checked.startswith("hexahedra: none: "), checked)
        self.assertIn("\nfield: hexahedra fit around each line and point of it, which was not enough\n", checked)
        self.assertNotIn("necessary", checked)
        self.assertNotRegex(checked, r"repaired: \d+ for \d+ places")
        # Each attempt ends with a line that says how, and the last why no other follows.
        ends = [line for line in self.result.stderr.splitlines() if line.startswith("attempt ")]
        self.assertGreater(len(ends), 1)
        self.assertEqual(len(ends), len(made["attempts"]))
        for k, line in enumerate(ends[:-1]):
            self.assertRegex(line, rf"^attempt {k + 1}: .+; trying .+$")
        self.assertRegex(ends[-1], rf"^attempt {len(ends)}: .+; (nothing else is left to try|the work of a search is done)$")
        texts = [line.split(": ", 1)[1].split("; trying ")[0] for line in ends]
        self.assertTrue(all(a != b or a.startswith("ends as attempt ") for a, b in zip(texts, texts[1:])), ends)
        self.write_box()
        self.hexahedra("box.mesh", "--cells", "4", "--force")
        self.assertEqual(self.files_of_hexahedra(), FILES)

    def files_of_hexahedra(self):
        return sorted(path.name for path in (self.folder / "out").iterdir() if path.name.startswith("hexahedra."))

    def test_a_volume_far_off_is_told_first_with_a_size_that_helps(self):
        self.write("cylinder.stl", stl_bytes(cylinder_triangles()))
        made = self.hexahedra("cylinder.stl", "--size", "0.5", "--tet-size", "0.5", "--map-only", code=APPROXIMATE)
        self.assertEqual(made["outcome"], "approximate")
        off = 100 * (1 - made["volume"] / made["model_volume"])
        row = next(line for line in self.result.stdout.splitlines() if line.startswith("hexahedra"))
        self.assertRegex(row, rf"^hexahedra  approximate: \d+ hexahedra, mean edge 0.4.*; its volume is {off:.2g} % below the model's; try --size [\d.]+ \(about \d+\)$")
        self.assertEqual(made["remedy"], "use_hex_size")
        self.assertIn(f"try --size {made['remedy_number']:g} (about ", row)
        self.assertNotIn("volume than the model", self.result.stdout)
        self.assertIn("hexahedra.inp", self.files_of_hexahedra())
        with self.subTest("accepted"):
            self.hexahedra("cylinder.stl", "--size", "0.5", "--tet-size", "0.5", "--accept", "approximate")
            self.assertIn("--accept", self.run_here("hex", "cylinder.stl", "--accept", "partial").stderr)
        # What it says helps.
        self.assertNotIn("reason", self.hexahedra("cylinder.stl", "--size", f"{made['remedy_number']:g}", "--tet-size", "0.5"))

    def test_without_a_mesh_that_fills_the_model_one_line_says_why_even_if_quiet(self):
        self.write_fan()
        made = self.hexahedra("fan.mesh", "--cells", "3", "--map-only", "--quiet", code=NOT_ALL_HEX)
        self.assertEqual(self.result.stdout, "")
        lines = [line for line in self.result.stderr.splitlines() if "warning: " not in line]
        self.assertEqual(len(lines), 1, lines)
        self.assertRegex(lines[0], r"\Acrossgrain: fan.mesh: (none|partial).*\Z")
        self.assertIn(made["reason"], lines[0])

    def test_verbose_adds_the_numbers_of_tets_repair_and_map(self):
        self.write_box()
        made = self.run_here("hex", "box.mesh", "--cells", "4", "-o", "out", "--verbose")
        self.assert_succeeds(made)
        rows = [line.split()[0] for line in made.stdout.splitlines()]
        self.assertLessEqual({"singular", "energy", "surface", "cells", "tets", "repair"}, set(rows))
        self.assertEqual(rows.count("energy"), 1)
        self.assertEqual(rows[-2:], ["files", "time"])

    def test_warnings_about_the_model_come_before_the_work(self):
        vertices, tets = tet_box()
        nodes = [f"{i + 1} {x:.17g} {y:.17g} {z:.17g}" for i, (x, y, z) in enumerate(vertices)]
        # Tets of second order; where the middles of their edges are does not count.
        cells = [" ".join(map(str, [i + 1, 11, 2, 0, 1, *(tet + 1), *[tet[0] + 1] * 6])) for i, tet in enumerate(tets)]
        self.write("box.msh", "\n".join(["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(nodes)), *nodes, "$EndNodes",
                                         "$Elements", str(len(cells)), *cells, "$EndElements", ""]))
        self.hexahedra("box.msh", "--size", "0.25", "--progress")
        warning, level = self.result.stderr.index("crossgrain: warning: box.msh"), self.result.stderr.index("solving the field")
        self.assertLess(warning, level)
        self.assertEqual(self.result.stderr.count("warning"), 1)

    def stopped(self, model, *arguments, after, number=signal.SIGINT):
        """Exit code and all of standard error of a search that is stopped after the first event for which `after` is true."""
        lines = []
        with subprocess.Popen([PROGRAM, "hex", model, *arguments, "-o", "out", "--progress", "json"], cwd=self.folder, text=True,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
            for line in process.stderr:
                lines.append(line)
                if line.startswith("{") and after(json.loads(line)):
                    break
            process.send_signal(number)
            lines.append(process.communicate(timeout=100)[1])
        return process.returncode, "".join(lines)

    def test_ctrl_c_before_there_is_a_mesh_writes_nothing_and_says_so(self):
        vertices, tets = tet_box((16, 12, 12))
        self.write("box.mesh", medit_text(vertices @ tilt(), tets))
        code, errors = self.stopped("box.mesh", "--cells", "60", after=lambda event: event.get("phase") == "repair")
        self.assertEqual(code, INTERRUPTED)
        self.assertIn("crossgrain: interrupted before there was a mesh; nothing is written\n", errors)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["box.mesh"])

    def test_ctrl_c_writes_the_best_mesh_so_far(self):
        self.write("star.stl", stl_bytes(star_triangles()))
        code, errors = self.stopped("star.stl", "--cells", "30", "--tet-size", "0.2", number=signal.SIGTERM,
                                    after=lambda event: event.get("best", {}).get("hexahedra", 0) > 0)
        self.assertEqual(code, INTERRUPTED, errors)
        self.assertIn("crossgrain: interrupted: writing the best mesh so far, ", errors)
        made = json.loads((self.folder / "out/report.json").read_text())["hexahedra"]
        self.assertTrue(made["is_stopped"])
        self.assertRegex(made["sentence"], "^[a-z-]+, the search was stopped")
        self.assertEqual(made["next"], "let it finish", "what was not tried yet may still bring a mesh")
        self.assertGreater(made["hexahedra"], 0)
        name = "hexahedra.vtu" if made["outcome"] in ("all-hex", "approximate") else "hexahedra.partial.vtu"
        self.assertEqual(len(read_arrays(self.folder / "out" / name)["scaled_jacobian"]), made["hexahedra"])

    def test_progress_as_json_tells_stages_with_their_shares_and_how_each_attempt_ended(self):
        self.write_box()
        result = self.run_here("hex", "box.mesh", "--progress", "json", "--cells", "4", "-o", "out")
        self.assert_succeeds(result)
        events = [json.loads(line) for line in result.stderr.splitlines() if line.startswith("{")]
        model = next(event for event in events if event["event"] == "model")
        vertices = tet_box()[0] @ tilt()
        np.testing.assert_allclose([model["bounding_box"]["low"], model["bounding_box"]["high"]], [vertices.min(axis=0), vertices.max(axis=0)])
        self.assertEqual(model["tets"], len(tet_box()[1]))
        self.assertNotIn("unit", model)
        self.assertTrue(all(event["best"]["hexahedra"] > 0 for event in events if "best" in event))
        self.assertTrue(all(event["levels"] >= event["level"] > 0 for event in events if "levels" in event))
        self.assertEqual({(event["tets"], event["most_tets"]) for event in events if "attempt" in event}, {(1, 1)})
        self.assertEqual([event["seconds"] for event in events], sorted(event["seconds"] for event in events))
        expected = next(event for event in events if event["event"] == "expected")
        made = json.loads((self.folder / "out/report.json").read_text())["hexahedra"]["hexahedra"]
        self.assertAlmostEqual(expected["hexahedra"], made, delta=made)
        phases = [event["phase"] for event in events if event.get("attempt") == 1 and event["event"] == "progress"]
        self.assertEqual([phase for k, phase in enumerate(phases) if phase not in phases[:k]][-4:],
                         ["repair", "map", "hexahedra", "smooth"])
        self.assertTrue(all(0 <= event["share"] <= 1 for event in events if "share" in event))
        end = next(event for event in events if event["event"] == "attempt")
        self.assertEqual((end["outcome"], end["next"], end["over"]), ("all-hex", "", ""))
        self.assertLess(events.index(expected), events.index(end))

    def test_a_later_solve_removes_the_hexahedra(self):
        self.write_box()
        self.hexahedra("box.mesh", "--cells", "4")
        self.assert_succeeds(self.run_here("solve", "box.mesh", "-o", "out", "--no-report", "--quiet"))
        self.assertFalse(set(FILES) & {path.name for path in (self.folder / "out").iterdir()})
        self.assertNotIn("hexahedra", json.loads((self.folder / "out/report.json").read_text()))

    def test_the_result_is_the_same_with_one_thread(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        self.hexahedra("box.stl", "--cells", "6", "--tet-size", "0.35", "--threads", "1")
        one = (self.folder / "out/hexahedra.mesh").read_bytes()
        self.hexahedra("box.stl", "--cells", "6", "--tet-size", "0.35")
        self.assertEqual((self.folder / "out/hexahedra.mesh").read_bytes(), one)

    def read_hexex(self, name):
        """Points, tets and coordinates of their corners; the file has nothing else."""
        words = (self.folder / "out" / name).read_text().split()
        count = int(words[0])
        rows = np.array(words[2 + 3 * count:], float).reshape(int(words[1 + 3 * count]), 16)
        return np.array(words[1:1 + 3 * count], float).reshape(-1, 3), rows[:, :4].astype(int), rows[:, 4:].reshape(-1, 4, 3)

    def test_the_map_is_written_for_programs_that_extract_hexahedra(self):
        self.write("cylinder.stl", stl_bytes(cylinder_triangles()))
        self.hexahedra("cylinder.stl", "--cells", "5", "--tet-size", "0.3", "--write", "hexex,mesh", "--map-only", code=APPROXIMATE)
        points, tets, grid = self.read_hexex("hexahedra.hexex")
        # Its cells are the hexahedra, one by one: as many, and a point of the grid in the tets for each vertex.
        self.assertAlmostEqual(np.linalg.det(grid[:, 1:] - grid[:, :1]).sum() / 6, len(self.corners), places=9)
        self.assertEqual(len(grid_points_in(points, tets, grid)), len(self.vertices))
        self.assertTrue((np.linalg.det(points[tets][:, 1:] - points[tets][:, :1]) > 0).all())
        for whole, side, other in transitions(tets, grid):
            np.testing.assert_array_equal(side, other)
            self.assertTrue(whole)
        same_points, same_tets, seamless = self.read_hexex("hexahedra_seamless.hexex")
        np.testing.assert_array_equal(points, same_points)
        np.testing.assert_array_equal(tets, same_tets)
        for _, side, other in transitions(tets, seamless):
            np.testing.assert_allclose(side, other, atol=1e-12)

    def test_paraview_sees_both_maps_of_each_tet(self):
        self.write_box()
        self.hexahedra("box.mesh", "--size", "0.3", "--write", "map,hexex")
        arrays = read_arrays(self.folder / "out/hexahedra_map.vtu")
        points, tets, grid = self.read_hexex("hexahedra.hexex")
        np.testing.assert_array_equal(arrays["vertex"], tets.ravel())
        np.testing.assert_array_equal(arrays["Points"], points[tets.ravel()])
        np.testing.assert_array_equal(arrays["integer_grid"], grid.reshape(-1, 3))
        np.testing.assert_array_equal(arrays["seamless"], self.read_hexex("hexahedra_seamless.hexex")[2].reshape(-1, 3))
        jacobians = np.linalg.det(grid[:, 1:] - grid[:, :1]) / np.linalg.det(points[tets][:, 1:] - points[tets][:, :1])
        np.testing.assert_allclose(arrays["determinant"], 0.3**3 * jacobians, rtol=1e-6)

    def test_files_of_the_map_are_listed_and_removed_by_a_later_run(self):
        self.write_box()
        self.hexahedra("box.mesh", "--cells", "4", "--write", "hexex,map")
        files = {"hexahedra.hexex", "hexahedra_seamless.hexex", "hexahedra_map.vtu"}
        self.assertTrue(all(name in self.result.stdout for name in files))
        self.hexahedra("box.mesh", "--cells", "4")
        self.assertFalse(files & {path.name for path in (self.folder / "out").iterdir()})

    def test_regions_are_kept(self):
        vertices, tets = tet_box()
        regions = 1 + (vertices[tets].mean(axis=1)[:, 0] > vertices[:, 0].mean())
        head, rows = medit_text(vertices, tets).split("Tetrahedra\n")
        count, *rows = rows.splitlines()
        for k, region in enumerate(regions):
            rows[k] = " ".join([*rows[k].split()[:4], str(region)])
        self.write("two.mesh", head + "Tetrahedra\n" + "\n".join([count, *rows]) + "\n")
        self.hexahedra("two.mesh", "--size", "0.25")
        of_hexahedra = medit_section(self.folder / "out/hexahedra.mesh", "Hexahedra", 9)[:, 8]
        self.assertEqual([np.count_nonzero(of_hexahedra == k) for k in (1, 2)], [96, 96])

    def test_other_commands_take_the_folder(self):
        self.write_box()
        self.hexahedra("box.mesh", "--cells", "4")
        self.assert_succeeds(self.run_here("check", "out"))
        self.assert_succeeds(self.run_here("sample", "out", "0", "0", "0"))

    def test_wrong_use_is_one_line(self):
        self.write_box()
        self.assert_fails(self.run_here("hex", "box.mesh", "--size", "1", "--cells", "3"), USAGE, "--size")
        self.assert_fails(self.run_here("hex", "box.mesh", "--tet-size", "1"), USAGE, "--tet-size")
        self.assert_fails(self.run_here("hex", "box.mesh", "--size", "0"), USAGE, "--size")
        self.assert_fails(self.run_here("hex", "box.mesh", "--write", "ovm"), USAGE, "--write", "hexex, map")
        self.assert_fails(self.run_here("hex", "none.stl"), INPUT, "none.stl", "no such file")
        (self.folder / "other").mkdir()
        self.write("other/thing", "")
        self.assert_fails(self.run_here("hex", "box.mesh", "-o", "other"), OUTPUT, "other")


if __name__ == "__main__":
    unittest.main()
