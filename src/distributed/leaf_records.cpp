// SPDX-License-Identifier: Apache-2.0
#include "distributed/leaf_records.hpp"

namespace crossgrain {
namespace {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

template <class Records, class Visit>
void for_lists(Records& records, const Visit& visit) {
  visit(records.numbers);
  visit(records.addresses);
  visit(records.centre_winding);
  visit(records.piece_counts);
  visit(records.pieces);
  for (auto& field : records.frames) visit(field);
}

}  // namespace

void append(LeafRecords& to, const GridLevel& level, std::span<const std::vector<StoredQuaternion>> frames,
            CellIndex begin, CellIndex end) {
  const auto append_range = [](auto& values, const auto& from, std::size_t first, std::size_t last) {
    values.insert(values.end(), from.begin() + static_cast<std::ptrdiff_t>(first),
                  from.begin() + static_cast<std::ptrdiff_t>(last));
  };
  append_range(to.addresses, level.tree.leaves(), begin, end);
  append_range(to.centre_winding, level.centre_winding, begin, end);
  for (CellIndex leaf = begin; leaf < end; ++leaf)
    to.piece_counts.push_back(level.piece_begin[leaf + 1] - level.piece_begin[leaf]);
  append_range(to.pieces, level.pieces, level.piece_begin[begin], level.piece_begin[end]);
  for (std::size_t f = 0; f < frames.size(); ++f) append_range(to.frames[f], frames[f], begin, end);
}

void append(LeafRecords& to, const LeafRecords& from) {
  append(to.numbers, from.numbers);
  append(to.addresses, from.addresses);
  append(to.centre_winding, from.centre_winding);
  append(to.piece_counts, from.piece_counts);
  append(to.pieces, from.pieces);
  for (std::size_t f = 0; f < from.frames.size(); ++f) append(to.frames[f], from.frames[f]);
}

Bytes packed(const LeafRecords& records) {
  Bytes message;
  message.reserve(records.size() *
                      (sizeof(CellAddress) + sizeof(StoredQuaternion) * records.frames.size() + 8) +
                  records.pieces.size() * sizeof(SurfacePiece));
  for_lists(records, [&](const auto& values) { append_list(message, values); });
  return message;
}

LeafRecords unpacked(std::span<const std::byte> message, std::size_t fields) {
  LeafRecords records;
  records.frames.resize(fields);
  if (message.empty()) return records;
  MessageReader reader(message);
  for_lists(records, [&]<class T>(std::vector<T>& values) { values = reader.take_list<T>(); });
  return records;
}

}  // namespace crossgrain
