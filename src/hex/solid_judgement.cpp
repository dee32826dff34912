// SPDX-License-Identifier: Apache-2.0
#include "hex/solid_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "crossgrain/message.hpp"
#include "crossgrain/place.hpp"
#include "measure/body_contacts.hpp"
#include "measure/hex_interfaces.hpp"

namespace crossgrain {
namespace {

/// Faces between hexahedra of two solids keep to those of the model if they are this near, in sizes: what
/// smoothing may leave of the surface.
constexpr double kOnInterface = 0.05;

void judge_contacts(const std::vector<BodyContact>& contacts, HexReport& report) {
  report.outcome = HexOutcome::kFlawed;
  for (const BodyContact& contact : contacts)
    if (report.places.size() < HexReport::kMostPlaces) report.places.push_back(contact.place);
  const Warning warning = warning_of(contacts);
  report.reason = warning.text;
  report.remedy = warning.remedy;
}

void judge_empty_solids(const std::vector<std::int32_t>& empty, HexReport& report) {
  report.outcome = HexOutcome::kFlawed;
  report.reason =
      empty.size() == 1
          ? fmt::format("solid {} is smaller than the hexahedra and has none", empty.front())
          : fmt::format("{} solids are smaller than the hexahedra and have none, the first is solid {}",
                        empty.size(), empty.front());
  report.remedy = Remedy::kTakeSmallerHexahedra;
}

/// Whether a warning is about solids that meet, as the field on the grid or the tets told them.
bool is_of_contact(const Warning& warning) {
  switch (warning.kind) {
    case WarningKind::kOverlappingSolids:
    case WarningKind::kTouchingSolids:
    case WarningKind::kUnmergedVertices:
      return true;
    case WarningKind::kSurfaceFinding:
      return warning.text.starts_with(name_of(FindingKind::kOverlappingComponents)) ||
             warning.text.starts_with(name_of(FindingKind::kTouchingComponents));
    default:
      return false;
  }
}

}  // namespace

void judge_solids(const HexMesh& mesh, const TetSolid& model, HexReport& report, SolveReport& whole) {
  const bool is_united = whole.onto->united;
  const HexInterfaces interfaces = interfaces_of(mesh, model, kOnInterface * report.used_size);
  report.interface_faces = interfaces.faces;
  report.largest_interface_distance = interfaces.largest_distance;
  if (interfaces.off > 0 && !is_united) {
    whole.warnings.emplace_back(
        WarningKind::kCrossedInterfaces,
        fmt::format(
            "hexahedra do not keep to the faces between solids: {} of {} between them are off, by up to "
            "{:.2g} ({:.2g} of their size) at {}; smaller hexahedra come closer",
            interfaces.off, counted(interfaces.faces, "face"), interfaces.largest_distance,
            interfaces.largest_distance / report.used_size, words_of_place(interfaces.place)));
  }
  if (report.outcome != HexOutcome::kAllHex) return;
  if (const std::vector<BodyContact> contacts = body_contacts(model); !contacts.empty()) {
    judge_contacts(contacts, report);
    std::erase_if(whole.warnings, is_of_contact);
  } else if (!interfaces.empty_regions.empty() && !is_united) {
    judge_empty_solids(interfaces.empty_regions, report);
  }
}

}  // namespace crossgrain
