// SPDX-License-Identifier: Apache-2.0
// A solid cut open along few faces, so that one name of the axes is left on either side of all others.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "matching/matched_field.hpp"
#include "matching/tet_complex.hpp"

namespace crossgrain {

/// A sheet of the cut with the side from which it is crossed: s + 1 along the direction of sheet s, -(s + 1)
/// against it; 0 for a face that is not cut.
using SheetStep = std::int32_t;

/// The steps across sheets on a way through the solid, one after the other; none beside its reverse.
using SheetWord = std::vector<SheetStep>;

/// The solid of a field with the axes of each tet named anew, so that most matchings are the identity: those
/// of a spanning tree of the tets, and those that close around regular edges. The faces that are left are
/// cut. They form sheets that end at singular edges, at the surface, and where more than two meet; a map is
/// u' = R u + T across a sheet, with one rotation R and one translation T for the whole of it.
///
/// Nieser, Reitebuch, Polthier 2011 ("CubeCover"), section 4. The field must outlive it.
class CutSolid {
 public:
  explicit CutSolid(const MatchedField& field);

  const MatchedField& field() const { return *field_; }

  /// The rotation that takes the axes of a tet's frame to their names here.
  std::uint8_t names_of(std::uint32_t tet) const { return names_[tet]; }

  bool is_cut(std::uint32_t inner_face) const { return steps_[inner_face] != 0; }

  SheetStep step_across(const Crossing& crossing) const {
    return crossing.reversed ? -steps_[crossing.face] : steps_[crossing.face];
  }

  std::size_t sheets() const { return rotations_.size(); }

  /// Of u on the way along the direction of a sheet.
  std::uint8_t rotation(std::size_t sheet) const { return rotations_[sheet]; }

  /// The steps all around an inner edge, from its first tet.
  SheetWord word_around(std::uint32_t inner_edge) const;

  bool is_singular(std::uint32_t inner_edge) const { return is_singular_[inner_edge] != 0; }

  /// Copies of vertices: the corners of tets at a vertex that hang together without the cut.
  std::size_t copies() const { return first_copies_.size(); }
  std::uint32_t copy_of(std::uint32_t tet, std::size_t corner) const { return copies_[tet][corner]; }
  std::uint32_t copy_at(std::uint32_t tet, std::uint32_t vertex) const;  ///< a vertex of the tet
  const std::vector<std::array<std::uint32_t, 4>>& copies_of_tets() const { return copies_; }

  /// The copy of the same vertex from which a word leads to this one.
  std::uint32_t first_copy(std::uint32_t copy) const { return first_copies_[copy]; }
  const SheetWord& word_to(std::uint32_t copy) const { return words_[copy]; }

 private:
  void name_axes(std::vector<std::uint8_t>& is_joined);
  void join_around_regular_edges(std::vector<std::uint8_t>& is_joined);
  void find_sheets(const std::vector<std::uint8_t>& is_joined);
  void find_copies();
  void find_words(std::span<const std::array<std::uint32_t, 2>> joins, std::span<const SheetStep> steps);
  std::uint8_t named_matching(std::uint32_t inner_face) const;

  const MatchedField* field_;
  std::vector<std::uint8_t> names_, is_singular_, rotations_;
  std::vector<SheetStep> steps_;           ///< from the first tet of each inner face to the second
  std::vector<std::uint32_t> cut_counts_;  ///< of the faces at each edge
  std::vector<std::array<std::uint32_t, 4>> copies_;
  std::vector<std::uint32_t> first_copies_;
  std::vector<SheetWord> words_;
};

/// Adds a step to a word; a step back takes the last one away.
void add_step(SheetWord& word, SheetStep step);

}  // namespace crossgrain
