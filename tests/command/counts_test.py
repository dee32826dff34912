# SPDX-License-Identifier: Apache-2.0
"""The counts of singular lines and nodes of a field on tets: the same in `check`, in the legend of a picture and in the page; and
those of the grid from which it started where that is asked for.

Models of CROSSGRAIN_SHARED, ../shared beside the project by default, are skipped where they are absent.
"""

import json
import lzma
import os
import re
import struct
import unittest
from collections import Counter
from pathlib import Path

import tet_solids
from page_reader import Page
from program import CommandTest, medit_text, tet_box

SHARED = Path(os.environ.get("CROSSGRAIN_SHARED", Path(__file__).resolve().parents[3] / "shared"))

# Kinds of lines by index, as the legend of a picture names them.
LINES = {0.25: "index +1/4", -0.25: "index −1/4", -0.5: "index −1/2"}


def description_of(path):
    """The text "Description" of a PNG file."""
    data, at = path.read_bytes(), 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"iTXt" and body.startswith(b"Description\0"):
            return body.split(b"\0", 5)[5].decode()
        at += 12 + size
    raise AssertionError("the picture has no description")


def counts_in_legend(text):
    """Lines by index, nodes and ends, as numbers in parentheses."""
    def number(words):
        return sum(int(count) for count in re.findall(r"\n  " + re.escape(words) + r"[^\n]*\((\d+)\)", text))

    return {**{name: number(name) for name in LINES.values()}, "nodes": number("node: lines meet"),
            "ends": number("end on the surface")}


def counts_of(indices, nodes, ends):
    counts = Counter(LINES.get(index) for index in indices)
    return {**{name: counts[name] for name in LINES.values()}, "nodes": nodes, "ends": ends}


def counts_in_check(graph):
    return counts_of([arc["index"] for arc in graph["arc_list"]], graph["nodes"], graph["boundary_ends"])


def counts_in_page(page, prefix=""):
    arrays = page.arrays
    return counts_of([float(index) for index in arrays[prefix + "arc_index"]],
                     int((arrays[prefix + "node_degree"] > 1).sum()), int(arrays[prefix + "node_on_boundary"].sum()))


class CountsTest(CommandTest):
    def solved(self, mesh):
        self.assert_succeeds(self.run_here("solve", mesh, "-o", "a.frames", "--quiet"))
        return json.loads(self.run_here("check", "a.frames", "--json").stdout)

    def legend(self, *arguments):
        self.assert_succeeds(self.run_here("render", "a.frames", "--size", "900x700", "-o", "a.png", "--quiet", *arguments))
        return description_of(self.folder / "a.png")

    def assert_same_counts(self, mesh):
        checked = self.solved(mesh)
        legend = self.legend()
        page = Page(self.folder / "a.frames" / "report.html")
        expected = counts_in_check(checked["tets"])
        self.assertEqual(counts_in_legend(legend), expected)
        self.assertEqual(counts_in_page(page), expected)
        self.assertEqual(counts_in_page(page, "grid_"), counts_in_check(checked["grid"]))
        grid = self.legend("--field", "grid")
        self.assertEqual(counts_in_legend(grid), counts_in_check(checked["grid"]))
        self.assertIn("Answer: ", legend)
        self.assertNotIn("tarting grid", legend)
        self.assertNotIn("Answer: ", grid)
        self.assertIn("Starting grid", grid)
        self.assertEqual("Singular lines of the starting grid" in grid, checked["grid"]["arcs"] > 0)


class OfSolids(CountsTest):
    def test_of_a_prism_over_a_triangle(self):
        self.write("prism.mesh", medit_text(*tet_solids.triangular_prism()))
        self.assert_same_counts("prism.mesh")

    def test_of_a_pyramid(self):
        self.write("pyramid.mesh", medit_text(*tet_solids.square_pyramid()))
        self.assert_same_counts("pyramid.mesh")


class OfFiles(CountsTest):
    def test_of_five_meshes(self):
        names = ("hexme/i10c_simp.vtk.xz", "hexme/s05c_cube_sphere.vtk.xz", "models/good/sphere_r0.12.mesh",
                 "models/good/rod.msh", "models/good/s02u_prism.vtk")
        paths = [SHARED / name for name in names if (SHARED / name).exists()]
        if not paths:
            self.skipTest(f"no tet meshes in {SHARED}")
        for path in paths:
            with self.subTest(path.name):
                packed = path.suffix == ".xz"
                self.assert_same_counts(self.write(path.stem, lzma.decompress(path.read_bytes())) if packed else path)


class OfAGrid(CountsTest):
    def test_there_are_no_tets_to_ask_for(self):
        self.write("prism.mesh", medit_text(*tet_solids.triangular_prism()))
        self.assert_succeeds(self.run_here("solve", "prism.mesh", "-o", "a.frames", "--quiet"))
        for name in ("onto.vtu", "onto.frames", "onto_singularities.vtu"):
            (self.folder / "a.frames" / name).unlink()
        self.assert_fails(self.run_here("render", "a.frames", "--field", "tets", "-o", "a.png"), 3, "no field on tets")


class OfRegions(CountsTest):
    def two_regions(self):
        vertices, tets = tet_box((6, 4, 4))
        tags = 1 + (vertices[tets].mean(axis=1)[:, 0] > 1)
        rows = medit_text(vertices, tets).split("\n")
        begin = rows.index("Tetrahedra") + 2
        for row, tag in enumerate(tags, begin):
            rows[row] = rows[row].rsplit(" ", 1)[0] + f" {tag + 10}"
        return "\n".join(rows)

    def test_the_legend_names_them_for_tets_and_grid(self):
        self.write("two.mesh", self.two_regions())
        self.solved("two.mesh")
        for arguments in ((), ("--field", "grid"), ("--field", "grid", "--cut", "y")):
            self.assertIn("Regions (2)\n  11\n  12\n", self.legend("--colour", "region", *arguments))

    def test_one_region_is_not_worth_colours(self):
        self.write("one.mesh", medit_text(*tet_box((4, 4, 4))))
        self.solved("one.mesh")
        self.assert_fails(self.run_here("render", "a.frames", "--colour", "region"), 2, "only one region")


if __name__ == "__main__":
    unittest.main()
