// SPDX-License-Identifier: Apache-2.0
// The features of a model as a cell complex: corners, curves between them, and faces between curves.
//
//        ends[1]
//           |            sectors counter-clockwise, seen from the side that normals look to:
//   face 0  |  face 1      {from 0, to 1, face 1}, {from 1, to 2, face 0}, {from 2, to 0, face 2}
//           o---- ends[0]
//          /             a curve that leaves the corner along ends[0] has face 1 on its left
//  ends[2]   face 2      and face 2 on its right
//
// An edge of three or more faces, or a point where several solids meet, has no single cycle: its sectors are
// listed one by one, and those of one pair of regions follow each other by `to` and `from`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/crease_angles.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

struct FeatureComplex {
  static constexpr std::uint32_t kNone = UINT32_MAX;

  /// Where a curve leaves a corner: at its first point, or at its last.
  struct End {
    std::uint32_t curve;
    bool is_last;

    friend bool operator==(const End&, const End&) = default;
  };

  /// The part of a face at a corner between two ends of curves that follow each other counter-clockwise, seen
  /// from the side that the face's normals look to.
  struct Sector {
    /// Indices in Corner::ends. They are equal where one curve ends inside the face; both are kNone where the
    /// face is all around the corner without a curve.
    std::uint32_t from, to;
    std::uint32_t face;
    std::int32_t below, above;  ///< those of the face
    double angle_rad;           ///< the sum of the angles of its triangles
  };

  /// A point where not just two curves meet that continue each other, or the tip of a cone.
  struct Corner {
    std::uint32_t vertex;
    Vector3 point;
    std::vector<End> ends;        ///< ascending by curve, first points before last ones
    std::vector<Sector> sectors;  ///< ascending by `from`, then by face
  };

  /// A face beside a curve.
  struct Side {
    std::uint32_t face;
    bool is_left;  ///< of the curve's direction, seen from the side that the face's normals look to

    friend bool operator==(const Side&, const Side&) = default;
  };

  struct Curve {
    std::vector<std::uint32_t> vertices;   ///< a closed curve ends with its first vertex
    std::array<std::uint32_t, 2> corners;  ///< at its first and last vertex; kNone of a closed one without

    /// Counter-clockwise around its direction, beginning with the lowest face. One of an open border, two
    /// mostly, three and more where solids meet. A curve inside a face has it on both sides.
    std::vector<Side> sides;

    bool is_soft;      ///< the surface is smooth across it: the border of a fillet, or a tagged edge
    bool is_tagged;    ///< the file tags it and the surface is not sharp there
    std::int32_t tag;  ///< CreaseCurve::tag of the curve of the mesh that it lies on; 0 without
    double length;

    bool is_closed() const { return vertices.front() == vertices.back(); }
  };

  /// Triangles that are connected over edges of no curve.
  struct Face {
    /// TriangleMesh::faces of its triangles; without them that of `face_numbers`. Pieces of a face that
    /// curves divide have its number.
    std::int32_t number;

    /// The solid behind the face, and the one that normals look into: TriangleMesh::solids + 1, or 1 without
    /// them; 0 outside the model. `below` is larger.
    std::int32_t below, above;

    std::vector<std::uint32_t> triangles;  ///< ascending

    /// Of the face with its border: that of a disk is 1, of a sphere 2, of a ring 0. A vertex at which it
    /// touches itself, and both sides of a curve inside it, count as often as it passes them.
    int euler;
    std::size_t loops;  ///< of its border; a curve that ends inside it with both ends is one
    double area;
  };

  std::vector<Vector3> vertices;  ///< those of the surface, by the same indices

  /// Corners are the first of equal vertices. A face between two solids is there once, of the higher one.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> face_of;    ///< of each triangle
  std::vector<std::uint32_t> source_of;  ///< of each triangle, its index in the surface

  /// As of a TriangleMesh, for each triangle; empty without.
  std::vector<std::array<Vector3, 3>> corner_normals;

  std::vector<Corner> corners;  ///< ascending by vertex
  std::vector<Curve> curves;    ///< open ones first, each kind by first vertices
  std::vector<Face> faces;      ///< by their first triangles

  std::array<Vector3, 3> points_of(std::size_t triangle) const {
    return crossgrain::corners_of(triangles[triangle], vertices);
  }
};

/// Curves that only the file knows (borders of its faces, tagged edges) are soft where the surface turns by
/// less across them.
inline constexpr double kSoftDeg = 15;

struct FeatureOptions {
  CreaseAngles angles = {};

  /// Whether the solids of a mesh are one: faces between them, and the curves of these, are left out.
  bool unite_solids = false;
};

/// Returns the features of a surface. Curves are its creases, by the rules of a solve: those that the mesh
/// brings along (TriangleMesh::creases) or its sharp edges (`sharp_curves`), the borders of its faces
/// (TriangleMesh::faces), open edges and those of three or more triangles. A seam, where a face meets itself
/// smoothly, is none. The surface turns across a curve by what exact normals say (corner_normals), without
/// them by its triangles beside those next to them.
///
/// Takes any surface: open, wrongly oriented, a soup. Solids whose common face has unequal triangles keep
/// both copies, each beside the outside.
/// Inner faces, and creases that run along no edge of a triangle, are left out.
FeatureComplex feature_complex(const Surface& surface, const FeatureOptions& options = {});

}  // namespace crossgrain
