// SPDX-License-Identifier: Apache-2.0
#include "hex/solid_judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/place.hpp"
#include "hex/hex_report.hpp"
#include "measure/feature_measure.hpp"
#include "measure/hex_interfaces.hpp"
#include "solve/tet_domain_data.hpp"
#include "surface/surface.hpp"
#include "tets/tet_shape.hpp"

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

/// The solids without hexahedra.
struct EmptySolids {
  std::vector<std::int32_t> numbers;  ///< ascending; of bodies from 1
  Vector3 place{};                    ///< in the first
};

std::vector<std::int32_t> solids_of_tets(const TetSolid& model) {
  if (!model.mesh.regions.empty()) return model.mesh.regions;
  std::vector<std::int32_t> bodies;
  for (const std::uint32_t body : model.tet_components) bodies.push_back(static_cast<std::int32_t>(body) + 1);
  return bodies;
}

/// Returns the centre of the largest tet of a solid.
Vector3 place_in(std::int32_t number, const std::vector<std::int32_t>& solids, const TetSolid& model) {
  Vector3 place{};
  double largest = -1;
  for (std::size_t t = 0; t < solids.size(); ++t) {
    if (solids[t] != number) continue;
    const auto& [a, b, c, d] = model.mesh.tets[t];
    const std::vector<Vector3>& at = model.mesh.vertices;
    const double volume = std::abs(dot(cross(at[b] - at[a], at[c] - at[a]), at[d] - at[a]));
    if (volume <= largest) continue;
    largest = volume;
    place = centroid_of_tet(model.mesh, t);
  }
  return place;
}

EmptySolids empty_solids(const CentreTets& centres) {
  const std::vector<std::int32_t> solids = solids_of_tets(centres.solid);
  std::set<std::int32_t> empty(solids.begin(), solids.end());
  for (const std::uint32_t tet : centres.of_hexahedra) empty.erase(solids[tet]);
  if (empty.empty()) return {};
  return {{empty.begin(), empty.end()}, place_in(*empty.begin(), solids, centres.solid)};
}

/// "solid 2 has no hexahedra, around 1 2 3".
std::string words_of(const EmptySolids& empty, const TetSolid& model) {
  const char* const noun = model.mesh.regions.empty() ? "body" : "solid";
  const std::string place = words_of_place(empty.place, longest_side(box_of(model.mesh.vertices)));
  if (empty.numbers.size() == 1)
    return fmt::format("{} {} has no hexahedra, around {}", noun, empty.numbers.front(), place);
  return fmt::format("{} have no hexahedra, the first is {} {}, around {}",
                     model.mesh.regions.empty() ? counted(empty.numbers.size(), "body", "bodies")
                                                : counted(empty.numbers.size(), "solid"),
                     noun, empty.numbers.front(), place);
}

void judge_empty_solids(const EmptySolids& empty, const TetSolid& model, HexReport& report) {
  report.outcome = HexOutcome::kPartial;
  report.reason = words_of(empty, model);
  report.places = {empty.place};
  advise_smaller(report);
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

void judge_solids(const HexMesh& mesh, const CentreTets& centres, const TetDomain& domain,
                  const std::vector<BodyContact>& contacts, HexReport& report, SolveReport& whole) {
  const TetSolid& model = domain.data().solid;
  const bool is_united = whole.onto->united;
  const HexInterfaces interfaces = interfaces_of(mesh, model, kOnInterface * report.size);
  report.interface_faces = interfaces.faces;
  report.largest_interface_distance = interfaces.largest_distance;
  if (interfaces.off > 0 && !is_united) {
    whole.warnings.emplace_back(
        WarningKind::kCrossedInterfaces,
        fmt::format(
            "hexahedra do not keep to the faces between solids: {} of {} between them are off, by up to "
            "{:.2g} ({:.2g} of the size) at {}",
            interfaces.off, counted(interfaces.faces, "face"), interfaces.largest_distance,
            interfaces.largest_distance / report.size, words_of_place(interfaces.place)));
  }
  const bool are_in_contact = !contacts.empty() && contacts.front().is_of_areas();
  const bool is_whole = report.outcome == HexOutcome::kAllHex;
  if (!contacts.empty()) remove_contacts(domain.warnings(), whole.warnings);
  if (!contacts.empty() && !(are_in_contact && is_whole)) whole.warnings.push_back(warning_of(contacts));
  const EmptySolids empty = is_united ? EmptySolids() : empty_solids(centres);
  const bool has_empty = !empty.numbers.empty();
  if (are_in_contact && is_whole) judge_contacts(contacts, report);
  if (has_empty && is_whole && !are_in_contact)
    judge_empty_solids(empty, model, report);
  else if (has_empty && !mesh.hexahedra.empty())
    whole.warnings.emplace_back(WarningKind::kEmptySolids, words_of(empty, model));
}

void judge_interfaces(const SolveReport& whole, HexReport& report) {
  const bool fills = report.outcome == HexOutcome::kAllHex || report.outcome == HexOutcome::kApproximate;
  const double off = report.largest_interface_distance / report.size;
  if (!fills || (whole.onto && whole.onto->united) || !(off > kMostOffInAll)) return;
  report.outcome = HexOutcome::kApproximate;
  report.reason += fmt::format(
      "{}the faces between its solids are steps of hexahedra, up to {:.2g} off, {:.2g} of the size",
      report.reason.empty() ? "" : "; ", report.largest_interface_distance, off);
}

}  // namespace crossgrain
