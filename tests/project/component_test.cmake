# SPDX-License-Identifier: Apache-2.0
# Where METIS, Embree, libpng, zlib, meshoptimizer and nlohmann_json cannot be found, Crossgrain's core can be configured,
# installed from BUILD_DIR, found, linked and run.

file(REMOVE_RECURSE "${WORK_DIR}")
foreach(package METIS embree PNG ZLIB meshoptimizer nlohmann_json)
  list(APPEND hidden "-DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON")
endforeach()
set(compiler "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}")

execute_process(COMMAND ${CMAKE_COMMAND} -S "${SOURCE_DIR}" -B "${WORK_DIR}/configured" -G "${GENERATOR}" ${compiler} ${hidden}
                        -DCROSSGRAIN_COMPONENTS=core OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

foreach(component core development)  # the latter is of shared libraries; without them it is empty
  execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD_DIR}" --component ${component} --prefix "${WORK_DIR}/installed"
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -S "${CONSUMER_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}" ${compiler} ${hidden}
                        "-DCMAKE_PREFIX_PATH=${WORK_DIR}/installed" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build "${WORK_DIR}/build" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${WORK_DIR}/build/core_consumer" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL "crossgrain ${VERSION}\n")
  message(FATAL_ERROR "the consumer of the core printed '${output}', not the version ${VERSION}")
endif()
