// SPDX-License-Identifier: Apache-2.0
#include "fit/patch_lift.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/fitting_energy.hpp"
#include "fit/fitting_targets.hpp"
#include "fit/hex_patch.hpp"
#include "fit/patch_slides.hpp"
#include "fit/vertex_moves.hpp"
#include "map/descent.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

/// Layers of a patch, powers of its poorness, and steps with each. With 1, 2 and 3 layers the worst of i18c
/// is 0.02, 0.03 and 0.06, of i22c 0.13, 0.14 and 0.18, of i25c 0.20, 0.30 and 0.22, of bracket 0.10, 0.11,
/// 0.10.
constexpr int kPatchLayers = 2;
constexpr std::array kPowers{2, 4, 8, 16};
constexpr int kSteps = 10;

/// In sizes wanted: edges that do not become shorter. With 0.1 the same five parts have a worst within 0.03.
constexpr double kShortestInPatch = 0.2;

/// Gain of the worst scaled Jacobian for which a patch is taken.
constexpr double kLeastGain = 1e-3;

/// Of a vertex's way: what its carrier may take of it. With 0.6 the same within 0.02.
constexpr double kBlocked = 0.3;

/// The least scaled Jacobian for which a vertex goes onto its carrier. With that of fit_onto, 0.02, i25c has
/// 0.22 for 0.30, and bracket 9270 hexahedra for 3961.
constexpr double kFloor = 0.1;

/// Rounds, and patches in each: the worst.
constexpr int kRounds = 10;
constexpr std::size_t kMostPatches = 64;

/// Moves the vertices of one patch.
class PatchLift {
 public:
  PatchLift(HexPatch& patch, const FittingTargets& targets, std::span<const Vector3> normals)
      : patch_(patch),
        targets_(targets),
        normals_(normals),
        best_(patch.mesh.vertices),
        best_worst_(worst_scaled_jacobian(patch.mesh)) {}

  /// Returns whether the worst has risen. Vertices off their carrier first keep their distance, then they
  /// may go anywhere within it.
  bool run() {
    const double before = best_worst_;
    const bool are_off = std::ranges::any_of(patch_.off, [](double off) { return off > 0; });
    for (const bool may_turn : {false, true}) {
      if (may_turn && (best_worst_ >= kGoodShape || !are_off)) break;
      for (const int power : kPowers) {
        blocked_.assign(patch_.vertices.size(), 0);
        for (std::size_t v = 0; v < blocked_.size(); ++v) blocked_[v] = patch_.off[v] > 0 && !may_turn;
        for (int k = 0; k < kSteps && step(power); ++k) continue;
      }
      patch_.mesh.vertices = best_;
    }
    return best_worst_ > before + kLeastGain;
  }

 private:
  double poorness_at(const std::vector<Vector3>& places, int power) {
    return poorness(patch_.mesh, places, power, patch_.shortest_edge / kShortestInPatch, by_place_);
  }

  /// On the way a hexahedron may be invalid that has no corner which is.
  void keep_if_better() {
    const double worst = worst_scaled_jacobian(patch_.mesh);
    if (worst <= best_worst_ || shortest_edge(patch_.mesh).length < patch_.shortest_edge ||
        std::ranges::count(inverted_hexahedra(patch_.mesh), 1) > 0)
      return;
    best_ = patch_.mesh.vertices;
    best_worst_ = worst;
  }

  Eigen::VectorXd descent_of(const PatchSlides& slides, int power) {
    constexpr int kDescents = 60;
    constexpr double kLeastDescent = 1e-5;
    std::vector<Vector3> places;
    const auto function = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
      places = patch_.mesh.vertices;
      slides.move(x, places);
      const double value = poorness_at(places, power);
      slides.put_gradient(by_place_, gradient);
      return value + slides.add_reach(x, gradient);
    };
    return minimised(function,
                     [](const Eigen::VectorXd& gradient, Eigen::VectorXd& result) { result = gradient; },
                     Eigen::VectorXd::Zero(slides.size()), {.steps = kDescents, .least_gain = kLeastDescent})
        .x;
  }

  /// Moves the patch to less poorness once vertices are on their carriers. Returns whether another step may
  /// go further.
  bool step(int power) {
    constexpr int kHalvings = 5;
    constexpr double kEnough = 1e-3;
    const PatchSlides slides(patch_, targets_, normals_, blocked_);
    if (slides.size() == 0) return false;
    const double before = poorness_at(patch_.mesh.vertices, power);
    Eigen::VectorXd x = descent_of(slides, power);
    bool is_blocked = false;
    for (int k = 0; k < kHalvings; ++k, x *= 0.5) {
      std::vector<Vector3> places = patch_.mesh.vertices;
      slides.move(x, places);
      std::vector<std::uint32_t> stopped = put_onto_carriers(places);
      if (k == 0)
        for (const std::uint32_t v : stopped) ++blocked_[v];
      is_blocked |= !stopped.empty();
      const double value = poorness_at(places, power);
      if (!(value < before)) continue;
      patch_.mesh.vertices = std::move(places);
      keep_if_better();
      return is_blocked || value < before - kEnough;
    }
    return is_blocked;
  }

  /// Returns the vertices whose carrier ends on their way, or turns.
  std::vector<std::uint32_t> put_onto_carriers(std::vector<Vector3>& places) const {
    constexpr double kRounding = 1e-6;
    std::vector<std::uint32_t> stopped;
    for (std::uint32_t v = 0; v < patch_.vertices.size(); ++v) {
      const std::uint32_t vertex = patch_.vertices[v];
      if (!patch_.is_free[v] || !targets_.carriers().of_vertex[vertex].is_on_surface()) continue;
      const Vector3 on = targets_.nearest(vertex, places[v], normals_[vertex]).point, off = places[v] - on;
      const double distance = norm(off), way = norm(places[v] - patch_.mesh.vertices[v]);
      if (distance <= patch_.off[v]) continue;
      if (distance - patch_.off[v] > kBlocked * way + kRounding * targets_.size()) stopped.push_back(v);
      places[v] = on + (patch_.off[v] / distance) * off;
    }
    return stopped;
  }

  HexPatch& patch_;
  const FittingTargets& targets_;
  std::span<const Vector3> normals_;
  std::vector<std::uint8_t> blocked_;  ///< of vertices: PatchSlides
  std::vector<Vector3> best_;
  double best_worst_;
  std::vector<Vector3> by_place_;
};

class PatchLifting {
 public:
  PatchLifting(HexMesh& mesh, FittingTargets& targets)
      : mesh_(mesh),
        targets_(targets),
        moves_(mesh, targets),
        uses_(corner_uses(mesh.vertices.size(), mesh.hexahedra)),
        is_in_vain_(mesh.hexahedra.size(), 0) {}

  std::size_t run() {
    std::size_t lifted = 0;
    for (int round = 0; round < kRounds; ++round) {
      targets_.slide_from(mesh_);
      moves_.snap(kFloor);
      normals_ = targets_.normals_of(mesh_);
      const std::size_t now = lift(patches_around_worst());
      lifted += now;
      if (now == 0) break;
    }
    moves_.snap(kFloor);
    return lifted;
  }

 private:
  /// Returns how many were lifted. Vertices that two patches have are free in neither.
  std::size_t lift(std::vector<HexPatch> patches) {
    std::vector<std::uint8_t> is_lifted(patches.size(), 0);
    parallel_for(
        patches.size(),
        [&](std::size_t k) { is_lifted[k] = PatchLift(patches[k], targets_, normals_).run(); }, 1);
    for (std::size_t k = 0; k < patches.size(); ++k) {
      is_in_vain_[patches[k].middle] = !is_lifted[k];
      if (!is_lifted[k]) continue;
      for (const std::uint32_t h : patches[k].hexahedra) is_in_vain_[h] = 0;
      for (std::size_t v = 0; v < patches[k].vertices.size(); ++v)
        if (patches[k].is_free[v]) mesh_.vertices[patches[k].vertices[v]] = patches[k].mesh.vertices[v];
    }
    return static_cast<std::size_t>(std::ranges::count(is_lifted, 1));
  }

  /// Those of no common hexahedron, the worst first.
  std::vector<HexPatch> patches_around_worst() const {
    const std::vector<double> shapes = scaled_jacobians(mesh_);
    std::vector<std::uint32_t> poor;
    for (std::uint32_t h = 0; h < shapes.size(); ++h)
      if (shapes[h] < kGoodShape && !is_in_vain_[h]) poor.push_back(h);
    std::ranges::stable_sort(poor, {}, [&](std::uint32_t h) { return shapes[h]; });
    std::vector<std::uint8_t> is_taken(shapes.size(), 0);
    std::vector<HexPatch> patches;
    for (const std::uint32_t h : poor) {
      if (patches.size() == kMostPatches) break;
      if (is_taken[h]) continue;
      HexPatch patch = patch_around(h, kPatchLayers, mesh_, uses_);
      if (std::ranges::any_of(patch.hexahedra, [&](std::uint32_t one) { return is_taken[one] != 0; }))
        continue;
      for (const std::uint32_t one : patch.hexahedra) is_taken[one] = 1;
      set_bounds(patch);
      patches.push_back(std::move(patch));
    }
    return patches;
  }

  void set_bounds(HexPatch& patch) const {
    for (const std::uint32_t v : patch.vertices)
      patch.off.push_back(
          moves_.is_on_carrier(v)
              ? 0
              : norm(targets_.nearest(v, mesh_.vertices[v], normals_[v]).point - mesh_.vertices[v]));
    const std::vector<double> sizes = wanted_sizes(patch.mesh, targets_.size());
    const double mean = std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
    patch.shortest_edge = std::min(kShortestInPatch * mean, shortest_edge(patch.mesh).length);
  }

  HexMesh& mesh_;
  FittingTargets& targets_;
  VertexMoves moves_;
  Lists<std::uint32_t> uses_;
  std::vector<Vector3> normals_;
  std::vector<std::uint8_t> is_in_vain_;  ///< of hexahedra: the patch around it has not risen as it is now
};

}  // namespace

std::size_t lift_patches(HexMesh& mesh, const FeatureComplex& complex, const HexCarriers& carriers,
                         double size) {
  FittingTargets targets(complex, carriers, size);
  targets.spread(mesh);
  return PatchLifting(mesh, targets).run();
}

}  // namespace crossgrain
