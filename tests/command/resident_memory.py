# SPDX-License-Identifier: Apache-2.0
"""The memory of a running program with those that it has started."""

import re
from pathlib import Path


def with_descendants(process):
    yield process
    try:
        for task in Path(f"/proc/{process}/task").iterdir():
            for child in (task / "children").read_text().split():
                yield from with_descendants(int(child))
    except OSError:
        pass


def resident_bytes(process):
    """What processes share, as a helper does with the program before it is started, counts in parts (Pss)."""
    try:
        return 1024 * int(re.search(r"^Pss: +(\d+)", Path(f"/proc/{process}/smaps_rollup").read_text(), re.MULTILINE)[1])
    except (OSError, TypeError):
        return 0


def resident_bytes_with_descendants(process):
    return sum(map(resident_bytes, with_descendants(process)))
