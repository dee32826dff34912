#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain check`, and the files of singular lines that it judges."""

import json
import math
import os
import unittest
from pathlib import Path

from field_reader import read_arrays
from program import CommandTest, box_triangles, cylinder_triangles, medit_text, stl_bytes, tet_box, with_option
from recompute_onto import OntoRecomputation
from recompute_singularity import Graph, graph_faults

USAGE, INPUT, NOT_SETTLED = 2, 3, 5
SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared"))


class CheckTest(CommandTest):
    def solve(self, name, *arguments):
        self.assert_succeeds(self.run_here("solve", name, "-o", "out", "--quiet", "--no-report", *arguments))
        return json.loads((self.folder / "out" / "report.json").read_text())

    def check(self, *arguments):
        result = self.run_here("check", "out", *arguments)
        self.assert_succeeds(result)
        return result.stdout


class OfAGrid(CheckTest):
    def setUp(self):
        super().setUp()
        self.write("cylinder.stl", stl_bytes(cylinder_triangles()))
        self.report = self.solve("cylinder.stl", "--resolution", "32")

    def test_begins_with_the_answer_and_ends_with_the_level_before(self):
        lines = self.check().splitlines()
        self.assertLessEqual(len(lines), 15)
        self.assertEqual(lines[0], "hexahedra fit locally (necessary, not sufficient)")
        self.assertEqual(lines[-1], "at half the resolution: 4 arcs, 0 nodes, 8 ends on the surface, the same; unchanged from "
                                    f"{self.report['coarser']['last_change']:g} cells on")
        self.assertIn(["arcs", "4"], [line.split() for line in lines])
        self.assertIn(["ends", "on", "the", "surface", "8"], [line.split() for line in lines])

    def test_prints_what_the_report_has(self):
        keys = ("verdict", "answer", "reasons", "coarser")
        expected = {key: self.report[key] for key in keys if key in self.report} | {"grid": self.report["singularity"]}
        self.assertEqual(json.loads(self.check("--json")), expected)
        self.assertEqual(next(iter(json.loads(self.check("--json")))), "verdict", "it comes first")

    def test_judges_the_field_and_not_what_the_report_says_of_it(self):
        path = self.folder / "out" / "report.json"
        report = json.loads(path.read_text())
        report["verdict"] = report["singularity"]["verdict"] = "not_meshable"
        report["singularity"]["arcs"] = 5
        path.write_text(json.dumps(report))
        self.assertTrue(self.check().startswith("hexahedra fit locally"))

    def test_the_file_has_four_arcs_of_index_a_quarter(self):
        graph = Graph(self.folder / "out" / "singularities.vtu")
        self.assertEqual(list(graph.arrays["index"]), [0.25] * 4)
        self.assertEqual(list(graph.arrays["on_boundary"]), [1] * 4)
        self.assertEqual(graph_faults("singularity", self.report["singularity"], self.folder / "out" / "singularities.vtu"), [])


class OfABox(CheckTest):
    def test_has_no_lines_and_is_meshable(self):
        self.write("box.stl", stl_bytes(box_triangles((2, 1, 1.5))))
        report = self.solve("box.stl", "--resolution", "8")
        self.assertEqual((report["singularity"]["arcs"], report["singularity"]["verdict"]), (0, "meshable"))
        arrays = read_arrays(self.folder / "out" / "singularities.vtu")
        self.assertEqual((len(arrays["Points"]), len(arrays["offsets"])), (0, 0))
        self.assertTrue(self.check().startswith("hexahedra fit locally"))


class OfTets(CheckTest):
    def test_judges_the_tets_and_shows_the_grid_beside(self):
        vertices, tets = tet_box()
        self.write("box.mesh", medit_text(vertices, tets))
        report = self.solve("box.mesh")
        lines = self.check().splitlines()
        self.assertEqual(lines[2].split(), ["tets", "grid"])
        of_check = json.loads(self.check("--json"))
        self.assertEqual((of_check["grid"], of_check["tets"]), (report["singularity"], report["onto"]["singularity"]))

    def test_damaged_tets_are_one_line_and_exit_code_3(self):
        vertices, tets = tet_box()
        self.write("box.mesh", medit_text(vertices, tets))
        self.solve("box.mesh")
        path = self.folder / "out" / "onto.vtu"
        path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
        self.assert_fails(self.run_here("check", "out"), INPUT, "onto.vtu")


@unittest.skipUnless((SHARED / "models" / "good").is_dir(), f"no models in {SHARED}")
class OfModels(CheckTest):
    def test_tets_and_grid_agree_on_the_sphere_and_the_notch(self):
        for name, counts in (("sphere_r0.12.mesh", (12, 8, 8)), ("notch5_0.mesh", (1, 0, 2))):
            with self.subTest(name):
                report = self.solve(SHARED / "models" / "good" / name)
                for section in (report["singularity"], report["onto"]["singularity"]):
                    self.assertEqual(tuple(section[key] for key in ("arcs", "nodes", "boundary_ends")), counts)
                    self.assertEqual(section["verdict"], "meshable")
                    self.assertEqual({abs(arc["index"]) for arc in section["arc_list"]}, {0.25})
                self.assertEqual(json.loads(self.check("--json"))["tets"], report["onto"]["singularity"])
                recomputation = OntoRecomputation(SHARED / "models" / "good" / name, self.folder / "out")
                self.assertEqual(recomputation.disagreements(report["onto"]), [])


def prism_stl(polygon, height=1.0):
    """A prism over a convex polygon, counter-clockwise."""
    low, high = [(*p, 0.0) for p in polygon], [(*p, height) for p in polygon]
    triangles = []
    for k in range(len(polygon)):
        following = (k + 1) % len(polygon)
        triangles += [(low[k], low[following], high[following]), (low[k], high[following], high[k])]
    for k in range(1, len(polygon) - 1):
        triangles += [(low[0], low[k + 1], low[k]), (high[0], high[k], high[k + 1])]
    return stl_bytes(triangles)


class OfSolidsThatHexahedraDoNotFit(CheckTest):
    def answer(self, stl, *arguments):
        self.write("part.stl", stl)
        result = self.run_here("solve", "part.stl", "-o", "out", "--resolution", "32", "--quiet", "--no-report", *arguments)
        self.assertIn(result.returncode, (0, NOT_SETTLED))
        report = json.loads((self.folder / "out" / "report.json").read_text())
        self.assertEqual(self.check().splitlines()[0], with_option(report["answer"]))
        return report

    def test_a_knife_edge_is_named_with_its_angle_place_and_mend(self):
        report = self.answer(prism_stl([(0, 0), (3, 0), (3 * math.cos(math.radians(30)), 1.5)]))
        self.assertEqual(report["verdict"], "not_meshable")
        self.assertEqual(report["reasons"][0]["kind"], "knife_edge")
        self.assertEqual(report["reasons"][0]["place"], [0, 0, 0.5])
        self.assertRegex(report["answer"], r"the edge of 30 degrees between patches \d+ and \d+ is too sharp")
        self.assertIn("fillet or a chamfer", report["answer"])
        # The summary says how many patches there are, and where their numbers stand.
        summary = self.run_here("solve", "part.stl", "-o", "out", "--resolution", "8", "--no-report").stdout
        self.assertRegex(summary, r"(?m)^patches    5 between sharp edges, numbered in report.json; a picture: crossgrain render out --colour face$")

    def test_an_edge_of_45_degrees_is_undecided(self):
        report = self.answer(prism_stl([(0, 0), (2, 0), (2, 2)]))
        self.assertEqual(report["verdict"], "undecided")
        self.assertIn("knife_edge", [reason["kind"] for reason in report["reasons"]])

    def test_an_edge_of_60_degrees_has_a_hexahedron(self):
        report = self.answer(prism_stl([(0, 0), (2, 0), (1, math.sqrt(3))]))
        self.assertEqual({crease["hexahedra"] for crease in report["singularity"]["crease_list"]}, {1})
        self.assertEqual({corner["hexahedra"] for corner in report["singularity"]["corner_list"]}, {1})

    def test_the_apex_of_four_creases_has_none(self):
        base = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
        sides = [(base[k], base[(k + 1) % 4], (0, 0, 1)) for k in range(4)]
        report = self.answer(stl_bytes(sides + [(base[0], base[2], base[1]), (base[0], base[3], base[2])]))
        self.assertEqual((report["verdict"], report["reasons"][0]["kind"]), ("not_meshable", "corner"))
        self.assertEqual(report["reasons"][0]["place"], [0, 0, 1])

    def test_walls_of_too_few_cells_are_undecided_and_the_named_resolution_decides(self):
        plate = stl_bytes(box_triangles((2, 1.4, 0.1)))
        report = self.answer(plate)
        self.assertEqual((report["verdict"], report["reasons"][0]["kind"]), ("undecided", "walls"))
        self.assertEqual(report["reasons"][0]["remedy"], "use_resolution")
        resolution = f"{report['reasons'][0]['remedy_number']:.0f}"
        self.assertEqual(self.solve("part.stl", "--resolution", resolution)["verdict"], "meshable")

    def test_rotation_of_the_part_does_not_change_the_answer(self):
        wedge = [(0, 0), (3, 0), (3 * math.cos(math.radians(30)), 1.5)]
        turned = [(x * math.cos(0.4) - y * math.sin(0.4), x * math.sin(0.4) + y * math.cos(0.4)) for x, y in wedge]
        self.assertEqual(self.answer(prism_stl(wedge))["verdict"], self.answer(prism_stl(turned))["verdict"])


class Faults(CheckTest):
    def test_of_what_is_no_field_are_one_line(self):
        self.assert_fails(self.run_here("check", "nothing"), INPUT, "nothing")
        self.assert_fails(self.run_here("check"), USAGE, "DIR")

    def test_of_a_report_with_unknown_names_or_of_an_earlier_schema_are_one_line_and_exit_code_3(self):
        self.write("box.stl", stl_bytes(box_triangles((2, 1, 1.5))))
        sound = self.solve("box.stl", "--resolution", "8")
        finding = {"kind": "holes", "count": 1, "at_least": False, "place": [0, 0, 0], "length": None, "done": "left_out"}
        arc = {"type": "regular", "index": 0.25, "verdict": "meshable", "length": 1, "oblique_length": 0,
               "on_boundary": False, "place": [0, 0, 0], "nodes": []}
        node = {"place": [0, 0, 0], "on_boundary": False, "verdict": "meshable", "arcs": []}
        warning = {"kind": "thin_walls", "text": "walls", "remedy": "raise_resolution"}

        def check(change):
            report = json.loads(json.dumps(sound))
            change(report)
            (self.folder / "out" / "report.json").write_text(json.dumps(report))
            return self.run_here("check", "out")

        lists = ((warning, lambda report: report["warnings"], ("kind", "remedy")),
                 (finding, lambda report: report["input"]["findings"], ("kind", "done")),
                 (arc, lambda report: report["singularity"]["arc_list"], ("type", "verdict")),
                 (node, lambda report: report["singularity"]["node_list"], ("verdict",)))
        for entry, list_of, keys in lists:
            self.assert_succeeds(check(lambda report: list_of(report).append(entry)))
            for key in keys:
                with self.subTest(entry=entry, key=key):
                    self.assert_fails(check(lambda report: list_of(report).append({**entry, key: "odd"})), INPUT,
                                      "report.json", f"'{key}' has the unknown value 'odd'")
        self.assert_fails(check(lambda report: report.update(schema=3)), INPUT, "report.json", "schema 3")


if __name__ == "__main__":
    unittest.main()
