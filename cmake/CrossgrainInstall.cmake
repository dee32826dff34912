# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts under a prefix: the library, the public headers, the program, and the package
# that makes `find_package(crossgrain)` give the target crossgrain::crossgrain.

include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/crossgrain")

install(TARGETS crossgrain EXPORT crossgrainTargets)
if(TARGET crossgrain_app)
  set_target_properties(crossgrain_app PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS crossgrain_app)
  install(TARGETS crossgrain_view RUNTIME DESTINATION "${CROSSGRAIN_HELPER_FOLDER}")
endif()
if(TARGET crossgrain_cad)
  install(TARGETS crossgrain_cad RUNTIME DESTINATION "${CROSSGRAIN_HELPER_FOLDER}")
  # A program with the static library in it may stand anywhere; its linker notes down where the helper is, and
  # the library asks for that (io/cad/cad_program.cpp).
  if(NOT BUILD_SHARED_LIBS)
    target_link_options(crossgrain INTERFACE
                        "$<INSTALL_INTERFACE:LINKER:-rpath,$<INSTALL_PREFIX>/${CROSSGRAIN_HELPER_FOLDER}>")
  endif()
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/crossgrain" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(FILES "${PROJECT_BINARY_DIR}/include/crossgrain/version.hpp"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/crossgrain")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/NOTICE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

install(EXPORT crossgrainTargets NAMESPACE crossgrain:: DESTINATION "${package_dir}")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/crossgrain-config.cmake.in"
                              "${PROJECT_BINARY_DIR}/crossgrain-config.cmake" INSTALL_DESTINATION "${package_dir}")
# Before 1.0 a new minor version may break what was there.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/crossgrain-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/crossgrain-config.cmake" "${PROJECT_BINARY_DIR}/crossgrain-config-version.cmake"
        DESTINATION "${package_dir}")
