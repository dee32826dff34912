# SPDX-License-Identifier: Apache-2.0
# Finds Netgen's library (Debian: libnglib-dev), which stands in a folder of its own: Nglib_LIBRARY_DIR.
#
#   Nglib::nglib

find_path(Nglib_INCLUDE_DIR nglib.h PATH_SUFFIXES netgen)
find_library(Nglib_LIBRARY nglib PATH_SUFFIXES netgen)
mark_as_advanced(Nglib_INCLUDE_DIR Nglib_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Nglib REQUIRED_VARS Nglib_LIBRARY Nglib_INCLUDE_DIR)

if(Nglib_FOUND)
  get_filename_component(Nglib_LIBRARY_DIR "${Nglib_LIBRARY}" DIRECTORY)
  if(NOT TARGET Nglib::nglib)
    add_library(Nglib::nglib INTERFACE IMPORTED)
    target_include_directories(Nglib::nglib SYSTEM INTERFACE "${Nglib_INCLUDE_DIR}")
    target_link_libraries(Nglib::nglib INTERFACE "${Nglib_LIBRARY}")
  endif()
endif()
