// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/names.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/place.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/verdict.hpp"
#include "measure/answer_limits.hpp"
#include "measure/fault_words.hpp"

namespace crossgrain {
namespace {

using Reason = Answer::Reason;
using Singularity = SolveReport::Singularity;

/// What to do about a reason.
struct Next {
  Remedy remedy;
  double number = 0;
};

/// Collects the reasons against a field.
class Reasons {
 public:
  void add(ReasonKind kind, Verdict verdict, std::string text, Next next) {
    reasons_.push_back({kind, verdict, 0, {}, std::move(text), next.remedy, next.number});
  }

  /// Adds a reason about the parts of a list with this verdict, if there are any; `text(part)` of the first.
  template <class Part, class Text>
  void add_worst(ReasonKind kind, Verdict verdict, const std::vector<Part>& parts, Verdict counted,
                 const Text& text, Remedy remedy) {
    const Part* first = nullptr;
    std::size_t count = 0;
    for (const Part& part : parts) {
      if (part.verdict != counted) continue;
      if (!first) first = &part;
      ++count;
    }
    if (first) reasons_.push_back({kind, verdict, count, first->place, text(*first), remedy});
  }

  bool empty() const { return reasons_.empty(); }
  Reason& last() { return reasons_.back(); }

  Answer answer() && {
    Answer answer;
    const auto is_fault = [](const Reason& reason) { return reason.verdict == Verdict::kNotMeshable; };
    answer.verdict = std::any_of(reasons_.begin(), reasons_.end(), is_fault) ? Verdict::kNotMeshable
                     : reasons_.empty()                                      ? Verdict::kMeshable
                                                                             : Verdict::kUndecided;
    std::stable_partition(reasons_.begin(), reasons_.end(), is_fault);
    answer.reasons = std::move(reasons_);
    return answer;
  }

 private:
  std::vector<Reason> reasons_;
};

/// The angle of the surface itself does not depend on the cells.
void judge_surface(const Singularity& singularity, const FaceNoun& noun, Reasons& reasons) {
  reasons.add_worst(
      ReasonKind::kKnifeEdge, Verdict::kNotMeshable, singularity.crease_list, Verdict::kNotMeshable,
      [&](const Singularity::Crease& it) { return fault_of(it, noun); }, Remedy::kRoundEdge);
  // Only what is sharp can be cut off.
  std::vector<Singularity::Corner> sharp, smooth;
  for (const Singularity::Corner& it : singularity.corner_list)
    (it.creases.empty() ? smooth : sharp).push_back(it);
  for (const auto& [corners, remedy] :
       {std::pair(&sharp, Remedy::kCutCorner), std::pair(&smooth, Remedy::kTryOtherCells)})
    reasons.add_worst(
        ReasonKind::kCorner, Verdict::kNotMeshable, *corners, Verdict::kNotMeshable,
        [&](const Singularity::Corner& it) { return fault_of(it, noun); }, remedy);
  const auto rounded = [&](const Singularity::Crease& crease) {
    return fmt::format("the edge of {:.3g} degrees{} has one hexahedron or none, by rounding",
                       crease.least_angle_deg, between(crease.faces, noun));
  };
  reasons.add_worst(ReasonKind::kKnifeEdge, Verdict::kUndecided, singularity.crease_list, Verdict::kUndecided,
                    rounded, Remedy::kRoundEdge);
  const auto undecided = [&](const Singularity::Corner& it) {
    return fmt::format("rounding or the size of the cells decides about a corner of {}{}",
                       counted(it.creases.size(), "sharp edge"), between(it.faces, noun));
  };
  reasons.add_worst(ReasonKind::kCorner, Verdict::kUndecided, singularity.corner_list, Verdict::kUndecided,
                    undecided, Remedy::kChangeAngles);
}

/// Faults of lines are certain only if the cells resolve them: `fault` is kUndecided otherwise.
void judge_lines(const Singularity& singularity, Verdict fault, Reasons& reasons) {
  constexpr Remedy kNext = Remedy::kTryOtherCells;
  reasons.add_worst(
      ReasonKind::kArc, fault, singularity.arc_list, Verdict::kNotMeshable,
      [](const Singularity::Arc& it) { return fault_of(it); }, kNext);
  const auto across = [](const Singularity::Arc& arc) {
    return arc.type == SingularityGraph::ArcType::kNoAxis
               ? "around a short line the field turns about a diagonal, which may be two lines"
               : "around a singular line the field turns about an axis across it";
  };
  reasons.add_worst(ReasonKind::kArc, Verdict::kUndecided, singularity.arc_list, Verdict::kUndecided, across,
                    kNext);
  reasons.add_worst(
      ReasonKind::kNode, fault, singularity.node_list, Verdict::kNotMeshable,
      [](const Singularity::Node& it) { return fault_of(it); }, kNext);
  std::vector<Singularity::Node> inner, ends;
  for (const Singularity::Node& it : singularity.node_list) (it.on_boundary ? ends : inner).push_back(it);
  const auto large = [](const Singularity::Node& it) {
    return fmt::format("{} meet in a point, too many to judge or one of them undecided",
                       counted(it.arcs.size(), "singular line"));
  };
  reasons.add_worst(ReasonKind::kNode, Verdict::kUndecided, inner, Verdict::kUndecided, large, kNext);
  const auto close = [](const Singularity::Node& it) {
    return fmt::format("{} end so close together on the surface that no hexahedron may fit between them",
                       counted(it.arcs.size(), "singular line"));
  };
  reasons.add_worst(ReasonKind::kEnds, Verdict::kUndecided, ends, Verdict::kUndecided, close,
                    Remedy::kCutTip);
}

void judge_short_lines(const Singularity& singularity, std::size_t short_arcs, Next next, Reasons& reasons) {
  const std::size_t shorter = short_arcs + singularity.unresolved_loops + singularity.unresolved_stubs;
  const auto others = static_cast<double>(singularity.arcs - short_arcs);
  if (shorter <= kFewShort || static_cast<double>(shorter) <= kShortPerArc * others) return;
  reasons.add(
      ReasonKind::kShortLines, Verdict::kUndecided,
      fmt::format("{} {} shorter than a few cells", counted(shorter, "singular line"), is_or_are(shorter)),
      next);
}

/// Creases are unresolved if frames do not see the number of hexahedra that their angle asks for.
void judge_creases(const Singularity& singularity, Next next, Reasons& reasons) {
  double all = 0, unfollowed = 0;
  const Singularity::Crease* worst = nullptr;
  for (const Singularity::Crease& crease : singularity.crease_list) {
    const double length = (1 - crease.followed) * crease.length;
    all += crease.length;
    unfollowed += length;
    if (!worst || length > (1 - worst->followed) * worst->length) worst = &crease;
  }
  if (!worst || unfollowed <= kUnfollowedShare * all) return;
  reasons.add(ReasonKind::kCreases, Verdict::kUndecided,
              fmt::format("the field does not follow the sharp edges along {:.2g} % of their length",
                          100 * unfollowed / all),
              next);
  reasons.last().count = 1;
  reasons.last().place = worst->place;
}

/// Whether two levels have the same arcs, nodes, ends and verdict.
bool agree(const Singularity& graph, const SolveReport::Coarser& coarser) {
  return graph.arcs == coarser.arcs && graph.nodes == coarser.nodes &&
         graph.boundary_ends == coarser.boundary_ends && graph.verdict == coarser.verdict &&
         coarser.differences.empty();
}

Next use_resolution(double resolution) {
  return {Remedy::kUseResolution, std::ceil(resolution)};
}

/// Judges whether the grid resolves the model.
void judge_grid(const SolveReport& report, Reasons& reasons) {
  const Next finer = use_resolution(2 * report.resolution);
  const SolveReport::Walls& walls = report.walls;
  if (walls.unresolved_share > kThinShare) {
    // The margin keeps the next solve from missing its wall by rounding.
    const double enough = 1.01 * report.resolution * kWallCells / walls.deciding_cells;
    reasons.add(ReasonKind::kWalls, Verdict::kUndecided,
                fmt::format("walls under {:.3g} % of the surface are thinner than {:g} cells",
                            100 * walls.unresolved_share, kWallCells),
                use_resolution(enough));
  }
  const SolveReport::Alignment& alignment = report.alignment_deg;
  if (alignment.excluded_share > kUnfollowedShare) {
    reasons.add(ReasonKind::kSurface, Verdict::kUndecided,
                fmt::format("no frame follows all faces in the cells at {:.2g} % of the surface",
                            100 * alignment.excluded_share),
                finer);
  } else if (alignment.p95.value_or(0) > kUnfollowedDeg) {
    reasons.add(ReasonKind::kSurface, Verdict::kUndecided,
                fmt::format("the field is more than {:.3g} degrees off 5 % of the surface", *alignment.p95),
                finer);
  }
  judge_creases(report.singularity, finer, reasons);
  judge_short_lines(report.singularity, report.singularity.short_arcs, finer, reasons);
}

void judge_comparison(const SolveReport& report, Reasons& reasons) {
  const Next finer = use_resolution(2 * report.resolution);
  if (!report.coarser) {
    reasons.add(ReasonKind::kNoComparison, Verdict::kUndecided,
                "there is no field of half the resolution to compare with", finer);
    return;
  }
  const SolveReport::Coarser& coarser = *report.coarser;
  if (agree(report.singularity, coarser)) return;
  reasons.add(ReasonKind::kOtherAtHalf, Verdict::kUndecided,
              fmt::format("half the resolution has other singular lines: {} for {}, {} on the surface for {}",
                          counted(coarser.arcs, "line"), report.singularity.arcs,
                          counted(coarser.boundary_ends, "end"), report.singularity.boundary_ends),
              finer);
  if (coarser.differences.empty()) return;
  Reason& reason = reasons.last();
  reason.count = coarser.differences.size();
  reason.place = coarser.differences.front().place;
}

void judge_tets(const SolveReport::Onto& onto, Reasons& reasons) {
  // Frames are half the turn of a facet off it; BoundaryVertexOptions::smooth_spread_deg is the largest half
  // at which they follow facets as one smooth surface.
  constexpr double kSmoothDeg = 15;
  const double off = std::max(onto.crease_deg.mean.value_or(0), onto.normal_deg.mean.value_or(0));
  const double share = std::min(0.5, kSmoothDeg / std::max(off, kSmoothDeg));
  const Next finer{Remedy::kUseEdgeLength, share * onto.edge_length};
  if (onto.unfollowed_share > kUnfollowedShare)
    reasons.add(ReasonKind::kSurface, Verdict::kUndecided,
                fmt::format("the field is more than {:g} degrees off {:.2g} % of the surface", kUnfollowedDeg,
                            100 * onto.unfollowed_share),
                finer);
  judge_creases(onto.singularity, finer, reasons);
  // The tets are what will be meshed: an arc of two of them is one.
  judge_short_lines(onto.singularity, 0, finer, reasons);
}

void judge_end(const SolveReport& report, Reasons& reasons) {
  if (report.unfinished)
    reasons.add(ReasonKind::kUnfinished, Verdict::kUndecided, "the solve was stopped before its end",
                {Remedy::kLetFinish});
  const auto overlaps = [](const Warning& it) { return it.kind == WarningKind::kOverlappingTets; };
  if (report.onto && std::any_of(report.warnings.begin(), report.warnings.end(), overlaps))
    reasons.add(ReasonKind::kSurface, Verdict::kUndecided, "tets overlap", {Remedy::kMeshAgain});
}

/// Returns where a reason holds: " at 1 2 3 and at 2 other places"; empty if it is about no place.
std::string places_of(const Reason& reason) {
  if (reason.count == 0) return "";
  const std::string text = " at " + words_of_place(reason.place);
  return reason.count == 1 ? text : text + " and at " + counted(reason.count - 1, "other place");
}

}  // namespace

const char* name_of(Verdict verdict) {
  constexpr std::array kNames{"meshable", "not_meshable", "undecided"};
  return name_among<Verdict::kUndecided>(kNames, verdict);
}

const char* words_of(Verdict verdict) {
  constexpr std::array kWords{"hexahedra fit locally", "hexahedra cannot follow this field", "undecided"};
  return name_among<Verdict::kUndecided>(kWords, verdict);
}

const char* name_of(ReasonKind kind) {
  constexpr std::array kNames{"knife_edge",    "corner", "arc",     "node",    "ends",        "other_at_half",
                              "no_comparison", "walls",  "surface", "creases", "short_lines", "unfinished"};
  return name_among<ReasonKind::kUnfinished>(kNames, kind);
}

Answer answer_of(const SolveReport& report) {
  Reasons reasons;
  if (report.onto) {
    // The matchings of a repair are exact, so no size of tets is in doubt.
    if (!report.onto->repair) judge_tets(*report.onto, reasons);
  } else {
    judge_grid(report, reasons);
    judge_comparison(report, reasons);
  }
  judge_end(report, reasons);
  const Singularity& singularity = report.onto ? report.onto->singularity : report.singularity;
  judge_lines(singularity, reasons.empty() ? Verdict::kNotMeshable : Verdict::kUndecided, reasons);
  judge_surface(singularity, noun_of(report.faces), reasons);
  Answer answer = std::move(reasons).answer();
  answer.is_meshed = report.hexahedra.has_value();
  return answer;
}

std::string sentence_of(const Answer& answer) {
  if (answer.reasons.empty()) return sentence_of(answer, "");
  const Reason& first = answer.reasons.front();
  return sentence_of(answer, words_of(first.remedy, first.remedy_number));
}

std::string sentence_of(const Answer& answer, const std::string& remedy_words) {
  std::string text = words_of(answer.verdict);
  if (answer.verdict == Verdict::kMeshable) return text + " (necessary, not sufficient)";
  if (answer.reasons.empty()) return text + ", because nothing was judged";
  const Reason& first = answer.reasons.front();
  const std::string where = places_of(first);
  if (answer.verdict == Verdict::kNotMeshable) {
    text += where + ": " + first.text;
    if (!answer.is_meshed) text += "; 'crossgrain hex' changes the field, and may mesh the part";
  } else {
    text += ", because " + first.text + where;
  }
  return remedy_words.empty() ? text : text + "; next: " + remedy_words;
}

}  // namespace crossgrain
