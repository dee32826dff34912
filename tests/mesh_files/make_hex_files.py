#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Has another program write files of hexahedra.

    make_hex_files.py gmsh|meshio FOLDER

Writes a box of 3 x 2 x 1 in 3 x 2 x 2 hexahedra in many formats. In files called tagged* the bottom has quads of the group 5; those
called curved* have hexahedra of order two. Exits with 77 where the program is not installed.
"""
import importlib.util
import shutil
import subprocess
import sys
from pathlib import Path

NOT_INSTALLED = 77


def by_gmsh(folder):
    (folder / "box.geo").write_text("""
Point(1) = {0, 0, 0}; Point(2) = {3, 0, 0}; Point(3) = {3, 2, 0}; Point(4) = {0, 2, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Transfinite Curve{1, 3} = 4; Transfinite Curve{2, 4} = 3;
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Surface{1}; Recombine Surface{1};
box[] = Extrude{0, 0, 1} { Surface{1}; Layers{2}; Recombine; };
Physical Surface("bottom", 5) = {1}; Physical Volume("box", 9) = {box[1]};
Mesh 3;
Mesh.MshFileVersion = 2.2; Save "tagged2.msh"; Save "a.vtk"; Save "a.inp"; Save "a.mesh";
Mesh.MshFileVersion = 4.1; Save "tagged4.msh";
Mesh.Binary = 1; Save "tagged4b.msh"; Mesh.MshFileVersion = 2.2; Save "tagged2b.msh"; Save "b.vtk";
Mesh.Binary = 0; SetOrder 2; Save "curved2.msh"; Save "curved.inp"; Mesh.MshFileVersion = 4.1; Save "curved4.msh";
""")
    subprocess.run(["gmsh", "box.geo", "-", "-v", "1"], cwd=folder, check=True, timeout=120)


def by_meshio(folder):
    import meshio
    import numpy as np

    points = np.array([(x, y, z / 2) for z in range(3) for y in range(3) for x in range(4)], dtype=float)

    def at(x, y, z):
        return x + 4 * (y + 3 * z)

    cubes = np.array([[at(x + i, y + j, z + k) for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
                      for z in range(2) for y in range(2) for x in range(3)])
    mesh = meshio.Mesh(points, [("hexahedron", cubes)])
    for name, options in (("a.vtk", {"binary": False}), ("b.vtk", {}), ("a.vtu", {}), ("b.vtu", {"binary": False}),
                          ("c.vtu", {"compression": None}), ("a.mesh", {}), ("a.inp", {})):
        mesh.write(folder / name, **options)
    meshio.medit.write(folder / "b.meshb", mesh)
    for name, version, is_binary in (("a.msh", "2.2", False), ("b.msh", "2.2", True), ("c.msh", "4.1", False), ("d.msh", "4.1", True)):
        meshio.gmsh.write(folder / name, mesh, version, binary=is_binary)


PROGRAMS = {"gmsh": (lambda: shutil.which("gmsh"), by_gmsh),
            "meshio": (lambda: importlib.util.find_spec("meshio"), by_meshio)}

if __name__ == "__main__":
    is_installed, write = PROGRAMS[sys.argv[1]]
    if not is_installed():
        sys.exit(NOT_INSTALLED)
    write(Path(sys.argv[2]))
