# SPDX-License-Identifier: Apache-2.0
# Files for pkg-config: crossgrain-core.pc and so on, one a component, and crossgrain.pc for all but `processes`
# and `c`.

# What pkg-config calls the libraries that components link; what begins with - or / is for the linker.
set(pkg_config_of_TBB::tbb tbb)
set(pkg_config_of_fmt::fmt fmt)
set(pkg_config_of_Scotch::scotch -lscotch -lscotcherr)
set(pkg_config_of_ZLIB::ZLIB zlib)
set(pkg_config_of_PkgConfig::libdeflate libdeflate)
set(pkg_config_of_PkgConfig::minizip minizip)
set(pkg_config_of_EXPAT::EXPAT expat)
set(pkg_config_of_PNG::PNG libpng)
set(pkg_config_of_Threads::Threads -pthread)
set(pkg_config_of_meshoptimizer::meshoptimizer -lmeshoptimizer)
set(pkg_config_of_embree -lembree3)
set(pkg_config_of_MPI::MPI_CXX ${MPI_CXX_LIBRARIES})
foreach(library IN LISTS CMAKE_DL_LIBS)
  set(pkg_config_of_${library} -l${library})
endforeach()

# crossgrain_pkg_config(NAME COMPONENT install-component DESCRIPTION text [REQUIRES module...] [LINKS flag...]
#                       [LIBRARIES library...]): writes and installs NAME.pc. LIBRARIES are as for crossgrain_component.
function(crossgrain_pkg_config name)
  cmake_parse_arguments(PC "" "COMPONENT;DESCRIPTION" "REQUIRES;LINKS;LIBRARIES" ${ARGN})
  # A static library leaves the linking of what it uses to its user; a shared one has it inside.
  if(NOT BUILD_SHARED_LIBS)
    foreach(library IN LISTS PC_LIBRARIES)
      if(NOT DEFINED pkg_config_of_${library})
        message(FATAL_ERROR "cmake/CrossgrainPkgConfig.cmake does not say what pkg-config calls ${library}")
      endif()
      foreach(word IN LISTS pkg_config_of_${library})
        if(word MATCHES "^[-/]")
          list(APPEND PC_LINKS "${word}")
        else()
          list(APPEND PC_REQUIRES "${word}")
        endif()
      endforeach()
    endforeach()
  endif()
  list(JOIN PC_REQUIRES " " requires)
  list(JOIN PC_LINKS " " links)
  set(fields "")
  if(requires)
    string(APPEND fields "Requires: ${requires}\n")
  endif()
  if(links)
    string(APPEND fields "Libs: ${links}\n")
  endif()
  # From its own place, so that the installed tree may be moved.
  file(RELATIVE_PATH up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  string(REGEX REPLACE "/$" "" up "${up}")
  file(WRITE "${PROJECT_BINARY_DIR}/pkgconfig/${name}.pc"
       "prefix=\${pcfiledir}/${up}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}

Name: ${name}
Description: ${PC_DESCRIPTION}
Version: ${PROJECT_VERSION}
${fields}Cflags: -I\${includedir}
")
  install(FILES "${PROJECT_BINARY_DIR}/pkgconfig/${name}.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
          COMPONENT ${PC_COMPONENT})
endfunction()

set(description_of_core "Volumetric frame fields: meshes in, fields out (C++20)")
set(description_of_display "What pages and pictures show of fields of Crossgrain (C++20)")
set(description_of_files "Files of Crossgrain as bytes (C++20)")
set(description_of_hex "Hexahedra along frame fields of Crossgrain (C++20)")
set(description_of_io "Reading models, writing fields of Crossgrain (C++20)")
set(description_of_meshing "Models to hexahedra with Crossgrain (C++20)")
set(description_of_page "Pages that show fields of Crossgrain in a browser (C++20)")
set(description_of_picture "Pictures of fields of Crossgrain (C++20)")
set(description_of_processes "Crossgrain by several processes, through MPI (C++20)")
set(description_of_c "C interface of Crossgrain")

foreach(component IN LISTS built_components)
  get_property(needed GLOBAL PROPERTY CROSSGRAIN_COMPONENTS_OF_${component})
  get_property(libraries GLOBAL PROPERTY CROSSGRAIN_LIBRARIES_OF_${component})
  set(links "-L\${libdir}" "-lcrossgrain-${component}")
  if(component STREQUAL "io" AND TARGET crossgrain_cad AND NOT BUILD_SHARED_LIBS)
    list(APPEND links "-Wl,-rpath,\${prefix}/${CROSSGRAIN_HELPER_FOLDER}")
  endif()
  crossgrain_pkg_config(crossgrain-${component} COMPONENT ${development_of_${component}}
                        DESCRIPTION "${description_of_${component}}" REQUIRES ${needed} LINKS ${links} LIBRARIES ${libraries})
endforeach()
list(TRANSFORM built_components PREPEND "crossgrain-" OUTPUT_VARIABLE all)
list(REMOVE_ITEM all crossgrain-processes crossgrain-c)
crossgrain_pkg_config(crossgrain COMPONENT ${development_of_core} DESCRIPTION "Volumetric octahedral frame fields (C++20)" REQUIRES ${all})
