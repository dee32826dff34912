// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/warning.hpp"

namespace crossgrain {

/// A point or a direction, in the model's own length unit.
using Vector3 = std::array<double, 3>;

/// An axis-aligned box; empty when some `low` exceeds its `high`.
struct Box {
  Vector3 low;
  Vector3 high;
};

/// A curve on a surface that frames are to run along: a polyline with the tangent of the true curve at each
/// of its points.
struct CreaseCurve {
  std::vector<Vector3> points;
  std::vector<Vector3> tangents;  ///< unit vectors, one a point
  std::int32_t tag = 0;           ///< the number of the edge in the file that it comes from

  /// The file asks for it where the surface is not sharp, or inside (SolverOptions::tagged_weight).
  bool is_tagged = false;
};

/// A surface: triangles that index vertices. Nothing is required of it but that indices are in range and
/// coordinates are finite; it may be open, flipped, non-manifold or a soup.
///
/// The other members say what the file knew besides. Those of triangles are empty, or have an entry for each.
struct TriangleMesh {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// The number of the face of the CAD model, or the tag, that a triangle belongs to.
  std::vector<std::int32_t> faces = {};

  /// The solid that a triangle bounds, counted from 0, seen from inside against the right-hand rule. A face
  /// between two solids is there twice, once for each, in opposite orientation.
  /// Numbers need not follow one another.
  std::vector<std::int32_t> solids = {};

  /// Unit normals of the true surface at a triangle's corners, on the side of the right-hand rule.
  std::vector<std::array<Vector3, 3>> corner_normals = {};

  /// Sharp edges that the file knows. Not one a triangle: any number.
  std::vector<CreaseCurve> creases = {};

  /// Triangles inside a solid, either way round, that frames are to have an axis across. They bound nothing.
  std::vector<std::array<std::uint32_t, 3>> inner_faces = {};

  /// The unit of the coordinates, such as "mm", and the one that the file itself is in, from which they were
  /// converted. Empty where the file does not say.
  std::string unit = {};
  std::string file_unit = {};

  /// What reading found. A solve passes them on to its report.
  std::vector<Warning> warnings = {};
};

/// A solid cut into tets that index vertices, of either orientation.
///
/// What a file tags are features: frames are to run along tagged edges, and to have an axis across tagged
/// faces.
struct TetMesh {
  struct Edge {
    std::array<std::uint32_t, 2> vertices;
    std::int32_t tag = 0;

    /// Someone asked for it. Otherwise it may be any curve of the model that was meshed, a seam too: on a
    /// face it counts only where the face is sharp, as if it were not there, and inside the solid in full.
    bool is_stated = true;
  };
  struct Face {
    std::array<std::uint32_t, 3> vertices;
    std::int32_t tag = 0;
  };

  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 4>> tets;

  std::vector<std::int32_t> regions = {};  ///< the number of each tet's region; empty where the file has none
  std::vector<Edge> feature_edges = {};
  std::vector<Face> feature_faces = {};

  /// What a reader did not take as it stands in the file.
  std::vector<Warning> warnings = {};
};

/// Three orthonormal axes, right-handed. As an octahedral frame it stands for itself and the 23 other
/// rotations that permute the axes and flip their signs.
struct Frame {
  std::array<Vector3, 3> axes;
};

/// Degree of the spherical harmonics that carry a frame: 3 (octupoles, seven numbers) or 4 (nine numbers).
enum class Degree : int { kThree = 3, kFour = 4 };

}  // namespace crossgrain
