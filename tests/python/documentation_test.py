# SPDX-License-Identifier: Apache-2.0
"""Every statement in Python of the documentation runs, and every name of the package is documented.

CROSSGRAIN_CAD_FILES is the program that makes the STEP file; without it a box of triangles takes its place.
"""

import ast
import contextlib
import importlib.util
import inspect
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import crossgrain as cg
from solids import ball, cube_of_tets, stl_bytes

ROOT = Path(__file__).parents[2]
PAGES = ["docs/python.md", "docs/hexahedra.md", "python/README.md", "README.md"]
CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")


def statements_of(page):
    for block in re.findall(r"^```python\n(.*?)^```", (ROOT / page).read_text(encoding="utf-8"), re.M | re.S):
        yield from ast.parse(block).body


class Documentation(unittest.TestCase):
    # Pages begin with the same hexahedra of the same part, which are made once.
    hexahedra = {}

    def run_statement(self, text, names):
        if text not in self.hexahedra:
            exec(text, names)  # pylint: disable=exec-used
        if re.match(r"mesh = cg\.hex\('part\.\w+', size=4\)$", text):
            names["mesh"] = self.hexahedra.setdefault(text, names.get("mesh"))

    def test_statements_run(self):
        for page in PAGES:
            with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder) if hasattr(contextlib, "chdir") else _chdir(folder):
                self.run_page(page, Path(folder))

    def run_page(self, page, folder):
        vertices, triangles = ball(6)
        (folder / "part.stl").write_bytes(stl_bytes(vertices, triangles))
        (folder / "part.step").touch()
        if CAD_FILES:
            subprocess.run([CAD_FILES, folder], check=True, stdout=subprocess.DEVNULL)
            os.replace(folder / "plate.step", folder / "part.step")
        points, cells = cube_of_tets(3)
        names = {"cg": cg, "vertices": vertices, "triangles": triangles, "points": points, "cells": cells, "at": [0, 0, 0], "axes": [1, 0, 0],
                 "part": "part.stl"}
        names.update(earlier=cg.solve(vertices, triangles, resolution=8))
        for package in ("meshio", "pyvista"):
            if importlib.util.find_spec(package):
                names[package] = importlib.import_module(package)
                (folder / "part.ply").unlink(missing_ok=True)
        if "meshio" in names:
            names["meshio"].Mesh(vertices, [("triangle", triangles.astype("i4"))]).write(folder / "part.ply")
        for statement in statements_of(page):
            text = ast.unparse(statement)
            if any(package in text and package not in names for package in ("meshio", "pyvista")) or "pyvista" in text:
                continue
            if re.search(r"make_tets|cg\.hex\(|\bmesh\.", text) and not shutil.which("gmsh"):
                continue
            if "part.step" in text and not CAD_FILES:
                text = text.replace("part.step", "part.stl")
            text = text.replace("resolution=128", "resolution=16").replace("cell_size=0.5", "cell_size=0.2")
            text = text.replace("solve(vertices, triangles)", "solve(vertices, triangles, resolution=16)").replace("size=2)", "size=4)")
            text = text.replace("SolveOptions(degree=3,", "SolveOptions(resolution=16, degree=3,")
            with self.subTest(page=page, statement=text), contextlib.redirect_stdout(io.StringIO()):
                self.run_statement(text, names)

    def test_strings_are_there_for_every_public_name(self):
        missing = []
        for name in cg.__all__:
            value = getattr(cg, name)
            if not inspect.isclass(value) and not callable(value):
                continue
            missing += [name] if not inspect.getdoc(value) else []
            if inspect.isclass(value):
                missing += [f"{name}.{member}" for member, its in vars(value).items() if not member.startswith("_")
                            and (inspect.isfunction(its) or isinstance(its, property)) and not inspect.getdoc(its)]
        self.assertEqual(missing, [])


@contextlib.contextmanager
def _chdir(folder):
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


if __name__ == "__main__":
    unittest.main()
