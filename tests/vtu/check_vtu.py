#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""An independent reader of VTK XML files in appended raw zlib form.

    check_vtu.py FILE.vtu

Prints a line for each array: section, name, type, components, values, and the CRC-32 of the raw bytes. Exits
with 1 and a message where the file breaks a rule of the format. Standard library only.
"""
import re
import struct
import sys
import xml.etree.ElementTree as ElementTree
import zlib

BYTES = {"Float32": 4, "Float64": 8, "Int32": 4, "Int64": 8, "UInt8": 1, "UInt32": 4, "UInt64": 8}


def inflate(data, offset):
    """Raw bytes of the array at `offset`, and where it ends."""
    count, block, last = struct.unpack_from("<3Q", data, offset)
    sizes = struct.unpack_from("<%dQ" % count, data, offset + 24)
    position, raw = offset + 24 + 8 * count, []
    for i, size in enumerate(sizes):
        inflated = zlib.decompress(data[position:position + size])
        expected = last if i == count - 1 and last else block
        assert len(inflated) == expected, "block %d inflates to %d bytes, not %d" % (i, len(inflated), expected)
        raw.append(inflated)
        position += size
    return b"".join(raw), position


def main(path):
    content = open(path, "rb").read()
    begin = re.search(rb'<AppendedData\s+encoding="raw">\s*_', content)
    end = content.rindex(b"</AppendedData>")
    data = content[begin.end():end]
    # Without the raw data the file must be well-formed XML.
    root = ElementTree.fromstring(content[:begin.end()] + content[end:])
    assert root.tag == "VTKFile" and root.get("type") == "UnstructuredGrid"
    assert root.get("byte_order") == "LittleEndian" and root.get("header_type") == "UInt64"
    assert root.get("compressor") == "vtkZLibDataCompressor"
    grid = root.find("UnstructuredGrid")
    piece = grid.find("Piece")
    points, cells = int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells"))
    rows_of = {"PointData": points, "CellData": cells, "Points": points}
    used = 0
    for parent in [grid.find("FieldData")] + [piece.find(s) for s in ("PointData", "CellData", "Points", "Cells")]:
        for array in parent:
            name, kind = array.get("Name"), array.get("type")
            components = int(array.get("NumberOfComponents", "1"))
            raw, stop = inflate(data, int(array.get("offset")))
            rows, rest = divmod(len(raw), components * BYTES[kind])
            assert rest == 0, name + ": not whole rows"
            assert rows == rows_of.get(parent.tag, rows), name + ": %d rows" % rows
            if parent.tag == "FieldData":
                assert rows == int(array.get("NumberOfTuples")), name
            if parent.tag == "Cells" and name in ("offsets", "types"):
                assert rows == cells, name
            print(parent.tag, name, kind, components, rows * components, "%08x" % zlib.crc32(raw))
            used = max(used, stop)
    assert data[used:].strip() == b"", "bytes after the last array"


if __name__ == "__main__":
    try:
        main(sys.argv[1])
    except (AssertionError, AttributeError, ValueError, struct.error, zlib.error) as error:
        sys.exit("%s: %s" % (sys.argv[1], error))
