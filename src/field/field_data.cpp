// SPDX-License-Identifier: Apache-2.0
#include "field/field_data.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
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
  if (data.part.is_whole()) return;
  const Share share = data.part;
  change_leaves(data, [&]<class T>(std::vector<T>& values) {
    if (!values.empty()) values = own_values(share, values);
  });
  data.part.begin = 0;
  data.part.end = static_cast<std::uint32_t>(share.size());
}

void renumber(FieldData& data) {
  if (data.part.is_whole()) return;
  Share& share = data.part;
  const auto sizes = gathered_value<std::uint64_t>(*share.exchange, data.tree.size());
  const auto own = sizes.begin() + share.exchange->rank();
  share.begin = 0;
  share.end = static_cast<std::uint32_t>(*own);
  share.before = std::accumulate(sizes.begin(), own, std::uint64_t{0});
  share.of_all = std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0});
}

void unite_cells(FieldData& data, int depth) {
  if (data.part.is_whole()) return;
  Exchange& exchange = *data.part.exchange;
  const std::vector<CellAddress>& leaves = data.tree.leaves();
  const auto cell_of = [&](CellAddress leaf) { return leaf.ancestor_at(depth); };
  struct LastCell {
    bool exists = false;
    CellAddress cell = CellAddress::root();
  };
  LastCell mine;
  if (!leaves.empty()) mine = {true, cell_of(leaves.back())};
  const std::vector<LastCell> last = gathered_value(exchange, mine);
  const auto own_rank = static_cast<std::size_t>(exchange.rank());
  std::size_t owner = own_rank, moved = 0;
  if (!leaves.empty()) {
    const CellAddress first = cell_of(leaves.front());
    for (owner = 0; owner < own_rank; ++owner)
      if (last[owner].exists && last[owner].cell == first) break;
    if (owner != own_rank)
      moved = static_cast<std::size_t>(
          std::ranges::find_if(leaves, [&](CellAddress leaf) { return cell_of(leaf) != first; }) -
          leaves.begin());
  }
  change_leaves(data, [&]<class T>(std::vector<T>& values) {
    std::vector<Bytes> to(static_cast<std::size_t>(exchange.ranks()));
    const std::size_t count = std::min(moved, values.size());
    if (count > 0) append_to<T>(to[owner], std::span(values).first(count));
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    for (const Bytes& part : exchange.delivered(std::move(to))) {
      const std::vector<T> more = MessageReader(part).take<T>(part.size() / sizeof(T));
      values.insert(values.end(), more.begin(), more.end());
    }
  });
  renumber(data);
}

void move_to_first(FieldData& data) {
  if (data.part.is_whole()) return;
  Exchange& exchange = *data.part.exchange;
  change_leaves(
      data, [&]<class T>(std::vector<T>& values) { values = moved_to_first(exchange, std::move(values)); });
  data.part = {};
}

}  // namespace crossgrain
