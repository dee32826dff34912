# SPDX-License-Identifier: Apache-2.0
# Builds what packages that stand alone are made of, and copies the libraries of Debian that it needs. To be sourced with the
# arguments of packaging/build.sh. Sets `root`, `folder`, `version` and `machine`; its functions want `tree` (the folder of
# the package), `lib` (where libraries go) and `stage` (for lists).

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
folder="$(realpath -m "${1:-$root/build/packages}")"
"$root/packaging/build.sh" "$@"
version="$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$folder/CMakeCache.txt")"
machine="$(uname -m)"
accepted="$root/packaging/accepted_packages.txt"

fail() { echo "packaging/$(basename "$0"): $*" >&2; exit 1; }

# Our programs and libraries and those copied.
binaries() { find "$tree" -type f \( -path '*/bin/*' -o -path '*/libexec/*' -o -name '*.so*' \); }

package_of() {
  # Where /lib is a link to /usr/lib, dpkg knows some libraries by one name and some by the other.
  { dpkg -S "$1" || dpkg -S "${1#/usr}" || true; } 2>/dev/null | head -1 | cut -d: -f1
}

# "NAME PATH" of each library outside the folder that something in it needs, at any depth.
libraries_outside() {
  binaries | xargs -n1 env LD_LIBRARY_PATH="$lib" ldd | awk -v own="$tree/" '
    $2 == "=>" && $3 == "not" { print $1, "missing" }
    $2 == "=>" && $3 ~ /^\// && index($3, own) != 1 { print $1, $3 }' | sort -u
}

# copy_libraries PACKAGE...: all but those of these packages, which every system has.
copy_libraries() {
  local name library package
  while read -r name library; do
    [ "$library" != missing ] || fail "$name is not installed"
    package="$(package_of "$(realpath "$library")")"
    if [[ " $* " == *" $package "* ]]; then continue; fi
    grep -q "^$package " "$accepted" || fail "$library is of the package '$package', which $accepted does not list"
    cp -L "$library" "$lib/$name"
    echo "$package" >>"$stage/copied"
  done < <(libraries_outside)
}

# The largest version of a set of symbols, such as GLIBC or GLIBCXX, that something in the folder needs.
newest_needed() {
  binaries | xargs -n1 readelf --version-info --wide | sed -n '/needs section/,$p' | grep -o "\b$1_[0-9.]*" | cut -d_ -f2 | sort -uV | tail -1
}

# write_licences FOLDER: the licences of Crossgrain and of all that was copied.
write_licences() {
  local package
  mkdir -p "$1"
  cp "$root/LICENSE" "$root/NOTICE" "$1/"
  cp "$folder/packages/crossgrain/copyright" "$1/crossgrain"
  # The texts that files of Debian refer to; that of the GPL with the libraries of GCC, which have an exception from it.
  cp -L /usr/share/common-licenses/{Apache-2.0,LGPL-2.1,MPL-2.0} "$1/"
  if grep -q '^libgcc' "$stage/copied"; then cp -L /usr/share/common-licenses/GPL-3 "$1/"; fi
  sort -u "$stage/copied" | while read -r package; do cp -L "/usr/share/doc/$package/copyright" "$1/$package"; done
}

# A line for each package of Debian whose libraries were copied: name, version, licence.
copied_packages() {
  local package
  sort -u "$stage/copied" | while read -r package; do
    printf '%-32s %-20s %s\n' "$package" "$(dpkg-query -Wf '${Version}' "$package" | head -1)" "$(sed -n "s/^$package  *//p" "$accepted")"
  done
}
