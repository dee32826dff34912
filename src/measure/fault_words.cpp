// SPDX-License-Identifier: Apache-2.0
#include "measure/fault_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "crossgrain/message.hpp"

namespace crossgrain {
namespace {

using Singularity = FieldAnalysis::Singularity;

/// Faces of fewer degrees at a corner taper to nothing there: tangent faces do, which are cut into triangles
/// of some degrees, and parts of regular corners have 45 or more.
constexpr double kTaperingDeg = 30;

/// Of faces without a number, which no list has.
constexpr std::int32_t kUntagged = 0;

/// Number of faces that are named.
constexpr std::size_t kMostNamed = 4;

bool tapers(const Singularity::Corner& corner) {
  return corner.narrowest_deg < kTaperingDeg;
}

std::string tapering(const std::vector<std::int32_t>& faces, const FaceNoun& noun) {
  if (faces.empty() || faces.front() == kUntagged) return fmt::format("a {} tapers to nothing", noun.one);
  std::string text = fmt::format("{} {} tapers to nothing", noun.one, faces.front());
  if (std::ranges::find(faces, kUntagged) != faces.end()) return text;
  if (faces.size() == 2) text += fmt::format(" beside {} {}", noun.one, faces.back());
  if (faces.size() > 2) text += between({faces.back(), faces[1]}, noun);
  return text;
}

/// Returns the sharp edges at a corner: "2 convex edges and 1 concave edge".
std::string edges_at(const Singularity::Corner& corner) {
  const auto convex =
      static_cast<std::size_t>(std::ranges::count_if(corner.creases, [](int k) { return k < 2; }));
  const std::size_t concave = corner.creases.size() - convex;
  std::string text;
  if (convex > 0) text = counted(convex, "convex edge");
  if (concave > 0) text += (text.empty() ? "" : " and ") + counted(concave, "concave edge");
  return text;
}

}  // namespace

FaceNoun noun_of(const std::vector<ModelFace>& faces) {
  return !faces.empty() && faces.front().kind == FaceKind::kPatch ? kPatchNoun : kFaceNoun;
}

std::string words_of_faces(const std::vector<std::int32_t>& faces, const FaceNoun& noun) {
  std::vector<std::int32_t> named;
  for (const std::int32_t face : faces)
    if (face != kUntagged && std::ranges::find(named, face) == named.end()) named.push_back(face);
  if (named.empty()) return "";
  if (named.size() == 1) return fmt::format("{} {}", noun.one, named.front());
  const std::size_t count = named.size();
  const bool names_all = count <= kMostNamed;
  const std::string last = names_all ? fmt::format("{}", named.back()) : counted(count - kMostNamed, "other");
  named.resize(names_all ? count - 1 : kMostNamed);
  return fmt::format("{} {} and {}", noun.several, fmt::join(named, ", "), last);
}

std::string between(const std::vector<std::int32_t>& faces, const FaceNoun& noun) {
  const std::string words = words_of_faces(faces, noun);
  if (words.empty()) return "";
  return (words.starts_with(noun.several) ? " between " : " of ") + words;
}

std::string fault_of(const Singularity::Crease& crease, const FaceNoun& noun) {
  return fmt::format("the edge of {:.3g} degrees{} is too sharp for a hexahedron", crease.least_angle_deg,
                     between(crease.faces, noun));
}

std::string fault_of(const Singularity::Corner& corner, const FaceNoun& noun) {
  if (tapers(corner)) return tapering(corner.faces, noun);
  const std::string faces = words_of_faces(corner.faces, noun);
  const std::string where = faces.empty() ? "" : " of " + faces;
  if (corner.creases.empty())
    return fmt::format("no hexahedra fit at a point of the surface{} where {} {}", where,
                       counted(corner.arcs.size(), "singular line"),
                       corner.arcs.size() == 1 ? "ends" : "end");
  if (corner.creases.size() > 1)
    return fmt::format("no hexahedra fit in a corner{} where {} meet", where, edges_at(corner));
  // Inside one face of a CAD model there is no sharp edge but between tets that are coarse beside its
  // curvature.
  const bool is_inside =
      std::string_view(noun.one) == kFaceNoun.one && !faces.empty() && !faces.starts_with(noun.several);
  return is_inside ? fmt::format("no hexahedra fit at a point of the surface{}", where)
                   : fmt::format("no hexahedra fit at the end of a sharp edge{}", where);
}

std::string fault_of(const Singularity::Arc& arc) {
  switch (arc.type) {
    case SingularityGraph::ArcType::kChanging:
      return "along a singular line three hexahedra would become five";
    case SingularityGraph::ArcType::kNoAxis:
      return "around a line the field turns about a diagonal, by a third of a turn";
    case SingularityGraph::ArcType::kRegular:
      break;
  }
  return "around a singular line there would be two hexahedra, which share two faces";
}

std::string fault_of(const Singularity::Node& node) {
  if (node.arcs.size() == 1) return "a singular line ends where hexahedra cannot end it";
  return fmt::format("{} meet in a point as those of hexahedra cannot",
                     counted(node.arcs.size(), "singular line"));
}

std::vector<Vector3> places_of_faults(const Singularity& graph) {
  std::vector<Vector3> places;
  const auto add = [&](const auto& parts) {
    for (const auto& part : parts)
      if (part.verdict == Verdict::kNotMeshable && std::ranges::find(places, part.place) == places.end())
        places.push_back(part.place);
  };
  add(graph.crease_list);
  add(graph.corner_list);
  add(graph.node_list);
  add(graph.arc_list);
  return places;
}

}  // namespace crossgrain
