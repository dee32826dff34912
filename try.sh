#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds the program into build/release, solves a part that ships with the project
# and shows its report. Safe to run again: only what changed is built.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
build="$root/build/release"
model="$root/models/bracket.stl"
result="$root/build/try/bracket.frames"

show_report() {
  local paths="model.triangles;model.watertight;levels.-1.active_cells;seconds.total;peak_memory_bytes"
  paths+=";energy.total;alignment_deg.mean;alignment_deg.p95;alignment_deg.max"
  paths+=";alignment_deg.excluded_share;singularity.arcs;singularity.length;singularity.boundary_ends"
  local values
  mapfile -t values < <(cmake -DFILE="$1" -DPATHS="$paths" -P "$root/cmake/json_values.cmake")
  set -- "${values[@]}"
  local -x LC_NUMERIC=C
  printf '\nSurface          %s triangles, %s\n' "$1" "$([ "$2" = ON ] && echo watertight || echo "not watertight")"
  printf 'Field            %s cells in %.1f s, %.0f MB at the peak\n' "$3" "$4" "${5}e-6"
  printf 'Energy           %.4g\n' "$6"
  printf 'Off the surface  %.2f degrees in the mean, %.2f at the 95th percentile, %.2f at most;\n' "$7" "$8" "$9"
  printf '                 over all but a share of %.3g of its area, where no frame can follow it\n' "${10}"
  printf 'Singular curves  %s, %.4g long in all, with %s ends on the surface\n\n' "${11}" "${12}" "${13}"
}

"$root/cmake/install_packages.sh" build
"$root/cmake/install_packages.sh" cad || echo "Building without the reader of STEP, IGES and BREP files" >&2

cmake -S "$root" -B "$build" -G Ninja --log-level=WARNING -DCMAKE_BUILD_TYPE=Release -DCROSSGRAIN_BUILD_TESTS=OFF -DCMAKE_UNITY_BUILD=ON >/dev/null
cmake --build "$build" --target crossgrain_app crossgrain_helpers
program="$build/apps/crossgrain/crossgrain"

mkdir -p "$(dirname "$result")"
"$program" solve "$model" -o "$result" --progress

show_report "$result/report.json"
cat <<EOF
Look at it:  $result/report.html   (in any browser; or: $program view $result)
The field:   $result/field.vtu   (opens in ParaView)
The report:  $result/report.json
Next:        $program solve YOUR_PART.stl --resolution 128
EOF
