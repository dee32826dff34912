#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that includes go downwards only; prints one line for each that does not, and exits with 1.

Usage: check_layers.py [ROOT]

  src/LAYER/            includes itself, the layers before it in its component, those of components that this one needs, and
                        public headers
  include/crossgrain/   includes public headers and the standard library
  apps/ examples/       include public headers and what stands in their own folder, or in that of a program they share;
                        apps/ also PROGRAM_HEADERS

OpenCASCADE (*.hxx) stands in src/cad_reading/program/ only, and Netgen (nglib.h) in src/tet_making/netgen_program/, which are built
as programs apart; only these folders include their headers.
"""

import re
import sys
from pathlib import Path



def components_of(cmake_lists):
    """{name: (its layers from the lowest up, the components that it needs)} of the calls in CMakeLists.txt."""
    components = {}
    for name, arguments in re.findall(r"^ *crossgrain_component\(\s*(\w+)([^)]*)\)", cmake_lists, re.MULTILINE):
        lists = {"LAYERS": [], "COMPONENTS": [], "LIBRARIES": []}
        for word in arguments.split():
            if word in lists:
                current = lists[word]
            else:
                current.append(word)
        components[name] = (lists["LAYERS"], lists["COMPONENTS"])
    return components


COMPONENTS = components_of((Path(__file__).parent.parent / "CMakeLists.txt").read_text(encoding="utf-8"))

# From the lowest up; the last two are of the C interface, which sees all, and of several processes.
LAYERS = [layer for layers, _ in COMPONENTS.values() for layer in layers] + ["c_interface", "distributed"]

# Layers below another in its component that it stands beside, not above.
BESIDE = {
    "archives": ["text"],
    "vtu": ["archives"],
    "process": ["text", "archives", "vtu"],
    "cad_reading": ["text", "vtu"],
    "mesh_files": ["process"],
    "results": ["process", "cad_reading"],
    "remeshing": ["text", "archives", "vtu", "process", "cad_reading", "mesh_files", "results"],
    "tet_making": ["results"],
}

# The folder of src/ with OpenCASCADE in it.
CAD_PROGRAM = "cad_reading/program/"

# The one with Netgen in it.
NETGEN_PROGRAM = "tet_making/netgen_program/"

OUTER_FOLDERS = ["apps", "examples"]

# Headers of src/, not installed, that apps/ may include besides: what only the program needs of the library.
PROGRAM_HEADERS = ["results/one_solve.hpp", "results/result_files.hpp", "solve/tuned_solve.hpp"]

# Programs that share the commands of another.
SHARES = {"crossgrain-mpi": "crossgrain"}
SUFFIXES = {".hpp", ".cpp", ".h", ".cc", ".in"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
STANDARD_HEADER = re.compile(r"^[a-z0-9_]+$")
C_HEADERS = ["stddef.h", "stdint.h"]


def layers_in(component):
    """Those of a component and of all that it needs."""
    layers, needed = COMPONENTS[component]
    return [layer for name in needed for layer in layers_in(name)] + layers


def layers_seen_by(layer):
    if layer == "c_interface":
        return LAYERS[: LAYERS.index(layer) + 1]
    if layer == "distributed":
        return layers_in("core") + [layer]
    component = next(name for name, (layers, _) in COMPONENTS.items() if layer in layers)
    seen = layers_in(component)
    last = len(seen) - seen[::-1].index(layer)
    return [name for name in seen[:last] if name not in BESIDE.get(layer, [])]


def includes_of(path):
    """(line number, opening character, what is included) for each include of a file."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1), match.group(2)


def sources_below(folder):
    return sorted(path for path in folder.rglob("*") if path.is_file() and path.suffix in SUFFIXES)


def fault_in_layer(layer, path, quote, included):
    """`path` is that of the file within src/."""
    first = included.split("/")[0]
    if included.endswith(".hxx") and not path.startswith(CAD_PROGRAM):
        return f"OpenCASCADE stands in the program src/{CAD_PROGRAM} only"
    if included.endswith("nglib.h") and not path.startswith(NETGEN_PROGRAM):
        return f"Netgen stands in the program src/{NETGEN_PROGRAM} only"
    if included.startswith(CAD_PROGRAM) and not path.startswith(CAD_PROGRAM):
        return "the library sees no more of the program for CAD files than cad_reading/cad_messages.hpp"
    if included.startswith(NETGEN_PROGRAM) and not path.startswith(NETGEN_PROGRAM):
        return "the library sees no more of the program with Netgen than tet_making/netgen_messages.hpp"
    if first in ("tbb", "oneapi") and layer != "base":
        return "oneTBB stands behind base/parallel.hpp; use parallel_for"
    if quote == "<" and (first != "crossgrain" and first not in LAYERS or STANDARD_HEADER.match(included)):
        return None  # <map> is no layer
    if quote == "<":
        return 'headers of the project are included with ""'
    if first == "crossgrain" or first in layers_seen_by(layer):
        return None
    if first in LAYERS:
        return f"layer {layer} may not include layer {first}"
    return 'write "layer/file.hpp" or "crossgrain/file.hpp"'


def fault_in_public_header(path, quote, included):
    if quote == '"' and included.startswith("crossgrain/"):
        return None
    if quote == "<" and (included in C_HEADERS if path.suffix == ".h" else STANDARD_HEADER.match(included)):
        return None
    return "a public header includes only public headers and the standard library"


def fault_in_outer_folder(path, root, quote, included):
    if included.startswith("crossgrain/") or root.name == "apps" and included in PROGRAM_HEADERS:
        return None
    # Its own folder, or the folder of the program that it belongs to.
    own = [folder for folder in path.parents if root in (folder, *folder.parents)]
    shared = [folder.with_name(SHARES[folder.name]) for folder in own if folder.name in SHARES]
    if quote == '"' and any((folder / included).is_file() for folder in own + shared):
        return None
    if quote == '"' or included.split("/")[0] in LAYERS and not STANDARD_HEADER.match(included):
        return "outside src/ only public headers (crossgrain/*.hpp) may be included"
    return None


def faults(root):
    """One line for each include that goes the wrong way, and for each unknown folder of src/."""
    source_root = root / "src"
    for folder in sorted(path for path in source_root.glob("*") if path.is_dir()):
        layer = folder.name
        if layer not in LAYERS:
            yield f"src/{layer}: unknown layer; add it to a component in CMakeLists.txt"
            continue
        for path in sources_below(folder):
            for number, quote, included in includes_of(path):
                fault = fault_in_layer(layer, path.relative_to(source_root).as_posix(), quote, included)
                if fault:
                    yield f"{path.relative_to(root)}:{number}: includes {included}: {fault}"
    for path in sources_below(root / "include"):
        for number, quote, included in includes_of(path):
            fault = fault_in_public_header(path, quote, included)
            if fault:
                yield f"{path.relative_to(root)}:{number}: includes {included}: {fault}"
    for name in OUTER_FOLDERS:
        for path in sources_below(root / name):
            for number, quote, included in includes_of(path):
                fault = fault_in_outer_folder(path, root / name, quote, included)
                if fault:
                    yield f"{path.relative_to(root)}:{number}: includes {included}: {fault}"


def faults_of_the_list(root):
    """A line if the list in CONTRIBUTING.md is not that of the layers, in their order."""
    page = root / "CONTRIBUTING.md"
    if page.exists():
        listed = re.findall(r"^src/([a-z_]+) ", page.read_text(encoding="utf-8"), re.MULTILINE)
        if listed != LAYERS:
            yield f"CONTRIBUTING.md lists the layers {' '.join(listed)}, and they are {' '.join(LAYERS)}"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    found = [*faults(root), *faults_of_the_list(root)]
    print("\n".join(found) if found else "includes go downwards only")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
