#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The help of each command fits the terminal, has examples that can be typed, and calls values by plain words."""

import fcntl
import os
import pty
import re
import shlex
import struct
import termios
import unittest

from completion_test import COMMANDS
from program import PROGRAM, CommandTest, run

USAGE = 2


def help_on_terminal(command, columns):
    """What --help prints on a terminal of so many columns."""
    child, terminal = pty.fork()
    if child == 0:
        fcntl.ioctl(1, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        os.execv(PROGRAM, [PROGRAM, *command, "--help"])
    text = b""
    while True:
        try:
            part = os.read(terminal, 65536)
        except OSError:  # the end, on Linux
            part = b""
        if not part:
            break
        text += part
    os.close(terminal)
    os.waitpid(child, 0)
    return text.decode().replace("\r\n", "\n")


def examples_of(command):
    """Lines to type, without remarks."""
    text = run(command, "--help").stdout
    return [line.split("#")[0].strip() for line in text.split("Examples:\n")[1].split("\n\n")[0].splitlines() if line.startswith("  ")]


class Help(CommandTest):
    def test_fits_into_80_columns_without_a_terminal(self):
        for command in ([], *[[name] for name in [*COMMANDS, "help"]]):
            for line in run(*command, "--help").stdout.splitlines():
                self.assertLessEqual(len(line), 80, line)

    def test_fits_the_terminal(self):
        for columns in (50, 120):
            for command in ([], ["hex"]):
                lines = help_on_terminal(command, columns).splitlines()
                self.assertGreater(len(lines), 10)
                self.assertTrue(any(len(line) > columns - 20 for line in lines))
                # A single word, or an option with its value, may be longer.
                for line in lines:
                    self.assertTrue(len(line) <= columns or len(line.split()) <= 2, line)

    def test_has_two_examples_of_each_command_that_can_be_typed(self):
        for command in COMMANDS:
            examples = examples_of(command)
            self.assertGreaterEqual(len(examples), 2, command)
            self.assertTrue(all(example.startswith("crossgrain ") for example in examples))
            for example in examples:
                if command == "view" or example.startswith("crossgrain view"):
                    continue
                result = self.run_here(*shlex.split(example)[1:])
                self.assertNotEqual(result.returncode, USAGE, result.stderr)  # but there is no such file

    def test_tells_what_exit_codes_say_of_the_result(self):
        for command in COMMANDS:
            codes = " ".join(run(command, "--help").stdout.split("Exit codes: ")[1].split())
            self.assertRegex(codes, r"^0 .*; 2 wrong usage; 3 bad input")
            self.assertEqual("6 " in codes, command in ("hex", "fit"))

    def test_calls_values_by_plain_words(self):
        for command in COMMANDS:
            text = run(command, "--help").stdout
            self.assertNotRegex(text, r"\bin \[|:INT|:FLOAT|\{|\bREQUIRED\b")
            self.assertEqual(re.findall(r"^  -\S+\{", text, re.MULTILINE), [])
        self.assertRegex(run("solve", "--help").stdout, r"(?m)^  --no-report\s")


if __name__ == "__main__":
    unittest.main()
