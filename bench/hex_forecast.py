#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Prints how many hexahedra were expected and made of parts: docs/notes/hexahedra.md, "The forecast".

Usage: hex_forecast.py --program PROGRAM --out FOLDER [--cells N] [--seconds S] PART...
Runs `crossgrain hex --cells N` for each part, stopped after S seconds with its best mesh so far; results that are in
FOLDER already are not made again. The ratio is that of the larger number to the smaller; the last line counts those
within a factor of two, of whole meshes and of all.
"""

import argparse
import json
import signal
import subprocess
from pathlib import Path

WITHIN = 2


def result_of(part, options):
    """The section of the report about hexahedra; None without a mesh."""
    # A part may be there as STEP and as STL.
    folder = Path(options.out) / part.name.replace(".", "_")
    if not (folder / "report.json").exists():
        command = [options.program, "hex", part, "--cells", str(options.cells), "-o", folder, "--no-report", "--quiet"]
        with subprocess.Popen(command, stderr=subprocess.DEVNULL) as process:
            try:
                process.wait(options.seconds)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGINT)
                process.wait()
    if not (folder / "report.json").exists():
        return None
    return json.loads((folder / "report.json").read_text(encoding="utf-8"))["hexahedra"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("--cells", type=float, default=20)
    parser.add_argument("--seconds", type=float, default=120)
    parser.add_argument("parts", nargs="+", type=Path)
    options = parser.parse_args()
    Path(options.out).mkdir(parents=True, exist_ok=True)
    print("| part | result | expected | made | ratio |\n|---|---|---|---|---|")
    ratios = {True: [], False: []}
    for part in options.parts:
        made = result_of(part, options)
        if made is None or made["hexahedra"] == 0:
            print(f"| {part.name} | none | | | |", flush=True)
            continue
        ratio = max(made["expected"], made["hexahedra"]) / max(1, min(made["expected"], made["hexahedra"]))
        ratios[made["outcome"] == "all-hex"].append(ratio)
        print(f"| {part.name} | {made['outcome']} | {made['expected']:.0f} | {made['hexahedra']} | {ratio:.2f} |", flush=True)
    for name, of in (("whole meshes", ratios[True]), ("all", ratios[True] + ratios[False])):
        print(f"{sum(ratio <= WITHIN for ratio in of)} of {len(of)} {name} are within a factor of {WITHIN}.")


if __name__ == "__main__":
    main()
