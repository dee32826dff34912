// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/names.hpp"
#include "crossgrain/hex_features.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/place.hpp"

namespace crossgrain {
namespace {

using Lack = HexFeatures::Lack;

/// What is wrong with all features of a kind: "2 creases are not kept".
std::string words_of_features(HexLackKind kind, std::size_t count) {
  const char* const verb = count == 1 ? "is" : "are";
  switch (kind) {
    case HexLackKind::kCorner:
      return fmt::format("{} {} not kept", counted(count, "corner"), verb);
    case HexLackKind::kCrease:
      return fmt::format("{} {} not kept", counted(count, "crease"), verb);
    default:
      return fmt::format("{} {} no quads", counted(count, "face"), count == 1 ? "has" : "have");
  }
}

/// Returns which is the first: ", face 4 around 1 2 3".
std::string words_of_first(const Lack& lack, std::size_t count) {
  std::string name;
  if (lack.number != 0 && lack.kind == HexLackKind::kFace) name = fmt::format("face {} ", lack.number);
  if (lack.number != 0 && lack.kind == HexLackKind::kCrease) name = fmt::format("edge {} ", lack.number);
  return fmt::format("{}, {}around {}", count == 1 ? "" : ", the first", name, words_of_place(lack.place));
}

std::string words_of_distance(const Lack& lack, double size) {
  if (lack.kind == HexLackKind::kVolume)
    return fmt::format("its volume is {:.2g} % {} the model's", 100 * std::abs(lack.figure - 1),
                       lack.figure < 1 ? "below" : "above");
  return fmt::format("{} up to {:.2g} {} around {}, {:.2g} of the size",
                     lack.kind == HexLackKind::kOffModel ? "the mesh is" : "the surface is",
                     size * lack.figure, lack.kind == HexLackKind::kOffModel ? "off the surface" : "from it",
                     words_of_place(lack.place), lack.figure);
}

/// "2 closed surfaces", or "1 tunnel" where all of these are alike.
std::string words_of_shells(const std::vector<int>& shells, bool by_surfaces) {
  if (by_surfaces) return counted(shells.size(), "closed surface");
  std::size_t tunnels = 0;
  for (const int euler : shells) tunnels += static_cast<std::size_t>((2 - euler) / 2);
  return counted(tunnels, "tunnel");
}

std::string words_of_kept(const HexFeatures::Kept& kept, const char* one, const char* several) {
  return fmt::format("{:.0f} of {:.0f} {}", kept.kept, kept.all, kept.all == 1 ? one : several);
}

}  // namespace

const char* name_of(HexLackKind kind) {
  constexpr std::array kNames{"corner", "crease", "face", "off_model", "off_mesh", "volume"};
  return name_among<HexLackKind::kVolume>(kNames, kind);
}

const char* name_of(HexFitWay way) {
  constexpr std::array kNames{"as_mapped", "snapped", "fitted", "layered", "padded"};
  return name_among<HexFitWay::kPadded>(kNames, way);
}

std::string topology_of(const HexFeatures& features) {
  if (features.has_topology_of_model()) return "";
  const bool by_surfaces = features.shells.size() != features.model_shells.size();
  const std::string of_mesh = words_of_shells(features.shells, by_surfaces);
  const std::string of_model = words_of_shells(features.model_shells, by_surfaces);
  if (of_mesh == of_model) return "its closed surfaces have tunnels at other places than the model's";
  return fmt::format("it has {}, the model {}", of_mesh, of_model);
}

std::string lacks_of(const HexFeatures& features, double size) {
  std::vector<std::string> parts;
  for (const HexLackKind kind : {HexLackKind::kCorner, HexLackKind::kCrease, HexLackKind::kFace}) {
    const auto is_of = [kind](const Lack& lack) { return lack.kind == kind; };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(features.lacking, is_of));
    if (count == 0) continue;
    const Lack& first = *std::ranges::find_if(features.lacking, is_of);
    std::string place = words_of_first(first, count);
    if (count == 1) place.erase(0, 2);
    parts.push_back(words_of_features(kind, count) + (count == 1 ? ": " : "") + place);
  }
  for (const Lack& lack : features.lacking)
    if (lack.kind > HexLackKind::kFace) parts.push_back(words_of_distance(lack, size));
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::string kept_of(const HexFeatures& features) {
  std::vector<std::string> parts;
  if (features.corners.all > 0) parts.push_back(words_of_kept(features.corners, "corner", "corners"));
  if (features.creases.all > 0) parts.push_back(words_of_kept(features.creases, "crease", "creases"));
  if (features.faces.all > 0) parts.push_back(words_of_kept(features.faces, "face", "faces"));
  std::string text = parts.empty() ? "" : fmt::format("{} kept", fmt::join(parts, ", "));
  if (const std::size_t small = features.small; small > 0) {
    const std::size_t lost = features.too_small.size();
    text += fmt::format("{}{}{} smaller than the hexahedra, {}", text.empty() ? "" : "; ",
                        parts.empty() ? counted(small, "feature") : std::to_string(small),
                        parts.empty() ? ""
                        : small == 1  ? " other"
                                      : " others",
                        lost == 0 ? "kept too" : fmt::format("{} of which are not kept", lost));
  }
  return text;
}

}  // namespace crossgrain
