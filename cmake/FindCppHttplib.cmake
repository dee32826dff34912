# SPDX-License-Identifier: Apache-2.0
# cpp-httplib as the compiled library that Debian makes of it, as the imported target CppHttplib::CppHttplib. It
# has no CMake config, and its classes are laid out by what it was built with: what its pkg-config file says.

find_path(CppHttplib_INCLUDE_DIR httplib.h)
find_library(CppHttplib_LIBRARY cpp-httplib)
mark_as_advanced(CppHttplib_INCLUDE_DIR CppHttplib_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CppHttplib REQUIRED_VARS CppHttplib_LIBRARY CppHttplib_INCLUDE_DIR
                                  REASON_FAILURE_MESSAGE "install libcpp-httplib-dev")

if(CppHttplib_FOUND AND NOT TARGET CppHttplib::CppHttplib)
  add_library(CppHttplib::CppHttplib UNKNOWN IMPORTED)
  set_target_properties(
    CppHttplib::CppHttplib
    PROPERTIES IMPORTED_LOCATION "${CppHttplib_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${CppHttplib_INCLUDE_DIR}"
               INTERFACE_COMPILE_DEFINITIONS
               "CPPHTTPLIB_OPENSSL_SUPPORT;CPPHTTPLIB_ZLIB_SUPPORT;CPPHTTPLIB_BROTLI_SUPPORT")
endif()
