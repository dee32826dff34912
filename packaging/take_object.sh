#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A compiler launcher of CMake: copies the object from another build folder of the same sources, if it is there,
# instead of compiling it. Usage: take_object.sh BUILD COMPILER ARGUMENT... -o OBJECT -c SOURCE
set -euo pipefail

build="$1"
shift
words=("$@")
for ((i = 0; i < ${#words[@]}; i++)); do
  if [ "${words[i]}" = -o ] && [ -f "$build/${words[i + 1]}" ]; then
    exec cp "$build/${words[i + 1]}" "${words[i + 1]}"
  fi
done
exec "$@"
