# SPDX-License-Identifier: Apache-2.0
"""Says whether a result folder is whole, with code of its own: every file complete, all of one solve."""

import base64
import gzip
import json
import re
import struct
import zlib

SOLVE = {".vtu": rb"<!-- solve ([0-9a-f]{16}) -->", ".json": rb'"solve": "([0-9a-f]{16})"',
         ".html": rb'<meta name="crossgrain-solve" content="([0-9a-f]{16})">'}
ALWAYS = {"field.vtu", "singularities.vtu", "surface.vtu", "report.json"}
NUMBER_BYTES = {"Float32": 4, "Float64": 8, "Int32": 4, "Int64": 8, "UInt8": 1, "UInt32": 4, "UInt64": 8}


class Broken(Exception):
    pass


def require(is_so, what):
    if not is_so:
        raise Broken(what)


def attributes_of(tag):
    return dict(re.findall(r'(\w+)="([^"]*)"', tag))


def check_vtu(path):
    """Inflates every block of every array, with its Adler-32, and finds the end of the file behind the last."""
    with open(path, "rb") as file:
        head = file.read(1 << 16)
        require(b"<AppendedData" in head, f"{path}: no data")
        start = head.index(b"_", head.index(b"<AppendedData")) + 1
        end = start
        for tag in re.findall(r"<DataArray[^>]*>", head[:start].decode()):
            end = max(end, check_array(file, start, attributes_of(tag), path))
        file.seek(end)
        require(file.read() == b"\n  </AppendedData>\n</VTKFile>\n", f"{path}: no end")


def check_array(file, start, attributes, path):
    """Returns where the array ends."""
    place = f"{path}: array {attributes['Name']}"
    file.seek(start + int(attributes["offset"]))
    blocks, block_bytes, last_bytes = struct.unpack("<3Q", file.read(24))
    sizes = struct.unpack(f"<{blocks}Q", file.read(8 * blocks))
    for k, size in enumerate(sizes):
        expected = last_bytes if k + 1 == blocks and last_bytes else block_bytes
        require(len(zlib.decompress(file.read(size))) == expected, place)
    total = (blocks - 1) * block_bytes + (last_bytes or block_bytes) if blocks else 0
    require(total % (NUMBER_BYTES[attributes["type"]] * int(attributes["NumberOfComponents"])) == 0, place)
    return file.tell()


def checksum(data):
    """FNV-1a of 64 bits."""
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return f"{value:016x}"


def check_page(path):
    text = path.read_text(encoding="utf-8")
    require(text.rstrip().endswith("</html>"), f"{path}: no end")
    scenes = re.findall(r">([A-Za-z0-9+/=]{200,})<", text)
    require(scenes and gzip.decompress(base64.b64decode(scenes[-1])), f"{path}: no scene")


def check_file(path):
    if path.suffix == ".vtu":
        check_vtu(path)
    elif path.suffix == ".html":
        check_page(path)
    elif path.suffix == ".json":
        json.loads(path.read_text(encoding="utf-8"))


def solve_of(path):
    with open(path, "rb") as file:
        found = re.search(SOLVE[path.suffix], file.read(1024))
    require(found, f"{path}: names no solve")
    return found[1].decode()


def solve_of_whole(folder, others=()):
    """The solve of a result folder that is whole; `others` are names of files that do not belong to it."""
    names = {path.name for path in folder.iterdir()} - set(others)
    require(ALWAYS <= names, f"{folder} has only {sorted(names)}")
    listed = {file["name"]: file for file in json.loads((folder / "report.json").read_text()).get("unmarked_files", ())}
    solves = set()
    for name in sorted(names):
        path = folder / name
        require(path.suffix in SOLVE or name in listed, f"{path} is left over")
        if path.suffix in SOLVE:
            solves.add(solve_of(path))
        else:
            data = path.read_bytes()
            require(len(data) == listed[name]["bytes"] and checksum(data) == listed[name]["checksum"], f"{path}: other bytes")
        check_file(path)
    require(set(listed) <= names, f"{folder} lacks {sorted(set(listed) - names)}")
    require(len(solves) == 1, f"{folder} is of the solves {sorted(solves)}")
    return solves.pop()
