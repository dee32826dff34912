#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether the remedies of `crossgrain hex` help: runs it on models, and again as it says, where no mesh fills a model.

    bench/hex_remedies.py --program build/release/apps/crossgrain/crossgrain --out OUT [--limit SECONDS] MODEL... [-- OPTIONS OF hex]

Prints a table: what came out, what was to be tried, and what came of that. A run that takes more processor seconds than the limit is stopped,
and the best so far counts. OPTIONS are pairs of a word and its value.
"""

import argparse
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

NOT_ALL_HEX, APPROXIMATE, STOPPED = 6, 7, 130

# Of its size where smaller hexahedra are to be taken and none is named.
SMALLER = 0.7


def processor_seconds(group):
    """Of all processes of a group, and of those that they have waited for."""
    ticks = 0
    for entry in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = entry.read_text(encoding="utf-8").rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[2]) == group:
            ticks += sum(map(int, fields[11:15]))
    return ticks / os.sysconf("SC_CLK_TCK")


def run_limited(command, limit):
    """Exit code, errors, processor seconds. Past the limit a first SIGTERM stops the search, a second one the program."""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True) as run:
        used, stops = 0, 0
        while run.poll() is None:
            used = max(used, processor_seconds(run.pid))
            if used > limit * (1 + 0.25 * stops):
                run.send_signal(signal.SIGTERM)
                stops += 1
            time.sleep(0.2)
        return run.returncode, run.stderr.read(), used


def result_of(arguments, model, folder, options):
    """The section `hexahedra` of the report, its warnings and processor seconds; no section where the program fails."""
    command = [arguments.program, "hex", model, "-o", folder, "--force", "--quiet", "--no-report", *options]
    code, errors, seconds = run_limited(command, arguments.limit)
    report = folder / "report.json"
    if code not in (0, NOT_ALL_HEX, APPROXIMATE, STOPPED) or not report.exists():
        return {"outcome": errors.strip().splitlines()[-1] if errors.strip() else f"exit {code}"}, [], seconds
    read = json.loads(report.read_text(encoding="utf-8"))
    return read["hexahedra"], read["warnings"], seconds


def remedy_options(made, options):
    """The options of the first run with those of the remedy; none if it names no option."""
    remedy, number = made.get("remedy"), made.get("remedy_number")
    if remedy in ("glue_solids", "separate_solids"):
        return [*options, "--glue"]
    if remedy == "take_smaller_hexahedra":
        remedy, number = "use_hex_size", SMALLER * made["used_size"]
    name = {"use_edge_length": "--tet-size", "use_hex_size": "--size"}.get(remedy)
    if name is None:
        return None
    others = {name, "--cells"} if name == "--size" else {name}
    pairs = [(word, value) for word, value in zip(options[::2], options[1::2]) if word not in others]
    return [word for pair in [*pairs, (name, f"{number:.6g}")] for word in pair]


def words_of(made, warnings):
    words = made.get("sentence", made["outcome"])
    crossed = [warning["text"] for warning in warnings if warning["kind"] == "crossed_interfaces"]
    return words + "".join(f"; warning: {text}" for text in crossed)


def is_mended(made, warnings):
    """Whether nothing is left to be mended: hexahedra fill the model and keep to its faces."""
    return made["outcome"] == "all-hex" and not made.get("reason") and not any(one["kind"] == "crossed_interfaces" for one in warnings)


def sizes_of(made):
    return ", ".join(f"{attempt['tet_size']:.3g}" for attempt in made.get("attempts", []) if attempt.get("tet_size"))


def main():
    words = sys.argv[1:]
    at = words.index("--") if "--" in words else len(words)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--limit", type=float, default=1e9)
    parser.add_argument("models", nargs="+", type=Path)
    arguments = parser.parse_args(words[:at])
    options = words[at + 1:]
    arguments.out.mkdir(parents=True, exist_ok=True)
    print("| part | result | tets tried | s | remedy | result then | s | helped |")
    print("|---|---|---|---|---|---|---|---|")
    for model in arguments.models:
        made, warnings, seconds = result_of(arguments, model, arguments.out / f"{model.name}.first", options)
        row = [model.name, words_of(made, warnings), sizes_of(made), f"{seconds:.0f}"]
        again = remedy_options(made, options)
        if again:
            then, then_warnings, then_seconds = result_of(arguments, model, arguments.out / f"{model.name}.then", again)
            added = again[len(options):] if again[:len(options)] == options else again[-2:]
            row += [" ".join(added), words_of(then, then_warnings), f"{then_seconds:.0f}", "yes" if is_mended(then, then_warnings) else "no"]
        else:
            row += [made.get("next", ""), "", "", ""]
        print("| " + " | ".join(row) + " |", flush=True)


if __name__ == "__main__":
    main()
