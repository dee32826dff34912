#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Unpacks the tarball in a clean Debian 13, where nothing that it needs is installed, and solves and draws: from a folder
# with a blank in its name, through a link. Usage: tarball_test.sh SOURCE_DIR WORK_DIR TARBALL CAD_FILES
set -euo pipefail

source_dir="$1" work="$2" tarball="$3" cad_files="$4"
. "$source_dir/tests/packages/chroot.sh"
chroot="$work/tarball"
trap 'rm -rf "$chroot"' EXIT

fresh_chroot "$chroot" trixie
models_in "$chroot"

start="$EPOCHREALTIME"
mkdir "$chroot/any folder"
tar --extract --file "$tarball" --directory "$chroot/any folder"
echo "unpacked in $(seconds_since "$start") s"
name="$(basename "$tarball" .tar.zst)"
in_chroot "$chroot" ln -s "/any folder/$name/bin/crossgrain" /usr/local/bin/crossgrain
check_program "$chroot" crossgrain

# For the programs nothing but glibc comes from the system, and nothing is under the GPL without an exception. The LGPL
# allows what these are: shared libraries that anybody may replace, with their licence and the address of their source.
outside="$(in_chroot "$chroot" sh -c 'find "/any folder" -type f \( -path "*/bin/*" -o -path "*/libexec/*" \) -exec ldd {} +' |
  awk '$2 == "=>" && $3 !~ /folder/ && $3 != "/any" { print $1, $3 }' | sort -u)"
others="$(echo "$outside" | grep -vE '^(libc|libm|libpthread|libdl|librt)\.so\.[0-9]+ ' || true)"
[ -z "$others" ] || fail "these come from the system: $others"
if grep GPL "$chroot/any folder/$name/README" | grep -vE 'Exception|exception'; then fail "there is a package under the GPL"; fi
