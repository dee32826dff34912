#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds with warnings as errors into build/test, and runs every test.
# Arguments go to ctest: ./test.sh -R Octree. With --nightly before them only the tests that take hours run.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
build="$root/build/test"
selection=()
if [[ "${1:-}" == --nightly ]]; then
  shift
  selection=(-C Nightly -L nightly)
fi

"$root/cmake/install_packages.sh" build test cad netgen gmsh hexahedra browser mpi shells packages chroot reference
command -v npm >/dev/null || "$root/cmake/install_packages.sh" npm

launcher=""
if command -v ccache >/dev/null; then launcher=ccache; fi
cmake -S "$root" -B "$build" -G Ninja --log-level=WARNING -DCMAKE_BUILD_TYPE=Release \
  -DCROSSGRAIN_BUILD_TESTS=ON -DCROSSGRAIN_WARNINGS_AS_ERRORS=ON -DCMAKE_UNITY_BUILD=ON -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" >/dev/null
cmake --build "$build"
ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" "${selection[@]}" "$@"
