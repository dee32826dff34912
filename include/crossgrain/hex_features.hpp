// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// @{

/// What a mesh of hexahedra may lack of its model.
enum class HexLackKind : int {
  kCorner,    ///< no vertex on it
  kCrease,    ///< no unbroken path of edges along it
  kFace,      ///< no quads
  kOffModel,  ///< the mesh is too far from the model
  kOffMesh,   ///< the model is too far from the mesh
  kVolume     ///< is too far off
};

/// Returns a name for files and scripts: "corner".
const char* name_of(HexLackKind kind);

/// What hexahedra keep of the features of a model; sizes are those asked for (HexReport::size). A feature is
/// *resolved* unless it is shorter than two sizes or another one runs within one size of it; only resolved
/// ones count. Soft features, such as the border of a fillet, do not.
struct HexFeatures {
  struct Lack {
    HexLackKind kind{};
    std::int32_t number = 0;  ///< of the face, or of the edge in its file; 0 without
    Vector3 place{0, 0, 0};

    /// Corners, creases and distances: how far off, in sizes; -1 if nothing is near. Volumes:
    /// the mesh's over the model's.
    double figure = 0;
    double share = 0;         ///< of a crease's length that is kept
    double size_to_show = 0;  ///< size of hexahedra that resolves it, for what is smaller than these; else 0
  };

  /// All that count, and those of them that are kept; lengths in the unit of the model.
  struct Kept {
    double all = 0, kept = 0;
  };

  /// Between the surfaces of hexahedra and model, in sizes: beyond what straight edges cut off a
  /// curved surface (k e^2 / 8 for an edge of length e at curvature k), and in all.
  struct Distances {
    double percentile_99 = 0, largest = 0;
    Vector3 place{0, 0, 0};
    double largest_in_all = 0;
    Vector3 place_in_all{0, 0, 0};
  };

  Kept corners, creases, crease_length, faces;
  Distances of_mesh, of_model;  ///< of the mesh from the model, and of the model from the mesh
  double volume_ratio = 1;      ///< the mesh's over the model's

  /// Euler number of each closed surface, ascending: 2 of a sphere, less 2 for each tunnel through it. Empty
  /// of a surface that does not close up.
  std::vector<int> shells, model_shells;

  std::vector<Lack> lacking;    ///< why hexahedra are only approximate
  std::vector<Lack> too_small;  ///< smaller than the hexahedra and not kept
  std::size_t small = 0;        ///< corners, creases and faces that are smaller, kept or not

  /// Whether all that is resolved is kept, and the surface within the limits.
  bool is_faithful() const { return lacking.empty(); }

  /// Whether the mesh has as many closed surfaces as the model, with as many tunnels; if that is known.
  bool has_topology_of_model() const {
    return shells.empty() || model_shells.empty() || shells == model_shells;
  }
};

/// How a mesh that roughly fills a model is made to keep its features.
enum class HexFitWay : int {
  kAsMapped,  ///< it is left as it was extracted and smoothed
  kSnapped,   ///< single vertices are moved onto corners, creases and faces
  kFitted,    ///< all vertices are moved at once, then single ones, then those around poor hexahedra
  kLayered,   ///< the same, with layers of hexahedra where the model's angles need them
  kPadded     ///< the same, with one layer of hexahedra everywhere at the surface
};

/// Returns a name for files and scripts: "as_mapped".
const char* name_of(HexFitWay way);

/// One way, and what came of it.
struct HexFitTry {
  HexFitWay way{};
  std::size_t hexahedra = 0, added = 0;  ///< beside those given
  std::size_t unplaced = 0;              ///< corners, creases and faces that the mesh has no place for
  std::size_t lacking = 0;               ///< HexFeatures::lacking
  double least = 0;                      ///< scaled Jacobian
  std::size_t inverted = 0;
  double seconds = 0;
};

/// Returns what is lacking: "2 creases are not kept, the first, edge 14, around 1 2 3"; empty if nothing is.
/// `size` is that asked for (HexReport::size), which distances are given beside.
std::string lacks_of(const HexFeatures& features, double size);

/// Returns how the topology differs: "it has 1 tunnel, the model 2"; empty if it does not.
std::string topology_of(const HexFeatures& features);

/// Returns what is kept: "8 of 8 corners, 12 of 12 creases and 6 of 6 faces kept; 3 others smaller than
/// the hexahedra, 2 of which are not kept".
std::string kept_of(const HexFeatures& features);

/// @}

}  // namespace crossgrain
