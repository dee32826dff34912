// SPDX-License-Identifier: Apache-2.0
#include "field/field_data.hpp"

#include <utility>

namespace crossgrain {
namespace {

/// Calls change(values) for every list with an entry per leaf that is not empty, and sets the tree to
/// changed(leaves).
template <class Change>
void change_leaves(FieldData& data, const Change& change) {
  const RootCube root = data.tree.root();
  std::vector<CellAddress> leaves = data.tree.leaves();
  data.tree = Octree(root, {});
  change(leaves);
  data.tree = Octree(root, std::move(leaves));
  change(data.frames);
  change(data.open_faces);
  change(data.on_boundary);
  change(data.energy_density);
  change(data.alignment_deg);
  change(data.constraints);
  change(data.regions);
}

}  // namespace

void leave_own_leaves(FieldData& data) {
  if (!data.part) return;
  const Share share = *data.part;
  change_leaves(data, [&]<class T>(std::vector<T>& values) {
    if (!values.empty()) values = own_values(share, values);
  });
  data.part->begin = 0;
  data.part->end = static_cast<std::uint32_t>(share.size());
}

void move_to_first(FieldData& data) {
  if (!data.part) return;
  Exchange& exchange = *data.part->exchange;
  change_leaves(
      data, [&]<class T>(std::vector<T>& values) { values = moved_to_first(exchange, std::move(values)); });
  data.part.reset();
}

}  // namespace crossgrain
