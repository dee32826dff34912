// SPDX-License-Identifier: Apache-2.0
// Whether hexahedra keep the features and the surface of their model.
#pragma once

#include "crossgrain/hex_features.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/hex_report.hpp"
#include "crossgrain/tet_domain.hpp"
#include "fit/feature_fit.hpp"
#include "measure/feature_measure.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// Returns the features of the surface around all solids of a model: of what its tets were made of
/// (TetMesh::given), or of their boundary with its tags.
FeatureComplex features_of_model(const TetDomain& domain);

/// The same of a surface.
FeatureComplex features_of_surface(TriangleMesh surface, const CreaseAngles& angles);

/// Returns what hexahedra that close up keep of features, in sizes of `size`.
HexFeatures features_kept(const HexMesh& mesh, const FeatureComplex& features, double size);

/// The same of hexahedra of one region that are measured already (sharp_feature_measure).
HexFeatures features_kept(const FeatureMeasure& measured);

/// Tells in a report how a mesh was fitted, and what it keeps. Without features where nothing was measured
/// before a stop.
void record(const FeatureFit& fit, HexReport& report);

/// Judges a result that is kAllHex so far by its features and its volume: kApproximate if it lacks any of
/// these, with reason, places and what to try; kPartial if it has another topology than its model. The report
/// has both, features if they were measured.
void judge_features(const HexMesh& mesh, HexReport& report);

}  // namespace crossgrain
