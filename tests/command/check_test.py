#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`crossgrain check`, and the files of singular lines that it judges."""

import json
import os
import unittest
from pathlib import Path

from field_reader import read_arrays
from program import CommandTest, box_triangles, cylinder_triangles, medit_text, stl_bytes, tet_box
from recompute_onto import OntoRecomputation
from recompute_singularity import Graph, graph_faults

USAGE, INPUT = 2, 3
SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared"))


class CheckTest(CommandTest):
    def solve(self, name, *arguments):
        self.assert_succeeds(self.run_here("solve", name, "-o", "out", "--quiet", *arguments))
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

    def test_says_in_ten_lines_that_a_cylinder_is_meshable(self):
        lines = self.check().splitlines()
        self.assertLessEqual(len(lines), 10)
        self.assertTrue(lines[-1].startswith("MESHABLE"))
        self.assertIn(["arcs", "4"], [line.split() for line in lines])
        self.assertIn(["ends", "on", "the", "surface", "8"], [line.split() for line in lines])

    def test_prints_what_the_report_has(self):
        self.assertEqual(json.loads(self.check("--json")), {"grid": self.report["singularity"]})

    def test_the_file_has_four_arcs_of_index_a_quarter(self):
        graph = Graph(self.folder / "out" / "singularities.vtu")
        self.assertEqual(list(graph.arrays["index"]), [0.25] * 4)
        self.assertEqual(list(graph.arrays["on_boundary"]), [1] * 4)
        self.assertEqual(graph_faults("singularity", self.report["singularity"], self.folder / "out" / "singularities.vtu"), [])

    def test_judges_the_field_and_not_what_the_report_says_of_it(self):
        path = self.folder / "out" / "report.json"
        report = json.loads(path.read_text())
        report["singularity"]["meshable"] = False
        path.write_text(json.dumps(report))
        self.assertTrue(self.check().splitlines()[-1].startswith("MESHABLE"))


class OfABox(CheckTest):
    def test_has_no_lines_and_is_meshable(self):
        self.write("box.stl", stl_bytes(box_triangles((2, 1, 1.5))))
        report = self.solve("box.stl", "--resolution", "8")
        self.assertEqual((report["singularity"]["arcs"], report["singularity"]["meshable"]), (0, True))
        arrays = read_arrays(self.folder / "out" / "singularities.vtu")
        self.assertEqual((len(arrays["Points"]), len(arrays["offsets"])), (0, 0))
        self.assertIn("MESHABLE", self.check())


class OfTets(CheckTest):
    def test_judges_the_tets_and_shows_the_grid_beside(self):
        vertices, tets = tet_box()
        self.write("box.mesh", medit_text(vertices, tets))
        report = self.solve("box.mesh")
        lines = self.check().splitlines()
        self.assertEqual(lines[1].split(), ["tets", "grid"])
        self.assertEqual(json.loads(self.check("--json")),
                         {"grid": report["singularity"], "tets": report["onto"]["singularity"]})

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
                    self.assertTrue(section["meshable"])
                    self.assertEqual({abs(arc["index"]) for arc in section["arc_list"]}, {0.25})
                self.assertEqual(json.loads(self.check("--json"))["tets"], report["onto"]["singularity"])
                recomputation = OntoRecomputation(SHARED / "models" / "good" / name, self.folder / "out")
                self.assertEqual(recomputation.disagreements(report["onto"]), [])


@unittest.skipUnless((SHARED / "models" / "good").is_dir(), f"no models in {SHARED}")
class OfAModelThatIsNotMeshable(CheckTest):
    def test_names_the_first_fault_and_its_place(self):
        # Walls of a cell or two, in which lines meet that no hexahedra can have.
        section = self.solve(SHARED / "models" / "good" / "platonic_shelf.obj", "--resolution", "64")["singularity"]
        self.assertFalse(section["meshable"])
        self.assertGreater(section["not_meshable_arcs"], 0)
        number, arc = next((k, arc) for k, arc in enumerate(section["arc_list"]) if arc["verdict"] == "not_meshable")
        x, y, z = (f"{value:.6g}" for value in arc["place"])
        self.assertIn(f"NOT MESHABLE; first arc {number} at ({x}, {y}, {z}): its frames", self.check().splitlines()[-1])


class Faults(CheckTest):
    def test_of_what_is_no_field_are_one_line(self):
        self.assert_fails(self.run_here("check", "nothing"), INPUT, "nothing")
        self.assert_fails(self.run_here("check"), USAGE, "DIR")

    def test_of_a_report_with_unknown_names_or_of_an_earlier_schema_are_one_line_and_exit_code_3(self):
        self.write("box.stl", stl_bytes(box_triangles((2, 1, 1.5))))
        sound = self.solve("box.stl", "--resolution", "8", "--no-report")
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
