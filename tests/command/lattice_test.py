#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain hex --lattice`, and lattices where no map keeps the model: judged by independent code (hex_judge.py)."""

import json
import os
import shutil
import signal
import subprocess
import unittest

import numpy as np

from damage import subdivided
from fit_test import cylinder
from hex_judge import judged
from hex_pictures_test import legend_of
from page_reader import Page
from program import PROGRAM, CommandTest, box_triangles, medit_text, stl_bytes, tet_box

CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
USAGE, INPUT, PARTIAL, APPROXIMATE, INTERRUPTED = 2, 3, 6, 7, 130


def turned(triangles, angle, axis=(1, 2, 3)):
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.array(triangles) @ (np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross).T


def revolved(profile, segments=36):
    """A solid of revolution around z, of radii and heights that begin and end on the axis."""
    angles = 2 * np.pi * np.arange(segments) / segments
    rings = [np.array([(r * np.cos(a), r * np.sin(a), z) for a in angles]) for r, z in profile]
    triangles = []
    for (low, (r, _)), (high, (next_r, _)) in zip(zip(rings, profile), list(zip(rings, profile))[1:]):
        for k in range(segments):
            n = (k + 1) % segments
            if r > 0:
                triangles.append((low[k], low[n], high[n] if next_r > 0 else high[k]))
            if next_r > 0:
                triangles.append((low[k], high[n], high[k]))
    return np.array(triangles)


def of_cells(cuts, kept):
    """The surface of cells (i, j, k) between coordinates along each axis."""
    triangles = []
    for cell in kept:
        for axis in range(3):
            for side in (0, 1):
                beside = tuple(c + (2 * side - 1) * (a == axis) for a, c in enumerate(cell))
                if beside in kept:
                    continue
                one, other = (axis + 1) % 3, (axis + 2) % 3
                corners = []
                for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    index = list(cell)
                    index[axis] += side
                    index[one] += u
                    index[other] += v
                    corners.append([cuts[a][i] for a, i in enumerate(index)])
                a, b, c, d = corners if side else corners[::-1]
                triangles += [(a, b, c), (a, c, d)]
    return np.array(triangles)


class Lattice(CommandTest):
    def made(self, *options, model="part.stl", code=0):
        """What it printed, and the report."""
        result = self.run_here("hex", model, *options, "-o", "out", "--force")
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stdout, json.loads((self.folder / "out" / "report.json").read_text())["hexahedra"]

    def assert_all_hex(self, size, model="part.stl", least=0.2):
        verdict = judged(self.folder / "out" / "hexahedra.msh", self.folder / model, size)
        self.assertEqual(verdict.outcome, "all_hex", verdict.reasons)
        self.assertGreater(verdict.figures["scaled_jacobian"]["min"], least)

    def test_fills_a_turned_box_with_bricks(self):
        self.write("part.stl", stl_bytes(turned(box_triangles(), 0.7)))
        printed, report = self.made("--lattice", "--cells", "8")
        self.assertIn("all-hex by a lattice: ", printed)
        self.assertIn("attempt 1 of 1: lattice", printed)
        self.assertRegex(printed, r"(?m)^expected   about \d+ hexahedra of \S+, by a lattice$")
        self.assertNotIn("tets", printed)
        self.assertRegex(printed, r"(?m)^files      out: report.html, hexahedra.vtu, hexahedra.mesh, hexahedra.msh, hexahedra.inp, report.json$")
        self.assertGreater(report["scaled_jacobian"]["min"], 0.999)
        self.assert_all_hex(report["size"])
        self.assertEqual(sorted(path.name for path in (self.folder / "out").iterdir()),
                         ["hexahedra.inp", "hexahedra.mesh", "hexahedra.msh", "hexahedra.vtu", "report.html", "report.json"])

    def test_has_a_page_with_hexahedra_and_model_and_no_field(self):
        self.write("part.stl", stl_bytes(cylinder(2, 5)))
        self.made("--lattice", "--size", "0.7")
        self.assert_succeeds(self.run_here("render", "out", "--colour", "face", "--size", "400x300", "-o", "a.png"))
        self.assertRegex(legend_of(self.folder / "a.png"), r"All-hex by a lattice: \d+ hexahedra\n(.*\n)*.*Faces \(3\)")
        page = Page(self.folder / "out" / "report.html")
        report = json.loads((self.folder / "out" / "report.json").read_text())
        self.assertEqual(page.report["hexahedra"], report["hexahedra"])
        self.assertEqual((page.header["hexahedra"]["total"], page.header["hexahedra"]["inverted"]), (report["hexahedra"]["hexahedra"], 0))
        self.assertNotIn("cells", page.header)
        self.assertFalse({"cell_corner", "arc_points", "tet_corners", "streamline_points"} & set(page.arrays))
        # The surface is closed, has the volume of the model, and names the patches that quads lie on.
        corners = page.arrays["surface_vertices"][page.arrays["surface_triangles"]].astype(float)
        volume = np.linalg.det(corners).sum() / 6
        self.assertAlmostEqual(volume, report["hexahedra"]["model_volume"], delta=1e-4 * volume)
        numbers = {face["number"] for face in report["faces"]}
        self.assertEqual(set(page.arrays["surface_face"]), numbers)
        self.assertEqual(set(page.arrays["hex_face"].flat), numbers | {0})
        self.assertEqual(len(page.lines("crease_points", "crease_starts")), 2)

    def test_has_no_page_where_none_is_wanted(self):
        self.write("part.stl", stl_bytes(box_triangles()))
        printed, _ = self.made("--lattice", "--cells", "4")
        self.assertTrue((self.folder / "out" / "report.html").exists())
        printed, _ = self.made("--lattice", "--cells", "4", "--no-report")
        self.assertFalse((self.folder / "out" / "report.html").exists(), "nor that of an earlier run")
        self.assertIn("out: hexahedra.vtu, ", printed)
        self.assert_fails(self.run_here("view", "out", "--no-browser"), INPUT, "out", "report.html", "--no-report")

    def test_is_checked_by_its_report(self):
        self.write("part.stl", stl_bytes(cylinder(2, 5)))
        printed, report = self.made("--lattice", "--size", "0.7")
        checked = self.run_here("check", "out")
        self.assert_succeeds(checked)
        rows = [line for line in printed.splitlines() if line.split()[0] in ("hexahedra", "worst", "fit", "features", "way", "warning")]
        self.assertEqual(checked.stdout.splitlines()[:len(rows)], rows)
        self.assertNotIn("arcs", checked.stdout)
        data = json.loads(self.run_here("check", "out", "--json").stdout)
        self.assertEqual(list(data), ["hexahedra", "faces", "warnings"])
        self.assertEqual(data["hexahedra"], report)
        # A field that is missing is no lattice.
        (self.folder / "out" / "report.json").unlink()
        self.assert_fails(self.run_here("check", "out"), INPUT, "out", "holds no field")

    def test_is_put_onto_a_round_part_askew(self):
        self.write("part.stl", stl_bytes(turned(cylinder(2, 5), 0.4)))
        _, report = self.made("--lattice", "--size", "0.5")
        self.assertEqual(report["features"]["creases"], {"all": 2, "kept": 2})
        self.assert_all_hex(0.5)

    def test_has_no_edge_far_shorter_than_its_hexahedra(self):
        self.write("part.stl", stl_bytes(turned(revolved([(0, 0), (4, 0), (4, 5), (2.4, 5), (2.4, 6), (3, 6), (3, 12), (0, 12)]), 0.5)))
        printed, report = self.made("--lattice", "--cells", "18")
        self.assertRegex(printed, r"(?m)^worst .*; shortest edge 0\.\d+ at ")
        self.assertGreater(report["scaled_jacobian"]["shortest_edge"], 0.05 * report["mean_edge"])
        self.assert_all_hex(report["used_size"])

    def test_is_made_where_the_hexahedra_of_a_map_do_not_keep_the_volume(self):
        self.write("part.stl", stl_bytes(cylinder(2, 5)))
        printed, report = self.made("--size", "1.4", "--no-report")
        self.assertIn("all-hex by a lattice: ", printed)
        self.assertIn("; no map, since ", printed)
        self.assertEqual(report["attempts"][report["best_attempt"]]["kind"], "lattice")
        self.assertTrue((self.folder / "out" / "onto.vtu").exists(), "the field is there too")
        checked = self.run_here("check", "out").stdout.splitlines()
        self.assertTrue(checked[0].startswith("hexahedra: all-hex by a lattice: "), checked)
        self.assertEqual(checked[1:3], [f"no map was taken, since {report['map_fault']}", "the mesh follows no field; that along which maps were tried:"])
        self.assertEqual(json.loads(self.run_here("check", "out", "--json").stdout)["hexahedra"], report)
        self.assert_all_hex(report["size"])

    def test_is_not_made_where_maps_are_preferred(self):
        self.write("part.stl", stl_bytes(cylinder(2, 5)))
        for option in (("--map-only",), ("--prefer", "map")):
            _, report = self.made("--size", "1.4", *option, "--no-report", code=APPROXIMATE)
            self.assertEqual({attempt["kind"] for attempt in report["attempts"]} - {"tets", "repair"}, set())

    def test_comes_first_where_it_is_preferred(self):
        self.write("box.mesh", medit_text(*tet_box((3, 2, 2))))
        printed, report = self.made("--cells", "6", "--prefer", "lattice", "--no-report", model="box.mesh")
        self.assertIn("all-hex by a lattice: 90 hexahedra, mean edge 0.322", printed)
        self.assertEqual([attempt["kind"] for attempt in report["attempts"]], ["lattice"])

    def test_of_two_solids_that_touch_is_no_success(self):
        vertices, tets = tet_box((4, 2, 2), (4.0, 2.0, 2.0))
        lines = medit_text(vertices, tets).split("\n")
        first = lines.index("Tetrahedra") + 2
        for k, tet in enumerate(tets):
            lines[first + k] = lines[first + k][:-1] + ("1" if vertices[tet].mean(axis=0)[0] < 2 else "2")
        self.write("two.mesh", "\n".join(lines))
        printed, report = self.made("--lattice", "--cells", "8", model="two.mesh", code=APPROXIMATE)
        self.assertRegex(printed, r"(?m)its 2 solids are meshed as one, without faces between them, which only maps have$")
        self.assertEqual(report["bodies"], 1)

    def test_fills_the_holes_of_a_surface_and_says_where(self):
        whole = turned(subdivided(np.array(box_triangles()), 2), 0.7)
        self.write("part.stl", stl_bytes(whole[np.random.default_rng(5).random(len(whole)) > 0.1]))
        self.write("whole.stl", stl_bytes(whole))
        result = self.run_here("hex", "part.stl", "--lattice", "--cells", "8", "-o", "out")
        self.assertRegex(result.stderr, r"warning: part.stl: holes: \d+, the largest .* at .*; filled with triangles")
        self.assert_all_hex(0.125 * max(np.ptp(whole.reshape(-1, 3), axis=0)), model="whole.stl")

    def test_leaves_narrow_pockets_out_and_says_where(self):
        self.write("part.stl", stl_bytes(revolved([(0, 0), (5, 0), (5, 4), (1, 4), (1, 2), (0, 2)])))
        self.write("whole.stl", stl_bytes(revolved([(0, 0), (5, 0), (5, 4), (0, 4)])))
        result = self.run_here("hex", "part.stl", "--lattice", "--size", "1", "--defeature", "3", "-o", "out")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, r"warning: part.stl: 1 hole, slot, pocket or boss narrower than 3 left out: 2 wide at \S+ \S+ 4\n")
        self.assert_all_hex(1, model="whole.stl")
        result = self.run_here("hex", "part.stl", "--lattice", "--size", "1", "--defeature", "1.9", "-o", "out", "--force")
        self.assertRegex(result.stderr, "warning: part.stl: no hole, slot, pocket or boss is narrower than 1.9")
        self.assert_all_hex(1)
        self.write("box.mesh", medit_text(*tet_box((3, 2, 2))))
        for options in ((), ("--lattice",)):
            self.assert_fails(self.run_here("hex", "box.mesh", "--defeature", "1", *options), USAGE, "nothing can be left out of a mesh of tets")

    def test_is_made_where_no_program_makes_tets(self):
        alone = shutil.copy(PROGRAM, self.folder / "alone")
        self.write("part.stl", stl_bytes(box_triangles()))
        arguments = ("hex", "part.stl", "--cells", "4", "-o", "out", "--no-report")
        environment = {**os.environ, "PATH": ""}
        result = self.run_here(*arguments, "--write", "hexex", program=str(alone), env=environment)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, "warning: part.stl: no tets can be made of it, and so no field and no map, but a lattice: there is no program .*; install gmsh")
        self.assertRegex(result.stderr, "warning: no file of a field or a map is written")
        self.assertRegex(result.stdout, r"(?m)^files      out: hexahedra.vtu, hexahedra.mesh, hexahedra.msh, hexahedra.inp, report.json$")
        self.assertIn("no tets can be made of it", str(json.loads((self.folder / "out/report.json").read_text())["warnings"]))
        result = self.run_here(*arguments, "--map-only", "--force", program=str(alone), env=environment)
        self.assert_fails(result, INPUT, "part.stl", "no program that makes tets", "install gmsh")

    @unittest.skipUnless(CAD_FILES, "built without OpenCASCADE")
    def test_fills_an_open_shell_of_a_cad_file(self):
        subprocess.run([CAD_FILES, self.folder], capture_output=True, timeout=60, check=True)
        for options in ((), ("--lattice",)):
            with self.subTest(options=options):
                result = self.run_here("hex", "open.brep", *options, "--cells", "6", "-o", "out", "--force", "--no-report")
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn("filled with triangles", result.stderr)
                features = json.loads((self.folder / "out" / "report.json").read_text())["hexahedra"]["features"]
                self.assertEqual(features["faces"]["kept"], 6)

    def test_of_bodies_that_touch_fills_what_they_are_together(self):
        box = np.array(box_triangles())
        size = box.reshape(-1, 3).max(axis=0)
        self.write("part.stl", stl_bytes(np.concatenate([box, 0.5 * box + np.array([size[0], 0.2 * size[1], 0.2 * size[2]])])))
        _, report = self.made("--lattice", "--cells", "10")
        self.assertEqual(report["bodies"], 1)
        self.assertAlmostEqual(report["volume"], 1.125 * np.prod(size), 6)

    def test_has_a_body_in_a_void(self):
        box = np.array(box_triangles())
        middle = box.reshape(-1, 3).mean(axis=0)
        scaled = [middle + share * (box - middle) for share in (1, 0.7, 0.2)]
        self.write("part.stl", stl_bytes(np.concatenate([scaled[0], scaled[1][:, ::-1], scaled[2]])))
        printed, _ = self.made("--lattice", "--cells", "12")
        self.assertIn("in 2 bodies", printed)
        self.assert_all_hex(0.1)

    def test_tells_its_hexahedra_with_layers_before_they_are_moved(self):
        self.write("part.stl", stl_bytes(revolved([(0, 0), (1, 0), (1, 2), (0, 2)])))
        result = self.run_here("hex", "part.stl", "--lattice", "--cells", "8", "--progress", "json", "-o", "out")
        self.assertEqual(result.returncode, 0, result.stderr)
        events = [json.loads(line) for line in result.stderr.splitlines() if line.startswith("{")]
        report = json.loads((self.folder / "out" / "report.json").read_text())["hexahedra"]
        best = report["attempts"][report["best_attempt"]]
        of_best = [event for event in events if event.get("attempt") == best["number"]]
        first = next(event for event in of_best if "fitted" in event)
        self.assertEqual(first["phase"], "smooth")
        self.assertEqual(first["fitted"], best["hexahedra"])
        self.assertLess(first["share"], 0.1)
        self.assertEqual(of_best[-1]["event"], "attempt")

    def test_that_is_stopped_is_the_best_so_far(self):
        self.write("part.stl", stl_bytes(cylinder(2, 5, segments=7)))
        with subprocess.Popen([PROGRAM, "hex", "part.stl", "--lattice", "--cells", "60", "-o", "out", "--progress", "json"], cwd=self.folder, text=True,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
            for line in process.stderr:
                if line.startswith('{"event":"progress"') and '"phase":"smooth"' in line:
                    break
            process.send_signal(signal.SIGTERM)
            errors = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, INTERRUPTED, errors)
        self.assertIn("interrupted: writing the best mesh so far, ", errors)
        made = json.loads((self.folder / "out/report.json").read_text())["hexahedra"]
        self.assertTrue(made["is_stopped"])
        self.assertIn(", the search was stopped", made["sentence"])
        self.assertGreater(made["hexahedra"], 0)

    def test_has_one_hexahedron_across_sheets_needles_walls_and_gaps(self):
        for thickness in (0.01, 2e-5):
            box = np.array(box_triangles((2, 2, 2)))
            hollow = np.concatenate([box, (box * (1 - thickness) + thickness)[:, ::-1]])
            apart = np.concatenate([box, box + (2 + thickness, 0, 0)])
            parts = {"sheet": (box * (1, 1, thickness), 8**2), "needle": (box * (1, thickness, 2 * thickness), 8),
                     "walls": (hollow, 10**3 - 8**3), "gap": (apart, 2 * 4**3)}
            for name, (triangles, number) in parts.items():
                with self.subTest(name, thickness=thickness):
                    self.write(f"{name}.stl", stl_bytes(triangles))
                    report = self.made("--lattice", "--cells", "8", model=f"{name}.stl")[1]
                    self.assertEqual(report["hexahedra"], number)
                    self.assertGreater(report["scaled_jacobian"]["min"], 0.999)

    def test_keeps_a_thin_wall_that_ends_at_an_edge(self):
        # Without it the topology is the same.
        cells = {(0, j, k) for j in range(3) for k in range(2)} - {(0, 1, 1)}
        self.write("part.stl", stl_bytes(turned(of_cells(([0, 6], [0, 0.2, 3, 6], [0, 2, 4]), cells), 0.7)))
        report = self.made("--lattice", "--size", "1")[1]
        self.assertEqual([attempt["size"] for attempt in report["attempts"]], [1, 1])
        self.assertEqual((report["hexahedra"], report["used_size"]), (6 * 7 * 2 + 6 * 4 * 2, 1))
        self.assert_all_hex(1, least=0.999)

    def test_makes_a_rod_of_one_cell_round(self):
        self.write("part.stl", stl_bytes(turned(cylinder(0.5, 20), 0.4)))
        report = self.made("--lattice", "--size", "1")[1]
        self.assertLess(report["hexahedra"], 1500)
        self.assert_all_hex(1, least=0.15)

    def test_is_padded_where_four_creases_meet(self):
        base = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
        triangles = [(base[0], base[2], base[1]), (base[0], base[3], base[2]), *[(base[k], base[(k + 1) % 4], (0, 0, 1.4)) for k in range(4)]]
        self.write("part.stl", stl_bytes(turned(triangles, 0.7)))
        report = self.made("--lattice", "--cells", "10")[1]
        self.assertEqual(report["fit_tries"][report["best_fit"]]["way"], "padded")
        self.assert_all_hex(report["size"], least=0.15)

    def test_takes_no_options_of_maps(self):
        self.write("part.stl", stl_bytes(box_triangles()))
        for options in (["--map-only"], ["--prefer", "map"], ["--tet-size", "1"], ["--seed", "3"]):
            self.assert_fails(self.run_here("hex", "part.stl", "--lattice", *options, "-o", "out"), USAGE, "--lattice")

    def test_refuses_sizes_that_suit_no_part(self):
        self.write("part.stl", stl_bytes(box_triangles()))
        for size in ("1e9", "1e-9"):
            self.assert_fails(self.run_here("hex", "part.stl", "--lattice", "--size", size, "-o", "out"), USAGE, "too")
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
