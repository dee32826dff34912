#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the predictions of solves with their results.

Usage: bench/prediction.py PROGRAM [--part NAME]... [--resolution N]... [--threads N]

Prints, for each part and resolution, the expected and actual cells, memory and seconds of `report.json`, and exits with 1 if one
of them is wrong by more than a factor of 1.5. Times are reliable only on an idle machine: use `--no-time` on a loaded one.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from scaling import models, say

PARTS = ["bracket", "housing", "pipe_branch", "pillow_block", "wedge", "sphere"]
RESOLUTIONS = [128, 256, 512, 1024]
MOST_OFF = 1.5


def report_of(program, model, resolution, threads, folder):
    """Returns the report.json of a solve; prints a message and returns None if it failed."""
    command = [program, "solve", model, "-o", folder, "--resolution", resolution, "--threads", threads, "--quiet"]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    if done.returncode == 0:
        return json.loads((folder / "report.json").read_text())
    say(f"{model.name} at {resolution}: {done.stderr.strip()}")
    return None


def compared(report):
    """Returns {what: (expected, actual)}; empty for a field too small for a prediction."""
    expected = report.get("expected")
    if not expected:
        return {}
    return {"cells": (expected["active_cells"], report["levels"][-1]["active_cells"]),
            "memory": (expected["peak_memory_bytes"], report["peak_memory_bytes"]),
            "time": (expected["seconds"], report["seconds"]["total"])}


def entry(expected, actual, unit):
    return f"{expected / unit:.3g} / {actual / unit:.3g}: {expected / actual:.2f}"


def parsed_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the built command line program")
    parser.add_argument("--part", action="append", metavar="NAME", help="of models/, or sphere or tube (default all but the tube)")
    parser.add_argument("--resolution", action="append", type=int, metavar="N", help="default 128, 256, 512 and 1024")
    parser.add_argument("--threads", type=int, default=os.cpu_count(), help="default all there are")
    parser.add_argument("--no-time", action="store_true", help="times may be off")
    return parser.parse_args()


def main():
    arguments = parsed_arguments()
    units = {"cells": 1e6, "memory": 1e9, "time": 1}
    print("Expected / actual, and their ratio:\n\n| part | N | million cells | GB | seconds | told after |\n|---|---|---|---|---|---|", flush=True)
    off = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, model in models(Path(folder), arguments.part or PARTS).items():
            for resolution in arguments.resolution or RESOLUTIONS:
                report = report_of(arguments.program.resolve(), model, resolution, arguments.threads, Path(folder) / "field")
                found = compared(report) if report else {}
                if not found:
                    continue
                share = report["expected"]["after_seconds"] / report["seconds"]["total"]
                print(f"| {name} | {resolution} | " + " | ".join(entry(*found[what], units[what]) for what in units)
                      + f" | {100 * share:.0f} % |", flush=True)
                checked = [what for what in units if what != "time" or not arguments.no_time]
                off += any(not 1 / MOST_OFF <= found[what][0] / found[what][1] <= MOST_OFF for what in checked)
    if off:
        say(f"{off} runs are off by more than a factor of {MOST_OFF}")
    sys.exit(off > 0)


if __name__ == "__main__":
    main()
