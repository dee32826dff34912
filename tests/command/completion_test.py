#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Completions for bash, zsh and fish offer what the program's help lists, and man pages exist for all commands.

CROSSGRAIN_DOCUMENTS is the folder that the build has written them to. Without a shell its tests are skipped.
"""

import gzip
import os
import pty
import re
import select
import shutil
import subprocess
import time
import unittest
from pathlib import Path

from program import KEPT, CommandTest, run

DOCUMENTS = Path(os.environ.get("CROSSGRAIN_DOCUMENTS", ""))
COMMANDS = ["solve", "sample", "spectrum", "check", "hex", "fit", "streamlines", "tets", "render", "view"]
WAIT_S = 20
BEHIND = "end_of_offers"


def options_of(command):
    """All names of options in the help of a command."""
    names = re.findall(r"^  (-\S+)", run(command, "--help").stdout, re.MULTILINE)
    return {name.split("{")[0] for group in names for name in group.split(",")}


def choices_in_help():
    """(command, option, words) for every option of one of several words."""
    for command in COMMANDS:
        for names, words in re.findall(r"^  (-\S+) ([a-z0-9-]+(?:\|[a-z0-9-]+)+)$", run(command, "--help").stdout, re.MULTILINE):
            yield command, names.split(",")[-1], words.split("|")


class Completion:
    """Cases of all shells; `offers_of(lines)` returns for each the words that a shell offers at its end. One shell answers all."""

    shell = ""

    def setUp(self):
        super().setUp()
        if shutil.which(self.shell) is None:
            self.skipTest(f"{self.shell} is not installed")
        self.write("part.stl", "")
        (self.folder / "part.frames").mkdir()

    def offers(self, line):
        return self.offers_of([line])[0]

    def test_commands(self):
        self.assertEqual(set(self.offers("crossgrain ")) - {"--help", "-h", "--version"}, {*COMMANDS, "help"})
        self.assertEqual(self.offers("crossgrain st"), ["streamlines"])

    def test_options(self):
        self.assertEqual(self.offers("crossgrain solve part.stl --reso"), ["--resolution"])
        offered = self.offers_of([f"crossgrain {command} --" for command in COMMANDS])
        for command, words in zip(COMMANDS, offered):
            long_names = {name for name in options_of(command) if name.startswith("--")}
            self.assertEqual({word for word in words if word.startswith("--")}, long_names)

    def test_choices(self):
        cases = list(choices_in_help())
        self.assertGreater(len(cases), 6)
        offered = self.offers_of([f"crossgrain {command} {option} " for command, option, _ in cases])
        for (command, option, words), found in zip(cases, offered):
            with self.subTest(command=command, option=option):
                self.assertEqual(set(found), set(words))

    def test_choices_besides_other_values(self):
        self.assertEqual(self.offers("crossgrain render part.frames --view bo"), ["bottom"])
        self.assertEqual(set(self.offers("crossgrain streamlines part.frames --on ")), {"volume", "surface", "x", "y", "z"})

    def test_lists(self):
        self.assertEqual([word.rstrip(",").split(",")[-1] for word in self.offers("crossgrain solve a.mesh --write fra,per")], ["perm"])

    def test_files(self):
        self.assertEqual({word.rstrip("/") for word in self.offers("crossgrain solve pa")}, {"part.stl", "part.frames"})

    def test_folders(self):
        for line in ("crossgrain check pa", "crossgrain solve part.stl --from pa", "crossgrain solve part.stl -o pa"):
            self.assertEqual([word.rstrip("/") for word in self.offers(line)], ["part.frames"])

    def test_commands_behind_help(self):
        self.assertIn("solve", self.offers("crossgrain help "))

    def test_no_files_for_numbers(self):
        self.assertEqual(self.offers("crossgrain solve part.stl --resolution "), [])

    def test_of_the_program_for_several_processes(self):
        self.assertEqual(self.offers("crossgrain-mpi solve part.stl --resta"), ["--restart"])


class Bash(Completion, CommandTest):
    shell = "bash"

    def offers_of(self, lines):
        script = f"source {DOCUMENTS}/bash/crossgrain; source {DOCUMENTS}/bash/crossgrain-mpi\n"
        for line in lines:
            words = line.replace("=", " = ").split(" ")
            script += f"""COMPREPLY=(); COMP_WORDS=({' '.join(words)} {'""' if words[-1] == '' else ''}); COMP_CWORD={len(words) - 1}
                $(complete -p {words[0]} | sed 's/.*-F \\([^ ]*\\).*/\\1/'); printf '%s\\n' "${{COMPREPLY[@]}}" {BEHIND}\n"""
        result = subprocess.run(["bash", "-c", script], cwd=self.folder, capture_output=True, text=True, timeout=WAIT_S, check=True)
        self.assertEqual(result.stderr, "")
        return [words.split() for words in result.stdout.split(BEHIND)[:-1]]

    def test_values_behind_an_equals_sign(self):
        self.assertEqual(self.offers("crossgrain solve part.stl --boundary=smo"), ["smooth-only"])
        self.assertEqual(set(self.offers("crossgrain solve part.stl --boundary=")), {"all", "smooth-only"})


class Fish(Completion, CommandTest):
    shell = "fish"

    def offers_of(self, lines):
        script = f"source {DOCUMENTS}/fish/crossgrain.fish; source {DOCUMENTS}/fish/crossgrain-mpi.fish\n"
        script += "".join(f"complete -C '{line}'; echo {BEHIND}\n" for line in lines)
        environment = {**os.environ, "HOME": str(self.folder / "home"), "TERM": "dumb"}
        result = subprocess.run(["fish", "--no-config", "-c", script], cwd=self.folder, env=environment, capture_output=True, text=True,
                                timeout=WAIT_S, check=True)
        return [[offer.split("\t")[0] for offer in words.splitlines() if offer] for words in result.stdout.split(f"{BEHIND}\n")[:-1]]


class Zsh(Completion, CommandTest):
    """zsh completes in its line editor only, so it runs on a terminal, and a widget writes what it would list."""

    shell = "zsh"
    SETUP = """
        PS1= PS2= RPS1=; setopt no_beep
        autoload -Uz compinit; fpath=({documents}/zsh $fpath); compinit -u -d {kept}/zsh.dump
        compadd() {{
          # With -A, -D and -O it only sorts words out.
          if [[ " ${{@[1,(i)(-|--)]}} " != *\ -[ADO]\ * ]]; then
            local -a hits
            builtin compadd -A hits "$@"
            print -rl -- $hits >> {folder}/.offers
          fi
          builtin compadd "$@"
        }}
        bindkey '^I' list-choices
        zle-line-init() {{ print ready > {folder}/.ready }}
        zle -N zle-line-init
    """

    def offers_of(self, lines):
        (self.folder / ".ready").unlink(missing_ok=True)
        setup = self.write(".setup", self.SETUP.format(documents=DOCUMENTS, folder=self.folder, kept=KEPT.name))
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(self.folder)
            os.execvpe("zsh", ["zsh", "-f", "-i"], {**os.environ, "TERM": "vt100", "HOME": str(self.folder)})
        try:
            os.write(terminal, f"source {setup}\n".encode())
            self.wait_for(".ready", terminal)
            return [self.offers_on(terminal, line) for line in lines]
        finally:
            os.kill(child, 9)
            os.waitpid(child, 0)
            os.close(terminal)

    def offers_on(self, terminal, line):
        for name in (".offers", ".done"):
            (self.folder / name).unlink(missing_ok=True)
        os.write(terminal, line.encode() + b"\t")
        (self.folder / ".ready").unlink()
        # The line editor takes up keys in their order: this one when the list is complete.
        os.write(terminal, b"\x15print done > .done\n")
        for name in (".done", ".ready"):  # a line that is typed before the next prompt is not completed
            self.wait_for(name, terminal)
        offered = self.folder / ".offers"
        return list(dict.fromkeys(offered.read_text().split())) if offered.exists() else []

    def wait_for(self, name, terminal):
        deadline = time.monotonic() + WAIT_S
        while not (self.folder / name).exists():
            self.assertLess(time.monotonic(), deadline, f"zsh has not written {name}")
            if select.select([terminal], [], [], 0.02)[0]:
                os.read(terminal, 65536)


class ManPages(unittest.TestCase):
    def test_there_is_one_for_each_command_with_all_its_options(self):
        for command in COMMANDS:
            text = gzip.decompress((DOCUMENTS / "man" / f"crossgrain-{command}.1.gz").read_bytes()).decode()
            for option in options_of(command):
                self.assertIn("\\fB" + option.replace("-", "\\-") + "\\fR", text)

    def test_roff_has_no_faults(self):
        if shutil.which("groff") is None:
            self.skipTest("groff is not installed")
        for page in sorted((DOCUMENTS / "man").glob("*.gz")):
            result = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z"], input=gzip.decompress(page.read_bytes()),
                                    capture_output=True, timeout=WAIT_S, check=True)
            self.assertEqual(result.stderr.decode(), "", page.name)


if __name__ == "__main__":
    unittest.main()
