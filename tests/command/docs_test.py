#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every command of README.md and docs/ runs as it is printed, page by page in a folder of its own.

CROSSGRAIN_CAD_FILES is the program that makes the STEP file, CROSSGRAIN_MPI_PROGRAM crossgrain-mpi; without them pages that
need one are skipped.
"""

import os
import re
import select
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

from documented import ROOT, blocks_of, pages, spans_of
from program import PROGRAM, TIME_LIMIT, CommandTest, medit_text, run, stl_bytes, tet_box

CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
MPI_PROGRAM = os.environ.get("CROSSGRAIN_MPI_PROGRAM", "")

# Lines that are not run, by how they begin.
NOT_RUN = {
    "./try.sh": "builds the program and needs the packages of the system",
    "cmake": "builds or installs",
    "packaging/": "builds packages; tests/packages installs them",
    "apt ": "installs packages",
    "PATH=": "names the programs, which the tests have at hand",
    "export OMPI_": "is in the environment of the tests",
    "bench/": "measures for minutes, with meshes of other authors",
    "tests/fuzz/": "runs for minutes, and needs clang",
    "build/fuzz/": "needs a fuzz target and an input that breaks it",
    "docs/figures/make_method_figures.sh": "builds a program; with CROSSGRAIN_BUILD_FIGURES a test of its own",
}

# Programs that a line needs; where one is missing, the line is not run.
OTHER_PROGRAMS = ("gmsh", "integergrid", "python3")

# Modules of Python that a block needs.
OTHER_MODULES = ("mouette",)

# What running text says about a command, without being one to type.
MENTIONS = re.compile(r"\b[A-Z]{2,}\b|^crossgrain \w+( --json)?$")


def is_run(line):
    return line.strip() != "" and not line.startswith(tuple(NOT_RUN))


def is_here(module):
    return subprocess.run(["python3", "-c", f"import {module}"], capture_output=True, check=False).returncode == 0


def angle_iron_triangles(length=400.0):
    """In place of the bracket, all whose points on pages lie in it; so long that few cells are a 128th of it."""
    outline = np.array([(0, 0), (45, 0), (45, 26), (20, 26), (20, 60), (0, 60)], float)  # y, z
    flat = np.array([(0, 1, 2), (0, 2, 3), (0, 3, 5), (3, 4, 5)])
    low, high = (np.column_stack([np.full(len(outline), x), outline]) for x in (0, length))
    sides = [(low[k], low[n], high[n], high[k]) for k, n in zip(range(6), (1, 2, 3, 4, 5, 0))]
    return np.array([*low[flat[:, ::-1]], *high[flat], *(t for a, b, c, d in sides for t in ((a, b, c), (a, c, d)))])


class Page(CommandTest):
    """A folder with all that a page takes for granted: the program, a bracket in models/, part.step, part.mesh, and a point
    and a seed inside both the bracket and the part. A block of JSON is constraints.json."""

    def setUp(self):
        super().setUp()
        places = [self.folder / "bin" / "crossgrain", self.folder / "build" / "release" / "apps" / "crossgrain" / "crossgrain"]
        for place in places:
            place.parent.mkdir(parents=True)
            place.symlink_to(Path(PROGRAM).resolve())
        (self.folder / "models").mkdir()
        self.write("models/bracket.stl", stl_bytes(angle_iron_triangles()))
        (self.folder / "docs" / "figures").mkdir(parents=True)
        if MPI_PROGRAM:
            (places[0].parent / "crossgrain-mpi").symlink_to(MPI_PROGRAM)
        if CAD_FILES:
            self.make_step()
        points, tets = tet_box((8, 6, 4), (40.0, 30.0, 10.0))
        # Not all of its hexahedra are cubes.
        points[:, 0] += 0.6 * (points[:, 1] - 15)
        self.write("part.mesh", medit_text(points, tets))
        self.write("points.txt", "30 20 6\n")
        self.write("seeds.txt", "30 20 6\n")
        mpi = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}
        self.environment = {**os.environ, **mpi, "PATH": f"{places[0].parent}:{os.environ['PATH']}", "BROWSER": "true"}
        self.assignments = ""

    def make_step(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([CAD_FILES, folder], check=True, capture_output=True)
            shutil.copy(Path(folder) / "plate.step", self.folder / "part.step")

    def run_page(self, path):
        """Runs all blocks in order; returns the number of lines that ran."""
        blocks = blocks_of(path)
        for block in blocks:
            if block.language == "json":
                self.write("constraints.json", "\n".join(block.lines))
        ran = 0
        for block in blocks:
            if block.language == "python":
                ran += self.run_python(block.lines, f"{path.name}:{block.first}")
            elif block.language == "sh":
                for offset, line in enumerate(block.lines):
                    ran += self.run_line(line, f"{path.name}:{block.first + offset}")
        return ran

    def run_python(self, lines, place):
        if place.startswith("python.md:") or "import crossgrain as cg" in lines:
            return 0  # of the package: tests/python/documentation_test.py
        if any(module in "\n".join(lines) and not is_here(module) for module in OTHER_MODULES):
            return 0
        result = subprocess.run(["python3", "-c", "\n".join(lines)], cwd=self.folder, capture_output=True, text=True,
                                timeout=TIME_LIMIT, check=False)
        self.assertEqual(result.returncode, 0, f"{place}\n{result.stderr}")
        return 1

    def run_line(self, line, place):
        if re.match(r"\w+=", line):
            self.assignments += line + "\n"
            return 0
        if not is_run(line):
            return 0
        if line.split()[0] in OTHER_PROGRAMS and not shutil.which(line.split()[0]):
            return 0
        if not shutil.which("gmsh") and self.needs_tets(line):
            return 0
        process = subprocess.Popen(["bash", "-c", self.assignments + line], cwd=self.folder, env=self.environment,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        if re.search(r"crossgrain view ", line):
            self.end_when_it_serves(process, place)
        output, errors = (text.decode() for text in process.communicate(timeout=TIME_LIMIT))
        self.assertEqual(process.returncode, 0, f"{place}: {line}\n{output}{errors}")
        self.assertNotRegex(errors, r"\b[1-9]\d* of \d+ .*outside|constraints outside", f"{place}: {line}")
        for name in re.findall(r"#.*\bwrites ([\w./]*\w)", line):
            self.assertTrue((self.folder / name).exists(), f"{place}: {line}")
        return 1

    def needs_tets(self, line):
        """Whether a line makes tets, or looks at hexahedra that lines before it have not made."""
        command = line.split("#")[0]
        missing = [name for name in re.findall(r"\w+\.hexahedra", command) if not (self.folder / name).exists()]
        return missing or re.search(r"crossgrain tets |crossgrain hex \S+\.step|--tets|made\.mesh", command)

    def end_when_it_serves(self, process, place):
        """Sends the Ctrl-C for which `crossgrain view` waits."""
        limit = time.monotonic() + TIME_LIMIT
        self.assertTrue(select.select([process.stdout], [], [], TIME_LIMIT)[0], place)
        self.assertIn(b"http://127.0.0.1:", process.stdout.readline(), place)
        while process.poll() is None and time.monotonic() < limit:
            os.killpg(process.pid, signal.SIGINT)
            time.sleep(0.2)


def page_test(path):
    def test(self):
        if not MPI_PROGRAM and "mpirun" in path.read_text(encoding="utf-8"):
            self.skipTest("Crossgrain was built without MPI, and the page starts several processes")
        if not CAD_FILES and "part.step" in path.read_text(encoding="utf-8"):
            self.skipTest("Crossgrain was built without OpenCASCADE, and the page takes a STEP file")
        self.assertGreater(self.run_page(path), 0)

    return test


for page in pages():
    if any("crossgrain " in line and is_run(line) for block in blocks_of(page) if block.language == "sh" for line in block.lines):
        name = str(page.relative_to(ROOT).with_suffix("")).replace("/", "_").replace("-", "_")
        setattr(Page, f"test_the_commands_of_{name}_run_as_printed", page_test(page))


class RunningText(CommandTest):
    def test_the_commands_in_sentences_run(self):
        """They look at fields of models of other authors, in whose place a box stands."""
        self.write("part.mesh", medit_text(*tet_box()))
        self.assert_succeeds(self.run_here("solve", "part.mesh", "-o", "field"))
        commands = [span for path in pages() for span in spans_of(path) if not MENTIONS.search(span)]
        self.assertGreater(len(commands), 5)
        for command in commands:
            with self.subTest(command=command):
                words = command.split()[1:]
                for folder in (self.folder / word for word in words if word.endswith(".frames")):
                    if not folder.exists():
                        folder.symlink_to("field")
                # Pictures of the default size are most of the work, and drawn on pages.
                small = ("--size", "320x240") if words[0] == "render" else ()
                self.assert_succeeds(run(*words, *small, cwd=self.folder))


class Limits(unittest.TestCase):
    def test_every_limit_names_a_test_that_there_is(self):
        sources = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "tests").rglob("*.cpp"))
        limits, tests = (ROOT / "docs" / "limits.md").read_text(encoding="utf-8").split("\n## Tests\n")
        names = re.findall(r"^\| (?!limit )(.*?) \|", limits, re.MULTILINE)
        listed = re.findall(r"^- (.*): (.*)$", tests, re.MULTILINE)
        self.assertEqual([name for name, _ in listed if name in names], names)
        rows = [row for _, row in listed]
        self.assertGreater(len(rows), 15)
        for row in rows:
            with self.subTest(row):
                suite, name = re.fullmatch(r"`(\w+)\.(\w+)`", row).groups()
                if suite.endswith("_test"):
                    self.assertIn(f"def {name}(", (ROOT / "tests" / "command" / f"{suite}.py").read_text(encoding="utf-8"))
                else:
                    self.assertRegex(sources, rf"TEST(_F|_P)?\({suite}, {name}\)")


if __name__ == "__main__":
    unittest.main()
