#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Prints how many seconds a million of the work of attempts at hexahedra takes: docs/notes/hexahedra.md.

Usage: hex_work.py FOLDER...      results of `crossgrain hex`
A row for each kind of attempt: their number, and the least, the median and the most of seconds by work. Work decides
when attempts end and seconds never do, so that results are the same on every machine; this is for forecasts only.
"""

import json
import statistics
import sys
from collections import defaultdict
from pathlib import Path


def main():
    rates = defaultdict(list)
    for folder in sys.argv[1:]:
        report = json.loads((Path(folder) / "report.json").read_text(encoding="utf-8"))
        for attempt in report["hexahedra"]["attempts"]:
            if attempt["work"] > 0:
                rates[attempt["kind"]].append(1e6 * attempt["seconds"] / attempt["work"])
    print("| kind | attempts | least | median | most |\n|---|---|---|---|---|")
    for kind, all_rates in rates.items():
        print(f"| {kind} | {len(all_rates)} | {min(all_rates):.2f} | {statistics.median(all_rates):.2f} | {max(all_rates):.2f} |")


if __name__ == "__main__":
    main()
