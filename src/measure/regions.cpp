// SPDX-License-Identifier: Apache-2.0
#include "measure/regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <span>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/place.hpp"
#include "surface/bvh.hpp"
#include "surface/solid_split.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

bool holds(const Box& box, const Vector3& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (point[axis] < box.low[axis] || point[axis] > box.high[axis]) return false;
  }
  return true;
}

/// One solid with its own winding number. Must not be moved: the tree refers to the surface.
struct SolidBody {
  std::int32_t number;
  Surface surface;
  TriangleBvh bvh;
  WindingNumber winding;
  double volume;

  SolidBody(std::int32_t solid, TriangleMesh mesh)
      : number(solid),
        surface(prepare_surface(CheckedMesh::derived(std::move(mesh)))),
        bvh(surface),
        winding(bvh),
        volume(enclosed_volume(surface)) {}
  SolidBody(const SolidBody&) = delete;
  SolidBody& operator=(const SolidBody&) = delete;
};

/// The triangles of each solid that have an area, with vertices of their own; solids ascending.
std::vector<std::unique_ptr<SolidBody>> bodies_of(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (shape_of(corners_of(mesh.triangles[t], mesh.vertices)).area > 0) order.push_back(t);
  }
  std::ranges::stable_sort(order,
                           [&](std::uint32_t a, std::uint32_t b) { return mesh.solids[a] < mesh.solids[b]; });
  std::vector<std::unique_ptr<SolidBody>> bodies;
  std::vector<std::uint32_t> new_index(mesh.vertices.size(), kNone);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const std::int32_t solid = mesh.solids[order[begin]];
    TriangleMesh own;
    std::vector<std::uint32_t> used;
    for (; end < order.size() && mesh.solids[order[end]] == solid; ++end) {
      auto triangle = mesh.triangles[order[end]];
      for (std::uint32_t& v : triangle) {
        if (new_index[v] == kNone) {
          new_index[v] = static_cast<std::uint32_t>(own.vertices.size());
          own.vertices.push_back(mesh.vertices[v]);
          used.push_back(v);
        }
        v = new_index[v];
      }
      own.triangles.push_back(triangle);
    }
    for (const std::uint32_t v : used) new_index[v] = kNone;
    bodies.push_back(std::make_unique<SolidBody>(solid, std::move(own)));
  }
  return bodies;
}

/// The body of a leaf, and whether it is also in others.
struct Claim {
  std::uint32_t body;
  bool contested;
};

class RegionFinder {
 public:
  RegionFinder(const TriangleMesh& mesh, const Surface& outer, const GridLevel& level)
      : bodies_(bodies_of(mesh)), outer_(outer), level_(level) {}

  const std::vector<std::unique_ptr<SolidBody>>& bodies() const { return bodies_; }

  /// Outer triangles with another solid on their other side.
  struct Contacts {
    std::size_t triangles = 0, pairs_of_solids = 0;
    std::int32_t solid = 0, other_solid = 0;  ///< of the first triangle
    Vector3 place{};                          ///< of the first triangle
  };
  Contacts contacts() const {
    const double step = kBeside * longest_side(outer_.box);
    std::vector<std::uint32_t> beyond(outer_.size(), kNone);
    parallel_for(outer_.size(), [&](std::size_t t) {
      const std::size_t own = body_of(outer_.mesh.solids[t]);
      const double outward = bodies_[own]->winding.flipped() ? -step : step;
      const Vector3 beside = centroid(t) + outward * outer_.normals[t];
      for (std::uint32_t b = 0; b < bodies_.size() && beyond[t] == kNone; ++b) {
        if (b != own && holds(bodies_[b]->surface.box, beside) && bodies_[b]->winding.inside(beside))
          beyond[t] = b;
      }
    });
    Contacts result;
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t t = 0; t < beyond.size(); ++t) {
      if (beyond[t] == kNone) continue;
      const std::size_t own = body_of(outer_.mesh.solids[t]), other = beyond[t];
      pairs.insert(std::minmax(own, other));
      if (result.triangles++ > 0) continue;
      result.solid = bodies_[own]->number;
      result.other_solid = bodies_[other]->number;
      result.place = centroid(t);
    }
    result.pairs_of_solids = pairs.size();
    return result;
  }

  Claim claim(CellIndex leaf) const {
    const Claim around = level_.centre_inside(leaf) ? around_centre(leaf) : Claim{kNone, false};
    if (around.body != kNone) return around;
    return {level_.holds_surface(leaf) ? of_most_surface(leaf) : likeliest_at(level_.tree.centre(leaf)),
            false};
  }

 private:
  /// Share of the longest side: above the rounding of coordinates, below all cells.
  static constexpr double kBeside = 1e-7;

  /// Solids that touch reach into each other by the distance of their triangles from the true surface, which
  /// is at most a tenth of a cell for CAD files.
  static constexpr double kTouchingCells = 0.25;

  Vector3 centroid(std::size_t triangle) const {
    const auto [a, b, c] = outer_.corners(triangle);
    return (1.0 / 3) * (a + b + c);
  }

  Claim around_centre(CellIndex leaf) const {
    const Vector3 centre = level_.tree.centre(leaf);
    const double reach = kTouchingCells * level_.tree.cell_size(leaf);
    Claim claim{kNone, false};
    int deep = 0;  // bodies that hold the centre deeper than touching ones do
    double closest = -INFINITY;
    std::uint32_t likeliest = kNone;
    for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
      if (!holds(bodies_[b]->surface.box, centre)) continue;
      const double winding = bodies_[b]->winding.at(centre);
      if (winding > closest) closest = winding, likeliest = b;
      if (winding <= 0.5) continue;
      deep += bodies_[b]->bvh.nearest(centre).squared_distance > reach * reach;
      claim.contested = deep > 1;
      if (claim.body == kNone || bodies_[b]->volume < bodies_[claim.body]->volume) claim.body = b;
    }
    if (claim.body == kNone) claim.body = likeliest;
    return claim;
  }

  /// Beside the cap over a hole, where a point may be in no solid: the one that winds around it most.
  std::uint32_t likeliest_at(const Vector3& point) const {
    std::vector<double> windings;
    for (const auto& body : bodies_) windings.push_back(body->winding.at(point));
    return static_cast<std::uint32_t>(std::ranges::max_element(windings) - windings.begin());
  }

  std::uint32_t of_most_surface(CellIndex leaf) const {
    std::vector<double> areas(bodies_.size());
    for (const SurfacePiece& piece : level_.pieces_of(leaf))
      areas[body_of(outer_.mesh.solids[piece.triangle])] += piece.area;
    return static_cast<std::uint32_t>(std::ranges::max_element(areas) - areas.begin());
  }

  std::size_t body_of(std::int32_t solid) const {
    const auto found =
        std::ranges::lower_bound(bodies_, solid, {}, [](const auto& body) { return body->number; });
    return static_cast<std::size_t>(found - bodies_.begin());
  }

  std::vector<std::unique_ptr<SolidBody>> bodies_;
  const Surface& outer_;
  const GridLevel& level_;
};

/// Leaves in several solids.
struct Contested {
  std::size_t count = 0;
  Vector3 first{};  ///< centre of the first of them
};

/// `contested` is 1 for such own leaves. Returns those of all processes.
Contested contested_leaves(const std::vector<std::uint8_t>& contested, const GridLevel& level) {
  const Share share = level.share();
  Contested here;
  here.count = static_cast<std::size_t>(std::ranges::count(contested, 1));
  const auto first = std::ranges::find(contested, 1);
  if (here.count > 0)
    here.first = level.tree.centre(static_cast<CellIndex>(share.begin + (first - contested.begin())));
  Contested all;
  for (const Contested& part : of_each(share, here)) {
    if (all.count == 0) all.first = part.first;
    all.count += part.count;
  }
  return all;
}

}  // namespace

CellRegions find_regions(const TriangleMesh& mesh, const Surface& outer, const GridLevel& level) {
  CellRegions result;
  if (!has_several_solids(mesh)) return result;
  const RegionFinder finder(mesh, outer, level);
  const Share share = level.share();
  std::vector<std::uint8_t> contested(share.size());
  result.of_leaf.resize(level.size());
  std::vector<std::uint32_t> body(share.size());
  parallel_for(share.size(), [&](std::size_t i) {
    const auto leaf = static_cast<CellIndex>(share.begin + i);
    const Claim claim = finder.claim(leaf);
    body[i] = claim.body;
    contested[i] = claim.contested;
    result.of_leaf[leaf] = finder.bodies()[claim.body]->number;
  });
  std::vector<std::size_t> cells(finder.bodies().size());
  for (const std::uint32_t b : body) ++cells[b];
  add_up(share, std::span(cells));
  for (std::size_t b = 0; b < cells.size(); ++b)
    result.regions.push_back({finder.bodies()[b]->number, cells[b], finder.bodies()[b]->volume});

  const Contested overlap = contested_leaves(contested, level);
  if (overlap.count > 0) {
    result.warnings.emplace_back(
        WarningKind::kOverlappingSolids,
        fmt::format("solids overlap: cells in more than one: {}, the first around {}; they count for the "
                    "smallest of them, and the surfaces of all constrain frames there",
                    overlap.count, words_of_place(overlap.first, longest_side(outer.box))),
        Remedy::kSeparateSolids);
  } else if (const RegionFinder::Contacts contacts = finder.contacts(); contacts.triangles > 0) {
    result.warnings.emplace_back(
        WarningKind::kTouchingSolids,
        fmt::format(
            "solids touch by faces that are not the same triangles: {} of solids, {}, the first of solid {} "
            "against solid {} around {}; both surfaces constrain frames there, also where "
            "solids are united",
            counted(contacts.pairs_of_solids, "pair"), counted(contacts.triangles, "triangle"),
            contacts.solid, contacts.other_solid, words_of_place(contacts.place, longest_side(outer.box))),
        Remedy::kGlueSolids);
  }
  const auto empty = [](const SolveReport::Region& region) { return region.cells == 0; };
  const auto none = std::ranges::find_if(result.regions, empty);
  if (none != result.regions.end()) {
    result.warnings.emplace_back(
        WarningKind::kEmptySolids,
        fmt::format("solids too small to hold a cell: {} of {}, the first is region {}",
                    std::ranges::count_if(result.regions, empty), result.regions.size(), none->region),
        Remedy::kRaiseResolution);
  }
  return result;
}

}  // namespace crossgrain
