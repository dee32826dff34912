#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Models of several solids, regions of tets and what tet files tag: the written files against the model, by code of its own.

CROSSGRAIN_CAD_FILES is the program that makes CAD files; without it Crossgrain was built without OpenCASCADE. The comparison
meshes are in the folder that CROSSGRAIN_SHARED names, ../shared beside the project by default; their tests are skipped where
it is absent.
"""

import itertools
import json
import os
import subprocess
import unittest
from pathlib import Path

import numpy as np

from field_reader import Field, read_arrays
from program import TIME_LIMIT, CommandTest, of_the_day, tet_box, tilt

CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared"))
LINE, TRIANGLE, TET = 3, 5, 10


def tagged_vtk_text(vertices, cells):
    """A legacy VTK file of cells (type, vertices, tag)."""
    rows = [" ".join(repr(float(x)) for x in vertex) for vertex in vertices]
    lists = [" ".join(str(i) for i in (len(nodes), *nodes)) for _, nodes, _ in cells]
    return "\n".join(["# vtk DataFile Version 3.0", "tets", "ASCII", "DATASET UNSTRUCTURED_GRID",
                      f"POINTS {len(rows)} double", *rows, f"CELLS {len(cells)} {sum(len(c[1]) + 1 for c in cells)}", *lists,
                      f"CELL_TYPES {len(cells)}", *[str(kind) for kind, _, _ in cells], f"CELL_DATA {len(cells)}",
                      "SCALARS CellEntityIds int 1", "LOOKUP_TABLE default", *[str(tag) for _, _, tag in cells], ""])


def angles_deg(axes, direction):
    """Of directions to the nearest of the axes (row, axis, component)."""
    return np.degrees(np.arccos(np.clip(np.abs(axes @ direction).max(axis=1), 0, 1)))



def without_faces(value):
    """A part of a report without the numbers of faces, which are tags."""
    if isinstance(value, dict):
        return {key: without_faces(item) for key, item in value.items() if key != "faces"}
    return [without_faces(item) for item in value] if isinstance(value, list) else value


class RegionsTest(CommandTest):
    def solve(self, *arguments, folder="out"):
        result = self.run_here("solve", *arguments, "-o", folder, "--no-report")
        self.assert_succeeds(result)
        return json.loads((self.folder / folder / "report.json").read_text())

    def arrays(self, name="field.vtu", folder="out"):
        return read_arrays(self.folder / folder / name)


class OfTets(RegionsTest):
    """A tilted box of two regions, 4 and 9, that meet where the unturned one has x = 1."""

    def setUp(self):
        super().setUp()
        self.vertices, self.tets = tet_box(cells=(8, 6, 6), size=(2.0, 1.2, 1.2))
        self.tags = np.where(self.vertices[self.tets].mean(axis=1)[:, 0] < 1, 4, 9)
        self.turned = self.vertices @ tilt()
        self.write("two.vtk", tagged_vtk_text(self.turned, [(TET, t, tag) for t, tag in zip(self.tets, self.tags)]))
        self.write("one.vtk", tagged_vtk_text(self.turned, [(TET, t, 1) for t in self.tets]))

    def test_each_cell_knows_the_region_that_its_centre_is_in(self):
        report = self.solve("two.vtk", "--resolution", 24)
        field = Field(self.folder / "out" / "field.vtu")
        x = (field.centre @ tilt().T)[:, 0]
        expected = np.where(x < 1, 4, 9)
        # Cells beside the interface with their centre outside the box go by their surface.
        unsure = np.abs(x - 1) < field.size
        regions = field.arrays["region"]
        self.assertTrue((regions == expected)[~unsure].all())
        self.assertEqual([r["region"] for r in report["regions"]], [4, 9])
        for entry in report["regions"]:
            self.assertEqual(entry["cells"], int((regions == entry["region"]).sum()))
            corners = self.turned[self.tets[self.tags == entry["region"]]]
            volume = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).sum() / 6
            self.assertAlmostEqual(entry["volume"], volume, places=9)
        self.assertTrue(report["model"]["watertight"])
        self.assertAlmostEqual(report["interfaces"]["area"], 1.44, places=9)
        self.assertLess(report["interfaces"]["alignment_deg"]["max"], 0.5)
        self.assertEqual(report["warnings"], [])

    def test_tets_keep_their_regions(self):
        self.solve("two.vtk")
        np.testing.assert_array_equal(self.arrays("onto.vtu")["region"], self.tags)

    def test_one_region_is_none_but_keeps_its_number(self):
        report = self.solve("one.vtk")
        self.assertNotIn("regions", report)
        self.assertNotIn("interfaces", report)
        self.assertNotIn("region", self.arrays())
        np.testing.assert_array_equal(self.arrays("onto.vtu")["region"], 1)

    def test_a_union_has_the_field_of_one_solid(self):
        one, union = self.solve("one.vtk", folder="one"), self.solve("two.vtk", "--union", folder="union")
        self.assertEqual(one["energy"], union["energy"])
        self.assertEqual((self.folder / "one" / "onto.frames").read_bytes(),
                         (self.folder / "union" / "onto.frames").read_bytes())
        self.assertNotIn("interfaces", union)
        self.assertEqual([r["region"] for r in union["regions"]], [4, 9])
        # Of one region it changes nothing at all.
        self.solve("one.vtk", "--union", folder="same")
        for name in ("field.vtu", "onto.vtu", "onto.frames"):
            self.assertEqual(*[(self.folder / folder / name).read_bytes() for folder in ("one", "same")])

    def test_threads_and_merged_cells(self):
        results = []
        for threads in (1, 2):
            self.solve("two.vtk", "--resolution", 24, "--threads", threads)
            results.append([(self.folder / "out" / name).read_bytes() for name in ("field.vtu", "onto.vtu")])
        self.assertTrue(results[0] == results[1])
        self.solve("two.vtk", "--resolution", 24, "--output-level", 3)
        self.assertEqual(set(self.arrays()["region"]), {4, 9})


class SlantedRegions(RegionsTest):
    def test_the_frames_on_the_tets_have_an_axis_across_a_slanted_interface(self):
        """Sheared, so that no frame that the outside asks for has an axis across the interface."""
        vertices, tets = tet_box(cells=(12, 8, 8), size=(3.0, 2.0, 2.0))
        tags = np.where(vertices[tets].mean(axis=1)[:, 0] < 1.5, 1, 2)
        inner = (vertices[:, 0] > 0) & (vertices[:, 0] < 3)
        vertices[:, 0] += np.where(inner, 0.4 * (vertices[:, 1] - 1) * np.minimum(vertices[:, 0], 3 - vertices[:, 0]) / 1.5, 0)
        normal = np.array([1, -0.4, 0]) / np.hypot(1, 0.4)
        on = np.abs(vertices @ normal - np.array([1.5, 1, 1]) @ normal) < 1e-9
        within = on & (vertices[:, 1:] > 0).all(axis=1) & (vertices[:, 1:] < 2).all(axis=1)
        self.assertEqual(within.sum(), 49)
        self.write("slanted.vtk", tagged_vtk_text(vertices, [(TET, t, tag) for t, tag in zip(tets, tags)]))
        report = self.solve("slanted.vtk", "--resolution", 48)
        frames = np.loadtxt(self.folder / "out" / "onto.frames").reshape(-1, 3, 3)
        self.assertLess(angles_deg(frames[within], normal).max(), 2e-6)
        self.assertLess(report["interfaces"]["alignment_deg"]["mean"], 1)
        self.assertLess(report["onto"]["normal_deg"]["max"], 2e-6)
        self.solve("slanted.vtk", "--union", folder="union")
        frames = np.loadtxt(self.folder / "union" / "onto.frames").reshape(-1, 3, 3)
        self.assertGreater(angles_deg(frames[within], normal).mean(), 5)


class TaggedFeatures(RegionsTest):
    def test_frames_run_along_tagged_edges_inside_a_block(self):
        vertices, tets = tet_box(cells=(10, 10, 10), size=(1.0, 1.0, 1.0))
        at = lambda x, y, z: x + 11 * (y + 11 * z)  # noqa: E731
        # From one side to the other, slanted by a right angle over two in the plane z = 1/2.
        path = [at(k, k, 5) for k in range(2, 9)]
        cells = [(TET, t, 1) for t in tets] + [(LINE, pair, 3) for pair in zip(path[:-1], path[1:])]
        self.write("block.vtk", tagged_vtk_text(vertices, cells))
        report = self.solve("block.vtk", "--resolution", 32)
        frames = np.loadtxt(self.folder / "out" / "onto.frames").reshape(-1, 3, 3)
        direction = np.array([1, 1, 0]) / np.sqrt(2)
        angles = angles_deg(frames[path], direction)
        self.assertLess(angles[1:-1].max(), 12)
        self.assertAlmostEqual(report["onto"]["feature_edge_deg"]["mean"],
                               np.mean(np.concatenate([angles[:-1], angles[1:]])), delta=5e-6)  # what the arc cosine tells
        self.assertEqual(report["creases"]["curves"], 13)
        # On the grid too.
        points = "\n".join(" ".join(map(str, 0.5 * (vertices[a] + vertices[b]))) for a, b in zip(path[2:-3], path[3:-2]))
        result = self.run_here("sample", "out", "-", stdin=points.encode())
        self.assert_succeeds(result)
        sampled = np.loadtxt(result.stdout.splitlines()).reshape(-1, 3, 3)
        self.assertLess(angles_deg(sampled, direction).max(), 12)

    def test_edges_tagged_on_a_flat_face_leave_its_frames_nothing_to_turn_about(self):
        vertices, tets = tet_box(cells=(8, 8, 4), size=(2.0, 2.0, 1.0))
        at = lambda x, y, z: x + 9 * (y + 9 * z)  # noqa: E731
        path = [at(k, k, 4) for k in range(2, 7)]
        cells = [(TET, t, 1) for t in tets] + [(LINE, pair, 3) for pair in zip(path[:-1], path[1:])]
        self.write("block.vtk", tagged_vtk_text(vertices, cells))
        report = self.solve("block.vtk")
        frames = np.loadtxt(self.folder / "out" / "onto.frames").reshape(-1, 3, 3)
        for direction in (np.array([1, 1, 0]) / np.sqrt(2), np.array([0, 0, 1.0])):
            self.assertLess(angles_deg(frames[path], direction).max(), 2e-6)
        self.assertLess(report["onto"]["feature_edge_deg"]["max"], 2e-6)
        self.assertLess(report["onto"]["normal_deg"]["max"], 2e-6)

    def test_tagged_triangles_inside_are_followed(self):
        vertices, tets = tet_box(cells=(6, 6, 6), size=(1.0, 1.0, 1.0))
        at = lambda x, y, z: x + 7 * (y + 7 * z)  # noqa: E731
        faces = {tuple(sorted(np.delete(tet, k))) for tet in tets for k in range(4)}
        # In the plane x = y, which holds the diagonals that the cubes are cut along.
        places = np.rint(6 * vertices).astype(int)
        sheet = [f for f in faces if (places[list(f), 0] == places[list(f), 1]).all()
                 and (places[list(f)] >= 1).all() and (places[list(f)] <= 5).all()]
        self.assertEqual(len(sheet), 2 * 4 * 4)
        cells = [(TET, t, 1) for t in tets] + [(TRIANGLE, f, 2) for f in sheet]
        self.write("block.vtk", tagged_vtk_text(vertices, cells))
        report = self.solve("block.vtk", "--resolution", 24)
        frames = np.loadtxt(self.folder / "out" / "onto.frames").reshape(-1, 3, 3)
        inside = [at(k, k, z) for k in (2, 3, 4) for z in (2, 3, 4)]
        self.assertLess(angles_deg(frames[inside], np.array([1, -1, 0]) / np.sqrt(2)).max(), 2e-6)
        self.assertAlmostEqual(report["interfaces"]["area"], 4 / 6 * np.sqrt(2) * 4 / 6, places=9)
        # They are no faces between solids, so a union has them too.
        self.assertEqual(self.solve("block.vtk", "--resolution", 24, "--union")["energy"], report["energy"])

    def test_doubled_vertices_are_warned_of(self):
        vertices, tets = tet_box(cells=(4, 2, 2), size=(2.0, 1.0, 1.0))
        right = vertices[tets].mean(axis=1)[:, 0] > 1
        apart = np.where(right[:, None], tets + len(vertices), tets)
        self.write("apart.vtk", tagged_vtk_text(np.vstack([vertices, vertices]), [(TET, t, 1) for t in apart]))
        warnings = self.solve("apart.vtk")["warnings"]
        found = [warning["text"] for warning in warnings if warning["kind"] == "unmerged_vertices"]
        self.assertEqual(len(found), 1, warnings)
        self.assertIn("without sharing vertices: 8;", found[0])


def medit_text(vertices, sections):
    """A Medit file of sections {keyword: [(vertices, tag)]}."""
    rows = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(vertices))]
    rows += [" ".join(repr(float(x)) for x in vertex) + " 0" for vertex in vertices]
    for keyword, cells in sections.items():
        rows += [keyword, str(len(cells)), *(" ".join(str(i + 1) for i in nodes) + f" {tag}" for nodes, tag in cells)]
    return "\n".join([*rows, "End", ""])


class ListsOfEverything(RegionsTest):
    """A bent box whose files list all faces and edges, under one tag, the side of the box or a running number each."""

    def setUp(self):
        super().setUp()
        self.vertices, self.tets = tet_box(cells=(6, 5, 4), size=(1.2, 1.0, 0.8))
        parts = lambda n: sorted({tuple(sorted(c)) for tet in self.tets for c in itertools.combinations(map(int, tet), n)})  # noqa: E731
        self.faces, self.edges = parts(3), parts(2)
        self.turned = (self.vertices + 0.3 * self.vertices[:, 1:2]**2 * [1, 0, 1]) @ tilt()
        self.write("plain.mesh", medit_text(self.turned, {"Tetrahedra": [(t, 1) for t in self.tets]}))

    def sides(self, face):
        """1 to 6 on the boundary, 0 inside."""
        on = [(self.vertices[list(face), k] == end).all() for k, size in enumerate((1.2, 1.0, 0.8)) for end in (0, size)]
        return on.index(True) + 1 if any(on) else 0

    def listed(self):
        tags = {"one": [0] * len(self.faces), "sides": [self.sides(f) for f in self.faces], "numbers": range(len(self.faces))}
        for name, of_faces in tags.items():
            triangles, edges = list(zip(self.faces, of_faces)), [(e, 0) for e in self.edges]
            yield f"{name}.mesh", medit_text(self.turned, {"Edges": edges, "Triangles": triangles,
                                                           "Tetrahedra": [(t, k) for k, t in enumerate(self.tets)]})
            yield f"{name}.vtk", tagged_vtk_text(self.turned, [(LINE, *e) for e in edges] + [(TRIANGLE, *f) for f in triangles]
                                                 + [(TET, t, 1) for t in self.tets])

    def test_leave_the_field_of_the_tets_alone_to_the_bit(self):
        plain = self.solve("plain.mesh", folder="plain")
        self.assertEqual(plain["warnings"], [])
        for name, text in self.listed():
            with self.subTest(name):
                self.write(name, text)
                result = self.run_here("solve", name, "-o", "out", "--quiet")
                self.assert_succeeds(result)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
                for word in (f"warning: {name}: ", "faces inside", f"{len(self.tets)} regions" if name.endswith(".mesh") else "edges of",
                             "--keep-tags"):
                    self.assertIn(word, result.stderr)
                report = json.loads((self.folder / "out" / "report.json").read_text())
                self.assertEqual([w["kind"] for w in report["warnings"]], ["listed_topology"])
                for key in ("energy", "alignment_deg", "creases", "singularity"):
                    self.assertEqual(without_faces(report[key]), without_faces(plain[key]))
                self.assertEqual(*[(self.folder / folder / "onto.frames").read_bytes() for folder in ("plain", "out")])
                for axis in ("axis_u", "axis_v", "axis_w"):
                    np.testing.assert_array_equal(*[self.arrays(folder=folder)[axis] for folder in ("plain", "out")])

    def test_are_followed_if_all_tags_are_kept(self):
        self.write("all.vtk", dict(self.listed())["one.vtk"])
        plain, kept = self.solve("plain.mesh", folder="plain"), self.solve("all.vtk", "--keep-tags")
        self.assertGreater(kept["creases"]["curves"], plain["creases"]["curves"])
        self.assertNotIn("listed_topology", [w["kind"] for w in kept["warnings"]])


@unittest.skipUnless((SHARED / "models" / "good" / "s02u_prism.vtk").exists(), f"no comparison meshes in {SHARED}")
class OfComparisonMeshes(RegionsTest):
    def test_frames_follow_the_tagged_edges_of_a_prism(self):
        report = self.solve(SHARED / "models" / "good" / "s02u_prism.vtk")
        # At the corners two edges are 60 degrees apart, so that no frame follows both.
        self.assertLess(report["onto"]["feature_edge_deg"]["mean"], 3)
        self.assertEqual(report["creases"]["curves"], 9)


@unittest.skipUnless(CAD_FILES, "built without OpenCASCADE")
class OfCad(RegionsTest):
    def setUp(self):
        super().setUp()
        subprocess.run([CAD_FILES, self.folder], capture_output=True, timeout=TIME_LIMIT, check=True)

    def test_glued_boxes_are_two_solids(self):
        for name in of_the_day(("glued.brep", "glued.step"), "glued.step"):
            with self.subTest(name):
                report = self.solve(name, "--resolution", 24)
                self.assertTrue(report["model"]["watertight"])
                self.assertEqual(report["warnings"], [])
                self.assertEqual([r["region"] for r in report["regions"]], [0, 1])
                for entry, volume in zip(report["regions"], (1000, 500)):
                    self.assertAlmostEqual(entry["volume"], volume, places=6)
                self.assertAlmostEqual(report["interfaces"]["area"], 100, places=6)
                self.assertLess(report["interfaces"]["alignment_deg"]["max"], 0.5)
                self.assertLess(report["creases"]["tangent_deg"]["max"], 0.5)
                self.assertEqual(report["creases"]["curves"], 20)
                union = self.solve(name, "--resolution", 24, "--union", folder="union")
                self.assertNotIn("interfaces", union)
                self.assertEqual(union["creases"]["curves"], 16)

    def test_a_core_in_a_sleeve_constrains_both_sides_of_the_face_between(self):
        for name in of_the_day(("sleeve.brep", "sleeve.step"), "sleeve.brep"):
            with self.subTest(name):
                report = self.solve(name, "--resolution", 48)
                self.assertTrue(report["model"]["watertight"])
                self.assertEqual(report["warnings"], [])
                volumes = sorted(entry["volume"] for entry in report["regions"])
                for volume, exact in zip(volumes, (90 * np.pi, 270 * np.pi)):
                    self.assertAlmostEqual(volume / exact, 1, 2)
                self.assertAlmostEqual(report["interfaces"]["area"] / (60 * np.pi), 1, 2)
                self.assertLess(report["interfaces"]["alignment_deg"]["mean"], 1)
                # Just inside and just outside of the face between, a third of a cell away.
                axis = np.array([1, 2, 2]) / 3
                across = np.linalg.svd(axis[None])[2][1:]
                angles = 2 * np.pi * (np.arange(40) + 0.4) / 40
                radial = np.cos(angles)[:, None] * across[0] + np.sin(angles)[:, None] * across[1]
                for radius in (2.91, 3.09):
                    points = np.array([1, 2, 3]) + 5 * axis + radius * radial
                    text = "\n".join(" ".join(map(repr, map(float, point))) for point in points)
                    result = self.run_here("sample", "out", "-", stdin=text.encode())
                    frames = np.loadtxt(result.stdout.splitlines()).reshape(-1, 3, 3)
                    cosines = np.abs(np.einsum("pij,pj->pi", frames, radial)).max(axis=1)
                    self.assertLess(np.degrees(np.arccos(np.clip(cosines, 0, 1))).mean(), 1)

    def test_solids_that_are_not_glued_are_told_of(self):
        report = self.solve("stacked.brep", "--resolution", 24)
        self.assertEqual([r["region"] for r in report["regions"]], [0, 1])
        self.assertEqual([f["kind"] for f in report["input"]["findings"]], ["touching components"])
        self.assertEqual([w["kind"] for w in report["warnings"]], ["touching_solids"])
        self.assertIn("solids touch by faces that are not the same triangles", report["warnings"][0]["text"])


if __name__ == "__main__":
    unittest.main()
