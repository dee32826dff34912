#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Progress of `solve`: a line a level, rewritten in place on a terminal and within its width; plain lines elsewhere."""

import fcntl
import os
import pty
import re
import select
import struct
import subprocess
import termios
import time
import unittest

from program import PROGRAM, CommandTest, medit_text, stl_bytes, tet_box, torus_triangles

LEVEL = re.compile(r"level (\d+) of (\d+): ")


def set_width(terminal, columns):
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))


class Progress(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("torus.stl", stl_bytes(torus_triangles()))

    def shown_on_terminal(self, *arguments, columns=100, term="xterm", meanwhile=None, command=("solve", "torus.stl")):
        """What a terminal of so many columns gets; `meanwhile` is called with it and with all that it got so far."""
        master, terminal = pty.openpty()
        set_width(terminal, columns)
        process = subprocess.Popen([PROGRAM, *command, *map(str, arguments)], stdout=subprocess.DEVNULL,
                                   stderr=terminal, cwd=self.folder, env={**os.environ, "TERM": term})
        shown, end = "", time.monotonic() + 100
        while time.monotonic() < end:
            ready = select.select([master], [], [], 0.05)[0]
            if ready:
                shown += os.read(master, 65536).decode()
                if meanwhile:
                    meanwhile(terminal, shown)
            elif process.poll() is not None:
                break
        self.assertEqual(process.wait(timeout=10), 0)
        os.close(terminal)
        os.close(master)
        return shown

    @staticmethod
    def rewritten(shown):
        """Every text that stood on a line, without control characters."""
        return [part.replace("\x1b[K", "") for part in re.split(r"[\r\n]+", shown)]

    @staticmethod
    def final_lines(shown):
        """What stays: of each line the last text."""
        return [line.rstrip("\r").rsplit("\r", 1)[-1].replace("\x1b[K", "") for line in shown.split("\n")[:-1]]

    def assert_a_line_a_level(self, lines):
        levels = [tuple(map(int, match.groups())) for match in map(LEVEL.match, lines) if match]
        self.assertGreater(len(levels), 1)
        self.assertEqual(levels, [(k + 1, len(levels)) for k in range(len(levels))])
        for line in lines:
            if LEVEL.match(line):
                self.assertRegex(line, r"^level \d+ of \d+: [\d.]+( million)? cells, energy [\d.e+]+, \d+\.\d s$")

    def test_on_a_terminal_a_level_has_one_line_which_is_rewritten_and_stays(self):
        shown = self.shown_on_terminal("--resolution", 64)
        self.assert_a_line_a_level(self.final_lines(shown))
        self.assertGreater(shown.count("\r"), shown.count("\r\n") + 8)

    def test_phases_beside_the_levels_have_a_line_each(self):
        lines = self.final_lines(self.shown_on_terminal("--resolution", 16))
        self.assertEqual(lines[0], "read")
        self.assertRegex(lines[-2], r"^analysis: \d+ cells$")
        self.assertEqual(lines[-1], "write")

    def test_nothing_is_wider_than_the_terminal(self):
        for columns, room in ((30, 29), (12, 11), (1, 0), (0, 79)):
            with self.subTest(columns=columns):
                shown = self.shown_on_terminal("--resolution", 16, columns=columns)
                self.assertLessEqual(max(map(len, self.rewritten(shown))), room)

    def test_a_terminal_that_gets_narrower_is_noticed(self):
        narrow_from = []

        def make_narrow(terminal, shown):
            if "level 2 of" in shown and not narrow_from:
                set_width(terminal, 20)
                narrow_from.append(len(shown))

        shown = self.shown_on_terminal("--resolution", 128, meanwhile=make_narrow)
        last = self.final_lines(shown[narrow_from[0]:])[-3:]
        self.assertLessEqual(max(map(len, last)), 19)
        self.assertTrue(last[0].startswith("level "))

    def test_the_time_that_remains_is_told_where_it_is_expected(self):
        shown = self.shown_on_terminal("--resolution", 128)
        self.assertRegex(shown, r"about \d+ (s|min) left")
        self.assertNotRegex("\n".join(self.final_lines(shown)), "left")

    def test_of_hexahedra_begins_with_the_time_which_no_narrow_terminal_cuts_off(self):
        self.write("box.mesh", medit_text(*tet_box()))
        for columns in (100, 40):
            with self.subTest(columns=columns):
                shown = self.shown_on_terminal("--cells", 4, "--no-report", columns=columns, command=("hex", "box.mesh", "-o", f"out{columns}"))
                lines = [line for line in self.rewritten(shown) if "attempt 1: " in line and "fill" not in line]
                self.assertGreater(len(lines), 4)
                for line in lines:
                    self.assertRegex(line, r"^ *\d+\.\d s  attempt 1: [a-z]")
                    self.assertLess(len(line), columns)
                self.assertRegex("\n".join(self.final_lines(shown)), r"attempt 1: mapping( took \d+\.\d s)?\n")
                self.assertIn("attempt 1: 24 hexahedra fill the model", shown)

    def test_a_dumb_terminal_gets_plain_lines(self):
        shown = self.shown_on_terminal("--resolution", 32, term="dumb")
        self.assertNotIn("\x1b", shown)
        self.assert_a_line_a_level(self.final_lines(shown))

    def test_a_terminal_gets_nothing_where_it_is_to_be_quiet(self):
        self.assertEqual(self.shown_on_terminal("--resolution", 16, "--quiet"), "")
        self.assertEqual(self.shown_on_terminal("--resolution", 16, "--quiet", "--progress"), "")

    def test_elsewhere_there_is_nothing_unless_asked_for_and_then_a_plain_line_a_level(self):
        self.assertEqual(self.run_here("solve", "torus.stl", "--resolution", 16).stderr, "")
        result = self.run_here("solve", "torus.stl", "--resolution", 32, "--progress")
        self.assertRegex(result.stderr, r"\A[ -~\n]*\Z")
        self.assert_a_line_a_level(result.stderr.splitlines())


if __name__ == "__main__":
    unittest.main()
