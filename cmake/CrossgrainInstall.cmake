# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts under a prefix: libraries, public headers, programs with man pages and completions, and
# the packages for CMake and pkg-config. Each library has an export of its own, so that `find_package(crossgrain
# COMPONENTS core)` works where what others need is missing.
#
# Install components: a library's own name, `program`, `cad`, `netgen`, `processes` (library and program), `examples`. What is
# only for compiling belongs to the library if that is static, and to `development` if it is shared; `processes` has
# its own. LICENSE and NOTICE likewise are of `core` or of `licence`.

include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/crossgrain")
get_property(built_components GLOBAL PROPERTY CROSSGRAIN_BUILT_COMPONENTS)

foreach(component IN LISTS built_components)
  set(development_of_${component} ${component})
  if(BUILD_SHARED_LIBS AND NOT component STREQUAL "processes")
    set(development_of_${component} development)
  endif()
  install(TARGETS crossgrain-${component} EXPORT crossgrain-${component}
          ARCHIVE COMPONENT ${component}
          LIBRARY COMPONENT ${component} NAMELINK_COMPONENT ${development_of_${component}})
  install(EXPORT crossgrain-${component} NAMESPACE crossgrain:: FILE crossgrain-${component}.cmake DESTINATION "${package_dir}"
          COMPONENT ${development_of_${component}})
  set_target_properties(crossgrain-${component} PROPERTIES INSTALL_RPATH "$ORIGIN")
endforeach()
include(CrossgrainPkgConfig)

if(TARGET crossgrain_app)
  set_target_properties(crossgrain_app PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS crossgrain_app COMPONENT program)
  install(TARGETS crossgrain_view RUNTIME DESTINATION "${CROSSGRAIN_HELPER_FOLDER}" COMPONENT program)
endif()
if(TARGET crossgrain_mpi)
  set_target_properties(crossgrain_mpi PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS crossgrain_mpi COMPONENT processes)
endif()
if(TARGET crossgrain_cad)
  install(TARGETS crossgrain_cad RUNTIME DESTINATION "${CROSSGRAIN_HELPER_FOLDER}" COMPONENT cad)
  # A program with the static library in it may stand anywhere; its linker notes down where the helper is, and
  # the library asks for that (process/helper_program.hpp).
  if(NOT BUILD_SHARED_LIBS)
    target_link_options(crossgrain-io INTERFACE
                        "$<INSTALL_INTERFACE:LINKER:-rpath,$<INSTALL_PREFIX>/${CROSSGRAIN_HELPER_FOLDER}>")
  endif()
endif()

if(TARGET crossgrain_netgen)
  install(TARGETS crossgrain_netgen RUNTIME DESTINATION "${CROSSGRAIN_HELPER_FOLDER}" COMPONENT netgen)
endif()

# Man pages and completions of a program, made by the build (apps/crossgrain/documents).
set(CROSSGRAIN_ZSH_FOLDER "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" CACHE STRING "Where zsh looks for completions")
function(crossgrain_install_documents program component)
  install(FILES "${CROSSGRAIN_DOCUMENTS}/bash/${program}" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
          COMPONENT ${component})
  install(FILES "${CROSSGRAIN_DOCUMENTS}/zsh/_${program}" DESTINATION "${CROSSGRAIN_ZSH_FOLDER}" COMPONENT ${component})
  install(FILES "${CROSSGRAIN_DOCUMENTS}/fish/${program}.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d"
          COMPONENT ${component})
endfunction()
if(TARGET crossgrain_app)
  crossgrain_install_documents(crossgrain program)
  install(DIRECTORY "${CROSSGRAIN_DOCUMENTS}/man/" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program
          PATTERN "crossgrain-mpi.1.gz" EXCLUDE)
endif()
if(TARGET crossgrain_mpi)
  crossgrain_install_documents(crossgrain-mpi processes)
  install(FILES "${CROSSGRAIN_DOCUMENTS}/man/crossgrain-mpi.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT processes)
endif()

install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/crossgrain" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
        COMPONENT ${development_of_core})
install(FILES "${PROJECT_BINARY_DIR}/include/crossgrain/version.h" "${PROJECT_BINARY_DIR}/include/crossgrain/version.hpp"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/crossgrain" COMPONENT ${development_of_core})
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/NOTICE" DESTINATION "${CMAKE_INSTALL_DOCDIR}"
        COMPONENT $<IF:$<BOOL:${BUILD_SHARED_LIBS}>,licence,core>)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples/" DESTINATION "${CMAKE_INSTALL_DATADIR}/crossgrain/examples"
        COMPONENT examples PATTERN __pycache__ EXCLUDE)

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/crossgrain-config.cmake.in"
                              "${PROJECT_BINARY_DIR}/crossgrain-config.cmake" INSTALL_DESTINATION "${package_dir}")
# Before 1.0 a new minor version may break what was there.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/crossgrain-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
# Only users of the static library link SCOTCH themselves.
if(TARGET crossgrain-hex AND NOT BUILD_SHARED_LIBS)
  install(FILES "${PROJECT_SOURCE_DIR}/cmake/FindScotch.cmake" DESTINATION "${package_dir}" COMPONENT hex)
endif()
install(FILES "${PROJECT_BINARY_DIR}/crossgrain-config.cmake" "${PROJECT_BINARY_DIR}/crossgrain-config-version.cmake"
        DESTINATION "${package_dir}" COMPONENT ${development_of_core})
