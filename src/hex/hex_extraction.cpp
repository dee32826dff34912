// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_extraction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "hex/grid_point.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;

constexpr std::uint32_t kNone = UINT32_MAX;

GridPoint turned(std::uint8_t rotation, const GridPoint& p) {
  GridPoint result{};
  for (SignedAxis k = 0; k < 3; ++k) {
    const SignedAxis image = CubeGroup::instance().image(rotation, k);
    result[image % 3] = image < 3 ? p[k] : -p[k];
  }
  return result;
}

/// A map in exact numbers.
class ExactMap {
 public:
  ExactMap(const MapUnknowns& unknowns, const MapCoordinates& map)
      : cut_(unknowns.cut()), solid_(cut_.field().complex().solid()) {
    if (map.size() > 0 && map.cwiseAbs().maxCoeff() > kLargestCoordinate)
      throw Error(ErrorKind::kLimit, "the map has more hexahedra along an axis than its numbers hold");
    find_translations(map);
    round_points(map);
  }

  const CutSolid& cut() const { return cut_; }
  const TetSolid& solid() const { return solid_; }

  std::array<GridPoint, 4> corners(std::uint32_t tet) const {
    std::array<GridPoint, 4> result{};
    for (std::size_t k = 0; k < 4; ++k) result[k] = points_[cut_.copy_of(tet, k)];
    return result;
  }

  /// A point in the names beyond a face.
  GridPoint carried(const GridPoint& point, const Crossing& crossing) const {
    return step(point, cut_.step_across(crossing));
  }

  /// The same for a cell, by its lowest corner.
  GridPoint carried_cell(const GridPoint& low, const Crossing& crossing) const {
    GridPoint high = low;
    for (std::int64_t& x : high) x += kGridUnit;
    const GridPoint a = carried(low, crossing), b = carried(high, crossing);
    return {std::min(a[0], b[0]), std::min(a[1], b[1]), std::min(a[2], b[2])};
  }

 private:
  GridPoint step(const GridPoint& point, SheetStep step) const {
    if (step == 0) return point;
    const auto sheet = static_cast<std::size_t>(std::abs(step) - 1);
    const CubeGroup& group = CubeGroup::instance();
    const GridPoint& translation = translations_[sheet];
    GridPoint result = point;
    if (step > 0) {
      result = turned(cut_.rotation(sheet), result);
      for (std::size_t k = 0; k < 3; ++k) result[k] += translation[k];
      return result;
    }
    for (std::size_t k = 0; k < 3; ++k) result[k] -= translation[k];
    return turned(group.inverse_of(cut_.rotation(sheet)), result);
  }

  /// Of each sheet, from any of its faces: translations of a map to the grid are whole.
  void find_translations(const MapCoordinates& map) {
    translations_.resize(cut_.sheets());
    std::vector<bool> is_known(cut_.sheets(), false);
    for (std::uint32_t f = 0; f < solid_.inner_faces.size(); ++f) {
      const SheetStep step = cut_.step_across({f, false});
      if (step == 0 || is_known[static_cast<std::size_t>(std::abs(step) - 1)]) continue;
      const auto sheet = static_cast<std::size_t>(std::abs(step) - 1);
      is_known[sheet] = true;
      const auto& [vertices, sides] = solid_.inner_faces[f];
      const std::uint32_t from = sides[step > 0 ? 0 : 1], to = sides[step > 0 ? 1 : 0];
      const GridPoint before = whole_part(map, from, vertices[0]), after = whole_part(map, to, vertices[0]);
      // Both are rounded to 2^-20; their difference is a whole number but for that.
      const GridPoint there = turned(cut_.rotation(sheet), before);
      for (std::size_t k = 0; k < 3; ++k)
        translations_[sheet][k] = kGridUnit * std::llround(static_cast<double>(after[k] - there[k]) /
                                                           static_cast<double>(kGridUnit));
    }
  }

  GridPoint whole_part(const MapCoordinates& map, std::uint32_t tet, std::uint32_t vertex) const {
    return rounded(map, cut_.copy_at(tet, vertex));
  }

  static GridPoint rounded(const MapCoordinates& map, std::uint32_t copy) {
    GridPoint point{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = map[static_cast<Index>(3 * copy) + static_cast<Index>(k)];
      // Integers of the map are so to about 1e-9, far below half a step.
      point[k] = std::llround(value * static_cast<double>(kGridUnit));
    }
    return point;
  }

  void round_points(const MapCoordinates& map) {
    points_.resize(cut_.copies());
    for (std::uint32_t copy = 0; copy < points_.size(); ++copy) {
      const std::uint32_t first = cut_.first_copy(copy);  // comes before its other copies
      if (first == copy) {
        points_[copy] = rounded(map, copy);
        continue;
      }
      GridPoint point = points_[first];
      for (const SheetStep s : cut_.word_to(copy)) point = step(point, s);
      points_[copy] = point;
    }
  }

  const CutSolid& cut_;
  const TetSolid& solid_;
  std::vector<GridPoint> translations_, points_;
};

std::array<GridPoint, 3> face_opposite(const std::array<GridPoint, 4>& corners, std::size_t k) {
  return {corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4]};
}

/// What a tet has of the grid.
struct TetPart {
  struct Cell {
    GridPoint low;
    std::array<bool, 4> meets_face;  ///< opposite each corner
    bool operator<(const Cell& other) const { return low < other.low; }
  };
  struct Vertex {
    GridPoint at;
    std::array<Int128, 4> weights;  ///< six volumes, by corner
    bool operator<(const Vertex& other) const { return at < other.at; }
  };
  Int128 volume = 0;
  std::vector<Cell> cells;       ///< ascending
  std::vector<Vertex> vertices;  ///< ascending
};

std::array<Int128, 4> weights_of(const std::array<GridPoint, 4>& corners, const GridPoint& point) {
  const auto& [a, b, c, d] = corners;
  return {six_volumes(point, b, c, d), six_volumes(a, point, c, d), six_volumes(a, b, point, d),
          six_volumes(a, b, c, point)};
}

bool is_inside(const std::array<Int128, 4>& weights) {
  return std::all_of(weights.begin(), weights.end(), [](Int128 weight) { return weight >= 0; });
}

std::int64_t floor_to_unit(std::int64_t x) {
  const std::int64_t rest = ((x % kGridUnit) + kGridUnit) % kGridUnit;
  return x - rest;
}

template <class Visit>
void for_each_grid_point(const std::array<GridPoint, 4>& corners, const Visit& visit) {
  GridPoint low = corners[0], high = corners[0];
  for (const GridPoint& corner : corners)
    for (std::size_t k = 0; k < 3; ++k)
      low[k] = std::min(low[k], corner[k]), high[k] = std::max(high[k], corner[k]);
  for (std::int64_t& x : low) x = floor_to_unit(x);
  for (std::int64_t x = low[0]; x <= high[0]; x += kGridUnit)
    for (std::int64_t y = low[1]; y <= high[1]; y += kGridUnit)
      for (std::int64_t z = low[2]; z <= high[2]; z += kGridUnit) visit(GridPoint{x, y, z});
}

TetPart part_of(const std::array<GridPoint, 4>& corners) {
  TetPart part;
  part.volume = six_volumes(corners[0], corners[1], corners[2], corners[3]);
  for_each_grid_point(corners, [&](const GridPoint& point) {
    TetPart::Cell cell{point, {}};
    bool meets = false;
    for (std::size_t k = 0; k < 4; ++k)
      meets |= cell.meets_face[k] = meets_open_cell(face_opposite(corners, k), point);
    if (part.volume > 0) {
      const std::array<Int128, 4> weights = weights_of(corners, point);
      if (is_inside(weights)) part.vertices.push_back({point, weights});
      GridPoint centre = point;
      for (std::int64_t& x : centre) x += kGridUnit / 2;
      meets = meets || is_inside(weights_of(corners, centre));
    }
    if (meets) part.cells.push_back(cell);
  });
  return part;
}

/// Numbers the cells, or the vertices, of all tets one after the other.
class Extraction {
 public:
  explicit Extraction(const ExactMap& map)
      : map_(map),
        tets_(map.solid().mesh.tets.size()),
        crossings_(crossings_of(map.solid())),
        parts_(tets_),
        first_cells_(tets_ + 1, 0),
        first_vertices_(tets_ + 1, 0) {
    parallel_for(tets_,
                 [&](std::size_t t) { parts_[t] = part_of(map.corners(static_cast<std::uint32_t>(t))); });
    for (std::size_t t = 0; t < tets_; ++t) {
      first_cells_[t + 1] = first_cells_[t] + static_cast<std::uint32_t>(parts_[t].cells.size());
      first_vertices_[t + 1] = first_vertices_[t] + static_cast<std::uint32_t>(parts_[t].vertices.size());
    }
  }

  ExtractedHexahedra result() {
    ExtractedHexahedra result;
    for (const TetPart& part : parts_) result.flipped_tets += part.volume <= 0;
    DisjointSets cells(first_cells_.back()), vertices(first_vertices_.back());
    join(cells, vertices);
    add_hexahedra(cells, vertices, result);
    return result;
  }

 private:
  std::uint32_t cell_in(std::uint32_t tet, const GridPoint& low) const {
    const auto& cells = parts_[tet].cells;
    const auto found = std::lower_bound(cells.begin(), cells.end(), TetPart::Cell{low, {}});
    if (found == cells.end() || found->low != low) return kNone;
    return first_cells_[tet] + static_cast<std::uint32_t>(found - cells.begin());
  }

  std::uint32_t vertex_in(std::uint32_t tet, const GridPoint& at) const {
    const auto& vertices = parts_[tet].vertices;
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), TetPart::Vertex{at, {}});
    if (found == vertices.end() || found->at != at) return kNone;
    return first_vertices_[tet] + static_cast<std::uint32_t>(found - vertices.begin());
  }

  void join(DisjointSets& cells, DisjointSets& vertices) const {
    for (std::uint32_t t = 0; t < tets_; ++t) {
      for (std::size_t k = 0; k < 4; ++k) {
        const Crossing crossing = crossings_[t][k];
        if (crossing.face == kNoFace || crossing.reversed) continue;
        const std::uint32_t next = map_.solid().inner_faces[crossing.face].tets[1];
        for (std::uint32_t c = 0; c < parts_[t].cells.size(); ++c) {
          if (!parts_[t].cells[c].meets_face[k]) continue;
          const std::uint32_t beyond = cell_in(next, map_.carried_cell(parts_[t].cells[c].low, crossing));
          if (beyond != kNone) cells.join(first_cells_[t] + c, beyond);
        }
        for (std::uint32_t v = 0; v < parts_[t].vertices.size(); ++v) {
          if (parts_[t].vertices[v].weights[k] != 0) continue;
          const std::uint32_t beyond = vertex_in(next, map_.carried(parts_[t].vertices[v].at, crossing));
          if (beyond != kNone) vertices.join(first_vertices_[t] + v, beyond);
        }
      }
    }
  }

  void add_hexahedra(DisjointSets& cells, DisjointSets& vertices, ExtractedHexahedra& result) const {
    std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> pieces;
    for (std::uint32_t t = 0; t < tets_; ++t)
      for (std::uint32_t c = 0; c < parts_[t].cells.size(); ++c)
        pieces[cells.root(first_cells_[t] + c)].push_back({t, c});
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (const auto& [name, of_cell] : pieces) {
      const std::optional<std::array<std::uint32_t, 8>> corners = corners_of(of_cell, vertices);
      if (!corners) {
        ++result.left_out;
        continue;
      }
      std::array<std::uint32_t, 8> hexahedron{};
      for (std::size_t k = 0; k < 8; ++k) {
        const auto [known, is_new] =
            numbers.try_emplace((*corners)[k], static_cast<std::uint32_t>(result.mesh.vertices.size()));
        if (is_new) add_vertex((*corners)[k], result);
        hexahedron[k] = known->second;
      }
      result.mesh.hexahedra.push_back(hexahedron);
      result.centre_tets.push_back(tet_at_centre(of_cell));
    }
  }

  std::uint32_t tet_at_centre(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pieces) const {
    for (const auto& [t, c] : pieces) {
      GridPoint centre = parts_[t].cells[c].low;
      for (std::int64_t& x : centre) x += kGridUnit / 2;
      if (is_inside(weights_of(map_.corners(t), centre))) return t;
    }
    return pieces.front().first;
  }

  /// The vertices at the corners of a cell. Names differ from tet to tet, so each piece is brought to those
  /// of the first through the faces that join them.
  std::optional<std::array<std::uint32_t, 8>> corners_of(
      const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pieces, DisjointSets& vertices) const {
    std::map<std::uint32_t, std::uint8_t> names;  // of tet: rotation from the first
    std::set<std::uint32_t> tets;
    for (const auto& [t, c] : pieces) {
      if (parts_[t].volume <= 0) return std::nullopt;
      if (!tets.insert(t).second) return std::nullopt;  // the cell meets a tet in two ways
    }
    std::map<std::uint32_t, GridPoint> lows;
    for (const auto& [t, c] : pieces) lows.emplace(t, parts_[t].cells[c].low);
    std::array<std::uint32_t, 8> corners;
    corners.fill(kNone);
    std::vector<std::uint32_t> reached{pieces.front().first};
    names[reached[0]] = CubeGroup::kIdentity;
    const CubeGroup& group = CubeGroup::instance();
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const std::uint32_t t = reached[k];
      if (!take_corners(t, lows.at(t), group.inverse_of(names.at(t)), vertices, corners)) return std::nullopt;
      for (std::size_t side = 0; side < 4; ++side) {
        const Crossing crossing = crossings_[t][side];
        if (crossing.face == kNoFace || !meets_open_cell(face_opposite(map_.corners(t), side), lows.at(t)))
          continue;
        const std::uint32_t next = map_.solid().inner_faces[crossing.face].tets[crossing.reversed ? 0 : 1];
        if (!lows.contains(next) || names.contains(next)) continue;
        names[next] = group.product(rotation_across(crossing), names.at(t));
        reached.push_back(next);
      }
    }
    if (std::find(corners.begin(), corners.end(), kNone) != corners.end()) return std::nullopt;
    return corners;
  }

  std::uint8_t rotation_across(const Crossing& crossing) const {
    const SheetStep step = map_.cut().step_across(crossing);
    if (step == 0) return CubeGroup::kIdentity;
    const std::uint8_t own = map_.cut().rotation(static_cast<std::size_t>(std::abs(step) - 1));
    return step > 0 ? own : CubeGroup::instance().inverse_of(own);
  }

  /// Fills in the corners of a cell that lie in a tet; false if one of them is another vertex than before.
  bool take_corners(std::uint32_t tet, const GridPoint& low, std::uint8_t back, DisjointSets& vertices,
                    std::array<std::uint32_t, 8>& corners) const {
    // Corners by their coordinates in the names of the first tet: right-handed around the lower face.
    constexpr std::array<std::uint8_t, 8> kOrder{0, 1, 3, 2, 4, 5, 7, 6};
    for (std::uint8_t k = 0; k < 8; ++k) {
      const GridPoint half{k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1};
      GridPoint at = low;
      for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += half[axis] > 0 ? kGridUnit : 0;
      const std::uint32_t found = vertex_in(tet, at);
      if (found == kNone) continue;
      const GridPoint first = turned(back, half);
      const auto place = static_cast<std::size_t>((first[0] > 0) + 2 * (first[1] > 0) + 4 * (first[2] > 0));
      std::uint32_t& corner = corners[kOrder[place]];
      const std::uint32_t vertex = vertices.root(found);
      if (corner != kNone && corner != vertex) return false;
      corner = vertex;
    }
    return true;
  }

  void add_vertex(std::uint32_t vertex, ExtractedHexahedra& result) const {
    const auto tet =
        static_cast<std::size_t>(std::upper_bound(first_vertices_.begin(), first_vertices_.end(), vertex) -
                                 first_vertices_.begin() - 1);
    const TetPart::Vertex& found = parts_[tet].vertices[vertex - first_vertices_[tet]];
    const TetMesh& mesh = map_.solid().mesh;
    Vector3 place{0, 0, 0};
    Carrier carrier{.tet = static_cast<std::uint32_t>(tet)};
    for (std::size_t k = 0; k < 4; ++k) {
      if (found.weights[k] == 0) continue;
      const std::uint32_t corner = mesh.tets[tet][k];
      place += static_cast<double>(found.weights[k]) / static_cast<double>(parts_[tet].volume) *
               mesh.vertices[corner];
      carrier.vertices[carrier.count++] = corner;
    }
    std::sort(carrier.vertices.begin(), carrier.vertices.end());
    result.mesh.vertices.push_back(place);
    result.carriers.push_back(carrier);
  }

  const ExactMap& map_;
  std::size_t tets_;
  std::vector<std::array<Crossing, 4>> crossings_;
  std::vector<TetPart> parts_;
  std::vector<std::uint32_t> first_cells_, first_vertices_;
};

}  // namespace

ExtractedHexahedra extracted_hexahedra(const MapUnknowns& unknowns, const MapCoordinates& map) {
  const ExactMap exact(unknowns, map);
  return Extraction(exact).result();
}

}  // namespace crossgrain
