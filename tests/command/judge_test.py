#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The answers about fields on tets against those of judge_of_tets.py, which knows only the written files and the rules in
docs/singularities.md: matchings, arcs, nodes, k of creases and F of corners, item by item.

Generated solids, and every tet mesh of the folders hexme and models/good in CROSSGRAIN_SHARED, ../shared beside the project by
default; those are skipped where they are absent.
"""

import copy
import json
import lzma
import os
import unittest
from pathlib import Path

import numpy as np

import tet_solids
from judge_lines import ArcJudgement, Lines
from judge_links import has_disc, has_sphere
from judge_mesh import TetField
from judge_of_tets import JudgeOfTets
from program import CommandTest, medit_text, of_the_day, tet_box, tilt

SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared"))
TET_FORMATS = (".mesh", ".msh", ".vtk")

# By day these stand for all: small ones with and without arcs, nodes, contacts, and creases that cannot be meshed.
CHOSEN = ("s01c_cube.vtk.xz", "s02c_prism.vtk.xz", "s10c_cyl_cutsphere.vtk.xz", "n03c_skijump_box_cyl.vtk.xz", "n09c_pyramid.vtk.xz",
          "rod.msh", "s02u_prism.vtk")


class JudgeTest(CommandTest):
    def solved(self, name, mesh):
        """The folder of its field, and the report."""
        self.assert_succeeds(self.run_here("solve", mesh, "-o", name, "--write", "quaternions", "--quiet", "--no-report"))
        return self.folder / name, json.loads((self.folder / name / "report.json").read_text())

    def solved_solid(self, name, vertices, tets):
        self.write(f"{name}.mesh", medit_text(vertices, tets))
        return self.solved(name, f"{name}.mesh")

    def assert_check_says(self, folder, report):
        checked = json.loads(self.run_here("check", folder, "--json").stdout)
        self.assertEqual((checked["verdict"], checked["reasons"]), (report["verdict"], report["reasons"]))
        self.assertEqual(checked["tets"], report["onto"]["singularity"])


class OfSolids(JudgeTest):
    def assert_agreed(self, verdict, kinds, vertices, tets):
        folder, report = self.solved_solid("solid", vertices, tets)
        self.assertEqual(JudgeOfTets(folder).differences(report), [])
        self.assertEqual((report["verdict"], [reason["kind"] for reason in report["reasons"]]), (verdict, kinds))
        self.assert_check_says(folder, report)

    def test_a_box_can_be_meshed(self):
        self.assert_agreed("meshable", [], *tet_box((6, 5, 5)))

    def test_an_angle_iron_can_be_meshed(self):
        self.assert_agreed("meshable", [], *tet_solids.angle_iron())

    def test_a_prism_over_a_triangle_can_be_meshed_around_an_arc(self):
        self.assert_agreed("meshable", [], *tet_solids.triangular_prism())

    def test_a_pyramid_cannot_as_four_creases_meet_in_its_apex(self):
        self.assert_agreed("not_meshable", ["corner"], *tet_solids.square_pyramid())

    def test_a_wedge_of_30_degrees_cannot_as_its_edge_has_no_hexahedron(self):
        self.assert_agreed("not_meshable", ["knife_edge", "corner"], *tet_solids.wedge(30))

    def test_a_wedge_of_42_degrees_is_undecided_as_rounding_decides(self):
        self.assert_agreed("undecided", ["knife_edge", "corner"], *tet_solids.wedge(42))


class OfFiles(JudgeTest):
    def judge(self, path):
        name = path.name.split(".vtk")[0].split(".m")[0]
        packed = path.suffix == ".xz"
        mesh = self.write(path.stem, lzma.decompress(path.read_bytes())) if packed else path
        folder, report = self.solved(name, mesh)
        self.assert_check_says(folder, report)
        differences = JudgeOfTets(folder).differences(report)
        self.assertEqual(differences, [], "\n".join(differences))

    def judge_all(self, paths):
        for path in of_the_day(sorted(paths), *CHOSEN):
            with self.subTest(path.name):
                self.judge(path)

    @unittest.skipUnless((SHARED / "hexme").is_dir(), f"no meshes in {SHARED / 'hexme'}")
    def test_every_mesh_of_hex_me_if_you_can_is_agreed_on(self):
        self.judge_all((SHARED / "hexme").glob("*.vtk.xz"))

    @unittest.skipUnless((SHARED / "models" / "good").is_dir(), f"no models in {SHARED / 'models' / 'good'}")
    def test_every_tet_mesh_of_the_good_models_is_agreed_on(self):
        self.judge_all(path for path in (SHARED / "models" / "good").iterdir() if path.suffix in TET_FORMATS)


class OfChangedReports(JudgeTest):
    def test_every_changed_item_is_found(self):
        folder, report = self.solved_solid("prism", *tet_solids.triangular_prism())
        judge = JudgeOfTets(folder)
        self.assertEqual(judge.differences(report), [])
        section = ["onto", "singularity"]
        for path, value in [(["verdict"], "undecided"), (["reasons"], [{"kind": "corner", "verdict": "undecided", "count": 1}]),
                            (["onto", "unfollowed_share"], 0.01), ([*section, "edges"], 3), ([*section, "contacts"], 7),
                            ([*section, "unresolved_loops"], 1), ([*section, "unresolved_stubs"], 1),
                            ([*section, "short_arcs"], 1), ([*section, "boundary_ends"], 3),
                            ([*section, "not_meshable_arcs"], 1), ([*section, "verdict"], "undecided"),
                            ([*section, "arc_list", 0, "verdict"], "not_meshable"),
                            ([*section, "arc_list", 0, "index"], -0.25), ([*section, "arc_list", 0, "type"], "changing"),
                            ([*section, "arc_list", 0, "oblique_length"], 1),
                            ([*section, "node_list", 1, "verdict"], "undecided"),
                            ([*section, "node_list", 1, "on_boundary"], False),
                            ([*section, "crease_list", 2, "hexahedra"], 2), ([*section, "crease_list", 2, "followed"], 0.9),
                            ([*section, "crease_list", 2, "angle_deg"], 91.5),
                            ([*section, "crease_list", 2, "verdict"], "undecided"),
                            ([*section, "corner_list", 3, "hexahedra"], 2), ([*section, "corner_list", 3, "arcs"], [3]),
                            ([*section, "corner_list", 3, "creases"], [1, 1, 3]),
                            ([*section, "corner_list", 3, "verdict"], "not_meshable")]:
            changed = copy.deepcopy(report)
            part = changed
            for key in path[:-1]:
                part = part[key]
            part[path[-1]] = value
            with self.subTest(path):
                found = judge.differences(changed)
                self.assertEqual(len(found), 1, found)
                self.assertIn(str([key for key in path if isinstance(key, str)][-1]), found[0])

    def test_a_report_without_a_crease_or_a_corner_is_found(self):
        folder, report = self.solved_solid("prism", *tet_solids.triangular_prism())
        for key in ("crease_list", "corner_list"):
            changed = copy.deepcopy(report)
            changed["onto"]["singularity"][key].pop()
            self.assertEqual(len(JudgeOfTets(folder).differences(changed)), 1, key)


def turn_about(axis, angle):
    axis = np.asarray(axis, float) / np.linalg.norm(axis)
    return np.eye(3) * np.cos(angle) + (1 - np.cos(angle)) * np.outer(axis, axis) + np.sin(angle) * np.cross(np.eye(3), axis)


class OfMadeUpFields(unittest.TestCase):
    """Frames that turn by a known angle around the vertical line through the middle of a tall box."""

    def judged(self, turn, lean=(0, 0), axis=(0, 0, 1), height=24):
        """Type, index and verdict of that line. Frames turn by `turn` around it, in degrees, about an axis that leans by the
        first angle at its low end and by the second at its high end."""
        vertices, tets = tet_box((4, 4, height), (4, 4, height))
        x, y, z = (vertices[tets].mean(axis=1) - [2.01, 2.02, 0]).T
        frames = np.array([turn_about((1, 0, 0), np.radians(np.interp(at, (0, height), lean))) @
                           turn_about(axis, turn / 360 * around) for at, around in zip(z, np.arctan2(y, x))])
        field = TetField(vertices @ tilt(), tets, np.einsum("ji,njk->nik", tilt(), frames))
        lines = Lines(field)
        names = [i for i in np.lexsort(vertices.T) if (vertices[i, :2] == 2).all()]
        edges = [field.number[min(a, b), max(a, b)] for a, b in zip(names[:-1], names[1:])]
        self.assertEqual(set(lines.turns), set(edges))
        arc = ArcJudgement(lines, edges, names, field.points[names])
        return arc.type, arc.index, arc.verdict

    def test_quarter_turns_are_arcs_of_three_and_of_five_hexahedra(self):
        self.assertEqual(self.judged(90), ("regular", 0.25, "meshable"))
        self.assertEqual(self.judged(-90), ("regular", -0.25, "meshable"))

    def test_half_turns_are_arcs_of_six_hexahedra_and_of_two_which_cannot_be(self):
        self.assertEqual(self.judged(-180), ("regular", -0.5, "meshable"))
        self.assertEqual(self.judged(180), ("regular", 0.5, "not_meshable"))

    def test_third_turns_cannot_be(self):
        self.assertEqual(self.judged(120, axis=(1, 1, 1)), ("no_axis", 0, "not_meshable"))

    def test_third_turns_along_two_cells_may_be_two_lines(self):
        self.assertEqual(self.judged(120, axis=(1, 1, 1), height=2), ("no_axis", 0, "undecided"))

    def test_an_oblique_arc_of_one_sense_can_be_meshed(self):
        self.assertEqual(self.judged(90, lean=(70, 70)), ("regular", 0.25, "meshable"))

    def test_an_axis_across_the_arc_leaves_it_undecided(self):
        self.assertEqual(self.judged(90, lean=(85, 95))[2], "undecided")

    def test_an_axis_that_turns_over_along_the_arc_makes_it_impossible(self):
        self.assertEqual(self.judged(90, lean=(0, 180)), ("changing", 0, "not_meshable"))


class OfLinks(unittest.TestCase):
    def test_eleven_nodes_of_lines_of_three_and_five_hexahedra_exist(self):
        # arXiv 2202.09686: (lines of 3, lines of 5), with the regular vertex and the two lines that pass through.
        known = {(0, 0), (2, 0), (0, 2), (4, 0), (2, 2), (1, 3), (0, 4), (2, 6), (0, 6), (0, 8), (0, 12)}
        pairs = [(a, b) for a in range(5) for b in range(13) if has_sphere((3,) * a + (5,) * b)]
        self.assertEqual(set(pairs), known)

    def test_nodes_and_corners_of_more_than_twenty_hexahedra_are_left_open(self):
        self.assertIsNone(has_sphere((5,) * 12 + (6,)))
        self.assertIsNone(has_disc((), (3,) * 17))

    def test_corners_of_common_solids_exist(self):
        for valences, creases in [((), ()), ((), (1, 1)), ((), (1, 1, 1)), ((), (3, 3)), ((), (3, 3, 3)), ((3,), ()), ((5,), ()),
                                  ((), (1, 1, 3)), ((), (4, 4)), ((5, 5), (3, 3, 3, 3))]:
            self.assertEqual(has_disc(valences, creases), True, (valences, creases))

    def test_corners_without_room_do_not(self):
        for valences, creases in [((), (0, 2)), ((), (1, 1, 1, 1)), ((), (1,)), ((), (3,)), ((), (1, 3)), ((), (3, 3, 3, 3)),
                                  ((3,), (1, 1, 1)), ((), (3, 1, 1, 1))]:
            self.assertEqual(has_disc(valences, creases), False, (valences, creases))


if __name__ == "__main__":
    unittest.main()
