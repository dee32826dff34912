// SPDX-License-Identifier: Apache-2.0
#include "measure/surface_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "base/required_memory.hpp"
#include "base/vector3.hpp"
#include "measure/triangle_samples.hpp"
#include "surface/bvh.hpp"

namespace crossgrain {
namespace {

/// Samples of the model are so many sizes apart.
constexpr double kSampleSpacing = 1.0 / 3;

/// Distance of a point on an edge, over its length: far above rounding.
constexpr double kOnEdge = 1e-6;

using SolidPair = std::array<std::int32_t, 2>;

/// Some triangles with their tree.
struct SearchedTriangles {
  Surface surface;
  std::optional<TriangleBvh> tree;
  std::vector<std::uint32_t> labels;

  void add(const std::array<std::uint32_t, 3>& triangle, std::uint32_t label) {
    const TriangleShape shape = shape_of(corners_of(triangle, surface.mesh.vertices));
    if (!(shape.area > 0)) return;
    surface.mesh.triangles.push_back(triangle);
    surface.normals.push_back(shape.normal);
    surface.areas.push_back(shape.area);
    labels.push_back(label);
  }

  void grow_tree() {
    surface.box = empty_box();
    for (std::size_t t = 0; t < surface.size(); ++t)
      for (const Vector3& corner : surface.corners(t)) include(surface.box, corner);
    tree.emplace(surface);
  }
};

/// Trees by pair of solids, and of all triangles for pairs that have none. They refer to themselves.
class TreesByPair {
 public:
  template <class PairOf>
  TreesByPair(const std::vector<Vector3>& vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
              std::span<const std::uint32_t> labels, const PairOf& pair_of) {
    const auto add = [&](std::unique_ptr<SearchedTriangles>& part, std::size_t t) {
      if (!part) {
        part = std::make_unique<SearchedTriangles>();
        part->surface.mesh.vertices = vertices;
      }
      part->add(triangles[t], labels[t]);
    };
    for (std::size_t t = 0; t < triangles.size(); ++t) add(parts_[pair_of(labels[t])], t);
    if (parts_.size() > 1)
      for (std::size_t t = 0; t < triangles.size(); ++t) add(all_, t);
    std::erase_if(parts_, [](const auto& entry) { return entry.second->surface.size() == 0; });
    for (auto& [pair, part] : parts_) part->grow_tree();
    if (all_ && !parts_.empty()) all_->grow_tree();
  }

  /// Of flat quads there may be none.
  bool empty() const { return parts_.empty(); }

  /// There must be some.
  const SearchedTriangles& of(const SolidPair& pair) const {
    const auto found = parts_.find(pair);
    if (found != parts_.end()) return *found->second;
    return all_ ? *all_ : *parts_.begin()->second;
  }

 private:
  std::map<SolidPair, std::unique_ptr<SearchedTriangles>> parts_;
  std::unique_ptr<SearchedTriangles> all_;
};

/// Sums of a face's normals at its vertices, weighted by area.
std::vector<std::array<Vector3, 3>> mean_normals(const Surface& face) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> corners;
  for (std::uint32_t t = 0; t < face.size(); ++t)
    for (const std::uint32_t v : face.mesh.triangles[t]) corners.push_back({v, t});
  std::sort(corners.begin(), corners.end());
  std::vector<std::array<Vector3, 3>> normals(face.size());
  for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
    Vector3 sum{0, 0, 0};
    for (; end < corners.size() && corners[end].first == corners[begin].first; ++end)
      sum += face.areas[corners[end].second] * face.normals[corners[end].second];
    for (std::size_t k = begin; k < end; ++k) {
      const auto& triangle = face.mesh.triangles[corners[k].second];
      const auto at =
          static_cast<std::size_t>(std::ranges::find(triangle, corners[k].first) - triangle.begin());
      normals[corners[k].second][at] = normalised(sum);
    }
  }
  return normals;
}

std::unique_ptr<SearchedTriangles> searched_face(const FeatureComplex& complex, std::uint32_t f) {
  auto part = std::make_unique<SearchedTriangles>();
  // Only the vertices that the face uses: there may be many faces.
  std::vector<std::uint32_t> used;
  for (const std::uint32_t t : complex.faces[f].triangles)
    used.insert(used.end(), complex.triangles[t].begin(), complex.triangles[t].end());
  sort_uniquely(used);
  for (const std::uint32_t v : used) part->surface.mesh.vertices.push_back(complex.vertices[v]);
  for (const std::uint32_t t : complex.faces[f].triangles) {
    std::array<std::uint32_t, 3> own;
    for (std::size_t k = 0; k < 3; ++k)
      own[k] =
          static_cast<std::uint32_t>(std::ranges::lower_bound(used, complex.triangles[t][k]) - used.begin());
    part->add(own, t);
  }
  if (part->surface.size() == 0) return nullptr;
  auto& normals = part->surface.mesh.corner_normals;
  if (complex.corner_normals.empty())
    normals = mean_normals(part->surface);
  else
    for (const std::uint32_t t : part->labels) normals.push_back(complex.corner_normals[t]);
  part->grow_tree();
  return part;
}

/// Quads or triangles at a time: a large triangle has thousands of samples.
constexpr std::size_t kItemsAtOnce = 16;

/// Of a sample, in sizes.
struct WeightedDistance {
  double beyond, weight;
  friend auto operator<=>(const WeightedDistance&, const WeightedDistance&) = default;
};

/// The first of several that are as large counts.
void include(DistanceFigures& figures, const Vector3& place, double distance, double beyond) {
  if (beyond > figures.largest) figures.largest = beyond, figures.place = place;
  if (distance > figures.largest_in_all) figures.largest_in_all = distance, figures.place_in_all = place;
}

/// Returns the figures of the samples of items, `count(item)` of each. visit(item, add) calls
/// add(place, weight, distance, beyond) for each of them; the last is what is beyond the distance that is
/// allowed there.
template <class Count, class Visit>
DistanceFigures figures_of(std::size_t items, double size, const Count& count, const Visit& visit) {
  std::vector<std::size_t> first(items + 1, 0);
  parallel_for(items, [&](std::size_t item) { first[item + 1] = count(item); });
  std::partial_sum(first.begin(), first.end(), first.begin());
  require_memory(static_cast<double>(first.back() * sizeof(WeightedDistance)),
                 "measuring distances between hexahedra and model", Remedy::kTakeFewerHexahedra);
  std::vector<WeightedDistance> samples(first.back());
  std::vector<DistanceFigures> of_chunks((items + kItemsAtOnce - 1) / kItemsAtOnce);
  parallel_for_chunks(items, kItemsAtOnce, [&](std::size_t begin, std::size_t end) {
    DistanceFigures& figures = of_chunks[begin / kItemsAtOnce];
    for (std::size_t item = begin; item < end; ++item)
      visit(item, [&, at = first[item]](const Vector3& place, double weight, double distance,
                                        double beyond) mutable {
        samples[at++] = {beyond / size, weight};
        include(figures, place, distance / size, beyond / size);
      });
  });
  DistanceFigures figures;
  for (const DistanceFigures& of_chunk : of_chunks) {
    include(figures, of_chunk.place, 0, of_chunk.largest);
    include(figures, of_chunk.place_in_all, of_chunk.largest_in_all, 0);
  }
  double weights = 0;
  for (const WeightedDistance& sample : samples) weights += sample.weight;
  std::ranges::sort(samples);
  double passed = 0;
  for (const WeightedDistance& sample : samples) {
    passed += sample.weight;
    if (passed < 0.99 * weights) continue;
    figures.percentile_99 = sample.beyond;
    break;
  }
  return figures;
}

/// For edge k of quad q, at 4 q + k, the largest of what the quads at it cut off: beside a rim, a flat cap
/// ends where the chords of the curved side do.
std::vector<double> cut_off_by_edges(std::span<const SurfaceQuad> quads, std::span<const double> cut_off) {
  struct QuadEdge {
    std::array<std::uint32_t, 2> vertices;
    std::size_t entry;
  };
  std::vector<QuadEdge> edges;
  edges.reserve(4 * quads.size());
  for (std::size_t q = 0; q < quads.size(); ++q) {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& vertices = quads[q].vertices;
      edges.push_back({ascending<2>({vertices[k], vertices[(k + 1) % 4]}), 4 * q + k});
    }
  }
  std::ranges::stable_sort(edges, {}, &QuadEdge::vertices);
  std::vector<double> largest(edges.size());
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    double most = 0;
    for (; end < edges.size() && edges[end].vertices == edges[begin].vertices; ++end)
      most = std::max(most, cut_off[edges[end].entry / 4]);
    for (std::size_t k = begin; k < end; ++k) largest[edges[k].entry] = most;
  }
  return largest;
}

DistanceFigures distances_of_mesh(const HexMesh& mesh, std::span<const SurfaceQuad> quads,
                                  std::span<const double> cut_off, const FeatureTrees& trees, double size) {
  const std::vector<double> by_edges = cut_off_by_edges(quads, cut_off);
  const auto count = [](std::size_t) { return std::size_t{9}; };
  return figures_of(quads.size(), size, count, [&](std::size_t q, auto add) {
    const SurfaceQuad& quad = quads[q];
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : quad.vertices) centre += 0.25 * mesh.vertices[v];
    const auto measure = [&](const Vector3& point, double weight, double allowed) {
      const double distance = trees.distance(point, quad.below, quad.above);
      add(point, weight, distance, std::max(0.0, distance - allowed));
    };
    // Neighbours share corners and edges, and their weights.
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3 &a = mesh.vertices[quad.vertices[k]], &b = mesh.vertices[quad.vertices[(k + 1) % 4]];
      measure(a, 0.25, 0);
      measure(0.5 * (a + b), 0.5, by_edges[4 * q + k]);
    }
    measure(centre, 1, cut_off[q]);
  });
}

/// Each quad as four triangles around its centre.
struct QuadTriangles {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> edge_of;  ///< edge k of quad q is 4 q + k

  QuadTriangles(const HexMesh& mesh, std::span<const SurfaceQuad> quads) : vertices(mesh.vertices) {
    for (std::uint32_t q = 0; q < quads.size(); ++q) {
      Vector3 centre{0, 0, 0};
      for (const std::uint32_t v : quads[q].vertices) centre += 0.25 * mesh.vertices[v];
      const auto middle = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(centre);
      for (std::size_t k = 0; k < 4; ++k) {
        triangles.push_back({quads[q].vertices[k], quads[q].vertices[(k + 1) % 4], middle});
        edge_of.push_back(4 * q + static_cast<std::uint32_t>(k));
      }
    }
  }
};

DistanceFigures distances_of_model(const HexMesh& mesh, std::span<const SurfaceQuad> quads,
                                   std::span<const double> cut_off, const FeatureComplex& complex,
                                   double size) {
  const QuadTriangles cut(mesh, quads);
  const TreesByPair trees(cut.vertices, cut.triangles, cut.edge_of, [&](std::uint32_t edge) {
    return SolidPair{quads[edge / 4].below, quads[edge / 4].above};
  });
  const std::vector<double> by_edges = cut_off_by_edges(quads, cut_off);
  if (trees.empty()) return {.percentile_99 = INFINITY, .largest = INFINITY, .largest_in_all = INFINITY};
  const double spacing = kSampleSpacing * size;
  const auto count = [&](std::size_t t) {
    std::size_t samples = 0;
    for_each_sample(complex.points_of(t), spacing, [&](const Vector3&, double) { ++samples; });
    return samples;
  };
  return figures_of(complex.triangles.size(), size, count, [&](std::size_t t, auto add) {
    const FeatureComplex::Face& face = complex.faces[complex.face_of[t]];
    const SearchedTriangles& part = trees.of({face.below, face.above});
    for_each_sample(complex.points_of(t), spacing, [&](const Vector3& place, double weight) {
      const NearestPoint nearest = part.tree->nearest(place);
      const double distance = std::sqrt(nearest.squared_distance);
      const std::uint32_t edge = part.labels[nearest.triangle];
      const auto [a, b, centre] = part.surface.corners(nearest.triangle);
      const bool is_on_edge = distance_to_segment(nearest.point, a, b) <= kOnEdge * norm(b - a);
      add(place, weight, distance,
          std::max(0.0, distance - (is_on_edge ? by_edges[edge] : cut_off[edge / 4])));
    });
  });
}

}  // namespace

struct FeatureTrees::Trees {
  TreesByPair by_pair;
  std::vector<std::unique_ptr<SearchedTriangles>> of_face;
};

FeatureTrees::FeatureTrees(const FeatureComplex& complex)
    : trees_(std::make_unique<const Trees>(Trees{
          TreesByPair(complex.vertices, complex.triangles, complex.face_of,
                      [&](std::uint32_t f) {
                        return SolidPair{complex.faces[f].below, complex.faces[f].above};
                      }),
          [&] {
            std::vector<std::unique_ptr<SearchedTriangles>> parts(complex.faces.size());
            parallel_for(
                parts.size(),
                [&](std::size_t f) { parts[f] = searched_face(complex, static_cast<std::uint32_t>(f)); }, 1);
            return parts;
          }()})) {}

FeatureTrees::~FeatureTrees() = default;

std::uint32_t FeatureTrees::nearest_face(const Vector3& point, std::int32_t below, std::int32_t above) const {
  const SearchedTriangles& part = trees_->by_pair.of({below, above});
  return part.labels[part.tree->nearest(point).triangle];
}

double FeatureTrees::distance(const Vector3& point, std::int32_t below, std::int32_t above) const {
  return std::sqrt(trees_->by_pair.of({below, above}).tree->nearest(point).squared_distance);
}

Vector3 FeatureTrees::normal_on_face(std::uint32_t face, const Vector3& point) const {
  const auto& part = trees_->of_face[face];
  if (!part) return {0, 0, 0};
  const NearestPoint nearest = part->tree->nearest(point);
  return part->surface.normal_at(nearest.triangle, nearest.point);
}

std::vector<double> cut_off_by_quads(const HexMesh& mesh, std::span<const SurfaceQuad> quads,
                                     std::span<const std::uint32_t> face_of_quad, const FeatureTrees& trees) {
  std::vector<double> cut_off(quads.size(), 0);
  parallel_for(quads.size(), [&](std::size_t q) {
    if (face_of_quad[q] == FeatureComplex::kNone) return;
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector3 &a = mesh.vertices[quads[q].vertices[k]], &b = mesh.vertices[quads[q].vertices[k + 2]];
      const Vector3 turn =
          trees.normal_on_face(face_of_quad[q], b) - trees.normal_on_face(face_of_quad[q], a);
      // |turn . (b - a)| is k d^2.
      cut_off[q] += std::abs(dot(turn, b - a)) / 16;
    }
  });
  return cut_off;
}

SurfaceDistances surface_distances(const HexMesh& mesh, std::span<const SurfaceQuad> quads,
                                   std::span<const double> cut_off, const FeatureComplex& complex,
                                   const FeatureTrees& trees, double size) {
  if (quads.empty()) return {};
  return {distances_of_mesh(mesh, quads, cut_off, trees, size),
          distances_of_model(mesh, quads, cut_off, complex, size)};
}

}  // namespace crossgrain
