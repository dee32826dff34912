# SPDX-License-Identifier: Apache-2.0
"""What the tests of the command line program share: running it, folders for it to work in, small models.

The program is named by the environment variable CROSSGRAIN_PROGRAM.
"""

import itertools
import os
import re
import resource
import shutil
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

PROGRAM = os.environ.get("CROSSGRAIN_PROGRAM", "")
NIGHTLY = os.environ.get("CROSSGRAIN_NIGHTLY") == "1"
TIME_LIMIT = 120


# Results that several tests want, by how they are made.
KEPT = tempfile.TemporaryDirectory(prefix="crossgrain-kept-")
FIRST_RESULTS = {}


def of_the_day(items, *chosen):
    """The paths, names or other items that were chosen to stand for all by day; all of them by night."""
    return [item for item in items if NIGHTLY or getattr(item, "name", item) in chosen]


# Above a test that others stand for by day.
by_night = unittest.skipUnless(NIGHTLY, "by night")


def run(*arguments, stdin=b"", program=PROGRAM, **options):
    """The finished process, its output as text."""
    command = [program, *map(str, arguments)]
    result = subprocess.run(command, input=stdin, capture_output=True, timeout=TIME_LIMIT, check=False, **options)
    result.stdout = result.stdout.decode()
    result.stderr = result.stderr.decode()
    return result


def with_option(answer):
    """The answer of a report as `check` words it."""
    return re.sub(r"use a resolution of (\d+)", r"solve with --resolution \1", answer)


def no_more_processes():
    """For a process that has been started: it can start no other, nor a thread."""
    resource.setrlimit(resource.RLIMIT_NPROC, (1, 1))


class CommandTest(unittest.TestCase):
    """A test with a folder of its own, which is the program's current folder too."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="crossgrain-command-")
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def copied_from_first(self, name, key, make):
        """A folder NAME of a result that several tests want: the first makes it here, the others copy it. Returns what make() did."""
        if key not in FIRST_RESULTS:
            made = make()
            kept = Path(KEPT.name) / str(len(FIRST_RESULTS))
            shutil.copytree(self.folder / name, kept)
            FIRST_RESULTS[key] = (kept, made)
            return made
        kept, made = FIRST_RESULTS[key]
        shutil.rmtree(self.folder / name, ignore_errors=True)
        shutil.copytree(kept, self.folder / name)
        return made

    def run_here(self, *arguments, **options):
        return run(*arguments, cwd=self.folder, **options)

    def run_without_privileges(self, *arguments, program=PROGRAM, **options):
        """The superuser may write anywhere and start any number of processes, so the program runs as nobody then."""
        self.folder.chmod(0o777)
        user = {"user": 65534, "group": 65534} if os.getuid() == 0 else {}
        try:
            return run(*arguments, program=program, cwd=self.folder, **user, **options)
        except PermissionError:
            self.skipTest("others than the superuser cannot enter the folder of the program")

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def names(self):
        return sorted(path.name for path in self.folder.iterdir())

    def assert_fails(self, result, code, *words):
        """Exit code, one line on standard error that begins with the program's name and holds all words; on standard output no
        more than the size of the model."""
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stdout, r"\A(onto .*\n)?(model .*\n)?\Z")
        self.assertTrue(result.stderr.startswith("crossgrain: "), result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertTrue(result.stderr.endswith("\n"))
        for word in words:
            self.assertIn(word, result.stderr)

    def assert_succeeds(self, result):
        self.assertEqual(result.returncode, 0, result.stderr)


def without_solve(content):
    """The bytes of a .vtu file but for the solve that it names."""
    return re.sub(rb"<!-- solve [0-9a-f]{16} -->", b"", content)


def without_costs(report):
    """What a solve found, without its name, what it took, and sums of files that tell both."""
    del report["seconds"], report["peak_memory_bytes"], report["solve"], report["files"], report["checksum"]
    report.get("onto", {}).pop("seconds", None)
    for level in report["levels"]:
        del level["seconds"]
    return report


def box_triangles(size=(2.0, 1.0, 1.5)):
    """Twelve triangles, outward."""
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float) * size
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return np.array([corners[list(f)] for a, b, c, d in faces for f in ((a, b, c), (a, c, d))])


def torus_triangles(major=0.6, minor=0.25, around=24, across=12):
    """About an axis that is tilted against the coordinates, outward."""
    phi = 2 * np.pi * np.arange(around) / around
    theta = 2 * np.pi * np.arange(across) / across
    ring = major + minor * np.cos(theta)
    points = np.stack([np.cos(phi)[:, None] * ring, np.sin(phi)[:, None] * ring,
                       np.broadcast_to(minor * np.sin(theta), (around, across))], axis=2)
    points = points @ tilt()
    triangles = []
    for i in range(around):
        for j in range(across):
            a, b = points[i, j], points[(i + 1) % around, j]
            c, d = points[(i + 1) % around, (j + 1) % across], points[i, (j + 1) % across]
            triangles += [(a, b, c), (a, c, d)]
    return np.array(triangles)


def cylinder_triangles(radius=0.55, half_height=0.7, segments=32):
    """About an axis that is tilted against the coordinates, outward."""
    phi = 2 * np.pi * np.arange(segments) / segments
    rims = [np.stack([radius * np.cos(phi), radius * np.sin(phi), np.full(segments, z)], axis=1) @ tilt()
            for z in (-half_height, half_height)]
    low, high = np.array([[0, 0, -half_height], [0, 0, half_height]]) @ tilt()
    triangles = []
    for i in range(segments):
        j = (i + 1) % segments
        triangles += [(rims[0][i], rims[0][j], rims[1][j]), (rims[0][i], rims[1][j], rims[1][i]),
                      (low, rims[0][j], rims[0][i]), (high, rims[1][i], rims[1][j])]
    return np.array(triangles)


def sphere_triangles(rings=12, segments=24):
    """Of radius 1, outward."""
    def point(i, j):
        latitude, longitude = np.pi * i / rings, 2 * np.pi * j / segments
        return np.array([np.sin(latitude) * np.cos(longitude), np.sin(latitude) * np.sin(longitude), np.cos(latitude)])

    triangles = []
    for i in range(rings):
        for j in range(segments):
            a, b, c, d = point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)
            triangles += [(a, b, c)] if i < rings - 1 else []
            triangles += [(a, c, d)] if i > 0 else []
    return np.array(triangles)


def wavy_rim_triangles(around=48):
    """A cylinder under a slanted dome, outward: the angle at its upper rim falls from 55 degrees to 22."""
    phi = 2 * np.pi * np.arange(around) / around
    radii = np.array([0, 10, 20, 20, 19, 18, 16, 14, 12, 10, 8, 6, 4, 2, 0]) / 20
    points = np.stack([radii[:, None] * np.cos(phi), radii[:, None] * np.sin(phi), np.full((len(radii), around), -0.5)], axis=2)
    x = points[3:, :, 0]
    points[3:, :, 2] = (1.64 + 0.97 * x) * (1 - radii[3:, None] ** 2) / 2
    triangles = []
    for i in range(len(radii) - 1):
        for k in range(around):
            a, b, c, d = points[i, k], points[i, k - 1], points[i + 1, k], points[i + 1, k - 1]
            triangles += [(a, c, d)] * bool(radii[i + 1]) + [(a, d, b)] * bool(radii[i])
    return np.array(triangles)


def tet_box(cells=(4, 3, 3), size=(2.0, 1.0, 1.5)):
    """Vertices and tets, numbered from 0, all of positive volume: each of the cells is cut into six around a diagonal."""
    def at(x, y, z):
        return x + (cells[0] + 1) * (y + (cells[1] + 1) * z)

    grid = np.array([[x, y, z] for z in range(cells[2] + 1) for y in range(cells[1] + 1) for x in range(cells[0] + 1)])
    steps = (at(1, 0, 0), at(0, 1, 0), at(0, 0, 1))
    tets = []
    for z, y, x in np.ndindex(cells[::-1]):
        for i, j, k in itertools.permutations(range(3)):
            a = at(x, y, z)
            tet = [a, a + steps[i], a + steps[i] + steps[j], a + sum(steps)]
            tets.append(tet if (j - i) % 3 == 1 else [tet[0], tet[1], tet[3], tet[2]])
    return grid * (np.array(size) / cells), np.array(tets)


def medit_text(vertices, tets):
    """A Medit mesh file."""
    rows = [" ".join(repr(float(x)) for x in vertex) + " 0" for vertex in vertices]
    elements = [" ".join(str(i + 1) for i in tet) + " 1" for tet in tets]
    return "\n".join(["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(rows)), *rows, "Tetrahedra",
                      str(len(elements)), *elements, "End", ""])


def vtk_text(vertices, tets):
    """A legacy VTK file."""
    rows = [" ".join(repr(float(x)) for x in vertex) for vertex in vertices]
    cells = [" ".join(str(i) for i in (4, *tet)) for tet in tets]
    return "\n".join(["# vtk DataFile Version 3.0", "tets", "ASCII", "DATASET UNSTRUCTURED_GRID",
                      f"POINTS {len(rows)} double", *rows, f"CELLS {len(cells)} {5 * len(cells)}", *cells,
                      f"CELL_TYPES {len(cells)}", *["10"] * len(cells), ""])


def tilt():
    """A rotation that has nothing to do with the coordinate axes."""
    quaternion = np.array([0.9, 0.3, -0.2, 0.25])
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def stl_bytes(triangles):
    """A binary STL file; its coordinates are in single precision."""
    records = np.zeros(len(triangles), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("zero", "<u2")]))
    records["corners"] = triangles
    return b"\0" * 80 + struct.pack("<I", len(triangles)) + records.tobytes()
