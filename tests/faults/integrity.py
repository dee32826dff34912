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
VTU_END = b"\n  </AppendedData>\n</VTKFile>\n"
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
        require(file.read(len(VTU_END)) == VTU_END, f"{path}: no end")
        whole = file.tell()
        seal = file.read()
        file.seek(0)
        require(seal in (b"", b"<!-- checksum %08x -->\n" % zlib.crc32(file.read(whole) if seal else b"")), f"{path}: other bytes")


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


def check_report(path):
    """Returns the files that it lists by name."""
    content = path.read_bytes()
    body, behind = content[:-len(',\n  "checksum": "00000000"\n}\n')], content[-12:-4]
    require(f"{zlib.crc32(body):08x}".encode() == behind, f"{path}: other bytes")
    return {file["name"]: file for file in json.loads(content)["files"]}


def check_content(path, listed):
    """Compares size and CRC-32."""
    crc = 0
    require(path.stat().st_size == listed["bytes"], f"{path}: another size")
    with open(path, "rb") as file:
        while block := file.read(1 << 24):
            crc = zlib.crc32(block, crc)
    require(f"{crc:08x}" == listed["checksum"], f"{path}: other bytes")


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


def solve_of(path):
    with open(path, "rb") as file:
        found = re.search(SOLVE[path.suffix], file.read(1024))
    require(found, f"{path}: names no solve")
    return found[1].decode()


def solve_of_whole(folder, others=()):
    """The solve of a result folder that is whole; `others` are names of files that do not belong to it."""
    names = {path.name for path in folder.iterdir()} - set(others)
    require(ALWAYS <= names, f"{folder} has only {sorted(names)}")
    listed = check_report(folder / "report.json")
    require(set(listed) == names - {"report.json", "streamlines.vtu"}, f"{folder} lists {sorted(listed)} and has {sorted(names)}")
    solves = set()
    for name in sorted(names):
        path = folder / name
        if name in listed:
            check_content(path, listed[name])
        if path.suffix in SOLVE:
            solves.add(solve_of(path))
        check_file(path)
    require(len(solves) == 1, f"{folder} is of the solves {sorted(solves)}")
    return solves.pop()
