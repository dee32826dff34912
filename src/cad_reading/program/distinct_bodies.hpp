// SPDX-License-Identifier: Apache-2.0
// The bodies of a shape, each of them once.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

#include "cad_reading/program/bodies.hpp"

namespace crossgrain {

struct DistinctBodies {
  /// In the given order. Numbers (Body::solid) are places among all that were given, first the solids.
  std::vector<Body> solids, shells;
  std::vector<Warning> warnings;  ///< of what was left out
};

/// Returns solids, and shells of no solid, without those that are there already: a solid in the place of an
/// earlier one, and a shell that lies on faces of solids or of other shells, be it the very shell of a solid,
/// a copy of it or of a part of it. `tolerance` is in model units.
DistinctBodies distinct_bodies(const std::vector<TopoDS_Shape>& solids,
                               const std::vector<TopoDS_Shape>& shells, double tolerance);

}  // namespace crossgrain
