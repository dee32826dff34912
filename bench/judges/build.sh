#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Builds programs of others that judge our fields, beside the project; says what is missing, and exits with 1 then.
#
#     build.sh SOURCES BUILT
#
# SOURCES has checkouts under the names below; BUILT gets the programs. README.md says what they are for.
#
#   CubeCover       github.com/evouga/CubeCover at 722d2d9
#   CoMISo          github.com/libigl/CoMISo at 562efe3 (Solver, Config, Utils, ext/gmm-4.2)
#   libHexEx        github.com/dbrandes-welfenlab/libHexExFull at 5487de6: libHexEx with its OpenVolumeMesh
#   libHexHex       github.com/cgg-bern/libHexHex at dd3bc8e
#   OpenVolumeMesh  github.com/OpenVolumeMesh/OpenVolumeMesh at v3.4.1
#   libTimekeeper   github.com/cgg-bern/libTimekeeper at 4f4b180
#   geogram         github.com/BrunoLevy/geogram at b8ef616 with its submodules amgcl, libMeshb and rply
#   mouette         github.com/GCoiffier/mouette at 7f93fa1, not built: matchings.py imports it
#
# Packages of Debian 12: g++ cmake ninja-build libeigen3-dev libblas-dev liblapack-dev libabsl-dev libcli11-dev nlohmann-json3-dev.

set -eu
[ $# -eq 2 ] || { sed -n '3,17p' "$0"; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
sources=$(cd "$1" && pwd)
mkdir -p "$2"
built=$(cd "$2" && pwd)
launcher=$(command -v ccache || true)
missing=0

# Whether all of these checkouts are there.
have() {
  local name
  for name in "$@"; do
    [ -e "$sources/$name" ] || { echo "missing: $sources/$name" >&2; missing=1; return 1; }
  done
}

# Without Gurobi, whose CubeCover finds better integers: CoMISo rounds them one by one.
build_cubecover() {
  local flags="-O2 -std=c++17 -w -DINCLUDE_TEMPLATES -DHAS_COMISO -I$sources -I$sources/CoMISo/ext/gmm-4.2/include"
  flags+=" -I/usr/include/eigen3 -I$sources/CubeCover/src"
  local objects=$built/objects file
  mkdir -p "$objects"
  for file in "$sources"/CoMISo/Solver/{EigenLDLTSolver,MISolver,ConstrainedSolver,GMM_Tools}.cc "$sources"/CubeCover/src/*.cpp; do
    $launcher g++ $flags -c "$file" -o "$objects/$(basename "$file").o"
  done
  g++ $flags "$sources/CubeCover/tools/integergrid/src/main.cpp" "$objects"/*.o -llapack -lblas -o "$built/cubecover_integergrid"
  g++ $flags "$here/cubecover_matchings.cpp" "$objects"/*.o -llapack -lblas -o "$built/cubecover_matchings"
}

configure() { cmake -S "$1" -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" "${@:3}" > "$2.log"; }

build_hexex() {
  configure "$sources/libHexEx" "$built/libHexEx"
  ninja -C "$built/libHexEx" cmdline_tool >> "$built/libHexEx.log"
  cp "$built/libHexEx/demo/cmdline_tool/cmdline_tool" "$built/hexex"
}

# Its own CMakeLists.txt downloads; this one takes checkouts and packages. Debian's CLI11 has no ensure_utf8.
build_hexhex() {
  local project=$built/libHexHex-project
  mkdir -p "$project"
  cp -r "$sources/libHexHex/tools/HexHex" "$project/tool"
  sed -i '/ensure_utf8/d' "$project/tool/main.cc"
  cat > "$project/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(judges LANGUAGES C CXX)
set(CMAKE_CXX_STANDARD 20)
find_package(nlohmann_json REQUIRED)
find_package(absl REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenMP COMPONENTS CXX)
add_subdirectory($sources/OpenVolumeMesh OpenVolumeMesh EXCLUDE_FROM_ALL)
add_subdirectory($sources/libTimekeeper libTimekeeper EXCLUDE_FROM_ALL)
add_subdirectory($sources/libHexHex/src libHexHex EXCLUDE_FROM_ALL)
add_subdirectory(tool)
END
  configure "$project" "$built/libHexHex"
  ninja -C "$built/libHexHex" >> "$built/libHexHex.log"
  cp "$built/libHexHex/tool/HexHex" "$built/hexhex"
}

build_geogram() {
  configure "$sources/geogram" "$built/geogram" -DVORPALINE_PLATFORM=Linux64-gcc-dynamic -DGEOGRAM_WITH_GRAPHICS=OFF \
    -DGEOGRAM_WITH_LUA=OFF -DGEOGRAM_WITH_EXPLORAGRAM=ON
  ninja -C "$built/geogram" hexdom_pipeline >> "$built/geogram.log"
  ln -sf geogram/bin/hexdom_pipeline "$built/hexdom_pipeline"
}

have CubeCover CoMISo && build_cubecover
have libHexEx && build_hexex
have libHexHex OpenVolumeMesh libTimekeeper && build_hexhex
have geogram geogram/src/lib/geogram/third_party/amgcl/amgcl && build_geogram
have mouette || true
exit $missing
