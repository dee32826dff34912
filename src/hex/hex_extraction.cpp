// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_extraction.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "hex/exact_map.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

/// Whether, and how, a tet covers a point: 1 or -1 for a tet that is flipped; none if the point is on its
/// boundary.
std::optional<int> cover(const std::array<ExactPoint, 4>& corners, const ExactPoint& point) {
  const std::array<Int128, 4> weights = weights_of(corners, point);
  const auto [least, most] = std::minmax_element(weights.begin(), weights.end());
  if (*least > 0) return 1;
  if (*most < 0) return -1;
  if (*least < 0 && *most > 0) return 0;
  return std::nullopt;
}

/// Number of the corner of a hexahedron (kHexFaces) that a vector from its centre points to.
std::size_t corner_towards(const ExactPoint& half) {
  constexpr std::array<std::uint8_t, 8> kOrder{0, 1, 3, 2, 4, 5, 7, 6};
  return kOrder[static_cast<std::size_t>((half[0] > 0) + 2 * (half[1] > 0) + 4 * (half[2] > 0))];
}

ExactPoint towards(std::uint8_t k) {
  return {k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1};
}

/// A cell of the grid in a tet, by its index in the part of that.
struct Piece {
  std::uint32_t tet, cell;
};

/// Connected pieces of cells.
struct Component {
  std::vector<Piece> pieces;
  std::vector<std::uint8_t> names;  ///< of each piece: rotation from the names of the first
  std::optional<int> degree;        ///< how often they cover their cell; none if they do in no one way
  std::uint32_t centre_tet = 0;     ///< near the middle of the cell
};

/// Numbers the cells, or the vertices, of all tets one after the other.
class Extraction {
 public:
  explicit Extraction(const ExactMap& map)
      : map_(map),
        tets_(static_cast<std::uint32_t>(map.solid().mesh.tets.size())),
        crossings_(crossings_of(map.solid())),
        parts_(tets_),
        first_cells_(tets_ + 1, 0),
        first_vertices_(tets_ + 1, 0) {
    // Few tets may have many cells.
    constexpr std::size_t kTetsAtATime = 16;
    parallel_for(
        tets_, [&](std::size_t t) { parts_[t] = part_of(map.corners(static_cast<std::uint32_t>(t))); },
        kTetsAtATime);
    for (std::size_t t = 0; t < tets_; ++t) {
      first_cells_[t + 1] = first_cells_[t] + static_cast<std::uint32_t>(parts_[t].cells.size());
      first_vertices_[t + 1] = first_vertices_[t] + static_cast<std::uint32_t>(parts_[t].vertices.size());
    }
  }

  ExtractedHexahedra result() {
    find_components();
    parallel_for(components_.size(), [&](std::size_t c) { find_degree(components_[c]); });
    DisjointSets corners(first_vertices_.back() + static_cast<std::uint32_t>(8 * components_.size()));
    join_vertices(corners);
    Checkpoint checkpoint;
    for (std::uint32_t c = 0; c < components_.size(); ++c)
      if (is_hexahedron(c)) join_corners(c, corners, checkpoint);
    for (std::uint32_t t = 0; t < tets_; ++t) join_neighbours(t, corners, checkpoint);
    return hexahedra(corners);
  }

 private:
  std::uint32_t cell_in(std::uint32_t tet, const ExactPoint& low) const {
    const auto& cells = parts_[tet].cells;
    const auto found = std::lower_bound(cells.begin(), cells.end(), TetPart::Cell{low, {}});
    if (found == cells.end() || found->low != low) return kNone;
    return static_cast<std::uint32_t>(found - cells.begin());
  }

  std::uint32_t vertex_in(std::uint32_t tet, const ExactPoint& at) const {
    const auto& vertices = parts_[tet].vertices;
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), TetPart::Vertex{at, {}});
    if (found == vertices.end() || found->at != at) return kNone;
    return first_vertices_[tet] + static_cast<std::uint32_t>(found - vertices.begin());
  }

  std::uint32_t tet_beyond(const Crossing& crossing) const {
    return map_.solid().inner_faces[crossing.face].tets[crossing.reversed ? 0 : 1];
  }

  /// Visits the ways through faces that join a cell of a tet to the same cell beyond.
  template <class Visit>
  void for_each_way(const Piece& piece, const Visit& visit) const {
    const TetPart::Cell& cell = parts_[piece.tet].cells[piece.cell];
    for (std::size_t k = 0; k < 4; ++k) {
      const Crossing crossing = crossings_[piece.tet][k];
      if (crossing.face == kNoFace || !cell.meets_face[k]) continue;
      const std::uint32_t next = tet_beyond(crossing);
      const std::uint32_t beyond = cell_in(next, map_.carried_cell(cell.low, crossing));
      if (beyond != kNone) visit(crossing, Piece{next, beyond});
    }
  }

  std::uint32_t number_of(const Piece& piece) const { return first_cells_[piece.tet] + piece.cell; }

  void find_components() {
    DisjointSets cells(first_cells_.back());
    std::vector<Piece> all;
    all.reserve(first_cells_.back());
    for (std::uint32_t t = 0; t < tets_; ++t)
      for (std::uint32_t c = 0; c < parts_[t].cells.size(); ++c) all.push_back({t, c});
    Checkpoint checkpoint;
    for (const Piece& piece : all) {
      checkpoint.pass();
      for_each_way(piece, [&](const Crossing&, const Piece& beyond) {
        cells.join(number_of(piece), number_of(beyond));
      });
    }
    component_of_.resize(all.size());
    for (const Piece& piece : all) {
      checkpoint.pass();
      const std::uint32_t number = number_of(piece), root = cells.root(number);
      if (root == number) {  // comes before the others
        component_of_[number] = static_cast<std::uint32_t>(components_.size());
        components_.emplace_back();
      }
      component_of_[number] = component_of_[root];
      components_[component_of_[number]].pieces.push_back(piece);
    }
  }

  /// Brings the pieces of a component to the names of the first, and counts how often they cover a point of
  /// their cell.
  void find_degree(Component& component) const {
    // A few points near the centre, until one is on no face of a tet.
    for (const std::int64_t k : {0, 1, 2, 3, 4, 5, 6, 7}) {
      ExactPoint point = parts_[component.pieces[0].tet].cells[component.pieces[0].cell].low;
      const ExactPoint off{1237 * k, 2741 * k + 11 * k * k, 4127 * k - 17 * k * k};
      for (std::size_t axis = 0; axis < 3; ++axis) point[axis] += kGridUnit / 2 + off[axis];
      const std::optional<std::vector<ExactPoint>> points = points_in_pieces(component, point);
      if (!points) return;  // the cell goes around something and comes back turned
      if (count_covers(component, *points)) return;
    }
  }

  std::optional<std::vector<ExactPoint>> points_in_pieces(Component& component,
                                                          const ExactPoint& point) const {
    std::map<std::uint32_t, std::size_t> places;
    for (std::size_t k = 0; k < component.pieces.size(); ++k) places[number_of(component.pieces[k])] = k;
    std::vector<ExactPoint> points(component.pieces.size());
    std::vector<bool> is_known(points.size(), false);
    component.names.assign(points.size(), CubeGroup::kIdentity);
    points[0] = point;
    is_known[0] = true;
    std::vector<std::size_t> reached{0};
    bool agrees = true;
    for (std::size_t r = 0; r < reached.size(); ++r) {
      const std::size_t from = reached[r];
      for_each_way(component.pieces[from], [&](const Crossing& crossing, const Piece& beyond) {
        const std::size_t to = places.at(number_of(beyond));
        const ExactPoint there = map_.carried(points[from], crossing);
        const std::uint8_t name =
            CubeGroup::instance().product(map_.rotation_across(crossing), component.names[from]);
        if (is_known[to]) {
          agrees = agrees && points[to] == there && component.names[to] == name;
          return;
        }
        is_known[to] = true;
        points[to] = there;
        component.names[to] = name;
        reached.push_back(to);
      });
    }
    if (!agrees) return std::nullopt;
    return points;
  }

  bool count_covers(Component& component, const std::vector<ExactPoint>& points) const {
    int degree = 0;
    component.centre_tet = component.pieces[0].tet;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::uint32_t tet = component.pieces[k].tet;
      if (parts_[tet].volume == 0) continue;
      const std::optional<int> here = cover(map_.corners(tet), points[k]);
      if (!here) return false;
      if (*here > 0) component.centre_tet = tet;
      degree += *here;
    }
    component.degree = degree;
    return true;
  }

  bool is_hexahedron(std::uint32_t component) const { return components_[component].degree == 1; }

  std::uint32_t corner(std::uint32_t component, std::size_t k) const {
    return first_vertices_.back() + static_cast<std::uint32_t>(8 * component + k);
  }

  /// Joins what different tets have of a vertex.
  void join_vertices(DisjointSets& corners) const {
    Checkpoint checkpoint;
    for (std::uint32_t t = 0; t < tets_; ++t) {
      for (std::size_t k = 0; k < 4; ++k) {
        const Crossing crossing = crossings_[t][k];
        if (crossing.face == kNoFace || crossing.reversed) continue;
        for (std::uint32_t v = 0; v < parts_[t].vertices.size(); ++v) {
          checkpoint.pass();
          if (parts_[t].vertices[v].weights[k] != 0) continue;
          const std::uint32_t beyond =
              vertex_in(tet_beyond(crossing), map_.carried(parts_[t].vertices[v].at, crossing));
          if (beyond != kNone) corners.join(first_vertices_[t] + v, beyond);
        }
      }
    }
  }

  /// Joins the corners of a hexahedron to the vertices there.
  void join_corners(std::uint32_t number, DisjointSets& corners, Checkpoint& checkpoint) const {
    const Component& component = components_[number];
    for (std::size_t p = 0; p < component.pieces.size(); ++p) {
      const auto& [tet, cell] = component.pieces[p];
      const std::uint8_t back = CubeGroup::instance().inverse_of(component.names[p]);
      for (std::uint8_t k = 0; k < 8; ++k) {
        checkpoint.pass();
        ExactPoint at = parts_[tet].cells[cell].low;
        for (std::size_t axis = 0; axis < 3; ++axis) at[axis] += towards(k)[axis] > 0 ? kGridUnit : 0;
        const std::uint32_t found = vertex_in(tet, at);
        if (found != kNone) corners.join(found, corner(number, corner_towards(turned(back, towards(k)))));
      }
    }
  }

  /// Joins the corners of hexahedra on either side of a face that a tet meets: a tet that meets two open
  /// cells meets the open face between them too.
  void join_neighbours(std::uint32_t tet, DisjointSets& corners, Checkpoint& checkpoint) const {
    const auto& cells = parts_[tet].cells;
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
      checkpoint.pass();
      if (!is_hexahedron(component_of_[first_cells_[tet] + c])) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ExactPoint low = cells[c].low;
        low[axis] += kGridUnit;
        const std::uint32_t next = cell_in(tet, low);
        if (next == kNone || !is_hexahedron(component_of_[first_cells_[tet] + next])) continue;
        for (std::uint8_t k = 0; k < 8; ++k) {
          if (towards(k)[axis] < 0) continue;
          ExactPoint beyond = towards(k);
          beyond[axis] = -1;
          corners.join(corner_in({tet, c}, towards(k)), corner_in({tet, next}, beyond));
        }
      }
    }
  }

  std::uint32_t corner_in(const Piece& piece, const ExactPoint& half) const {
    const std::uint32_t number = component_of_[number_of(piece)];
    const Component& component = components_[number];
    const auto place = std::lower_bound(
        component.pieces.begin(), component.pieces.end(), piece,
        [](const Piece& a, const Piece& b) { return a.tet != b.tet ? a.tet < b.tet : a.cell < b.cell; });
    const std::uint8_t name = component.names[static_cast<std::size_t>(place - component.pieces.begin())];
    return corner(number, corner_towards(turned(CubeGroup::instance().inverse_of(name), half)));
  }

  ExtractedHexahedra hexahedra(DisjointSets& corners) const {
    ExtractedHexahedra result;
    for (const TetPart& part : parts_) result.flipped_tets += part.volume <= 0;
    const std::vector<std::uint32_t> places = places_of(corners);
    std::vector<std::uint32_t> numbers(places.size(), kNone);
    Checkpoint checkpoint;
    for (std::uint32_t c = 0; c < components_.size(); ++c) {
      checkpoint.pass();
      if (components_[c].degree == 0) continue;
      std::array<std::uint32_t, 8> hexahedron{};
      for (std::size_t k = 0; k < 8; ++k) hexahedron[k] = corners.root(corner(c, k));
      std::array<std::uint32_t, 8> ascending = hexahedron;
      std::ranges::sort(ascending);
      const bool are_different = std::ranges::adjacent_find(ascending) == ascending.end();
      if (!is_hexahedron(c) || !are_different || ascending.back() >= first_vertices_.back()) {
        result.left_out.push_back(components_[c].pieces.front().tet);
        continue;
      }
      for (std::uint32_t& vertex : hexahedron) {
        std::uint32_t& number = numbers[vertex];
        if (number == kNone) {
          number = static_cast<std::uint32_t>(result.mesh.vertices.size());
          add_vertex(places[vertex], result);
        }
        vertex = number;
      }
      result.mesh.hexahedra.push_back(hexahedron);
      result.centre_tets.push_back(components_[c].centre_tet);
    }
    return result;
  }

  /// For each root, the vertex whose place it takes: where there are several, since the map folds, one on a
  /// vertex, edge or face of a tet, which what is on the surface has, and in a tet that is not flipped.
  std::vector<std::uint32_t> places_of(DisjointSets& corners) const {
    std::vector<std::uint32_t> places(first_vertices_.back(), kNone);
    std::vector<std::pair<int, bool>> ranks(places.size());
    Checkpoint checkpoint;
    for (std::uint32_t t = 0; t < tets_; ++t) {
      for (std::uint32_t v = 0; v < parts_[t].vertices.size(); ++v) {
        checkpoint.pass();
        const auto& weights = parts_[t].vertices[v].weights;
        const std::pair rank(static_cast<int>(4 - std::count(weights.begin(), weights.end(), 0)),
                             parts_[t].volume < 0);
        const std::uint32_t number = first_vertices_[t] + v, root = corners.root(number);
        if (places[root] != kNone && ranks[root] <= rank) continue;
        places[root] = number;
        ranks[root] = rank;
      }
    }
    return places;
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
  std::uint32_t tets_;
  std::vector<std::array<Crossing, 4>> crossings_;
  std::vector<TetPart> parts_;
  std::vector<std::uint32_t> first_cells_, first_vertices_;
  std::vector<Component> components_;
  std::vector<std::uint32_t> component_of_;  ///< of each cell in a tet
};

}  // namespace

ExtractedHexahedra extracted_hexahedra(const MapUnknowns& unknowns, const MapCoordinates& map) {
  const ExactMap exact(unknowns, map);
  return Extraction(exact).result();
}

}  // namespace crossgrain
