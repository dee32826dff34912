#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds what packages are made of, with shared libraries and for /usr, into build/packages (or FOLDER), and installs
# the Debian packages that this needs. Usage: packaging/build.sh [FOLDER [BUILD]]
#
# BUILD is a build folder of the same sources with the same flags, such as that of the tests, and up to date: its objects
# are copied (take_object.sh) instead of compiled again. The libraries of both kinds consist of the same objects.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
folder="$(realpath -m "${1:-$root/build/packages}")"
objects="${2:+$(realpath "$2")}"

launcher="$(command -v ccache || true)"
if [ -n "$objects" ]; then launcher="$root/packaging/take_object.sh;$objects"; fi

"$root/cmake/install_packages.sh" build cad netgen mpi packages
cmake -S "$root" -B "$folder" -G Ninja --log-level=WARNING -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
  -DCMAKE_SKIP_INSTALL_RPATH=ON -DCROSSGRAIN_ZSH_FOLDER=share/zsh/vendor-completions -DBUILD_SHARED_LIBS=ON -DCROSSGRAIN_PACKAGES=ON \
  -DCROSSGRAIN_BUILD_TESTS=OFF -DCROSSGRAIN_BUILD_EXAMPLES=OFF -DCROSSGRAIN_BUILD_CAD=ON -DCROSSGRAIN_BUILD_NETGEN=ON -DCROSSGRAIN_BUILD_MPI=ON \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" >/dev/null
# Copied objects tell nothing of the headers that they depend on.
if [ -n "$objects" ]; then cmake --build "$folder" --target clean >/dev/null; fi
cmake --build "$folder" >&2
