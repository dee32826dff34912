// SPDX-License-Identifier: Apache-2.0
// Writers of hexahedra, one for each format.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/writing.hpp"
#include "files/output_file.hpp"
#include "mesh_files/hex/hex_groups.hpp"

namespace crossgrain {

/// A valid mesh with what its files tell of it.
struct HexOutput {
  /// Throws Error(kUsage) if the mesh contradicts itself.
  explicit HexOutput(const HexMesh& mesh);

  /// What files of text say of their content.
  std::string_view content() const {
    if (mesh.is_partial)
      return has_inverted ? "partial: these hexahedra are not the whole model, and some are inverted"
                          : "partial: these hexahedra are not the whole model";
    return has_inverted ? "some of these hexahedra are inverted"
                        : "hexahedra with numbers of regions and faces";
  }

  const HexMesh& mesh;
  bool has_inverted;
  std::vector<BoundarySide> sides;  ///< of HexMesh::boundary
  HexGroups groups;
};

/// Which files a folder has of hexahedra.
struct HexFilesOf {
  bool is_partial = false;  ///< HexMesh::is_partial
  bool for_display_only = false;
  bool is_empty = false;  ///< without hexahedra there are no files
};

/// Those of a mesh.
HexFilesOf hex_files_of(const HexMesh& mesh, InvertedHexahedra inverted);

/// hexahedra.vtu and so on: the files of hexahedra in the folder of a field, each of one format.
std::vector<std::string> hexahedra_file_names(HexFilesOf which);

/// All that a folder may have.
std::vector<std::string> all_hexahedra_file_names();

/// Writes one of them to a file of its name.
void write_hexahedra_file(OutputFile& file, const HexOutput& output, const Monitor& monitor);

/// Points, hexahedra with their scaled Jacobian and region, in VTK's XML.
void write_vtu_hexahedra(OutputFile& file, const HexOutput& output, const Monitor& monitor);

/// Medit in text: the boundary with its tags, the hexahedra with their regions.
void write_medit_hexahedra(OutputFile& file, const HexOutput& output, const Monitor& monitor);

/// Gmsh 4.1 in text: an entity and a physical group for each tag of faces and for each region.
void write_gmsh_hexahedra(OutputFile& file, const HexOutput& output, const Monitor& monitor);

/// Abaqus and CalculiX: nodes, elements, sets of both, and surfaces of faces of elements.
void write_abaqus_hexahedra(OutputFile& file, const HexOutput& output, const Monitor& monitor);

}  // namespace crossgrain
