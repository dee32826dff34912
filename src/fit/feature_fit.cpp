// SPDX-License-Identifier: Apache-2.0
#include "fit/feature_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "base/required_memory.hpp"
#include "base/stopwatch.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/message.hpp"
#include "fit/coarser_features.hpp"
#include "fit/embedding.hpp"
#include "fit/hex_carriers.hpp"
#include "fit/hex_fitting.hpp"
#include "fit/layers.hpp"
#include "fit/patch_lift.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"
#include "measure/surface_distance.hpp"

namespace crossgrain {
namespace {

using LackKind = FeatureMeasure::Kind;

bool is_of_shape(const FeatureMeasure::Lack& lack) {
  return lack.kind == LackKind::kOffModel || lack.kind == LackKind::kOffMesh ||
         lack.kind == LackKind::kVolume;
}

std::size_t lost_features(const FeatureMeasure& measure) {
  return measure.lacking.size() -
         static_cast<std::size_t>(std::ranges::count_if(measure.lacking, is_of_shape));
}

/// Worst scaled Jacobian of single moves from which moving all vertices at once gains little.
constexpr double kFineShape = 0.4;

/// Of two meshes with as poor a worst hexahedron, the one with less than half as many of these is better.
constexpr double kPoorShape = 0.1;

/// Classes of worst shapes between which a difference counts: a tenth of a scaled Jacobian is worth no more
/// hexahedra.
int class_of(double least) {
  return static_cast<int>(std::ranges::count_if(std::array{kPoorestShape, 0.05, 0.1, kGoodShape, kFineShape},
                                                [&](double bound) { return least >= bound; }));
}

/// Layers that are dearer than others by this, or are more hexahedra than that, are not tried where only
/// shapes are poor: with a million both ways take three minutes each, and neither was better by a class.
constexpr double kMostBeside = 2, kMostForShapes = 300000;

void require_memory_of(double hexahedra) {
  require_memory(kBytesOfFittedHexahedron * hexahedra,
                 fmt::format("fitting {:.0f} hexahedra to the model", hexahedra),
                 Remedy::kTakeFewerHexahedra);
}

struct SortedQuad {
  std::array<std::uint32_t, 4> vertices;  ///< ascending
  std::uint32_t index;
  friend auto operator<=>(const SortedQuad&, const SortedQuad&) = default;
};

SortedQuad sorted_quad(std::array<std::uint32_t, 4> vertices, std::uint32_t index) {
  std::ranges::sort(vertices);
  return {vertices, index};
}

/// The face of each quad of an embedding, found by its vertices.
class FacesOfQuads {
 public:
  FacesOfQuads(const HexMesh& mesh, const FeatureComplex& features, const Embedding& embedding)
      : embedding_(embedding) {
    const QuadComplex surface = surface_of(mesh, features);
    for (std::uint32_t q = 0; q < surface.quads().size(); ++q)
      quads_.push_back(sorted_quad(surface.quads()[q].vertices, q));
    std::ranges::sort(quads_);
  }

  /// kNone without.
  std::uint32_t face(const std::array<std::uint32_t, 4>& vertices) const {
    const SortedQuad wanted = sorted_quad(vertices, 0);
    const auto at = std::ranges::lower_bound(quads_, wanted);
    if (at == quads_.end() || at->vertices != wanted.vertices) return Embedding::kNone;
    return embedding_.face_of_quad[at->index];
  }

 private:
  const Embedding& embedding_;
  std::vector<SortedQuad> quads_;
};

/// Whether the surface touches itself nowhere. A sheet that meets itself at the boundary may leave an edge of
/// four quads there: in 4 of 2,000 random lattices.
bool is_manifold(const HexMesh& mesh) {
  const HexTopology topology = topology_of(mesh);
  return topology.is_closed() && topology.pinched_vertices == 0;
}

FittedMesh measured(HexMesh mesh, const FeatureComplex& features, double size) {
  FittedMesh fitted{std::move(mesh), {}};
  fitted.measure = sharp_feature_measure(fitted.mesh, features, size);
  const std::vector<double> shapes = scaled_jacobians(fitted.mesh);
  if (!shapes.empty()) fitted.least = *std::ranges::min_element(shapes);
  fitted.poor = static_cast<std::size_t>(
      std::ranges::count_if(shapes, [](double shape) { return shape < kPoorShape; }));
  fitted.invalid = static_cast<std::size_t>(std::ranges::count(inverted_hexahedra(fitted.mesh), 1));
  return fitted;
}

/// A mesh that curves and faces are embedded in.
struct Embedded {
  HexMesh mesh;
  FeatureComplex features;  ///< without the soft curves that have no path
  Embedding embedding;
};

HexCarriers carriers_in(const Embedded& embedded) {
  const Embedding& embedding = embedded.embedding;
  std::vector<HexCarriers::Quad> quads;
  const QuadComplex surface = surface_of(embedded.mesh, embedded.features);
  for (std::uint32_t q = 0; q < surface.quads().size(); ++q)
    if (const std::uint32_t face = embedding.face_of_quad[q]; face != Embedding::kNone)
      quads.push_back({surface.quads()[q].vertices, face});
  return carriers_on(embedded.mesh.vertices.size(), embedded.features, embedding.vertex_of_corner,
                     embedding.path_of_curve, std::move(quads));
}

/// The ways, one after the other, with the best so far.
class FittingWays {
 public:
  FittingWays(const HexMesh& mesh, const FeatureComplex& features, const FitSizes& sizes)
      : given_(mesh), features_(features), sizes_(sizes) {}

  void measure_given() {
    require_memory(bytes_to_fit_to(features_),
                   fmt::format("fitting hexahedra to {}", counted(features_.triangles.size(), "triangle")),
                   Remedy::kAllowMemory);
    keep(HexFitWay::kAsMapped, measured(given_, features_, sizes_.judged), 0);
  }

  bool is_good() const { return fit_.best.is_good(); }

  bool is_faithful() const { return fit_.best.invalid == 0 && fit_.best.measure.is_faithful(); }
  bool is_fine() const { return is_good() && fit_.best.least >= kFineShape; }

  void embed() {
    for (const bool makes_room : {true, false}) {
      embedded_ = {given_, features_, {}};
      embedded_.embedding = embedded(embedded_.mesh, embedded_.features, sizes_.edge, {makes_room});
      if (is_manifold(embedded_.mesh)) return;
    }
  }

  /// A mesh that is nearly on its features stays as it is elsewhere.
  void snap() {
    require_memory_of(static_cast<double>(embedded_.mesh.hexahedra.size()));
    keep_moved(HexFitWay::kSnapped, embedded_, {.point_rounds = 0, .slide_rounds = 0, .relaxations = 1});
  }

  void fit() {
    keep_moved(HexFitWay::kFitted, embedded_, {});
    // Without layers they are the mesh that was just moved.
    for (Layers& way : layers_) way.is_usable &= way.added > 0;
  }

  /// Makes both ways of layers: where they are needed, and one everywhere; first that of fewer hexahedra.
  /// Returns whether they are needed anywhere.
  bool add_layers_to_embedded() {
    require_memory_of(static_cast<double>(embedded_.mesh.hexahedra.size() + embedded_.mesh.boundary.size()));
    layers_ = {{{HexFitWay::kLayered, add_layers, embedded_}, {HexFitWay::kPadded, add_padding, embedded_}}};
    for (Layers& way : layers_) {
      way.added = way.add(way.embedded.mesh, way.embedded.features, way.embedded.embedding).hexahedra();
      way.is_usable = is_manifold(way.embedded.mesh);
    }
    // Both may be the same.
    Layers &layered = layers_[0], &padded = layers_[1];
    const bool are_needed = layered.is_usable && layered.added > 0;
    padded.is_usable &= padded.added > 0 && (padded.added != layered.added || !layered.is_usable);
    if (padded.is_usable && (padded.added < layered.added || !layered.is_usable)) std::swap(layered, padded);
    return are_needed;
  }

  /// With the layers that were added: the second way unless the first is good, or keeps all and the second is
  /// dearer by kMostBeside, or the first is off the model by what other layers do not mend.
  void fit_with_layers() {
    const auto first = static_cast<double>(layers_[0].embedded.mesh.hexahedra.size());
    const double most = std::min(kMostBeside * first, std::max(first, kMostForShapes));
    bool is_elsewhere = false;
    for (const Layers& way : layers_) {
      if (!way.is_usable) continue;
      const bool is_first = &way == &layers_[0];
      if (is_good() || is_elsewhere) return;
      const auto number = static_cast<double>(way.embedded.mesh.hexahedra.size());
      if (!is_first && is_faithful() && number > most) return;
      require_memory_of(number);
      is_elsewhere = keep_moved(way.way, way.embedded, {});
    }
  }

  /// Moves all vertices, with layers where angles need them: of five maps with which both were tried, moving
  /// them without was the best of none. It takes less memory, though.
  void fit_all() {
    std::optional<Error> limit;
    try {
      const bool needs_layers = !is_good() && add_layers_to_embedded();
      if (!needs_layers && !is_fine()) fit();
      if (!is_good()) fit_with_layers();
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kLimit) throw;
      limit = error;
    }
    if (!limit) return;
    if (std::ranges::none_of(fit_.tries, [](const HexFitTry& one) { return one.way >= HexFitWay::kFitted; }))
      fit();
    throw Error(*limit);
  }

  void stop() { fit_.is_stopped = true; }
  void limit(const Error& limit) { fit_.limit = limit; }

  FeatureFit result() && {
    if (fit_.tries.empty()) fit_.best.mesh = given_;
    return std::move(fit_);
  }

 private:
  /// An embedded mesh, moved onto its features. Returns whether it is valid and far off the model, which
  /// neither lifting nor other layers mend.
  bool keep_moved(HexFitWay way, const Embedded& embedded, const HexFittingOptions& options) {
    constexpr double kFar = 0.5;  // sizes, beyond what edges cut off
    HexMesh mesh = embedded.mesh;
    const HexCarriers carriers = carriers_in(embedded);
    fit_onto(mesh, embedded.features, carriers, sizes_.edge, options);
    tag_boundary(mesh, embedded);
    FittedMesh made = measured(std::move(mesh), features_, sizes_.judged);
    const SurfaceDistances& distances = made.measure.distances;
    const bool is_far =
        made.invalid == 0 && std::max(distances.of_mesh.largest, distances.of_model.largest) > kFar;
    const std::size_t unplaced = embedded.embedding.faults.size();
    try {
      if (made.invalid == 0 && made.least < kGoodShape && !is_far) lift(embedded, carriers, made);
    } catch (...) {
      keep(way, std::move(made), unplaced);
      throw;
    }
    keep(way, std::move(made), unplaced);
    return is_far;
  }

  /// Lifts poor hexahedra, where the mesh is better then.
  void lift(const Embedded& embedded, const HexCarriers& carriers, FittedMesh& made) const {
    HexMesh lifted = made.mesh;
    if (lift_patches(lifted, embedded.features, carriers, sizes_.edge) == 0) return;
    tag_boundary(lifted, embedded);
    FittedMesh other = measured(std::move(lifted), features_, sizes_.judged);
    if (is_better_fit(other, made)) made = std::move(other);
  }

  /// Soft curves without a path divide faces all the same: quads have the number of the nearest of those that
  /// are one in the embedding.
  void tag_boundary(HexMesh& mesh, const Embedded& embedded) const {
    const FacesOfQuads faces(mesh, embedded.features, embedded.embedding);
    const FeatureTrees trees(features_);
    std::vector<std::uint32_t> groups;
    for (const FeatureComplex::Face& face : features_.faces)
      groups.push_back(embedded.embedding.group_of_face[embedded.features.face_of[face.triangles.front()]]);
    parallel_for(mesh.boundary.size(), [&](std::size_t q) {
      HexMesh::Face& quad = mesh.boundary[q];
      const std::uint32_t index = faces.face(quad.vertices);
      if (index == Embedding::kNone) return;
      const FeatureComplex::Face& face = embedded.features.faces[index];
      Vector3 centre{0, 0, 0};
      for (const std::uint32_t v : quad.vertices) centre += 0.25 * mesh.vertices[v];
      const std::uint32_t nearest = trees.nearest_face(centre, face.below, face.above);
      const bool is_of_group = groups[nearest] == embedded.embedding.group_of_face[index];
      quad.tag = is_of_group ? features_.faces[nearest].number : face.number;
    });
  }

  void keep(HexFitWay way, FittedMesh made, std::size_t unplaced) {
    const std::size_t hexahedra = made.mesh.hexahedra.size();
    fit_.tries.push_back({way, hexahedra, hexahedra - given_.hexahedra.size(), unplaced,
                          made.measure.lacking.size(), made.least, made.invalid, stopwatch_.restart()});
    if (fit_.tries.size() > 1 && !is_better_fit(made, fit_.best)) return;
    fit_.best = std::move(made);
    fit_.best_try = fit_.tries.size() - 1;
  }

  struct Layers {
    HexFitWay way = HexFitWay::kLayered;
    AddedLayers (*add)(HexMesh&, const FeatureComplex&, Embedding&) = nullptr;
    Embedded embedded = {};
    std::size_t added = 0;
    bool is_usable = false;
  };

  const HexMesh& given_;
  const FeatureComplex& features_;
  const FitSizes sizes_;
  Stopwatch stopwatch_;
  Embedded embedded_;
  std::array<Layers, 2> layers_;
  FeatureFit fit_;
};

}  // namespace

FeatureMeasure sharp_feature_measure(const HexMesh& mesh, const FeatureComplex& features, double size) {
  std::vector<bool> is_soft;
  for (const FeatureComplex::Curve& curve : features.curves) is_soft.push_back(curve.is_soft);
  FeatureMeasure measure = feature_measure(mesh, without_curves(features, is_soft).complex, size);
  if (std::ranges::none_of(is_soft, [](bool soft) { return soft; })) return measure;
  FeatureMeasure of_faces = feature_measure(mesh, features, size);
  const auto is_of_face = [](const FeatureMeasure::Lack& lack) { return lack.kind == LackKind::kFace; };
  for (auto list : {&FeatureMeasure::lacking, &FeatureMeasure::too_small}) {
    std::erase_if(measure.*list, is_of_face);
    std::ranges::copy_if(of_faces.*list, std::back_inserter(measure.*list), is_of_face);
    std::ranges::stable_sort(measure.*list, {}, &FeatureMeasure::Lack::kind);
  }
  measure.faces = of_faces.faces;
  measure.small.back() = of_faces.small.back();
  return measure;
}

double bytes_to_fit_to(const FeatureComplex& features) {
  // 14 MB for the 22,600 triangles of housing, which have few curves; 35 MB for the 36,000 triangles and
  // 28,500 curves of a Menger sponge.
  constexpr double kOfTriangle = 650, kOfCurve = 500;
  return kOfTriangle * static_cast<double>(features.triangles.size()) +
         kOfCurve * static_cast<double>(features.curves.size());
}

bool FittedMesh::is_good() const {
  return invalid == 0 && measure.is_faithful() && least >= kGoodShape;
}

bool is_better_fit(const FittedMesh& mesh, const FittedMesh& other) {
  const auto worth = [](const FittedMesh& one) {
    const bool is_usable = one.invalid == 0 && one.least >= kPoorestShape;
    const auto lost = lost_features(one.measure);
    return std::tuple(one.invalid == 0, is_usable, -static_cast<double>(lost),
                      -static_cast<double>(one.measure.lacking.size() - lost), class_of(one.least),
                      -std::bit_width(one.poor), -static_cast<double>(one.mesh.hexahedra.size()));
  };
  return worth(mesh) > worth(other);
}

FeatureFit fitted_to_features(const HexMesh& mesh, const FeatureComplex& features, const FitSizes& sizes,
                              FitWays tried) {
  FittingWays ways(mesh, features, sizes);
  try {
    ways.measure_given();
    if (!ways.is_good() && is_manifold(mesh)) {
      ways.embed();
      if (tried == FitWays::kAll) {
        ways.snap();
        ways.fit_all();
      } else {
        ways.add_layers_to_embedded();
        ways.fit_with_layers();
        if (!ways.is_faithful()) ways.snap();
      }
    }
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kInterrupted)
      ways.stop();
    else if (error.kind() == ErrorKind::kLimit)
      ways.limit(error);
    else
      throw;
  }
  return std::move(ways).result();
}

}  // namespace crossgrain
