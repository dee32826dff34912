// SPDX-License-Identifier: Apache-2.0
#include "display/cut_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "grid/leaf_finder.hpp"

namespace crossgrain {
namespace {

/// Number of squares of the raster per piece.
constexpr double kBinsPerPiece = 2;

/// Distance from its sides within which a point belongs to a piece, as a share of the piece's size: rounding
/// leaves no gap between two.
constexpr double kOnSide = 1e-9;

/// Rounds in which points of a seam move to the middle of their neighbours: steps of cells become straight.
constexpr int kSeamRounds = 30;

/// Distance below which ends of sides are one point, as a share of the sides' mean length.
constexpr double kSamePoint = 1e-3;

/// Segments joined into polylines, each from an end or a branch to the next.
class Joined {
 public:
  Joined(std::span<const CutMesh::Side> sides, double distance) : distance_(distance) {
    for (const CutMesh::Side& side : sides) {
      const std::uint32_t a = node(side.from), b = node(side.to);
      if (a == b) continue;
      around_[a].push_back(b);
      around_[b].push_back(a);
    }
  }

  std::vector<std::vector<Vector3>> lines() {
    std::vector<std::vector<Vector3>> lines;
    for (const bool from_ends : {true, false})
      for (std::uint32_t i = 0; i < points_.size(); ++i)
        while (!around_[i].empty() && (!from_ends || degree(i) != 2)) lines.push_back(line_from(i));
    return lines;
  }

 private:
  std::uint32_t node(const Vector3& point) {
    std::array<std::int64_t, 3> key{};
    for (std::size_t k = 0; k < 3; ++k) key[k] = std::llround(point[k] / distance_);
    const auto [at, is_new] = nodes_.try_emplace(key, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(point), around_.emplace_back();
    return at->second;
  }

  /// Number of segments at a point before any was taken.
  std::size_t degree(std::uint32_t i) {
    if (degrees_.empty())
      for (const auto& others : around_) degrees_.push_back(others.size());
    return degrees_[i];
  }

  std::vector<Vector3> line_from(std::uint32_t i) {
    const std::uint32_t first = i;
    std::vector<Vector3> line{points_[i]};
    do {
      const std::uint32_t next = around_[i].back();
      around_[i].pop_back();
      std::erase(around_[next], i);
      line.push_back(points_[next]);
      i = next;
    } while (i != first && degree(i) == 2 && !around_[i].empty());
    return line;
  }

  double distance_;
  std::map<std::array<std::int64_t, 3>, std::uint32_t> nodes_;
  std::vector<Vector3> points_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<std::size_t> degrees_;
};

/// Where the segment from a to b meets the plane, whose sides they are on.
Vector3 meeting(const Vector3& a, const Vector3& b, const CutPlane& plane) {
  const double from = a[plane.axis] - plane.position, to = b[plane.axis] - plane.position;
  Vector3 point = a + from / (from - to) * (b - a);
  point[plane.axis] = plane.position;
  return point;
}

double area_of(std::span<const Vector3> corners, const CutPlane& plane) {
  const std::size_t u = plane.across(), v = plane.up();
  double twice = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    twice += a[u] * b[v] - a[v] * b[u];
  }
  return 0.5 * std::abs(twice);
}

/// Moves the inner points of a line to the middle of their neighbours, again and again.
void smooth(std::vector<Vector3>& line) {
  for (int round = 0; round < kSeamRounds; ++round) {
    const std::vector<Vector3> before = line;
    for (std::size_t k = 1; k + 1 < line.size(); ++k)
      line[k] = 0.5 * before[k] + 0.25 * (before[k - 1] + before[k + 1]);
  }
}

}  // namespace

CutMesh::CutMesh(const ShownField& field, const CutPlane& plane) : plane_(plane) {
  if (field.is_on_tets())
    cut_tets(field.tets().solid, field.tet_field().tet_frames);
  else
    cut_leaves(field.grid());
  sort_into_bins();
}

void CutMesh::add_piece(std::uint32_t element, const Quaternion& frame, std::span<const Vector3> corners) {
  Piece piece{element,
              static_cast<std::uint32_t>(corners_.size()),
              static_cast<std::uint32_t>(corners.size()),
              {0, 0, 0},
              std::sqrt(area_of(corners, plane_))};
  for (const Vector3& corner : corners) piece.middle += 1.0 / static_cast<double>(corners.size()) * corner;
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  pieces_.push_back(piece);
  frames_.push_back(frame);
}

void CutMesh::cut_leaves(const FieldData& field) {
  const Octree& tree = field.tree;
  const std::size_t u = plane_.across(), v = plane_.up();
  std::vector<std::uint32_t> piece_of(tree.size(), kNoCell);
  std::vector<Box> boxes;
  for (CellIndex i = 0; i < tree.size(); ++i) {
    const Box box = tree.root().box(tree[i]);
    if (!(box.low[plane_.axis] < plane_.position && plane_.position <= box.high[plane_.axis])) continue;
    std::array<Vector3, 4> corners;
    for (Vector3& corner : corners) corner[plane_.axis] = plane_.position;
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k][u] = k == 1 || k == 2 ? box.high[u] : box.low[u];
      corners[k][v] = k >= 2 ? box.high[v] : box.low[v];
    }
    piece_of[i] = static_cast<std::uint32_t>(pieces_.size());
    boxes.push_back(box);
    const StoredQuaternion& q = field.frames[i];
    add_piece(i, normalised(Quaternion{q.w, q.x, q.y, q.z}), corners);
  }

  const LeafFinder finder(tree);
  for (std::uint32_t piece = 0; piece < pieces_.size(); ++piece) {
    const CellIndex leaf = pieces_[piece].element;
    for (int face = 0; face < 6; ++face) {
      const auto along = static_cast<std::size_t>(face_axis(face));
      if (along == plane_.axis || !(field.open_faces[leaf] >> face & 1)) continue;
      const CellIndex other = finder.neighbour(leaf, face);
      if (other == kNoCell || piece_of[other] == kNoCell) continue;
      // Between leaves of the same size each side is met twice.
      if (tree[other].depth() == tree[leaf].depth() && other < leaf) continue;
      const Box& box = boxes[piece];
      const Vector3& beyond = pieces_[piece_of[other]].middle;
      const bool is_high = beyond[along] > pieces_[piece].middle[along];
      Side side{piece, piece_of[other], box.low, box.high};
      for (Vector3* end : {&side.from, &side.to}) {
        (*end)[plane_.axis] = plane_.position;
        (*end)[along] = is_high ? box.high[along] : box.low[along];
      }
      sides_.push_back(side);
    }
  }
}

void CutMesh::cut_tets(const TetSolid& solid, std::span<const Quaternion> frames) {
  const std::vector<Vector3>& points = solid.mesh.vertices;
  std::vector<std::uint8_t> is_above(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) is_above[i] = points[i][plane_.axis] > plane_.position;
  std::vector<std::uint32_t> piece_of(solid.mesh.tets.size(), kNoTet);
  for (std::uint32_t t = 0; t < solid.mesh.tets.size(); ++t) {
    std::array<std::uint32_t, 4> above{}, below{};
    std::size_t n = 0, m = 0;
    for (const std::uint32_t vertex : solid.mesh.tets[t])
      is_above[vertex] ? above[n++] = vertex : below[m++] = vertex;
    if (n == 0 || m == 0) continue;
    // Around the polygon, one end of the crossed edge changes at a time.
    std::array<Vector3, 4> corners;
    std::size_t count = 0;
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
      corners[count++] = meeting(points[a], points[b], plane_);
    };
    if (n == 2)
      add(above[0], below[0]), add(above[0], below[1]), add(above[1], below[1]), add(above[1], below[0]);
    for (std::size_t k = 0; n == 1 && k < 3; ++k) add(above[0], below[k]);
    for (std::size_t k = 0; n == 3 && k < 3; ++k) add(above[k], below[0]);
    const std::span polygon(corners.data(), count);
    if (!(area_of(polygon, plane_) > 0)) continue;
    piece_of[t] = static_cast<std::uint32_t>(pieces_.size());
    add_piece(t, frames[t], polygon);
  }
  for (const TetSolid::InnerFace& face : solid.inner_faces) {
    if (face.tets[1] == kNoTet) continue;
    const std::uint32_t a = piece_of[face.tets[0]], b = piece_of[face.tets[1]];
    if (a == kNoTet || b == kNoTet) continue;
    std::array<Vector3, 2> ends;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = face.vertices[k], to = face.vertices[(k + 1) % 3];
      if (is_above[from] != is_above[to] && count < 2)
        ends[count++] = is_above[from] ? meeting(points[from], points[to], plane_)
                                       : meeting(points[to], points[from], plane_);
    }
    if (count == 2) sides_.push_back({a, b, ends[0], ends[1]});
  }
}

std::int64_t CutMesh::bin(double place, std::size_t side) const {
  const auto number = static_cast<std::int64_t>((place - bin_low_[side]) / bin_size_);
  return std::clamp<std::int64_t>(number, 0, bin_count_[side] - 1);
}

template <class Act>
void CutMesh::for_each_bin(const Piece& piece, const Act& act) const {
  const std::size_t u = plane_.across(), v = plane_.up();
  Box box = empty_box();
  for (const Vector3& corner : corners(piece)) include(box, corner);
  for (std::int64_t j = bin(box.low[v], 1); j <= bin(box.high[v], 1); ++j)
    for (std::int64_t i = bin(box.low[u], 0); i <= bin(box.high[u], 0); ++i)
      act(static_cast<std::size_t>(j * bin_count_[0] + i));
}

void CutMesh::sort_into_bins() {
  if (pieces_.empty()) return;
  const std::array<std::size_t, 2> in_plane{plane_.across(), plane_.up()};
  Box box = empty_box();
  for (const Vector3& corner : corners_) include(box, corner);
  double area = 1;
  for (std::size_t k = 0; k < 2; ++k) {
    bin_low_[k] = box.low[in_plane[k]];
    area *= box.high[in_plane[k]] - box.low[in_plane[k]];
  }
  bin_size_ = std::sqrt(area / (kBinsPerPiece * static_cast<double>(pieces_.size())));
  for (std::size_t k = 0; k < 2; ++k)
    bin_count_[k] = 1 + static_cast<std::int64_t>((box.high[in_plane[k]] - box.low[in_plane[k]]) / bin_size_);
  binned_ = {static_cast<std::size_t>(bin_count_[0] * bin_count_[1]), [&](const auto& add) {
               for (std::uint32_t i = 0; i < pieces_.size(); ++i)
                 for_each_bin(pieces_[i], [&](std::size_t k) { add(k, i); });
             }};
}

bool CutMesh::contains(const Piece& piece, const Vector3& point) const {
  const std::size_t u = plane_.across(), v = plane_.up();
  const auto polygon = corners(piece);
  const double least = kOnSide * piece.size * piece.size;
  bool left = false, right = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double side = (b[u] - a[u]) * (point[v] - a[v]) - (b[v] - a[v]) * (point[u] - a[u]);
    left = left || side > least;
    right = right || side < -least;
  }
  return !(left && right);
}

std::optional<std::uint32_t> CutMesh::piece_at(const Vector3& point) const {
  if (pieces_.empty()) return std::nullopt;
  const auto k =
      static_cast<std::size_t>(bin(point[plane_.up()], 1) * bin_count_[0] + bin(point[plane_.across()], 0));
  for (const std::uint32_t piece : binned_[k])
    if (contains(pieces_[piece], point)) return piece;
  return std::nullopt;
}

std::vector<FrameLink> CutMesh::links() const {
  std::vector<FrameLink> links;
  links.reserve(sides_.size());
  for (const Side& side : sides_)
    links.push_back(
        {side.a, side.b, norm(pieces_[side.a].middle - pieces_[side.b].middle), norm(side.to - side.from)});
  return links;
}

std::vector<AxisNames> CutMesh::named_axes() const {
  std::uint32_t start = 0;
  for (std::uint32_t i = 1; i < pieces_.size(); ++i)
    if (pieces_[i].size > (1 + kSamePoint) * pieces_[start].size) start = i;
  return name_axes(frames_, links(), start);
}

std::vector<std::vector<Vector3>> CutMesh::seams(std::span<const AxisNames> names) const {
  std::vector<Side> sides;
  double length = 0;
  for (const std::uint32_t k : seams_of(names, frames_, links())) {
    sides.push_back(sides_[k]);
    length += norm(sides_[k].to - sides_[k].from);
  }
  if (sides.empty()) return {};
  auto lines = Joined(sides, kSamePoint * length / static_cast<double>(sides.size())).lines();
  for (std::vector<Vector3>& line : lines) smooth(line);
  return lines;
}

}  // namespace crossgrain
