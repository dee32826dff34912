// SPDX-License-Identifier: Apache-2.0
// Solids with fields on them, with all that a map of them refers to.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "map/demanded_splits.hpp"
#include "map/map_unknowns.hpp"
#include "repair/made_matchings.hpp"
#include "repair/repaired_matchings.hpp"
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

inline RepairedTets repaired_cylinder(const TetComplex& complex) {
  const auto frames = frames_at_centroids(complex.solid(), [](const Vector3& p) {
    // Straight near the axis, along the radius at the surface: four lines between.
    const double angle = std::atan2(p[1], p[0]), quarter = std::numbers::pi / 2;
    const double nearest = angle - quarter * std::round(angle / quarter);
    return from_rotation_vector({0, 0, std::clamp(2.5 * std::hypot(p[0], p[1]) - 1.2, 0.0, 1.0) * nearest});
  });
  return repaired_tets(MatchedField(complex, frames), {});
}

/// A cylinder of radius 1 and height 2 with repaired matchings, four arcs along it, and tets split for a map.
struct ArcedCylinder {
  TetSolid given = solid_of(tet_cylinder(8));
  TetComplex complex{given};
  RepairedTets repaired = repaired_cylinder(complex);
  OwnedField split = split_for_map(MatchedField(complex, repaired.frames, repaired.matchings));
  CutSolid cut{*split.field};
  MapUnknowns unknowns{cut};

  ArcedCylinder() = default;
  ArcedCylinder(const ArcedCylinder&) = delete;
};

}  // namespace crossgrain::testing
