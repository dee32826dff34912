#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the wheel in clean Debians without a compiler and without anything else of the project: with NumPy alone to the
# first array; beside Debian's vtk, meshio, tqdm and nbconvert; in another one (paraview) beside ParaView's Python, which
# conflicts with vtk; and in Debian 13 (numpy2) with Python 3.13 and NumPy 2. Runs the tests of the package there.
# Usage: wheel_test.sh SOURCE_DIR WORK_DIR PACKAGES CAD_FILES [paraview|numpy2]
set -euo pipefail

source_dir="$1" work="$2" wheel="$(echo "$3"/crossgrain-*.whl)" cad_files="$4" beside="${5:-}"
. "$source_dir/tests/packages/chroot.sh"
chroot="$work/wheel$beside"
trap 'rm -rf "$chroot"' EXIT

install_wheel() { in_chroot "$chroot" pip install --quiet --no-index --break-system-packages --root-user-action=ignore "/work/$(basename "$wheel")"; }
run_test() {
  local output
  output="$(in_chroot "$chroot" env "${settings[@]}" python3 "/work/tests/$1_test.py" 2>&1)" || { echo "$output" >&2; fail "$1_test.py"; }
  echo "$1_test.py: $(tail -1 <<<"$output") after $(seconds_since "$start") s"
}

fresh_chroot "$chroot" "$(if [ "$beside" = numpy2 ]; then echo trixie; else echo bookworm; fi)"
models_in "$chroot"
cp "$wheel" "$chroot/work/"
cp -r "$source_dir/tests/python" "$chroot/work/tests"
cp -r "$source_dir/examples/python" "$chroot/work/examples"
settings=(CROSSGRAIN_EXAMPLES=/work/examples CROSSGRAIN_ALL_PACKAGES=1)

start="$EPOCHREALTIME"
if [ "$beside" = paraview ]; then
  echo "== beside ParaView's Python"
  install_in "$chroot" python3-pip python3-numpy python3-paraview paraview
  install_wheel
  echo "installed after $(seconds_since "$start") s"
  run_test paraview
  exit
fi

echo "== wheel to the first array"
install_in "$chroot" python3-pip python3-numpy
echo "Python and NumPy installed in $(seconds_since "$start") s"
install_wheel
in_chroot "$chroot" sh -c 'cd /work && python3 -c "
import crossgrain as cg
field = cg.solve(\"bracket.stl\", resolution=64)
print(field, field.frames.shape)
print(cg.solve(\"part.step\", resolution=32).check())"'
echo "first array after $(seconds_since "$start") s"
if in_chroot "$chroot" sh -c 'command -v cc || command -v crossgrain'; then fail "there is a compiler, or the program"; fi
outside="$(in_chroot "$chroot" sh -c 'ldd "$(python3 -c "from crossgrain import _library; print(_library.library._name)")"' |
  awk '$3 ~ /^\// && $3 !~ /crossgrain/ { print $1 }' | grep -vE '^(libc|libm|libdl|libpthread|librt|libstdc\+\+|libgcc_s)\.so\.' || true)"
[ -z "$outside" ] || fail "these come from the system: $outside"
for name in package arrays_fuzz examples; do run_test "$name"; done
in_chroot "$chroot" python3 -c 'import sys, numpy; print("Python", sys.version.split()[0], "NumPy", numpy.__version__)'
if [ "$beside" = numpy2 ]; then exit; fi

echo "== beside vtk, meshio, tqdm and nbconvert"
install_in "$chroot" python3-vtk9 python3-meshio python3-tqdm jupyter-nbconvert python3-ipykernel
for name in other_packages notebook; do run_test "$name"; done
