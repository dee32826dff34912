// SPDX-License-Identifier: Apache-2.0
#include "fit/vertex_moves.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/hex_quality.hpp"

namespace crossgrain {
namespace {

/// In sizes: what rounding leaves between a vertex and its carrier.
constexpr double kOnCarrier = 1e-9;

/// In sizes: edges that are not made shorter for a better scaled Jacobian, which sees angles alone; and for a
/// place on a carrier. Without them the longest edge of a hexahedron is up to 149,000 times the shortest on
/// five lattices of parts (a shaft, a tee, a housing with bosses, i10o, a plate), with them 44 times; with
/// 0.35 in place of 0.2 it is 58 times, and worst scaled Jacobians of 0.28 and 0.33 become 0.24 and 0.29.
constexpr double kShortEdge = 0.2, kShortestEdge = 0.05;

/// In mean edges: moves that are too short to stir the surroundings.
constexpr double kStir = 2e-3;

/// Of the way to its carrier that a vertex may go at once. Short ones let its surroundings give way in
/// between: with a quarter as the least, the corner of a cusp stays out of reach.
constexpr std::array kShares{1.0, 0.5, 0.25, 0.125, 0.0625};

/// Hexahedra that are raised in a sweep, the worst: 80 places are tried for each of their vertices. Without
/// the limit, the search in an octahedron takes 110 seconds of a processor, 60 of them here.
constexpr std::ptrdiff_t kMostRaised = 40;

/// Vertices of a task.
constexpr std::size_t kMovesAtOnce = 32;

/// Newton's step within the plane of two unit vectors, along one, or in space.
Vector3 newton_step(const SecondOrder& sum, const std::array<Vector3, 3>& axes, int count) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) {
    const auto& u = axes[static_cast<std::size_t>(i)];
    right[i] = -dot(u, sum.gradient);
    const Vector3 image = crossgrain::apply(sum.hessian, u);
    for (int j = 0; j < count; ++j) matrix(i, j) = dot(image, axes[static_cast<std::size_t>(j)]);
  }
  const Eigen::Vector3d step = matrix.llt().solve(right);
  Vector3 result{0, 0, 0};
  for (int i = 0; i < count; ++i) result += step[i] * axes[static_cast<std::size_t>(i)];
  return result;
}

}  // namespace

VertexMoves::VertexMoves(HexMesh& mesh, const FittingTargets& targets)
    : mesh_(mesh),
      targets_(targets),
      uses_(corner_uses(mesh.vertices.size(), mesh.hexahedra)),
      sets_(independent_sets(mesh, uses_)),
      sizes_(wanted_sizes(mesh, targets.size())),
      is_on_(mesh.vertices.size(), 1),
      is_stirred_(mesh.vertices.size(), 1) {
  for (std::uint32_t v = 0; v < is_on_.size(); ++v)
    is_on_[v] = !targets_.carriers().of_vertex[v].is_on_surface();
}

template <class Move>
std::size_t VertexMoves::move_all(const std::vector<std::uint8_t>& wanted, const Move& move) {
  std::vector<std::uint8_t> has_moved(mesh_.vertices.size(), 0);
  for (const std::vector<std::uint32_t>& set : sets_)
    parallel_for(
        set.size(),
        [&](std::size_t k) {
          const std::uint32_t v = set[k];
          if (!wanted[v] || kind(v) == Kind::kHeld) return;
          const Vector3 before = mesh_.vertices[v];
          const bool moved = move(v);
          has_moved[v] = moved && norm(mesh_.vertices[v] - before) > kStir * targets_.size();
        },
        kMovesAtOnce);
  std::fill(is_stirred_.begin(), is_stirred_.end(), 0);
  for (const auto& hexahedron : mesh_.hexahedra)
    if (std::any_of(hexahedron.begin(), hexahedron.end(), [&](std::uint32_t v) { return has_moved[v] != 0; }))
      for (const std::uint32_t v : hexahedron) is_stirred_[v] = 1;
  return static_cast<std::size_t>(std::count(has_moved.begin(), has_moved.end(), 1));
}

double VertexMoves::pull_energy(std::uint32_t vertex, const Vector3& place, const FittingPulls& pulls) const {
  double sum = 0;
  if (!is_on_[vertex]) {
    const VertexPull& pull = pulls.of_vertex[vertex];
    sum += dot(place - pull.point, crossgrain::apply(pull.weight, place - pull.point));
  }
  for (const std::uint32_t use : pulled_by_[vertex]) {
    const QuadPull& pull = pulls.of_quads[use / 3];
    const double off = pull.difference(mesh_.vertices) +
                       pull.shares[use % 3] * dot(pull.direction, place - mesh_.vertices[vertex]);
    sum += pulls.quad_weight * pull.weight * off * off;
  }
  return sum;
}

void VertexMoves::add_pulls(std::uint32_t vertex, const FittingPulls& pulls, SecondOrder& sum) const {
  const Vector3& place = mesh_.vertices[vertex];
  sum.value += pull_energy(vertex, place, pulls);
  if (!is_on_[vertex]) {
    const VertexPull& pull = pulls.of_vertex[vertex];
    sum.gradient += 2 * crossgrain::apply(pull.weight, place - pull.point);
    for (std::size_t k = 0; k < 6; ++k) sum.hessian[k] += 2 * pull.weight[k];
  }
  for (const std::uint32_t use : pulled_by_[vertex]) {
    const QuadPull& pull = pulls.of_quads[use / 3];
    const double share = pull.shares[use % 3], factor = 2 * pulls.quad_weight * pull.weight * share;
    sum.gradient += factor * pull.difference(mesh_.vertices) * pull.direction;
    std::size_t entry = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j)
        sum.hessian[entry++] += factor * share * pull.direction[i] * pull.direction[j];
  }
}

Vector3 VertexMoves::held(std::uint32_t vertex, const Vector3& place) const {
  if (!is_on_[vertex] || kind(vertex) == Kind::kInside) return place;
  return targets_.nearest(vertex, place, normals_[vertex]).point;
}

/// How far a vertex would be off its carrier; 0 for those that are held on theirs.
double VertexMoves::off_carrier(std::uint32_t vertex, const Vector3& place) const {
  return is_on_[vertex] ? 0 : norm(targets_.nearest(vertex, place, normals_[vertex]).point - place);
}

bool VertexMoves::relax_vertex(std::uint32_t vertex, const FittingPulls& pulls,
                               const CornerEnergyOptions& options) {
  if (is_on_[vertex] && kind(vertex) == Kind::kCorner) return false;
  VertexSurroundings around(mesh_, uses_[vertex]);
  SecondOrder sum;
  if (!around.add_energy(sizes_, options, sum)) return false;
  add_pulls(vertex, pulls, sum);
  const Vector3 before = mesh_.vertices[vertex];
  std::array<Vector3, 3> axes{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
  int count = 3;
  if (is_on_[vertex] && kind(vertex) != Kind::kInside) {
    const Vector3 direction = targets_.nearest(vertex, before, normals_[vertex]).direction;
    const bool is_on_face = kind(vertex) == Kind::kFace;
    count = is_on_face ? 2 : 1;
    axes[0] = is_on_face ? orthogonal_unit(direction) : direction;
    axes[1] = cross(direction, axes[0]);
  }
  Vector3 step = newton_step(sum, axes, count);
  const double length = norm(step), most = 0.5 * targets_.size();
  if (!(length > 1e-6 * targets_.size())) return false;
  if (length > most) step = (most / length) * step;
  constexpr int kTries = 5;
  for (int k = 0; k < kTries; ++k, step = 0.5 * step) {
    const Vector3 place = held(vertex, before + step);
    around.move_to(place);
    const double energy = around.energy(sizes_, options) + pull_energy(vertex, place, pulls);
    if (!(energy < sum.value) || !around.are_valid()) continue;
    mesh_.vertices[vertex] = place;
    return true;
  }
  return false;
}

std::size_t VertexMoves::relax(const FittingPulls& pulls, const CornerEnergyOptions& options) {
  update_normals();
  pulled_by_ = Lists<std::uint32_t>(mesh_.vertices.size(), [&](const auto& add) {
    for (std::uint32_t q = 0; q < pulls.of_quads.size(); ++q)
      for (std::uint32_t k = 0; k < 3; ++k) add(pulls.of_quads[q].vertices[k], 3 * q + k);
  });
  const std::vector<std::uint8_t> wanted = is_stirred_;
  return move_all(wanted, [&](std::uint32_t v) { return relax_vertex(v, pulls, options); });
}

bool VertexMoves::snap_vertex(std::uint32_t vertex, double floor) {
  const Vector3 before = mesh_.vertices[vertex];
  const Vector3 target = targets_.nearest(vertex, before, normals_[vertex]).point;
  VertexSurroundings around(mesh_, uses_[vertex]);
  const double least = around.least_scaled_jacobian(), shortest = around.least_edge(),
               short_edge = kShortestEdge * around.mean_size(sizes_);
  for (const double share : kShares) {
    const Vector3 place = share == 1.0 ? target : before + share * (target - before);
    around.move_to(place);
    const double now = around.least_scaled_jacobian();
    if ((now < floor && now < least) || !around.are_valid()) continue;
    const double edge_now = around.least_edge();
    if (edge_now < short_edge && edge_now < shortest) continue;
    mesh_.vertices[vertex] = place;
    is_on_[vertex] = share == 1.0;
    return true;
  }
  return false;
}

std::size_t VertexMoves::snap(double floor) {
  update_normals();
  std::vector<std::uint8_t> wanted(is_on_.size());
  for (std::size_t v = 0; v < wanted.size(); ++v) wanted[v] = !is_on_[v];
  move_all(wanted, [&](std::uint32_t v) { return snap_vertex(v, floor); });
  std::fill(is_stirred_.begin(), is_stirred_.end(), 1);
  return static_cast<std::size_t>(std::count(is_on_.begin(), is_on_.end(), 0));
}

Vector3 VertexMoves::direction_of(std::uint32_t vertex, const Vector3& gradient) const {
  if (!is_on_[vertex] || kind(vertex) == Kind::kInside) return gradient;
  if (kind(vertex) == Kind::kCorner) return {0, 0, 0};
  const Vector3 direction = targets_.nearest(vertex, mesh_.vertices[vertex], normals_[vertex]).direction;
  const Vector3 along = dot(direction, gradient) * direction;
  return kind(vertex) == Kind::kCurve ? along : gradient - along;
}

bool VertexMoves::lift_vertex(std::uint32_t vertex) {
  constexpr double kFirstStep = 0.3, kLeastStep = 0.002, kLeastGain = 1e-6, kGoodEnough = 0.15;
  VertexSurroundings around(mesh_, uses_[vertex]);
  const Vector3 downhill = normalised(direction_of(vertex, -around.badness_gradient()));
  if (norm(downhill) == 0) return false;
  const double edge = around.mean_edge(), badness = around.badness(), least = around.least_scaled_jacobian();
  const Vector3 before = mesh_.vertices[vertex];
  const double off = off_carrier(vertex, before), shortest = around.least_edge(),
               short_edge = kShortEdge * around.mean_size(sizes_);
  for (double step = kFirstStep * edge; step > kLeastStep * edge; step *= 0.5) {
    const Vector3 place = held(vertex, before + step * downhill);
    if (off_carrier(vertex, place) > off) continue;
    around.move_to(place);
    if (!(around.badness() < (1 - kLeastGain) * badness)) continue;
    const double edge_now = around.least_edge();
    if (edge_now < short_edge && edge_now < shortest) continue;
    const double now = around.least_scaled_jacobian();
    if ((now < least && now < kGoodEnough) || !around.are_valid()) continue;
    mesh_.vertices[vertex] = place;
    return true;
  }
  return false;
}

/// Orthonormal axes that turn with the mesh, other ones in each sweep: at first one is along a gradient.
std::array<Vector3, 3> VertexMoves::axes_at(std::uint32_t vertex, const Vector3& gradient, int sweep) const {
  const std::uint32_t use = uses_[vertex][0];
  const Vector3 along = mesh_.vertices[mesh_.hexahedra[use / 8][(use + 1) % 8]] - mesh_.vertices[vertex];
  const Vector3 u = norm(gradient) > 0 ? normalised(gradient) : normalised(along);
  const Vector3 across = cross(u, along);
  const Vector3 v = norm(across) > 1e-6 * norm(along) ? normalised(across) : orthogonal_unit(u);
  std::array<Vector3, 3> axes{u, v, cross(u, v)};
  for (int k = 0; k < sweep; ++k) {
    const auto [a, b, c] = axes;
    // A rotation of no finite order.
    axes = {(1.0 / 7) * (6 * a + 2 * b + 3 * c), (1.0 / 7) * (2 * a + 3 * b - 6 * c),
            (1.0 / 7) * (6 * b - 3 * a + 2 * c)};
  }
  return axes;
}

/// The downhill way of `lift` sums over all hexahedra around, and ends where it would lower the worst; places
/// in many directions are found by trial.
bool VertexMoves::raise_vertex(std::uint32_t vertex, int sweep) {
  constexpr std::array kSteps{0.3, 0.1, 0.03};  // of the mean edge
  constexpr double kLeastGain = 1e-3;
  constexpr int kDirections = 27;  // to the neighbours in a grid of 3^3, and none
  if (is_on_[vertex] && kind(vertex) == Kind::kCorner) return false;
  VertexSurroundings around(mesh_, uses_[vertex]);
  const Vector3 before = mesh_.vertices[vertex];
  const double edge = around.mean_edge(), off = off_carrier(vertex, before), shortest = around.least_edge(),
               short_edge = kShortEdge * around.mean_size(sizes_);
  double best = around.least_scaled_jacobian() + kLeastGain;
  Vector3 best_place = before;
  const auto [u, v, w] = axes_at(vertex, around.badness_gradient(), sweep);
  for (int code = 0; code < kDirections; ++code) {
    const Vector3 towards = static_cast<double>(code % 3 - 1) * u +
                            static_cast<double>(code / 3 % 3 - 1) * v + static_cast<double>(code / 9 - 1) * w;
    const Vector3 direction = normalised(direction_of(vertex, towards));
    if (norm(direction) == 0) continue;
    for (const double step : kSteps) {
      const Vector3 place = held(vertex, before + step * edge * direction);
      if (off_carrier(vertex, place) > off) continue;
      around.move_to(place);
      const double now = around.least_scaled_jacobian(), edge_now = around.least_edge();
      if (now <= best || (edge_now < short_edge && edge_now < shortest) || !around.are_valid()) continue;
      best = now;
      best_place = place;
    }
  }
  mesh_.vertices[vertex] = best_place;
  return best_place != before;
}

/// The vertices of hexahedra with a scaled Jacobian below a threshold.
std::vector<std::uint8_t> VertexMoves::vertices_of_worst(double threshold) const {
  std::vector<std::uint8_t> wanted(is_on_.size(), 0);
  for (std::size_t h = 0; h < mesh_.hexahedra.size(); ++h)
    if (scaled_jacobian_of(corners_of(mesh_, h)) < threshold)
      for (const std::uint32_t v : mesh_.hexahedra[h]) wanted[v] = 1;
  return wanted;
}

std::size_t VertexMoves::raise(double threshold, int sweep) {
  update_normals();
  std::vector<double> worst;
  for (const double shape : scaled_jacobians(mesh_))
    if (shape < threshold) worst.push_back(shape);
  if (std::ssize(worst) > kMostRaised) {
    const auto last = worst.begin() + kMostRaised;
    std::nth_element(worst.begin(), last, worst.end());
    threshold = *last;
  }
  return move_all(vertices_of_worst(threshold), [&](std::uint32_t v) { return raise_vertex(v, sweep); });
}

std::size_t VertexMoves::lift(double threshold) {
  update_normals();
  return move_all(vertices_of_worst(threshold), [&](std::uint32_t v) { return lift_vertex(v); });
}

}  // namespace crossgrain
