#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the tables of docs/notes/repair.md: what a repair changes on tet meshes.

    repair_table.py PROGRAM FOLDER [MODEL...]

MODEL are tet meshes, packed with xz or not; without them, the curvature-adapted meshes of ../shared/hexme beside the project. FOLDER gets the
results: MODEL/plain by `solve`, MODEL/repaired by `solve --prepare --repair`. Flips are those of the seamless map of tests/command/poisson_map.py,
which has no integers and untangles nothing.
"""

import csv
import json
import lzma
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "command"))

from poisson_map import figures_of, files_of, read_field  # noqa: E402

HEXME = ROOT.parent / "shared" / "hexme"
RUNS = {"plain": [], "repaired": ["--prepare", "--repair"]}


def hexme_models():
    with open(HEXME / "MANIFEST.tsv", encoding="utf-8") as manifest:
        rows = [row for row in csv.DictReader(manifest, delimiter="\t") if ", curvature-adapted," in row["source"]]
    return [HEXME / row["file"] for row in rows]


def solved(program, model, folder, options):
    """The report and the figures of the seamless map."""
    folder.mkdir(parents=True, exist_ok=True)
    mesh = model
    if model.suffix == ".xz":
        mesh = folder.parent / model.stem
        mesh.write_bytes(lzma.decompress(model.read_bytes()))
    subprocess.run([program, "solve", mesh, "-o", folder, "--force", "--write", "mesh,fra,perm", "--quiet", "--no-report", *options],
                   check=True)
    return json.loads((folder / "report.json").read_text()), figures_of(read_field(*files_of(folder)))


def places_of(report):
    reasons = [reason for reason in report["reasons"] if reason["count"]]
    return "; ".join(f"{reason['text']} at {' '.join(f'{x:.4g}' for x in reason['place'])}" +
                     (f" and {reason['count'] - 1} more" if reason["count"] > 1 else "") for reason in reasons)


def row_of(name, plain, repaired):
    (before, flips_before), (after, flips_after) = plain, repaired
    onto, repair = after["onto"], after["onto"]["repair"]
    return [name, onto["tets"], before["verdict"].replace("_", " "), after["verdict"].replace("_", " "),
            f"{repair['faults_before']} → {repair['faults']}",
            f"{before['onto']['singularity']['edges']} → {onto['singularity']['edges']}",
            f"{before['onto']['singularity']['contacts']} → {onto['singularity']['contacts']}",
            f"{flips_before['off_axis_smooth']} + {flips_before['off_axis_creased']} → "
            f"{flips_after['off_axis_smooth']} + {flips_after['off_axis_creased']}",
            f"{flips_before['flips']} → {flips_after['flips']}",
            f"{flips_before['flipped_share']:.4f} → {flips_after['flipped_share']:.4f}",
            f"{repair['energy_before']:.4g} → {repair['energy']:.4g}", f"{repair['bent_length']:.3g}", f"{repair['seconds']:.2f}",
            places_of(after)]


def main(program, folder, models):
    names = ("mesh", "tets", "answer before", "after", "faults", "singular edges", "contacts", "faces off axis, smooth + creased", "flips",
             "share of volume", "energy", "bent", "s", "what is left")
    print("| " + " | ".join(names) + " |\n|" + "---|" * len(names))
    sums = [0, 0.0, 0, 0.0]
    for model in models:
        name = model.name.split(".")[0]
        plain, repaired = (solved(program, model, folder / name / kind, options) for kind, options in RUNS.items())
        for k, (_, flips) in enumerate((plain, repaired)):
            sums[2 * k] += flips["flips"]
            sums[2 * k + 1] += flips["flipped_share"]
        print("| " + " | ".join(map(str, row_of(name, plain, repaired))) + " |", flush=True)
    print(f"\nflips {sums[0]} → {sums[2]}, shares of volume in sum {sums[1]:.4f} → {sums[3]:.4f}")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], Path(sys.argv[2]), [Path(model) for model in sys.argv[3:]] or hexme_models())
