// SPDX-License-Identifier: Apache-2.0
// Models that hexahedra are put onto, from files and surfaces.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/hex_fit.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/types.hpp"
#include "hex/model_fitting.hpp"

namespace crossgrain {

/// A model as hexahedra are put onto it, with what a report says of it.
struct ReadModel {
  FittingModel model;
  SolveReport::Model description;
  std::vector<ModelFace> faces;
  std::vector<Warning> warnings;
  std::size_t solids = 1;  ///< of a CAD file, or regions of tets
};

/// Reads a CAD file, a surface or a tet mesh. The monitor hears of the model. Throws as `read_surface`
/// and `read_tets` do, naming the file, and Error(kInput) for surfaces that bound no solid.
ReadModel read_model(const std::filesystem::path& path, const HexFitOptions& options, const Monitor& monitor);

/// The same of a surface, which is closed (ClosedModel).
ReadModel model_of(TriangleMesh surface, const HexFitOptions& options);

/// Throws Error(kUsage) for a size below which a mesh of tets would lose holes and bosses.
void check_no_defeature(double size);

/// Returns an error with the name of the model's file, if it is about the model or what is asked of it.
Error named(const Error& error, const std::filesystem::path& model);

}  // namespace crossgrain
