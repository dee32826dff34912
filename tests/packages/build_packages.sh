#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the packages for the tests from the objects of a build folder. Usage: build_packages.sh SOURCE_DIR FOLDER BUILD
set -euo pipefail

if [ "$(id -u)" -ne 0 ]; then echo "skipped: only root can install packages in a chroot"; exit 77; fi
"$1/packaging/deb.sh" "$2" "$3"
"$1/packaging/tarball.sh" "$2" "$3"
ls -l "$2"/debs/*.deb "$2"/*.tar.zst
