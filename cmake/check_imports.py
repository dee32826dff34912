#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that no modules of the Python package or of the viewer import each other in a circle; prints one line for each circle, and
exits with 1.

Usage: check_imports.py [ROOT]

Imports inside functions count, and those of types only: they hide a circle and do not break it.
"""

import ast
import re
import sys
from pathlib import Path

PACKAGE = "python/crossgrain"
VIEWER = "viewer/src"

# Modules that python/generate.py makes; they import none of the others.
GENERATED = {"_interface", "options"}

TYPESCRIPT_IMPORT = re.compile(r"""\b(?:from|import)\s*\(?\s*["'](\.[^"']*)["']""")
TYPESCRIPT_COMMENT = re.compile(r"^\s*//[^\n]*|/\*.*?\*/", re.MULTILINE | re.DOTALL)


def names_imported(node, modules):
    """What a statement imports of the package; a name that is no module stands in __init__."""
    if isinstance(node, ast.Import):
        return [alias.name.split(".")[1] for alias in node.names if alias.name.startswith("crossgrain.")]
    if not isinstance(node, ast.ImportFrom):
        return []
    path = (node.module or "").split(".")
    if node.level == 0 and path[0] == "crossgrain":
        path = path[1:] or [""]
    elif node.level != 1:
        return []
    return [path[0]] if path[0] else [alias.name if alias.name in {*modules, *GENERATED} else "__init__" for alias in node.names]


def python_imports(folder):
    """{module: modules that it imports}."""
    modules = {path.stem: path for path in sorted(folder.glob("*.py"))}
    nodes = {name: ast.walk(ast.parse(path.read_text(encoding="utf-8"))) for name, path in modules.items()}
    return {name: {other for node in its for other in names_imported(node, modules) if other in modules} for name, its in nodes.items()}


def typescript_imports(folder):
    """{module: modules that it imports}, by their paths within the folder."""
    def imported(path):
        text = TYPESCRIPT_COMMENT.sub("", path.read_text(encoding="utf-8"))
        return {(path.parent / other).resolve().relative_to(folder.resolve()).as_posix() for other in TYPESCRIPT_IMPORT.findall(text)}
    return {path.relative_to(folder).as_posix(): imported(path) for path in sorted(folder.rglob("*.ts"))}


def circles(imports):
    """Circles of modules, as lists; at least one if there are any."""
    done = set()

    def search(module, way):
        if module in way:
            yield [*way[way.index(module):], module]
        elif module not in done:
            for other in sorted(imports.get(module, ())):
                yield from search(other, [*way, module])
            done.add(module)

    for module in imports:
        yield from search(module, [])


def faults(root):
    for folder, imports_of in ((PACKAGE, python_imports), (VIEWER, typescript_imports)):
        for circle in circles(imports_of(root / folder)):
            yield f"{folder}: {' imports '.join(circle)}"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    found = list(faults(root))
    print("\n".join(found) if found else "no modules import each other in a circle")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
