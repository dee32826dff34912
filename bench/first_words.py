#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints, for each model, when `hex` first says how it will end, how it ends, and how good its forecast was.

A table in Markdown: processor seconds to the first line that tells the outcome and in all, helpers included; exit code; number of
hexahedra told before the attempt whose mesh is written, and made; the lines `hexahedra` and `worst`. Then how many forecasts were within a factor of two, of these
and of all lattices that were tried. The line that
tells is that of the first attempt that fills the model, the line `hexahedra` itself, or an error, whichever comes first.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

TELLS = re.compile(r"^(hexahedra |attempt \d+: [\d,]+ hexahedr\w+ fills? |crossgrain: (?!warning))")
WITHIN = 2


def processor_seconds(process):
    """Of a running process and of those that it has waited for; none of one that has ended."""
    try:
        fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    except (FileNotFoundError, ProcessLookupError):
        return float("inf")
    return sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")


class Reader(threading.Thread):
    """Lines of a stream, each with the processor seconds until it came."""

    def __init__(self, stream, process):
        super().__init__()
        self.stream, self.process, self.lines = stream, process, []
        self.start()

    def run(self):
        for line in iter(self.stream.readline, ""):
            self.lines.append((processor_seconds(self.process), line.rstrip()))


class Run:
    def __init__(self, program, model, options, limit):
        with tempfile.TemporaryDirectory(prefix="crossgrain-words-") as folder:
            command = [program, "hex", model, "-o", f"{folder}/out", "--no-report", "--progress", *options]
            process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            readers = [Reader(stream, process.pid) for stream in (process.stdout, process.stderr)]
            ending = threading.Timer(limit, process.terminate)
            ending.start()
            _, status, used = os.wait4(process.pid, 0)
            ending.cancel()
            for reader in readers:
                reader.join()
            self.code, self.seconds = os.waitstatus_to_exitcode(status), used.ru_utime + used.ru_stime
            process.returncode = self.code
            self.lines = sorted((line for reader in readers for line in reader.lines), key=lambda line: line[0])
            report = Path(folder, "out", "report.json")
            self.hexahedra = json.loads(report.read_text(encoding="utf-8"))["hexahedra"] if report.exists() else None

    def first_word(self):
        return min(self.seconds, next((at for at, text in self.lines if TELLS.search(text)), self.seconds))

    def forecasts(self):
        """By the numbers of attempts, the last number told before the end of each: of maps in the row `expected`, of a lattice with the plan."""
        told, of_maps, next_told = {}, 0, 0
        for _, text in self.lines:
            if expected := re.match(r"expected +about ([\d.e+]+)", text):
                of_maps = next_told = float(expected[1])
            elif ended := re.match(r"attempt (\d+):", text):
                told[int(ended[1])] = next_told
                plan = re.search(r"; trying .*, about ([\d.e+]+)", text)
                next_told = float(plan[1]) if plan else of_maps
        return told, next_told

    def forecast(self):
        """The number told before the attempt whose mesh is written."""
        told, last = self.forecasts()
        return told.get(self.hexahedra["attempts"][self.hexahedra["best_attempt"]]["number"], last)

    def lattices(self):
        """What was told before each lattice that was put onto the model, and what it became."""
        told, last = self.forecasts()
        fitted = [attempt for attempt in self.hexahedra["attempts"] if attempt["kind"] == "lattice" and attempt["outcome"] != "none"]
        return [(told.get(attempt["number"], last), attempt["hexahedra"]) for attempt in fitted]

    def words(self):
        kept = [text.split(None, 1)[1] for _, text in self.lines if re.match(r"(hexahedra|worst) +\S", text)]
        return "; ".join(kept) if kept else next((text for _, text in reversed(self.lines) if text.startswith("crossgrain:")), "")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("models", nargs="+", type=Path)
    parser.add_argument("--limit", type=float, default=900, help="seconds after which a run is ended, with its best mesh")
    parser.add_argument("--options", default="--cells 20", help="of hex")
    arguments = parser.parse_args()
    print("| model | first word | in all | exit | expected | made | words |\n|---|---:|---:|---:|---:|---:|---|")
    ratios, of_lattices = {True: [], False: []}, []
    for model in arguments.models:
        run = Run(arguments.program, model, arguments.options.split(), arguments.limit)
        expected, made = (run.forecast(), run.hexahedra["hexahedra"]) if run.hexahedra else (0, 0)
        if made > 0:
            ratios[run.hexahedra["outcome"] == "all-hex"].append(max(expected, made) / min(expected, made))
        if run.hexahedra:
            of_lattices += [max(told, became) / min(told, became) for told, became in run.lattices() if min(told, became) > 0]
        print(f"| {model.name} | {run.first_word():.1f} | {run.seconds:.1f} | {run.code} | {expected:.0f} | {made} | {run.words()} |", flush=True)
    for name, of in (("whole meshes", ratios[True]), ("all", ratios[True] + ratios[False]), ("lattices", of_lattices)):
        print(f"\n{sum(ratio <= WITHIN for ratio in of)} of {len(of)} {name} are within a factor of {WITHIN} of their forecast.")


if __name__ == "__main__":
    sys.exit(main())
