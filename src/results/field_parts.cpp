// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/field_parts.hpp"

#include <memory>
#include <utility>

#include "field/field_data.hpp"
#include "grid/merged_depth.hpp"
#include "results/output_cells.hpp"

namespace crossgrain {
namespace {

/// Returns the whole of the parts in the first process.
std::optional<FrameField> gathered(std::shared_ptr<FieldData> part) {
  const bool is_first = part->share().is_of_first();
  move_to_first(*part);
  return is_first ? std::optional(FrameField(std::move(part))) : std::nullopt;
}

}  // namespace

std::optional<FrameField> whole_of_parts(FrameField part) {
  if (part.data().share().is_whole()) return part;
  auto data = std::make_shared<FieldData>(part.data());
  part = FrameField(std::make_shared<FieldData>());  // makes room
  return gathered(std::move(data));
}

std::optional<FrameField> thinned_from_parts(const FrameField& part, std::size_t most_cells) {
  const FieldData& data = part.data();
  if (data.share().is_whole()) return part;
  OutputOptions options;
  options.level = merged_depth(data.tree, most_cells, kMaxDepth, data.share());
  auto thinned = std::make_shared<FieldData>(merged_part(data, options, {}));
  thinned->surface = data.surface;
  thinned->singularities = data.singularities;
  return gathered(std::move(thinned));
}

}  // namespace crossgrain
