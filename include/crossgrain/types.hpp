// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/warning.hpp"

namespace crossgrain {

/// \addtogroup types Meshes and frames
/// @{

/// A point or a direction, in the model's own length unit.
using Vector3 = std::array<double, 3>;

/// An axis-aligned box; empty when some `low` exceeds its `high`.
struct Box {
  Vector3 low;
  Vector3 high;
};

/// A unit of length: what the coordinates of a file mean that does not say so.
enum class LengthUnit : int { kUnknown, kMicrometre, kMillimetre, kCentimetre, kMetre, kInch, kFoot };

/// Returns the name that meshes and reports have: "mm"; "none" for kUnknown.
const char* name_of(LengthUnit unit);
/// What surface a face of a model lies on.
enum class FaceKind : int {
  // Of a CAD file.
  kPlane,
  kCylinder,
  kCone,
  kSphere,
  kTorus,
  kExtrusion,
  kRevolution,
  kSpline,  ///< Bezier or B-spline
  kOffset,
  kOther,

  kPatch,  ///< of a surface of triangles: those between creases
  kTagged  ///< of a tet mesh: triangles with the same tag
};

/// Returns a name for files and scripts: "cylinder".
const char* name_of(FaceKind kind);

/// A face of a model.
struct ModelFace {
  std::int64_t number = 0;  ///< TriangleMesh::faces of its triangles
  FaceKind kind{};
  double area = 0;
  Vector3 centre{};          ///< centroid; that of a curved face lies beside it
  std::uint32_t solids = 1;  ///< that it bounds: 2 between two solids, 0 inside one

  /// Faces of hexahedra on it; none without hexahedra, and for faces inside the model.
  std::optional<std::size_t> quads = {};
  std::optional<double> quads_area = {};  ///< of all of them
};

/// Volume and area of a model; of several solids the sum, without the faces between them. 0 if unknown.
struct ModelSize {
  double volume = 0, area = 0;
};

/// What a model is given as.
enum class ModelSource : int {
  kTets,
  kSurface,  ///< triangles
  kCad
};

/// Returns a name for files and scripts: "cad".
const char* name_of(ModelSource source);

/// A curve that frames should follow: a polyline with the tangent of the true curve at each of its points.
struct CreaseCurve {
  std::vector<Vector3> points;
  std::vector<Vector3> tangents;  ///< unit vectors, one per point
  std::int32_t tag = 0;           ///< number of the edge in the file that it comes from

  /// Whether the file tags it although the surface is not sharp there, or it lies inside the solid.
  bool is_tagged = false;
};

/// A surface: triangles that index vertices. Indices must be in range and coordinates finite; the surface may
/// be open, flipped, non-manifold or a triangle soup.
///
/// All other members are optional. Those that belong to triangles are empty or have one entry per triangle.
struct TriangleMesh {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// Number of the face of the CAD model, or tag, that the triangle belongs to.
  std::vector<std::int32_t> faces = {};

  /// Number of the solid that the triangle bounds, 0 or more, not necessarily consecutive. Triangles point
  /// out of their solid. A face between two solids is present twice, once for each, in opposite orientations.
  std::vector<std::int32_t> solids = {};

  /// Unit normals of the true surface at the corners of the triangle, on the side given by the right-hand
  /// rule.
  std::vector<std::array<Vector3, 3>> corner_normals = {};

  /// Sharp edges that the file knows; any number of them.
  std::vector<CreaseCurve> creases = {};

  /// Triangles inside a solid, in either orientation, whose normal frames should follow. They bound nothing.
  std::vector<std::array<std::uint32_t, 3>> inner_faces = {};

  /// Unit of the coordinates, such as "mm", and unit of the file, from which they were converted. Empty if
  /// the file does not say; the first may be set then.
  std::string unit = {};
  std::string file_unit = {};

  /// The faces of a CAD model, ascending by number, its exact size and box; empty and 0 for other surfaces.
  std::vector<ModelFace> face_list = {};
  ModelSize exact_size = {};
  Box exact_box = {};

  /// What reading found. A solve passes them on to its report.
  std::vector<Warning> warnings = {};
};

/// The model that tets were made of: what hexahedra in them are measured against.
struct GivenModel {
  ModelSource source{};
  std::vector<ModelFace> faces;  ///< ascending by number
  ModelSize size;                ///< exact for CAD models, otherwise that of the triangles

  /// Triangles around all solids: of a CAD model finer than the tets, with its creases, normals and numbers
  /// of faces; of a surface those given, as mended, with numbers of faces.
  TriangleMesh surface = {};

  /// The angle by which its edges count as sharp, unless it brings its creases along.
  double crease_angle_deg = 35;

  /// Of a CAD model: triangles between its solids that are the same of both, each once, of the vertices of
  /// `surface`.
  std::vector<std::array<std::uint32_t, 3>> between = {};
};

/// A solid cut into tets that index vertices, in either orientation.
///
/// Tagged edges and faces are features: frames should follow the edges and the normals of the faces.
struct TetMesh {
  struct Edge {
    std::array<std::uint32_t, 2> vertices;
    std::int32_t tag = 0;

    /// Whether the file marks the edge as a feature. Otherwise it may be any curve of the meshed model, even
    /// a seam: on the surface it counts only where the surface is sharp, inside the solid always.
    bool is_stated = true;
  };
  struct Face {
    std::array<std::uint32_t, 3> vertices;
    std::int32_t tag = 0;
  };

  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 4>> tets;

  std::vector<std::int32_t> regions = {};  ///< region number of each tet; empty if the file has none
  std::vector<Edge> feature_edges = {};
  std::vector<Face> feature_faces = {};

  /// As of a TriangleMesh.
  std::string unit = {};
  std::string file_unit = {};

  /// What the tets were made of; null if they were read.
  std::shared_ptr<const GivenModel> given = {};

  /// What a reader did not take as it stands in the file.
  std::vector<Warning> warnings = {};
};

/// What TetDomain::prepared_for_map did: numbers of tets and vertices before, and of splits.
struct MapPreparation {
  std::size_t tets_before = 0, vertices_before = 0;
  std::size_t split_edges = 0, split_faces = 0, split_tets = 0;

  /// Splits that were not made, because rounding would leave a tet without volume.
  std::size_t refused_splits = 0;
};

/// Three orthonormal axes, right-handed. An octahedral frame is the class of the 24 such triples that differ
/// by permutations and signs of the axes; each of them represents it.
struct Frame {
  std::array<Vector3, 3> axes;
};

/// What the constraints in a cell determine (docs/design.md, "Classes").
enum class CellConstraint : std::uint8_t {
  kNoSurface = 0,  ///< the cell holds no surface
  kPlane = 1,      ///< one axis
  kAxis = 2,       ///< one axis, as a compromise between normals
  kFrame = 3,      ///< all three axes
  kFree = 4,       ///< nothing: all directions are alike
  kConflicted = 5  ///< no frame meets them
};
inline constexpr int kCellConstraintCount = 6;

/// Degree of the spherical harmonics that represent a frame: 3 (octupoles, seven numbers) or 4 (nine
/// numbers).
enum class Degree : int { kThree = 3, kFour = 4 };

/// @}

}  // namespace crossgrain
