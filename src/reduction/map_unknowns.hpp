// SPDX-License-Identifier: Apache-2.0
// What is free in a map that follows the matchings of a field.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "reduction/cut_solid.hpp"
#include "reduction/integer_elimination.hpp"

namespace crossgrain {

/// Three coordinates of the map as forms of unknowns.
using MapPoint = std::array<LinearForm, 3>;

/// The unknowns of a map of a cut solid (CutSolid) that is linear in each tet, after exact elimination of all
/// that its matchings demand:
///
/// - u' = R u + T across sheets of the cut, so that T = 0 around regular edges and u = R u + T on singular
///   ones;
/// - on a face of the surface the coordinate along the axis of its normal is constant.
///
/// Some unknowns are integers in a map that hexahedra can follow: those in translations, in the constant
/// coordinate of a face of the surface, and in the two coordinates across the axis of a singular edge.
///
/// Bommes, Campen, Ebke, Alliez, Kobbelt 2013 ("Integer-grid maps"), for tets. The cut must outlive it.
class MapUnknowns {
 public:
  /// Throws Error(kLimit) if the equations have factors that are no numbers in double precision.
  explicit MapUnknowns(const CutSolid& cut);

  const CutSolid& cut() const { return *cut_; }

  /// The coordinates of a copy (CutSolid::copy_of) as forms of columns.
  const MapPoint& point(std::uint32_t copy) const { return points_[copy]; }

  std::size_t columns() const { return is_integer_.size(); }
  bool is_integer(std::uint32_t column) const { return is_integer_[column] != 0; }

  /// Whether a form is an integer whatever the integer columns are.
  bool is_integer(const LinearForm& form) const;

  /// The signed axis along the outward normal of a boundary face, in the names of the cut.
  SignedAxis normal_axis(std::uint32_t boundary_face) const { return normal_axes_[boundary_face]; }

  /// The axis of a singular edge in its first tet, in the names of the cut.
  int axis_of_edge(std::uint32_t singular_edge) const;

  /// T of u' = R u + T along the direction of a sheet, as forms of columns.
  const MapPoint& translation(std::size_t sheet) const { return translations_[sheet]; }

 private:
  struct Transition {
    std::uint8_t rotation = CubeGroup::kIdentity;
    MapPoint translation;
  };

  const Transition& transition(const SheetWord& word);
  MapPoint raw_point(std::uint32_t copy);
  void impose_regular_edges();
  void impose_singular_edges();
  void impose_surface();
  void number_columns();
  void find_integers();

  const CutSolid* cut_;
  std::uint32_t first_translation_;
  IntegerElimination elimination_;
  std::map<SheetWord, Transition> transitions_;
  std::vector<SignedAxis> normal_axes_;
  std::vector<MapPoint> points_, translations_;
  std::vector<std::uint8_t> is_integer_;
};

}  // namespace crossgrain
