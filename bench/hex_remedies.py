#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether the remedies of `crossgrain hex` help: runs it on models, and again as it says, where no mesh fills a model.

    bench/hex_remedies.py --program build/release/apps/crossgrain/crossgrain --out OUT MODEL... [-- OPTIONS OF hex]

Prints a table: what came out, what was to be tried, and what came of that. OPTIONS are pairs of a word and its value.
"""

import argparse
import json
import subprocess
import sys
import time
from pathlib import Path

NOT_ALL_HEX = 6


def result_of(program, model, folder, options):
    """The section `hexahedra` of the report, and the seconds; none where the program fails."""
    begun = time.monotonic()
    run = subprocess.run([program, "hex", model, "-o", folder, "--force", "--quiet", "--no-report", *options], capture_output=True, text=True, check=False)
    seconds = time.monotonic() - begun
    if run.returncode not in (0, NOT_ALL_HEX):
        return {"outcome": run.stderr.strip()}, seconds
    return json.loads((folder / "report.json").read_text(encoding="utf-8"))["hexahedra"], seconds


def remedy_options(made, options):
    """The options of the first run with those of the remedy; none if it names no option."""
    name = {"use_edge_length": "--tet-size", "use_hex_size": "--size"}.get(made.get("remedy"))
    if name is None:
        return None
    others = {name, "--cells"} if name == "--size" else {name}
    pairs = [(word, value) for word, value in zip(options[::2], options[1::2]) if word not in others]
    return [word for pair in [*pairs, (name, f"{made['remedy_number']:.6g}")] for word in pair]


def sizes_of(made):
    return ", ".join(f"{attempt['tet_size']:.3g}" for attempt in made.get("attempts", []) if attempt.get("tet_size"))


def main():
    words = sys.argv[1:]
    at = words.index("--") if "--" in words else len(words)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("models", nargs="+", type=Path)
    arguments = parser.parse_args(words[:at])
    options = words[at + 1:]
    arguments.out.mkdir(parents=True, exist_ok=True)
    print("| part | result | tets tried | s | remedy | result then | s |")
    print("|---|---|---|---|---|---|---|")
    for model in arguments.models:
        made, seconds = result_of(arguments.program, model, arguments.out / f"{model.stem}.first", options)
        row = [model.stem, made.get("sentence", made["outcome"]), sizes_of(made), f"{seconds:.0f}"]
        again = remedy_options(made, options)
        if again:
            then, then_seconds = result_of(arguments.program, model, arguments.out / f"{model.stem}.then", again)
            row += [" ".join(again[-2:]), then.get("sentence", then["outcome"]), f"{then_seconds:.0f}"]
        else:
            row += [made.get("next", ""), "", ""]
        print("| " + " | ".join(row) + " |", flush=True)


if __name__ == "__main__":
    main()
