// SPDX-License-Identifier: Apache-2.0
#include "fit/hex_fitting.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/fitting_energy.hpp"
#include "fit/fitting_targets.hpp"
#include "fit/near_surface.hpp"
#include "fit/surface_samples.hpp"
#include "fit/vertex_moves.hpp"
#include "map/descent.hpp"
#include "map/foldover.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

using Kind = HexCarrier::Kind;

/// Weight of the change of volume against that of shape.
constexpr double kFitVolumeWeight = 1.0 / 6;

/// Samples are so many sizes apart: 12 a quad of that size.
constexpr double kSampleSpacing = 0.4;

/// Samples for each quad at most, in the mean: more where quads are far larger than the size, as those of
/// thin layers are, which would take memory without end.
constexpr double kMostSamplesOfQuad = 1000;

/// Weights of pulls, in energies of a vertex that is off by a size: 1 to 100 while they go to places, then to
/// 1e4, by these factors a round. Twice as many rounds of the root of this factor take 1.6 times as long for
/// the same figures on seven maps.
constexpr double kFirstWeight = 1, kFirstSlideWeight = 100, kLastWeight = 1e4, kRise = 6.25;

/// Of pulls within a face to the place where `spread` put the vertex. With 12 what lies between vertices
/// hardly moves them.
constexpr double kEvenWeight = 1;

/// Of samples. On maps of wedge, pillow block and housing, with layers, the surface is 0.10, 0.22 and 0.32
/// sizes from the mesh at the 99th percentile with 1000, and 0.09, 0.15 and 0.21 with 3000, which leaves the
/// worst hexahedra as they are.
constexpr double kQuadWeight = 3000;

/// Of the energy of shapes in moves of single vertices. With 1, the worst hexahedron of wedge has a scaled
/// Jacobian of 0.29, with 2 of 0.35, with 3 of 0.38; but 3 keeps fillets from being followed.
constexpr int kShapePower = 2;

void add_isotropic(SymmetricMatrix3& sum, double weight) {
  for (const std::size_t diagonal : {0, 3, 5}) sum[diagonal] += weight;
}

void add_along(SymmetricMatrix3& sum, double weight, const Vector3& direction) {
  std::size_t entry = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) sum[entry++] += weight * direction[i] * direction[j];
}

/// Each sample has at least half of the squared spacing.
double sample_spacing(const FeatureComplex& complex, std::size_t quads, double size) {
  double area = 0;
  for (const FeatureComplex::Face& face : complex.faces) area += face.area;
  const double most = kMostSamplesOfQuad * static_cast<double>(std::max<std::size_t>(quads, 1));
  return std::max(kSampleSpacing * size, std::sqrt(2 * area / most));
}

class HexFitting {
 public:
  HexFitting(HexMesh& mesh, const FeatureComplex& complex, const HexCarriers& carriers, double size,
             const HexFittingOptions& options, std::size_t all)
      : mesh_(mesh),
        all_(all),
        carriers_(carriers),
        size_(size),
        options_(options),
        targets_(complex, carriers, size),
        samples_(surface_samples(complex, carriers.group_of_face,
                                 sample_spacing(complex, carriers.quads.size(), size))),
        trust_(mesh.vertices.size(), 1.0) {
    for (const HexCarrier& carrier : carriers.of_vertex)
      pulls_.is_held.push_back(carrier.kind == Kind::kHeld);
  }

  HexFittingResult run();

 private:
  void tell_part(int part, int done, int all) const;
  void pull_to_places(double weight);
  void pull_to_nearest(double weight);
  void round(int number);
  void move_single_vertices();
  void update_quad_pulls();
  void update_trust();
  std::size_t count_invalid() const;
  std::size_t count_off() const;
  double epsilon() const;

  HexMesh& mesh_;
  const std::size_t all_;  ///< hexahedra of the whole mesh
  const HexCarriers& carriers_;
  double size_;
  const HexFittingOptions& options_;
  FittingTargets targets_;
  std::vector<SurfaceSample> samples_;
  FittingPulls pulls_;
  std::vector<double> trust_;  ///< of each vertex: the share of its pulls that hexahedra around it stand
};

/// Tells that `done` of `all` steps of one of four parts are done.
void HexFitting::tell_part(int part, int done, int all) const {
  const double share = 0.25 * (part + static_cast<double>(done) / all);
  tell_watched(Phase::kSmooth, share, all_);
}

std::size_t HexFitting::count_invalid() const {
  const std::vector<std::uint8_t> inverted = inverted_hexahedra(mesh_);
  return static_cast<std::size_t>(std::count(inverted.begin(), inverted.end(), 1));
}

/// Where hexahedra have become bad, pulls wane until they recover.
void HexFitting::update_trust() {
  constexpr double kBad = 0.15, kWane = 0.1, kRecovery = 3, kLeastTrust = 1e-4;
  std::vector<double> least(mesh_.vertices.size(), 1);
  const std::vector<double> shapes = scaled_jacobians(mesh_);
  for (std::size_t h = 0; h < shapes.size(); ++h)
    for (const std::uint32_t v : mesh_.hexahedra[h]) least[v] = std::min(least[v], shapes[h]);
  for (std::size_t v = 0; v < trust_.size(); ++v)
    trust_[v] = std::clamp((least[v] < kBad ? kWane : kRecovery) * trust_[v], kLeastTrust, 1.0);
}

/// Vertices of faces and curves towards places that are spread evenly.
void HexFitting::pull_to_places(double weight) {
  const double scaled = weight / (size_ * size_);
  pulls_.of_vertex.assign(mesh_.vertices.size(), {});
  for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v) {
    if (!carriers_.of_vertex[v].is_on_surface()) continue;
    pulls_.of_vertex[v].point = targets_.evenly()[v];
    add_isotropic(pulls_.of_vertex[v].weight, scaled);
  }
}

/// A pull to a plane or line, and to a place in it, sums up as one to their weighted mean.
void HexFitting::pull_to_nearest(double weight) {
  const double evenly = kEvenWeight / (size_ * size_);
  const std::vector<Vector3> normals = targets_.normals_of(mesh_);
  pulls_.of_vertex.assign(mesh_.vertices.size(), {});
  parallel_for(mesh_.vertices.size(), [&](std::size_t index) {
    const auto v = static_cast<std::uint32_t>(index);
    const Kind kind = carriers_.of_vertex[v].kind;
    if (!carriers_.of_vertex[v].is_on_surface()) return;
    const Vector3& at = mesh_.vertices[v];
    const auto [point, direction] = targets_.nearest(v, at, normals[v]);
    const double scaled = trust_[v] * weight / (size_ * size_);
    VertexPull& pull = pulls_.of_vertex[v];
    pull.point = point;
    if (kind == Kind::kCorner) return add_isotropic(pull.weight, scaled);
    if (kind == Kind::kCurve) {
      add_isotropic(pull.weight, scaled);
      return add_along(pull.weight, -scaled, direction);
    }
    const Vector3 off = at - point;
    const Vector3 normal = norm(off) > 0.01 * size_ ? normalised(off) : direction;
    const Vector3 to_place = targets_.evenly()[v] - point;
    pull.point = point + (to_place - dot(to_place, normal) * normal);
    add_isotropic(pull.weight, evenly);
    add_along(pull.weight, scaled, normal);
  });
}

void HexFitting::update_quad_pulls() {
  pulls_.of_quads = quad_pulls(samples_, mesh_, carriers_, size_);
  for (QuadPull& pull : pulls_.of_quads) {
    const auto& [a, b, c] = pull.vertices;
    pull.weight *= std::min({trust_[a], trust_[b], trust_[c]});
  }
  pulls_.quad_weight = kQuadWeight / (size_ * size_);
}

double HexFitting::epsilon() const {
  constexpr double kLeastEpsilon = 1e-3, kMostEpsilon = 0.5, kShare = 0.2;
  const ShapeEnergy shapes(mesh_.vertices.size(), mesh_.hexahedra, wanted_sizes(mesh_, size_));
  return std::clamp(-kShare * shapes.least_determinant(mesh_.vertices), kLeastEpsilon, kMostEpsilon);
}

/// At first a tangle may spread into valid hexahedra, through which it unfolds; if it has not then, they are
/// kept.
void HexFitting::round(int number) {
  constexpr int kRoundsOfUnfolding = 3;
  std::vector<std::uint8_t> kept = inverted_hexahedra(mesh_);
  for (std::uint8_t& flag : kept) flag = !flag;
  const bool is_valid = std::ranges::count(kept, 0) == 0;
  if (!is_valid && number < kRoundsOfUnfolding) std::ranges::fill(kept, 0);
  FittingEnergy energy(mesh_, pulls_, size_,
                       {.volume_weight = kFitVolumeWeight, .epsilon = is_valid ? 0 : epsilon()},
                       std::move(kept));
  const Descent descent =
      minimised([&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) { return energy(x, gradient); },
                [&](const Eigen::VectorXd& gradient, Eigen::VectorXd& result) {
                  energy.precondition(gradient, result);
                },
                Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(mesh_.vertices.size())),
                {.steps = options_.steps, .least_gain = 1e-6});
  mesh_.vertices = energy.places(descent.x);
}

void HexFitting::move_single_vertices() {
  VertexMoves moves(mesh_, targets_);
  const CornerEnergyOptions shapes{.volume_weight = kFitVolumeWeight, .power = kShapePower};
  const std::size_t at_rest = mesh_.vertices.size() / 200;
  for (int k = 0; k < options_.relaxations; ++k) {
    tell_part(2, k, options_.relaxations);
    moves.snap(options_.floor);
    update_trust();
    pull_to_nearest(kLastWeight);
    update_quad_pulls();
    if (moves.relax(pulls_, shapes) <= at_rest) break;
  }
  for (int k = 0; k < options_.lifts; ++k) {
    tell_part(3, k, options_.lifts);
    moves.snap(options_.floor);
    if (moves.lift(options_.lifted_below) == 0) break;
  }
  moves.snap(options_.floor);
  constexpr int kIdle = 4;  // sweeps, each in other directions, in which the worst stays as it is
  double worst = -1;
  for (int k = 0, idle = 0; k < options_.raises && idle < kIdle; ++k) {
    moves.raise(options_.raised_below, k);
    const double now = std::ranges::min(scaled_jacobians(mesh_));
    idle = now > worst ? 0 : idle + 1;
    worst = now;
  }
}

HexFittingResult HexFitting::run() {
  targets_.spread(mesh_);
  double weight = kFirstWeight;
  for (int k = 0; k < options_.point_rounds; ++k, weight *= kRise) {
    tell_part(0, k, options_.point_rounds);
    pull_to_places(weight);
    round(k);
  }
  weight = kFirstSlideWeight;
  for (int k = 0; k < options_.slide_rounds; ++k, weight *= kRise) {
    tell_part(1, k, options_.slide_rounds);
    update_trust();
    pull_to_nearest(weight);
    update_quad_pulls();
    round(options_.point_rounds + k);
  }
  move_single_vertices();
  return {count_invalid(), count_off()};
}

std::size_t HexFitting::count_off() const {
  constexpr double kOff = 1e-9;
  const std::vector<Vector3> normals = targets_.normals_of(mesh_);
  std::size_t off = 0;
  for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v) {
    if (!carriers_.of_vertex[v].is_on_surface()) continue;
    const Vector3& at = mesh_.vertices[v];
    off += norm(targets_.nearest(v, at, normals[v]).point - at) > kOff * size_;
  }
  return off;
}

}  // namespace

HexFittingResult fit_onto(HexMesh& mesh, const FeatureComplex& complex, const HexCarriers& carriers,
                          double size, const HexFittingOptions& options) {
  if (mesh.hexahedra.empty()) return {};
  if (std::optional<NearSurface> part = near_surface(mesh, carriers, options.lifted_below)) {
    const HexFittingResult result =
        HexFitting(part->mesh, complex, part->carriers, size, options, mesh.hexahedra.size()).run();
    part->copy_places_to(mesh);
    return result;
  }
  return HexFitting(mesh, complex, carriers, size, options, mesh.hexahedra.size()).run();
}

}  // namespace crossgrain
