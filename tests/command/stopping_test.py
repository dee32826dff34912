#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Files of any size are read within the limit of memory, and reading ends when it is told to.

CROSSGRAIN_LARGE_MB sets the size of the files: 500 for the figures of the documentation.
"""

import os
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from large_files import BYTES
from program import KEPT, PROGRAM, CommandTest, of_the_day, stl_bytes, torus_triangles

LARGE_MB = float(os.environ.get("CROSSGRAIN_LARGE_MB", "30"))
LIMIT, INTERRUPTED = 5, 130


def processor_seconds(process):
    """Of a running process."""
    with open(f"/proc/{process.pid}/stat") as file:
        words = file.read().rsplit(")", 1)[1].split()
    return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")


def has_ended(process):
    with open(f"/proc/{process.pid}/stat") as file:
        return file.read().rsplit(")", 1)[1].split()[0] == "Z"


class Large(CommandTest):
    def make(self, kind, megabytes=LARGE_MB):
        """Once for all tests, in a process of its own: the peak memory of a child begins with that of its parent."""
        path = Path(KEPT.name) / f"large.{kind}"
        if path.exists():
            return path
        subprocess.run([sys.executable, Path(__file__).parent / "large_files.py", kind, path, str(megabytes)], check=True)
        return path

    def run_measured(self, *arguments):
        """Exit code, standard error and bytes of peak memory."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        errors = process.stderr.read().decode()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        process.stderr.close()
        return process.returncode, errors, 1024 * usage.ru_maxrss


class MemoryOfReading(Large):
    def test_stays_within_the_limit_whatever_a_file_inflates_to(self):
        bomb = self.make("bomb.vtu", 3.1)
        code, errors, peak = self.run_measured("solve", bomb, "-o", self.folder / "out", "--max-memory", "500MB")
        self.assertEqual(code, LIMIT, errors)
        self.assertIn("0.5 GB are allowed", errors)
        self.assertLess(peak, 500e6)

    def test_of_every_format_is_refused_before_it_exceeds_the_limit(self):
        for kind in BYTES:
            with self.subTest(kind=kind):
                path = self.make(kind)
                limit = os.path.getsize(path) * 1.3
                code, errors, peak = self.run_measured("solve", path, "-o", self.folder / "out",
                                                       "--max-memory", int(limit))
                self.assertEqual(code, LIMIT, errors)
                # Amounts below 16 MB are not checked.
                self.assertLess(peak, limit + 40e6)


class MemoryOfSolving(Large):
    def test_of_more_triangles_than_fit_is_refused_before_the_work(self):
        model = self.make("stl")
        triangles = (os.path.getsize(model) - 84) // 50
        limit = 200 * triangles
        code, errors, peak = self.run_measured("solve", model, "-o", self.folder / "out", "--max-memory", limit)
        self.assertEqual(code, LIMIT, errors)
        self.assertIn(f"the surface of {triangles} triangles", errors)
        self.assertLess(peak, limit)


class Reading(Large):
    def assert_stops(self, arguments, after):
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while processor_seconds(process) < after:
            self.assertFalse(has_ended(process), "it ended before it could be stopped")
            time.sleep(0.005)
        process.send_signal(signal.SIGTERM)
        before = processor_seconds(process)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, INTERRUPTED)
        # Processor time, since others may use the machine.
        self.assertLess(usage.ru_utime + usage.ru_stime - before, 1)

    def test_of_every_format_ends_within_a_second(self):
        (self.folder / "torus.stl").write_bytes(stl_bytes(torus_triangles()))
        for kind in (*BYTES, "json"):
            path = self.make(kind)
            model = ("torus.stl", "--constraints", path) if kind == "json" else (path,)
            # The program listens to signals after some 0.02 processor seconds, 0.03 on a busy machine.
            for after in of_the_day((0.06, 0.1), 0.1 if kind.startswith("text") else 0.06):
                with self.subTest(kind=kind, after=after):
                    self.assert_stops(("solve", *(self.folder / word if word == "torus.stl" else word for word in model),
                                       "-o", self.folder / "out"), after)


if __name__ == "__main__":
    unittest.main()
