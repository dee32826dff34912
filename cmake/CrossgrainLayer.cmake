# SPDX-License-Identifier: Apache-2.0
# A layer is a folder of src/ built as an object library that links the layers below it only; a component is a
# library that users link, of one or more layers. `cmake/check_layers.py` holds includes to the same order.

set_property(GLOBAL PROPERTY CROSSGRAIN_LAYERS "")

function(crossgrain_compile_settings target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                                           $<$<BOOL:${CROSSGRAIN_WARNINGS_AS_ERRORS}>:-Werror>)
  # The same bits on every machine: no contraction of a*b+c that depends on the instruction set.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  # Nobody reads errno or catches floating-point traps; without them roots are one instruction.
  target_compile_options(${target} PRIVATE -fno-math-errno -fno-trapping-math)
  # Sources of one unit are included by it, so that g++ takes their anonymous namespaces for those of a header.
  target_compile_options(${target} PRIVATE $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-subobject-linkage>)
  target_compile_definitions(${target} PRIVATE $<$<BOOL:${CROSSGRAIN_STD_THREADS}>:CROSSGRAIN_STD_THREADS>)
endfunction()

# crossgrain_layer(NAME SOURCES ... [LIBRARIES ...])
function(crossgrain_layer name)
  cmake_parse_arguments(LAYER "" "" "SOURCES;LIBRARIES" ${ARGN})
  if(NOT LAYER_SOURCES)
    return()
  endif()
  add_library(crossgrain_${name} OBJECT ${LAYER_SOURCES})
  crossgrain_compile_settings(crossgrain_${name})
  set_target_properties(crossgrain_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(
    crossgrain_${name} PUBLIC "${PROJECT_SOURCE_DIR}/include" "${PROJECT_SOURCE_DIR}/src"
                              "${PROJECT_BINARY_DIR}/include")
  target_link_libraries(crossgrain_${name} PUBLIC ${LAYER_LIBRARIES})
  set_property(GLOBAL APPEND PROPERTY CROSSGRAIN_LAYERS ${name})
endfunction()

# crossgrain_component(NAME LAYERS ... [COMPONENTS ...] [LIBRARIES ...]): the library crossgrain::NAME that users
# link: the objects of some layers, each a folder of src/. COMPONENTS are those whose symbols it uses.
function(crossgrain_component name)
  cmake_parse_arguments(COMPONENT "" "" "LAYERS;COMPONENTS;LIBRARIES" ${ARGN})
  set(target "crossgrain-${name}")
  add_library(${target})
  add_library(crossgrain::${name} ALIAS ${target})
  crossgrain_compile_settings(${target})
  foreach(layer IN LISTS COMPONENT_LAYERS)
    if(NOT TARGET crossgrain_${layer})
      add_subdirectory("${PROJECT_SOURCE_DIR}/src/${layer}")
    endif()
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:crossgrain_${layer}>)
  endforeach()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION}
                                             SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                              $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  list(TRANSFORM COMPONENT_COMPONENTS PREPEND "crossgrain-")
  target_link_libraries(${target} PUBLIC ${COMPONENT_COMPONENTS} PRIVATE ${COMPONENT_LIBRARIES})
  set_property(GLOBAL APPEND PROPERTY CROSSGRAIN_BUILT_COMPONENTS ${name})
  set_property(GLOBAL PROPERTY CROSSGRAIN_COMPONENTS_OF_${name} ${COMPONENT_COMPONENTS})
  set_property(GLOBAL PROPERTY CROSSGRAIN_LIBRARIES_OF_${name} ${COMPONENT_LIBRARIES})
endfunction()

# crossgrain_gtests(TARGET [SLOW pattern...]): every suite of a program as a test of ctest, named after both. Tests whose names match a pattern
# of Google Test (Suite.*, *.Name) get the label "slow", those of a suite together; `ctest -LE slow` runs the others.
function(crossgrain_gtests target)
  cmake_parse_arguments(GTESTS "" "" "SLOW" ${ARGN})
  list(JOIN GTESTS_SLOW ":" slow)
  string(REGEX REPLACE "^crossgrain_|_tests$" "" name "${target}")
  set(suites "${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake")
  add_custom_command(
    TARGET ${target} POST_BUILD
    COMMAND /usr/bin/python3 "${PROJECT_SOURCE_DIR}/cmake/discover_suites.py" $<TARGET_FILE:${target}> ${name} "${suites}" "${slow}"
    BYPRODUCTS "${suites}" VERBATIM)
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake"
       "if(EXISTS \"${suites}\")\n  include(\"${suites}\")\nelse()\n  add_test(${name}.not_built ${target}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake")
endfunction()

# crossgrain_layer_test(NAME SOURCES ... [SLOW pattern...]): one test program for a layer, linked with it and those below.
function(crossgrain_layer_test name)
  cmake_parse_arguments(TEST "" "" "SOURCES;SLOW" ${ARGN})
  get_property(layers GLOBAL PROPERTY CROSSGRAIN_LAYERS)
  add_executable(crossgrain_${name}_tests ${TEST_SOURCES})
  crossgrain_compile_settings(crossgrain_${name}_tests)
  target_include_directories(crossgrain_${name}_tests PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  foreach(layer IN LISTS layers)
    target_link_libraries(crossgrain_${name}_tests PRIVATE crossgrain_${layer})
    if(layer STREQUAL name)
      break()
    endif()
  endforeach()
  target_link_libraries(crossgrain_${name}_tests PRIVATE crossgrain_test_support GTest::gtest_main)
  crossgrain_gtests(crossgrain_${name}_tests SLOW ${TEST_SLOW})
endfunction()
