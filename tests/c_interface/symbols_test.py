# SPDX-License-Identifier: Apache-2.0
"""The shared library of the C interface shows the functions that its headers declare and nothing else.

Usage: symbols_test.py FOLDER SYMBOLS LIBRARY [--write]

FOLDER has the headers, c_*.h.

SYMBOLS lists them, so that a change of the interface is seen in a review; --write writes it anew. A function that goes from there asks
for another CROSSGRAIN_C_VERSION.
"""

import re
import subprocess
import sys
from pathlib import Path


def main():
    folder, symbols, library = map(Path, sys.argv[1:4])
    text = "".join(path.read_text(encoding="utf-8") for path in folder.glob("c_*.h"))
    declared = set(re.findall(r"\b(crossgrain_\w+)\(", re.sub(r"/\*.*?\*/", "", text, flags=re.S)))
    if "--write" in sys.argv:
        symbols.write_text("".join(f"{name}\n" for name in sorted(declared)), encoding="utf-8")
    listed = set(symbols.read_text(encoding="utf-8").split())
    table = subprocess.run(["nm", "--dynamic", "--defined-only", library], capture_output=True, text=True, check=True).stdout
    shown = {line.split()[-1].split("@")[0] for line in table.splitlines()}
    faults = [f"{name}: {what}" for names, what in [
        (declared - shown, "declared, but not in the library"), (shown - declared, "in the library, but not declared"),
        (declared - listed, f"declared, but not in {symbols.name}"), (listed - declared, f"in {symbols.name}, but not declared"),
    ] for name in sorted(names)]
    print("\n".join(faults) or f"{len(declared)} functions")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
