# SPDX-License-Identifier: Apache-2.0
# Installs BUILD_DIR below a fresh WORK_DIR, moves the prefix to show that nothing in it remembers where it was,
# and builds and runs the project in CONSUMER_DIR against it, through CMake and through pkg-config.

file(REMOVE_RECURSE "${WORK_DIR}")
set(prefix "${WORK_DIR}/moved")

execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD_DIR}" --prefix "${WORK_DIR}/installed"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${WORK_DIR}/installed" "${prefix}")

execute_process(
  COMMAND ${CMAKE_COMMAND} -S "${CONSUMER_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
          "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
          "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build "${WORK_DIR}/build" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${WORK_DIR}/build/consumer" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE modules "${prefix}/*.pc")
list(LENGTH modules count)
if(count LESS 6)
  message(FATAL_ERROR "only these files for pkg-config were installed: ${modules}")
endif()
list(GET modules 0 module)
cmake_path(GET module PARENT_PATH modules_dir)
set(ENV{PKG_CONFIG_PATH} "${modules_dir}")
set(ENV{LD_LIBRARY_PATH} "${modules_dir}/..")  # of shared libraries; static ones need none
foreach(module IN LISTS modules)
  execute_process(COMMAND pkg-config --validate "${module}" COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND pkg-config --cflags --libs crossgrain OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags} ${CXX_FLAGS}")
execute_process(COMMAND "${CXX_COMPILER}" -std=c++20 "${CONSUMER_DIR}/main.cpp" -o "${WORK_DIR}/build/consumer_of_modules" ${flags}
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${WORK_DIR}/build/consumer_of_modules" OUTPUT_VARIABLE output_of_modules COMMAND_ERROR_IS_FATAL ANY)
if(NOT output_of_modules STREQUAL output)
  message(FATAL_ERROR "the consumer built through pkg-config printed '${output_of_modules}', not '${output}'")
endif()

if(NOT output STREQUAL "crossgrain ${VERSION}\n")
  message(FATAL_ERROR "the consumer printed '${output}', not the version that was installed, ${VERSION}")
endif()

execute_process(COMMAND "${WORK_DIR}/build/consumer_in_c" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL "crossgrain ${VERSION}\n")
  message(FATAL_ERROR "the consumer in C printed '${output}', not the version that was installed, ${VERSION}")
endif()

if(PROGRAM)
  file(GLOB program "${prefix}/bin/crossgrain")
  if(NOT program)
    message(FATAL_ERROR "the program was not installed below ${prefix}/bin")
  endif()
endif()

if(MPI AND NOT EXISTS "${prefix}/bin/crossgrain-mpi")
  message(FATAL_ERROR "the program for several processes was not installed below ${prefix}/bin")
endif()

# The program that reads CAD files is found from wherever the consumer was built, and says of what it cannot read.
if(CAD)
  file(WRITE "${WORK_DIR}/damaged.brep" "DBRep_DrawableShape\n\nCASCADE Topology V1\nnonsense\n*\n+1 0\n")
  foreach(consumer consumer consumer_in_c consumer_of_modules)
    execute_process(COMMAND "${WORK_DIR}/build/${consumer}" "${WORK_DIR}/damaged.brep" OUTPUT_VARIABLE output
                    COMMAND_ERROR_IS_FATAL ANY)
    if(NOT output MATCHES "damaged, or not a BREP file")
      message(FATAL_ERROR "${consumer} did not find the program that reads CAD files: ${output}")
    endif()
  endforeach()
endif()
