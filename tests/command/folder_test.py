#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What `crossgrain solve` does with a folder that is there already: its own files go, others stay untouched."""

import os
import shutil
import signal
import subprocess
import unittest

from program import PROGRAM, CommandTest, box_triangles, medit_text, stl_bytes, tet_box

INPUT = 3
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
        process = subprocess.Popen([PROGRAM, "solve", "box.stl", "-o", "out", "--resolution", "96", "--progress"],
                                   cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
        self.addCleanup(process.stderr.close)
        process.stderr.readline()
        self.make("notes.txt")
        process.communicate(timeout=120)
        self.assertEqual(process.returncode, 0)
        self.assertEqual(self.contents()["notes.txt"], b"mine")
        self.assertIn("field.vtu", self.contents())

    def test_a_killed_solve_leaves_nothing_that_stops_the_next(self):
        process = subprocess.Popen([PROGRAM, "solve", "box.stl", "-o", "out", "--resolution", "96"], cwd=self.folder,
                                   stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        part = self.folder / ".out.crossgrain-part"
        while process.poll() is None and not part.exists():
            pass
        process.send_signal(signal.SIGKILL)
        process.wait(timeout=60)
        self.assertTrue(part.exists())
        self.assert_succeeds(self.solve("box.stl", "-o", "out"))
        self.assertEqual(self.names(), ["box.mesh", "box.stl", "out"])


class ChangedFiles(FolderTest):
    EVERY_RESULT = {"hex": (["hex", "box.mesh", "--cells", "2", "--write", "mesh,hexex,map," + EVERY_FORMAT], 22),
                    "solve": (["solve", "box.stl", *RESOLUTION], 5)}

    def refused(self, command, name):
        changed = (self.folder / "out" / name).read_bytes()
        self.assert_fails(self.run_here(*command, "-o", "out"), OUTPUT, f"out: holds '{name}', which was changed since Crossgrain wrote it; ",
                          "another folder with -o", "--force")
        self.assertEqual((self.folder / "out" / name).read_bytes(), changed)

    def test_are_kept_whichever_of_a_result_it_is_and_replaced_by_force(self):
        for command, files in self.EVERY_RESULT.values():
            self.assert_succeeds(self.run_here(*command, "-o", "out"))
            self.assert_succeeds(self.run_here("streamlines", "out", "--count", "3"))
            written = self.contents()
            self.assertEqual(len(written), files + 1)
            for number, (name, content) in enumerate(sorted(written.items())):
                with self.subTest(command=command[0], name=name):
                    half = len(content) // 2
                    in_place = content[:half] + bytes([content[half] ^ 1]) + content[half + 1:]
                    # Either is tried on all files by ForeignFiles.AreAllThatWereChangedSinceTheyWereWritten, which is quicker.
                    self.write("out/" + name, in_place if number % 2 else content + b"\n")
                    self.refused(command, name)
                    self.write("out/" + name, content)
            for name, content in written.items():
                self.write("out/" + name, content + b"mine")
            self.assert_succeeds(self.run_here(*command, "-o", "out", "--force"))
            self.assertEqual(set(self.contents()), set(written) - {"streamlines.vtu"})
            self.assertFalse([name for name, content in self.contents().items() if content.endswith(b"mine")])
            self.assert_succeeds(self.run_here(*command, "-o", "out"))
            shutil.rmtree(self.folder / "out")

    def test_are_none_that_the_user_deleted(self):
        command = self.EVERY_RESULT["solve"][0]
        self.assert_succeeds(self.run_here(*command, "-o", "out"))
        for name in ("field.vtu", "report.html"):
            (self.folder / "out" / name).unlink()
        self.assert_succeeds(self.run_here(*command, "-o", "out"))
        (self.folder / "out" / "report.json").unlink()
        self.assert_fails(self.run_here(*command, "-o", "out"), OUTPUT, "out: holds 'field.vtu' and 3 other files, which no report.json lists; ", "--force")


class OneSolveAtATime(FolderTest):
    def test_a_second_solve_into_the_folder_is_refused_and_the_first_is_whole(self):
        for there in (False, True):
            with self.subTest(there=there):
                process = subprocess.Popen([PROGRAM, "solve", "box.stl", "-o", "a/out", "--resolution", "96", "--progress"],
                                           cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
                self.addCleanup(process.stderr.close)
                process.stderr.readline()
                self.assert_fails(self.solve("box.mesh", "-o", "a/out"), OUTPUT, "a/out: another solve is writing to it; wait")
                process.communicate(timeout=120)
                self.assertEqual(process.returncode, 0)
                self.assertNotIn("onto.vtu", self.contents("a/out"))
                self.assertEqual([path.name for path in (self.folder / "a").iterdir()], ["out"])

    def test_many_into_a_new_folder_leave_one_that_is_whole(self):
        for k in range(4):
            runs = [subprocess.Popen([PROGRAM, "solve", "box.stl", "-o", f"new{k}/out", *RESOLUTION, "--quiet"],
                                     cwd=self.folder, stderr=subprocess.PIPE, text=True) for _ in range(3)]
            results = [(run.communicate(timeout=60)[1], run.returncode) for run in runs]
            self.assertIn(("", 0), results)
            for errors, code in results:
                self.assertTrue(code == 0 or (code == OUTPUT and "another solve" in errors), results)
            self.assert_succeeds(self.run_here("check", f"new{k}/out"))
            self.assertEqual([path.name for path in (self.folder / f"new{k}").iterdir()], ["out"])


class FilesOfDifferentSolves(FolderTest):
    READERS = (["check", "out"], ["render", "out", "-o", "a.png", "--size", "64x64"], ["streamlines", "out", "-o", "a.vtu"],
               ["sample", "out", "1", "0.5", "0.5"], ["view", "out", "--no-browser"],
               ["solve", "box.stl", "--from", "out", "-o", "more", "--resolution", "16"])

    def assert_refused(self, name):
        for reader in self.READERS:
            with self.subTest(name=name, reader=reader[0]):
                self.assert_fails(self.run_here(*reader), 3, f"out/{name}", "out/report.json", "is of another solve than")
                self.assertFalse(set(self.names()) & {"a.png", "a.vtu", "more"})

    def test_are_refused_by_every_command_which_names_two(self):
        for arguments in (["-o", "out"], ["-o", "other", "--degree", "3"]):
            self.assert_succeeds(self.solve("box.mesh", *arguments))
            self.assert_succeeds(self.run_here("streamlines", arguments[1], "--count", "3"))
        own, other = self.contents("out"), self.contents("other")
        for name in own:
            if name in ("report.json", "onto.frames"):
                continue
            self.write("out/" + name, other[name])
            self.assert_refused(name)
            self.write("out/" + name, own[name])
        for reader in self.READERS[:4]:
            self.assert_succeeds(self.run_here(*reader))

    def test_of_formats_without_a_mark_are_told_by_their_bytes(self):
        self.assert_succeeds(self.solve("box.mesh", "-o", "out", "--write", "fra"))
        frames = (self.folder / "out" / "onto.frames").read_text()
        self.write("out/onto.frames", "".join(line[::1] + "\n" for line in reversed(frames.splitlines())))
        for reader in self.READERS[1:3]:
            self.assert_fails(self.run_here(*reader), 3, "out/onto.frames", "out/report.json")
        self.write("out/onto.frames", frames)
        self.write("out/onto.fra", "FRA 1\n")
        self.assert_fails(self.run_here("check", "out"), 3, "out/onto.fra", "out/report.json")

    def test_have_the_same_mark_after_the_same_solve_with_other_threads(self):
        for name, threads in (("out", 1), ("again", 2)):
            self.assert_succeeds(self.solve("box.mesh", "-o", name, "--threads", threads))
        first, second = self.contents("out"), self.contents("again")
        for name in first:
            if name not in ("report.json", "report.html"):
                self.assertEqual(first[name], second[name])


class PlacesThatAreNoFiles(FolderTest):
    def test_are_refused_at_once_by_every_command(self):
        self.assert_succeeds(self.solve("box.stl", "-o", "out"))
        self.write("points.txt", "1 0.5 0.5\n")
        # Lines are written as what the name says, which comes first.
        for command, ending in ((["render", "out", "--size", "64x64"], ""), (["streamlines", "out"], ".vtu"), (["sample", "out", "points.txt"], "")):
            pipe, link, folder = f"pipe{ending}", f"link{ending}", f"folder{ending}"
            if not (self.folder / pipe).exists():
                os.mkfifo(self.folder / pipe)
                (self.folder / link).symlink_to("nowhere")
                (self.folder / folder).mkdir()
            for place, words in ((pipe, "is not a regular file"), (link, "is a link to nothing"), (folder, "folder")):
                with self.subTest(command=command[0], place=place):
                    self.assert_fails(self.run_here(*command, "-o", place), OUTPUT, place, words)
        for command in (["render", "out"], ["sample", "out", "points.txt"]):
            self.assert_fails(self.run_here(*command, "-o", "/dev/null"), OUTPUT, "/dev/null", "is not a regular file")
        self.assert_fails(self.run_here("sample", "out", "points.txt", "--outside", "pipe"), OUTPUT, "pipe")
        self.assert_fails(self.solve("box.stl", "-o", "link"), OUTPUT, "link: is a link to nothing")
        self.assert_fails(self.solve("box.stl", "-o", "pipe"), OUTPUT, "pipe: is a file, but must be a folder")

    def test_are_refused_in_a_result_too(self):
        (self.folder / "out").mkdir()
        os.mkfifo(self.folder / "out" / "report.json")
        for force in ([], ["--force"]):
            self.assert_fails(self.solve("box.stl", "-o", "out", *force), OUTPUT, "out/report.json: is not a regular file")


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
                changed = (self.folder / name).read_bytes() + b"mine"
                self.write(name, changed)
                self.assert_fails(self.run_here(*arguments), OUTPUT, name, "was changed since Crossgrain wrote it", "-o")
                self.assertEqual((self.folder / name).read_bytes(), changed)


class FieldsOfOtherModels(FolderTest):
    def test_are_not_replaced_in_a_folder_that_nobody_named(self):
        self.assert_succeeds(self.solve("box.stl"))
        before = self.contents("box.frames")
        self.assert_fails(self.solve("box.mesh"), OUTPUT, "box.frames: ", "box.stl", "-o", "--force")
        self.assertEqual(self.contents("box.frames"), before)
        self.assert_succeeds(self.solve("box.mesh", "--force"))
        self.assertIn("onto.vtu", self.contents("box.frames"))

    def test_are_not_what_is_wrong_with_a_model_that_is_none(self):
        self.assert_succeeds(self.solve("box.stl"))
        self.write("box.png", "a picture")
        self.assert_fails(self.solve("box.png"), INPUT, "box.png: no reader for '.png' files")
        self.assert_fails(self.solve("box.frames"), INPUT, "box.frames: is a folder")

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
