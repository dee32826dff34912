# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts under a prefix: the libraries, the public headers, the program, and the package that
# makes `find_package(crossgrain COMPONENTS core)` give the target crossgrain::core. Each library is an install
# component of its own name, and an export of its own, so that core can be found where what others need is missing.

include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/crossgrain")
get_property(built_components GLOBAL PROPERTY CROSSGRAIN_BUILT_COMPONENTS)

foreach(component IN LISTS built_components)
  install(TARGETS crossgrain-${component} EXPORT crossgrain-${component} COMPONENT ${component})
  install(EXPORT crossgrain-${component} NAMESPACE crossgrain:: FILE crossgrain-${component}.cmake DESTINATION "${package_dir}"
          COMPONENT ${component})
endforeach()
if(TARGET crossgrain_app)
  set_target_properties(crossgrain_app PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS crossgrain_app)
  install(TARGETS crossgrain_view RUNTIME DESTINATION "${CROSSGRAIN_HELPER_FOLDER}")
endif()
if(TARGET crossgrain_mpi)
  set_target_properties(crossgrain_mpi PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS crossgrain_mpi)
endif()
if(TARGET crossgrain_cad)
  install(TARGETS crossgrain_cad RUNTIME DESTINATION "${CROSSGRAIN_HELPER_FOLDER}")
  # A program with the static library in it may stand anywhere; its linker notes down where the helper is, and
  # the library asks for that (io/cad/cad_program.cpp).
  if(NOT BUILD_SHARED_LIBS)
    target_link_options(crossgrain-io INTERFACE
                        "$<INSTALL_INTERFACE:LINKER:-rpath,$<INSTALL_PREFIX>/${CROSSGRAIN_HELPER_FOLDER}>")
  endif()
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/crossgrain" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT core)
install(FILES "${PROJECT_BINARY_DIR}/include/crossgrain/version.hpp"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/crossgrain" COMPONENT core)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/NOTICE" DESTINATION "${CMAKE_INSTALL_DOCDIR}"
        COMPONENT core)

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/crossgrain-config.cmake.in"
                              "${PROJECT_BINARY_DIR}/crossgrain-config.cmake" INSTALL_DESTINATION "${package_dir}")
# Before 1.0 a new minor version may break what was there.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/crossgrain-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/crossgrain-config.cmake" "${PROJECT_BINARY_DIR}/crossgrain-config-version.cmake"
        DESTINATION "${package_dir}" COMPONENT core)
