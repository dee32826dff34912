#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the table of docs/notes/verdict.md: the answers about the curvature-adapted meshes of Hex-Me-If-You-Can.

    CROSSGRAIN_PROGRAM=build/release/apps/crossgrain/crossgrain /usr/bin/python3 tests/command/hexme_table.py [HEXME]

HEXME is the folder of packed meshes and MANIFEST.tsv, ../shared/hexme beside the project by default.
"""

import csv
import json
import lzma
import sys
import tempfile
from collections import Counter
from pathlib import Path

from program import run


def report_of(packed, folder):
    """The report on a packed mesh."""
    mesh = folder / packed.stem
    mesh.write_bytes(lzma.decompress(packed.read_bytes()))
    solved = run("solve", mesh, "-o", folder / "out", "--quiet", "--no-report")
    assert solved.returncode == 0, solved.stderr
    return json.loads((folder / "out" / "report.json").read_text())


def items_of(singularity):
    """k of creases and F of corners that are not meshable, with the number of each."""
    items = Counter(f"k = {crease['hexahedra']} at {crease['least_angle_deg']:.1f} degrees"
                    for crease in singularity["crease_list"] if crease["verdict"] != "meshable")
    items += Counter(f"F = {corner['hexahedra']} of k = {', '.join(map(str, min_turned(corner['creases'])))}"
                     for corner in singularity["corner_list"] if corner["verdict"] != "meshable")
    return "; ".join(item if count == 1 else f"{count} × {item}" for item, count in items.items())


def min_turned(creases):
    """The same for all corners that differ in where the circle around them begins and which way it goes."""
    turned = [creases[i:] + creases[:i] for i in range(len(creases))]
    return min(turned + [word[::-1] for word in turned], default=[])


def row_of(model, report):
    reasons = report["reasons"]
    why = "; ".join(reason["text"] + (f" (and {reason['count'] - 1} more)" if reason["count"] > 1 else "") for reason in reasons)
    places = [" ".join(f"{round(x, 9):.4g}" for x in reason["place"]) for reason in reasons if reason["count"]]
    known = "yes" if model["valid_map_known"] == "1" else "no"
    return [Path(model["file"]).name.split(".")[0], known, report["verdict"].replace("_", " "), why, "; ".join(places),
            items_of(report["onto"]["singularity"])]


def main(hexme):
    with open(hexme / "MANIFEST.tsv", encoding="utf-8") as manifest:
        models = [model for model in csv.DictReader(manifest, delimiter="\t") if ", curvature-adapted," in model["source"]]
    print("| mesh | map known | answer | why | where | k and F |\n|---|---|---|---|---|---|")
    answers = Counter()
    for model in models:
        with tempfile.TemporaryDirectory(prefix="crossgrain-table-") as folder:
            report = report_of(hexme / model["file"], Path(folder))
        answers[report["verdict"]] += 1
        print("| " + " | ".join(row_of(model, report)) + " |", flush=True)
    print("\n" + ", ".join(f"{count} {answer.replace('_', ' ')}" for answer, count in sorted(answers.items())))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[3] / "shared" / "hexme")
