// SPDX-License-Identifier: Apache-2.0
// Where vertices of hexahedra belong on the surface of the tets.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "hex/hex_extraction.hpp"
#include "matching/matched_field.hpp"
#include "surface/bvh.hpp"

namespace crossgrain {

/// What a vertex of hexahedra keeps to while it moves.
struct Foot {
  enum class Kind : std::uint8_t { kInside, kFace, kCurve, kCorner };
  Kind kind = Kind::kInside;
  std::uint32_t index = 0;  ///< of the face or curve (MapSurface), or the vertex of the tets
};

/// The surface of tets as a map has it: faces, on each of which one coordinate of the map is constant, curves
/// between two of them, on which two are, and corners. A crease of the surface that the map does not bend at
/// is inside such a face.
class MapSurface {
 public:
  /// The field must outlive it.
  explicit MapSurface(const MatchedField& field);

  Foot foot_of(const Carrier& carrier) const;

  /// The nearest point of what a vertex keeps to.
  struct Place {
    Vector3 point;
    Vector3 direction{0, 0, 0};  ///< unit: the normal of a face, outward, or along a curve
    std::uint32_t face = 0;      ///< of the boundary (TetSolid::boundary); for faces only
  };
  Place nearest(const Foot& foot, const Vector3& point) const;

  /// Of all faces.
  Place nearest_of_all(const Vector3& point) const;

 private:
  struct Face {
    Surface surface;  ///< TriangleMesh::faces are indices of boundary faces
    std::optional<TriangleBvh> tree;
  };
  using Segment = std::array<std::uint32_t, 2>;

  /// A boundary face with its vertices in ascending order.
  struct SortedFace {
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t face;
  };

  void find_faces();
  void find_curves();
  bool is_bent(std::uint32_t boundary_edge) const;
  std::vector<std::uint32_t> bent_edges_at(std::uint32_t vertex) const;

  const MatchedField* field_;
  std::vector<SortedFace> boundary_;     ///< ascending
  std::vector<std::uint32_t> face_of_;   ///< of each boundary face
  std::vector<std::uint32_t> curve_of_;  ///< of each edge of the complex that is bent
  std::vector<std::unique_ptr<Face>> faces_;
  std::vector<std::vector<Segment>> curves_;
};

}  // namespace crossgrain
