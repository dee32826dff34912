// SPDX-License-Identifier: Apache-2.0
#include "reduction/demanded_splits.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/vector3.hpp"
#include "tets/tet_splits.hpp"

namespace crossgrain {
namespace {

/// Says which coordinates of corners of a tet are one integer.
class CommonIntegers {
 public:
  explicit CommonIntegers(const MapUnknowns& unknowns) : unknowns_(unknowns) {}

  bool are_common(std::uint32_t tet, std::uint32_t a, std::uint32_t b, std::size_t axis) const {
    const LinearForm& form = of(tet, a)[axis];
    return unknowns_.is_integer(form) && form == of(tet, b)[axis];
  }

  int count(std::uint32_t tet, std::uint32_t a, std::uint32_t b) const {
    int common = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) common += are_common(tet, a, b, axis);
    return common;
  }

 private:
  const MapPoint& of(std::uint32_t tet, std::uint32_t vertex) const {
    return unknowns_.point(unknowns_.cut().copy_at(tet, vertex));
  }

  const MapUnknowns& unknowns_;
};

/// How many coordinates an edge may have in common.
int allowed(const CutSolid& cut, std::uint32_t edge) {
  const TetComplex::Edge& its = cut.field().complex().edges()[edge];
  if (its.is_branched) return 3;
  if (its.is_on_boundary()) return cut.field().boundary_turn(edge).hexahedra % 2 == 0 ? 1 : 2;
  return cut.is_singular(edge) ? 2 : 0;
}

std::vector<CubeRotation> inherited_matchings(const MatchedField& field, const TetSolid& solid,
                                              const std::vector<std::uint32_t>& parents) {
  const std::vector<TetSolid::InnerFace>& former = field.complex().solid().inner_faces;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> faces;
  for (std::uint32_t f = 0; f < former.size(); ++f) faces.emplace(former[f].tets, f);
  const CubeGroup& group = CubeGroup::instance();
  std::vector<CubeRotation> matchings;
  for (const TetSolid::InnerFace& face : solid.inner_faces) {
    const std::array<std::uint32_t, 2> sides{parents[face.tets[0]], parents[face.tets[1]]};
    if (sides[0] == sides[1]) {
      matchings.emplace_back();
    } else if (const auto found = faces.find(sides); found != faces.end()) {
      matchings.push_back(group[field.matching(found->second)]);
    } else {
      matchings.push_back(group[group.inverse_of(field.matching(faces.at({sides[1], sides[0]})))]);
    }
  }
  return matchings;
}

void complete(OwnedField& result, const std::vector<CubeRotation>& matchings) {
  result.complex = std::make_unique<TetComplex>(*result.solid);
  result.field = std::make_unique<MatchedField>(*result.complex, result.frames, matchings);
}

}  // namespace

OwnedField owned(const MatchedField& field) {
  OwnedField result;
  result.solid = std::make_unique<const TetSolid>(field.complex().solid());
  result.frames.assign(field.frames().begin(), field.frames().end());
  complete(result, field.matchings());
  return result;
}

DemandedSplits demanded_splits(const MapUnknowns& unknowns) {
  const CutSolid& cut = unknowns.cut();
  const TetComplex& complex = cut.field().complex();
  const CommonIntegers integers(unknowns);
  DemandedSplits splits;
  std::vector<bool> is_split(complex.edges().size(), false);
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    const TetComplex::Edge& edge = complex.edges()[e];
    is_split[e] = integers.count(edge.first_tet, edge.ends[0], edge.ends[1]) > allowed(cut, e);
    if (is_split[e]) splits.edges.push_back(edge.ends);
  }
  const std::vector<TetSolid::InnerFace>& faces = complex.solid().inner_faces;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto& [a, b, c] = faces[f].vertices;
    const auto& edges = complex.edges_of_face(f);
    if (std::any_of(edges.begin(), edges.end(), [&](std::uint32_t e) { return is_split[e]; })) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!integers.are_common(faces[f].tets[0], a, b, axis) ||
          !integers.are_common(faces[f].tets[0], a, c, axis))
        continue;
      splits.faces.push_back(faces[f].vertices);
      break;
    }
  }
  return splits;
}

OwnedField with_splits(const OwnedField& field, const DemandedSplits& splits) {
  const std::vector<Vector3>& vertices = field.solid->mesh.vertices;
  std::vector<std::pair<double, std::array<std::uint32_t, 2>>> edges;
  for (const auto& ends : splits.edges)
    edges.emplace_back(-norm(vertices[ends[1]] - vertices[ends[0]]), ends);
  std::sort(edges.begin(), edges.end());
  TetSplits cut(field.solid->mesh);
  for (const auto& [length, ends] : edges) cut.split_edge(ends[0], ends[1]);
  for (const auto& face : splits.faces) cut.split_face(face);
  SplitTetMesh split = cut.result();
  OwnedField result;
  std::vector<Warning> known;  // the faults of the tets as given
  result.solid = std::make_unique<const TetSolid>(prepare_tets(std::move(split.mesh), known));
  for (const std::uint32_t parent : split.parents) result.frames.push_back(field.frames[parent]);
  complete(result, inherited_matchings(*field.field, *result.solid, split.parents));
  return result;
}

OwnedField split_for_map(const MatchedField& field, int most_rounds) {
  OwnedField result = owned(field);
  for (int round = 0; round < most_rounds; ++round) {
    const CutSolid cut(*result.field);
    const MapUnknowns unknowns(cut);
    const DemandedSplits splits = demanded_splits(unknowns);
    if (splits.empty()) break;
    result = with_splits(result, splits);
  }
  return result;
}

}  // namespace crossgrain
