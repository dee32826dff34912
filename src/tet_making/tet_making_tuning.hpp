// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>

#include "crossgrain/tet_making.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {

/// TetMakingOptions with what only tests and the search for hexahedra set.
struct TetMakingTuning : TetMakingOptions {
  /// Whether there are `edges` along the longest side even where `size` is larger.
  bool at_least_edges = false;

  /// Remeshing::smallest_share.
  double smallest_share = 0.1;

  /// Unless empty, judges whether the sizes suit the part, in place of what is usual of tets: called with its
  /// closed surface before tets are made.
  std::function<void(const SearchableSurface& part)> on_solid = {};

  /// The programs; if empty, those of `cad_program`, `gmsh_program` and `netgen_program`.
  std::filesystem::path cad_program = {};
  std::filesystem::path gmsh = {};
  std::filesystem::path netgen = {};

  /// Largest edge of the tets of a model with this longest side.
  double size_for(double longest) const {
    const double of_edges = longest / edges;
    return size == 0 ? of_edges : at_least_edges ? std::min(size, of_edges) : size;
  }
};

TetMesh make_tets(const std::filesystem::path& model, const TetMakingTuning& options,
                  const Monitor& monitor = {});
TetMesh make_tets(const TriangleMesh& surface, const TetMakingTuning& options, const Monitor& monitor = {});

}  // namespace crossgrain
