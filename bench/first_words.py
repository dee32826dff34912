#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints, for each model, when `hex` first says how it will end, when it ends, and its words: first_words.py PROGRAM MODEL... [-- OPTION...]

A table in Markdown: seconds to the first line that tells the outcome, seconds in all, exit code, the lines `hexahedra` and `worst`. The
line that tells is that of the first attempt that fills the model, the line `hexahedra` itself, or an error, whichever comes first.
Without options: --cells 20."""
import argparse
import re
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

TELLS = re.compile(r"^(hexahedra |attempt \d+: [\d,]+ hexahedr\w+ fills? |crossgrain: (?!warning))")


def timed_lines(stream, begin, lines):
    for line in iter(stream.readline, ""):
        lines.append((time.monotonic() - begin, line.rstrip()))


def run(program, model, options, limit):
    with tempfile.TemporaryDirectory(prefix="crossgrain-words-") as folder:
        begin = time.monotonic()
        command = [program, "hex", model, "-o", f"{folder}/out", "--progress", *options]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        lines = []
        readers = [threading.Thread(target=timed_lines, args=(stream, begin, lines)) for stream in (process.stdout, process.stderr)]
        for reader in readers:
            reader.start()
        try:
            code = process.wait(timeout=limit)
        except subprocess.TimeoutExpired:
            process.terminate()
            process.wait()
            code = "limit"
        for reader in readers:
            reader.join()
        return code, time.monotonic() - begin, sorted(lines, key=lambda line: line[0])


def words_of(lines):
    kept = [text.split(None, 1)[1] for _, text in lines if re.match(r"(hexahedra|worst) +\S", text)]
    return "; ".join(kept) if kept else next((text for _, text in reversed(lines) if text.startswith("crossgrain:")), "")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("models", nargs="+")
    parser.add_argument("--limit", type=float, default=900, help="seconds after which a run is ended")
    parser.add_argument("--options", default="--cells 20", help="of hex")
    arguments = parser.parse_args()
    print("| model | first word, s | in all, s | exit | words |\n|---|---:|---:|---:|---|")
    for model in arguments.models:
        code, seconds, lines = run(arguments.program, model, arguments.options.split(), arguments.limit)
        first = next((at for at, text in lines if TELLS.search(text)), seconds)
        print(f"| {Path(model).name} | {first:.1f} | {seconds:.1f} | {code} | {words_of(lines)} |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
