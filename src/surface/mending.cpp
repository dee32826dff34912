// SPDX-License-Identifier: Apache-2.0
#include "surface/mending.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/place.hpp"
#include "surface/duplicates.hpp"
#include "surface/edge_uses.hpp"
#include "surface/patch_sides.hpp"
#include "surface/patches.hpp"

namespace crossgrain {
namespace {

Vector3 centroid_of(const TriangleMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return (1.0 / 3) * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]);
}

Vector3 middle_of(const TriangleMesh& mesh, const EdgeUse& use) {
  return 0.5 * (mesh.vertices[use.low()] + mesh.vertices[use.high()]);
}

/// The parts of a mesh: sets of triangles connected through edges, numbered in the order of their first
/// triangles. Collapsed triangles have no part.
struct Parts {
  std::vector<std::uint32_t> of;
  std::size_t count = 0;
};

Parts parts_of(std::size_t triangles, std::span<const EdgeUse> uses) {
  DisjointSets sets(triangles);
  std::vector<bool> takes_part(triangles);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    for (const EdgeUse& use : edge) {
      sets.join(edge[0].triangle, use.triangle);
      takes_part[use.triangle] = true;
    }
  });
  Parts parts{std::vector<std::uint32_t>(triangles, kNoPart), 0};
  for (std::uint32_t t = 0; t < triangles; ++t) {
    if (!takes_part[t]) continue;
    const std::uint32_t root = sets.root(t);
    if (root == t) parts.of[t] = static_cast<std::uint32_t>(parts.count++);
    parts.of[t] = parts.of[root];
  }
  return parts;
}

/// Mean thickness, relative to the square root of the area, below which a part is a flat sheet with two
/// sides.
constexpr double kFlat = 1e-9;

/// Returns 1 or -1 if the volumes of all parts of a closed mesh have this sign and no part is flat; otherwise
/// 0.
int common_orientation(const TriangleMesh& mesh, const Parts& parts) {
  std::vector<double> volumes(parts.count), areas(parts.count);
  std::vector<Vector3> origins(parts.count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t part = parts.of[t];
    if (part == kNoPart) continue;
    const auto& [a, b, c] = mesh.triangles[t];
    if (areas[part] == 0) origins[part] = mesh.vertices[a];
    const Vector3& o = origins[part];
    const Vector3 to_a = mesh.vertices[a] - o, to_b = mesh.vertices[b] - o, to_c = mesh.vertices[c] - o;
    volumes[part] += dot(to_a, cross(to_b, to_c)) / 6;
    areas[part] += norm(cross(to_b - to_a, to_c - to_a)) / 2;
  }
  bool outward = true, inward = true;
  for (std::size_t p = 0; p < parts.count; ++p) {
    const double flat = 0.5 * kFlat * areas[p] * std::sqrt(areas[p]);
    outward &= volumes[p] > flat;
    inward &= volumes[p] < -flat;
  }
  return outward ? 1 : inward ? -1 : 0;
}

/// Repairs a mesh. Triangles keep their numbers until the end.
class Mender {
 public:
  explicit Mender(TriangleMesh mesh) : mesh_(std::move(mesh)) {
    areas_.resize(mesh_.triangles.size());
    parallel_for(areas_.size(), [&](std::size_t t) {
      areas_[t] = shape_of(corners_of(mesh_.triangles[t], mesh_.vertices)).area;
    });
  }

  MendedSurface mend(const SurfaceTopology& topology) {
    result_.topology = topology;
    roles_ = find_duplicates(mesh_, result_.findings);
    orient_within_patches();
    const std::vector<std::uint32_t> kept = kept_triangles();
    if (kept.empty()) prepare_surface(CheckedMesh::derived(mesh_));  // throws the Error
    judge(kept);
    finish();
    return std::move(result_);
  }

 private:
  /// Returns the edges of surface triangles, except those left out once `left_out_` is set, unless asked for.
  std::vector<EdgeUse> edge_uses(bool with_left_out = false) const {
    auto triangles = mesh_.triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const bool is_left_out = !with_left_out && !left_out_.empty() && left_out_[t];
      if (roles_[t] != TriangleRole::kSurface || is_left_out) triangles[t] = {0, 0, 0};
    }
    return sorted_edge_uses(triangles);
  }

  void orient_within_patches() {
    const std::vector<EdgeUse> uses = edge_uses();
    open_ = find_open_edges(mesh_.vertices, uses, longest_side(box_of_solid_triangles(mesh_)));
    report_shared_edges(uses);
    Patches found = find_patches(mesh_.vertices, uses, open_, areas_);
    patches_ = std::move(found.patches);
    patch_of_.assign(mesh_.triangles.size(), kNoPatch);
    Tally flipped;
    for (std::uint32_t p = 0; p < patches_.size(); ++p) {
      for (const std::uint32_t t : patches_[p].triangles) {
        patch_of_[t] = p;
        if (!found.turned[t]) continue;
        turn_triangle(mesh_, t);
        if (!patches_[p].one_sided && areas_[t] > 0) flipped.add(centroid_of(mesh_, t));
      }
    }
    flipped.report(result_.findings, FindingKind::kFlippedFacet);
  }

  void report_shared_edges(const std::vector<EdgeUse>& uses) {
    Tally soup, nonmanifold;
    bool any_shared = false;
    for_each_edge(std::span(uses), [&](std::span<const EdgeUse> edge) {
      any_shared |= edge.size() > 1;
      if (edge.size() > 2) nonmanifold.add(middle_of(mesh_, edge[0]));
    });
    nonmanifold.report(result_.findings, FindingKind::kNonmanifoldEdge);
    if (any_shared || uses.size() <= 3) return;
    soup.add(centroid_of(mesh_, uses[0].triangle), uses.size() / 3);
    soup.report(result_.findings, FindingKind::kTriangleSoup);
  }

  std::vector<std::uint32_t> kept_triangles() const {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      if (roles_[t] != TriangleRole::kDropped && areas_[t] > 0) kept.push_back(t);
    return kept;
  }

  /// Returns whether nearly all triangles lie alone though cracks are joined. By chance some of them enclose
  /// a little, the more of them the sooner, which is no solid.
  bool is_scattered(std::size_t triangles) const {
    constexpr double kNearlyAll = 0.9;
    const auto alone = std::count_if(patches_.begin(), patches_.end(), [](const Patch& patch) {
      return patch.triangles.size() == 1 && patch.nonmanifold_edges == 0;
    });
    return alone > 1 && static_cast<double>(alone) > kNearlyAll * static_cast<double>(triangles);
  }

  void judge(const std::vector<std::uint32_t>& kept) {
    if (is_scattered(kept.size())) fail_without_inside(kept.size());
    std::vector<std::uint32_t> patch_of;
    for (const std::uint32_t t : kept) patch_of.push_back(patch_of_[t]);
    const PatchSides sides = judge_patches(selected_triangles(mesh_, kept), patch_of, patches_);
    left_out_.assign(mesh_.triangles.size(), false);
    for (std::size_t k = 0; k < kept.size(); ++k) left_out_[kept[k]] = sides.left_out[k];
    for (std::uint32_t p = 0; p < patches_.size(); ++p) {
      for (const std::uint32_t t : patches_[p].triangles) {
        if (sides.flipped[p]) turn_triangle(mesh_, t);
        if (sides.stray[p]) left_out_[t] = true;
      }
    }
    report_patches(sides);
    // The boundary of a sheet that is left out is not a hole.
    std::erase_if(open_.edges, [&](const EdgeUse& use) { return left_out_[use.triangle]; });
    std::erase_if(open_.cracks, [&](const CrackSide& side) { return left_out_[side.edge.triangle]; });
    report_open_edges(mesh_.vertices, open_, result_.findings);
    result_.open_loops = open_loops(mesh_.vertices, open_);
    for (const std::uint32_t t : kept)
      if (!left_out_[t]) rest_.push_back(t);
    if (rest_.empty()) fail_without_inside(kept.size());
  }

  void report_patches(const PatchSides& sides) {
    Tally inside_out, one_sided, sheets, strays, walls;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      const Patch& patch = patches_[p];
      const Vector3 place = centroid_of(mesh_, patch.triangles[0]);
      const bool is_turned = !sides.stray[p] && sides.flipped[p] != sides.inside_out;
      if (is_turned && !patch.one_sided && patch.turned_share <= kUndecided) inside_out.add(place);
      if (patch.one_sided) {
        one_sided.add(patch.one_sided_place);
      } else if (sides.stray[p] && (patch.nonmanifold_edges > 0 || patch.triangles.size() == 1)) {
        strays.add(place, patch.triangles.size());
      } else if (sides.stray[p]) {
        sheets.add(place);
      }
    }
    // Both triangles of a wall are treated alike and count once.
    std::size_t halves = 0;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (roles_[t] != TriangleRole::kInternalSheet || areas_[t] == 0 || halves++ % 2 == 1) continue;
      (left_out_[t] ? strays : walls).add(centroid_of(mesh_, t));
    }
    walls.report(result_.findings, FindingKind::kInternalSheet);
    inside_out.report(result_.findings, FindingKind::kInsideOutPart);
    one_sided.report(result_.findings, FindingKind::kOneSidedSheet);
    sheets.report(result_.findings, FindingKind::kOpenSheet);
    strays.report(result_.findings, FindingKind::kStrayFacet);
  }

  [[noreturn]] void fail_without_inside(std::size_t triangles) const {
    const auto count = [&](FindingKind kind) {
      const Finding* finding = find(result_.findings, kind);
      return finding == nullptr ? 0 : finding->count;
    };
    const std::string all = std::to_string(triangles) + (triangles == 1 ? " triangle" : " triangles");
    std::string what;
    if (result_.topology.watertight) {
      what = "it is flat";
    } else if (count(FindingKind::kTriangleSoup) > 0) {
      what = "it is a soup of " + all + ", no two of which share an edge";
    } else if (is_scattered(triangles)) {
      what = "it is a soup of " + all + ", nearly all of which share no edge";
    } else if (count(FindingKind::kOneSidedSheet) > 0) {
      what = "it is a one-sided sheet of " + all + ", such as a Moebius band";
    } else if (count(FindingKind::kStrayFacet) > 0) {
      what =
          "it is " + all +
          (triangles == 1 ? " that lies around no volume" : " that meet at edges and lie around no volume");
    } else {
      what = "it is an open sheet of " + all + words_of_rim();
    }
    throw Error(ErrorKind::kInput, "the surface encloses nothing: " + what, Remedy::kCloseSurface);
  }

  /// Of the longest rim: ", open along 12.5 around 1 2 3".
  std::string words_of_rim() const {
    const std::vector<EdgeUse> uses = edge_uses(/*with_left_out=*/true);
    const double size = longest_side(box_of_solid_triangles(mesh_));
    const auto rims = open_loops(mesh_.vertices, find_open_edges(mesh_.vertices, uses, size));
    const auto longest = std::ranges::max_element(rims, {}, &OpenLoop::length);
    if (longest == rims.end()) return "";
    return fmt::format(", open along {:.4g} around {}", longest->length,
                       words_of_place(longest->middle, size));
  }

  void finish() {
    const std::vector<EdgeUse> uses = edge_uses();
    const Parts parts = parts_of(mesh_.triangles.size(), uses);
    std::vector<bool> is_open(parts.count);
    result_.closed = !uses.empty();
    for_each_edge(std::span(uses), [&](std::span<const EdgeUse> edge) {
      std::ptrdiff_t balance = 0;
      for (const EdgeUse& use : edge) balance += use.forward ? 1 : -1;
      if (balance == 0) return;
      result_.closed = false;
      for (const EdgeUse& use : edge) is_open[parts.of[use.triangle]] = true;
    });
    Tally degenerate;
    for (std::size_t t = 0; t < areas_.size(); ++t)
      if (areas_[t] == 0) degenerate.add(mesh_.vertices[mesh_.triangles[t][0]]);
    degenerate.report(result_.findings, FindingKind::kDegenerateTriangle);
    result_.parts = parts.count;
    for (const std::uint32_t t : rest_) {
      const std::uint32_t part = parts.of[t];
      result_.part_of.push_back(part == kNoPart || is_open[part] ? kNoPart : part);
    }
    if (parts.count < 2) result_.part_of.clear();
    result_.surface = prepare_surface(CheckedMesh::derived(selected_triangles(mesh_, rest_)));
    result_.surface.degenerate_triangles = degenerate.count();
    std::sort(result_.findings.begin(), result_.findings.end(),
              [](const Finding& a, const Finding& b) { return a.kind < b.kind; });
  }

  TriangleMesh mesh_;
  std::vector<double> areas_;
  std::vector<TriangleRole> roles_;
  std::vector<bool> left_out_;
  OpenEdges open_;
  std::vector<Patch> patches_;
  std::vector<std::uint32_t> patch_of_, rest_;
  MendedSurface result_;
};

/// Returns a closed, consistently oriented mesh unchanged, with its findings.
MendedSurface as_it_is(TriangleMesh mesh, const SurfaceTopology& topology, const Parts& parts,
                       int orientation) {
  MendedSurface result;
  result.topology = topology;
  result.closed = true;
  Tally degenerate, inside_out;
  std::vector<std::uint8_t> has_area(mesh.triangles.size());
  parallel_for(has_area.size(), [&](std::size_t t) {
    has_area[t] = shape_of(corners_of(mesh.triangles[t], mesh.vertices)).area > 0;
  });
  for (std::size_t t = 0; t < has_area.size(); ++t)
    if (has_area[t] == 0) degenerate.add(mesh.vertices[mesh.triangles[t][0]]);
  if (orientation < 0) inside_out.add(centroid_of(mesh, 0), parts.count);
  degenerate.report(result.findings, FindingKind::kDegenerateTriangle);
  inside_out.report(result.findings, FindingKind::kInsideOutPart);
  result.surface = prepare_surface(CheckedMesh::derived(std::move(mesh)));
  result.parts = parts.count;
  if (parts.count < 2) return result;
  for (std::size_t t = 0; t < has_area.size(); ++t)
    if (has_area[t] != 0) result.part_of.push_back(parts.of[t]);
  return result;
}

/// Returns the mesh unchanged, by a move, if it is closed and all its parts have the same orientation. Parts
/// without common vertices may still touch each other, which requires welding.
std::optional<MendedSurface> if_sound(TriangleMesh& mesh, bool is_welded) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  const SurfaceTopology topology = analyse_topology(mesh, uses);
  if (!topology.watertight) return std::nullopt;
  const Parts parts = parts_of(mesh.triangles.size(), uses);
  if (parts.count > 1 && !is_welded && has_equal_vertices(mesh)) return std::nullopt;
  const int orientation = common_orientation(mesh, parts);
  if (orientation == 0) return std::nullopt;
  return as_it_is(std::move(mesh), topology, parts, orientation);
}

}  // namespace

MendedSurface mend_surface(CheckedMesh checked) {
  TriangleMesh mesh = *std::move(checked);
  if (auto whole = if_sound(mesh, false)) return std::move(*whole);
  const std::size_t vertices = mesh.vertices.size();
  TriangleMesh welded = weld(std::move(mesh));
  if (welded.vertices.size() < vertices)
    if (auto whole = if_sound(welded, true)) return std::move(*whole);
  const SurfaceTopology topology = analyse_topology(welded);
  return Mender(std::move(welded)).mend(topology);
}

}  // namespace crossgrain
