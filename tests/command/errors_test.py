#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every error is one line with the exit code of its kind, and leaves nothing behind."""

import os
import resource
import signal
import struct
import subprocess
import unittest

from program import PROGRAM, CommandTest, box_triangles, no_more_processes, run, stl_bytes

USAGE, INPUT, OUTPUT, LIMIT = 2, 3, 4, 5


class WrongUsage(CommandTest):
    def refuse(self, arguments, *words):
        self.assert_fails(self.run_here(*arguments), USAGE, "--help", *words)
        self.assertEqual(self.names(), [])

    def test_without_arguments_there_is_help_and_exit_code_2(self):
        result = run()
        self.assertEqual(result.returncode, USAGE)
        self.assertIn("solve", result.stderr)

    def test_help_and_version_are_no_errors(self):
        for arguments in (["--help"], ["solve", "--help"], ["sample", "--help"], ["spectrum", "--help"], ["--version"], ["help"],
                          ["help", "solve"]):
            result = run(*arguments)
            self.assert_succeeds(result)
            self.assertNotEqual(result.stdout, "")
            self.assertEqual(result.stderr, "")

    def test_unknown_options_and_commands_are_refused(self):
        self.refuse(["solve", "a.stl", "--wrong"], "--wrong")
        self.refuse(["resolve"], "unknown command 'resolve'", "did you mean 'solve'?")
        self.refuse(["sovle", "a.stl"], "unknown command 'sovle'", "did you mean 'solve'?")
        self.refuse(["help", "chekc"], "did you mean 'check'?")
        self.refuse(["frobnicate"], "unknown command 'frobnicate';")
        self.refuse(["solve"], "MODEL")
        self.refuse(["sample", "a.frames"], "POINTS")
        self.refuse(["solve", "a.stl", "b.stl"], "solve takes one MODEL; 'b.stl' is one too many")
        self.refuse(["streamlines", "a.frames", "1", "2"], "streamlines takes DIR and SEEDS; '2' is one too many")

    def test_unknown_options_are_answered_by_the_nearest_that_there_is(self):
        for arguments, words in ((["hex", "a.stl", "--sise", "2"], "there is no option --sise; did you mean --size?"),
                                 (["hex", "--sise", "2", "a.stl"], "there is no option --sise; did you mean --size?"),
                                 (["hex", "a.stl", "--tetsize=2"], "there is no option --tetsize; did you mean --tet-size?"),
                                 (["hex", "a.stl", "--out", "b"], "there is no option --out; did you mean --output?"),
                                 (["hex", "a.stl", "size", "2"], "hex takes one MODEL; 'size' is one too many; did you mean --size?"),
                                 (["hex", "a.stl", "--resolution", "20"], "no option --resolution here; 'crossgrain solve' has it"),
                                 (["check", "a.frames", "-x"], "there is no option -x;"),
                                 (["--quiet", "solve", "a.stl"], "'--quiet' is before the command; give solve first")):
            with self.subTest(arguments=arguments):
                self.refuse(arguments, words)

    def test_missing_words_are_answered_by_an_example(self):
        self.refuse(["hex"], "MODEL is missing, as in 'crossgrain hex part.step --size 2'")
        self.refuse(["sample", "a.frames"], "POINTS is missing, as in")
        self.refuse(["hex", "a.stl", "--size"], "--size needs a value: X")
        self.refuse(["solve", "a.stl", "--degree"], "--degree needs a value: 3|4")
        self.refuse(["hex", "a.stl", "--size", "1", "--size", "2"], "--size is given more than once")
        for flag in ("--quiet=no-word", "--lattice=5", "--lattice=false"):
            self.refuse(["hex", "a.stl", flag], flag.split("=")[0] + " takes no value")
        self.refuse(["hex", "a.stl", "--threads", "1e3"], "--threads takes a whole number, 0 or more, not 1e3")
        self.refuse(["hex", "a.stl", "--quiet", "--", "b.stl"], "hex takes one MODEL; 'b.stl' is one too many")
        self.refuse(["hex", "--", "a.stl", "-b.stl"], "hex takes one MODEL; '-b.stl' is one too many")

    def test_help_of_a_command_is_the_same_either_way(self):
        for command, its_name in ((["check"], "Usage: crossgrain check "), ([], "Usage: crossgrain [OPTIONS]")):
            ways = [run("help", *command), run(*command, "--help")]
            for way in ways:
                self.assert_succeeds(way)
                self.assertIn(its_name, way.stdout)
            self.assertEqual(ways[0].stdout, ways[1].stdout)

    def test_a_model_without_a_command_is_probably_to_be_solved(self):
        (self.folder / "part.stl").write_bytes(stl_bytes(box_triangles()))
        self.assert_fails(self.run_here("part.stl"), USAGE, "did you mean 'crossgrain solve part.stl'?")

    def test_a_file_where_a_folder_is_written_is_refused(self):
        for name in ("x.msh", "x.inp", "x.VTU", "sub/x.mesh", "x.stl", "x.msh.gz", "x.STL.GZ", "x.step.gz", "x.gz"):
            self.refuse(["hex", "a.stl", "-o", name], name, "hexahedra.inp", "without ." + name.split(".", 1)[1])
            self.refuse(["solve", "a.stl", "-o", name], name, "field.vtu", "--write")

    def test_a_folder_where_a_file_is_written_is_refused(self):
        self.assert_fails(self.run_here("tets", "a.stl", "-o", "out/"), USAGE, "out/", ".mesh or .msh")

    def test_a_picture_that_is_no_png_is_refused(self):
        self.refuse(["render", "a.frames", "-o", "a.jpg"], "a.jpg", "PNG")

    def test_files_of_other_formats_than_are_written_are_refused(self):
        for arguments, words in ((["streamlines", "a.frames", "-o", "lines.csv"], ".vtu, .vtp or .obj"),
                                 (["sample", "a.frames", "1", "2", "3", "-o", "frames.vtu"], ".txt or .dat"),
                                 (["sample", "a.frames", "1", "2", "3", "--outside", "out.csv"], ".txt or .dat"),
                                 (["tets", "a.step", "-o", "tets.vtu"], ".mesh or .msh")):
            with self.subTest(arguments=arguments):
                self.assert_fails(self.run_here(*arguments), USAGE, arguments[-1], words)
                self.assertEqual(self.names(), [])

    def test_values_out_of_range_are_refused(self):
        for option, value in [("--degree", "5"), ("--degree", "four"), ("--resolution", "3"), ("--resolution", "-1"),
                              ("--resolution", "1e99"), ("--cell-size", "0"), ("--cell-size", "-1"),
                              ("--cell-size", "x"), ("--cell-size", "nan"), ("--cell-size", "inf"),
                              ("--max-memory", "0"), ("--max-memory", "-1GB"), ("--max-memory", "much"),
                              ("--max-memory", "1XB"), ("--max-memory", "1e30"), ("--max-memory", ""),
                              ("--crease-angle", "0"), ("--crease-angle", "181"), ("--crease-angle", "nan"),
                              ("--threads", "-2"), ("--seed", "-1"), ("--seed", "x"), ("--seed", "1e3"),
                              ("--seed", "18446744073709551616")]:
            with self.subTest(option=option, value=value):
                self.refuse(["solve", "a.stl", option, value], option)

    def test_ranges_are_told_in_words(self):
        for arguments, words in ((["hex", "a.stl", "--cells", "100000"], "--cells takes 1 to 4000, not 100000;"),
                                 (["hex", "a.stl", "--cells", "x"], "--cells takes 1 to 4000, not 'x';"),
                                 (["hex", "a.stl", "--size", "-1"], "--size takes a number above 0, not -1;"),
                                 (["solve", "a.stl", "--resolution", "3"], "--resolution takes 4 or more, not 3;"),
                                 (["solve", "a.stl", "--resolution", "3e9"], "--resolution takes at most 2147483647, not 3e9;"),
                                 (["solve", "a.stl", "--threads", "2.5"], "--threads takes a whole number, 0 or more, not 2.5;"),
                                 (["solve", "a.stl", "--degree", "5"], "--degree takes 3 or 4, not 5;"),
                                 (["solve", "a.stl", "--output-level", "20"], "--output-level takes 0 to 19, not 20;"),
                                 (["solve", "a.stl", "--unit", "yard"], "--unit takes um, mm, cm, m, inch or foot, not 'yard';"),
                                 (["tets", "a.stl", "--per-circle", "2"], "--per-circle takes 3 to 1000000, not 2;"),
                                 (["tets", "a.stl", "--by", "hand"], "--by takes gmsh or netgen, not 'hand';"),
                                 (["streamlines", "a.frames", "--spacing", "2"], "--spacing takes 0 to 1, not 2;"),
                                 (["render", "a.frames", "--hexahedra", "--below", "3"], "--below takes -1 to 2, not 3;"),
                                 (["view", "a.frames", "--port", "0"], "--port takes 1 to 65535, not 0;")):
            with self.subTest(arguments=arguments):
                self.refuse(arguments, words)

    def test_resolution_and_cell_size_exclude_each_other(self):
        self.refuse(["solve", "a.stl", "--resolution", "8", "--cell-size", "1"], "--resolution and --cell-size exclude each other")

    def test_spectrum_wants_one_of_preset_and_normals(self):
        self.refuse(["spectrum"], "--preset")
        self.refuse(["spectrum", "--preset", "teapot"], "teapot")
        self.refuse(["spectrum", "--preset", "cube", "normals.txt"], "--preset")


class WrongSizes(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("box.stl", stl_bytes(box_triangles()))

    def test_cells_too_large_for_the_model_are_refused(self):
        self.assert_fails(self.run_here("solve", "box.stl", "--cell-size", "1"), USAGE, "too large")

    def test_what_cannot_fit_into_memory_is_refused_at_once(self):
        for arguments, code, words in ((["--resolution", "400000"], LIMIT, "lower --resolution"),
                                       (["--cell-size", "1e-300"], USAGE, "try --cell-size ")):
            result = self.run_here("solve", "box.stl", *arguments)
            self.assert_fails(result, code, words)
            self.assertNotIn("nan", result.stderr)
            self.assertNotIn("inf", result.stderr)
        self.assertEqual(self.names(), ["box.stl"])

    def test_where_even_much_larger_cells_need_more_memory_than_allowed_it_is_refused(self):
        self.assert_fails(self.run_here("solve", "box.stl", "--resolution", "512", "--max-memory", "5MB"), LIMIT, "--max-memory")
        self.assertEqual(self.names(), ["box.stl"])

    def test_control_characters_of_names_do_not_reach_the_terminal(self):
        # Bytes that end a line, begin a sequence of a terminal, and begin one in UTF-8.
        name = "a\x1b[31m\x7f\u009b31m"
        (self.folder / "box.stl").rename(self.folder / (name + ".stl"))
        result = self.run_here("solve", name + ".stl", "--resolution", "8")
        self.assert_succeeds(result)
        wrong = self.run_here("solve", name + ".stl", "--resolution", "3")
        missing = self.run_here("check", name)
        for text in (result.stdout, result.stderr, wrong.stderr, missing.stderr):
            self.assertFalse(any(character in text for character in "\x1b\x7f\u009b"), repr(text))
        self.assertIn("a?[31m???31m", result.stdout)

    def test_any_number_of_threads_will_do(self):
        result = self.run_here("solve", "box.stl", "--resolution", "8", "--threads", "2147483647", "--quiet")
        self.assert_succeeds(result)


class BadModels(CommandTest):
    def refuse(self, name, content, *words):
        with self.subTest(name=name):
            if content is not None:
                self.write(name, content)
            before = self.names()
            self.assert_fails(self.run_here("solve", name, "-o", "out/deep"), INPUT, name, *words)
            self.assertEqual(self.names(), before)

    def test_missing_empty_and_foreign_files(self):
        self.refuse("none.stl", None, "no such file")
        self.refuse("empty.stl", b"", "empty")
        self.refuse("text.obj", "nothing of the kind\n")
        self.refuse("picture.png", b"\x89PNG\r\n\x1a\n")
        self.refuse("mesh.obj", stl_bytes(box_triangles()))
        (self.folder / "folder.stl").mkdir()
        self.refuse("folder.stl", None, "folder")

    def test_truncated_files(self):
        self.refuse("a.stl", stl_bytes(box_triangles())[:-20])
        self.refuse("b.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n")
        self.refuse("c.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n")
        self.refuse("d.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n")

    def test_surfaces_without_triangles(self):
        self.refuse("a.stl", stl_bytes(box_triangles()[:0]), "triangle")
        self.refuse("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "triangle")
        self.refuse("c.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "triangle")

    def test_triangles_without_area(self):
        self.refuse("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "area")

    def test_surfaces_that_enclose_nothing(self):
        self.refuse("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "encloses nothing")
        self.refuse("flat.stl", stl_bytes(box_triangles((1.0, 1.0, 1e-12))), "encloses nothing")

    def test_an_error_of_the_model_names_its_file_whatever_other_files_are_called(self):
        # "the surface ..." begins like the name of the folder.
        self.write("box.stl", stl_bytes(box_triangles()))
        self.assert_succeeds(self.run_here("solve", "box.stl", "--resolution", 4, "--no-report", "--quiet", "-o", "t"))
        self.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assert_fails(self.run_here("solve", "sheet.obj", "--from", "t"), INPUT,
                          "crossgrain: sheet.obj: the surface encloses nothing")

    def test_models_of_a_size_or_at_a_place_that_numbers_cannot_hold(self):
        self.refuse("small.stl", stl_bytes(1e-12 * box_triangles()), "rescale")
        self.refuse("large.stl", stl_bytes(1e15 * box_triangles()), "rescale")
        self.refuse("far.obj", "v 1e12 0 0\nv 1e12 1 0\nv 1e12 0 1\nf 1 2 3\n", "origin")

    def test_models_of_a_size_or_at_a_place_that_numbers_cannot_hold_have_no_tets_and_hexahedra(self):
        self.write("small.stl", stl_bytes(1e-12 * box_triangles()))
        self.write("large.stl", stl_bytes(1e15 * box_triangles()))
        corners = (box_triangles() + (1e11, 0, 0)).reshape(-1, 3).tolist()
        faces = "".join(f"f {3 * k + 1} {3 * k + 2} {3 * k + 3}\n" for k in range(12))
        self.write("far.obj", "".join("v {!r} {!r} {!r}\n".format(*corner) for corner in corners) + faces)
        for model, words in {"small.stl": "rescale it", "large.stl": "rescale it", "far.obj": "move it to the origin"}.items():
            for command in (["hex", "--cells", "4"], ["hex", "--lattice", "--cells", "4"], ["tets", "--edges", "4"]):
                with self.subTest(model, command=command):
                    output = "out.mesh" if command[0] == "tets" else "out"
                    result = self.run_here(command[0], model, *command[1:], "-o", output)
                    self.assert_fails(result, 3, f"{model}: the model is ")
                    self.assertIn(words, result.stderr)
                    self.assertFalse((self.folder / output).exists())

    def test_coordinates_that_are_no_numbers(self):
        triangles = box_triangles()
        triangles[3, 1, 2] = float("nan")
        self.refuse("a.stl", stl_bytes(triangles), "3")
        self.refuse("b.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n", "line 2: ")
        self.refuse("c.off", "OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", "line 4: ")

    def test_indices_out_of_range(self):
        self.refuse("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4: ")
        self.refuse("b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "line 6: ")

    def test_headers_that_claim_more_than_there_is(self):
        header = "ply\nformat binary_little_endian 1.0\nelement vertex 353535235358\nproperty float x\n" \
                 "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        self.refuse("a.ply", header.encode() + b"\0" * 50, "353535235358")
        self.refuse("b.off", "OFF\n353535235358 1 0\n0 0 0\n")
        self.refuse("c.stl", b"\0" * 80 + struct.pack("<I", 4000000000) + b"\0" * 50)

    def test_a_folder_that_is_none_is_blamed_itself(self):
        (self.folder / "empty.frames").mkdir()
        self.write("file.frames", "text")
        self.write("box.stl", stl_bytes(box_triangles()))
        self.write("seeds.txt", "0 0 0\n")
        ways = [["check"], ["sample", "{}", "0", "0", "0"], ["streamlines"], ["streamlines", "{}", "seeds.txt"], ["render"], ["view"],
                ["solve", "box.stl", "--from", "{}", "-o", "out"]]
        self.write("part.step.gz", "text")
        (self.folder / "part.frames").mkdir()
        self.write("part.frames/field.vtu", "text")
        for name, fault in (("nope.frames", "no such folder"), ("file.frames", "is not a folder"), ("empty.frames", "holds no field"),
                            ("box.stl", "is a model, not a folder with a result; give a folder that 'crossgrain solve' or 'crossgrain hex' has"),
                            ("part.step.gz", "is a model"), ("part.frames/field.vtu", "is one file of a result, not its folder")):
            for way in ways:
                arguments = [word.format(name) for word in way] if len(way) > 1 else [*way, name]
                words = "has no report.html" if way == ["view"] and name == "empty.frames" else fault
                self.assert_fails(self.run_here(*arguments), INPUT, f"crossgrain: {name}: {words}")
        self.assert_fails(self.run_here("render", "empty.frames", "--hexahedra"), INPUT, "crossgrain: empty.frames: has no hexahedra")

    def test_an_earlier_field_that_is_none(self):
        self.write("box.stl", stl_bytes(box_triangles()))
        self.assert_fails(self.run_here("solve", "box.stl", "--from", "none.frames"), INPUT, "none.frames")
        self.assertEqual(self.names(), ["box.stl"])


class UnwritableOutput(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("box.stl", stl_bytes(box_triangles()))

    def test_a_file_where_the_folder_should_be(self):
        self.write("taken", "precious")
        self.assert_fails(self.run_here("solve", "box.stl", "-o", "taken"), OUTPUT, "taken", "with -o")
        self.assert_fails(self.run_here("solve", "box.stl", "-o", "taken/below"), OUTPUT, "taken", "with -o")
        self.assertEqual(self.names(), ["box.stl", "taken"])
        self.assertEqual((self.folder / "taken").read_text(), "precious")

    def test_a_folder_where_a_file_should_be(self):
        (self.folder / "out" / "field.vtu").mkdir(parents=True)
        self.assert_fails(self.run_here("solve", "box.stl", "-o", "out"), OUTPUT, "field.vtu")

    def test_a_folder_without_permission(self):
        (self.folder / "locked").mkdir(mode=0o555)
        result = self.run_without_privileges("solve", "box.stl", "-o", "locked/out")
        self.assert_fails(result, OUTPUT, "locked/out", "Permission denied", "-o")
        self.assertEqual(list((self.folder / "locked").iterdir()), [])

    def test_names_that_the_system_does_not_allow(self):
        for name in ("a" * 256, "/".join(["a" * 250] * 17)):
            self.assert_fails(self.run_here("solve", name + ".stl", "-o", "out"), INPUT, "File name too long")
            self.assert_fails(self.run_here("solve", "box.stl", "-o", name), OUTPUT, "File name too long", "-o")
        self.assertEqual(self.names(), ["box.stl"])

    def test_the_output_is_looked_at_before_the_model(self):
        self.write("taken", "precious")
        self.write("rubbish.stl", "rubbish")
        self.assert_fails(self.run_here("solve", "rubbish.stl", "-o", "taken"), OUTPUT, "taken")

    def test_a_system_without_threads_left_is_told(self):
        result = self.run_without_privileges("solve", "box.stl", "-o", "out", "--resolution", "16", preexec_fn=no_more_processes)
        if result.returncode != 0:  # on one core it needs none
            self.assert_fails(result, LIMIT, "box.stl", "starts no more threads", "ulimit -u")

    def test_a_full_disk_leaves_nothing_and_an_earlier_result_as_it_was(self):
        def small_files_only():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

        result = self.run_here("solve", "box.stl", "-o", "out", "--resolution", "16", preexec_fn=small_files_only)
        self.assert_fails(result, OUTPUT, "field.vtu", "too large", "-o")
        self.assertEqual(self.names(), ["box.stl"])

        self.assert_succeeds(self.run_here("solve", "box.stl", "-o", "out", "--resolution", "16"))
        files = {path.name: path.read_bytes() for path in (self.folder / "out").iterdir()}
        result = self.run_here("solve", "box.stl", "-o", "out", "--resolution", "24", preexec_fn=small_files_only)
        self.assert_fails(result, OUTPUT)
        self.assertEqual({path.name: path.read_bytes() for path in (self.folder / "out").iterdir()}, files)

    def test_a_full_standard_output_is_told(self):
        with open("/dev/full", "wb") as full:
            for arguments in (["spectrum", "--preset", "cube"], ["solve", "box.stl", "--resolution", "8"], ["--version"], ["--help"],
                              ["help", "hex"], ["hex", "--help"]):
                result = subprocess.run([PROGRAM, *arguments], stdout=full, stderr=subprocess.PIPE, cwd=self.folder,
                                        timeout=60, check=False)
                self.assertEqual(result.returncode, OUTPUT)
                self.assertEqual(result.stderr.count(b"\n"), 1)
                self.assertIn(b"standard output", result.stderr)

    def test_a_standard_output_that_nobody_reads_ends_it_like_any_program_and_leaves_nothing(self):
        for command in ("solve", "hex"):
            reading, writing = os.pipe()
            os.close(reading)
            with os.fdopen(writing, "wb") as closed:
                result = subprocess.run([PROGRAM, command, "box.stl", "-o", "out"], stdout=closed, stderr=subprocess.PIPE, cwd=self.folder,
                                        timeout=60, check=False)
            self.assertEqual((result.returncode, result.stderr), (-signal.SIGPIPE, b""))
            self.assertEqual(os.listdir(self.folder), ["box.stl"])

    def test_a_place_in_which_nothing_can_be_made_is_told(self):
        self.assert_fails(self.run_here("solve", "box.stl", "-o", "/proc/out"), OUTPUT, "/proc/out", "cannot be created: No such file")


if __name__ == "__main__":
    unittest.main()
