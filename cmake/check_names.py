#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that no two files define types of the same name; prints one line for each that do, and exits with 1.

Usage: check_names.py [ROOT]

All of src/ and include/ is linked into one library. If two of its files define a class, struct, union, enum or alias of one name in one
namespace, no file can include both, and functions inlined from one of them may be replaced by those of the other without a word from
the compiler. Types in anonymous namespaces, inside other types and inside functions belong to one file each and may have any name.
"""

import re
import sys
from pathlib import Path

FOLDERS = ["src", "include"]
SUFFIXES = {".hpp", ".cpp", ".h", ".cc"}
TYPE_KEYWORDS = {"class", "struct", "union", "enum"}

# What is no code (texts, comments, lines of the preprocessor) matches without a group.
TOKEN = re.compile(
    r"""  R"(?P<delimiter>[^()\\\s]{0,16})\(.*?\)(?P=delimiter)"
        | "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])*'
        | //[^\n]* | /\*.*?\*/ | ^[ \t]*\#(?:\\\n|[^\n])*
        | \d(?:'?[\w.])*
        | (?P<token>[A-Za-z_]\w* | :: | [^\s])""",
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)


def tokens_of(text):
    """(word or sign, line number) for each in the code."""
    line, counted = 1, 0
    for match in TOKEN.finditer(text):
        if match.group("token") is None:
            continue
        line += text.count("\n", counted, match.start())
        counted = match.start()
        yield match.group("token"), line


def is_name(word):
    return re.match(r"[A-Za-z_]", word) is not None


class Scanner:
    """The types that one file defines in namespaces with a name."""

    def __init__(self, text):
        self.words, self.lines = zip(*([*tokens_of(text)] + [("", 0)] * 4))
        self.at = 0

    def definitions(self):
        """(name with its namespaces, line number) for each; a line number of 0 where braces do not match."""
        scopes = []  # the name of a namespace, "" for an anonymous one, None for any other braces
        while self.word():
            word, line = self.word(), self.lines[self.at]
            self.at += 1
            if word == "template":
                self.skip_bracketed("<", ">")
            elif word == "{":
                scopes.append(None)
            elif word == "}" and not scopes:
                yield "", 0
            elif word == "}":
                scopes.pop()
            elif word == "namespace":
                self.open_namespace(scopes)
            elif word == "using" and all(scopes) and self.word(1) == "=":
                yield "::".join([*scopes, self.word()]), line
            elif word in TYPE_KEYWORDS and all(scopes):
                name = self.defined_name()
                if name:
                    yield "::".join([*scopes, name]), line
        if scopes:
            yield "", 0

    def word(self, ahead=0):
        return self.words[self.at + ahead]

    def skip_bracketed(self, opening, closing):
        if self.word() != opening:
            return
        depth = 0
        while self.word():
            depth += (self.word() == opening) - (self.word() == closing)
            self.at += 1
            if depth == 0:
                return

    def open_namespace(self, scopes):
        """Behind the word `namespace`; not every one opens one."""
        name = ""
        while is_name(self.word()) or self.word() == "::":
            name += self.word() if self.word() != "inline" else ""
            self.at += 1
        if self.word() == "{":
            scopes.append(name)
            self.at += 1

    def defined_name(self):
        """Behind a keyword: the name of the type, if this is its definition and no specialisation or member of another type."""
        while self.word() in ("class", "struct", "[", "alignas"):
            if self.word() == "[":
                self.skip_bracketed("[", "]")
            else:
                self.at += 1
                self.skip_bracketed("(", ")")
        name = self.word()
        if not is_name(name):
            return None
        self.at += 1
        if self.word() == "final":
            self.at += 1
        if self.word() == ":":
            while self.word() and self.word() not in ("{", ";"):
                self.at += 1
        return name if self.word() == "{" else None


def faults(root):
    """One line for each name that a file defines after another one did, and for each file that cannot be followed."""
    first = {}
    for path in sorted(path for folder in FOLDERS for path in (root / folder).rglob("*") if path.suffix in SUFFIXES):
        file = path.relative_to(root)
        for name, line in Scanner(path.read_text(encoding="utf-8")).definitions():
            if line == 0:
                yield f"{file}: its braces do not match, so its names cannot be checked; open and close none inside #if"
                continue
            other_file, other_line = first.setdefault(name, (file, line))
            if other_file != file:
                yield (f"{file}:{line}: {name} is another type in {other_file}:{other_line}; "
                       "rename one, or put what one .cpp file uses alone into an anonymous namespace")


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    found = list(faults(root))
    print("\n".join(found) if found else "every type has a name of its own")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
