// SPDX-License-Identifier: Apache-2.0
#include "hex/model_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/digits.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/place.hpp"
#include "hex/hex_forecast.hpp"
#include "measure/fault_words.hpp"
#include "measure/hex_quality.hpp"
#include "surface/bvh.hpp"
#include "surface/model_faces.hpp"
#include "surface/surface.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Share of the model's volume that is worth a warning, and distance in sizes of hexahedra. Of 20 meshes that
/// fill their models (two of models/, eleven of HexMe's c meshes, seven CAD parts) the worst is 1.7 % off the
/// volume of its tets, which are up to 1.5 % off a CAD model, and 0.32 sizes off the surface. A ring of 1.3
/// sizes in thickness loses 20 %, a rod of one 37 %.
constexpr double kPoorVolume = 0.05, kPoorDistance = 0.5;

/// What a size is suggested for: less than kPoorVolume, since a whole number of hexahedra fits around a hole.
constexpr double kAimedVolume = 0.04;

/// Share of the model's volume that is said although it is no fault.
constexpr double kNoticedVolume = 0.02;

/// Share of the area of a face by which that of its quads may be off: around a hole six quads cut off 5 %,
/// four 10 %.
constexpr double kPoorFaceArea = 0.15;

/// Faces that a warning names.
constexpr std::size_t kMostNamed = 5;

Farthest farthest_from(const Surface& surface, const std::vector<Vector3>& points) {
  Farthest result;
  if (points.empty()) return result;
  const TriangleBvh tree(surface);
  std::vector<double> distances(points.size());
  parallel_for(points.size(),
               [&](std::size_t k) { distances[k] = std::sqrt(tree.nearest(points[k]).squared_distance); });
  const auto largest = std::max_element(distances.begin(), distances.end());
  result.distance = *largest;
  result.place = points[static_cast<std::size_t>(largest - distances.begin())];
  result.mean =
      std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size());
  return result;
}

/// The vertices of the boundary, each once.
std::vector<Vector3> boundary_points(const HexMesh& mesh) {
  std::vector<std::uint32_t> used;
  for (const HexMesh::Face& face : mesh.boundary)
    used.insert(used.end(), face.vertices.begin(), face.vertices.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<Vector3> points;
  for (const std::uint32_t v : used) points.push_back(mesh.vertices[v]);
  return points;
}

void measure_distances(const HexMesh& mesh, const Surface& model, const TetSolid& tets, HexReport& report) {
  const Farthest away = farthest_from(model, boundary_points(mesh));
  report.largest_distance = away.distance;
  report.largest_distance_place = away.place;
  report.mean_distance = away.mean;
  std::vector<Vector3> points = points_on(model.mesh.vertices, model.mesh.triangles);
  for (const auto& triangle : tets.boundary)
    for (const std::uint32_t v : triangle) points.push_back(tets.mesh.vertices[v]);
  const Farthest missed = farthest_from(mesh, points);
  report.largest_distance_of_model = missed.distance;
  report.largest_distance_of_model_place = missed.place;
}

/// Area over the largest extent: of a strip its width, of other faces less than that. 0 for a face without
/// triangles.
double width_of(const ModelFace& face, const TetSolid& tets, const std::vector<std::int32_t>& tags) {
  std::vector<Vector3> points;
  for (std::size_t f = 0; f < tags.size(); ++f)
    if (tags[f] == face.number)
      for (const std::uint32_t v : tets.boundary[f]) points.push_back(tets.mesh.vertices[v]);
  if (points.empty()) return 0;
  // From any point to the farthest, and from there again: at least 1/sqrt(3) of the diameter, nearly all of
  // it for strips.
  Vector3 from = points.front();
  double extent = 0;
  for (int pass = 0; pass < 2; ++pass) {
    const Vector3 start = from;
    extent = 0;
    for (const Vector3& point : points) {
      if (norm(point - start) <= extent) continue;
      extent = norm(point - start);
      from = point;
    }
  }
  return extent > 0 ? face.area / extent : 0;
}

const char* words_of(FaceKind kind) {
  constexpr std::array kWords{
      "a plane",          "a cylinder",           "a cone",        "a sphere",       "a torus",
      "an extruded face", "a face of revolution", "a spline face", "an offset face", "a curved face",
      "a patch",          "tagged triangles"};
  return kWords.at(static_cast<std::size_t>(kind));
}

/// Faces without quads, the largest first.
std::vector<ModelFace> bare_faces(const std::vector<ModelFace>& faces) {
  std::vector<ModelFace> bare;
  for (const ModelFace& face : faces)
    if (face.quads == std::size_t{0}) bare.push_back(face);
  std::stable_sort(bare.begin(), bare.end(),
                   [](const ModelFace& a, const ModelFace& b) { return a.area > b.area; });
  return bare;
}

std::vector<double> widths_of(const std::vector<ModelFace>& faces, const TetSolid& tets) {
  const std::vector<std::int32_t> tags = tags_of_faces(tets.mesh, tets.boundary);
  std::vector<double> widths;
  for (const ModelFace& face : faces) widths.push_back(width_of(face, tets, tags));
  return widths;
}

/// The size that fits across all of some widths, of two digits; 0 if hexahedra are not larger than all, or if
/// a width is unknown.
double size_across(const std::vector<double>& widths, double used_size) {
  if (widths.empty() || *std::ranges::max_element(widths) >= used_size) return 0;
  const double narrowest = *std::ranges::min_element(widths);
  return narrowest > 0 ? rounded_down(narrowest, 2) : 0;
}

/// Whether so many hexahedra are not made whatever walls add to them.
bool are_too_many(double size, double model_volume) {
  return model_volume / size / size / size > kMostHexahedra;
}

/// What a size that fits across faces would make. No order to take it: finer hexahedra fail more often.
std::string words_of_size_across(double size, const TetSolid& tets, const HexReport& report) {
  if (size == 0 || !(report.model_volume > 0)) return "";
  const std::string words = fmt::format("; those of {:g} would fit across", size);
  if (are_too_many(size, report.model_volume)) return words + ", but so many are not made";
  const double count = hexahedra_in(tets, size);
  return words + fmt::format(" ({}), but finer ones may have no mesh", about(count));
}

/// The size that would miss half of the volume that is noticed: it falls with the square.
double finer_size(const HexReport& report, double missed) {
  return rounded_down(std::min(report.size, report.used_size) * std::sqrt(0.5 * kNoticedVolume / missed), 2);
}

double volume_missed(const HexReport& report) {
  return report.hexahedra == 0 || report.model_volume <= 0 ? 0 : report.volume / report.model_volume - 1;
}

}  // namespace

double next_smaller_size(double size) {
  return rounded_down(kSmallerSize * size, 2);
}

TriangleMesh surface_triangles(const HexMesh& mesh) {
  TriangleMesh triangles;
  triangles.vertices = mesh.vertices;
  for (const HexMesh::Face& face : mesh.boundary) {
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : face.vertices) centre += 0.25 * mesh.vertices[v];
    const auto middle = static_cast<std::uint32_t>(triangles.vertices.size());
    triangles.vertices.push_back(centre);
    for (std::size_t k = 0; k < 4; ++k)
      triangles.triangles.push_back({face.vertices[k], face.vertices[(k + 1) % 4], middle});
  }
  return triangles;
}

Farthest farthest_from(const HexMesh& mesh, const std::vector<Vector3>& points) {
  return farthest_from(prepare_surface(CheckedMesh::derived(surface_triangles(mesh))), points);
}

std::vector<Vector3> points_on(const std::vector<Vector3>& vertices,
                               const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<Vector3> points;
  points.reserve(4 * triangles.size());
  for (const auto& triangle : triangles) {
    Vector3 centroid{0, 0, 0};
    for (const std::uint32_t v : triangle) {
      points.push_back(vertices[v]);
      centroid += (1.0 / 3) * vertices[v];
    }
    points.push_back(centroid);
  }
  return points;
}

void measure_fit(const HexMesh& mesh, const TetSolid& tets, FitTo fit_to, HexReport& report) {
  const std::vector<double> volumes = volumes_of(mesh);
  report.volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  report.area = boundary_area(mesh);
  TriangleMesh triangles;
  const GivenModel* const given = tets.mesh.given.get();
  // What is mended of a surface may have lost faces between its parts.
  if (given && (fit_to == FitTo::kCommonSurface || given->source == ModelSource::kCad)) {
    report.model = given->source;
    report.model_volume = given->size.volume;
    report.model_area = given->size.area;
    triangles.vertices = given->surface.vertices;
    triangles.triangles = given->surface.triangles;
    if (fit_to == FitTo::kEachSolid)
      triangles.triangles.insert(triangles.triangles.end(), given->between.begin(), given->between.end());
  } else {
    report.model = ModelSource::kTets;
    report.model_volume = volume_of(tets.mesh);
    report.model_area = size_of(tets.mesh.vertices, tets.boundary).area;
    triangles.vertices = tets.mesh.vertices;
    triangles.triangles = tets.boundary;
  }
  if (mesh.boundary.empty()) return;
  measure_distances(mesh, prepare_surface(CheckedMesh::derived(std::move(triangles))), tets, report);
}

void count_quads(const HexMesh& mesh, std::vector<ModelFace>& faces) {
  std::map<std::int64_t, std::pair<std::size_t, double>> of_tags;
  for (const HexMesh::Face& face : mesh.boundary) {
    auto& [quads, area] = of_tags[face.tag];
    ++quads;
    area += area_of(mesh, face);
  }
  const bool has_tags = of_tags.size() > of_tags.count(0);
  for (ModelFace& face : faces) {
    face.quads.reset();
    face.quads_area.reset();
    if (has_tags && face.solids == 1) std::tie(face.quads, face.quads_area) = of_tags[face.number];
  }
}

std::optional<Warning> faces_off(const std::vector<ModelFace>& faces, const HexReport& report) {
  // The area of a face may have the part that it shares with another solid.
  if (is_partial(report.outcome) || report.interface_faces > 0) return std::nullopt;
  std::vector<std::pair<double, const ModelFace*>> off;
  for (const ModelFace& face : faces) {
    if (face.quads.value_or(0) == 0 || face.area < report.mean_edge * report.mean_edge) continue;
    const double missed = std::abs(*face.quads_area - face.area);
    if (missed > kPoorFaceArea * face.area) off.emplace_back(-missed, &face);
  }
  if (off.empty()) return std::nullopt;
  std::ranges::stable_sort(off, {}, &std::pair<double, const ModelFace*>::first);
  const FaceNoun noun = noun_of(faces);
  std::vector<std::string> named;
  for (std::size_t k = 0; k < std::min(off.size(), kMostNamed); ++k) {
    const ModelFace& face = *off[k].second;
    named.push_back(fmt::format("{} {} by {:+.0f} % of {:.3g} around {}", noun.one, face.number,
                                100 * (*face.quads_area / face.area - 1), face.area,
                                words_of_place(face.centre, std::cbrt(report.model_volume))));
  }
  if (off.size() > kMostNamed) named.push_back(fmt::format("and {} more", off.size() - kMostNamed));
  return Warning(WarningKind::kFacesOff,
                 fmt::format("the mesh moves the smooth border of {}, and so changes the area: {}",
                             counted(off.size(), noun.one, noun.several), fmt::join(named, "; ")));
}

std::optional<Warning> faces_without_quads(const std::vector<ModelFace>& faces, const TetSolid& tets,
                                           const HexReport& report) {
  const std::vector<ModelFace> bare = bare_faces(faces);
  if (bare.empty()) return std::nullopt;
  const std::vector<double> widths = widths_of(bare, tets);
  const FaceNoun noun = noun_of(bare);
  std::string text =
      fmt::format("{} of the model {} no quads: ", counted(bare.size(), noun.one, noun.several),
                  bare.size() == 1 ? "has" : "have");
  const double extent = longest_side(box_of(tets.mesh.vertices));
  for (std::size_t k = 0; k < std::min(bare.size(), kMostNamed); ++k) {
    const ModelFace& face = bare[k];
    const bool is_patch = face.kind == FaceKind::kPatch;
    text += fmt::format("{}{} {}{} of area {:.3g}", k > 0 ? "; " : "", noun.one, face.number,
                        is_patch ? "" : fmt::format(", {}", words_of(face.kind)), face.area);
    if (widths[k] > 0) text += fmt::format(" and about {:.2g} wide", widths[k]);
    text += ", around " + words_of_place(face.centre, extent);
  }
  if (bare.size() > kMostNamed) text += fmt::format("; and {} more", bare.size() - kMostNamed);
  const double widest = *std::ranges::max_element(widths);
  if (widest > 0 && widest < report.used_size) {
    text += fmt::format("; the hexahedra of {:.3g} are larger", report.used_size);
    if (report.remedy != Remedy::kUseHexSize)
      text += words_of_size_across(size_across(widths, report.used_size), tets, report);
  }
  return Warning(WarningKind::kFacesWithoutQuads, std::move(text));
}

std::optional<double> size_for_faces(const std::vector<ModelFace>& faces, const TetSolid& tets,
                                     const HexReport& report) {
  const double size = size_across(widths_of(bare_faces(faces), tets), report.used_size);
  if (size == 0 || are_too_many(size, report.model_volume)) return std::nullopt;
  return size;
}

std::string words_of_volume(const HexReport& report) {
  const double missed = volume_missed(report);
  return fmt::format("its volume is {:.2g} % {} the model's", 100 * std::abs(missed),
                     missed < 0 ? "below" : "above");
}

std::optional<double> size_for_volume(const HexReport& report, std::size_t quads) {
  const double missed = std::abs(volume_missed(report));
  if (missed <= kPoorVolume) return std::nullopt;
  const double edge = std::min(report.used_size, std::sqrt(report.area / static_cast<double>(quads)));
  return rounded_down(edge * std::sqrt(kAimedVolume / missed), 2);
}

std::optional<Warning> poor_fit(const HexReport& report) {
  if (report.hexahedra == 0 || report.model_volume <= 0) return std::nullopt;
  const double missed = volume_missed(report);
  const bool is_off = report.largest_distance > report.largest_distance_of_model;
  const double distance = is_off ? report.largest_distance : report.largest_distance_of_model;
  const Vector3& at = is_off ? report.largest_distance_place : report.largest_distance_of_model_place;
  const bool is_whole = report.outcome == HexOutcome::kAllHex;
  std::vector<std::string> faults;
  const bool is_said = !is_partial(report.outcome) && std::abs(missed) > kPoorVolume;
  if (std::abs(missed) > kNoticedVolume && !is_said) {
    std::string fault = fmt::format("have {:.2g} % {} volume than the model", 100 * std::abs(missed),
                                    missed < 0 ? "less" : "more");
    if (is_whole) {
      const double finer = finer_size(report, std::abs(missed));
      fault += fmt::format(", those of {:g} about {:g} %", finer, 100 * 0.5 * kNoticedVolume);
    }
    faults.push_back(std::move(fault));
  }
  if (distance > kPoorDistance * report.size && report.outcome != HexOutcome::kApproximate)
    faults.push_back(fmt::format("{} by up to {:.2g}, at {}, which is {:.2g} of the size",
                                 is_off ? "are off the model's surface" : "miss parts of the model's surface",
                                 distance, words_of_place(at, std::cbrt(report.model_volume)),
                                 distance / report.size));
  if (faults.empty()) return std::nullopt;
  return Warning(WarningKind::kPoorFit, fmt::format("the hexahedra {}", fmt::join(faults, " and ")));
}

}  // namespace crossgrain
