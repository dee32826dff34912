#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Models and results with damage at random places: whatever the bytes are, `hex`, `tets`, repairs and all commands that read a folder
end with a documented exit code and words of the program, which a sanitizer's report is not.

CROSSGRAIN_MUTATIONS is the number of damaged inputs of each test: 1,000 by night, which takes hours under sanitizers; CROSSGRAIN_SEED
the number of the first.
"""

import os
import random
import shutil
import signal
import subprocess
import unittest
from pathlib import Path

from damage_test import BAD
from program import NIGHTLY, PROGRAM, CommandTest, box_triangles, medit_text, stl_bytes, tet_box, vtk_text
from mutation import mutated

MUTATIONS = int(os.environ.get("CROSSGRAIN_MUTATIONS", "1000" if NIGHTLY else "3"))
SEED = int(os.environ.get("CROSSGRAIN_SEED", "1"))

DONE, INPUT, OUTPUT, LIMIT, PARTIAL, APPROXIMATE, INTERRUPTED = 0, 3, 4, 5, 6, 7, 130

# A damaged model may be fine and large: it is interrupted then, and ends.
TIME_S, TIME_TO_END_S = 20, 30
FEW = ("--no-report", "--quiet", "--max-memory", "4GB")
COMMANDS_OF_MODELS = [("hex", "--cells", 3, *FEW), ("hex", "--lattice", "--cells", 3, *FEW), ("tets", "--edges", 3), ("solve", "--resolution", 6, *FEW)]
TET_FILES = {".mesh", ".vtk", ".msh"}
BAD_FILES = [path for path in sorted(BAD.glob("*.*")) if path.name != "MANIFEST.tsv"]
COMMANDS_OF_RESULTS = [("check", "out"), ("sample", "out", "1", "0.5", "0.5"), ("streamlines", "out", "--on", "surface", "-o", "lines.vtu"),
                       ("render", "out", "-o", "picture.png", "--size", "128x128"), ("solve", "box.mesh", "--from", "out", "--resolution", 8, "-o", "again", *FEW)]
# Larger files take time and show nothing more.
MOST_BYTES = 40000


class Mutated(CommandTest):
    def end_of(self, *arguments):
        """Exit code and standard error."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        try:
            errors = process.communicate(timeout=TIME_S)[1]
        except subprocess.TimeoutExpired:
            # SIGINT is ignored by what a shell runs in the background.
            process.send_signal(signal.SIGTERM)
            try:
                errors = process.communicate(timeout=TIME_TO_END_S)[1]
            except subprocess.TimeoutExpired:
                process.kill()
                errors = b"does not end: " + process.communicate()[1]
        return process.returncode, errors.decode(errors="replace")

    def assert_ends(self, codes, *arguments):
        code, errors = self.end_of(*arguments)
        self.assertIn(code, codes, errors[-3000:])
        self.assertNotIn("Sanitizer", errors)
        self.assertNotIn("runtime error", errors)
        if code in (INPUT, OUTPUT, LIMIT):
            self.assertRegex(errors.splitlines()[-1], r"\Acrossgrain: [ -~]+\Z")


class Models(Mutated):
    def assert_end_of_each_command(self, path, repairs):
        for command, *options in COMMANDS_OF_MODELS:
            with self.subTest(command=command, options=options):
                repair = ("--prepare", "--repair") if command == "solve" and repairs else ()
                output = "out.mesh" if command == "tets" else "out"
                self.assert_ends((DONE, INPUT, LIMIT, PARTIAL, APPROXIMATE, INTERRUPTED), command, path, *repair, *options, "-o", output)
                shutil.rmtree(self.folder / "out", ignore_errors=True)
        (self.folder / "out.mesh").unlink(missing_ok=True)

    def seeds(self):
        """Suffixes and contents."""
        files = [(path.suffix, path.read_bytes()) for path in BAD_FILES]
        box = tet_box((2, 1, 1))
        made = [(".mesh", medit_text(*box).encode()), (".vtk", vtk_text(*box).encode()), (".stl", stl_bytes(box_triangles()))]
        return [(suffix, content) for suffix, content in files if 0 < len(content) <= MOST_BYTES] + made

    def test_that_are_damaged_end_in_each_command(self):
        seeds = self.seeds()
        for seed in range(SEED, SEED + MUTATIONS):
            chance = random.Random(seed)
            suffix, content = chance.choice(seeds)
            path = self.write("damaged" + suffix, mutated(content, chance))
            with self.subTest(seed=seed):
                self.assert_end_of_each_command(path.name, suffix in TET_FILES)
            path.unlink()

    def test_that_are_bad_end_in_each_command(self):
        for path in BAD_FILES if NIGHTLY else []:
            with self.subTest(path.name):
                self.assert_end_of_each_command(path, path.suffix in TET_FILES)


class Results(Mutated):
    def test_that_are_damaged_end_in_each_command(self):
        self.write("box.mesh", medit_text(*tet_box((2, 1, 1))))
        whole = self.folder / "whole"
        self.assertEqual(self.end_of("hex", "box.mesh", "--cells", 3, "-o", whole)[0], DONE)
        contents = {path.name: path.read_bytes() for path in sorted(whole.iterdir()) if path.suffix in (".json", ".vtu", ".frames")}
        for seed in range(SEED, SEED + MUTATIONS):
            chance = random.Random(seed)
            name = chance.choice(list(contents))
            for command in COMMANDS_OF_RESULTS:
                shutil.rmtree(self.folder / "out", ignore_errors=True)
                shutil.copytree(whole, self.folder / "out")
                (self.folder / "out" / name).write_bytes(mutated(contents[name], random.Random(seed)))
                with self.subTest(seed=seed, file=name, command=command[0]):
                    self.assert_ends((DONE, INPUT, LIMIT, INTERRUPTED), *command)
                shutil.rmtree(self.folder / "again", ignore_errors=True)
                for left in ("lines.vtu", "picture.png"):
                    (self.folder / left).unlink(missing_ok=True)


if __name__ == "__main__":
    unittest.main()
