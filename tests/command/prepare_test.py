#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`solve --prepare`, `--write mesh` and `--hex-size`, recomputed from the written files by code of its own.

The meshes of Hex-Me-If-You-Can are in the folder that CROSSGRAIN_SHARED names, ../shared beside the project by default; their
tests are skipped where it is absent.
"""

import itertools
import json
import lzma
import os
import shutil
import subprocess
import unittest
from pathlib import Path

import numpy as np

from program import CommandTest, box_triangles, medit_text, stl_bytes, tet_box, tilt

USAGE = 2
SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared"))
FACES = [(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)]
EDGES = list(itertools.combinations(range(4), 2))


def read_medit(path):
    """Vertices, tets from 0, and their references, of a file with nothing else."""
    lines = path.read_text().splitlines()
    assert lines[:3] == ["MeshVersionFormatted 2", "Dimension 3", "Vertices"] and lines[-1] == "End"
    count = int(lines[3])
    assert lines[4 + count] == "Tetrahedra" and int(lines[5 + count]) == len(lines) - count - 7
    vertices = np.array([line.split(" ") for line in lines[4:4 + count]], float)
    tets = np.array([line.split(" ") for line in lines[6 + count:-1]], int)
    assert vertices.shape[1] == 4 and tets.shape[1] == 5
    return vertices[:, :3], tets[:, :4] - 1, tets[:, 4]


def volumes(vertices, tets):
    return np.linalg.det(vertices[tets[:, 1:]] - vertices[tets[:, :1]]) / 6


def boundary_of(tets, regions=None):
    """Sorted faces of one tet, or of tets of two regions; and how many of them each tet has."""
    faces = np.sort(tets[:, FACES].reshape(-1, 3), axis=1)
    _, number, count = np.unique(faces, axis=0, return_inverse=True, return_counts=True)
    is_held = count == 1
    if regions is not None:
        of_face = np.repeat(regions, 4)
        low, high = np.full(len(count), 2**30), np.full(len(count), -2**30)
        np.minimum.at(low, number, of_face)
        np.maximum.at(high, number, of_face)
        is_held |= low != high
    return faces[is_held[number]], is_held[number].reshape(-1, 4).sum(axis=1)


def edge_keys(edges):
    return {tuple(edge) for edge in np.sort(edges, axis=1).tolist()}


class PrepareTest(CommandTest):
    def solve(self, *arguments, folder="out"):
        """The report."""
        result = self.run_here("solve", *arguments, "-o", folder, "--no-report", "--verbose")
        self.assert_succeeds(result)
        self.summary = result.stdout
        return json.loads((self.folder / folder / "report.json").read_text())

    def mesh(self, folder="out"):
        return read_medit(self.folder / folder / "onto.mesh")

    def assert_prepared(self, tets, regions=None):
        """No edge, face or tet has all its vertices on the boundary without being part of it."""
        faces, of_tet = boundary_of(tets, regions)
        self.assertLessEqual(of_tet.max(), 1)
        is_held = np.zeros(tets.max() + 1, bool)
        is_held[faces] = True
        self.assertLess(is_held[tets].sum(axis=1).max(), 4)
        inner = tets[:, EDGES].reshape(-1, 2)
        inner = edge_keys(inner[is_held[inner].all(axis=1)])
        self.assertEqual(inner - edge_keys(faces[:, list(itertools.combinations(range(3), 2))].reshape(-1, 2)), set())
        all_faces = np.sort(tets[:, FACES].reshape(-1, 3), axis=1)
        on = {tuple(face) for face in all_faces[is_held[all_faces].all(axis=1)].tolist()}
        self.assertEqual(on - {tuple(face) for face in faces.tolist()}, set())


class PreparedTets(PrepareTest):
    def setUp(self):
        super().setUp()
        self.vertices, self.tets = tet_box()
        self.vertices = self.vertices @ tilt()
        self.write("box.mesh", medit_text(self.vertices, self.tets))

    def test_have_at_most_one_face_on_the_surface_and_the_same_volume(self):
        report = self.solve("box.mesh", "--prepare", "--write", "mesh")
        vertices, tets, references = self.mesh()
        self.assertGreater(volumes(vertices, tets).min(), 0)
        self.assertAlmostEqual(volumes(vertices, tets).sum(), 3, 12)
        self.assert_prepared(tets)
        self.assertTrue((references == 1).all())
        np.testing.assert_array_equal(vertices[:len(self.vertices)], self.vertices)
        onto, prepared = report["onto"], report["onto"]["prepared"]
        self.assertEqual((onto["vertices"], onto["tets"]), (len(vertices), len(tets)))
        self.assertEqual((prepared["vertices_before"], prepared["tets_before"]), (len(self.vertices), len(self.tets)))
        splits = prepared["split_edges"] + prepared["split_faces"] + prepared["split_tets"]
        self.assertEqual(splits, len(vertices) - len(self.vertices))
        self.assertEqual(prepared["refused_splits"], 0)
        self.assertIn(f"{len(tets)}, split from {len(self.tets)} for a map", self.summary)

    def test_are_those_of_all_other_files(self):
        self.solve("box.mesh", "--prepare", "--write", "mesh,fra,perm,frame,quaternions")
        vertices, tets, _ = self.mesh()
        folder = self.folder / "out"
        self.assertEqual((folder / "onto.fra").read_text().splitlines()[1], f"{len(tets)} 3 1")
        self.assertEqual((folder / "onto.frame").read_text().splitlines()[1], str(len(tets)))
        self.assertEqual(len(np.loadtxt(folder / "onto.frames")), len(vertices))
        self.assertEqual(len(np.loadtxt(folder / "onto_tets.quaternions")), len(tets))
        faces = [{tuple(sorted(face)) for face in tet} for tet in tets[:, FACES].tolist()]
        rows = [line.split(" ") for line in (folder / "onto.perm").read_text().splitlines()[2:]]
        for a, b, *_ in rows:
            self.assertTrue(faces[int(a)] & faces[int(b)])

    def test_can_be_solved_again(self):
        self.solve("box.mesh", "--prepare", "--write", "mesh")
        report = self.solve("out/onto.mesh", "--write", "mesh", folder="again")
        self.assertEqual(report["warnings"], [])
        self.assertNotIn("prepared", report["onto"])
        for one, other in zip(self.mesh(), self.mesh("again")):
            np.testing.assert_array_equal(one, other)

    def test_are_prepared_once(self):
        self.solve("box.mesh", "--prepare", "--write", "mesh")
        prepared = self.solve("out/onto.mesh", "--prepare", folder="again")["onto"]["prepared"]
        self.assertEqual([prepared[f"split_{what}"] for what in ("edges", "faces", "tets")], [0, 0, 0])

    def test_may_be_those_of_onto(self):
        self.write("box.stl", stl_bytes(box_triangles() @ tilt()))
        report = self.solve("box.stl", "--onto", "box.mesh", "--prepare", "--write", "mesh")
        self.assertEqual(report["onto"]["prepared"]["tets_before"], len(self.tets))
        self.assert_prepared(self.mesh()[1])

    def test_have_walls_between_regions_unless_these_are_one(self):
        centres = self.vertices[self.tets].mean(axis=1) @ tilt().T
        regions = np.where(centres[:, 0] < 1, 3, 8)
        text = medit_text(self.vertices, self.tets).splitlines()
        first = text.index("Tetrahedra") + 2
        for t, region in enumerate(regions):
            text[first + t] = text[first + t].rsplit(" ", 1)[0] + f" {region}"
        self.write("regions.mesh", "\n".join([*text, ""]))
        self.solve("regions.mesh", "--prepare", "--write", "mesh")
        _, tets, found = self.mesh()
        self.assertEqual(set(found), {3, 8})
        self.assert_prepared(tets, found)
        self.solve("regions.mesh", "--prepare", "--write", "mesh", "--union", folder="union")
        _, united, _ = self.mesh("union")
        self.assert_prepared(united)
        self.assertLess(len(united), len(tets))

    @unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")
    def test_are_read_by_gmsh_with_the_same_numbers(self):
        self.solve("box.mesh", "--prepare", "--write", "mesh")
        vertices, tets, _ = self.mesh()
        subprocess.run(["gmsh", "-v", "0", "-save", "-format", "vtk", "-o", "gmsh.vtk", "out/onto.mesh"], cwd=self.folder, check=True)
        words = (self.folder / "gmsh.vtk").read_text().split()
        points, cells = words.index("POINTS"), words.index("CELLS")
        self.assertEqual(int(words[points + 1]), len(vertices))
        numbers = np.array(words[points + 3:points + 3 + vertices.size], float).reshape(-1, 3)
        np.testing.assert_allclose(numbers, vertices, atol=1e-14)
        self.assertEqual(int(words[cells + 1]), len(tets))
        read = np.array(words[cells + 3:cells + 3 + 5 * len(tets)], int).reshape(-1, 5)
        np.testing.assert_array_equal(read[:, 1:], tets)


class SizeOfHexahedra(PrepareTest):
    def axes(self, name):
        lines = (self.folder / "out" / name).read_text().splitlines()
        rows = lines[2:] if name.endswith("fra") else lines[2:-1]
        return np.array([word for line in rows for word in line.split(" ")], float).reshape(-1, 3, 3)

    def test_divides_the_axes_of_fra_and_leaves_frame(self):
        self.write("box.mesh", medit_text(*tet_box()))
        self.solve("box.mesh", "--write", "fra,frame")
        unit = self.axes("onto.fra")
        self.solve("box.mesh", "--write", "fra,frame", "--hex-size", "0.3")
        np.testing.assert_array_equal(self.axes("onto.fra"), unit / 0.3)
        np.testing.assert_array_equal(self.axes("onto.frame"), unit)

    def test_is_the_edge_of_hexahedra_along_each_axis_of_a_box(self):
        # The integral of an axis along a side of the box is the number of hexahedra there.
        self.write("box.mesh", medit_text(*tet_box(size=(2.0, 1.0, 1.5))))
        self.solve("box.mesh", "--write", "fra", "--hex-size", "0.25")
        axes = self.axes("onto.fra")
        for side, count in (((2, 0, 0), 8), ((0, 1, 0), 4), ((0, 0, 1.5), 6)):
            np.testing.assert_allclose(np.abs(axes @ side).max(axis=1), count, atol=1e-4)


class WrongUse(PrepareTest):
    def test_of_prepare_without_tets_is_told_in_a_line(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        self.assert_fails(self.run_here("solve", "box.stl", "--prepare", "-o", "out"), USAGE, "--prepare", "--onto", "--help")
        self.assertEqual(self.names(), ["box.stl"])

    def test_of_sizes_is_told_in_a_line(self):
        self.write("box.mesh", medit_text(*tet_box()))
        for size in ("0", "-1", "nan", "inf", "wide"):
            self.assert_fails(self.run_here("solve", "box.mesh", "--write", "fra", "--hex-size", size), USAGE, "--hex-size", "--help")
        for formats in ([], ["--write", "frame,mesh"]):
            self.assert_fails(self.run_here("solve", "box.mesh", *formats, "--hex-size", "2"), USAGE, "--hex-size", "--write fra", "--help")
        self.assertEqual(self.names(), ["box.mesh"])


@unittest.skipUnless((SHARED / "hexme").is_dir(), "the meshes of Hex-Me-If-You-Can are not there")
class HexMe(PrepareTest):
    def prepared(self, name):
        self.write(name + ".vtk", lzma.decompress((SHARED / "hexme" / (name + ".vtk.xz")).read_bytes()))
        return self.solve(name + ".vtk", "--prepare", "--write", "mesh")

    def test_meshes_are_prepared(self):
        for name in ("s02c_prism", "s04c_tetrahedron", "s10c_cyl_cutsphere", "n09c_pyramid", "i17c_s20"):
            with self.subTest(name):
                report = self.prepared(name)
                vertices, tets, _ = self.mesh()
                self.assertGreater(volumes(vertices, tets).min(), 0)
                self.assert_prepared(tets)
                self.assertEqual(report["onto"]["prepared"]["refused_splits"], 0)

    def test_lines_of_round_bodies_do_not_touch_them(self):
        for name, before in (("s15c_cylinder", 50), ("s17c_sphere", 50)):
            with self.subTest(name):
                self.assertEqual(self.prepared(name)["onto"]["singularity"]["contacts"], 0)
                plain = self.solve(name + ".vtk", folder="plain")
                self.assertGreater(plain["onto"]["singularity"]["contacts"], before)


if __name__ == "__main__":
    unittest.main()
