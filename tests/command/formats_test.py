#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`solve --write`: every format read by code of its own (docs/formats.md), and what a folder holds afterwards."""

import itertools
import json
import os
import resource
import unittest

import numpy as np

from field_reader import read_arrays
from program import CommandTest, box_triangles, medit_text, stl_bytes, tet_box, tilt

USAGE, INPUT, OUTPUT = 2, 3, 4
ALWAYS = ["field.vtu", "onto.frames", "onto.vtu", "onto_singularities.vtu", "report.html", "report.json", "singularities.vtu", "surface.vtu"]
FILES = {"mesh": ["onto.mesh"], "fra": ["onto.fra"], "perm": ["onto.perm"], "frame": ["onto.frame"],
         "quaternions": ["onto_tets.quaternions", "onto_vertices.quaternions"], "features": ["onto_features.vtu"]}


class FormatsTest(CommandTest):
    def write_box(self, name="box.mesh", **shape):
        vertices, tets = tet_box(**shape)
        self.write(name, medit_text(vertices @ tilt(), tets))
        return vertices, tets

    def solve(self, *arguments, folder="out"):
        """The report."""
        result = self.run_here("solve", *arguments, "-o", folder)
        self.assert_succeeds(result)
        self.summary = result.stdout
        return json.loads((self.folder / folder / "report.json").read_text())

    def files(self, folder="out"):
        return sorted(os.listdir(self.folder / folder))

    def lines(self, name):
        text = (self.folder / "out" / name).read_text()
        self.assertTrue(text.endswith("\n"))
        return text.splitlines()

    def numbers(self, lines):
        return np.array([[float(word) for word in line.split(" ")] for line in lines])


class Formats(FormatsTest):
    def test_every_format_has_the_frames_of_the_same_field(self):
        vertices, tets = self.write_box()
        self.solve("box.mesh", "--write", "mesh,fra,perm,frame,quaternions,features")
        self.assertEqual(self.files(), sorted(ALWAYS + sum(FILES.values(), [])))
        for name in self.files():
            self.assertIn(name, self.summary)

        fra = self.lines("onto.fra")
        self.assertEqual(fra[:2], ["FRA 1", f"{len(tets)} 3 1"])
        axes = self.numbers(fra[2:]).reshape(-1, 3, 3)
        self.assertEqual(len(axes), len(tets))

        frame = self.lines("onto.frame")
        self.assertEqual(frame[:2] + frame[-1:], ["FRAME", str(len(tets)), "END"])
        np.testing.assert_array_equal(self.numbers(frame[2:-1]).reshape(-1, 3, 3), axes)

        grid = read_arrays(self.folder / "out" / "onto.vtu")
        single = np.stack([grid[f"axis_{name}"] for name in "uvw"], axis=1)  # points, then cells: the last of a name
        np.testing.assert_allclose(single, axes, atol=1e-7)
        vertex_axes = np.loadtxt(self.folder / "out" / "onto.frames").reshape(-1, 3, 3)
        for name, expected in (("onto_tets.quaternions", axes), ("onto_vertices.quaternions", vertex_axes)):
            w, x, y, z = self.numbers(self.lines(name)).T
            first = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)], axis=1)
            np.testing.assert_allclose(first, expected[:, 0], atol=1e-14)

        # The box has no singular edge; whatever its tets call their axes, the matchings make one frame of all.
        perm = self.lines("onto.perm")
        self.assertEqual(perm[0], "PERM 1")
        rows = [[int(word) for word in line.split(" ")] for line in perm[2:]]
        self.assertEqual(perm[1], f"{len(tets)} {len(rows)} 3")
        for a, b, *images in rows:
            for k, image in enumerate(images):
                self.assertGreater(axes[a, k] @ axes[b, abs(image) - 1] * np.sign(image), 0.9)

    def test_numbers_have_17_significant_digits(self):
        self.write_box()
        self.solve("box.mesh", "--write", "fra,frame,quaternions")
        for name in ("onto.fra", "onto.frame", "onto_tets.quaternions", "onto_vertices.quaternions"):
            words = " ".join(self.lines(name)[2:-1]).split(" ")
            self.assertTrue(all(word == f"{float(word):.17g}" for word in words), name)

    def test_features_are_those_of_the_file(self):
        vertices, tets = tet_box()
        at = lambda x, y, z: x + 5 * (y + 4 * z)  # of 4 x 3 x 3 cells
        edges = [(at(0, 0, 0), at(1, 0, 0), 12), (at(2, 1, 1), at(2, 2, 1), 700000)]
        triangle = next(face for tet in tets for face in itertools.combinations(sorted(tet), 3)
                        if sum(set(face) <= set(other) for other in tets.tolist()) == 2)
        sections = ["Edges", "2", *(f"{a + 1} {b + 1} {tag}" for a, b, tag in edges), "Ridges", "1", "1",
                    "Triangles", "1", " ".join(str(v + 1) for v in triangle) + " 31"]
        self.write("box.mesh", medit_text(vertices, tets).replace("End\n", "\n".join([*sections, "End", ""])))
        self.solve("box.mesh", "--write", "features")
        grid = read_arrays(self.folder / "out" / "onto_features.vtu")
        cells = np.split(grid["connectivity"], grid["offsets"][:-1])
        rows = [(tuple(cell.tolist()), int(tag)) for cell, tag in zip(cells, grid["tag"])]
        self.assertIn(((edges[0][0], edges[0][1]), 12), rows)
        self.assertIn((tuple(int(v) for v in triangle), 31), rows)
        self.assertEqual(len(grid["Points"]), len(vertices))
        np.testing.assert_array_equal(grid["types"], [{2: 3, 3: 5}[len(cell)] for cell in cells])

    def test_a_surface_onto_tets_has_them_too(self):
        vertices, tets = tet_box()
        self.write("tets.mesh", medit_text(vertices, tets))
        self.write("box.stl", stl_bytes(box_triangles()))
        self.solve("box.stl", "--onto", "tets.mesh", "--write", "fra")
        self.assertEqual(self.files(), sorted([*ALWAYS, "onto.fra"]))

    def test_what_is_always_written_may_be_asked_for(self):
        self.write_box()
        self.solve("box.mesh", "--write", "vtu,frames,vtu")
        self.assertEqual(self.files(), ALWAYS)

    def test_rows_are_those_of_the_tets_that_are_left(self):
        vertices, tets = tet_box()
        inverted = tets.copy()
        inverted[3] = inverted[3][[0, 1, 3, 2]]
        flat = [0, 1, 5, 6]
        contents = []
        for mesh in (tets, inverted, np.insert(inverted, 5, flat, axis=0)):
            self.write("box.mesh", medit_text(vertices, mesh))
            report = self.solve("box.mesh", "--cell-size", 0.125, "--write", "fra,perm")
            contents.append([(self.folder / "out" / name).read_bytes() for name in ("onto.fra", "onto.perm")])
            warned = [warning["text"] for warning in report["warnings"] if warning["kind"] == "left_out_tets"]
            self.assertEqual(len(warned), 1 if len(mesh) > len(tets) else 0, report["warnings"])
        self.assertIn(f"left out: 1 of {len(tets) + 1}; onto.fra, onto.perm number", warned[0])
        self.assertEqual(contents[0][0], contents[1][0])
        self.assertEqual(len(contents[2][0].splitlines()), 2 + 3 * len(tets))


class FoldersOfFormats(FormatsTest):
    def test_only_the_formats_of_the_last_solve_are_there(self):
        self.write_box()
        self.write("box.stl", stl_bytes(box_triangles()))
        self.solve("box.mesh", "--write", "mesh,fra,perm,frame,quaternions,features")
        (self.folder / "out" / "notes.fra").write_text("mine")
        self.solve("box.mesh", "--write", "perm,quaternions", "--force")
        self.assertEqual(self.files(), sorted([*ALWAYS, "notes.fra", *FILES["perm"], *FILES["quaternions"]]))
        self.solve("box.mesh", "--force")
        self.assertEqual(self.files(), sorted([*ALWAYS, "notes.fra"]))
        self.solve("box.mesh", "--write", "frame", "--force")
        self.solve("box.stl", "--resolution", 8, "--force")
        self.assertEqual(self.files(), ["field.vtu", "notes.fra", "report.html", "report.json", "singularities.vtu", "surface.vtu"])

    def test_a_full_disk_leaves_what_was_there(self):
        def small_files_only():
            resource.setrlimit(resource.RLIMIT_FSIZE, (largest, largest))

        self.write_box()
        self.solve("box.mesh", "--write", "perm,frame", "--no-report")
        files = {name: (self.folder / "out" / name).read_bytes() for name in self.files()}
        # field.vtu, onto.vtu and the like still fit.
        largest = max(len(content) for name, content in files.items() if name != "onto.frame") + 1
        self.assertGreater(len(files["onto.frame"]), largest + 1000)
        result = self.run_here("solve", "box.mesh", "--write", "fra", "-o", "out", "--no-report", preexec_fn=small_files_only)
        self.assert_fails(result, OUTPUT, "onto.fra")
        self.assertEqual({name: (self.folder / "out" / name).read_bytes() for name in self.files()}, files)
        result = self.run_here("solve", "box.mesh", "--write", "fra", "-o", "new/deep", "--no-report", preexec_fn=small_files_only)
        self.assert_fails(result, OUTPUT, "onto.fra")
        self.assertEqual(self.names(), ["box.mesh", "out"])

    def test_the_folder_is_looked_at_before_the_tets(self):
        (self.folder / "out" / "onto.perm").mkdir(parents=True)
        self.write("rubbish.mesh", "rubbish")
        result = self.run_here("solve", "rubbish.mesh", "-o", "out", "--write", "perm")
        self.assert_fails(result, OUTPUT, "onto.perm")
        self.assert_fails(self.run_here("solve", "rubbish.mesh", "-o", "out", "--force"), INPUT, "rubbish.mesh")


class WrongFormats(FormatsTest):
    def test_names_that_are_none_are_refused_with_a_list_of_them(self):
        self.write_box()
        for text in ("hexex", "map", "fra,hexex", "", "fra,", ",fra", "fra perm", "FRA", "fra;perm"):
            with self.subTest(text):
                result = self.run_here("solve", "box.mesh", "--write", text, "-o", "out")
                self.assert_fails(result, USAGE, "--write", "--help", ", ".join(FILES))
        self.assertEqual(self.names(), ["box.mesh"])

    def test_without_tets_there_are_none(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        result = self.run_here("solve", "box.stl", "--write", "fra", "-o", "out")
        self.assert_fails(result, USAGE, "--write", "--onto", "--help")
        self.assertEqual(self.names(), ["box.stl"])


if __name__ == "__main__":
    unittest.main()
