#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the parts of the Python package that say again what the C and C++ headers say.

Usage: generate.py INCLUDE_FOLDER OUTPUT_FOLDER LIBRARY

  _interface.py   the structs, constants and functions of crossgrain/c.h for ctypes, the name of the LIBRARY
  options.py      a dataclass for each struct of options in the C++ headers, with its defaults and comments
"""

import re
import sys
import textwrap
from pathlib import Path

LICENSE = "# SPDX-License-Identifier: Apache-2.0\n"



def wrapped(text, indent):
    """Text in lines of 110 columns, with quotes; the caller indents the first."""
    return f"\n{indent}".join(textwrap.wrap(text, 104 - len(indent), break_on_hyphens=False))


# -- crossgrain/c.h ----------------------------------------------------------------------------------------

SIMPLE_TYPES = {
    "int": "c_int", "size_t": "c_size_t", "double": "c_double", "float": "c_float", "int8_t": "c_int8",
    "uint8_t": "c_uint8", "int32_t": "c_int32", "uint32_t": "c_uint32", "int64_t": "c_int64",
}


class Header:
    def __init__(self, text):
        text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
        text = re.sub(r"^\s*#.*?$", " ", text, flags=re.M)
        self.text = re.sub(r"\s+", " ", text)
        self.enums, self.structs = self.bodies("enum"), self.bodies("struct")
        callbacks = re.findall(r"typedef (\w+) \(\*(\w+)\)\(([^)]*)\);", self.text)
        self.callbacks = {name: (returned, arguments) for returned, name, arguments in callbacks}
        self.functions = re.findall(r"([\w ]+?[ *]+)(crossgrain_\w+)\(([^)]*)\);", self.text)

    def bodies(self, keyword):
        found = re.findall(rf"typedef {keyword} \w+ \{{([^}}]*)\}} (\w+);", self.text)
        return {name: body for body, name in found}

    def ctype(self, declared, is_result=False):
        """The ctypes type of a C type. Arrays and handles are addresses."""
        base = declared.replace("const", "").strip()
        stars = base.count("*")
        base = base.replace("*", "").strip()
        if stars == 0:
            if base in self.enums:
                return "c_int"
            return None if base == "void" else base if base in self.callbacks else SIMPLE_TYPES[base]
        if base == "char" and stars == 1:
            return "c_char_p" if "const" in declared else "c_void_p"
        if base in self.structs and stars == 1:
            # Errors are released, so their address is needed.
            return f"POINTER({base})" if is_result else "c_void_p"
        if stars == 2:
            return "POINTER(c_void_p)"
        return "c_void_p"


def split_arguments(arguments):
    """(type, name) of each argument of a function."""
    for argument in filter(None, map(str.strip, arguments.split(","))):
        if argument == "void":
            return
        declared, name, array = re.fullmatch(r"(.*?[ *])(\w+)((?:\[\d+\])?)", argument).groups()
        yield declared + ("*" if array else ""), name


def members_of(body):
    """(type, name, length of the array or 1) of each member of a struct."""
    for declaration in filter(None, map(str.strip, body.split(";"))):
        declared, names = re.fullmatch(r"(.*?[ *])(\w+(?:\[\d+\])?(?:, \w+)*)", declaration).groups()
        for name in names.split(", "):
            name, count = re.fullmatch(r"(\w+)(?:\[(\d+)\])?", name).groups()
            yield declared, name, int(count or 1)


def interface_of(text, library):
    header = Header(text)
    yield LICENSE
    yield '"""The C interface (crossgrain/c.h) for ctypes. Made by python/generate.py."""\n'
    types = ", ".join(["CFUNCTYPE", "POINTER", "Structure", "c_char_p", "c_void_p", *SIMPLE_TYPES.values()])
    yield wrapped(f"from ctypes import ({types})", " " * 20) + "\n"
    yield f'LIBRARY = "{library}"'
    yield "C_VERSION = " + re.search(r"CROSSGRAIN_C_VERSION (\d+)", text).group(1)
    for name, body in header.enums.items():
        yield ""
        for constant, value in re.findall(r"CROSSGRAIN_(\w+) = (\d+)", body):
            yield f"{constant} = {value}"
    for name, body in header.structs.items():
        yield f"\n\nclass {name}(Structure):\n    _fields_ = ["
        for declared, member, count in members_of(body):
            ctype = header.ctype(declared)
            yield f'        ("{member}", {ctype}{f" * {count}" if count > 1 else ""}),'
        yield "    ]"
    yield ""
    for name, (returned, arguments) in header.callbacks.items():
        types = [header.ctype(declared, is_result=True) for declared, _ in split_arguments(arguments)]
        yield f"\n{name} = CFUNCTYPE({header.ctype(returned)}, {', '.join(types)})"
    yield "\n\n# name: (type of the result, types of the arguments)\nFUNCTIONS = {"
    for returned, name, arguments in header.functions:
        types = [header.ctype(declared) for declared, _ in split_arguments(arguments)]
        comma = "," if len(types) == 1 else ""
        its_type = header.ctype(returned, is_result=True)
        yield "    " + wrapped(f'"{name}": ({its_type}, ({", ".join(types)}{comma})),', " " * 8)
    yield "}\n"


# -- Options -----------------------------------------------------------------------------------------------

# The structs of options by header, inner ones before those that hold them, and their kind in crossgrain/c.h.
OPTIONS = {
    "options.hpp": ["TetTagOptions", "MapPreparationOptions", "SolveOptions"],
    "reading.hpp": ["ReadOptions"],
    "result_folder.hpp": ["OutputOptions"],
    "repair.hpp": ["RepairOptions"],
    "streamlines.hpp": ["StreamlineOptions"],
    "picture.hpp": ["PictureOptions"],
    "tet_making.hpp": ["TetMakingOptions"],
    "hexahedra.hpp": ["HexOptions"],
    "hex_meshing.hpp": ["HexMeshingOptions"],
    "hex_fit.hpp": ["HexFitOptions"],
}
KINDS = {
    "SolveOptions": "SOLVE_OPTIONS", "ReadOptions": "READ_OPTIONS", "TetTagOptions": "TAG_OPTIONS",
    "OutputOptions": "OUTPUT_OPTIONS", "StreamlineOptions": "STREAMLINE_OPTIONS",
    "PictureOptions": "PICTURE_OPTIONS", "MapPreparationOptions": "PREPARATION_OPTIONS",
    "RepairOptions": "REPAIR_OPTIONS", "TetMakingOptions": "TET_MAKING_OPTIONS", "HexOptions": "HEX_OPTIONS",
    "HexMeshingOptions": "HEX_MESHING_OPTIONS", "HexFitOptions": "HEX_FIT_OPTIONS",
}

# Members that Python passes in another way.
LEFT_OUT = {
    "SolveOptions": {"constraints", "for_page"},
    "OutputOptions": {"companion", "hex_map", "hexahedra", "reservation"},
}
ADDED = {"OutputOptions": [
    ("page", "bool", "False", "Whether report.html, which shows the field in a browser, is written too."),
]}

# Names of enumerations, as in src/c_interface/option_value.hpp.
NAMES = {
    "TetBoundary": {"kAll": "all", "kSmoothOnly": "smooth-only"},
    "TetMaker": {"kAutomatic": "automatic", "kGmsh": "gmsh", "kNetgen": "netgen"},
    "LengthUnit": {"kUnknown": "none", "kMicrometre": "um", "kMillimetre": "mm", "kCentimetre": "cm",
                   "kMetre": "m", "kInch": "inch", "kFoot": "foot"},
    "HexPreference": {"kFeatures": "features", "kMap": "map", "kLattice": "lattice", "kMapOnly": "map_only"},
    "ForeignFiles": {"kRefuse": "refuse", "kKeep": "keep", "kReplace": "replace"},
    "PictureColour": {"kNone": "none", "kAlignment": "alignment", "kEnergy": "energy", "kConstraint": "class",
                      "kRegion": "region", "kFace": "face"},
    "PictureFrames": {"kLines": "lines", "kBoxes": "boxes", "kCrosses": "crosses", "kNone": "none"},
    "PicturePart": {"kLines": "lines", "kCreases": "creases", "kLegend": "legend"},
    "PictureBackground": {"kLight": "light", "kDark": "dark", "kTransparent": "transparent"},
}
TYPES = {
    "bool": "bool", "int": "int", "std::size_t": "int", "std::uint64_t": "int", "double": "float",
    "Degree": "int", "std::filesystem::path": "str", "std::optional<int>": "Optional[int]",
    "std::optional<double>": "Optional[float]", "std::optional<Box>": "Optional[Sequence[float]]",
    "std::optional<View>": "Union[None, str, Sequence[float]]",
    "std::optional<Cut>": "Union[None, str, Tuple[Union[int, str], Optional[float]]]",
    "std::optional<std::array<double, 2>>": "Optional[Sequence[float]]",
    "std::array<bool, 3>": "Sequence[bool]", "std::array<int, 2>": "Sequence[int]",
    "std::vector<PicturePart>": "Sequence[str]", "std::vector<std::string>": "Sequence[str]",
}
# What Python takes for a type, added to the comment.
NOTES = {
    "std::optional<Box>": "Six numbers: the lower and the upper corner.",
    "std::optional<View>": "A name such as 'front', or the two angles.",
    "std::optional<Cut>": "'x', 'y' or 'z', or a pair of such an axis and a coordinate.",
}


def struct_body(text, name):
    start = text.index(f"struct {name} {{") + len(f"struct {name} {{")
    depth, at = 1, start
    while depth:
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        at += 1
    return text[start:at - 1]


def comment_before(text, at):
    """The text of the /// lines that end at a place."""
    lines = []
    for line in reversed(text[:at].rstrip().splitlines()):
        if not line.strip().startswith("///"):
            break
        lines.insert(0, line.strip()[3:].strip())
    return in_python(" ".join(lines))


def in_python(comment):
    comment = comment.replace("::", ".")
    return re.sub(r"\bk(?=[A-Z])(\w+)\b", r"\1", comment).replace("DefaultResolution", "128")


def without_inner_types(body):
    """A body without the structs that are declared inside, whose members follow as `Name name;`."""
    return re.sub(r"(?:\s*///[^\n]*\n)*\s*struct (\w+) \{[^}]*\};", "", body)


MEMBER = re.compile(r"^\s*([\w:<>, ]*?[\w>]) (\w+(?: = [^;]*)?(?:\{[^;]*\})?);"
                    r"(?:\s*///<\s*(.*(?:\n\s*///<.*)*))?", re.M)


def options_members(body):
    """(type, name, C++ default or None, comment) of each member."""
    body = without_inner_types(body)
    for match in MEMBER.finditer(body):
        declared, names, trailing = match.groups()
        behind = trailing and in_python(re.sub(r"\s*///<\s*", " ", trailing))
        comment = behind or comment_before(body, match.start())
        braced = re.fullmatch(r"(\w+)(\{.*\})", names, re.S)
        if braced:
            yield declared, braced.group(1), braced.group(2), comment
            continue
        # `int width = 1600, height = 1200` declares two members.
        parts = re.split(r", (?=\w+ = )", names) if not re.search(r"= \{", names) else [names]
        for part in parts:
            name, _, default = part.partition(" = ")
            yield declared, name, default or None, comment


def python_default(declared, default, structs):
    if declared in structs:
        return f"field(default_factory={declared})"
    if default is None or default == "{}":
        empty = {"std::vector": "()", "std::filesystem::path": "''"}
        return empty.get(declared.partition("<")[0], "None")
    if default in ("true", "false"):
        return default.capitalize()
    if default.startswith("{"):
        return "(" + default[1:-1].replace("true", "True").replace("false", "False") + ")"
    if "::" in default:
        enum, value = default.split("::")
        return {"kThree": "3", "kFour": "4"}[value] if enum == "Degree" else repr(NAMES[enum][value])
    return default


def python_type(declared, structs):
    if declared in NAMES:
        return "str"
    return declared if declared in structs else TYPES[declared]


BASE = """

class _Options:
    _kind = c.NO_OPTIONS

    def __new__(cls, *values: Any, **named: Any) -> Any:
        for name in named:
            refuse_removed(cls, name)
        return super().__new__(cls)

    def __getattr__(self, name: str) -> Any:
        # Only of members that do not exist.
        refuse_removed(type(self), name)
        raise AttributeError(f"{type(self).__name__} has no member {name!r}")

    def __setattr__(self, name: str, value: Any) -> None:
        # A member that is misspelt would have no effect.
        if name not in getattr(self, "__dataclass_fields__"):
            refuse_removed(type(self), name)
            raise AttributeError(f"{type(self).__name__} has no member {name!r}")
        super().__setattr__(name, value)


def refuse_removed(kind: Any, name: str) -> None:
    # UsageError for an option of earlier versions.
    if name.startswith("_"):
        return
    instead = library.crossgrain_options_replacement(kind._kind, name.encode())
    if instead is not None:
        raise UsageError(f"{name} is no option any more; {instead.decode()}")
"""


def options_of(include):
    yield LICENSE
    yield '"""The options of all functions. Made by python/generate.py from the C++ headers."""\n'
    yield "from __future__ import annotations\n"
    yield "from dataclasses import dataclass, field"
    yield "from typing import Any, Optional, Sequence, Tuple, Union\n"
    yield "from . import _interface as c"
    yield "from ._library import library"
    yield "from .errors import UsageError"
    structs = [name for names in OPTIONS.values() for name in names]
    yield BASE
    names = ", ".join(f'"{name}"' for name in structs)
    yield "\n" + wrapped(f"__all__ = [{names}]", " " * 11)
    for header, names in OPTIONS.items():
        text = (include / "crossgrain" / header).read_text(encoding="utf-8")
        for name in names:
            comment = comment_before(text, text.index(f"struct {name} {{")) or name
            yield f'\n\n@dataclass\nclass {name}(_Options):\n    """{wrapped(comment, "    ")}"""\n'
            if name in KINDS:
                yield f"    _kind = c.{KINDS[name]}\n"
            for declared, member, default, its_comment in options_members(struct_body(text, name)):
                if member in LEFT_OUT.get(name, ()):
                    continue
                listed = declared.removeprefix("std::vector<").rstrip(">")
                if listed in NAMES:
                    values = ", ".join(f"'{value}'" for value in NAMES[listed].values())
                    its_comment += f" {'One' if listed == declared else 'Any'} of {values}."
                its_comment = " ".join(filter(None, [its_comment, NOTES.get(declared)]))
                its_type = python_type(declared, structs)
                its_default = python_default(declared, default, structs)
                yield "    " + wrapped(f"{member}: {its_type} = {its_default}", " " * 8)
                if its_comment:
                    sentence = its_comment[0].upper() + its_comment[1:]
                    yield f'    """{wrapped(sentence, "    ")}"""\n'
            for member, its_type, default, its_comment in ADDED.get(name, []):
                yield f'    {member}: {its_type} = {default}\n    """{its_comment}"""'
    yield ""


def main():
    include, output = Path(sys.argv[1]), Path(sys.argv[2])
    output.mkdir(parents=True, exist_ok=True)
    parts = sorted((include / "crossgrain").glob("c_*.h"))
    text = "\n".join(path.read_text(encoding="utf-8") for path in parts)
    (output / "_interface.py").write_text("\n".join(interface_of(text, sys.argv[3])), encoding="utf-8")
    (output / "options.py").write_text("\n".join(options_of(include)), encoding="utf-8")


if __name__ == "__main__":
    main()
