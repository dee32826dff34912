// SPDX-License-Identifier: Apache-2.0
#include "fuzz/reader_checks.hpp"

#include <array>

namespace crossgrain {
namespace {

// A new reader is a row here, a name in CMakeLists.txt and a list of inputs in made_inputs.cpp.
constexpr std::array kReaders = {
    ReaderUnderTest{"gzip", check_gzip},
    ReaderUnderTest{"zip", check_zip},
    ReaderUnderTest{"threemf", check_threemf},
    ReaderUnderTest{"freecad", check_freecad},
    ReaderUnderTest{"stl", check_stl},
    ReaderUnderTest{"obj", check_obj},
    ReaderUnderTest{"ply", check_ply},
    ReaderUnderTest{"off", check_off},
    ReaderUnderTest{"medit", check_medit},
    ReaderUnderTest{"medit_binary", check_medit_binary},
    ReaderUnderTest{"gmsh", check_gmsh},
    ReaderUnderTest{"vtk", check_vtk},
    ReaderUnderTest{"vtu", check_vtu},
    ReaderUnderTest{"hex_medit", check_hex_medit},
    ReaderUnderTest{"hex_gmsh", check_hex_gmsh},
    ReaderUnderTest{"hex_vtk", check_hex_vtk},
    ReaderUnderTest{"abaqus", check_abaqus},
    ReaderUnderTest{"vtu_data", check_vtu_data},
    ReaderUnderTest{"field", check_field},
    ReaderUnderTest{"field_arrays", check_field_arrays},
    ReaderUnderTest{"onto_arrays", check_onto_arrays},
    ReaderUnderTest{"repaired_arrays", check_repaired_arrays},
    ReaderUnderTest{"surface_arrays", check_surface_arrays},
    ReaderUnderTest{"singularity_arrays", check_singularity_arrays},
    ReaderUnderTest{"streamline_arrays", check_streamline_arrays},
    ReaderUnderTest{"hexahedron_arrays", check_hexahedron_arrays},
    ReaderUnderTest{"report", check_report},
    ReaderUnderTest{"points", check_points},
    ReaderUnderTest{"normals", check_normals},
    ReaderUnderTest{"constraints", check_constraints},
    ReaderUnderTest{"cad", check_cad},
    ReaderUnderTest{"cad_answer", check_cad_answer},
    ReaderUnderTest{"netgen_answer", check_netgen_answer},
    ReaderUnderTest{"hex_options", check_hex_options, true},
};

}  // namespace

std::span<const ReaderUnderTest> readers_under_test() {
  return kReaders;
}

}  // namespace crossgrain
