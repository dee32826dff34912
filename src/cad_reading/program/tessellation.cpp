// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/tessellation.hpp"

#include <fmt/format.h>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <utility>

#include "base/vector3.hpp"
#include "cad_reading/program/edge_nodes.hpp"
#include "cad_reading/program/face_surface.hpp"
#include "cad_reading/program/fault.hpp"
#include "cad_reading/program/sharp_edges.hpp"

namespace crossgrain {
namespace {

/// Largest distance between triangles and the true surface, in cells: a tenth is below what the grid
/// resolves, since normals come from the true surface. And its bounds relative to the longest side.
constexpr double kChordErrorCells = 0.1;
constexpr double kLargestChord = 1.0 / 40, kSmallestChord = 1e-6;

constexpr std::int32_t kNoSolid = -1;

/// The box before meshing also contains the poles of splines. If it exceeds that of the triangles by more
/// than this factor, the faces are meshed again, finer.
constexpr double kBoxTooLarge = 1.1;

double chord_error(double longest_side, const CadReading& options) {
  const int resolution = options.resolution > 0 ? options.resolution : kDefaultResolution;
  const double cell = options.cell_size > 0 ? options.cell_size : longest_side / resolution;
  return std::clamp(kChordErrorCells * cell, kSmallestChord * longest_side, kLargestChord * longest_side);
}

void mesh_faces(const TopoDS_Shape& shape, double chord, const CadReading& options) {
  // BREP files may contain triangles of any size.
  BRepTools::Clean(shape);
  const double angle_rad = options.facet_angle_deg * std::numbers::pi / 180;
  const bool relative = false, in_parallel = false;
  BRepMesh_IncrementalMesh(shape, chord, relative, angle_rad, in_parallel);
}

/// Triangles of a face, in the orientation of its surface.
struct FacetedFace {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<Vector3, 3>> corner_normals;
};

class Tessellation {
 public:
  Tessellation(const Bodies& bodies, const CadReading& options)
      : bodies_(bodies), options_(options), nodes_(bodies) {
    const double size = mesh_all();
    surfaces_.reserve(static_cast<std::size_t>(bodies.faces.Extent()) + 1);
    surfaces_.emplace_back(TopoDS::Face(bodies.faces(1)), size);  // entry 0 is unused
    faces_.resize(1);
    for (int number = 1; number <= bodies.faces.Extent(); ++number) {
      const TopoDS_Face face = TopoDS::Face(bodies.faces(number).Oriented(TopAbs_FORWARD));
      surfaces_.emplace_back(face, size);
      faces_.push_back(facets_of(face, surfaces_.back()));
    }
    mesh_.vertices = nodes_.positions();
  }

  TriangleMesh mesh() && {
    find_faces_within_solids();
    SharpEdges sharp(bodies_, surfaces_, options_.crease_angle_deg);
    for (const Body& body : bodies_.bodies) {
      const std::vector<Use> uses = uses_in(body.shape);
      const bool inside_out = body.closed && volume_of(uses) < 0;
      for (const Use& use : uses) {
        if (within_solids_[use.face]) continue;
        append(faces_[use.face], bodies_.face_numbers[use.face], body.solid, use.reversed != inside_out);
      }
      sharp.add(body.shape, inside_out);
    }
    if (mesh_.triangles.empty()) throw Fault("none of its faces could be triangulated");
    mesh_.creases = sharp.creases(nodes_);
    warn_of_missing_faces();
    return std::move(mesh_);
  }

 private:
  /// A face of a body with its orientation.
  struct Use {
    std::size_t face;
    bool reversed;
  };

  /// Meshes all faces. Returns the longest side of the box of the triangles.
  double mesh_all() {
    const double at_most = longest_side_at_most(bodies_.whole);
    mesh_faces(bodies_.whole, chord_error(at_most, options_), options_);
    const double size = longest_side_of_triangles();
    if (size > 0 && at_most > kBoxTooLarge * size)
      mesh_faces(bodies_.whole, chord_error(size, options_), options_);
    return size;
  }

  double longest_side_of_triangles() const {
    Vector3 low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (int number = 1; number <= bodies_.faces.Extent(); ++number) {
      TopLoc_Location location;
      const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(bodies_.faces(number)), location);
      for (int node = 1; !mesh.IsNull() && node <= mesh->NbNodes(); ++node) {
        const gp_Pnt point = mesh->Node(node).Transformed(location);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          low[axis] = std::min(low[axis], point.Coord(static_cast<int>(axis) + 1));
          high[axis] = std::max(high[axis], point.Coord(static_cast<int>(axis) + 1));
        }
      }
    }
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 0.0});
  }

  /// `face` must be FORWARD.
  FacetedFace facets_of(const TopoDS_Face& face, const FaceSurface& surface) {
    FacetedFace result;
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull() || !mesh->HasUVNodes()) return result;
    const std::vector<std::uint32_t> vertices = nodes_.vertices_of(face, mesh, location);
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
      std::array<int, 3> nodes;
      mesh->Triangle(i).Get(nodes[0], nodes[1], nodes[2]);
      std::array<std::uint32_t, 3> triangle;
      std::array<gp_Pnt2d, 3> uv;
      for (std::size_t k = 0; k < 3; ++k) {
        triangle[k] = vertices[static_cast<std::size_t>(nodes[k])];
        uv[k] = mesh->UVNode(nodes[k]);
      }
      // At the apex of a cone an edge of the face is a single point.
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
      result.triangles.push_back(triangle);
      result.corner_normals.push_back(corner_normals(surface, uv, facet_normal(triangle)));
    }
    return result;
  }

  Vector3 facet_normal(const std::array<std::uint32_t, 3>& triangle) const {
    const auto& [a, b, c] = triangle;
    const std::vector<Vector3>& at = nodes_.positions();
    return normalised(cross(at[b] - at[a], at[c] - at[a]));
  }

  /// Corner normals. Where the surface has none, that of the triangle's own strip, as on a cone; failing
  /// that, the triangle's.
  static std::array<Vector3, 3> corner_normals(const FaceSurface& surface, const std::array<gp_Pnt2d, 3>& uv,
                                               const Vector3& facet_normal) {
    std::array<Vector3, 3> normals;
    for (std::size_t k = 0; k < 3; ++k) {
      std::optional<Vector3> normal = surface.normal_at(uv[k]);
      if (!normal) normal = surface.normal_beside(uv[k], (uv[(k + 1) % 3].XY() + uv[(k + 2) % 3].XY()) / 2);
      normals[k] = normal.value_or(facet_normal);
    }
    return normals;
  }

  /// Finds the faces between pieces of one solid.
  void find_faces_within_solids() {
    within_solids_.resize(faces_.size());
    std::vector<std::int32_t> forward(faces_.size(), kNoSolid), reversed(faces_.size(), kNoSolid);
    for (const Body& body : bodies_.bodies) {
      for (const Use& use : uses_in(body.shape)) (use.reversed ? reversed : forward)[use.face] = body.solid;
    }
    const bool has_pieces =
        std::adjacent_find(bodies_.bodies.begin(), bodies_.bodies.end(), [](const Body& a, const Body& b) {
          return a.solid == b.solid;
        }) != bodies_.bodies.end();
    for (std::size_t face = 0; has_pieces && face < faces_.size(); ++face)
      within_solids_[face] = forward[face] != kNoSolid && forward[face] == reversed[face];
  }

  std::vector<Use> uses_in(const TopoDS_Shape& body) const {
    std::vector<Use> uses;
    for (TopExp_Explorer faces(body, TopAbs_FACE); faces.More(); faces.Next()) {
      const TopoDS_Shape& face = faces.Current();
      // Faces of other orientations lie inside or outside a body and do not bound it.
      if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) continue;
      uses.push_back(
          {static_cast<std::size_t>(bodies_.faces.FindIndex(face)), face.Orientation() == TopAbs_REVERSED});
    }
    return uses;
  }

  /// Returns six times the enclosed volume. Coordinates are relative to one of the vertices, to limit
  /// rounding errors.
  double volume_of(const std::vector<Use>& uses) const {
    double volume = 0;
    const Vector3* origin = nullptr;
    for (const Use& use : uses) {
      for (const auto& [a, b, c] : faces_[use.face].triangles) {
        if (origin == nullptr) origin = &mesh_.vertices[a];
        const double part =
            dot(mesh_.vertices[a] - *origin, cross(mesh_.vertices[b] - *origin, mesh_.vertices[c] - *origin));
        volume += use.reversed ? -part : part;
      }
    }
    return volume;
  }

  void append(const FacetedFace& face, std::int32_t number, std::int32_t solid, bool reversed) {
    for (std::size_t t = 0; t < face.triangles.size(); ++t) {
      auto triangle = face.triangles[t];
      auto normals = face.corner_normals[t];
      if (reversed) {
        std::swap(triangle[1], triangle[2]);
        std::swap(normals[1], normals[2]);
        for (Vector3& normal : normals) normal = -normal;
      }
      mesh_.triangles.push_back(triangle);
      mesh_.corner_normals.push_back(normals);
      mesh_.faces.push_back(number);
      mesh_.solids.push_back(solid);
    }
  }

  void warn_of_missing_faces() {
    std::size_t missing = 0;
    std::int32_t first = 0;
    for (std::size_t face = 1; face < faces_.size(); ++face) {
      if (!faces_[face].triangles.empty()) continue;
      if (missing++ == 0) first = bodies_.face_numbers[face];
    }
    if (missing > 0)
      mesh_.warnings.emplace_back(
          WarningKind::kMissingFaces,
          fmt::format(
              "faces that could not be triangulated, so they are missing: {} of {}; the first is face {}",
              missing, faces_.size() - 1, first));
  }

  const Bodies& bodies_;
  const CadReading& options_;
  EdgeNodes nodes_;
  std::vector<FaceSurface> surfaces_;  ///< of the faces, from 1
  std::vector<FacetedFace> faces_;     ///< of the faces, from 1
  std::vector<bool> within_solids_;    ///< of the faces, from 1: between pieces of one solid
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh tessellate(const Bodies& bodies, const CadReading& options) {
  return Tessellation(bodies, options).mesh();
}

}  // namespace crossgrain
