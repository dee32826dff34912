#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Says how far a field is from hexahedra: the flips of its seamless map, without integers and without untangling.

    poisson_map.py MESH FRA [PERM]      tets of a Medit file, or of onto.vtu; without PERM, matchings of the nearest frames
    poisson_map.py FOLDER               its *.mesh or onto.vtu, onto.fra and onto.perm
    poisson_map.py --compare A B        a table of two such folders, or of the folders of the same names within both

Prints one line of JSON for each field:

    tets, faces             number of tets, and of triangles of the surface
    singular_edges          inner edges around which the product of matchings is not the identity
    ends_on_surface         ends of such edges on the surface
    off_axis_smooth         faces of the surface without an axis within OFF_AXIS_DEG of their normal, all edges smooth
    off_axis_creased        the same of faces with an edge at which the surface turns by CREASE_DEG or more
    flips, flipped_share    tets whose determinant is LEAST_DETERMINANT or less, and their share of the volume
    flat                    those of them whose determinant is zero
    least_determinant       1 in tets where the map follows the frames
    unknowns, seconds       size of the system, and time without reading
"""

import json
import sys
import time
from pathlib import Path

import numpy as np

from field_reader import read_arrays
from seamless_map import MatchedField, SeamlessMap

OFF_AXIS_DEG = 10
CREASE_DEG = 35
LEAST_DETERMINANT = 1e-9  # rounding of tets that are flat in the map is 1e-13
SECTIONS = {"Vertices": 4, "Corners": 1, "RequiredVertices": 1, "Edges": 3, "Ridges": 1, "RequiredEdges": 1, "Triangles": 4,
            "RequiredTriangles": 1, "Quadrilaterals": 5, "Tetrahedra": 5, "Prisms": 7, "Pyramids": 6, "Hexahedra": 9}


def medit_sections(path):
    """The rows of each section of a Medit file as floats, by keyword; tags are the last column, vertices count from 1."""
    words = Path(path).read_text().split()
    found, at = {}, 0
    while at < len(words):
        width = SECTIONS.get(words[at])
        if width is None:
            at += 1
            continue
        count = int(words[at + 1])
        found[words[at]] = np.array(words[at + 2:at + 2 + count * width], float).reshape(count, width)
        at += 2 + count * width
    return found


def read_medit(path):
    """Points, and tets numbered from 0."""
    found = medit_sections(path)
    return found["Vertices"][:, :3], found["Tetrahedra"][:, :4].astype(int) - 1


def read_tets(path):
    if Path(path).suffix == ".vtu":
        arrays = read_arrays(path)
        return arrays["Points"].reshape(-1, 3).astype(float), arrays["connectivity"].reshape(-1, 4)
    return read_medit(path)


def read_fra(path):
    """Axes as rows, (tets, 3, 3); CubeCover's files scale them by the size of hexahedra, here they get length 1."""
    words = Path(path).read_text().split()
    axes = np.array(words[5:], float).reshape(int(words[2]), 3, 3)
    return axes / np.linalg.norm(axes, axis=2, keepdims=True)


def read_perm(path):
    words = Path(path).read_text().split()
    return np.array(words[5:], int).reshape(int(words[3]), 5)


def read_field(mesh, fra, perm=None):
    points, tets = read_tets(mesh)
    axes = read_fra(fra)
    if len(axes) != len(tets):
        raise ValueError(f"{fra} has {len(axes)} frames, {mesh} {len(tets)} tets")
    return MatchedField(points, tets, axes, None if perm is None else read_perm(perm))


def files_of(folder):
    """Mesh, frames and matchings of a folder."""
    meshes = [*sorted(folder.glob("*.mesh")), folder / "onto.vtu"]
    return meshes[0], folder / "onto.fra", folder / "onto.perm"


def off_axis(field):
    """Numbers of smooth and of creased faces of the surface without an axis near the normal."""
    _, first, last = field.faces_beside_sectors()
    turned = np.einsum("ni,ni->n", field.normals[first], field.normals[last]) <= np.cos(np.radians(CREASE_DEG))
    creased = np.zeros(len(field.surface), bool)
    creased[np.concatenate([first[turned], last[turned]])] = True
    off = np.abs(field.cosines).max(axis=1) < np.cos(np.radians(OFF_AXIS_DEG))
    return int((off & ~creased).sum()), int((off & creased).sum())


def figures_of(field):
    started = time.monotonic()
    found = SeamlessMap(field)
    smooth, creased = off_axis(field)
    flipped = found.determinants <= LEAST_DETERMINANT
    singular = found.cut.singular
    return {"tets": len(field.tets), "faces": len(field.surface), "singular_edges": int(singular.sum()),
            "ends_on_surface": int(field.on_surface[field.edges[singular]].sum()), "off_axis_smooth": smooth,
            "off_axis_creased": creased, "flips": int(flipped.sum()),
            "flipped_share": round(float(found.volume[flipped].sum() / found.volume.sum()), 6),
            "flat": int((np.abs(found.determinants) <= LEAST_DETERMINANT).sum()),
            "least_determinant": float(f"{found.determinants.min():.3g}"), "unknowns": found.unknowns,
            "seconds": round(time.monotonic() - started, 2)}


def fields_within(folder):
    if (folder / "onto.fra").exists():
        return {folder.name: folder}
    return {path.name: path for path in sorted(folder.iterdir()) if (path / "onto.fra").exists()}


def compare(one, other):
    """Prints a table, and last the sums."""
    one, other = fields_within(one), fields_within(other)
    names = list(zip(one, other)) if len(one) == len(other) == 1 else [(name, name) for name in one if name in other]
    columns = ("tets", "singular_edges", "ends_on_surface", "off_axis_smooth", "off_axis_creased", "flips", "flipped_share")
    print("| field | " + " | ".join(column.replace("_", " ") for column in columns) + " |\n|---" + "|---" * len(columns) + "|")
    sums = np.zeros((2, len(columns)))
    for a, b in names:
        rows = [figures_of(read_field(*files_of(folder))) for folder in (one[a], other[b])]
        sums += [[row[column] for column in columns] for row in rows]
        print(table_row(a, *([row[column] for column in columns] for row in rows)), flush=True)
    print(table_row("sum", *sums.tolist()))


def table_row(name, before, after):
    cells = (" → ".join(f"{x:.4g}" if isinstance(x, float) else str(x) for x in pair) for pair in zip(before, after))
    return f"| {name} | " + " | ".join(cells) + " |"


def main(arguments):
    if arguments[:1] == ["--compare"] and len(arguments) == 3:
        compare(Path(arguments[1]), Path(arguments[2]))
    elif len(arguments) == 1:
        print(json.dumps(figures_of(read_field(*files_of(Path(arguments[0]))))))
    elif len(arguments) in (2, 3) and not arguments[0].startswith("-"):
        print(json.dumps(figures_of(read_field(*arguments))))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
