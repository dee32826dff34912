# SPDX-License-Identifier: Apache-2.0
# Builds the bytes of a file, text or binary, into the library:
#
#   crossgrain_embed(VARIABLE FILE path HEADER path FUNCTION name)
#
# sets VARIABLE to a source that defines `std::string_view name()`, which HEADER declares.
#
# Every C++ compiler takes a string literal, which .incbin of the assembler is not, and it compiles in a third of a
# second a megabyte; an array of numbers takes two seconds.

function(crossgrain_embed variable)
  cmake_parse_arguments(EMBED "" "FILE;HEADER;FUNCTION" "" ${ARGN})
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${EMBED_FUNCTION}.cpp")
  set(script "${CMAKE_CURRENT_FUNCTION_LIST_FILE}")
  add_custom_command(
    OUTPUT "${source}"
    COMMAND "${CMAKE_COMMAND}" "-DFILE=${EMBED_FILE}" "-DSOURCE=${source}" "-DHEADER=${EMBED_HEADER}"
            "-DFUNCTION=${EMBED_FUNCTION}" -P "${script}"
    DEPENDS "${EMBED_FILE}" "${script}"
    VERBATIM)
  set(${variable} "${source}" PARENT_SCOPE)
endfunction()

# The same file is the script that writes the source.
if(CMAKE_SCRIPT_MODE_FILE)
  file(READ "${FILE}" bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
  string(REGEX REPLACE "(................................................................)" "\"\\1\"\n" bytes "${bytes}")
  string(REGEX REPLACE "(\n|^)([^\"\n]+)$" "\\1\"\\2\"" bytes "${bytes}")
  file(WRITE "${SOURCE}" "// Made by cmake/CrossgrainEmbed.cmake.
#include \"${HEADER}\"

#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace crossgrain {
namespace {

constexpr char kBytes[] =
${bytes};

}  // namespace

std::string_view ${FUNCTION}() {
  return {kBytes, sizeof kBytes - 1};
}

}  // namespace crossgrain
")
endif()
