#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that every source names its licence in its first lines and is formatted by clang-format 14, and that no line of the Python
package is longer than one of C++.

Usage: check_style.py [--fix] [ROOT]     --fix formats in place instead of complaining about the format.
Prints one line for each fault and exits with 1 where there is one.
"""

import argparse
import subprocess
import sys
from pathlib import Path

FOLDERS = ["include", "src", "apps", "python", "examples", "bench", "tests", "models", "docs", "cmake", "packaging", "viewer"]
CPP_SUFFIXES = {".hpp", ".cpp", ".h", ".c"}
LICENSED_SUFFIXES = CPP_SUFFIXES | {".py", ".sh", ".cmake", ".in", ".ts", ".mjs", ".css"}
OTHERS_FOLDER = "node_modules"
LICENSE_LINE = "SPDX-License-Identifier: Apache-2.0"

# Where the licence line must stand: the first line, or the second below a "#!".
LICENSE_WITHIN_LINES = 2

# As ColumnLimit in .clang-format.
COLUMNS = 110


def sources(root, suffixes):
    roots = [root / folder for folder in FOLDERS]
    nested = (path for folder in roots for path in folder.rglob("*"))
    return sorted(
        path
        for path in [*root.glob("*"), *nested]
        if path.is_file() and path.suffix in suffixes and OTHERS_FOLDER not in path.parts
    )


def files_without_license(root):
    for path in sources(root, LICENSED_SUFFIXES):
        head = path.read_text(encoding="utf-8").splitlines()[:LICENSE_WITHIN_LINES]
        if not any(LICENSE_LINE in line for line in head):
            yield f"{path.relative_to(root)}:1: the first line has to say {LICENSE_LINE}"


def long_lines(root):
    for path in sorted((root / "python").rglob("*.py")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if len(line) > COLUMNS:
                yield f"{path.relative_to(root)}:{number}: has {len(line)} columns; at most {COLUMNS}"


def files_badly_formatted(root, fix):
    files = [str(path) for path in sources(root, CPP_SUFFIXES)]
    if not files:
        return
    mode = ["-i"] if fix else ["--dry-run", "-Werror", "--ferror-limit=1"]
    result = subprocess.run(["clang-format-14", *mode, *files], capture_output=True, text=True, check=False)
    lines = [line for line in result.stderr.splitlines() if ": error:" in line]
    if result.returncode != 0 and not lines:
        lines = result.stderr.splitlines()
    yield from lines
    if lines:
        yield "cmake/check_style.py --fix formats all of them"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fix", action="store_true")
    parser.add_argument("root", nargs="?", default=Path(__file__).parent.parent, type=Path)
    options = parser.parse_args()
    root = options.root.resolve()
    found = [*files_without_license(root), *long_lines(root), *files_badly_formatted(root, options.fix)]
    print("\n".join(found) if found else "every source names its licence and is formatted")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
