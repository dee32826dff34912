// SPDX-License-Identifier: Apache-2.0
#include "picture/hex_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "crossgrain/error.hpp"
#include "crossgrain/message.hpp"
#include "display/shown_faces.hpp"
#include "display/smooth_corners.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"
#include "picture/face_labels.hpp"
#include "picture/field_drawing.hpp"
#include "picture/region_colours.hpp"

namespace crossgrain {
namespace {

/// Radius of edges in units of PictureWeights, and the most in lengths of a mean edge: of a fine mesh they
/// would cover the colours.
constexpr double kEdgeRadius = 0.9, kMostOfAnEdge = 0.035;

/// The least radius in pixels, since the one ray through a pixel misses thinner rods; and the least mean
/// length of an edge in pixels, below which they would cover the colours all the same, and are left out.
constexpr double kLeastRadius = 0.55, kLeastLength = 5;

/// Edges of what a limit of shapes leaves out are this much thinner, so that those of what is there cover
/// them.
constexpr double kPaleShare = 0.8;

/// Of 32 degrees, as of creases of surfaces.
constexpr double kSharpCosine = 0.848;

/// Opacities of what a limit of shapes leaves out.
constexpr float kPale = 0.05f, kPaleAside = 0.3f;

/// Enough to tell the sides of a hexahedron apart, in colours that can still be found in the legend.
constexpr float kShading = 0.5f;

/// Edges are dark on any paper: they run over faces, which are light.
constexpr Colour kInverted = colour_of(0xd916d3), kEdge = colour_of(0x1d2630),
                 kPaleEdge = colour_of(0xaab4be);

/// Four triangles for each face, around its centre.
SolvedSurface triangles_of(const HexMesh& mesh, const std::vector<HexSide>& faces) {
  SolvedSurface surface;
  surface.vertices = mesh.vertices;
  for (const HexSide& face : faces) {
    const auto centre = static_cast<std::uint32_t>(surface.vertices.size());
    Vector3 sum{0, 0, 0};
    for (const std::uint32_t v : face.vertices) sum += 0.25 * mesh.vertices[v];
    surface.vertices.push_back(sum);
    for (std::size_t k = 0; k < 4; ++k)
      surface.triangles.push_back({face.vertices[k], face.vertices[(k + 1) % 4], centre});
  }
  return surface;
}

Vector3 normal_of(const HexMesh& mesh, const HexSide& face) {
  const auto& [a, b, c, d] = face.vertices;
  return normalised(cross(mesh.vertices[c] - mesh.vertices[a], mesh.vertices[d] - mesh.vertices[b]));
}

/// One normal for each face: the four triangles of a warped one look as one.
CornerNormals normals_of(const HexMesh& mesh, const std::vector<HexSide>& faces) {
  CornerNormals normals;
  for (const HexSide& face : faces) {
    const Vector3 normal = normal_of(mesh, face);
    std::array<float, 3> single;
    for (std::size_t k = 0; k < 3; ++k) single[k] = static_cast<float>(normal[k]);
    normals.insert(normals.end(), 4, {single, single, single});
  }
  return normals;
}

/// The edges at which faces turn by more than those of one curved side do.
std::vector<std::array<std::uint32_t, 2>> sharp_edges(const HexMesh& mesh,
                                                      const std::vector<HexSide>& faces) {
  struct Use {
    std::array<std::uint32_t, 2> edge;
    Vector3 normal;
  };
  std::vector<Use> uses;
  for (const HexSide& face : faces) {
    const Vector3 normal = normal_of(mesh, face);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [low, high] = std::minmax(face.vertices[k], face.vertices[(k + 1) % 4]);
      uses.push_back({{low, high}, normal});
    }
  }
  std::stable_sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.edge < b.edge; });
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::size_t k = 1; k < uses.size(); ++k)
    if (uses[k].edge == uses[k - 1].edge && dot(uses[k].normal, uses[k - 1].normal) < kSharpCosine)
      edges.push_back(uses[k].edge);
  return edges;
}

DrawnMesh pale_mesh(const SolvedSurface& surface) {
  DrawnMesh mesh;
  mesh.vertices = surface.vertices;
  mesh.triangles = surface.triangles;
  mesh.colour = kPlainPart;
  mesh.opacity = kPale;
  mesh.grazing_opacity = kPaleAside;
  mesh.has_front_only = true;
  return mesh;
}

Colour colour_of_shape(double shape) {
  static const ColourMap map = ColourMap::shape();
  return map.at(shape);
}

std::vector<Rod> rods_along(const HexMesh& mesh, const std::vector<std::array<std::uint32_t, 2>>& edges,
                            double radius, const Colour& colour) {
  std::vector<Rod> rods;
  for (const auto& [a, b] : edges) rods.push_back({mesh.vertices[a], mesh.vertices[b], radius, colour});
  return rods;
}

double mean_length(const HexMesh& mesh, const HexSkin& skin) {
  double sum = 0;
  for (const auto& [a, b] : skin.edges) sum += norm(mesh.vertices[a] - mesh.vertices[b]);
  return sum / static_cast<double>(std::max<std::size_t>(skin.edges.size(), 1));
}

std::string hexahedra_text(std::size_t count) {
  return counted(count, "hexahedron", "hexahedra");
}

const char* title_of(HexOutcome outcome) {
  switch (outcome) {
    case HexOutcome::kAllHex:
      return "All-hex";
    case HexOutcome::kApproximate:
      return "Approximate mesh";
    default:
      return "Partial mesh";
  }
}

LegendBlock outcome_block(std::size_t hexahedra, const HexReport* report) {
  if (report == nullptr) return {hexahedra_text(hexahedra)};
  LegendBlock block{fmt::format("{}{}: {}", title_of(report->outcome),
                                report->is_of_lattice() ? " by a lattice" : "", hexahedra_text(hexahedra))};
  if (!report->reason.empty()) block.notes.push_back(report->reason);
  if (const std::string lacking = lacking_of(*report); !lacking.empty()) block.notes.push_back(lacking);
  return block;
}

}  // namespace

ShownHexahedra::ShownHexahedra(const HexMesh& mesh, const PictureOptions& options, const Vector3& towards)
    : mesh_(mesh),
      options_(options),
      shapes_(scaled_jacobians(mesh)),
      is_inverted_(inverted_hexahedra(mesh)) {
  std::vector<std::uint8_t> is_shown(mesh.hexahedra.size(), 1);
  skin_ = skin_of(mesh, is_shown);
  kept_surface_ = triangles_of(mesh, skin_.faces);
  if (const auto cut = picture_cut(options, kept_surface_, towards)) {
    const auto& [axis, position] = cut->plane;
    is_shown = hexahedra_beside(mesh, axis, position, cut->normal[axis] < 0);
    skin_ = skin_of(mesh, is_shown);
    kept_surface_ = triangles_of(mesh, skin_.faces);
    if (kept_surface_.triangles.empty())
      throw Error(ErrorKind::kUsage, fmt::format("the cut at {} = {:.6g} leaves no hexahedron", "xyz"[axis],
                                                 cut -> asked_position));
  }
  if (options.quality_below) take_below(*options.quality_below, is_shown);
  shown_ = static_cast<std::size_t>(std::count(is_shown.begin(), is_shown.end(), 1));
  surface_ = triangles_of(mesh, skin_.faces);
  choose_colours();
}

/// A picture of nothing would look like one of a mesh without poor hexahedra.
void ShownHexahedra::take_below(double limit, std::vector<std::uint8_t>& is_shown) {
  kept_edges_ = sharp_edges(mesh_, skin_.faces);
  double worst = 2;  // more than any
  for (std::size_t h = 0; h < is_shown.size(); ++h) {
    if (is_shown[h] == 0) continue;
    worst = std::min(worst, shapes_[h]);
    is_shown[h] = shapes_[h] < limit;
  }
  if (!(worst < limit))
    throw Error(ErrorKind::kUsage,
                fmt::format("no hexahedron{} has a scaled Jacobian below {:g}: the worst has {:.4g}",
                            options_.cut ? " that the cut leaves" : "", limit, worst));
  skin_ = skin_of(mesh_, is_shown);
}

void ShownHexahedra::choose_colours() {
  if (options_.colour == PictureColour::kRegion) {
    const std::set<std::int32_t> regions(mesh_.regions.begin(), mesh_.regions.end());
    if (regions.size() < 2) throw Error(ErrorKind::kUsage, "the hexahedra have only one region");
    regions_.assign(regions.begin(), regions.end());
  }
  if (options_.colour != PictureColour::kFace) return;
  if (std::ranges::all_of(mesh_.boundary, [](const HexMesh::Face& face) { return face.tag == 0; }))
    throw Error(ErrorKind::kInput, "the hexahedra have no faces of a model");
  tags_ = tags_of_sides(mesh_, skin_.faces);
}

Drawing ShownHexahedra::drawing(const Camera& camera, double text_size) const {
  DrawnMesh mesh;
  mesh.vertices = surface_.vertices;
  mesh.triangles = surface_.triangles;
  mesh.corner_normals = normals_of(mesh_, skin_.faces);
  mesh.shading = kShading;
  mesh.colour_at = [this](const MeshPoint& point) {
    if (!tags_.empty()) return colour_of_face(tags_[point.triangle / 4]);
    const std::size_t hexahedron = skin_.faces[point.triangle / 4].hexahedron;
    if (!regions_.empty()) return colour_of_region(regions_, mesh_.regions[hexahedron]);
    return is_inverted_[hexahedron] ? kInverted : colour_of_shape(shapes_[hexahedron]);
  };
  Drawing drawing;
  if (!tags_.empty()) {
    std::vector<std::int32_t> faces;
    for (const std::int32_t tag : tags_) faces.insert(faces.end(), 4, tag);
    drawing.labels =
        face_labels(mesh.vertices, mesh.triangles, faces, camera, options_.size, text_size, nullptr);
  }
  drawing.meshes.push_back(std::move(mesh));
  const double pixel = camera.pixel_size(), length = mean_length(mesh_, skin_);
  const double widest = std::max(kEdgeRadius * PictureWeights(options_, camera).unit, kLeastRadius * pixel);
  const double radius = std::clamp(kMostOfAnEdge * length, kLeastRadius * pixel, widest);
  if (length >= kLeastLength * pixel)
    drawing.rods.push_back({RodLook::kInk, rods_along(mesh_, skin_.edges, radius, kEdge), {}});
  if (!options_.quality_below) return drawing;
  drawing.meshes.push_back(pale_mesh(kept_surface_));
  drawing.rods.push_back(
      {RodLook::kInk,
       rods_along(mesh_, kept_edges_, std::max(kPaleShare * widest, kLeastRadius * pixel), kPaleEdge),
       {}});
  return drawing;
}

std::vector<LegendBlock> ShownHexahedra::legend(const HexReport* report) const {
  const auto inverted = std::ranges::count(is_inverted_, 1);
  LegendBlock shapes{"Scaled Jacobian", "", ColourBar{ColourMap::shape(), {0, 1}}};
  if (inverted > 0)
    shapes.signs.push_back({Sign::Shape::kBox, kInverted, fmt::format("inverted ({})", inverted)});
  const double worst = *std::min_element(shapes_.begin(), shapes_.end());
  shapes.signs.push_back({Sign::Shape::kNothing, {}, fmt::format("worst {:.2g}", worst)});
  if (!tags_.empty()) shapes = face_legend(tags_);
  if (!regions_.empty()) shapes = region_legend(regions_);
  std::vector<LegendBlock> blocks{outcome_block(mesh_.hexahedra.size(), report), std::move(shapes)};
  if (options_.quality_below)
    blocks.push_back(
        {fmt::format("{} shown, below {:.3g}", hexahedra_text(shown_), *options_.quality_below)});
  else if (options_.cut)
    blocks.push_back({fmt::format("{} shown", hexahedra_text(shown_))});
  return blocks;
}

}  // namespace crossgrain
