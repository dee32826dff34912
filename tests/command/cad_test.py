#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""CAD files on the command line: they are solved, nothing is printed that should not be, and OpenCASCADE is in a process of
its own, which ends with the program.

CROSSGRAIN_CAD_FILES is the program that makes the files; without it Crossgrain was built without OpenCASCADE.
"""

import gzip
import json
import os
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from field_reader import read_arrays
from program import PROGRAM, TIME_LIMIT, CommandTest, box_triangles, no_more_processes, stl_bytes

CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
USAGE, INPUT, LIMIT, INTERRUPTED = 2, 3, 5, 130


STEP = "ISO-10303-21;\nEND-ISO-10303-21;\n"


class WithoutTheReader(CommandTest):
    def test_a_program_away_from_its_reader_names_the_packages(self):
        alone = shutil.copy(PROGRAM, self.folder / "alone")
        self.write("part.step", STEP)
        result = subprocess.run([alone, "solve", "part.step"], cwd=self.folder, capture_output=True, text=True,
                                timeout=TIME_LIMIT, check=False)
        self.assert_fails(result, INPUT, "part.step", "libocct-data-exchange-dev", "crossgrain_cad")

    def test_the_program_itself_links_no_opencascade(self):
        linked = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True, timeout=TIME_LIMIT, check=True).stdout
        self.assertIn("libc.so", linked)
        self.assertNotIn("libTK", linked)


class WithAHangingReader(CommandTest):
    """An installed tree whose reader is a script that notes its number down and is never done."""

    def setUp(self):
        super().setUp()
        (self.folder / "bin").mkdir()
        (self.folder / "libexec" / "crossgrain").mkdir(parents=True)
        self.program = shutil.copy(PROGRAM, self.folder / "bin" / "crossgrain")
        reader = self.write("libexec/crossgrain/crossgrain_cad", "#!/bin/sh\nsleep 1000 &\necho $$ $! > process\nwait\n")
        reader.chmod(0o755)
        self.write("part.step", STEP)

    def start(self, *arguments):
        """The program, once it has started its reader, and the numbers of the reader and of what that has started."""
        process = subprocess.Popen([self.program, "solve", "part.step", "-o", "out", *arguments], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        note = self.folder / "process"
        deadline = time.monotonic() + TIME_LIMIT
        while not (note.exists() and note.read_text().endswith("\n")):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        return process, [int(number) for number in note.read_text().split()]

    def assert_gone(self, processes):
        deadline = time.monotonic() + TIME_LIMIT
        while any(self.is_running(process) for process in processes):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    @staticmethod
    def is_running(process):
        """Not so for one that has ended and whose parent has not asked for it, as first processes of containers do."""
        try:
            return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
        except (FileNotFoundError, ProcessLookupError):
            return False

    def finished(self, process):
        process.stdout_text, process.stderr_text = process.communicate(timeout=TIME_LIMIT)
        return subprocess.CompletedProcess(process.args, process.returncode, process.stdout_text, process.stderr_text)

    def test_it_is_stopped_after_its_time_with_one_line(self):
        process, reader = self.start("--read-seconds", "0.5")
        self.assert_fails(self.finished(process), INPUT, "part.step", "did not finish within 0.5 s", "--read-seconds")
        self.assert_gone(reader)
        self.assertFalse((self.folder / "out").exists())

    def test_a_system_without_processes_left_is_told(self):
        result = self.run_without_privileges("solve", "part.step", "-o", "out", program=self.program, preexec_fn=no_more_processes)
        self.assert_fails(result, LIMIT, "part.step", "starts no more processes", "ulimit -u")

    def test_it_ends_with_a_program_that_is_killed(self):
        process, reader = self.start()
        process.kill()
        process.communicate()
        self.assert_gone(reader)

    def test_an_interrupt_stops_it(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number.name):
                process, reader = self.start()
                process.send_signal(number)
                self.assert_fails(self.finished(process), INTERRUPTED, "interrupted")
                self.assert_gone(reader)
                (self.folder / "process").unlink()


@unittest.skipUnless(CAD_FILES, "built without OpenCASCADE")
class WithTheReader(CommandTest):
    def setUp(self):
        super().setUp()
        subprocess.run([CAD_FILES, self.folder], capture_output=True, timeout=TIME_LIMIT, check=True)

    def solve(self, model, *arguments):
        result = self.run_here("solve", model, "-o", "out", "--no-report", *arguments)
        self.assert_succeeds(result)
        return result, json.loads((self.folder / "out" / "report.json").read_text())

    def test_every_format_gives_a_field_that_follows_the_part(self):
        for name in ("plate.step", "inch.stp", "plate.iges", "plate.brep"):
            with self.subTest(name):
                result, report = self.solve(name, "--resolution", "32", "--quiet")
                self.assertEqual((result.stdout, result.stderr), ("", ""))
                self.assertTrue(report["model"]["watertight"])
                self.assertAlmostEqual(report["model"]["bounding_box"]["high"][0], 40, 6)
                self.assertLess(report["alignment_deg"]["mean"], 3)

    def test_constraints_name_faces_by_their_numbers(self):
        self.write("c.json", '{"schema": 1, "faces": [{"face": 1, "axis": "normal"}]}')
        _, report = self.solve("plate.step", "--resolution", "16", "--constraints", "c.json")
        faces = report["constraints"]["faces"]
        self.assertEqual(faces["count"], 1)
        self.assertGreater(faces["area"], 0)
        self.assertLess(faces["angle_deg"]["mean"], 5)
        self.write("c.json", '{"schema": 1,\n"faces": [{"face": 999, "axis": "normal"}]}')
        result = self.run_here("solve", "plate.step", "--constraints", "c.json")
        self.assert_fails(result, INPUT, "crossgrain: c.json: line 2: ", "no face 999, only 1 to")

    def test_the_report_names_the_units(self):
        model = self.solve("inch.stp", "--resolution", "8")[1]["model"]
        self.assertEqual((model["unit"], model["file_unit"]), ("mm", "inch"))
        model = self.solve("plate.brep", "--resolution", "8")[1]["model"]
        self.assertNotIn("unit", model)
        self.assertNotIn("file_unit", model)

    def test_open_faces_alone_are_refused_by_every_command(self):
        for command in ("solve", "tets", "hex"):
            for name, words in (("face.brep", "one open face"), ("faces_apart.brep", "2 open faces")):
                with self.subTest(command=command, name=name):
                    before = self.names()
                    self.assert_fails(self.run_here(command, name), INPUT, f"{name}: has {words}", "encloses nothing; close it")
                    self.assertEqual(self.names(), before)

    def test_packed_files_are_solved_as_they_are_and_name_the_folder(self):
        self.write("plate.step.gz", gzip.compress((self.folder / "plate.step").read_bytes()))
        self.solve("plate.step", "--resolution", "8", "--no-report")
        self.assert_succeeds(self.run_here("solve", "plate.step.gz", "--resolution", "8", "--no-report", "--quiet"))
        self.assertEqual(read_arrays(self.folder / "out" / "field.vtu")["frame"].tobytes(),
                         read_arrays(self.folder / "plate.frames" / "field.vtu")["frame"].tobytes())
    def test_a_unit_is_for_files_that_name_none(self):
        model = self.solve("plate.brep", "--resolution", "8", "--unit", "mm")[1]["model"]
        self.assertEqual(model["unit"], "mm")
        self.assertNotIn("file_unit", model)
        self.assertEqual(self.solve("inch.stp", "--resolution", "8", "--unit", "mm")[1]["model"]["unit"], "mm")
        result = self.run_here("solve", "inch.stp", "--resolution", "8", "--unit", "m", "-o", "other")
        self.assert_fails(result, USAGE, "crossgrain: inch.stp: names its unit, inch, and is read in mm", "unit m is for files that name none")

    def test_the_model_line_tells_faces_and_solids(self):
        result = self.run_here("solve", "plate.step", "--resolution", "8", "-o", "other")
        self.assertRegex(result.stdout, r"\Amodel      40 x .* mm from .*; \d+ faces, 1 solid\n")

    def test_finer_cells_get_finer_triangles(self):
        coarse = self.solve("cylinder.brep", "--resolution", "8")[1]["model"]["triangles"]
        by_size = self.solve("cylinder.brep", "--cell-size", "0.2", "--output-level", "2")[1]["model"]["triangles"]
        self.assertGreater(by_size, coarse)

    def test_what_reading_found_is_told_on_standard_error_and_in_the_report(self):
        result, report = self.solve("loose.brep", "--resolution", "8", "--quiet")
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertIn("loose.brep: the file has no solids", result.stderr)
        first = report["warnings"][0]
        self.assertEqual((first["kind"], first["file"]), ("loose_faces", "loose.brep"))
        self.assertIn("no solids", first["text"])
        self.assertEqual([w["kind"] for w in report["warnings"]].count("loose_faces"), 1)

    def test_one_thread_and_two_give_the_same_bytes(self):
        fields = []
        for threads in (1, 2):
            self.solve("rounded.brep", "--resolution", "16", "--threads", threads)
            fields.append((self.folder / "out" / "field.vtu").read_bytes())
        self.assertEqual(fields[0], fields[1])

    def test_a_damaged_file_gives_one_line(self):
        self.write("bad.step", "ISO-10303-21;\nHEADER;\nnonsense\nENDSEC;\nEND-ISO-10303-21;\n")
        self.assert_fails(self.run_here("solve", "bad.step"), INPUT, "bad.step", "export it again")

    def test_opencascade_is_loaded_for_cad_files_only_and_in_another_process(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        for name, processes, with_opencascade in (("box.stl", 1, 0), ("box.brep", 2, 1)):
            with self.subTest(name):
                (self.folder / name[4:]).mkdir()
                self.assert_succeeds(self.run_here("solve", name, "-o", name + ".frames", "--resolution", "8", "--quiet", env={
                    **os.environ, "LD_DEBUG": "files", "LD_DEBUG_OUTPUT": f"{self.folder}/{name[4:]}/loaded"}))
                loaded = [path.read_text() for path in (self.folder / name[4:]).iterdir()]
                self.assertEqual(len(loaded), processes)
                self.assertEqual(sum("libTKernel" in text for text in loaded), with_opencascade)

    def test_the_reader_ends_with_a_program_that_is_killed(self):
        # As fine as that, the part takes minutes.
        process = subprocess.Popen([PROGRAM, "solve", "rounded.brep", "--resolution", "1000000", "--max-memory", "3GB"],
                                   cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        children = f"/proc/{process.pid}/task/{process.pid}/children"
        deadline = time.monotonic() + TIME_LIMIT
        reader = ""
        while "crossgrain_cad" not in reader:
            self.assertLess(time.monotonic(), deadline)
            self.assertIsNone(process.poll())
            with open(children, encoding="utf-8") as numbers:
                reader = "".join(f"/proc/{number}" for number in numbers.read().split())
            reader = os.readlink(f"{reader}/exe") + "\n" + reader if reader else ""
        process.kill()
        process.wait()
        while os.path.exists(reader.split("\n")[1]):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)


if __name__ == "__main__":
    unittest.main()
