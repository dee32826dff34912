// SPDX-License-Identifier: Apache-2.0
#include "map/line_separations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_set>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;

/// Largest distances across and along lines that are near each other, in hexahedra of the map.
constexpr double kReach = 1.5, kBeside = 0.25;

/// Whether a map takes an edge to a line of the grid.
bool is_line(const CutSolid& cut, std::uint32_t edge) {
  const TetComplex::Edge& its = cut.field().complex().edges()[edge];
  if (its.is_branched) return false;
  return its.is_on_boundary() ? cut.field().boundary_turn(edge).hexahedra % 2 != 0 : cut.is_singular(edge);
}

std::vector<std::uint32_t> lines_of(const CutSolid& cut) {
  std::vector<std::uint32_t> lines;
  for (std::uint32_t e = 0; e < cut.field().complex().edges().size(); ++e)
    if (is_line(cut, e)) lines.push_back(e);
  return lines;
}

/// The only axis along which the ends of a line differ, in its first tet.
std::optional<std::size_t> axis_of(const MapUnknowns& unknowns, std::uint32_t edge) {
  const TetComplex::Edge& its = unknowns.cut().field().complex().edges()[edge];
  const MapPoint& a = unknowns.point(unknowns.cut().copy_at(its.first_tet, its.ends[0]));
  const MapPoint& b = unknowns.point(unknowns.cut().copy_at(its.first_tet, its.ends[1]));
  std::optional<std::size_t> axis;
  for (std::size_t k = 0; k < 3; ++k) {
    if (a[k] == b[k]) continue;
    if (axis) return std::nullopt;
    axis = k;
  }
  return axis;
}

/// u = R v + T of coordinates v of a tet, in the names of another.
struct Names {
  std::uint8_t rotation = CubeGroup::kIdentity;
  MapPoint translation{};
  Eigen::Vector3d shift{0, 0, 0};

  MapPoint of(const MapPoint& point) const {
    MapPoint result = turned(rotation, point);
    for (std::size_t k = 0; k < 3; ++k) result[k] = added(result[k], translation[k]);
    return result;
  }

  Eigen::Vector3d of(const Eigen::Vector3d& point) const { return shift + turned(rotation, point); }
};

struct Segment {
  std::array<Eigen::Vector3d, 2> ends;
  double low(std::size_t axis) const {
    return std::min(ends[0][static_cast<Index>(axis)], ends[1][static_cast<Index>(axis)]);
  }
  double high(std::size_t axis) const {
    return std::max(ends[0][static_cast<Index>(axis)], ends[1][static_cast<Index>(axis)]);
  }

  /// Between their extents along an axis; 0 if these overlap.
  double gap(const Segment& other, std::size_t axis) const {
    return std::max({0.0, other.low(axis) - high(axis), low(axis) - other.high(axis)});
  }
};

/// Walks from a line through the tets near it.
class Surroundings {
 public:
  Surroundings(const MapUnknowns& unknowns, const Eigen::VectorXd& columns, const MapCoordinates& map)
      : unknowns_(unknowns),
        cut_(unknowns.cut()),
        complex_(cut_.field().complex()),
        columns_(columns),
        map_(map),
        crossings_(crossings_of(complex_.solid())) {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (const std::uint32_t e : lines_of(cut_)) {
      const std::optional<std::size_t> axis = axis_of(unknowns, e);
      if (axis) pairs.push_back({complex_.edges()[e].first_tet, e}), axes_.emplace(e, *axis);
    }
    lines_ = ListTable(complex_.solid().mesh.tets.size(), pairs);
  }

  Separations gaps_at(std::uint32_t edge) const {
    Separations gaps;
    const auto axis = axes_.find(edge);
    if (axis == axes_.end()) return gaps;
    const std::uint32_t start = complex_.edges()[edge].first_tet;
    const Segment own = segment(start, edge, Names{});
    std::vector<Visit> visits{{start, 0}};
    std::vector<Names> names(1);
    std::unordered_set<std::uint32_t> seen{start};
    for (std::size_t k = 0; k < visits.size(); ++k) {
      const auto [tet, name] = visits[k];
      for (const std::uint32_t other : lines_[tet])
        if (other > edge) add_gap(edge, axis->second, own, tet, other, names[name], gaps);
      for (const Crossing& crossing : crossings_[tet]) {
        if (crossing.face == kNoFace) continue;
        const std::uint32_t next =
            complex_.solid().inner_faces[crossing.face].tets[crossing.reversed ? 0 : 1];
        if (seen.contains(next)) continue;
        const SheetStep step = cut_.step_across(crossing);
        Names beyond = step == 0 ? names[name] : names_beyond(names[name], step);
        if (!is_near(own, next, beyond)) continue;
        seen.insert(next);
        visits.push_back({next, step == 0 ? name : names.size()});
        if (step != 0) names.push_back(std::move(beyond));
      }
    }
    return gaps;
  }

 private:
  struct Visit {
    std::uint32_t tet;
    std::size_t names;
  };

  Eigen::Vector3d at(std::uint32_t copy) const { return map_.segment<3>(static_cast<Index>(3 * copy)); }

  Segment segment(std::uint32_t tet, std::uint32_t edge, const Names& names) const {
    const auto& [a, b] = complex_.edges()[edge].ends;
    return {{names.of(at(cut_.copy_at(tet, a))), names.of(at(cut_.copy_at(tet, b)))}};
  }

  bool is_near(const Segment& own, std::uint32_t tet, const Names& names) const {
    Eigen::Vector3d low, high;
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Vector3d corner = names.of(at(cut_.copy_of(tet, k)));
      low = k == 0 ? corner : low.cwiseMin(corner).eval();
      high = k == 0 ? corner : high.cwiseMax(corner).eval();
    }
    const Segment box{{low, high}};
    return own.gap(box, 0) < kReach && own.gap(box, 1) < kReach && own.gap(box, 2) < kReach;
  }

  /// From v' = R v + T along a sheet, v = R^-1 (v' - T).
  Names names_beyond(const Names& names, SheetStep step) const {
    const auto sheet = static_cast<std::size_t>(std::abs(step) - 1);
    const CubeGroup& group = CubeGroup::instance();
    const MapPoint& translation = unknowns_.translation(sheet);
    Eigen::Vector3d shift;
    for (std::size_t k = 0; k < 3; ++k) shift[static_cast<Index>(k)] = value_of(translation[k], columns_);
    Names beyond = names;
    if (step < 0) {
      beyond.rotation = group.product(names.rotation, cut_.rotation(sheet));
      beyond.translation = names.of(translation);
      beyond.shift = names.of(shift);
      return beyond;
    }
    beyond.rotation = group.product(names.rotation, group.inverse_of(cut_.rotation(sheet)));
    const MapPoint back = turned(beyond.rotation, translation);
    for (std::size_t k = 0; k < 3; ++k) beyond.translation[k] = added(names.translation[k], back[k], -1);
    beyond.shift = names.shift - turned(beyond.rotation, shift);
    return beyond;
  }

  void add_gap(std::uint32_t edge, std::size_t own_axis, const Segment& own, std::uint32_t tet,
               std::uint32_t other, const Names& names, Separations& gaps) const {
    const Segment its = segment(tet, other, names);
    const std::size_t its_axis =
        CubeGroup::instance().image(names.rotation, static_cast<SignedAxis>(axes_.at(other))) % 3;
    // Along either line they must be beside each other; how far they are apart across both is what counts.
    for (std::size_t k = 0; k < 3; ++k)
      if (own.gap(its, k) >= (k == own_axis || k == its_axis ? kBeside : kReach)) return;
    const MapPoint& from =
        unknowns_.point(cut_.copy_at(complex_.edges()[edge].first_tet, complex_.edges()[edge].ends[0]));
    const MapPoint to = names.of(unknowns_.point(cut_.copy_at(tet, complex_.edges()[other].ends[0])));
    std::optional<LinearForm> farthest;
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == own_axis || k == its_axis) continue;
      LinearForm form = added(to[k], from[k], -1);
      if (form.is_zero() || !unknowns_.is_integer(form)) continue;
      const double distance = value_of(form, columns_);
      if (std::abs(distance) <= most) continue;
      most = std::abs(distance);
      farthest = distance > 0 ? std::move(form) : -form;
    }
    constexpr double kApart = 1e-6;
    if (farthest && most > kApart) gaps.push_back(std::move(*farthest));
  }

  const MapUnknowns& unknowns_;
  const CutSolid& cut_;
  const TetComplex& complex_;
  const Eigen::VectorXd& columns_;
  const MapCoordinates& map_;
  std::vector<std::array<Crossing, 4>> crossings_;
  ListTable lines_;  ///< at the first tet of each
  std::map<std::uint32_t, std::size_t> axes_;
};

/// Whether lines go on through a vertex: two of them, of one kind, and no corner of the surface.
bool goes_on(const CutSolid& cut, std::uint32_t vertex, const std::vector<std::uint32_t>& lines) {
  if (lines.size() != 2) return false;
  const TetComplex& complex = cut.field().complex();
  const bool on_surface = complex.is_on_boundary(vertex);
  for (const std::uint32_t e : lines)
    if (complex.edges()[e].is_on_boundary() != on_surface) return false;
  return !on_surface || (!complex.is_pinched(vertex) && !cut.field().is_map_corner(vertex));
}

}  // namespace

double value_of(const LinearForm& form, const Eigen::VectorXd& columns) {
  double sum = 0;
  for (const auto& [column, factor] : form.terms) sum += static_cast<double>(factor) * columns[column];
  return sum;
}

Separations line_lengths(const MapUnknowns& unknowns, const Eigen::VectorXd& columns) {
  const CutSolid& cut = unknowns.cut();
  const TetComplex& complex = cut.field().complex();
  const auto count = static_cast<std::uint32_t>(complex.edges().size());
  std::vector<bool> is_of_line(count, false);
  const std::vector<std::uint32_t> lines = lines_of(cut);
  for (const std::uint32_t e : lines) is_of_line[e] = true;
  DisjointSets sets(count);
  for (std::uint32_t v = 0; v < complex.solid().mesh.vertices.size(); ++v) {
    std::vector<std::uint32_t> at;
    for (const std::uint32_t e : complex.edges_at(v))
      if (is_of_line[e]) at.push_back(e);
    if (goes_on(cut, v, at)) sets.join(at[0], at[1]);
  }
  std::map<std::uint32_t, LinearForm> lengths;
  for (const std::uint32_t e : lines) {
    const std::optional<std::size_t> axis = axis_of(unknowns, e);
    if (!axis) continue;
    const TetComplex::Edge& edge = complex.edges()[e];
    const LinearForm way = added(unknowns.point(cut.copy_at(edge.first_tet, edge.ends[1]))[*axis],
                                 unknowns.point(cut.copy_at(edge.first_tet, edge.ends[0]))[*axis], -1);
    LinearForm& length = lengths[sets.root(e)];
    length = added(length, way, value_of(way, columns) > 0 ? 1 : -1);
  }
  Separations result;
  for (auto& [root, length] : lengths)
    if (!length.is_zero() && unknowns.is_integer(length)) result.push_back(std::move(length));
  return result;
}

Separations line_gaps(const MapUnknowns& unknowns, const Eigen::VectorXd& columns,
                      const MapCoordinates& map) {
  const Surroundings surroundings(unknowns, columns, map);
  const std::vector<std::uint32_t> lines = lines_of(unknowns.cut());
  std::vector<Separations> of_line(lines.size());
  parallel_for(
      lines.size(), [&](std::size_t k) { of_line[k] = surroundings.gaps_at(lines[k]); }, /*grain=*/8);
  Separations gaps;
  for (Separations& some : of_line)
    gaps.insert(gaps.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  return gaps;
}

}  // namespace crossgrain
