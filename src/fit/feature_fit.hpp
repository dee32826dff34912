// SPDX-License-Identifier: Apache-2.0
// A mesh of hexahedra that roughly fills a model, made to keep its corners, creases and faces.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/hex_features.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "measure/feature_measure.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// Returns what hexahedra keep of a model. Corners and creases are those without the soft curves: a crease
/// goes on where only these end in it. Faces are divided by soft curves too. Places are found from the mesh
/// alone, not taken from an embedding. The numbers of corners and curves are those without soft ones.
FeatureMeasure sharp_feature_measure(const HexMesh& mesh, const FeatureComplex& features, double size);

/// A mesh, and what it keeps of its model.
struct FittedMesh {
  HexMesh mesh;
  FeatureMeasure measure;
  double least = 0;         ///< scaled Jacobian
  std::size_t poor = 0;     ///< hexahedra below a scaled Jacobian of a tenth
  std::size_t invalid = 0;  ///< hexahedra that are not valid (is_valid)

  /// Whether nothing better is looked for.
  bool is_good() const;
};

struct FeatureFit {
  FittedMesh best;
  std::vector<HexFitTry> tries;  ///< none if a stop came before the mesh as given was measured
  std::size_t best_try = 0;
  bool is_stopped = false;          ///< by Monitor::stop: the best of those that had ended by then
  std::optional<Error> limit = {};  ///< of memory, which kept other ways from being tried
};

struct FitSizes {
  double edge;    ///< about that of the hexahedra
  double judged;  ///< in which lengths of features and distances are counted: the size asked for
};

/// Which ways are tried: of the cells of a lattice, steps stand where faces are, and only layers of new
/// hexahedra turn these into faces; single vertices are moved there where these keep less.
enum class FitWays { kAll, kLayersOnly };

/// Returns the best of: the mesh as given; it with single vertices moved onto the features after these are
/// embedded in its surface; with all vertices moved at once, unless the model's angles need layers; and the
/// same with layers where they need them, or with one everywhere (first the way of fewer hexahedra). Poor
/// hexahedra of each are lifted (lift_patches). A way is tried only if those
/// before have lost something, or have shapes below kGoodShape; and none on a mesh that touches itself in an
/// edge or a vertex. The best is valid; then it lacks the fewest features; then is near the surface; then its
/// worst hexahedron is of the better class; then it has less than half as many poor ones; then fewer
/// hexahedra.
///
/// Quads have the number of the model's face that they lie on.
/// Old vertices and hexahedra keep their numbers. Regions stay; hexahedra of all regions are one solid here.
/// The same to the bit for any number of threads. A stop of watched loops, and their limit of
/// memory, return what there is.
FeatureFit fitted_to_features(const HexMesh& mesh, const FeatureComplex& features, const FitSizes& sizes,
                              FitWays tried = FitWays::kAll);

/// Worst scaled Jacobians: good ones, and the least that finite elements are commonly computed on.
inline constexpr double kGoodShape = 0.2, kPoorestShape = 0.02;

/// Bytes for a hexahedron while it is fitted, beyond the mesh as given: 2.2 kB on n03c of 14,000.
inline constexpr double kBytesOfFittedHexahedron = 2800;

/// Returns the bytes that a model itself takes while hexahedra are fitted to it and measured.
double bytes_to_fit_to(const FeatureComplex& features);

/// Whether a mesh is worth more than another.
bool is_better_fit(const FittedMesh& mesh, const FittedMesh& other);

}  // namespace crossgrain
