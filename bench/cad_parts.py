#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints a table of hexahedra in everyday CAD parts, which gmsh makes as STEP files: holes, fillets, chamfers, shafts, pipes.

    cad_parts.py --program CROSSGRAIN --out FOLDER [--cells 10,20] [PART...]

FOLDER gets PART.step, with the files that gmsh makes it of, and PART-CELLS with the results.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import time

UNION = "BooleanUnion{{Volume{{1}};Delete;}}{{Volume{{{}}};Delete;}}"
DIFFERENCE = "BooleanDifference{{Volume{{1}};Delete;}}{{Volume{{{}}};Delete;}}"

L_PROFILE = "Box(1)={0,0,0,10,6,2}; Box(2)={0,0,0,2,6,8};" + UNION.format(2)
HEXAGON = """For k In {0:5}
Point(k+1)={5*Cos(k*Pi/3),5*Sin(k*Pi/3),0};
EndFor
For k In {0:5}
Line(k+1)={k+1,(k+1)%6+1};
EndFor
Curve Loop(1)={1:6}; Plane Surface(1)={1}; Extrude{0,0,3}{Surface{1};}
"""
TRIANGLE = """Point(1)={0,0,0}; Point(2)={8,0,0}; Point(3)={2,6,0}; Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,1};
Curve Loop(1)={1:3}; Plane Surface(1)={1}; Extrude{0,0,4}{Surface{1};}
"""
TETRAHEDRON = """Point(1)={0,0,0}; Point(2)={6,0,0}; Point(3)={1,5,0}; Point(4)={2,2,5};
Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,1}; Line(4)={1,4}; Line(5)={2,4}; Line(6)={3,4};
Curve Loop(1)={1,2,3}; Plane Surface(1)={1}; Curve Loop(2)={1,5,-4}; Plane Surface(2)={2};
Curve Loop(3)={2,6,-5}; Plane Surface(3)={3}; Curve Loop(4)={3,4,-6}; Plane Surface(4)={4};
Surface Loop(1)={1,2,3,4}; Volume(1)={1};
"""

# In gmsh's language, with its OpenCASCADE kernel.
PARTS = {
    "plate_with_hole": "Box(1)={0,0,0,10,6,2}; Cylinder(2)={5,3,-1,0,0,4,1.5};" + DIFFERENCE.format(2),
    "plate_with_four_holes": "Box(1)={0,0,0,10,8,1}; Cylinder(2)={2,2,-1,0,0,4,.8}; Cylinder(3)={8,2,-1,0,0,4,.8};"
                             "Cylinder(4)={2,6,-1,0,0,4,.8}; Cylinder(5)={8,6,-1,0,0,4,.8};" + DIFFERENCE.format("2,3,4,5"),
    "thin_plate": "Box(1)={0,0,0,20,20,.5}; Cylinder(2)={10,10,-1,0,0,3,4};" + DIFFERENCE.format(2),
    "slanted_hole": "Box(1)={0,0,0,10,8,5}; Cylinder(2)={3,4,-3,3,0,12,1.3};" + DIFFERENCE.format(2),
    "blind_hole": "Box(1)={0,0,0,8,8,8}; Cylinder(2)={4,4,4,0,0,6,2};" + DIFFERENCE.format(2),
    "l_profile": L_PROFILE,
    "l_profile_with_fillet": L_PROFILE + "Cylinder(5)={3.5,-1,3.5,0,9,0,1.5}; Box(6)={2,0,2,1.5,6,1.5};"
                                         "BooleanDifference{Volume{6};Delete;}{Volume{5};Delete;}" + UNION.format(6),
    "slanted_box": "Box(1)={0,0,0,8,6,6}; Box(2)={-2,-2,5,14,10,5}; Rotate{{0,1,0},{0,0,6},Pi/12}{Volume{2};}" + DIFFERENCE.format(2),
    "rounded_box": "Box(1)={0,0,0,8,6,4}; Fillet{1}{1:12}{1}",
    "chamfered_box": "Box(1)={0,0,0,8,6,4}; Chamfer{1}{5}{1}{1.5}",
    "box_less_sphere": "Box(1)={0,0,0,10,10,6}; Sphere(2)={5,5,6,3};" + DIFFERENCE.format(2),
    "box_with_dome": "Box(1)={-4,-4,-4,8,8,8}; Sphere(2)={0,0,4,3};" + UNION.format(2),
    "nut": HEXAGON + "Cylinder(2)={0,0,-1,0,0,6,2.5};" + DIFFERENCE.format(2),
    "triangular_prism": TRIANGLE,
    "tetrahedron": TETRAHEDRON,
    "shaft": "Cylinder(1)={0,0,0,0,0,4,3}; Cylinder(2)={0,0,4,0,0,5,2}; Cylinder(3)={0,0,9,0,0,3,1};" + UNION.format("2,3"),
    "flange": "Cylinder(1)={0,0,0,0,0,1.5,6}; Cylinder(2)={0,0,0,0,0,6,3};" + UNION.format(2) +
              "Cylinder(4)={0,0,-1,0,0,9,2}; BooleanDifference{Volume{1};Delete;}{Volume{4};Delete;}",
    "pin_with_ball_end": "Cylinder(1)={0,0,0,0,0,8,2}; Sphere(2)={0,0,8,2};" + UNION.format(2),
    "cylinder_with_cross_hole": "Cylinder(1)={0,0,0,0,0,10,4}; Cylinder(2)={-6,0,5,12,0,0,1.5};" + DIFFERENCE.format(2),
    "tube": "Cylinder(1)={0,0,0,0,0,10,4}; Cylinder(2)={0,0,-1,0,0,12,3};" + DIFFERENCE.format(2),
    "t_joint": "Cylinder(1)={-6,0,0,12,0,0,2}; Cylinder(2)={0,0,0,0,0,6,2};" + UNION.format(2),
    "elbow": "Torus(1)={0,0,0,5,1.5,Pi/2};",
    "torus": "Torus(1)={0,0,0,5,1.5};",
    "hemisphere": "Sphere(1)={0,0,0,5,0,Pi/2,2*Pi};",
    "frustum": "Cone(1)={0,0,0,0,0,8,5,2};",
    "cone": "Cone(1)={0,0,0,0,0,8,5,0};",
}


def make(name, folder):
    """Returns PART.step, made by gmsh."""
    script = folder / f"{name}.geo"
    step = folder / f"{name}.step"
    script.write_text(f'SetFactory("OpenCASCADE");\n{PARTS[name]}\nSave "{step.name}";\n')
    step.unlink(missing_ok=True)
    made = subprocess.run(["gmsh", "-0", script, "-o", folder / f"{name}.brep"], capture_output=True, text=True, check=False)
    if not step.exists():
        sys.exit(f"gmsh does not make {step}: {made.stdout}{made.stderr}")
    return step


def add_row(program, folder, step, cells):
    """Prints a row; returns whether the part is all-hex."""
    name = step.stem
    results = folder / f"{name}-{cells}"
    start = time.monotonic()
    done = subprocess.run([program, "hex", step, "--cells", str(cells), "-o", results, "--force", "--no-report", "--quiet"],
                          capture_output=True, text=True, check=False)
    seconds = time.monotonic() - start
    if done.returncode not in (0, 6):
        print(f"| {name} | {cells} | failed: {done.stderr.strip()} ||||||", flush=True)
        return False
    found = json.loads((results / "report.json").read_text())["hexahedra"]
    shape, volume = found["scaled_jacobian"], found["volume"] / found["model_volume"] - 1
    result = "" if found["outcome"] == "all-hex" else f"{found['outcome']}: {found['reason']}"
    print(f"| {name} | {cells} | {found['used_size'] / found['size']:.2f} | {found['hexahedra']} | {shape['min']:.2f} | {shape['mean']:.2f} | {100 * volume:+.1f} % | {seconds:.0f} | {result} |",
          flush=True)
    return not result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--cells", default="10,20")
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(PARTS))
    options = parser.parse_args()
    if unknown := set(options.parts) - set(PARTS):
        parser.error(f"no such part: {', '.join(sorted(unknown))}")
    options.out.mkdir(parents=True, exist_ok=True)
    print("| part | cells | size taken | hexahedra | worst scaled Jacobian | mean | volume | s | result |\n|---|---|---|---|---|---|---|---|---|")
    steps = [make(name, options.out) for name in options.parts or PARTS]
    good = [add_row(options.program, options.out, step, int(cells)) for step in steps for cells in options.cells.split(",")]
    print(f"\n{sum(good)} of {len(good)} all-hex", file=sys.stderr)


if __name__ == "__main__":
    main()
