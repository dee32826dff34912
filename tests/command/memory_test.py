#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`hex`, `tets` and repairs keep to --max-memory, with the programs that they start: what does not fit is refused before it is made."""

import json
import resource
import subprocess
import time
import unittest

import numpy as np

from program import PROGRAM, TIME_LIMIT, CommandTest, box_triangles, medit_text, stl_bytes, tet_box, torus_triangles
from resident_memory import resident_bytes_with_descendants
from tets_test import MAKERS

LIMIT, PARTIAL, APPROXIMATE = 5, 6, 7
PAUSE_S = 0.005


def sponge(level):
    """Triangles of a Menger sponge of unit cubes."""
    filled = np.ones((1, 1, 1), bool)
    unit = np.indices((3, 3, 3))
    kept = (unit == 1).sum(axis=0) < 2
    for _ in range(level):
        filled = np.kron(filled, kept)
    padded = np.pad(filled, 1)
    triangles = []
    for axis in range(3):
        for side in (0, 1):
            free = ~np.roll(padded, 1 - 2 * side, axis)[1:-1, 1:-1, 1:-1]
            cells = np.argwhere(filled & free)
            u, v = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
            corner = cells + side * np.eye(3, dtype=int)[axis]
            quads = [corner, corner + u, corner + u + v, corner + v][:: 1 if side else -1]
            triangles += [np.stack([quads[0], quads[1], quads[2]], 1), np.stack([quads[0], quads[2], quads[3]], 1)]
    return np.concatenate(triangles)


class MemoryTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("box.mesh", medit_text(*tet_box(size=(4.0, 3.0, 3.0))))

    def peak_of(self, *arguments, codes=(0,)):
        """The largest memory of the program and those that it starts, in bytes."""
        with open(self.folder / "errors", "w+b") as errors:
            process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=errors)
            end, peak = time.monotonic() + TIME_LIMIT, 0
            while process.poll() is None and time.monotonic() < end:
                peak = max(peak, resident_bytes_with_descendants(process.pid))
                time.sleep(PAUSE_S)
            process.kill()
            self.assertIn(process.wait(), codes, (self.folder / "errors").read_text())
        return peak


class WhatDoesNotFit(MemoryTest):
    def refuse(self, *arguments, words):
        before = self.names()
        self.assert_fails(self.run_here(*arguments), LIMIT, "--max-memory", *words)
        self.assertEqual(self.names(), before)

    def test_is_refused_by_the_number_of_hexahedra(self):
        for size, about in (("0.05", "2.9e+05 hexahedra takes 0."), ("0.02", "4.5e+06 hexahedra takes 5.")):
            self.refuse("hex", "box.mesh", "--size", size, "--max-memory", "60MB", "-o", "out",
                        words=["box.mesh: a mesh of about " + about, "0.06 GB are allowed", "raise --size"])

    def test_is_refused_by_the_number_of_tets_before_their_field_is_made(self):
        self.write("fine.mesh", medit_text(*tet_box((20, 20, 20), (4.0, 3.0, 3.0))))
        self.refuse("hex", "fine.mesh", "--cells", "4", "--max-memory", "100MB", "-o", "out", words=["a field on 49140 tets takes 0."])

    def test_is_refused_by_a_repair_too(self):
        self.write("fine.mesh", medit_text(*tet_box((20, 20, 20), (4.0, 3.0, 3.0))))
        self.refuse("solve", "fine.mesh", "--prepare", "--repair", "--max-memory", "70MB", "-o", "out", words=["a repair on 49140 tets takes 0."])

    def test_is_refused_by_the_number_of_triangles_that_hexahedra_are_put_onto(self):
        self.write("torus.stl", stl_bytes(torus_triangles(around=400, across=200)))
        self.refuse("hex", "torus.stl", "--lattice", "--cells", "8", "--max-memory", "100MB", "-o", "out",
                    words=["torus.stl: putting hexahedra onto 160000 triangles takes 0.1"])
        peak = self.peak_of("hex", "torus.stl", "--lattice", "--cells", "8", "--max-memory", "190MB", "-o", "out", "--no-report", codes=(0, APPROXIMATE))
        self.assertLessEqual(peak, 190e6)

    def test_is_refused_by_what_many_creases_take(self):
        self.write("sponge.stl", stl_bytes(sponge(3)))
        lattice = ("hex", "sponge.stl", "--lattice", "--cells", "27", "-o", "out")
        result = self.run_here(*lattice, "--max-memory", "60MB")
        self.assertEqual(result.returncode, LIMIT)
        self.assertIn("fitting a lattice of 8000 cells takes 0.0", result.stderr)
        peak = self.peak_of(*lattice, "--max-memory", "100MB", "--no-report", codes=(0, LIMIT))
        self.assertLessEqual(peak, 100e6)

    @unittest.skipUnless("gmsh" in MAKERS, "gmsh is not installed")
    def test_is_told_of_what_gmsh_takes(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        # The few triangles of the model itself need less.
        result = self.run_here("tets", "box.stl", "--by", "gmsh", "--edges", "60", "--max-memory", "100MB", "-o", "out.mesh")
        self.assertIn("gmsh needs more than the 0.0", result.stderr)
        (self.folder / "out.mesh").unlink(missing_ok=True)
        self.refuse("tets", "box.stl", "--max-memory", "30MB", "-o", "out.mesh", words=["no memory is left to make tets: 0.03 GB are allowed"])


class AddressSpace(MemoryTest):
    """`ulimit -v`, which helpers inherit and do not know of."""

    @unittest.skipUnless("gmsh" in MAKERS, "gmsh is not installed")
    def test_that_does_not_suffice_is_told_as_memory(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        codes = []
        for megabytes in (90, 120, 600, 3000):
            with self.subTest(megabytes=megabytes):
                limits = (1000000 * megabytes,) * 2
                result = self.run_here("tets", "box.stl", "-o", "out.mesh", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, limits))
                codes.append(result.returncode)
                (self.folder / "out.mesh").unlink(missing_ok=True)
                self.assertIn(result.returncode, (0, LIMIT), result.stderr)
                if result.returncode == LIMIT:
                    self.assertRegex(result.stderr, "memory")
        self.assertEqual((codes[0], codes[-1]), (LIMIT, 0))


class RunsThatFit(MemoryTest):
    def test_leave_hexahedra_as_they_are_mapped_where_memory_does_not_suffice_to_fit_them(self):
        # A ridge across the diagonals of hexahedra.
        vertices, tets = tet_box((4, 4, 3), (4.0, 4.0, 3.0))
        vertices[:, 2] *= 1 - 0.12 * abs(vertices[:, 0] - vertices[:, 1])
        self.write("roof.mesh", medit_text(vertices, tets))
        command = ["hex", "roof.mesh", "--cells", "20", "--threads", "2", "--no-report", "-o", "out", "--force"]
        peak = self.peak_of(*command, "--max-memory", "27MB", codes=(APPROXIMATE,))
        self.assertLessEqual(peak, 27e6)
        report = json.loads((self.folder / "out/report.json").read_text())
        self.assertEqual([a_try["way"] for a_try in report["hexahedra"]["fit_tries"]], ["as_mapped"])
        self.assertEqual([warning["kind"] for warning in report["warnings"]].count("attempt_limited"), 1)

    def test_take_seconds_by_their_number(self):
        """In processor seconds, at most ten times what docs/limits.md says."""
        for cells, size in (((4, 3, 3), 0.2), ((10, 10, 10), 1.0)):
            vertices, tets = tet_box(cells, (4.0, 3.0, 3.0))
            self.write("box.mesh", medit_text(vertices, tets))
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            self.assert_succeeds(self.run_here("hex", "box.mesh", "--size", size, "-o", f"out{size}", "--no-report"))
            seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
            self.assertLess(seconds, 10 * (len(tets) + 36 / size**3) / 1000)

    def test_keep_to_their_limits(self):
        runs = [(["hex", "box.mesh", "--size", "0.2"], 32), (["hex", "box.mesh", "--size", "0.1"], 80)]
        self.write("fine.mesh", medit_text(*tet_box((12, 12, 12), (4.0, 3.0, 3.0))))
        runs += [(["hex", "fine.mesh", "--cells", "8"], 80), (["solve", "fine.mesh", "--prepare", "--repair"], 60)]
        if MAKERS:
            self.write("box.stl", stl_bytes(box_triangles()))
            runs += [(["hex", "box.stl", "--cells", "6"], 90), (["solve", "box.stl", "--tet-size", "0.3"], 90)]
        for arguments, limit in runs:
            with self.subTest(arguments):
                peak = self.peak_of(*arguments, "--threads", "2", "--no-report", "-o", "out", "--force", "--max-memory", f"{limit}MB")
                self.assertLessEqual(peak, limit * 1e6)


if __name__ == "__main__":
    unittest.main()
