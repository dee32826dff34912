#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian packages in a clean Debian 12 without a compiler, solves and draws, also by Python and by several
# processes; then installs a compiler, and builds the installed examples and a program that makes hexahedra through CMake,
# and one example and a program in C through pkg-config. Usage: deb_test.sh SOURCE_DIR WORK_DIR DEBS CAD_FILES
set -euo pipefail

source_dir="$1" work="$2" debs="$3" cad_files="$4"
. "$source_dir/tests/packages/chroot.sh"
chroot="$work/deb"
trap 'rm -rf "$chroot"' EXIT

fresh_chroot "$chroot" bookworm
models_in "$chroot"
mkdir "$chroot/debs"
cp "$debs"/*.deb "$chroot/debs/"
packages() { (cd "$chroot" && find debs -name "$1_*.deb" -printf '/%p\n'); }

echo "== packages to the first picture"
start="$EPOCHREALTIME"
install_in "$chroot" $(packages crossgrain) $(packages crossgrain-cad) $(packages 'libcrossgrain[0-9]*')
echo "installed in $(seconds_since "$start") s"
if in_chroot "$chroot" sh -c 'command -v cc'; then fail "there is a compiler"; fi
check_program "$chroot" crossgrain
for page in crossgrain crossgrain-solve crossgrain-render; do
  [ -f "$chroot/usr/share/man/man1/$page.1.gz" ] || fail "there is no man page $page"
done

python="$(packages python3-crossgrain)"
if [ -n "$python" ]; then
  echo "== Python"
  start="$EPOCHREALTIME"
  install_in "$chroot" "$python"
  echo "installed in $(seconds_since "$start") s"
  in_chroot "$chroot" python3 -c 'import crossgrain; print(crossgrain.solve("/work/part.step", resolution=16).frames.shape, "frames by Python")'
fi

netgen="$(packages crossgrain-netgen)"
if [ -n "$netgen" ]; then
  echo "== tets by Netgen"
  start="$EPOCHREALTIME"
  install_in "$chroot" "$netgen"
  echo "installed in $(seconds_since "$start") s"
  in_chroot "$chroot" crossgrain tets /work/part.step -o /work/part.mesh
fi

echo "== several processes"
start="$EPOCHREALTIME"
install_in "$chroot" $(packages crossgrain-mpi)
echo "installed in $(seconds_since "$start") s"
in_chroot "$chroot" env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 \
  OMPI_MCA_mpi_yield_when_idle=1 mpirun -n 2 crossgrain-mpi solve /work/bracket.stl -o /work/by_two.frames --resolution 32 --quiet
echo "solved after $(seconds_since "$start") s"
in_chroot "$chroot" crossgrain check /work/by_two.frames >/dev/null

echo "== examples with a compiler"
start="$EPOCHREALTIME"
install_in "$chroot" g++ cmake make pkg-config $(packages libcrossgrain-dev)
echo "compiler installed in $(seconds_since "$start") s"
cp "$source_dir/tests/project/consumer/main.c" "$chroot/work/"
cp -r "$source_dir/tests/project/hex_consumer" "$chroot/work/"
in_chroot "$chroot" sh -ec '
  cmake -S /usr/share/crossgrain/examples -B /tmp/examples >/dev/null
  cmake --build /tmp/examples -j2 >/dev/null
  ctest --test-dir /tmp/examples -Q || ctest --test-dir /tmp/examples --rerun-failed --output-on-failure
  cmake -S /work/hex_consumer -B /tmp/hexahedra >/dev/null
  cmake --build /tmp/hexahedra >/dev/null
  /tmp/hexahedra/hex_consumer
  for module in /usr/lib/*/pkgconfig/crossgrain*.pc; do pkg-config --validate "$module"; done
  g++ -std=c++20 /usr/share/crossgrain/examples/solve_from_arrays.cpp -o /tmp/example $(pkg-config --cflags --libs crossgrain)
  /tmp/example
  cc /work/main.c -o /tmp/in_c $(pkg-config --cflags --libs crossgrain-c)
  /tmp/in_c'
echo "examples built and run after $(seconds_since "$start") s"
