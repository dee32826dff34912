#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the packages for the tests from the objects of a build folder. Usage: build_packages.sh SOURCE_DIR FOLDER BUILD
set -euo pipefail

if [ "$(id -u)" -ne 0 ]; then echo "skipped: only root can install packages in a chroot"; exit 77; fi
"$1/cmake/install_packages.sh" packages || { echo "skipped: the tools for packages cannot be installed"; exit 77; }
rm -rf "$2"
for script in deb.sh tarball.sh wheel.sh; do
  start="$EPOCHREALTIME"
  "$1/packaging/$script" "$2" "$3" 2>&1 | grep -v '^\[' # without the progress of the build
  echo "$script took $(awk -v from="$start" -v to="$EPOCHREALTIME" 'BEGIN { printf "%.1f", to - from }') s"
done
ls -l "$2"/debs/*.deb "$2"/*.tar.zst "$2"/*.whl
