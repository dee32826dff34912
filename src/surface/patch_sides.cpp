// SPDX-License-Identifier: Apache-2.0
#include "surface/patch_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/bvh.hpp"
#include "surface/surface.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {
namespace {

/// Smallest |own| of a patch that encloses a volume: half of the 1/2 of a closed patch. A half sphere has
/// 0.25 to 0.35.
constexpr double kCurvesRound = 0.25;

/// A sheet bounds a solid if the winding numbers on its two sides are within this distance of 0 and of 1, or
/// of 2 and more where sheets lie on each other.
constexpr double kBounds = 0.25;

/// Number of triangles of a patch that are tested; the median decides.
constexpr std::size_t kLooks = 7;

/// Distance of the test points from the triangle, in units of the square root of its area. It is far above
/// rounding and below the thickness of any wall, since thinner walls count as flat.
constexpr double kStepOff = 1e-6;

/// A test costs microseconds, but among large triangles that all cross each other its cost grows with their
/// number.
constexpr std::size_t kMostPatches = 3000;

/// Largest number of rounds, since flips and removals influence each other. Two or three suffice in practice.
constexpr int kMostRounds = 8;

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the share of the full sphere that a triangle covers as seen from p, positive from behind (Van
/// Oosterom and Strackee 1983).
double winding_of(const std::array<Vector3, 3>& corners, const Vector3& p) {
  const Vector3 a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
  const double la = norm(a), lb = norm(b), lc = norm(c);
  const double denominator = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return std::atan2(dot(a, cross(b, c)), denominator) / (2 * std::numbers::pi);
}

/// Winding numbers at a patch.
struct View {
  double own = 0, others = 0;
  double step = 1;   ///< from one side to the other: 2 where another one lies on it, 1 at least
  bool any = false;  ///< the patch still has triangles
};

class PatchJudge {
 public:
  PatchJudge(const TriangleMesh& mesh, const std::vector<std::uint32_t>& patch_of,
             const std::vector<Patch>& patches)
      : mesh_(mesh), patch_of_(patch_of), patches_(patches) {
    sides_.flipped.resize(patches.size());
    sides_.stray.resize(patches.size());
    sides_.left_out.resize(mesh.triangles.size());
  }

  PatchSides judge() {
    for (int round = 0; round < kMostRounds; ++round) {
      gather();
      if (rest_.empty()) break;
      const Surface surface = prepare_surface(CheckedMesh::derived(selected_triangles(mesh_, rest_)));
      const TriangleBvh bvh(surface);
      const WindingNumber winding(bvh);
      sides_.inside_out = winding.flipped();
      if (patches_.size() > kMostPatches) break;
      const std::vector<View> views = look(surface, winding);
      if (flip(views)) continue;
      const bool strays = leave_out_strays(views), sheets = leave_out_sheets(surface, winding);
      if (!strays && !sheets) break;
    }
    return std::move(sides_);
  }

 private:
  /// Collects the triangles that are left, and those of each patch among them.
  void gather() {
    rest_.clear();
    members_.assign(patches_.size(), {});
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (sides_.left_out[t]) continue;
      if (patch_of_[t] != kNoPatch)
        members_[patch_of_[t]].push_back(static_cast<std::uint32_t>(rest_.size()));
      rest_.push_back(t);
    }
  }

  /// Returns triangles that are spread evenly over the area of the patch.
  std::vector<std::uint32_t> looks_of(const Surface& surface,
                                      const std::vector<std::uint32_t>& members) const {
    double area = 0;
    for (const std::uint32_t t : members) area += surface.areas[t];
    std::vector<std::uint32_t> looks;
    double passed = 0;
    const std::size_t wanted = std::min(kLooks, members.size());
    for (const std::uint32_t t : members) {
      passed += surface.areas[t];
      const double next = area * (static_cast<double>(looks.size()) + 0.5) / static_cast<double>(wanted);
      if (looks.size() < wanted && passed >= next) looks.push_back(t);
    }
    return looks;
  }

  /// The winding numbers on the outer and the inner side of a triangle.
  static std::array<double, 2> on_both_sides(const Surface& surface, std::uint32_t t,
                                             const auto& winding_at) {
    const auto [a, b, c] = surface.corners(t);
    const Vector3 centre = (1.0 / 3) * (a + b + c);
    const Vector3 off = kStepOff * std::sqrt(surface.areas[t]) * surface.normals[t];
    return {winding_at(centre + off), winding_at(centre - off)};
  }

  static double at_both_sides(const Surface& surface, std::uint32_t t, const auto& winding_at) {
    const auto [outer, inner] = on_both_sides(surface, t, winding_at);
    return 0.5 * (outer + inner);
  }

  static double own_winding(const Surface& surface, std::uint32_t look,
                            const std::vector<std::uint32_t>& members) {
    return at_both_sides(surface, look, [&](const Vector3& x) {
      double sum = 0;
      for (const std::uint32_t t : members) sum += winding_of(surface.corners(t), x);
      return sum;
    });
  }

  std::vector<View> look(const Surface& surface, const WindingNumber& winding) const {
    const double sign = winding.flipped() ? -1 : 1;
    std::vector<View> views(patches_.size());
    parallel_for(
        patches_.size(),
        [&](std::size_t p) {
          if (members_[p].empty()) return;
          const std::vector<std::uint32_t> looks = looks_of(surface, members_[p]);
          std::vector<double> all(looks.size()), steps(looks.size());
          parallel_for(
              looks.size(),
              [&](std::size_t k) {
                const auto [outer, inner] =
                    on_both_sides(surface, looks[k], [&](const Vector3& x) { return winding.at(x); });
                all[k] = 0.5 * (outer + inner);
                steps[k] = std::abs(inner - outer);
              },
              1);
          std::vector<double> owns = all;
          if (members_[p].size() < rest_.size()) {
            parallel_for(
                looks.size(),
                [&](std::size_t k) { owns[k] = sign * own_winding(surface, looks[k], members_[p]); }, 1);
          }
          views[p].own = median(owns);
          views[p].others = median(all) - views[p].own;
          views[p].step = std::max(1.0, std::round(median(steps)));
          views[p].any = true;
        },
        1);
    return views;
  }

  bool is_wrong_way_round(const Patch& patch, const View& view) const {
    if (!view.any || std::abs(view.own) < kCurvesRound) return false;
    const int around = static_cast<int>(std::lround(view.others));
    if (around <= -1) return true;
    if (around == 0) return view.own < 0;
    return patch.turned_share > kUndecided && (view.own > 0) == (around % 2 == 1);
  }

  bool flip(const std::vector<View>& views) {
    bool any = false;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      if (!is_wrong_way_round(patches_[p], views[p])) continue;
      any = true;
      sides_.flipped[p] = !sides_.flipped[p];
      for (const std::uint32_t member : members_[p]) turn_triangle(mesh_, rest_[member]);
    }
    return any;
  }

  bool leave_out_strays(const std::vector<View>& views) {
    bool any = false;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      if (!views[p].any || std::abs(views[p].own) >= kCurvesRound) continue;
      const double outside = views[p].own + views[p].others - 0.5 * views[p].step;
      if (std::abs(outside) <= kBounds) continue;
      any = sides_.stray[p] = true;
      for (const std::uint32_t member : members_[p]) sides_.left_out[rest_[member]] = true;
    }
    return any;
  }

  /// Leaves out the internal sheets that are not inside. Returns whether there are any.
  bool leave_out_sheets(const Surface& surface, const WindingNumber& winding) {
    std::vector<std::uint32_t> sheets;
    for (std::uint32_t t = 0; t < rest_.size(); ++t)
      if (patch_of_[rest_[t]] == kNoPatch) sheets.push_back(t);
    if (sheets.size() > kMostPatches) return false;
    std::vector<char> outside(sheets.size());
    parallel_for(sheets.size(), [&](std::size_t k) {
      outside[k] = at_both_sides(surface, sheets[k], [&](const Vector3& x) { return winding.at(x); }) < 0.5;
    });
    bool any = false;
    for (std::size_t k = 0; k < sheets.size(); ++k) {
      if (outside[k]) any = sides_.left_out[rest_[sheets[k]]] = true;
    }
    return any;
  }

  TriangleMesh mesh_;
  const std::vector<std::uint32_t>& patch_of_;
  const std::vector<Patch>& patches_;
  PatchSides sides_;
  std::vector<std::uint32_t> rest_;
  std::vector<std::vector<std::uint32_t>> members_;  ///< positions in rest_
};

}  // namespace

PatchSides judge_patches(const TriangleMesh& mesh, const std::vector<std::uint32_t>& patch_of,
                         const std::vector<Patch>& patches) {
  return PatchJudge(mesh, patch_of, patches).judge();
}

void turn_triangle(TriangleMesh& mesh, std::size_t triangle) {
  std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
  if (mesh.corner_normals.empty()) return;
  auto& normals = mesh.corner_normals[triangle];
  std::swap(normals[1], normals[2]);
  for (Vector3& normal : normals) normal = -normal;
}

TriangleMesh selected_triangles(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  TriangleMesh result;
  result.vertices = mesh.vertices;
  result.inner_faces = mesh.inner_faces;
  result.creases = mesh.creases;
  result.unit = mesh.unit;
  result.file_unit = mesh.file_unit;
  result.face_list = mesh.face_list;
  result.exact_size = mesh.exact_size;
  result.exact_box = mesh.exact_box;
  result.warnings = mesh.warnings;
  const auto select = [&](const auto& from, auto& to) {
    if (from.empty()) return;
    to.reserve(triangles.size());
    for (const std::uint32_t t : triangles) to.push_back(from[t]);
  };
  select(mesh.triangles, result.triangles);
  select(mesh.faces, result.faces);
  select(mesh.solids, result.solids);
  select(mesh.corner_normals, result.corner_normals);
  return result;
}

}  // namespace crossgrain
