#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""crossgrain --version: name and version first, then what this build can do on this machine."""

import os
import shutil
import unittest
from pathlib import Path

from program import PROGRAM, CommandTest, run


def features(**options):
    """{name: value} of the lines behind the first."""
    lines = run("--version", **options).stdout.splitlines()[1:]
    return {line[:19].strip(): line[19:] for line in lines}


class Version(CommandTest):
    def test_is_on_the_first_line_for_scripts(self):
        self.assertRegex(run("--version").stdout.splitlines()[0], r"^crossgrain \d+\.\d+\.\d+$")

    def test_names_the_reader_of_cad_files(self):
        value = features()["CAD files"]
        if value.startswith("yes, by "):
            self.assertTrue(Path(value.removeprefix("yes, by ")).is_file())

    def test_says_that_the_reader_is_missing(self):
        alone = shutil.copy(PROGRAM, self.folder / "alone")
        self.assertEqual(features(program=alone)["CAD files"], "no; the program crossgrain_cad is missing")

    def test_names_the_programs_that_make_tets(self):
        value = features()["tets"]
        if value.startswith("made by "):
            for program in value.removeprefix("made by ").split(" and "):
                self.assertTrue(Path(program).is_file(), program)
        alone = shutil.copy(PROGRAM, self.folder / "alone")
        self.assertEqual(features(program=alone, env={**os.environ, "PATH": ""})["tets"],
                         "read only; gmsh and crossgrain_netgen, which make them, are missing")

    def test_names_the_vectors_that_are_used(self):
        environment = {**os.environ, "CROSSGRAIN_VECTOR_DOUBLES": "2"}
        self.assertRegex(features(env=environment)["vectors"], r"^2 doubles \((SSE2|baseline)\)$")

    def test_names_everything_else_that_builds_differ_in(self):
        self.assertEqual(set(features()), {"harmonics", "CAD files", "tets", "pages, pictures", "several processes", "vectors", "threads"})
        self.assertRegex(features()["threads"], r"^(oneTBB \d+\.\d+|std::thread)")


if __name__ == "__main__":
    unittest.main()
