# SPDX-License-Identifier: Apache-2.0
"""The commands that README.md and the pages of docs/ print."""

import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^\s*```(\w*)\s*$")
SPAN = re.compile(r"`(crossgrain [^`]+)`")


@dataclass
class Block:
    """A fenced block: its language, the number of its first line, and its lines."""
    language: str
    first: int
    lines: list


def pages():
    """README.md and all pages below docs/, those for developers excepted."""
    found = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    return [path for path in found if ROOT / "docs" / "notes" not in path.parents]


def blocks_of(path):
    """The fenced blocks of a page, in order."""
    blocks, inside = [], None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        fence = FENCE.match(line)
        if fence and inside is None:
            inside = Block(fence.group(1), number + 1, [])
        elif fence:
            blocks.append(inside)
            inside = None
        elif inside is not None:
            inside.lines.append(line)
    return blocks


def spans_of(path):
    """Commands in running text, which may go on in the next line."""
    text = re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    return [" ".join(span.split()) for span in SPAN.findall(text)]
