#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Each remedy that names an option is followed on a case that brings it: then it succeeds, or no longer says so."""

import re
import unittest
from pathlib import Path

from fit_test import blocks, medit
from program import CommandTest, box_triangles, medit_text, stl_bytes, tet_box, wavy_rim_triangles
from tets_test import MAKERS

MESSAGES = Path(__file__).resolve().parents[2] / "apps/crossgrain/messages.cpp"

# Remedies that other tests follow, and where.
ELSEWHERE = {
    "kUseHexSize": "hex_test.py",
    "kUseResolution": "check_test.py",
    "kKeepTags": "regions_test.py",
    "kContinueSolve": "interruption_test.py",
    "kAllowReadTime": "cad_test.py",
    "kSolveAnew": "tests/distributed/processes_test.py",
}

# Remedies that none follows, and why.
NOT_FOLLOWED = {
    "kUseEdgeLength": "of fields on tets that leave something undecided, where finer tets may too",
    "kNameOutput": "the command line refuses such names before",
    **dict.fromkeys(["kFreeSpace", "kCheckOutputDisk", "kMoveCheckpoint"], "disks that are full or broken"),
    **dict.fromkeys(["kAwaitSolve", "kGiveCheckpoint"], "several solves or processes at once"),
    **dict.fromkeys(["kReadUnglued", "kSimplifyOrAllowMemory", "kChangeTetSize"], "models on which other programs fail"),
    **dict.fromkeys(["kRaiseResolution", "kLowerResolution"], "walls of a few thousandths, 4 billion cells"),
}


class Followed(CommandTest):
    seen = set()

    def setUp(self):
        super().setUp()
        self.write("box.stl", stl_bytes(box_triangles()))
        self.write("box.mesh", medit_text(*tet_box()))

    def follow(self, remedy, words, failing, following, code=0):
        """What is said once it is followed."""
        self.seen.add(remedy)
        with self.subTest(remedy, command=failing[0]):
            first = self.run_here(*failing)
            self.assertEqual((first.stdout + first.stderr).count(words), 1, first.stdout + first.stderr)
            then = self.run_here(*following)
            self.assertEqual(then.returncode, code, then.stderr)
            self.assertNotIn(words, then.stdout + then.stderr)

    def test_sizes_of_hexahedra_and_tets(self):
        hexahedra = ("hex", "box.mesh", "-o", "out", "--no-report")
        self.follow("kGiveHexSize", "try --size 0.1", [*hexahedra, "--size", "9"], [*hexahedra, "--size", "0.1"])
        self.follow("kTakeLargerHexahedra", "raise --size, or lower --cells", [*hexahedra, "--cells", "1000"], [*hexahedra, "--cells", "4"])
        self.follow("kTakeFewerHexahedra", "raise --size, or allow more memory with --max-memory",
                    [*hexahedra, "--size", "0.02", "--max-memory", "60MB"], [*hexahedra, "--size", "0.5", "--max-memory", "60MB"])

    @unittest.skipUnless(MAKERS, "neither gmsh nor Netgen is installed")
    def test_sizes_of_made_tets(self):
        tets = ("tets", "box.stl", "-o", "out.mesh")
        solve = ("solve", "box.stl", "-o", "out", "--no-report")
        self.follow("kGiveTetSize", "try --size 0.1", [*tets, "--size", "9"], [*tets, "--size", "0.1"])
        self.follow("kTakeLargerTets", "take larger tets with --size or --edges", [*tets, "--size", "0.004"], [*tets, "--size", "0.5"])
        self.follow("kAllowTetTime", "or allow more time with --seconds", [*tets, "--seconds", "0.001"], [*tets, "--edges", "5", "--seconds", "100"])
        self.follow("kGiveTetSize", "try --tet-size 0.1", [*solve, "--tet-size", "9"], [*solve, "--tet-size", "0.1"])
        self.follow("kTakeLargerTets", "take larger tets with --tet-size", [*solve, "--tet-size", "0.004"], [*solve, "--tet-size", "0.5"])

    def test_angles_of_creases(self):
        self.write("rim.stl", stl_bytes(wavy_rim_triangles()))
        words = "where its angle falls to 22 degrees; follow such edges with --crease-angle 20"
        solve = ("solve", "rim.stl", "-o", "out", "--no-report", "--resolution", "16", "--force")
        self.follow("kUseCreaseAngle", words, solve, [*solve, "--crease-angle", "20"])
        if MAKERS:
            tets = ("tets", "rim.stl", "-o", "out.mesh")
            self.follow("kUseCreaseAngle", words, tets, [*tets, "--crease-angle", "20"])
            hexahedra = ("hex", "rim.stl", "-o", "lattice", "--no-report", "--lattice", "--cells", "8", "--force")
            self.follow("kUseCreaseAngle", words, hexahedra, [*hexahedra, "--crease-angle", "20"])

    def test_memory_and_cells(self):
        solve = ("solve", "box.stl", "-o", "out", "--no-report")
        self.follow("kGiveCellSize", "try --cell-size ", [*solve, "--cell-size", "9"], [*solve, "--cell-size", "0.2"])
        self.follow("kUseLessMemory", "or allow more memory with --max-memory", [*solve, "--resolution", "4000", "--max-memory", "60MB"],
                    [*solve, "--resolution", "8", "--max-memory", "2GB"])
        self.follow("kAllowMemory", "allow more memory with --max-memory", [*solve, "--resolution", "8", "--max-memory", "1MB"],
                    [*solve, "--resolution", "8", "--max-memory", "2GB"])

    def test_places_of_output(self):
        solve = ("solve", "box.stl", "--resolution", "8", "--no-report")
        (self.folder / "other").mkdir()
        self.write("other/thing", "")
        self.follow("kChooseFolder", "or write there with --force", [*solve, "-o", "other"], [*solve, "-o", "other", "--force"])
        self.write("file", "")
        self.follow("kClearPlace", "or choose another place with -o", [*solve, "-o", "file"], [*solve, "-o", "out"])
        self.follow("kMakeFolder", "make that folder, or choose another with -o", ["render", "out", "-o", "none/a.png"], ["render", "out", "-o", "a.png"])

    def test_places_that_may_not_be_written(self):
        self.seen.add("kChooseWritablePlace")
        (self.folder / "closed").mkdir(mode=0o555)
        solve = ("solve", "box.stl", "--resolution", "8", "--no-report", "-o")
        self.assertIn("choose a place you may write to with -o", self.run_without_privileges(*solve, "closed/out").stderr)
        self.assert_succeeds(self.run_without_privileges(*solve, "out"))

    def test_results_of_other_commands(self):
        solve = ("solve", "box.mesh", "-o", "out", "--no-report")
        self.follow("kGiveFieldFolder", "give a folder that 'crossgrain solve' or 'crossgrain hex' has written", ["check", "box.mesh"], solve)
        self.assert_succeeds(self.run_here("check", "out"))
        self.write("bricks.mesh", medit(*blocks((2, 2, 2), (2, 1, 1.5))))
        self.follow("kFitHexahedra", "'crossgrain fit' puts them onto a model", ["hex", "bricks.mesh", "-o", "out"],
                    ["fit", "bricks.mesh", "box.stl", "-o", "fitted"])
        self.follow("kMakeHexahedra", "make them with 'crossgrain hex'", ["render", "out", "--hexahedra", "-o", "a.png"],
                    ["hex", "box.mesh", "--cells", "4", "-o", "out", "--no-report"])
        self.assert_succeeds(self.run_here("render", "out", "--hexahedra", "-o", "a.png"))
        self.follow("kTraceStreamlines", "trace lines with 'crossgrain streamlines'", ["render", "out", "--streamlines", "-o", "b.png"],
                    ["streamlines", "out"])
        self.assert_succeeds(self.run_here("render", "out", "--streamlines", "-o", "b.png"))
        cut = ("render", "out", "--view", "front", "-o", "c.png", "--cut")
        self.follow("kTurnView", "choose another --view or --cut", [*cut, "x"], [*cut, "y"])

    @classmethod
    def tearDownClass(cls):
        named = set(re.findall(r"\{Remedy::(k\w+),", MESSAGES.read_text(encoding="utf-8")))
        missing = named - cls.seen - set(ELSEWHERE) - set(NOT_FOLLOWED)
        if MAKERS and missing:
            raise AssertionError(f"remedies that nobody follows: {sorted(missing)}")


if __name__ == "__main__":
    unittest.main()
