// SPDX-License-Identifier: Apache-2.0
#include "hex/solid_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "crossgrain/message.hpp"
#include "crossgrain/place.hpp"
#include "measure/hex_interfaces.hpp"
#include "solve/tet_domain_data.hpp"

namespace crossgrain {
namespace {

/// Faces between hexahedra of two solids keep to those of the model if they are this near, in sizes: what
/// smoothing may leave of the surface.
constexpr double kOnInterface = 0.05;

void judge_contacts(const std::vector<BodyContact>& contacts, HexReport& report) {
  report.outcome = HexOutcome::kPartial;
  for (const BodyContact& contact : contacts)
    if (report.places.size() < HexReport::kMostPlaces) report.places.push_back(contact.place);
  const Warning warning = warning_of(contacts);
  report.reason = warning.text;
  report.remedy = warning.remedy;
}

void judge_empty_solids(const std::vector<std::int32_t>& empty, HexReport& report) {
  report.outcome = HexOutcome::kPartial;
  report.reason =
      empty.size() == 1
          ? fmt::format("solid {} is smaller than the hexahedra and has none", empty.front())
          : fmt::format("{} solids are smaller than the hexahedra and have none, the first is solid {}",
                        empty.size(), empty.front());
  report.remedy = Remedy::kTakeSmallerHexahedra;
}

/// Removes what the surface and the tets say of contacts. The boundary of tets is closed, so all that is
/// found of it, and not of the model (`of_model`), comes from them too.
void remove_contacts(const std::vector<Warning>& of_model, std::vector<Warning>& warnings) {
  const auto is_found = [&](const Warning& warning) {
    return warning.kind == WarningKind::kSurfaceFinding &&
           std::ranges::none_of(of_model, [&](const Warning& one) { return one.text == warning.text; });
  };
  std::erase_if(warnings, [&](const Warning& one) { return is_of_contact(one) || is_found(one); });
}

}  // namespace

void judge_solids(const HexMesh& mesh, const TetDomain& domain, const std::vector<BodyContact>& contacts,
                  HexReport& report, SolveReport& whole) {
  const TetSolid& model = domain.data().solid;
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
  const bool are_in_contact = !contacts.empty() && contacts.front().is_of_areas();
  const bool is_whole = report.outcome == HexOutcome::kAllHex;
  if (!contacts.empty()) remove_contacts(domain.warnings(), whole.warnings);
  if (!contacts.empty() && !(are_in_contact && is_whole)) whole.warnings.push_back(warning_of(contacts));
  if (!is_whole) return;
  if (are_in_contact) {
    judge_contacts(contacts, report);
  } else if (!interfaces.empty_regions.empty() && !is_united) {
    judge_empty_solids(interfaces.empty_regions, report);
  }
}

}  // namespace crossgrain
