# SPDX-License-Identifier: Apache-2.0
# OpenCASCADE as imported targets, without its own CMake config, which sets no include directory and prints to
# standard output:
#
#   OpenCascade::Modeling   shapes, triangles of them, booleans and fillets
#   OpenCascade::Cad        Modeling, and the readers and writers of STEP and IGES

set(modeling TKernel TKMath TKG2d TKG3d TKBRep TKGeomBase TKGeomAlgo TKTopAlgo TKPrim TKBO TKFillet TKOffset TKMesh
             TKShHealing)
set(exchange TKXSBase TKSTEPBase TKSTEPAttr TKSTEP209 TKSTEP TKIGES)

find_path(OpenCascadeLibraries_INCLUDE_DIR Standard_Version.hxx PATH_SUFFIXES opencascade)
set(needed OpenCascadeLibraries_INCLUDE_DIR)
foreach(name IN LISTS modeling exchange)
  find_library(OpenCascadeLibraries_${name} ${name})
  mark_as_advanced(OpenCascadeLibraries_${name})
  list(APPEND needed OpenCascadeLibraries_${name})
endforeach()
mark_as_advanced(OpenCascadeLibraries_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  OpenCascadeLibraries REQUIRED_VARS ${needed}
  REASON_FAILURE_MESSAGE "install libocct-data-exchange-dev and libocct-modeling-algorithms-dev")

if(OpenCascadeLibraries_FOUND AND NOT TARGET OpenCascade::Modeling)
  add_library(OpenCascade::Modeling INTERFACE IMPORTED)
  target_include_directories(OpenCascade::Modeling SYSTEM INTERFACE "${OpenCascadeLibraries_INCLUDE_DIR}")
  foreach(name IN LISTS modeling)
    target_link_libraries(OpenCascade::Modeling INTERFACE "${OpenCascadeLibraries_${name}}")
  endforeach()
  add_library(OpenCascade::Cad INTERFACE IMPORTED)
  target_link_libraries(OpenCascade::Cad INTERFACE OpenCascade::Modeling)
  foreach(name IN LISTS exchange)
    target_link_libraries(OpenCascade::Cad INTERFACE "${OpenCascadeLibraries_${name}}")
  endforeach()
endif()
