#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Three thousand system calls that fail and five hundred kills, twenty of them over a result of 2 GB.

Usage: nightly.py [FAULTS [KILLS [LARGE_KILLS]]]
"""

import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import integrity
from faults import FAULTS, all_cases, broken_faults, folder_for_runs, say
from integrity import Broken
from program import PROGRAM

REWRITE = os.environ.get("CROSSGRAIN_REWRITE_RESULT", "")
# About 100 bytes a cell in files.
LARGE_RESOLUTION, LARGE_BYTES = "1650", 2e9
# Boxes that leave out a few cells, so that each result differs from the one before.
CLIPS = ("0.7", "0.69")


def faults_of(cases, count, chance):
    """Calls of all cases in any order, each as often as `count` allows and each time with another fault."""
    orders = {(case.name, call): chance.sample(FAULTS, len(FAULTS)) for case in cases
              for call in range(1, len(case.calls) + 1)}
    chosen = []
    for k in range(len(FAULTS)):
        chosen += chance.sample([(case, call, orders[case.name, call][k]) for case in cases
                                 for call in range(1, len(case.calls) + 1)], sum(len(case.calls) for case in cases))
    return chosen[:count]


def kills(cases, count, chance):
    """So many kills at random moments, half of them in the last part, where results are put in place."""
    broken, running = [], 0
    for case in cases:
        case.restore()
        begin = time.monotonic()
        case.run(case.command, case.variables())
        case.seconds = time.monotonic() - begin
    tried = 0
    while running < count:
        case = cases[tried % len(cases)]
        share = chance.uniform(0.7, 1) if tried // len(cases) % 2 else chance.random()
        tried += 1
        try:
            running += case.kill(share * case.seconds)
        except (Broken, OSError) as failure:
            running += 1
            broken.append(f"{case.name}, killed after {share * case.seconds:.3f} s: {failure}")
    say(f"kills: {running} of {tried} runs, the others ended before; {len(broken)} broken promises")
    return broken


def make_large(folder):
    """A result of 2 GB and one of other bytes over which it is written."""
    whole = folder / "whole"
    subprocess.run([PROGRAM, "solve", folder / "torus.stl", "-o", whole, "--resolution", LARGE_RESOLUTION, "--quiet",
                    "--no-report"], check=True)
    size = sum(path.stat().st_size for path in whole.iterdir())
    say(f"a result of {size / 1e9:.2f} GB, {json.loads((whole / 'report.json').read_text())['seconds']['total']:.0f} s")
    if size < LARGE_BYTES:
        raise SystemExit(f"the result has only {size} bytes")
    return whole


def rewrite(whole, target, clip, share, seconds):
    """Writes the result once; killed after a share of `seconds`, if there are any. Returns whether it was, and its time."""
    process = subprocess.Popen([REWRITE, whole, target, clip], stdout=subprocess.PIPE, text=True)
    process.stdout.readline()
    begin = time.monotonic()
    try:
        process.wait(share * seconds if seconds else None)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    process.stdout.close()
    return process.returncode != 0, time.monotonic() - begin


def large_kills(folder, count, chance):
    whole, target = make_large(folder), folder / "large"
    _, seconds = rewrite(whole, target, CLIPS[1], 1, None)
    before = integrity.solve_of_whole(target)
    broken, states, killed, tried = [], Counter(), 0, 0
    while killed < count:
        share = chance.uniform(0.8, 1) if tried % 2 else chance.random()
        was_killed, _ = rewrite(whole, target, CLIPS[tried % 2], share, seconds)
        tried, killed = tried + 1, killed + was_killed
        try:
            after = integrity.solve_of_whole(target)
            states["old" if after == before else "new"] += was_killed
            before = after
        except Broken as failure:
            broken.append(f"large, killed after {share * seconds:.1f} s: {failure}")
    say(f"kills over 2 GB, which takes {seconds:.1f} s: {killed} of {tried} runs; {dict(states)}, {len(broken)} broken promises")
    return broken


def main():
    count, kill_count, large_count = [*map(int, sys.argv[1:]), *(3000, 480, 20)[len(sys.argv) - 1:]]
    chance = random.Random(1)
    with tempfile.TemporaryDirectory(prefix="crossgrain-faults-", dir=folder_for_runs()) as name:
        folder = Path(name)
        cases = all_cases_in(folder)
        faults = faults_of(cases, count, chance)
        broken = broken_faults(faults, say)
        say(f"faults: {len(faults)} at {sum(len(case.calls) for case in cases)} calls; {len(broken)} broken promises")
        broken += kills(cases, kill_count, chance)
        if large_count:
            broken += large_kills(folder, large_count, chance)
    for line in broken:
        say(line)
    return 1 if broken else 0


def all_cases_in(folder):
    cases = all_cases(folder)
    say("system calls: " + ", ".join(f"{case.name} {len(case.calls)}" for case in cases))
    return cases


if __name__ == "__main__":
    sys.exit(main())
