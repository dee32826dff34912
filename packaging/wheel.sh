#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes build/packages/crossgrain-VERSION-py3-none-manylinux_2_N_MACHINE.whl: the Python package with the library, the
# reader of CAD files and all libraries that these need, but for those that every Linux with Python has. Prints its path.
# Usage: packaging/wheel.sh [FOLDER [BUILD]], as for packaging/build.sh
set -euo pipefail

. "$(dirname "${BASH_SOURCE[0]}")/libraries.sh"
stage="$folder/wheel" tree="$folder/wheel/tree" lib="$folder/wheel/tree/crossgrain/lib"

# What manylinux_2_36 allows of the system besides glibc (auditwheel's policy): no library of its own, and no later symbols.
left_outside="libc6 libstdc++6 libgcc-s1"
newest_allowed="GLIBC=2.36 GLIBCXX=3.4.30 CXXABI=1.3.13 GCC=12.0.0"

install_components() {
  local component
  for component in core hex files io meshing display page picture c python cad; do
    cmake --install "$folder" --component "$component" --prefix "$stage/prefix" --strip >/dev/null
  done
  mkdir -p "$lib"
  cp -r "$stage/prefix/lib/python3/dist-packages/." "$tree/"
  # The library by the name that the package loads; no links, which wheels cannot have.
  find "$stage/prefix/lib" -type l -name 'libcrossgrain-*.so.*' -exec sh -c 'cp -L "$1" "$2/$(basename "$1")"' sh {} "$lib" \;
  mkdir -p "$tree/crossgrain/libexec/crossgrain"
  cp "$stage/prefix/libexec/crossgrain/crossgrain_cad" "$tree/crossgrain/libexec/crossgrain/"
}

# Gives the libraries of Debian names of their own: of two libraries with one name a process loads only the first.
rename_libraries() {
  local library name own names=()
  for library in "$lib"/*.so*; do
    name="$(basename "$library")"
    case "$name" in libcrossgrain-*) continue ;; esac
    own="${name%%.so*}-$(sha256sum "$library" | cut -c1-8).so${name#*.so}"
    mv "$library" "$lib/$own"
    patchelf --set-soname "$own" "$lib/$own"
    names+=(--replace-needed "$name" "$own")
  done
  for library in "$lib"/* "$tree"/crossgrain/libexec/crossgrain/*; do patchelf "${names[@]}" "$library"; done
}

set_run_paths() {
  patchelf --force-rpath --set-rpath '$ORIGIN' "$lib"/*
  patchelf --force-rpath --set-rpath '$ORIGIN/../../lib' "$tree"/crossgrain/libexec/crossgrain/*
}

check_policy() {
  local allowed newest outside
  for allowed in $newest_allowed; do
    newest="$(newest_needed "${allowed%=*}")"
    [ "$(printf '%s\n%s\n' "$newest" "${allowed#*=}" | sort -V | tail -1)" = "${allowed#*=}" ] || fail "it needs ${allowed%=*} $newest, later than ${allowed#*=}"
  done
  outside="$(libraries_outside | grep -vE '^(libc|libm|libdl|libpthread|librt|libstdc\+\+|libgcc_s)\.so\.' || true)"
  [ -z "$outside" ] || fail "it needs libraries outside: $outside"
}

write_metadata() {
  local info="$tree/crossgrain-$version.dist-info"
  write_licences "$info/licences"
  {
    echo "In crossgrain/lib are libraries of these packages of Debian $(cat /etc/debian_version), whose sources are at https://snapshot.debian.org:"
    echo
    copied_packages
  } >"$info/licences/README"
  printf 'Wheel-Version: 1.0\nGenerator: packaging/wheel.sh\nRoot-Is-Purelib: false\nTag: py3-none-%s\n' "$tag" >"$info/WHEEL"
}

rm -rf "$stage"
install_components
copy_libraries $left_outside
rename_libraries
set_run_paths
check_policy
tag="manylinux_2_$(newest_needed GLIBC | cut -d. -f2)_$machine"
write_metadata
rm -f "$folder"/crossgrain-*.whl
/usr/bin/python3 -m wheel pack "$tree" --dest-dir "$folder" >/dev/null
rm -rf "$stage"
ls "$folder"/crossgrain-*.whl
