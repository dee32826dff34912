// SPDX-License-Identifier: Apache-2.0
// Whether the sizes that are asked for suit the part, before the work.
#pragma once

#include <vector>

#include "crossgrain/hex_meshing.hpp"
#include "measure/part_size.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {

class AskedHexahedra {
 public:
  /// The options must outlive the object.
  explicit AskedHexahedra(const HexMeshingOptions& options) : options_(options) {}

  /// Throws Error(kInput) by `check_scale`, Error(kUsage) if hexahedra or tets are too large for the part or
  /// too small, Error(kLimit) if hexahedra need more tets than are made. Hands out warnings if few hexahedra
  /// fit across most of the part, and if the tets of a given size are many. Only the first call counts: tets
  /// of other sizes are of the same part.
  void check(const SearchableSurface& part);

  /// For the report.
  const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  void warn_of_many_tets(const PartSize& part);
  void warn(const Warning& warning);

  const HexMeshingOptions& options_;
  bool is_checked_ = false;
  std::vector<Warning> warnings_;
};

}  // namespace crossgrain
