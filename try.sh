#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds the program into build/release, solves a part that ships with the project
# and shows what came out. Safe to run again: only what changed is built.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
build="$root/build/release"
model="models/bracket.stl"
result="$root/build/try/bracket.frames"
program="$build/apps/crossgrain/crossgrain"

# Rough processor time of a first build, in seconds.
build_seconds=450

build_program() {
  local processors
  processors="$(nproc)"
  [ -x "$program" ] ||
    printf 'Building: about %d minutes of waiting, if nothing else takes the %d processors\n' $((1 + build_seconds / processors / 60)) "$processors"
  NINJA_STATUS='[%f of %t steps, %e s] ' cmake --build "$build" --target crossgrain_app crossgrain_helpers
}

show_report() {
  local paths="levels.-1.active_cells;seconds.total;peak_memory_bytes;model.triangles"
  paths+=";alignment_deg.mean;alignment_deg.p95;singularity.arcs;singularity.length;energy.total"
  local values
  mapfile -t values < <(cmake -DFILE="$1" -DPATHS="$paths" -P "$root/cmake/json_values.cmake")
  set -- "${values[@]}"
  local -x LC_NUMERIC=C
  printf '\nThe field has a frame, three orthogonal directions, in each of %d cells inside %s.\n' "$1" "$model"
  printf 'Cost             %.1f s and %.0f MB of memory, for a surface of %d triangles\n' "$2" "${3}e-6" "$4"
  printf 'At the surface   one direction is normal to it: within %.2g degrees in the mean, within %.2g on 95 %% of it\n' "$5" "$6"
  printf 'Inside           the directions turn smoothly, except around %d singular curves, %.4g long in all,\n' "$7" "$8"
  printf '                 where three or five hexahedra would meet in place of four\n'
  printf 'Energy           %.4g: the less, the smoother; compare it at the same resolution only\n\n' "$9"
}

"$root/cmake/install_packages.sh" build
"$root/cmake/install_packages.sh" cad || echo "Building without the reader of STEP, IGES and BREP files" >&2

cmake -S "$root" -B "$build" -G Ninja --log-level=WARNING -DCMAKE_BUILD_TYPE=Release -DCROSSGRAIN_BUILD_TESTS=OFF -DCMAKE_UNITY_BUILD=ON >/dev/null
build_program

mkdir -p "$(dirname "$result")"
"$program" solve "$root/$model" -o "$result" --quiet

show_report "$result/report.json"
cat <<EOF
Hexahedra:   $("$program" check "$result" | head -n 1)
Look at it:  $result/report.html   (in any browser; or: $program view $result)
The field:   $result/field.vtu   (opens in ParaView)
The report:  $result/report.json
Next:        $program hex YOUR_PART.step
EOF
