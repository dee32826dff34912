# SPDX-License-Identifier: Apache-2.0
# Debian packages by CPack, of a build with shared libraries for /usr (packaging/build.sh). Each is made of some
# install components; those that this build has not are left out, and so are packages without any.

set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME crossgrain)
set(CPACK_PACKAGE_VENDOR "The Crossgrain authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each has its own
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/debs")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CROSSGRAIN_PACKAGER "The Crossgrain authors <nobody@crossgrain.invalid>" CACHE STRING
    "Who answers for the packages; set it where they are handed on")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${CROSSGRAIN_PACKAGER}")
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "https://arxiv.org/abs/2309.13477")
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# Packages find each other's libraries here; they name each other below.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}" "${PROJECT_BINARY_DIR}/src/distributed/mpi")
set(CPACK_COMPONENTS_ALL "")

get_cmake_property(install_components COMPONENTS)
set(version_of_packages "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(library_package "libcrossgrain${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(same_library "${library_package} (= ${version_of_packages})")

# crossgrain_package(NAME SECTION section SUMMARY line TEXT lines COMPONENTS component... [DEPENDS a, b] [RECOMMENDS a]
#                    [SUGGESTS a] [ARCHITECTURE all] [COPYRIGHT_COMMENT line])
function(crossgrain_package name)
  cmake_parse_arguments(PACKAGE "" "SECTION;SUMMARY;TEXT;DEPENDS;RECOMMENDS;SUGGESTS;ARCHITECTURE;COPYRIGHT_COMMENT" "COMPONENTS"
                        ${ARGN})
  foreach(component IN LISTS PACKAGE_COMPONENTS)
    if(component IN_LIST install_components)
      list(APPEND present ${component})
    endif()
  endforeach()
  if(NOT present)
    return()
  endif()
  list(GET present 0 first)
  string(MAKE_C_IDENTIFIER "${name}" group)
  string(TOUPPER "${group}" GROUP)
  foreach(component IN LISTS present)
    string(TOUPPER "${component}" COMPONENT)
    set(CPACK_COMPONENT_${COMPONENT}_GROUP ${group} PARENT_SCOPE)
  endforeach()
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${present} PARENT_SCOPE)
  set(CPACK_DEBIAN_${GROUP}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${GROUP}_PACKAGE_SECTION ${PACKAGE_SECTION} PARENT_SCOPE)
  set(CPACK_DEBIAN_${GROUP}_DESCRIPTION "${PACKAGE_SUMMARY}\n${PACKAGE_TEXT}" PARENT_SCOPE)
  foreach(field DEPENDS RECOMMENDS SUGGESTS ARCHITECTURE)
    if(PACKAGE_${field})
      set(CPACK_DEBIAN_${GROUP}_PACKAGE_${field} "${PACKAGE_${field}}" PARENT_SCOPE)
    endif()
  endforeach()
  set(comment "${PACKAGE_COPYRIGHT_COMMENT}")
  if(NOT comment)
    set(comment "Nothing in this package is under the GPL.")
  endif()
  set(documents "${PROJECT_BINARY_DIR}/packages/${name}")
  configure_file("${PROJECT_SOURCE_DIR}/packaging/copyright" "${documents}/copyright" @ONLY)
  install(FILES "${documents}/copyright" DESTINATION "share/doc/${name}" COMPONENT ${first})
  # Debian wants a changelog that dpkg can read; the one for people is CHANGELOG.md.
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE "${documents}/changelog.Debian"
       "crossgrain (${version_of_packages}) unstable; urgency=medium\n\n  * Version ${PROJECT_VERSION}.\n\n -- "
       "${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}\n")
  execute_process(COMMAND gzip -9nf "${documents}/changelog.Debian" COMMAND_ERROR_IS_FATAL ANY)
  install(FILES "${documents}/changelog.Debian.gz" DESTINATION "share/doc/${name}" COMPONENT ${first})
endfunction()

set(what_it_is "Crossgrain computes octahedral frame fields inside solids: three
orthogonal directions at every point that vary smoothly and follow the
surface. Hexahedral meshing, lattice infill and anisotropic design need
them.")

crossgrain_package(
  ${library_package}
  SECTION libs
  SUMMARY "volumetric frame fields (shared libraries)"
  TEXT "${what_it_is}\n\nThis package has the shared libraries, with the C interface."
  COMPONENTS core hex files io meshing display page picture c
  RECOMMENDS crossgrain-cad)
crossgrain_package(
  libcrossgrain-dev
  SECTION libdevel
  SUMMARY "volumetric frame fields (development files)"
  TEXT "${what_it_is}\n\nThis package has the headers, files for CMake and pkg-config, and
examples."
  COMPONENTS development examples
  DEPENDS "${same_library}"
  SUGGESTS "cmake, pkg-config")
crossgrain_package(
  crossgrain
  SECTION science
  SUMMARY "volumetric frame fields (program)"
  TEXT "${what_it_is}\n\nThis package has the command line program, its man pages and
completions."
  COMPONENTS program
  DEPENDS "${same_library}, crossgrain-cad (= ${version_of_packages})"
  SUGGESTS "gmsh, crossgrain-netgen")
crossgrain_package(
  crossgrain-cad
  SECTION science
  SUMMARY "volumetric frame fields (reader of CAD files)"
  TEXT "${what_it_is}\n\nThis package has the program that reads STEP, IGES and BREP files for
the library. It uses OpenCASCADE."
  COMPONENTS cad
  COPYRIGHT_COMMENT "The program links OpenCASCADE, shared libraries of other packages under the LGPL-2.1 with an exception.")
crossgrain_package(
  crossgrain-netgen
  SECTION science
  SUMMARY "volumetric frame fields (tets by Netgen)"
  TEXT "${what_it_is}\n\nThis package has the program that cuts solids into tets with Netgen for
the library, besides or instead of gmsh."
  COMPONENTS netgen
  COPYRIGHT_COMMENT "The program links Netgen, shared libraries of another package under the LGPL-2.1.")
crossgrain_package(
  crossgrain-mpi
  SECTION science
  SUMMARY "volumetric frame fields (program for several machines)"
  TEXT "${what_it_is}\n\nThis package has the program that solves by several processes through
MPI, and its library."
  COMPONENTS processes
  DEPENDS "${same_library}, openmpi-bin"
  RECOMMENDS crossgrain
  COPYRIGHT_COMMENT "The program links Open MPI (BSD-3-clause) and no p4est; nothing in this package is under the GPL.")
crossgrain_package(
  python3-crossgrain
  SECTION python
  SUMMARY "volumetric frame fields (Python)"
  TEXT "${what_it_is}\n\nThis package has the Python module, which uses NumPy arrays."
  COMPONENTS python
  ARCHITECTURE all
  DEPENDS "${same_library}, python3, python3-numpy")

include(CPack)
