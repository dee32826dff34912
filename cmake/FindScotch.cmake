# SPDX-License-Identifier: Apache-2.0
# Finds SCOTCH 7 with indices of 32 bits (Debian: libscotch-dev), which brings no files for CMake there. Installed too, for
# users of the static library.
#
#   Scotch::scotch

find_path(Scotch_INCLUDE_DIR scotch.h PATH_SUFFIXES scotch-int32 scotch)
find_library(Scotch_LIBRARY scotch)
find_library(Scotch_ERROR_LIBRARY scotcherr)
mark_as_advanced(Scotch_INCLUDE_DIR Scotch_LIBRARY Scotch_ERROR_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Scotch REQUIRED_VARS Scotch_LIBRARY Scotch_ERROR_LIBRARY Scotch_INCLUDE_DIR)

if(Scotch_FOUND AND NOT TARGET Scotch::scotch)
  add_library(Scotch::scotch INTERFACE IMPORTED)
  target_include_directories(Scotch::scotch SYSTEM INTERFACE "${Scotch_INCLUDE_DIR}")
  target_link_libraries(Scotch::scotch INTERFACE "${Scotch_LIBRARY}" "${Scotch_ERROR_LIBRARY}")
endif()
