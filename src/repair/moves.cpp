// SPDX-License-Identifier: Apache-2.0
#include "repair/moves.hpp"

#include <algorithm>
#include <optional>

namespace crossgrain {
namespace {

/// The same as crossings around an edge from which those of `changes` are known.
class ChangedField {
 public:
  explicit ChangedField(const MatchedField& field) : field_(field) {}

  void add(const FaceChange& change) { changes_.push_back(change); }
  const std::vector<FaceChange>& changes() const { return changes_; }

  std::uint8_t across(const Crossing& crossing) const {
    const auto changed = std::find_if(changes_.begin(), changes_.end(),
                                      [&](const FaceChange& change) { return change.face == crossing.face; });
    if (changed == changes_.end()) return field_.across(crossing);
    return crossing.reversed ? CubeGroup::instance().inverse_of(changed->matching) : changed->matching;
  }

  /// The matching of a face with which an edge of it gets the holonomy that it should have, if all other
  /// matchings stay; none if it should have none.
  std::optional<std::uint8_t> freeing(std::uint32_t edge, std::uint32_t face) const {
    const CubeGroup& group = CubeGroup::instance();
    const auto around = field_.complex().around(edge);
    const auto found = std::find_if(around.begin(), around.end(),
                                    [&](const Crossing& crossing) { return crossing.face == face; });
    if (found == around.end()) return std::nullopt;  // beside another fan of a branched edge
    std::uint8_t before = CubeGroup::kIdentity, after = CubeGroup::kIdentity;
    for (auto crossing = around.begin(); crossing != found; ++crossing)
      before = group.product(across(*crossing), before);
    for (auto crossing = found + 1; crossing != around.end(); ++crossing)
      after = group.product(across(*crossing), after);
    const std::uint8_t now = group.product(after, group.product(across(*found), before));
    const auto wanted = field_.wanted_holonomy(edge, now);
    if (!wanted) return std::nullopt;
    // The product after * across * before must become the wanted one.
    const std::uint8_t matching =
        group.product(group.inverse_of(after), group.product(*wanted, group.inverse_of(before)));
    return found->reversed ? group.inverse_of(matching) : matching;
  }

 private:
  const MatchedField& field_;
  std::vector<FaceChange> changes_;
};

}  // namespace

std::vector<FaceChange> push_changes(const MatchedField& field, std::uint32_t vertex,
                                     std::span<const std::uint32_t> way,
                                     std::span<const std::uint32_t> faces) {
  ChangedField changed(field);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const auto matching = changed.freeing(field.complex().edge_between(vertex, way[k]), faces[k]);
    if (!matching) break;
    changed.add({faces[k], *matching});
  }
  return changed.changes();
}

}  // namespace crossgrain
