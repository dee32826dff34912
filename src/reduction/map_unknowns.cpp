// SPDX-License-Identifier: Apache-2.0
#include "reduction/map_unknowns.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace crossgrain {

MapUnknowns::MapUnknowns(const CutSolid& cut)
    : cut_(&cut),
      first_translation_(static_cast<std::uint32_t>(3 * cut.copies())),
      elimination_(static_cast<std::uint32_t>(3 * (cut.copies() + cut.sheets()))) {
  const MatchedField& field = cut.field();
  const std::vector<std::uint32_t>& tets = field.complex().solid().boundary_tets;
  for (std::uint32_t f = 0; f < tets.size(); ++f)
    normal_axes_.push_back(CubeGroup::instance().image(cut.names_of(tets[f]), field.normal_axis(f)));
  impose_regular_edges();
  impose_singular_edges();
  impose_surface();
  for (std::uint32_t copy = 0; copy < cut.copies(); ++copy) {
    points_.push_back(raw_point(copy));
    for (LinearForm& form : points_.back()) form = elimination_.reduced(form);
  }
  for (std::uint32_t sheet = 0; sheet < cut.sheets(); ++sheet) {
    translations_.emplace_back();
    for (std::uint32_t k = 0; k < 3; ++k)
      translations_.back()[k] = elimination_.reduced({first_translation_ + 3 * sheet + k, 1});
  }
  number_columns();
  find_integers();
}

const MapUnknowns::Transition& MapUnknowns::transition(const SheetWord& word) {
  if (const auto known = transitions_.find(word); known != transitions_.end()) return known->second;
  Transition result;
  if (!word.empty()) {
    const Transition& before = transition({word.begin(), word.end() - 1});
    const SheetStep step = word.back();
    const auto sheet = static_cast<std::uint32_t>(std::abs(step) - 1);
    const CubeGroup& group = CubeGroup::instance();
    MapPoint own;
    for (std::uint32_t k = 0; k < 3; ++k) own[k] = {first_translation_ + 3 * sheet + k, 1};
    MapPoint& translation = result.translation;
    if (step > 0) {
      translation = turned(cut_->rotation(sheet), before.translation);
      for (std::size_t k = 0; k < 3; ++k) translation[k] = added(translation[k], own[k]);
      result.rotation = group.product(cut_->rotation(sheet), before.rotation);
    } else {
      const std::uint8_t back = group.inverse_of(cut_->rotation(sheet));
      for (std::size_t k = 0; k < 3; ++k) own[k] = added(before.translation[k], own[k], -1);
      translation = turned(back, own);
      result.rotation = group.product(back, before.rotation);
    }
  }
  return transitions_.emplace(word, std::move(result)).first->second;
}

MapPoint MapUnknowns::raw_point(std::uint32_t copy) {
  const Transition& from_first = transition(cut_->word_to(copy));
  MapPoint first;
  for (std::uint32_t k = 0; k < 3; ++k) first[k] = {3 * cut_->first_copy(copy) + k, 1};
  MapPoint point = turned(from_first.rotation, first);
  for (std::size_t k = 0; k < 3; ++k) point[k] = added(point[k], from_first.translation[k]);
  return point;
}

void MapUnknowns::impose_regular_edges() {
  const TetComplex& complex = cut_->field().complex();
  std::set<SheetWord> words;
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e)
    if (!complex.edges()[e].is_on_boundary() && !cut_->is_singular(e)) words.insert(cut_->word_around(e));
  // Short words first: their forms stay short.
  std::vector<SheetWord> sorted(words.begin(), words.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const SheetWord& a, const SheetWord& b) { return a.size() < b.size(); });
  for (const SheetWord& word : sorted)
    for (const LinearForm& form : transition(word).translation) elimination_.impose(form, first_translation_);
}

void MapUnknowns::impose_singular_edges() {
  const TetComplex& complex = cut_->field().complex();
  std::set<std::pair<std::uint32_t, SheetWord>> done;
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    if (!cut_->is_singular(e)) continue;
    const TetComplex::Edge& edge = complex.edges()[e];
    const SheetWord word = cut_->word_around(e);
    for (const std::uint32_t vertex : edge.ends) {
      const std::uint32_t copy = cut_->copy_at(edge.first_tet, vertex);
      if (!done.insert({copy, word}).second) continue;
      const MapPoint point = raw_point(copy);
      const Transition& around = transition(word);
      const MapPoint there = turned(around.rotation, point);
      for (std::size_t k = 0; k < 3; ++k)
        elimination_.impose(added(added(point[k], there[k], -1), around.translation[k], -1),
                            first_translation_);
    }
  }
}

void MapUnknowns::impose_surface() {
  const TetSolid& solid = cut_->field().complex().solid();
  for (std::uint32_t f = 0; f < solid.boundary.size(); ++f) {
    const std::uint32_t tet = solid.boundary_tets[f];
    const std::size_t axis = normal_axes_[f] % 3;
    std::array<LinearForm, 3> constant;
    for (std::size_t k = 0; k < 3; ++k)
      constant[k] = raw_point(cut_->copy_at(tet, solid.boundary[f][k]))[axis];
    for (std::size_t k = 1; k < 3; ++k) elimination_.impose(added(constant[k], constant[0], -1));
  }
}

void MapUnknowns::number_columns() {
  std::vector<std::uint32_t> columns(elimination_.size(), UINT32_MAX);
  const auto for_each_form = [&](const auto& visit) {
    for (std::vector<MapPoint>* points : {&points_, &translations_})
      for (MapPoint& point : *points)
        for (LinearForm& form : point) visit(form);
  };
  for_each_form([&](LinearForm& form) {
    for (const auto& term : form.terms) columns[term.unknown] = 0;
  });
  std::uint32_t count = 0;
  for (std::uint32_t& column : columns)
    if (column == 0) column = count++;
  for_each_form([&](LinearForm& form) {
    for (auto& term : form.terms) term.unknown = columns[term.unknown];
  });
  is_integer_.assign(count, 0);
}

void MapUnknowns::find_integers() {
  const auto mark = [&](const LinearForm& form) {
    for (const auto& term : form.terms) is_integer_[term.unknown] = 1;
  };
  for (const MapPoint& translation : translations_)
    for (const LinearForm& form : translation) mark(form);
  const TetComplex& complex = cut_->field().complex();
  const TetSolid& solid = complex.solid();
  for (std::uint32_t f = 0; f < solid.boundary.size(); ++f) {
    const std::uint32_t tet = solid.boundary_tets[f];
    mark(points_[cut_->copy_at(tet, solid.boundary[f][0])][normal_axes_[f] % 3]);
  }
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    if (!cut_->is_singular(e)) continue;
    const TetComplex::Edge& edge = complex.edges()[e];
    const MapPoint& point = points_[cut_->copy_at(edge.first_tet, edge.ends[0])];
    const int axis = axis_of_edge(e);
    for (int k = 0; k < 3; ++k)
      if (k != axis) mark(point[static_cast<std::size_t>(k)]);
  }
}

int MapUnknowns::axis_of_edge(std::uint32_t singular_edge) const {
  std::uint8_t rotation = CubeGroup::kIdentity;
  const CubeGroup& group = CubeGroup::instance();
  for (const SheetStep step : cut_->word_around(singular_edge)) {
    const std::uint8_t own = cut_->rotation(static_cast<std::size_t>(std::abs(step) - 1));
    rotation = group.product(step > 0 ? own : group.inverse_of(own), rotation);
  }
  for (SignedAxis axis = 0; axis < 3; ++axis)
    if (group.image(rotation, axis) == axis) return axis;
  return 3;
}

bool MapUnknowns::is_integer(const LinearForm& form) const {
  return std::all_of(form.terms.begin(), form.terms.end(),
                     [&](const auto& term) { return is_integer_[term.unknown] != 0; });
}

}  // namespace crossgrain
