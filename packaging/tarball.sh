#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes build/packages/crossgrain-VERSION-linux-MACHINE.tar.zst: the program with all libraries that it needs but
# those of glibc, for any folder of any distribution. Prints its path and the least glibc that it needs.
# Usage: packaging/tarball.sh [FOLDER [BUILD]], as for packaging/build.sh
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
folder="$(realpath -m "${1:-$root/build/packages}")"
accepted="$root/packaging/tarball_packages.txt"

fail() { echo "packaging/tarball.sh: $*" >&2; exit 1; }

install_components() {
  local component
  for component in core files io page picture program cad; do
    cmake --install "$folder" --component "$component" --prefix "$tree" --strip >/dev/null
  done
  # One folder for our libraries and those of Debian.
  mv "$tree"/lib/*-linux-gnu*/* "$tree/lib/"
  rmdir "$tree"/lib/*-linux-gnu*
}

binaries() { find "$tree/bin" "$tree/libexec" "$tree/lib" -type f; }

package_of() {
  # Where /lib is a link to /usr/lib, dpkg knows some libraries by one name and some by the other.
  { dpkg -S "$1" || dpkg -S "${1#/usr}" || true; } 2>/dev/null | head -1 | cut -d: -f1
}

copy_libraries() {
  local name library package
  while read -r name library; do
    [ "$library" != missing ] || fail "$name is not installed"
    package="$(package_of "$(realpath "$library")")"
    [ "$package" != libc6 ] || continue
    grep -q "^$package " "$accepted" || fail "$library is of the package '$package', which $accepted does not list"
    cp -L "$library" "$tree/lib/$name"
    echo "$package" >>"$stage/copied"
  done < <(binaries | xargs -n1 env LD_LIBRARY_PATH="$tree/lib" ldd | awk -v own="$tree/" '$2 == "=>" && $3 == "not" { print $1, "missing" }
             $2 == "=>" && $3 ~ /^\// && index($3, own) != 1 { print $1, $3 }' | sort -u)
}

# Our files name the folder of libraries from their own place. This kind of run path (DT_RPATH) also counts for the
# libraries of Debian, which stay as they are.
set_run_paths() {
  patchelf --force-rpath --set-rpath '$ORIGIN/../lib' "$tree/bin/crossgrain"
  patchelf --force-rpath --set-rpath '$ORIGIN/../../lib' "$tree"/libexec/crossgrain/*
  find "$tree/lib" -name 'libcrossgrain-*' -type f -exec patchelf --force-rpath --set-rpath '$ORIGIN' {} +
}

least_glibc() {
  binaries | xargs -n1 readelf --version-info --wide | grep -o 'GLIBC_[0-9.]*' | cut -d_ -f2 | sort -uV | tail -1
}

write_documents() {
  local package
  mkdir -p "$tree/licences"
  cp "$root/LICENSE" "$root/NOTICE" "$tree/"
  cp "$folder/packages/crossgrain/copyright" "$tree/licences/crossgrain"
  # The texts that files of Debian refer to.
  cp -L /usr/share/common-licenses/{Apache-2.0,GPL-3,LGPL-2.1,MPL-2.0} "$tree/licences/"
  {
    echo "Crossgrain $version: run bin/crossgrain; its folder may be moved. Needs Linux on $machine with glibc $glibc or later."
    echo
    echo "Licence: Apache-2.0 (LICENSE, NOTICE). In lib/ are also libraries of these packages of Debian $(cat /etc/debian_version), whose"
    echo "sources are at https://snapshot.debian.org and whose licences are in licences/:"
    echo
    sort -u "$stage/copied" | while read -r package; do
      cp -L "/usr/share/doc/$package/copyright" "$tree/licences/$package"
      printf '%-32s %-20s %s\n' "$package" "$(dpkg-query -Wf '${Version}' "$package" | head -1)" \
        "$(sed -n "s/^$package  *//p" "$accepted")"
    done
  } >"$tree/README"
}

"$root/packaging/build.sh" "$@"
version="$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$folder/CMakeCache.txt")"
machine="$(uname -m)"
name="crossgrain-$version-linux-$machine"
stage="$folder/tarball"
tree="$stage/$name"
rm -rf "$stage"
install_components
copy_libraries
set_run_paths
glibc="$(least_glibc)"
write_documents
tar --create --directory "$stage" --owner=0 --group=0 --sort=name --use-compress-program='zstd -q -12 -T0' --file "$folder/$name.tar.zst" "$name"
rm -rf "$stage"
echo "$folder/$name.tar.zst"
echo "needs glibc $glibc or later" >&2
