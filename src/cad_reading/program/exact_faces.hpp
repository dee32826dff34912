// SPDX-License-Identifier: Apache-2.0
// The true faces of bodies in numbers: kinds, areas, centroids; and the volume inside them.
#pragma once

#include <vector>

#include "cad_reading/program/bodies.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

struct ExactFaces {
  std::vector<ModelFace> faces;  ///< ascending by number (Bodies::face_numbers)

  /// Volume of all closed bodies, those that overlap counted each; area of the faces of one body only. 0 if
  /// OpenCASCADE cannot integrate over a face.
  ModelSize size;
};

/// Integrates over the true surfaces (BRepGProp), to 1e-6 of each value or better on sound faces.
ExactFaces exact_faces(const Bodies& bodies);

}  // namespace crossgrain
