// SPDX-License-Identifier: Apache-2.0
// Solids with fields on them, with all that a map of them refers to.
#pragma once

#include <array>
#include <random>
#include <utility>
#include <vector>

#include "matching/made_matchings.hpp"
#include "reduction/demanded_splits.hpp"
#include "reduction/map_unknowns.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain::testing {

/// A solid with a field; frames are those that a function makes of the solid.
struct MappedSolid {
  TetSolid solid;
  TetComplex complex;
  std::vector<Quaternion> frames;
  MatchedField field;
  CutSolid cut;
  MapUnknowns unknowns;

  template <class Frames>
  MappedSolid(TetMesh mesh, const Frames& frames_of)
      : solid(solid_of(std::move(mesh))),
        complex(solid),
        frames(frames_of(solid)),
        field(complex, frames),
        cut(field),
        unknowns(cut) {}
  MappedSolid(const MappedSolid&) = delete;
};

/// A box of these sides that lies askew, with frames along its sides, each named in another way.
struct AskewBox : MappedSolid {
  explicit AskewBox(const std::array<std::uint32_t, 3>& cells, const Vector3& cell = {1, 1, 1})
      : MappedSolid(mesh_of(cells, cell), named) {}

  static Quaternion turn() { return from_rotation_vector({0.4, -0.3, 0.7}); }

  static TetMesh mesh_of(const std::array<std::uint32_t, 3>& cells, const Vector3& cell) {
    TetMesh mesh = TetBox{cells}.mesh(0.1);
    for (Vector3& p : mesh.vertices)
      p = rotate(turn(), Vector3{p[0] * cell[0], p[1] * cell[1], p[2] * cell[2]});
    return mesh;
  }

  static std::vector<Quaternion> named(const TetSolid& solid) {
    std::vector<Quaternion> result;
    std::mt19937 random(3);
    for (std::size_t t = 0; t < solid.mesh.tets.size(); ++t)
      result.push_back(turn() *
                       to_quaternion(CubeGroup::instance()[static_cast<std::uint8_t>(random() % 24)]));
    return result;
  }
};

}  // namespace crossgrain::testing
