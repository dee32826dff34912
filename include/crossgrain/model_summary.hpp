// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup types Meshes and frames
/// @{

/// What is known of a model as soon as its file is read, before anything is mended or computed.
struct ModelSummary {
  /// Model units: of a CAD model exact, else of the vertices of triangles and tets; empty if there are none.
  Box bounding_box{};
  std::string unit = {}, file_unit = {};  ///< TriangleMesh::unit and file_unit
  std::size_t triangles = 0;              ///< of a surface; 0 for tets
  std::size_t tets = 0;                   ///< 0 for a surface
  std::size_t faces = 0;                  ///< that the triangles belong to; 0 if the file names none
  std::size_t solids = 0;                 ///< or regions of tets; 0 if the file names none
};

ModelSummary summary_of(const TriangleMesh& mesh);
ModelSummary summary_of(const TetMesh& mesh);

/// Returns the summary in words: "40 x 30 x 12 mm from 0 0 0; 24 faces, 1 solid".
std::string sentence_of(const ModelSummary& model);

/// @}

}  // namespace crossgrain
