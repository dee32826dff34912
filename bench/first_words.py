#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints, for each model, when `hex` first says how it will end, how it ends, and how good its forecast was.

A table in Markdown: processor seconds to the first line that tells the outcome and in all, helpers included; exit code; number of
hexahedra told before the attempt whose mesh is written, told within it before vertices move onto the model (0 where they need not), and made; the lines
`hexahedra` and `worst`. Then how many forecasts were within a factor of two, of these, of all lattices that were tried, and of the numbers told last. The
line that tells is that of the first attempt that fills the model, the line `hexahedra` itself, or an error, whichever comes first.
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

TELLS = re.compile(r"^(hexahedra |crossgrain: (?!warning))")
FILLS = re.compile(r"[\d,]+ hexahedr\w+ fills? ")
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
            command = [program, "hex", model, "-o", f"{folder}/out", "--no-report", "--progress", "json", *options]
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
            lines = sorted((line for reader in readers for line in reader.lines), key=lambda line: line[0])
            self.events = [(at, json.loads(text)) for at, text in lines if text.startswith("{")]
            self.lines = [(at, text) for at, text in lines if not text.startswith("{")]
            report = Path(folder, "out", "report.json")
            self.hexahedra = json.loads(report.read_text(encoding="utf-8"))["hexahedra"] if report.exists() else None

    def first_word(self):
        told = [at for at, text in self.lines if TELLS.search(text)]
        told += [at for at, event in self.events if event["event"] == "attempt" and FILLS.match(event["text"])]
        return min([self.seconds, *told])

    def forecasts(self):
        """By the numbers of attempts, the last number told before the end of each: of maps in the row `expected`, of a lattice with the plan."""
        told, of_maps, next_told = {}, 0, 0
        for _, event in self.events:
            if event["event"] == "expected":
                of_maps = next_told = event["hexahedra"]
            elif event["event"] == "attempt":
                told[event["attempt"]] = next_told
                plan = re.search(r", about ([\d.e+]+)", event["next"])
                next_told = float(plan[1]) if plan else of_maps
        return told, next_told

    def best(self):
        """Number of the attempt whose mesh is written."""
        return self.hexahedra["attempts"][self.hexahedra["best_attempt"]]["number"]

    def forecast(self):
        """The number told before that attempt."""
        told, last = self.forecasts()
        return told.get(self.best(), last)

    def told_within(self):
        """The last number told within that attempt before vertices moved, or 0."""
        return next((event["fitted"] for _, event in reversed(self.events) if event.get("attempt") == self.best() and "fitted" in event), 0)

    def lattices(self):
        """What was told before each lattice that was put onto the model, and what it became."""
        told, last = self.forecasts()
        fitted = [attempt for attempt in self.hexahedra["attempts"] if attempt["kind"] == "lattice" and attempt["outcome"] != "none"]
        return [(told.get(attempt["number"], last), attempt["hexahedra"]) for attempt in fitted]

    def words(self):
        kept = [text.split(None, 1)[1] for _, text in self.lines if re.match(r"(hexahedra|worst) +\S", text)]
        return "; ".join(kept) if kept else next((text for _, text in reversed(self.lines) if text.startswith("crossgrain:")), "")


def ratio_of(one, other):
    return max(one, other) / min(one, other) if min(one, other) > 0 else float("inf")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("models", nargs="+", type=Path)
    parser.add_argument("--limit", type=float, default=900, help="seconds after which a run is ended, with its best mesh")
    parser.add_argument("--options", default="--cells 20", help="of hex")
    arguments = parser.parse_args()
    print("| model | first word | in all | exit | expected | within | made | words |\n|---|---:|---:|---:|---:|---:|---:|---|")
    ratios, of_lattices, within = {True: [], False: []}, [], []
    for model in arguments.models:
        run = Run(arguments.program, model, arguments.options.split(), arguments.limit)
        expected, last, made = (run.forecast(), run.told_within(), run.hexahedra["hexahedra"]) if run.hexahedra else (0, 0, 0)
        if made > 0:
            ratios[run.hexahedra["outcome"] == "all-hex"].append(ratio_of(expected, made))
            within.append(ratio_of(last or expected, made))
        if run.hexahedra:
            of_lattices += [ratio_of(told, became) for told, became in run.lattices() if min(told, became) > 0]
        print(f"| {model.name} | {run.first_word():.1f} | {run.seconds:.1f} | {run.code} | {expected:.0f} | {last} | {made} | {run.words()} |", flush=True)
    for name, of in (("whole meshes", ratios[True]), ("all", ratios[True] + ratios[False]), ("lattices", of_lattices), ("meshes, as told last,", within)):
        print(f"\n{sum(ratio <= WITHIN for ratio in of)} of {len(of)} {name} are within a factor of {WITHIN} of their forecast.")


if __name__ == "__main__":
    sys.exit(main())
