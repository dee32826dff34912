# SPDX-License-Identifier: Apache-2.0
# Clean systems for tests of packages, to be sourced. Nothing is mounted outside the processes that run in them.

# ctest takes this exit code for a test that cannot run here.
skip() { echo "skipped: $*"; exit 77; }
fail() { echo "failed: $*" >&2; exit 1; }
seconds_since() { awk -v from="$1" -v to="$EPOCHREALTIME" 'BEGIN { printf "%.1f", to - from }'; }

# fresh_chroot FOLDER SUITE: a minimal Debian in FOLDER, a copy of one that is made once in FOLDER/../SUITE.
fresh_chroot() {
  local folder="$1" suite="$2" base mirror=http://deb.debian.org/debian
  base="$(dirname "$folder")/$suite"
  [ "$(id -u)" -eq 0 ] || skip "only root can make a chroot"
  "$source_dir/cmake/install_packages.sh" chroot || skip "debootstrap cannot be installed"
  unshare --mount true 2>/dev/null || skip "this container allows no mounts of its own"
  mkdir -p "$(dirname "$folder")"
  (
    flock 9
    if [ ! -d "$base" ]; then
      rm -rf "$base.part"
      unshare --mount debootstrap --variant=minbase "$suite" "$base.part" "$mirror" >"$base.log" 2>&1 || exit 1
      # Only speed matters for a system that is thrown away.
      echo force-unsafe-io >"$base.part/etc/dpkg/dpkg.cfg.d/unsafe-io"
      mv "$base.part" "$base"
    fi
  ) 9>"$base.lock" || skip "debootstrap has not made $suite from $mirror: $(tail -1 "$base.log")"
  rm -rf "$folder"
  cp -a "$base" "$folder"
  cp -L /etc/resolv.conf "$folder/etc/resolv.conf"
}

# in_chroot FOLDER COMMAND...: runs it with /proc, which programs need to find themselves.
in_chroot() {
  unshare --mount --pid --fork --kill-child bash -c 'mount -t proc proc "$0/proc" && exec chroot "$0" env -i \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"' "$@"
}

# install_in FOLDER PACKAGE...: by apt, without packages that are only recommended.
install_in() {
  local folder="$1" log="$1.apt.log"
  shift
  local command=(apt-get install --yes --quiet=2 --no-install-recommends "$@")
  in_chroot "$folder" "${command[@]}" >"$log" 2>&1 ||
    { in_chroot "$folder" apt-get update --quiet=2 && in_chroot "$folder" "${command[@]}"; } >"$log" 2>&1 ||
    { cat "$log" >&2; fail "apt could not install $*"; }
}

# check_program FOLDER PROGRAM: solves, checks and draws a triangle mesh and a CAD file that stand in FOLDER/work. Tells
# the seconds since $start.
check_program() {
  local folder="$1" program="$2"
  run() { in_chroot "$folder" sh -c 'cd /work && exec "$@"' sh "$program" "$@"; }
  run --version
  run --version | grep '^CAD files  *yes' >/dev/null || fail "it does not find the reader of CAD files"
  run solve bracket.stl --resolution 64 --quiet
  echo "first field after $(seconds_since "$start") s"
  run render bracket.frames --cut y --quiet
  head -c 4 "$folder/work/bracket.png" | grep -q PNG || fail "bracket.png is no picture"
  echo "first picture after $(seconds_since "$start") s"
  run check bracket.frames >/dev/null
  run solve part.step --resolution 32 --quiet
  run check part.frames >/dev/null
  # It serves the page until it is interrupted.
  run_for_a_second() { in_chroot "$folder" timeout --signal=INT --preserve-status 1 "$@"; }
  run_for_a_second "$program" view /work/bracket.frames --no-browser | grep http://127.0.0.1 >/dev/null || fail "view serves no page"
}

# models_in FOLDER: the models of check_program.
models_in() {
  mkdir -p "$1/work"
  cp "$source_dir/models/bracket.stl" "$1/work/"
  local files
  files="$(mktemp -d)"
  "$cad_files" "$files" >/dev/null
  cp "$files/plate.step" "$1/work/part.step"
  rm -rf "$files"
}
