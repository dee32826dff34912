// SPDX-License-Identifier: Apache-2.0
// How much a surface turns across an edge between two of its faces.
#pragma once

#include "surface/feature_edges.hpp"
#include "surface/feature_fans.hpp"

namespace crossgrain {

/// Returns the angle between the normals of the true surface on the two sides of an edge of two triangles
/// that continue each other, in degrees. Exact normals tell it (TriangleMesh::corner_normals). Without them
/// it is that between the triangles, less what the surface turns by within half a triangle: a fillet of
/// facets of 20 degrees ends 10 degrees off the plane beside it. The turn of the nearest triangles of either
/// face as a linear function of their distance from the edge tells that.
double turn_deg_across(const FeatureEdge& edge, const FeatureFans& fans, const Surface& surface);

}  // namespace crossgrain
