// SPDX-License-Identifier: Apache-2.0
// What hexahedra keep of a model's features and shape.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "measure/feature_paths.hpp"
#include "measure/feature_resolution.hpp"
#include "measure/surface_distance.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// Limits of a mesh that follows its model: distances in sizes of hexahedra, beyond what straight edges cut
/// off and in all, and the share of a solid's volume. A bare cylinder needs twelve edges around for these.
inline constexpr double kMostOff99 = 0.1, kMostOff = 0.2, kMostOffInAll = 0.35, kMostVolumeOff = 0.05;

/// Length that rounding may take from a curve that is kept.
inline constexpr double kWhole = 0.999;

struct FeatureMeasure {
  enum class Kind : std::uint8_t {
    kCorner,    ///< no vertex on it
    kCurve,     ///< no unbroken path of edges along it
    kFace,      ///< no quads
    kOffModel,  ///< the mesh is too far from the model
    kOffMesh,   ///< the model is too far from the mesh
    kVolume     ///< of a solid
  };

  /// What the mesh lacks, or what is smaller than its hexahedra.
  struct Lack {
    Kind kind;
    std::uint32_t index;  ///< in the complex; of a volume the number of the solid there
    std::int32_t number;  ///< of the face, or tag of the curve, in the model; 0 without
    Vector3 place;

    /// Corners, curves and distances: distance in sizes, infinite where nothing is near. Faces: 0 quads.
    /// Volumes: the mesh's over the model's.
    double figure;
    double share;         ///< of a curve's length that is kept; otherwise 0
    double size_to_show;  ///< of hexahedra, for what is smaller than these; otherwise 0
  };

  /// All of those that count, and those kept; lengths in model units.
  struct Kept {
    double all = 0, kept = 0;
    double share() const { return all > 0 ? kept / all : 1; }
  };

  double size = 0;
  Kept corners, curves, curve_length, faces;  ///< resolved ones; without soft curves and their corners
  std::size_t soft_curves = 0, soft_curves_kept = 0;

  std::vector<Lack> lacking;           ///< by kind, then by index
  std::vector<Lack> too_small;         ///< unresolved corners, curves and faces that are not kept
  std::array<std::size_t, 3> small{};  ///< unresolved corners, curves and faces, kept or not

  SurfaceDistances distances;
  double volume_ratio = 1;  ///< that of the solid whose volume is farthest off; 1 of an open model

  /// Of the surfaces around all solids: euler_numbers_of_shells.
  std::vector<int> shells, model_shells;

  std::vector<double> corner_distances;     ///< of each corner's vertex in sizes; infinite without
  std::vector<CurveShare> curve_shares;     ///< of each curve
  std::vector<std::size_t> quads_of_faces;  ///< of each face
  FeatureResolution resolution;

  /// Whether all that is resolved is kept, and distances and volumes are within the limits.
  bool is_faithful() const { return lacking.empty(); }
};

/// Returns the number of each hexahedron's solid in a complex: its region + 1, or the only one there.
std::vector<std::int32_t> solids_in(const HexMesh& mesh, const FeatureComplex& complex);

/// Measures hexahedra of about this size against the features of their model. `places` tells where features
/// lie on the mesh, with quads as `surface_quads` lists them; if null, `found_places` does.
FeatureMeasure feature_measure(const HexMesh& mesh, const FeatureComplex& complex, double size,
                               const FeaturePlaces* places = nullptr);

}  // namespace crossgrain
