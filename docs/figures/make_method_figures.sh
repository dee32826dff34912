#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the figures of docs/method.md: builds the program that draws them into build/figures and runs it.
#   --check         leaves the figures as they are, and fails where they would come out otherwise
#   --program FILE  runs this one and builds none
set -euo pipefail

folder="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(dirname "$(dirname "$folder")")"
check=false
program=""
while [ $# -gt 0 ]; do
  case "$1" in
    --check) check=true ;;
    --program) program="${2:?--program needs a file}"; shift ;;
    *) echo "usage: make_method_figures.sh [--check] [--program FILE]" >&2; exit 2 ;;
  esac
  shift
done

if [ -z "$program" ]; then
  build="$root/build/figures"
  launcher=""
  if command -v ccache >/dev/null; then launcher=ccache; fi
  cmake -S "$root" -B "$build" -G Ninja --log-level=WARNING -DCMAKE_BUILD_TYPE=Release -DCROSSGRAIN_BUILD_FIGURES=ON \
    -DCROSSGRAIN_BUILD_TESTS=OFF -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" >/dev/null
  cmake --build "$build" --target method_figures
  program="$build/docs/figures/method/method_figures"
fi

made="$(mktemp -d)"
trap 'rm -rf "$made"' EXIT
"$program" "$made"
if ! "$check"; then
  cp "$made"/method-*.png "$folder/"
  exit
fi
status=0
for figure in "$made"/method-*.png; do
  cmp --silent "$figure" "$folder/${figure##*/}" && continue
  echo "docs/figures/${figure##*/} is not what the program draws: run docs/figures/make_method_figures.sh" >&2
  status=1
done
exit "$status"
