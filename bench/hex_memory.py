#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints, for each model, what memory `hex` takes in its stages, and whether it keeps to limits.

A table in Markdown of runs without a limit: the largest resident memory of the program with its helpers by stage, in bytes for each
tet beyond the start of the repair, and for each hexahedron beyond the start of the extraction. Then runs under shares of that memory:
the peak, which may not exceed the limit, and the exit code (5: refused by the limit).
"""
import argparse
import json
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests/command"))
from resident_memory import resident_bytes_with_descendants

SHARES = (0.3, 0.5, 0.7, 0.9, 1.1)
PAUSE_S = 0.002


class Run:
    def __init__(self, command, model, limit=0, options=()):
        self.stages, self.stage, self.tets, self.hexahedra = {}, "start", 0, 0
        with tempfile.TemporaryDirectory(prefix="crossgrain-memory-") as folder:
            whole = [*command, str(model), "-o", f"{folder}/out", "--progress", "json", *options]
            if limit:
                whole += ["--max-memory", f"{int(limit)}"]
            process = subprocess.Popen(whole, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            reader = threading.Thread(target=self.read, args=(process.stdout,))
            reader.start()
            while process.poll() is None:
                now = resident_bytes_with_descendants(process.pid)
                first, most = self.stages.get(self.stage, (now, now))
                self.stages[self.stage] = first, max(most, now)
                time.sleep(PAUSE_S)
            reader.join()
            self.code = process.returncode
        self.peak = max(most for _, most in self.stages.values())

    def read(self, stream):
        self.last = ""
        for line in stream:
            if not line.startswith("{"):
                self.last = line.strip()
                continue
            event = json.loads(line)
            if event["event"] == "progress":
                self.stage = event["phase"]
            elif event["event"] == "expected":
                self.tets = event["tets"]
            elif event["event"] == "attempt":
                self.hexahedra = max(self.hexahedra, event["hexahedra"])

    def grown(self, begin, stages, count):
        """Bytes for each of `count` beyond the begin of a stage."""
        if begin not in self.stages or not count:
            return "-"
        most = max(self.stages[stage][1] for stage in stages if stage in self.stages)
        return f"{(most - self.stages[begin][0]) / count:,.0f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("models", nargs="+", type=Path)
    parser.add_argument("--command", default="hex", help="with its options")
    parser.add_argument("--shares", type=float, nargs="*", default=SHARES, help="of the memory without a limit")
    arguments = parser.parse_args()
    command = [arguments.program, *arguments.command.split()]
    print("| model | tets | hexahedra | peak, MB | bytes a tet | bytes a hexahedron | limits: peak, exit |")
    print("|---|---:|---:|---:|---:|---:|---|")
    exceeded = 0
    for model in arguments.models:
        free = Run(command, model)
        limited = []
        for share in arguments.shares:
            limit = share * free.peak
            run = Run(command, model, limit)
            exceeded += run.peak > limit
            limited.append(f"{limit / 1e6:.0f}: {run.peak / 1e6:.0f}{'**' if run.peak > limit else ''}, {run.code}")
        print(f"| {model.name} | {free.tets} | {free.hexahedra} | {free.peak / 1e6:.0f} | {free.grown('repair', ['repair', 'map'], free.tets)} "
              f"| {free.grown('hexahedra', ['hexahedra', 'smooth'], free.hexahedra)} | {'; '.join(limited)} |", flush=True)
    print(f"\n{exceeded} runs took more than their limit")


if __name__ == "__main__":
    main()
