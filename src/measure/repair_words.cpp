// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>

#include "crossgrain/message.hpp"
#include "crossgrain/report.hpp"

namespace crossgrain {

std::string sentence_of(const SolveReport::Onto::Repair& repair, const SolveReport::Singularity& after) {
  const std::string moved = repair.moved_vertices == 0
                                ? ""
                                : fmt::format("; {} moved, so that arcs run straight",
                                              counted(repair.moved_vertices, "vertex", "vertices"));
  if (repair.moves == 0)
    return fmt::format("no matching changed; {} left", counted(repair.faults, "fault")) + moved;
  const auto change = [](std::size_t before, std::size_t now) {
    return fmt::format("{} (before {})", now, before);
  };
  std::string text = fmt::format(
      "places where no hexahedra can meet: {}; singular edges: {}, touching the surface: {}; arcs: {} "
      "removed, {} shortened, {} led to the surface",
      change(repair.faults_before, repair.faults), change(repair.edges_before, after.edges),
      change(repair.contacts_before, after.contacts), repair.removed_arcs, repair.shortened_arcs,
      repair.led_arcs);
  text += fmt::format("; energy of the frames {:.4g} for {:.4g}", repair.energy, repair.energy_before);
  if (repair.bent_edges > 0)
    text += fmt::format("; the map turns otherwise than the surface along edges of a length of {:.3g} in all",
                        repair.bent_length);
  return text + moved;
}

}  // namespace crossgrain
