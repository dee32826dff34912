// SPDX-License-Identifier: Apache-2.0
#include "reduction/cut_solid.hpp"

#include <algorithm>
#include <cassert>
#include <deque>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Inner faces of each tet.
ListTable faces_of_tets(const TetSolid& solid) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t f = 0; f < solid.inner_faces.size(); ++f)
    for (const std::uint32_t tet : solid.inner_faces[f].tets) pairs.push_back({tet, f});
  return {solid.mesh.tets.size(), pairs};
}

}  // namespace

void add_step(SheetWord& word, SheetStep step) {
  if (step == 0) return;
  if (!word.empty() && word.back() == -step) {
    word.pop_back();
  } else {
    word.push_back(step);
  }
}

CutSolid::CutSolid(const MatchedField& field) : field_(&field) {
  const TetComplex& complex = field.complex();
  const auto edges = static_cast<std::uint32_t>(complex.edges().size());
  is_singular_.resize(edges);
  parallel_for(edges, [&](std::size_t e) {
    const auto edge = static_cast<std::uint32_t>(e);
    is_singular_[e] = !complex.edges()[e].is_on_boundary() && field.is_singular(edge);
  });
  std::vector<std::uint8_t> is_joined(complex.solid().inner_faces.size(), 0);
  name_axes(is_joined);
  join_around_regular_edges(is_joined);
  find_sheets(is_joined);
  find_copies();
}

std::uint8_t CutSolid::named_matching(std::uint32_t inner_face) const {
  const CubeGroup& group = CubeGroup::instance();
  const auto& [from, to] = field_->complex().solid().inner_faces[inner_face].tets;
  return group.product(names_[to],
                       group.product(field_->matching(inner_face), group.inverse_of(names_[from])));
}

void CutSolid::name_axes(std::vector<std::uint8_t>& is_joined) {
  const CubeGroup& group = CubeGroup::instance();
  const TetSolid& solid = field_->complex().solid();
  const ListTable faces_of = faces_of_tets(solid);
  const auto count = static_cast<std::uint32_t>(solid.mesh.tets.size());
  names_.assign(count, CubeGroup::kIdentity);
  std::vector<std::uint8_t> is_named(count, 0);
  std::deque<std::uint32_t> queue;
  for (std::uint32_t root = 0; root < count; ++root) {
    if (is_named[root]) continue;
    is_named[root] = 1;
    queue.push_back(root);
    while (!queue.empty()) {
      const std::uint32_t tet = queue.front();
      queue.pop_front();
      for (const std::uint32_t f : faces_of[tet]) {
        const auto& tets = solid.inner_faces[f].tets;
        const bool reversed = tets[1] == tet;
        const std::uint32_t next = tets[reversed ? 0 : 1];
        if (is_named[next]) continue;
        is_named[next] = is_joined[f] = 1;
        const std::uint8_t across = field_->across({f, reversed});
        names_[next] = group.product(names_[tet], group.inverse_of(across));
        queue.push_back(next);
      }
    }
  }
}

void CutSolid::join_around_regular_edges(std::vector<std::uint8_t>& is_joined) {
  const TetComplex& complex = field_->complex();
  const auto edges = static_cast<std::uint32_t>(complex.edges().size());
  cut_counts_.assign(edges, 0);
  for (std::uint32_t e = 0; e < edges; ++e)
    for (const Crossing& crossing : complex.around(e)) cut_counts_[e] += !is_joined[crossing.face];
  std::deque<std::uint32_t> queue;
  const auto closes = [&](std::uint32_t e) {
    return cut_counts_[e] == 1 && !complex.edges()[e].is_on_boundary() && !is_singular_[e];
  };
  for (std::uint32_t e = 0; e < edges; ++e)
    if (closes(e)) queue.push_back(e);
  while (!queue.empty()) {
    const std::uint32_t edge = queue.front();
    queue.pop_front();
    if (!closes(edge)) continue;
    const auto around = complex.around(edge);
    const auto last = std::find_if(around.begin(), around.end(),
                                   [&](const Crossing& crossing) { return !is_joined[crossing.face]; });
    assert(named_matching(last->face) == CubeGroup::kIdentity);
    is_joined[last->face] = 1;
    for (const std::uint32_t e : complex.edges_of_face(last->face)) {
      --cut_counts_[e];
      if (closes(e)) queue.push_back(e);
    }
  }
}

void CutSolid::find_sheets(const std::vector<std::uint8_t>& is_joined) {
  const TetComplex& complex = field_->complex();
  // Faces that continue each other at regular edges with two of them, and whether their directions agree.
  struct Beside {
    std::uint32_t face;
    bool agrees;
  };
  std::vector<std::vector<Beside>> beside(is_joined.size());
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    if (cut_counts_[e] != 2 || complex.edges()[e].is_on_boundary() || is_singular_[e]) continue;
    std::vector<Crossing> cut;
    for (const Crossing& crossing : complex.around(e))
      if (!is_joined[crossing.face]) cut.push_back(crossing);
    const bool agrees = cut[0].reversed != cut[1].reversed;  // the way around goes back through the second
    beside[cut[0].face].push_back({cut[1].face, agrees});
    beside[cut[1].face].push_back({cut[0].face, agrees});
  }
  steps_.assign(is_joined.size(), 0);
  for (std::uint32_t first = 0; first < is_joined.size(); ++first) {
    if (is_joined[first] || steps_[first] != 0) continue;
    rotations_.push_back(named_matching(first));
    steps_[first] = static_cast<SheetStep>(rotations_.size());
    std::vector<std::uint32_t> stack{first};
    while (!stack.empty()) {
      const std::uint32_t face = stack.back();
      stack.pop_back();
      for (const Beside& next : beside[face]) {
        if (steps_[next.face] != 0) continue;
        steps_[next.face] = next.agrees ? steps_[face] : -steps_[face];
        stack.push_back(next.face);
      }
    }
  }
}

std::uint32_t CutSolid::copy_at(std::uint32_t tet, std::uint32_t vertex) const {
  return copies_[tet][corner_of(field_->complex().solid().mesh.tets[tet], vertex)];
}

SheetWord CutSolid::word_around(std::uint32_t inner_edge) const {
  SheetWord word;
  for (const Crossing& crossing : field_->complex().around(inner_edge)) add_step(word, step_across(crossing));
  return word;
}

void CutSolid::find_copies() {
  const TetSolid& solid = field_->complex().solid();
  const std::vector<std::array<std::uint32_t, 4>>& tets = solid.mesh.tets;
  DisjointSets sets(4 * tets.size());
  std::vector<std::array<std::uint32_t, 2>> joins;  // corners on either side of the cut
  std::vector<SheetStep> steps;
  for (std::uint32_t f = 0; f < solid.inner_faces.size(); ++f) {
    const auto& [vertices, sides] = solid.inner_faces[f];
    for (const std::uint32_t v : vertices) {
      std::array<std::uint32_t, 2> corners{};
      for (std::size_t side = 0; side < 2; ++side)
        corners[side] = static_cast<std::uint32_t>(4 * sides[side] + corner_of(tets[sides[side]], v));
      if (!is_cut(f)) {
        sets.join(corners[0], corners[1]);
      } else {
        joins.push_back(corners);
        steps.push_back(steps_[f]);
      }
    }
  }
  copies_.resize(tets.size());
  std::uint32_t count = 0;
  for (std::uint32_t corner = 0; corner < 4 * tets.size(); ++corner) {
    const std::uint32_t root = sets.root(corner);  // comes before the others
    copies_[corner / 4][corner % 4] = root == corner ? count++ : copies_[root / 4][root % 4];
  }
  first_copies_.assign(count, UINT32_MAX);
  words_.resize(count);
  for (auto& pair : joins)
    for (std::uint32_t& corner : pair) corner = copies_[corner / 4][corner % 4];
  find_words(joins, steps);
}

void CutSolid::find_words(std::span<const std::array<std::uint32_t, 2>> joins,
                          std::span<const SheetStep> steps) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t k = 0; k < joins.size(); ++k)
    for (const std::uint32_t copy : joins[k]) pairs.push_back({copy, k});
  const ListTable joins_of(first_copies_.size(), pairs);
  std::deque<std::uint32_t> queue;
  for (std::uint32_t first = 0; first < first_copies_.size(); ++first) {
    if (first_copies_[first] != UINT32_MAX) continue;
    first_copies_[first] = first;
    queue.push_back(first);
    while (!queue.empty()) {
      const std::uint32_t copy = queue.front();
      queue.pop_front();
      for (const std::uint32_t k : joins_of[copy]) {
        const bool reversed = joins[k][1] == copy;
        const std::uint32_t next = joins[k][reversed ? 0 : 1];
        if (first_copies_[next] != UINT32_MAX) continue;
        first_copies_[next] = first;
        words_[next] = words_[copy];
        add_step(words_[next], reversed ? -steps[k] : steps[k]);
        queue.push_back(next);
      }
    }
  }
}

}  // namespace crossgrain
