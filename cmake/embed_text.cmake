# SPDX-License-Identifier: Apache-2.0
# Writes a source with the text of a file in it:
#   cmake -DFILE=... -DSOURCE=... -DHEADER=... -DFUNCTION=... -P embed_text.cmake
# Compilers take literals of limited length: many short ones stand one after the other.

file(READ "${FILE}" hex HEX)
string(LENGTH "${hex}" length)
math(EXPR size "${length} / 2")
string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
file(WRITE "${SOURCE}" "// Made by cmake/embed_text.cmake.
#include \"${HEADER}\"

namespace crossgrain {
namespace {

constexpr unsigned char kBytes[] = {
${bytes}};

}  // namespace

std::string_view ${FUNCTION}() {
  return {reinterpret_cast<const char*>(kBytes), ${size}};
}

}  // namespace crossgrain
")
