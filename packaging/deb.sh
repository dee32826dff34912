#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the Debian packages, build/packages/debs/*.deb, and prints their paths.
# Usage: packaging/deb.sh [FOLDER [BUILD]], as for packaging/build.sh
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
folder="${1:-$root/build/packages}"

"$root/packaging/build.sh" "$@"
rm -rf "$folder/debs" "$folder/_CPack_Packages"
cpack --config "$folder/CPackConfig.cmake" -B "$folder/debs" >"$folder/cpack.log" 2>&1 || { cat "$folder/cpack.log" >&2; exit 1; }
rm -rf "$folder/debs/_CPack_Packages"
ls "$folder"/debs/*.deb
