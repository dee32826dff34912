#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What `crossgrain solve` does with a folder that is there already: its own files go, others stay untouched."""

import signal
import subprocess
import unittest

from program import PROGRAM, CommandTest, box_triangles, medit_text, stl_bytes, tet_box

OUTPUT = 4
RESOLUTION = ("--resolution", "8")
EVERY_FORMAT = "fra,perm,frame,quaternions,features"


class FolderTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("box.stl", stl_bytes(box_triangles()))
        self.write("box.mesh", medit_text(*tet_box()))

    def solve(self, *arguments):
        return self.run_here("solve", *arguments, *RESOLUTION)

    def contents(self, folder="out"):
        return {path.name: path.read_bytes() for path in (self.folder / folder).iterdir()}


class ForeignFiles(FolderTest):
    def make(self, *names):
        (self.folder / "out").mkdir(exist_ok=True)
        for name in names:
            self.write("out/" + name, "mine")

    def test_a_folder_with_a_foreign_field_is_refused_and_the_file_is_untouched(self):
        self.make("field.vtu")
        result = self.solve("box.stl", "-o", "out")
        self.assert_fails(result, OUTPUT, "out: ", "field.vtu", "another folder with -o", "--force")
        self.assertEqual(self.contents(), {"field.vtu": b"mine"})

    def test_any_foreign_file_is_refused_with_and_without_tets(self):
        self.make("notes.txt")
        for model in ("box.stl", "box.mesh"):
            self.assert_fails(self.solve(model, "-o", "out"), OUTPUT, "notes.txt")
        self.assertEqual(self.contents(), {"notes.txt": b"mine"})

    def test_the_folder_of_the_model_is_refused(self):
        before = self.contents("")
        self.assert_fails(self.solve("box.stl", "-o", "."), OUTPUT, "box.mesh", "--force")
        self.assertEqual(self.contents(""), before)

    def test_force_writes_and_leaves_what_has_another_name(self):
        self.make("notes.txt", "field.vtu")
        self.assert_succeeds(self.solve("box.stl", "-o", "out", "--force"))
        self.assertEqual(self.contents()["notes.txt"], b"mine")
        self.assertNotEqual(self.contents()["field.vtu"], b"mine")

    def test_everything_that_commands_write_into_a_folder_may_be_replaced(self):
        self.assert_succeeds(self.solve("box.mesh", "-o", "out", "--write", EVERY_FORMAT))
        self.write("points.txt", "1 0.5 0.5\n9 9 9\n")
        for arguments in (["streamlines", "out"], ["streamlines", "out", "-o", "out/more.vtu", "--count", "3"],
                          ["render", "out", "-o", "out/picture.png", "--size", "64x64"],
                          ["sample", "out", "points.txt", "-o", "out/frames.txt", "--outside", "out/outside.txt"]):
            self.assert_succeeds(self.run_here(*arguments))
        self.assertEqual(len(self.contents()), 19)
        result = self.solve("box.stl", "-o", "out")
        self.assert_succeeds(result)
        self.assertEqual(set(self.contents()), {"field.vtu", "surface.vtu", "singularities.vtu", "report.json", "report.html",
                                                "more.vtu", "picture.png", "frames.txt", "outside.txt"})

    def test_what_appears_during_a_solve_does_not_cost_its_result(self):
        process = subprocess.Popen([PROGRAM, "solve", "box.stl", "-o", "out", "--resolution", "160", "--progress"],
                                   cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
        self.addCleanup(process.stderr.close)
        process.stderr.readline()
        self.make("notes.txt")
        process.communicate(timeout=120)
        self.assertEqual(process.returncode, 0)
        self.assertEqual(self.contents()["notes.txt"], b"mine")
        self.assertIn("field.vtu", self.contents())

    def test_a_killed_solve_leaves_nothing_that_stops_the_next(self):
        process = subprocess.Popen([PROGRAM, "solve", "box.stl", "-o", "out", "--resolution", "160"], cwd=self.folder,
                                   stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        left = []
        while process.poll() is None and not left:
            left = list((self.folder / "out").glob(".*.part")) if (self.folder / "out").is_dir() else []
        process.send_signal(signal.SIGKILL)
        process.wait(timeout=60)
        self.assert_succeeds(self.solve("box.stl", "-o", "out"))


class OutputsThatNobodyNamed(FolderTest):
    def test_replace_only_files_of_the_program(self):
        self.assert_succeeds(self.solve("box.stl", "-o", "out"))
        for arguments, name in ((["render", "out", "--size", "64x64"], "out.png"),
                                (["streamlines", "out", "--count", "3"], "out/streamlines.vtu")):
            with self.subTest(name=name):
                self.write(name, "mine")
                self.assert_fails(self.run_here(*arguments), OUTPUT, name, "-o")
                self.assertEqual((self.folder / name).read_text(), "mine")
                self.assert_succeeds(self.run_here(*arguments, "-o", name))
                self.assert_succeeds(self.run_here(*arguments))


class FieldsOfOtherModels(FolderTest):
    def test_are_not_replaced_in_a_folder_that_nobody_named(self):
        self.assert_succeeds(self.solve("box.stl"))
        before = self.contents("box.frames")
        self.assert_fails(self.solve("box.mesh"), OUTPUT, "box.frames: ", "box.stl", "-o", "--force")
        self.assertEqual(self.contents("box.frames"), before)
        self.assert_succeeds(self.solve("box.mesh", "--force"))
        self.assertIn("onto.vtu", self.contents("box.frames"))

    def test_are_replaced_in_a_folder_that_was_named_which_is_said(self):
        self.assert_succeeds(self.solve("box.stl", "-o", "out"))
        result = self.solve("box.mesh", "-o", "out")
        self.assert_succeeds(result)
        self.assertIn("crossgrain: out: the field of box.stl will be replaced\n", result.stderr)
        self.assertEqual(self.solve("box.stl", "-o", "out", "--quiet").stderr, "")

    def test_are_those_of_another_file_and_not_of_another_spelling(self):
        self.assert_succeeds(self.solve("box.stl"))
        result = self.solve(self.folder / "box.stl")
        self.assert_succeeds(result)
        self.assertEqual(result.stderr, "")


if __name__ == "__main__":
    unittest.main()
