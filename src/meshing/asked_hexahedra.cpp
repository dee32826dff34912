// SPDX-License-Identifier: Apache-2.0
#include "meshing/asked_hexahedra.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "crossgrain/error.hpp"
#include "hex/hex_forecast.hpp"
#include "hex/hex_memory.hpp"
#include "measure/part_size.hpp"
#include "meshing/hexahedra_of_models.hpp"

namespace crossgrain {
namespace {

/// Hexahedra that must fit across most of a part: with one, a wall has no vertex inside, and a map must round
/// both of its sides to neighbouring planes.
constexpr double kAcross = 2;

void check_count(double expected, double size, const PartSize& part) {
  if (expected <= kMostHexahedra) return;
  throw Error(
      ErrorKind::kLimit,
      {"", "",
       fmt::format("about {:.2g} hexahedra of {} would fill the part, which is {} across, but at most "
                   "{:.2g} are made",
                   expected, length_text(size, part.unit), length_text(part.longest, part.unit),
                   kMostHexahedra),
       Remedy::kTakeLargerHexahedra});
}

}  // namespace

void AskedHexahedra::check(const SearchableSurface& surface) {
  if (std::exchange(is_checked_, true)) return;
  check_scale(surface.surface().box);
  const PartSize part = part_size(surface.surface());
  const HexOptions& asked = options_.hexahedra;
  const double size = asked.size > 0 ? asked.size : part.longest / asked.cells;
  const double expected = part.volume / size / size / size;
  check_asked_size({size, "hexahedra", 1, HexOptions().cells, expected, Remedy::kGiveHexSize}, part);
  const double of_tets = options_.tets.size;
  if (of_tets > 0) {
    const double tets = part.volume / of_tets / of_tets / of_tets;
    check_asked_size({of_tets, "tets", 1, TetMakingOptions().edges, tets, Remedy::kGiveTetSize}, part);
    warn_of_many_tets(part);
  } else {
    check_count(expected, size, part);
  }
  require_memory_of_hexahedra(expected);
  const double thickness = usual_thickness(surface.bvh());
  if (kAcross * size <= thickness) return;
  // No size is named: whether the mesh needs a finer one shows when it is there, and is said then.
  warn({WarningKind::kThinPart,
        fmt::format("less than {:g} hexahedra of {} fit across most of the part, which is {} thick there: "
                    "most walls may get one",
                    kAcross, length_text(size, part.unit), length_text(thickness, part.unit))});
}

void AskedHexahedra::warn_of_many_tets(const PartSize& part) {
  const double size = options_.tets.size, expected = expected_tets(part, size);
  if (expected <= static_cast<double>(kLargeTets)) return;
  warn({WarningKind::kManyTets,
        fmt::format("about {:.2g} tets of {} are made, as asked for; without a size they would be at most "
                    "about {}, and the work grows with them",
                    expected, length_text(size, part.unit), kLargeTets),
        Remedy::kTakeLargerTets});
}

void AskedHexahedra::warn(const Warning& warning) {
  warnings_.push_back(warning);
  if (options_.on_warning) options_.on_warning(warning);
}

}  // namespace crossgrain
