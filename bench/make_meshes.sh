#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the six meshes of docs/comparison.md with Gmsh (gmsh 4.8.4 of Debian 12): make_meshes.sh FOLDER
set -euo pipefail
mkdir -p "${1:?which folder?}"
cd "$1"

cat >sphere.geo <<END
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 1};
END
cat >cylinder.geo <<END
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 2, 0.7};
END
cat >part.geo <<END
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 3, 2, 0.6};
Box(2) = {0, 0, 0, 0.6, 2, 1.8};
Cylinder(3) = {-1, 1, 1.2, 3, 0, 0, 0.3};
Cylinder(4) = {1.2, 0.5, -1, 0, 0, 3, 0.25};
Cylinder(5) = {1.2, 1.5, -1, 0, 0, 3, 0.25};
Cylinder(6) = {2.3, 1, -1, 0, 0, 3, 0.4};
BooleanUnion(7) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
BooleanDifference(8) = { Volume{7}; Delete; }{ Volume{3:6}; Delete; };
END

mesh() { gmsh -3 "$1.geo" -clmax "$2" -format mesh -o "$3.mesh"; }
mesh sphere .095 sphere20k
mesh cylinder .085 cylinder20k
mesh part .1 part20k
mesh sphere .044 sphere200k
mesh cylinder .039 cylinder200k
mesh part .045 part200k
