// SPDX-License-Identifier: Apache-2.0
// What no hexahedra can have, in words for whoever changes the part.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/field_analysis.hpp"

namespace crossgrain {

/// What the parts of a surface are called that have numbers.
struct FaceNoun {
  const char* one;
  const char* several;
};

inline constexpr FaceNoun kFaceNoun{"face", "faces"}, kPatchNoun{"patch", "patches"};

/// Returns kPatchNoun for the patches between creases of a surface of triangles, whose numbers stand in no
/// file, otherwise kFaceNoun.
FaceNoun noun_of(const std::vector<ModelFace>& faces);

/// Returns faces by their numbers: "face 3", "patches 3, 5 and 9"; empty without numbers.
std::string words_of_faces(const std::vector<std::int32_t>& faces, const FaceNoun& noun);

/// Returns " between faces 3 and 5", or " of patch 3"; empty without numbers.
std::string between(const std::vector<std::int32_t>& faces, const FaceNoun& noun);

/// Each returns why no hexahedra fit: "the edge of 30 degrees between faces 3 and 5 is too sharp for a
/// hexahedron", "face 9 tapers to nothing between faces 12 and 17".
std::string fault_of(const FieldAnalysis::Singularity::Crease& crease, const FaceNoun& noun);
std::string fault_of(const FieldAnalysis::Singularity::Corner& corner, const FaceNoun& noun);
std::string fault_of(const FieldAnalysis::Singularity::Arc& arc);
std::string fault_of(const FieldAnalysis::Singularity::Node& node);

/// Returns where hexahedra cannot meet, each place once: creases and corners before nodes and arcs.
std::vector<Vector3> places_of_faults(const FieldAnalysis::Singularity& graph);

}  // namespace crossgrain
