#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Signals to `solve` and `hex`: the first leaves the last level or mesh that is finished, the second nothing."""

import json
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from field_reader import Field
from program import NIGHTLY, PROGRAM, TIME_LIMIT, CommandTest, box_triangles, by_night, medit_text, stl_bytes, tet_box, torus_triangles, without_solve

INTERRUPTED = 130

# Its finest level takes far longer than what happens here.
LARGE = ("--resolution", "1500")
LEVELS = 6

# Signals that follow each other faster count as one.
APART = 0.2

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Solve:
    """A running `solve --progress`, and the lines that it has said so far."""

    def __init__(self, folder, *arguments):
        self.lines = []
        self.process = subprocess.Popen([PROGRAM, "solve", *map(str, arguments), "--progress"], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, cwd=folder)

    def wait_for(self, word):
        while word not in (self.lines[-1] if self.lines else ""):
            line = self.process.stderr.readline().decode()
            if not line:
                raise AssertionError(f"ended without '{word}': {self.lines}")
            self.lines.append(line)
        return self.lines[-1]

    def send(self, number=signal.SIGINT):
        self.process.send_signal(number)

    def send_while_halted(self, number=signal.SIGINT):
        """So that it does not get any further between."""
        self.process.send_signal(signal.SIGSTOP)
        time.sleep(APART)
        self.process.send_signal(number)
        self.process.send_signal(signal.SIGCONT)

    def end(self):
        """Exit code, standard output, all of standard error."""
        output, errors = self.process.communicate(timeout=100)
        return self.process.returncode, output.decode(), "".join(self.lines) + errors.decode()


class InterruptionTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("torus.stl", stl_bytes(torus_triangles()))

    def start(self, *arguments):
        solve = Solve(self.folder, *arguments)
        self.addCleanup(lambda: solve.process.poll() is None and solve.process.kill())
        return solve

    def report(self, name="out"):
        return json.loads((self.folder / name / "report.json").read_text())

    def files(self, name="out"):
        return {path.name: path.read_bytes() for path in (self.folder / name).iterdir()}

    def stopped_solve(self, level=1, number=signal.SIGINT):
        """Stopped once that level is finished; exit code, standard output and standard error."""
        solve = self.start("torus.stl", "-o", "out", *LARGE, "--no-report")
        solve.wait_for(f"level {level} of {LEVELS}:")
        solve.send(number)
        return solve.end()


class Stopped(InterruptionTest):
    def test_leaves_the_last_finished_level_marked_as_unfinished(self):
        code, output, errors = self.stopped_solve(level=2)
        self.assertEqual(code, INTERRUPTED)
        report = self.report()
        finished = len(report["levels"])
        self.assertGreaterEqual(finished, 2)
        self.assertEqual(report["unfinished"], {"resolution_asked": 1500, "levels_missing": LEVELS - finished,
                                                "tets_missing": False})
        self.assertAlmostEqual(report["resolution"], 1500 / 2 ** (LEVELS - finished))
        self.assertNotIn("limited", report)
        self.assertEqual(report["warnings"][0]["kind"], "unfinished")
        self.assertIn("unfinished", output)
        cells = report["levels"][-1]["active_cells"]
        self.assertIn(f"crossgrain: interrupted: writing level {finished} of {LEVELS}, {cells} cells; press Ctrl-C again to discard it\n",
                      errors)
        field = Field(self.folder / "out" / "field.vtu")
        self.assertEqual(len(field), cells)
        self.assertEqual(field.depth.max(), report["levels"][-1]["depth"])

    def test_shows_no_line_of_the_level_that_is_dropped(self):
        _, _, errors = self.stopped_solve()
        shown = sum(line.startswith("level ") for line in errors.splitlines())
        self.assertEqual(shown, len(self.report()["levels"]))

    def test_by_any_of_the_signals_that_end_programs(self):
        for number in SIGNALS:
            with self.subTest(signal=number.name):
                self.assertEqual(self.stopped_solve(number=number)[0], INTERRUPTED)
                self.assertIn("unfinished", self.report())

    def test_by_a_signal_that_comes_twice_at_once(self):
        # As `timeout` sends it, to the process and to its group.
        solve = self.start("torus.stl", "-o", "out", *LARGE, "--no-report")
        solve.wait_for(f"level 1 of {LEVELS}:")
        solve.send(signal.SIGTERM)
        solve.send(signal.SIGINT)
        self.assertEqual(solve.end()[0], INTERRUPTED)
        self.assertIn("unfinished", self.report())

    def test_gives_a_field_that_a_solve_starts_from_and_others_read(self):
        self.stopped_solve()
        result = self.run_here("check", "out")
        self.assert_succeeds(result)
        self.assertTrue(result.stdout.startswith("UNFINISHED"), result.stdout)
        self.assert_succeeds(self.run_here("sample", "out", "-", stdin=b"0.6 0 0\n"))
        self.assert_succeeds(self.run_here("solve", "torus.stl", "--from", "out", "-o", "again", "--resolution", 32, "--no-report"))
        again = self.report("again")
        self.assertNotIn("unfinished", again)
        self.assertNotIn("unfinished", [warning["kind"] for warning in again["warnings"]])

    def test_replaces_an_earlier_result_as_a_whole(self):
        self.assert_succeeds(self.run_here("solve", "torus.stl", "-o", "out", "--resolution", 16, "--no-report"))
        before = self.files()
        self.stopped_solve()
        after = self.files()
        self.assertEqual(before.keys(), after.keys())
        self.assertEqual([name for name in before if before[name] == after[name]], [])
        self.assertEqual(*(without_solve(files["surface.vtu"]) for files in (before, after)))  # of the same model

    def test_before_any_level_is_finished_leaves_nothing(self):
        solve = self.start("torus.stl", "-o", "out", *LARGE)
        solve.send_while_halted()
        code, output, errors = solve.end()
        if (self.folder / "out").exists():
            self.skipTest("the first level was finished before the process could be halted")
        # The very first moment, before the program has said what to do with signals, is the system's.
        self.assertIn(code, (INTERRUPTED, -signal.SIGINT))
        self.assertEqual(output, "")
        self.assertNotIn("writing", errors)
        self.assertEqual(self.names(), ["torus.stl"])


class AfterTheFinestLevel(InterruptionTest):
    def test_a_stop_changes_nothing_but_to_say_so(self):
        self.assert_succeeds(self.run_here("solve", "torus.stl", "-o", "whole", "--resolution", 64, "--no-report"))
        solve = self.start("torus.stl", "-o", "out", "--resolution", 64, "--no-report")
        levels = len(self.report("whole")["levels"])
        solve.wait_for(f"level {levels} of {levels}:")
        solve.send_while_halted()
        code, _, errors = solve.end()
        self.assertEqual(code, 0)
        self.assertIn("interrupted: the result is complete", errors)
        self.assertNotIn("unfinished", self.report())
        self.assertTrue(self.files()["field.vtu"] == self.files("whole")["field.vtu"])


class Cancelled(InterruptionTest):
    def cancel_while_writing(self):
        solve = self.start("torus.stl", "-o", "out", *LARGE)
        solve.wait_for(f"level 3 of {LEVELS}:")
        solve.send()
        solve.wait_for("interrupted: writing level")
        solve.send_while_halted()
        return solve.end()

    @by_night
    def test_a_second_signal_leaves_nothing(self):
        code, output, errors = self.cancel_while_writing()
        self.assertEqual(code, INTERRUPTED)
        self.assertNotIn("result", output)
        self.assertTrue(errors.endswith("crossgrain: interrupted\n"), errors)
        self.assertEqual(self.names(), ["torus.stl"])

    @by_night
    def test_a_second_signal_leaves_an_earlier_result_as_it_was(self):
        self.assert_succeeds(self.run_here("solve", "torus.stl", "-o", "out", "--resolution", 16))
        before = self.files()
        self.assertEqual(self.cancel_while_writing()[0], INTERRUPTED)
        self.assertEqual(self.files(), before)

    def test_a_second_signal_while_the_finest_level_is_written_leaves_nothing(self):
        solve = self.start("torus.stl", "-o", "out", "--resolution", 160)
        solve.wait_for("analysis")
        solve.send_while_halted()
        solve.wait_for("interrupted: the result is complete")
        solve.send_while_halted()
        code, _, errors = solve.end()
        self.assertEqual(code, INTERRUPTED, errors)
        self.assertEqual(self.names(), ["torus.stl"])


class OfHexahedra(InterruptionTest):
    STAGES = ("read", "grid", "tets", "repair", "map", "hexahedra", "smooth", "write")
    # Far beyond the second that is promised, since the machine may be busy, and far below what the work takes by night.
    SECONDS = 15

    def setUp(self):
        super().setUp()
        self.write("box.mesh", medit_text(*tet_box((3, 3, 4), (3.0, 3.0, 4.0))))
        # A million hexahedra by night.
        self.size = 0.03 if NIGHTLY else 0.1

    def interrupted_at(self, stage, *arguments, pause=0.0, signals=1, number=signal.SIGINT):
        """The exit code, once that many signals have followed the begin of a stage; nothing half written is left."""
        shutil.rmtree(self.folder / "out", ignore_errors=True)
        command = [PROGRAM, "hex", *map(str, arguments), "-o", "out", "--progress", "json"]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, cwd=self.folder)
        self.addCleanup(lambda: process.poll() is None and process.kill())
        for line in process.stderr:
            # A stage of less than a tenth of a second may not be told.
            if line.startswith(b"{") and json.loads(line).get("phase") in self.STAGES[self.STAGES.index(stage):]:
                break
        time.sleep(pause)
        for k in range(signals):
            time.sleep(APART if k > 0 else 0)
            process.send_signal(number)
        start = time.monotonic()
        process.communicate(timeout=TIME_LIMIT)
        self.assertLess(time.monotonic() - start, self.SECONDS)
        self.assertEqual([name for name in self.names() if name.startswith(".")], [])
        self.assertEqual("out" in self.names(), process.returncode == 0)
        return process.returncode

    def test_end_in_each_stage_and_leave_nothing_half_written(self):
        for stage in self.STAGES[:-1]:
            with self.subTest(stage):
                code = self.interrupted_at(stage, "box.mesh", "--size", self.size)
                # With a mesh, the first signal lets it be written.
                self.assertIn(code, (0, INTERRUPTED) if stage == "smooth" else (INTERRUPTED,))

    @unittest.skipUnless(NIGHTLY, "takes minutes")
    def test_end_with_little_work_at_any_moment_of_the_extraction(self):
        """In processor seconds, which a busy machine does not change."""
        ticks = os.sysconf("SC_CLK_TCK")

        def seconds(process):
            fields = Path(f"/proc/{process.pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
            return sum(map(int, fields[11:13])) / ticks

        for moment in range(1, 11):
            with self.subTest(moment=moment), tempfile.TemporaryDirectory() as folder:
                process = subprocess.Popen([PROGRAM, "hex", "box.mesh", "--size", str(self.size), "-o", folder + "/out", "--threads", "1",
                                            "--progress", "json"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, cwd=self.folder)
                next(line for line in process.stderr if line.startswith(b"{") and json.loads(line).get("phase") == "hexahedra")
                start = seconds(process)
                while process.poll() is None and seconds(process) < start + moment:
                    time.sleep(0.01)
                at_signal = seconds(process)
                process.send_signal(signal.SIGINT)
                process.stderr.read()
                process.stderr.close()
                _, status, usage = os.wait4(process.pid, 0)
                process.returncode = os.waitstatus_to_exitcode(status)
                self.assertLess(usage.ru_utime + usage.ru_stime - at_signal, 0.75)

    def test_end_while_tets_are_made(self):
        self.write("box.stl", stl_bytes(box_triangles((1.0, 1.0, 1.0))))
        self.assertEqual(self.interrupted_at("read", "box.stl", "--size", 0.05, "--tet-size", 0.03, pause=0.5), INTERRUPTED)

    def test_leave_nothing_however_many_signals_come_while_they_are_written(self):
        for number in SIGNALS[:2]:
            with self.subTest(signal=number.name):
                code = self.interrupted_at("write", "box.mesh", "--size", self.size, signals=4, number=number)
                # By day all may be written before the second one.
                self.assertIn(code, (INTERRUPTED,) if NIGHTLY else (0, INTERRUPTED))


class OnTets(InterruptionTest):
    def setUp(self):
        super().setUp()
        self.write("box.mesh", medit_text(*tet_box((24, 20, 20))))

    def test_a_stop_while_the_field_is_carried_leaves_that_on_the_grid(self):
        solve = self.start("box.mesh", "-o", "out", "--write", "fra", "--resolution", 16)
        solve.wait_for("analysis")
        solve.send()
        code, output, errors = solve.end()
        self.assertEqual(code, INTERRUPTED)
        self.assertIn("interrupted: writing the field on the grid", errors)
        report = self.report()
        self.assertEqual(report["unfinished"], {"resolution_asked": 16, "levels_missing": 0, "tets_missing": True})
        self.assertNotIn("onto", report)
        self.assertEqual([warning["kind"] for warning in report["warnings"]].count("unfinished"), 1)
        self.assertEqual(report["warnings"][0]["kind"], "unfinished")
        self.assertIn("not carried onto the tets", report["warnings"][0]["text"])
        self.assertIn("not carried onto the tets", output)
        self.assertEqual(sorted(self.files()), ["field.vtu", "report.html", "report.json", "singularities.vtu", "surface.vtu"])
        self.assertIn("no field on the tets", self.run_here("check", "out").stdout)

    def test_a_stop_while_levels_are_solved_leaves_the_grid_too(self):
        solve = self.start("box.mesh", "-o", "out", *LARGE, "--no-report")
        solve.wait_for("level 4 of 9:")
        solve.send()
        code, _, errors = solve.end()
        self.assertEqual(code, INTERRUPTED)
        self.assertEqual(errors.count("interrupted:"), 1, errors)
        unfinished = self.report()["unfinished"]
        self.assertTrue(unfinished["tets_missing"])
        self.assertGreater(unfinished["levels_missing"], 0)


if __name__ == "__main__":
    unittest.main()
