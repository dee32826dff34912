# SPDX-License-Identifier: Apache-2.0
# Where HIDDEN, packages that other components need, cannot be found, COMPONENT and those that it needs (COMPONENTS, with
# it) can be configured, installed from BUILD_DIR, found, linked and run: by the project in CONSUMER_DIR, whose program is
# COMPONENT_consumer, through CMake and through pkg-config. Lists have commas.

file(REMOVE_RECURSE "${WORK_DIR}")
string(REPLACE "," ";" components "${COMPONENTS}")
string(REPLACE "," ";" hidden "${HIDDEN}")
list(TRANSFORM hidden REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON")
set(compiler "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}")
set(prefix "${WORK_DIR}/installed")

string(REPLACE ";" "\\;" escaped_components "${components}")
execute_process(COMMAND ${CMAKE_COMMAND} -S "${SOURCE_DIR}" -B "${WORK_DIR}/configured" -G "${GENERATOR}" ${compiler} ${hidden}
                        "-DCROSSGRAIN_COMPONENTS=${escaped_components}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

foreach(component IN LISTS components ITEMS development)  # the latter is of shared libraries; without them it is empty
  execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD_DIR}" --component ${component} --prefix "${prefix}"
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()

function(check_output program)
  execute_process(COMMAND "${program}" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  if(NOT output STREQUAL "crossgrain ${VERSION}\n")
    message(FATAL_ERROR "${program} printed '${output}', not the version ${VERSION}")
  endif()
endfunction()

execute_process(COMMAND ${CMAKE_COMMAND} -S "${CONSUMER_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}" ${compiler} ${hidden}
                        "-DCMAKE_PREFIX_PATH=${prefix}" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build "${WORK_DIR}/build" COMMAND_ERROR_IS_FATAL ANY)
check_output("${WORK_DIR}/build/${COMPONENT}_consumer")

file(GLOB_RECURSE module "${prefix}/crossgrain-${COMPONENT}.pc")
cmake_path(GET module PARENT_PATH modules_dir)
set(ENV{PKG_CONFIG_PATH} "${modules_dir}")
set(ENV{LD_LIBRARY_PATH} "${modules_dir}/..")  # of shared libraries; static ones need none
execute_process(COMMAND pkg-config --cflags --libs crossgrain-${COMPONENT} OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags} ${CXX_FLAGS}")
execute_process(COMMAND "${CXX_COMPILER}" -std=c++20 "${CONSUMER_DIR}/main.cpp" -o "${WORK_DIR}/build/consumer_of_module" ${flags}
                COMMAND_ERROR_IS_FATAL ANY)
check_output("${WORK_DIR}/build/consumer_of_module")
