# SPDX-License-Identifier: Apache-2.0
"""Runs of the program in which one system call fails, or which are killed, and what must hold after each.

The environment names the program, the library that makes calls fail, and a program that writes a large result.
"""

import errno
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import integrity
from integrity import Broken, require
from program import PROGRAM, box_triangles, medit_text, stl_bytes, tet_box, torus_triangles

LIBRARY = os.environ.get("CROSSGRAIN_FAULT_LIBRARY", "")
TIME_LIMIT = 120
FOREIGN = "notes.txt"
EVERY_FORMAT = ("--write", "fra,perm,frame,quaternions,features")

# Exit codes of a command of which a system call failed: bad input, output that cannot be written, memory.
ERROR_CODES = {3, 4, 5}

FAULTS = (*(str(code) for code in (errno.EIO, errno.ENOSPC, errno.EACCES, errno.EMFILE)), "kill", "short")


def make_models(folder):
    """Models outside the folder in which calls fail."""
    (folder / "box.stl").write_bytes(stl_bytes(box_triangles()))
    (folder / "torus.stl").write_bytes(stl_bytes(torus_triangles()))
    (folder / "box.mesh").write_text(medit_text(*tet_box()))


class Case:
    """A command, the folder in which it runs, and what may be there afterwards."""

    def __init__(self, name, command, before=(), always="", reads=False, target="out"):
        self.name, self.command, self.before, self.always, self.reads, self.target = (name, command, before, always, reads,
                                                                                      target)

    def prepare(self, models):
        """Makes the folder as it is before, kept aside for all runs."""
        self.models, self.zone, self.kept = models, models / f"faultzone-{self.name}", models / f"before-{self.name}"
        self.zone.mkdir()
        for command in self.before:
            result = self.run(command, {})
            require(result.returncode == 0, result.stderr)
        if self.before:
            (self.zone / "out" / FOREIGN).write_text("mine")
        shutil.copytree(self.zone, self.kept)
        self.old = self.state()
        result = self.run(self.command, self.variables())
        require(result.returncode == 0, result.stderr)
        self.new = self.state()
        self.calls = self.count_calls()
        return self

    def variables(self, **more):
        return {"LD_PRELOAD": LIBRARY, "FAULT_FOLDER": self.zone.name, "FAULT_ALWAYS": self.always, **more}

    def words(self, command):
        return [PROGRAM] + [word.format(zone=self.zone, models=self.models) for word in command]

    def run(self, command, variables):
        return subprocess.run(self.words(command), capture_output=True, text=True, timeout=TIME_LIMIT, check=False,
                              env={**os.environ, **variables}, cwd=self.models)

    def restore(self):
        shutil.rmtree(self.zone)
        shutil.copytree(self.kept, self.zone)

    def count_calls(self):
        self.restore()
        log = self.models / "calls"
        log.write_text("")
        self.run(self.command, self.variables(FAULT_LOG=str(log)))
        return log.read_text().split()

    def state(self):
        """The solve of the result and the bytes of the other file that the command writes; None for what is not there."""
        folder = self.zone / "out"
        if not folder.exists():
            return None, None
        require(not self.before or (folder / FOREIGN).read_text() == "mine", "a file that is no result has changed")
        other = self.zone / "out" / self.target if self.target != "out" else None
        others = {FOREIGN} | ({self.target} if self.target.endswith((".png", ".txt")) else set())
        return (integrity.solve_of_whole(folder, others | self.leftovers(folder)),
                other.read_bytes() if other and other.exists() else None)

    @staticmethod
    def leftovers(folder):
        """What a killed run may leave: hidden files with names of their own."""
        return {path.name for path in folder.iterdir() if path.name.startswith(".") and
                (path.name.endswith(".part") or path.name in (".crossgrain-part", ".crossgrain-replaces"))}

    def complete(self):
        """Lets the next command finish what was begun, where folders are not exchanged."""
        if (self.zone / "out" / ".crossgrain-complete").exists():
            result = self.run(["check", "{zone}/out"], {})
            require(result.returncode == 0, "the next command does not finish the result: " + result.stderr)

    def check_killed(self):
        self.complete()
        try:
            require(self.state() in (self.old, self.new), "neither the old state nor the new one")
        except (Broken, OSError, ValueError) as fault:
            raise Broken(f"not whole: {fault}") from fault
        if self.command[0] == "solve" and any(self.zone.rglob(".*")):
            self.run(self.command, {})
            require(self.state() == self.new, "the next solve does not succeed")
            left = [path.name for path in self.zone.rglob(".*")]
            require(not left, f"the next solve does not clear {left}")

    def check_ended(self, result):
        require(result.returncode >= 0, f"signal {-result.returncode}")
        lines = [line for line in result.stderr.splitlines() if "warning" not in line]
        if result.returncode == 0:
            self.complete()
            require(self.state() == self.new, "it says that it is done, and it is not")
        else:
            require(result.returncode in ERROR_CODES, f"exit code {result.returncode}: {result.stderr}")
            require(len(lines) == 1 and lines[0].startswith("crossgrain: "), f"not one line: {result.stderr}")
        self.check_killed()

    def fail(self, call, fault):
        """Runs the command with a call that fails and checks what is left."""
        self.restore()
        result = self.run(self.command, self.variables(FAULT_CALL=str(call), FAULT=fault))
        if fault == "kill" and result.returncode == -signal.SIGKILL:
            return self.check_killed()
        return self.check_ended(result)

    def kill(self, seconds):
        """Runs the command and kills it after a time. Returns whether it was still running."""
        self.restore()
        process = subprocess.Popen(self.words(self.command), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   cwd=self.models, env={**os.environ, **self.variables()})
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        self.check_killed()
        return process.returncode == -signal.SIGKILL


def solve(model, *more):
    return ["solve", "{models}/" + model, "-o", "{zone}/out", "--resolution", "8", "--quiet", *more]


def all_cases(models):
    torus, force = solve("torus.stl"), ["--force"]
    tets = solve("box.mesh", *EVERY_FORMAT)
    drawn = ["streamlines", "{zone}/out", "--count", "3", "--quiet"]
    new_folder = ["solve", "{models}/box.stl", "-o", "{zone}/out", "--resolution", "8", "--quiet"]
    cases = [
        Case("replace", solve("box.stl", *force), [torus]),
        Case("new", new_folder),
        Case("tets", [*tets, *force], [torus, drawn]),
        Case("grid", solve("box.stl", *force), [tets]),
        Case("inplace", [*tets, *force], [torus, drawn], always="exchange"),
        Case("inplacegrid", solve("box.stl", *force), [tets], always="exchange"),
        Case("nolinks", solve("box.stl", *force), [torus], always="link"),
        Case("streamlines", drawn, [torus], target="streamlines.vtu"),
        Case("render", ["render", "{zone}/out", "--size", "64x64", "-o", "{zone}/out/a.png", "--quiet"], [torus],
             target="a.png"),
        Case("sample", ["sample", "{zone}/out", "0.6", "0", "0", "-o", "{zone}/out/a.txt"], [torus], target="a.txt"),
        Case("check", ["check", "{zone}/out"], [tets], reads=True),
    ]
    make_models(models)
    return [case.prepare(models) for case in cases]


def describe(case, call, fault):
    name = case.calls[call - 1] if call <= len(case.calls) else "?"
    how = errno.errorcode.get(int(fault), fault) if fault.isdigit() else fault
    return f"{case.name}: call {call} of {len(case.calls)} ({name}), {how}"


def broken_faults(faults, show=None):
    """Makes each (case, call, fault); returns a line for each that breaks a promise."""
    broken = []
    for k, (case, call, fault) in enumerate(faults):
        try:
            case.fail(call, fault)
        except (Broken, OSError, subprocess.TimeoutExpired) as failure:
            broken.append(f"{describe(case, call, fault)}: {failure}")
        if show and k % 100 == 99:
            show(f"{k + 1} faults, {len(broken)} broken promises")
    return broken


def say(line):
    print(line, flush=True, file=sys.stdout)


def folder_for_runs():
    """A folder that is not in memory, where a rename or fsync may mean more."""
    return Path(os.environ.get("CROSSGRAIN_FAULT_PLACE", "/var/tmp"))
