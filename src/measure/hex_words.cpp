// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/digits.hpp"
#include "base/names.hpp"
#include "crossgrain/hex_report.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/place.hpp"

namespace crossgrain {
namespace {

/// Below it a scaled Jacobian is too poor for most solvers: as HexTuning::least_quality, below which the
/// search goes on.
constexpr double kBadShape = 0.05;

/// Below it a scaled Jacobian is poor: the least that meshes for finite elements are commonly asked to have.
/// HexReport::Quality::below_fifth counts them.
constexpr double kPoorShape = 0.2;

/// A number of hexahedra is as expected within this factor: what a forecast from the volume keeps on solid
/// parts.
constexpr double kAsExpected = 2;

/// Why smaller hexahedra than asked for were taken.
const char* fault_of_larger(const HexReport& report, double expected) {
  if (report.is_of_lattice()) {
    const bool is_kept = std::ranges::any_of(report.attempts, [&](const HexAttempt& attempt) {
      return attempt.is_of_lattice() && attempt.outcome == HexOutcome::kAllHex &&
             attempt.size > report.used_size;
    });
    return is_kept ? "larger ones of a lattice are badly shaped"
                   : "larger ones of a lattice do not keep the model";
  }
  const char* fault = "larger ones would be turned inside out";
  for (const HexAttempt& attempt : report.attempts) {
    if (attempt.outcome != HexOutcome::kAllHex || attempt.size <= report.used_size) continue;
    if (static_cast<double>(attempt.hexahedra) * kAsExpected >= expected)
      return "larger ones would be badly shaped";
    fault = "larger ones would be far fewer than expected";
  }
  return fault;
}

/// How many hexahedra the features of the model have added.
std::size_t added_by_fit(const HexReport& report) {
  return report.best_fit < report.fit_tries.size() ? report.fit_tries[report.best_fit].added : 0;
}

/// Returns number and mean edge of hexahedra; of those that fill the model with what was expected where they
/// are others, and why they are.
std::string sizes_of(const HexReport& report) {
  const auto made = static_cast<double>(report.hexahedra);
  const double expected =
      std::max(1.0, report.expected > 0 ? report.expected : report.model_volume / std::pow(report.size, 3));
  const bool is_whole = report.outcome == HexOutcome::kAllHex || report.outcome == HexOutcome::kApproximate;
  const bool is_smaller = report.used_size<report.size, is_more = made> kAsExpected * expected,
             is_less = made * kAsExpected < expected;
  const std::string bodies =
      report.bodies > 1 ? fmt::format(" in {}", counted(report.bodies, "body", "bodies")) : "";
  const std::string text =
      fmt::format("{}{}, mean edge {:.3g}", counted(report.hexahedra, "hexahedron", "hexahedra"), bodies,
                  report.mean_edge);
  if (!is_whole || !(is_smaller || is_more || is_less)) return text;
  const char* const reason = is_smaller ? fault_of_larger(report, expected)
                             : is_more  ? (added_by_fit(report) > 0 ? "its features need layers of them"
                                                                    : "each wall and gap has one across")
                             : report.is_of_lattice() ? "its planes are moved onto the model's faces"
                                                      : "the field leaves room for fewer";
  if (report.is_of_lattice() && is_smaller)
    return fmt::format("{}, not {:.3g} as asked for: {}", text, report.size, reason);
  return fmt::format("{}, not about {:.0f} of {:.3g}: {}", text, expected, report.size, reason);
}

/// Adds to the size that is to be tried about how many hexahedra it makes.
std::string with_count(const HexReport& report, const std::string& remedy_words) {
  if (report.remedy != Remedy::kUseHexSize || remedy_words.empty() || report.remedy_hexahedra <= 0)
    return remedy_words;
  return fmt::format("{} ({})", remedy_words, about(report.remedy_hexahedra));
}

/// Returns what to do, or that nothing is known, where that is what a reader looks for.
std::string remedy_of(const HexReport& report, const std::string& remedy_words) {
  const bool is_wanting = report.outcome != HexOutcome::kAllHex || !report.reason.empty();
  if (!is_wanting || !remedy_words.empty() || report.attempts.empty())
    return with_count(report, remedy_words);
  const bool has_steps = report.reason.find("steps of hexahedra") != std::string::npos;  // of any size
  return report.is_of_lattice() || has_steps ? "" : "smaller hexahedra may help";
}

/// Says so of shapes that are too poor to compute on, where none is inverted.
std::string words_of_shapes(const HexReport& report) {
  const bool is_said = report.reason.find("badly shaped") != std::string::npos;
  if (report.hexahedra == 0 || report.quality.inverted > 0 || report.quality.least >= kBadShape || is_said)
    return "";
  return fmt::format("badly shaped: worst scaled Jacobian {:.2g}", report.quality.least);
}

/// How hexahedra came to lie on the model: ", fitted to the model with 12 more hexahedra".
std::string way_of_fit(const HexReport& report) {
  if (report.best_fit == 0 || report.best_fit >= report.fit_tries.size()) return "";
  const std::size_t added = added_by_fit(report);
  return ", fitted to the model" +
         (added > 0 ? fmt::format(" with {} more", counted(added, "hexahedron", "hexahedra")) : "");
}

}  // namespace

const char* name_of(HexOutcome outcome) {
  constexpr std::array kNames{"all-hex", "approximate", "partial", "none"};
  return name_among<HexOutcome::kNone>(kNames, outcome);
}

std::string shapes_of(const HexReport::Quality& quality) {
  const bool is_poor = quality.inverted == 0 && quality.least < kPoorShape;
  std::string text =
      fmt::format("scaled Jacobian {:.2g}{} at {}, {:.2g} in the mean", quality.least,
                  is_poor ? ", which is poor," : "", words_of_place(quality.worst_place), quality.mean);
  if (quality.shortest_edge > 0)
    text += fmt::format("; shortest edge {:.2g} at {}", quality.shortest_edge,
                        words_of_place(quality.shortest_edge_place));
  return text;
}

std::string distances_of(const HexReport& report) {
  constexpr double kOnSurface = 1e-9;  // in sizes of hexahedra
  struct Largest {
    double distance;
    Vector3 place;
  };
  // Those at vertices, and within quads.
  const auto largest = [&](double at_vertices, const Vector3& place, const HexFeatures::Distances* in_all) {
    Largest result{at_vertices, place};
    if (in_all && in_all->largest_in_all * report.size > at_vertices)
      result = {in_all->largest_in_all * report.size, in_all->place_in_all};
    if (result.distance < kOnSurface * report.size) result.distance = 0;
    return result;
  };
  const HexFeatures* const features = report.features ? &*report.features : nullptr;
  const Largest of_mesh = largest(report.largest_distance, report.largest_distance_place,
                                  features ? &features->of_mesh : nullptr);
  const Largest of_model = largest(report.largest_distance_of_model, report.largest_distance_of_model_place,
                                   features ? &features->of_model : nullptr);
  if (of_mesh.distance == 0 && of_model.distance == 0) return "nowhere off the surface";
  std::array words{of_mesh.distance == 0 ? "mesh on the surface"
                                         : fmt::format("mesh up to {:.3g} off the surface", of_mesh.distance),
                   of_model.distance == 0
                       ? "surface on the mesh"
                       : fmt::format("surface up to {:.3g} from the mesh", of_model.distance)};
  const bool is_of_model = of_model.distance > of_mesh.distance;
  if (!is_of_model) std::swap(words[0], words[1]);
  return fmt::format(
      "{}; {}, at {}", words[0], words[1],
      words_of_place((is_of_model ? of_model : of_mesh).place, std::cbrt(report.model_volume)));
}

std::string lacking_of(const HexReport& report) {
  if (report.outcome != HexOutcome::kPartial) return "";
  std::vector<std::string> parts;
  if (report.left_out > 0)
    parts.push_back(fmt::format("{} left out near {}", counted(report.left_out, "cell"),
                                words_of_place(report.left_out_place, std::cbrt(report.model_volume))));
  if (report.quality.inverted > 0) parts.push_back(fmt::format("{} inverted", report.quality.inverted));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string way_of(const HexReport& report) {
  if (report.attempts.empty()) {
    if (report.fit_tries.empty()) return "";
    const std::string fit = way_of_fit(report);
    return fit.empty() ? "as given, since no fit is better" : fit.substr(2);
  }
  if (report.best_attempt >= report.attempts.size()) return "";
  const HexAttempt& best = report.attempts[report.best_attempt];
  std::size_t last = 0;
  std::string size;
  for (const HexAttempt& attempt : report.attempts) {
    last = std::max(last, attempt.number);
    if (attempt.tet_size > 0 && attempt.round == best.round && attempt.tets > 0)
      size = fmt::format(" of at most {:.3g}", attempt.tet_size);
  }
  const std::string begin = fmt::format("attempt {} of {}: ", best.number, last);
  if (best.is_of_lattice())
    return begin + "lattice" + way_of_fit(report) +
           (report.map_fault.empty() ? "" : "; no map, since " + report.map_fault);
  return fmt::format("{}field on {}{}, repaired{}{}", begin, counted(best.tets, "tet"), size,
                     best.kind == "repair" ? "" : ", " + best.kind, way_of_fit(report));
}

std::string sentence_of(const HexReport& report) {
  return sentence_of(report, words_of(report.remedy, report.remedy_number));
}

std::string sentence_of(const HexReport& report, const std::string& remedy_words) {
  std::string text = name_of(report.outcome);
  if (report.is_of_lattice()) text += " by a lattice";
  if (report.is_stopped) text += ", the search was stopped";
  std::string sizes;
  if (report.hexahedra > 0) sizes = sizes_of(report);
  if (const std::string lacking = lacking_of(report); !lacking.empty()) sizes += ", " + lacking;
  const std::string remedy = remedy_of(report, remedy_words);
  if (report.outcome == HexOutcome::kAllHex && !report.reason.empty())
    return text + ", but " + report.reason + (remedy.empty() ? "" : ": " + remedy) + "; " + sizes;
  std::vector<std::string> parts;
  for (const std::string& part : {sizes, words_of_shapes(report), report.reason, remedy})
    if (!part.empty()) parts.push_back(part);
  return parts.empty() ? text : fmt::format("{}: {}", text, fmt::join(parts, "; "));
}

}  // namespace crossgrain
