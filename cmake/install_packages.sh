#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian packages of the named sections of debian-packages.txt that are missing; does nothing,
# and needs no root, where none is. Usage: cmake/install_packages.sh SECTION...
set -euo pipefail

list="$(dirname "${BASH_SOURCE[0]}")/debian-packages.txt"

packages_of() {
  awk -v wanted="[$1]" '/^\[/ { inside = ($1 == wanted); next } inside && NF && !/^#/ { print $1 }' "$list"
}

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

install() {
  DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet=2 --no-install-recommends "$@"
}

if ! command -v apt-get >/dev/null; then
  echo "This is no Debian: install by hand what $list names" >&2
  exit 1
fi

missing=()
for section in "$@"; do
  for package in $(packages_of "$section"); do
    is_installed "$package" || missing+=("$package")
  done
done
[ ${#missing[@]} -gt 0 ] || exit 0

if [ "$(id -u)" -ne 0 ]; then
  echo "Packages are missing and only root can install them: apt-get install ${missing[*]}" >&2
  exit 1
fi

echo "Installing ${missing[*]}" >&2
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
# The lists of a fresh system are empty, those of an old one name versions that are gone: only then update.
if ! install "${missing[@]}" >"$log" 2>&1; then
  if ! { apt-get update --quiet=2 && install "${missing[@]}"; } >"$log" 2>&1; then
    cat "$log" >&2
    echo "apt-get could not install ${missing[*]}: see above" >&2
    exit 1
  fi
fi
