# SPDX-License-Identifier: Apache-2.0
# Prints the values of a JSON file at the dotted PATHS, one a line, "nan" where there is none; an index of -1 is
# the last element. For shell scripts on systems where CMake is all there is:
#   cmake -DFILE=report.json "-DPATHS=energy.total;levels.-1.cells" -P json_values.cmake

file(READ "${FILE}" json)
set(values "")
foreach(path IN LISTS PATHS)
  string(REPLACE "." ";" keys "${path}")
  list(FIND keys -1 position)
  if(position GREATER 0)
    list(SUBLIST keys 0 ${position} array)
    string(JSON length ERROR_VARIABLE error LENGTH "${json}" ${array})
    if(length GREATER 0)
      math(EXPR last "${length} - 1")
      list(TRANSFORM keys REPLACE "^-1$" ${last})
    endif()
  endif()
  string(JSON value ERROR_VARIABLE error GET "${json}" ${keys})
  if(NOT error STREQUAL "NOTFOUND")
    set(value "nan")
  endif()
  string(APPEND values "${value}\n")
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -E echo_append "${values}")
