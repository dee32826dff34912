#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes build/packages/crossgrain-VERSION-linux-MACHINE.tar.zst: the program with all libraries that it needs but
# those of glibc, for any folder of any distribution. Prints its path and the least glibc that it needs.
# Usage: packaging/tarball.sh [FOLDER [BUILD]], as for packaging/build.sh
set -euo pipefail

. "$(dirname "${BASH_SOURCE[0]}")/libraries.sh"
name="crossgrain-$version-linux-$machine"
stage="$folder/tarball" tree="$folder/tarball/$name" lib="$folder/tarball/$name/lib"

install_components() {
  local component
  for component in core hex files io meshing display page picture program cad; do
    cmake --install "$folder" --component "$component" --prefix "$tree" --strip >/dev/null
  done
  # One folder for our libraries and those of Debian.
  mv "$lib"/*-linux-gnu*/* "$lib/"
  rmdir "$lib"/*-linux-gnu*
}

# Our files name the folder of libraries from their own place. This kind of run path (DT_RPATH) also counts for the
# libraries of Debian, which stay as they are.
set_run_paths() {
  patchelf --force-rpath --set-rpath '$ORIGIN/../lib' "$tree/bin/crossgrain"
  patchelf --force-rpath --set-rpath '$ORIGIN/../../lib' "$tree"/libexec/crossgrain/*
  find "$lib" -name 'libcrossgrain-*' -type f -exec patchelf --force-rpath --set-rpath '$ORIGIN' {} +
}

write_readme() {
  echo "Crossgrain $version: run bin/crossgrain; its folder may be moved. Needs Linux on $machine with glibc $glibc or later."
  echo
  echo "Licence: Apache-2.0 (licences/LICENSE, licences/NOTICE). In lib/ are also libraries of these packages of Debian"
  echo "$(cat /etc/debian_version), whose sources are at https://snapshot.debian.org and whose licences are in licences/:"
  echo
  copied_packages
}

rm -rf "$stage"
install_components
copy_libraries libc6
set_run_paths
glibc="$(newest_needed GLIBC)"
write_licences "$tree/licences"
write_readme >"$tree/README"
tar --create --directory "$stage" --owner=0 --group=0 --sort=name --use-compress-program='zstd -q -12 -T0' --file "$folder/$name.tar.zst" "$name"
rm -rf "$stage"
echo "$folder/$name.tar.zst"
echo "needs glibc $glibc or later" >&2
