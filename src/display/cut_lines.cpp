// SPDX-License-Identifier: Apache-2.0
#include "display/cut_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <unordered_map>

#include "base/lists.hpp"

namespace crossgrain {
namespace {

/// Reach of a piece's frame, as a multiple of its size: curves turn smoothly from piece to piece.
constexpr double kReach = 1.5;

/// Cosine of the angle within which two curves run along the same axis.
constexpr double kSameWay = 0.7071;

/// Largest number of steps of a curve each way.
constexpr int kMostSteps = 10000;

/// Length along a curve, in spacings, within which it is not another curve to itself.
constexpr double kOwnLag = 1.2;

/// Distance of a seed from curves along the same axis, in spacings: less than one, since that is where seeds
/// are laid beside a curve.
constexpr double kSeedShare = 0.98;

/// Smallest length of a curve, in spacings, unless it runs from boundary to boundary.
constexpr double kShortest = 1;

/// Curves end where another along the same axis is nearer than this share of the spacing.
constexpr double kEndShare = 0.55;

/// Curves follow the two axes that run along the plane, not the third. One ends where the component of its
/// axis normal to the plane exceeds that of both others by this; axes closer than that are equally steep.
constexpr double kNormalMargin = 0.1;

/// Smallest distance of a curve's seed from the outline, across the curve, as a share of the spacing; in
/// walls of less than twice that the seed is in the middle.
constexpr double kOutlineShare = 0.25;

/// Thickness of walls, as a share of the spacing, below which there is no curve along them.
constexpr double kWallShare = 0.12;

/// Length of a step as a share of the spacing.
constexpr double kStepShare = 0.2;

/// An axis of the field at a point, and its name there.
struct Heading {
  Vector3 axis;      ///< unit, in space
  Vector3 in_plane;  ///< unit, projected to the plane
  double excess;     ///< normal component of the axis less the larger one of the other two
  std::uint8_t name;
};

class CutField {
 public:
  CutField(const CutMesh& mesh, std::span<const AxisNames> names) : mesh_(mesh), names_(names) {
    around_ = {mesh.pieces().size(), [&](const auto& add) {
                 for (const CutMesh::Side& side : mesh.sides()) add(side.a, side.b), add(side.b, side.a);
               }};
    for (const Quaternion& frame : mesh.frames()) axes_.push_back(axes_of(frame));
  }

  /// The axis at a point of a piece that is nearest to a direction, from the frames around.
  Heading towards(std::uint32_t piece, const Vector3& point, const Vector3& direction) const {
    const std::size_t own = nearest_axis(piece, direction);
    const Vector3 lead = turned(axes_[piece][own], direction);
    Vector3 sum = weight(piece, point) * lead;
    for (const std::uint32_t other : around_[piece])
      sum += weight(other, point) * turned(axes_[other][nearest_axis(other, lead)], lead);
    const double length = norm(sum);
    const Vector3 axis = length > 0 ? 1 / length * sum : lead;
    Vector3 flat = axis;
    flat[mesh_.plane().axis] = 0;
    const double share = norm(flat);
    return {axis, share > 0 ? 1 / share * flat : flat, excess(piece, own), names_[piece][own]};
  }

  const std::array<Vector3, 3>& axes(std::uint32_t piece) const { return axes_[piece]; }

  /// The axis of a piece along which no curve begins: the steepest one. Of two that are about equally steep
  /// that with the later name, so that curves over a whole part have the same.
  std::size_t across(std::uint32_t piece) const {
    std::size_t most = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (steepness(piece, k) > steepness(piece, most)) most = k;
    std::size_t across = most;
    for (std::size_t k = 0; k < 3; ++k)
      if (steepness(piece, k) > steepness(piece, most) - kNormalMargin &&
          names_[piece][k] > names_[piece][across])
        across = k;
    return across;
  }

 private:
  std::size_t nearest_axis(std::uint32_t piece, const Vector3& direction) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (std::abs(dot(axes_[piece][k], direction)) > std::abs(dot(axes_[piece][best], direction))) best = k;
    return best;
  }

  double steepness(std::uint32_t piece, std::size_t k) const {
    return std::abs(axes_[piece][k][mesh_.plane().axis]);
  }

  double excess(std::uint32_t piece, std::size_t own) const {
    return steepness(piece, own) - std::max(steepness(piece, (own + 1) % 3), steepness(piece, (own + 2) % 3));
  }

  static Vector3 turned(const Vector3& axis, const Vector3& direction) {
    return dot(axis, direction) < 0 ? -axis : axis;
  }

  double weight(std::uint32_t piece, const Vector3& point) const {
    const CutMesh::Piece& p = mesh_.pieces()[piece];
    const Vector3 off = point - p.middle;
    const double far = dot(off, off) / (kReach * kReach * p.size * p.size);
    return far < 1 ? (1 - far) * (1 - far) : 0;
  }

  const CutMesh& mesh_;
  std::span<const AxisNames> names_;
  Lists<std::uint32_t> around_;
  std::vector<std::array<Vector3, 3>> axes_;
};

/// Points of curves, to find what runs along the same axis nearby.
class DrawnPoints {
 public:
  DrawnPoints(const CutPlane& plane, double spacing) : plane_(plane), spacing_(spacing) {}

  bool has_room(const Vector3& point, const Vector3& way, double distance) const {
    const auto [i, j] = place(point);
    for (std::int64_t di = -1; di <= 1; ++di) {
      for (std::int64_t dj = -1; dj <= 1; ++dj) {
        const auto bin = bins_.find(key(i + di, j + dj));
        if (bin == bins_.end()) continue;
        for (const auto& [other, along] : bin->second) {
          const Vector3 off = other - point;
          if (dot(off, off) < distance * distance && std::abs(dot(along, way)) > kSameWay) return false;
        }
      }
    }
    return true;
  }

  void add(const Vector3& point, const Vector3& way) {
    const auto [i, j] = place(point);
    bins_[key(i, j)].push_back({point, way});
  }

 private:
  std::array<std::int64_t, 2> place(const Vector3& point) const {
    return {static_cast<std::int64_t>(std::floor(point[plane_.across()] / spacing_)),
            static_cast<std::int64_t>(std::floor(point[plane_.up()] / spacing_))};
  }
  static std::uint64_t key(std::int64_t i, std::int64_t j) {
    return static_cast<std::uint64_t>(i) << 32 ^ (static_cast<std::uint64_t>(j) & 0xffffffff);
  }

  CutPlane plane_;
  double spacing_;
  std::unordered_map<std::uint64_t, std::vector<std::array<Vector3, 2>>> bins_;
};

class CutTracer {
 public:
  CutTracer(const CutMesh& mesh, std::span<const AxisNames> names, double spacing,
            const std::function<bool(const Vector3&)>& is_inside)
      : mesh_(mesh),
        field_(mesh, names),
        spacing_(spacing),
        is_inside_(is_inside),
        drawn_(mesh.plane(), spacing) {}

  std::vector<CutLine> lines() {
    for (const std::uint32_t piece : by_size()) {
      try_from(mesh_.pieces()[piece].middle);
      while (!seeds_.empty()) {
        const Vector3 seed = seeds_.front();
        seeds_.pop_front();
        try_from(seed);
      }
    }
    return std::move(lines_);
  }

 private:
  /// The pieces, largest first: they are in the thick of the part.
  std::vector<std::uint32_t> by_size() const {
    std::vector<std::uint32_t> order(mesh_.pieces().size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return mesh_.pieces()[a].size > mesh_.pieces()[b].size;
    });
    return order;
  }

  void try_from(const Vector3& seed) {
    const auto piece = mesh_.piece_at(seed);
    if (!piece || !is_inside_(seed)) return;
    const std::size_t across_plane = field_.across(*piece);
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == across_plane) continue;
      const Heading heading = field_.towards(*piece, seed, field_.axes(*piece)[k]);
      const auto place = off_outline(seed, heading.in_plane);
      if (place && drawn_.has_room(*place, heading.in_plane, kSeedShare * spacing_)) trace(*place, heading);
    }
  }

  /// The seed, or the middle of the thin wall that it is in; none if a curve would run next to the outline.
  std::optional<Vector3> off_outline(const Vector3& seed, const Vector3& way) const {
    const double least = kOutlineShare * spacing_;
    const Vector3 aside = across(way);
    if (has(seed + least * aside) && has(seed - least * aside)) return seed;
    const Vector3 left = seed + 2 * least * aside, right = seed - 2 * least * aside;
    if (has(left) || has(right)) return std::nullopt;
    const Vector3 from = last_inside(seed, left), to = last_inside(seed, right);
    const double wall = norm(to - from);
    if (wall < kWallShare * spacing_ || wall > 2 * least) return std::nullopt;
    return 0.5 * (from + to);
  }

  bool has(const Vector3& point) const { return mesh_.piece_at(point) && is_inside_(point); }

  /// The direction in the plane at right angles to another.
  Vector3 across(const Vector3& way) const {
    Vector3 normal{};
    normal[mesh_.plane().axis] = 1;
    return cross(normal, way);
  }

  struct Way {
    std::vector<Vector3> points;
    std::vector<Vector3> ways;
    std::vector<std::uint8_t> names;
    bool at_boundary = false;
  };

  /// Half a curve. Steps by the midpoint rule. Ends next to earlier curves, and to the other half or itself
  /// where it comes round.
  Way half(const Vector3& seed, Vector3 direction, const Way& other_half) const {
    const double step = kStepShare * spacing_;
    const double least = kEndShare * spacing_;
    const auto lag = static_cast<std::size_t>(std::ceil(kOwnLag / kStepShare));
    DrawnPoints own(mesh_.plane(), spacing_);
    for (std::size_t k = lag; k < other_half.points.size(); ++k)
      own.add(other_half.points[k], other_half.ways[k]);
    Way way;
    Vector3 point = seed;
    for (int k = 0; k < kMostSteps; ++k) {
      const auto piece = mesh_.piece_at(point);
      if (!piece) break;
      const Heading here = field_.towards(*piece, point, direction);
      if (here.excess > kNormalMargin) return way;
      const Vector3 middle = point + 0.5 * step * here.in_plane;
      const auto ahead = mesh_.piece_at(middle);
      const Heading there = ahead ? field_.towards(*ahead, middle, here.axis) : here;
      if (there.excess > kNormalMargin) return way;
      const Vector3 next = point + step * there.in_plane;
      if (!has(next)) {
        way.points.push_back(last_inside(point, next));
        way.ways.push_back(there.in_plane);
        way.names.push_back(here.name);
        way.at_boundary = true;
        return way;
      }
      if (!drawn_.has_room(next, there.in_plane, least) || !own.has_room(next, there.in_plane, least))
        return way;
      way.points.push_back(next);
      way.ways.push_back(there.in_plane);
      way.names.push_back(here.name);
      if (way.points.size() > lag) {
        const std::size_t passed = way.points.size() - 1 - lag;
        own.add(way.points[passed], way.ways[passed]);
      }
      point = next;
      direction = there.axis;
    }
    way.at_boundary = true;
    return way;
  }

  Vector3 last_inside(Vector3 inside, Vector3 outside) const {
    constexpr int kHalvings = 12;
    for (int k = 0; k < kHalvings; ++k) {
      const Vector3 middle = 0.5 * (inside + outside);
      (has(middle) ? inside : outside) = middle;
    }
    return inside;
  }

  void trace(const Vector3& seed, const Heading& heading) {
    const Way back = half(seed, -heading.axis, {});
    const Way forth = half(seed, heading.axis, back);
    CutLine line;
    std::vector<Vector3> ways(back.ways.rbegin(), back.ways.rend());
    line.points.assign(back.points.rbegin(), back.points.rend());
    line.names.assign(back.names.rbegin(), back.names.rend());
    line.points.push_back(seed);
    ways.push_back(heading.in_plane);
    line.points.insert(line.points.end(), forth.points.begin(), forth.points.end());
    ways.insert(ways.end(), forth.ways.begin(), forth.ways.end());
    line.names.insert(line.names.end(), forth.names.begin(), forth.names.end());
    if (line.points.size() < 2) return;
    double length = 0;
    for (std::size_t k = 1; k < line.points.size(); ++k) length += norm(line.points[k] - line.points[k - 1]);
    if (length < kShortest * spacing_ && !(back.at_boundary && forth.at_boundary)) return;
    for (std::size_t k = 0; k < line.points.size(); ++k) drawn_.add(line.points[k], ways[k]);
    add_seeds(line, ways);
    lines_.push_back(std::move(line));
  }

  /// Seeds one spacing to either side, and along the curve for the other axis.
  void add_seeds(const CutLine& line, const std::vector<Vector3>& ways) {
    const auto every = static_cast<std::size_t>(std::max(1.0, std::round(1 / kStepShare)));
    // Not at the ends: a curve from there would run along the boundary.
    for (std::size_t k = every / 2 + 1; k + 1 + every / 2 < line.points.size(); k += every) {
      const Vector3 aside = spacing_ * across(ways[k]);
      seeds_.push_back(line.points[k]);
      seeds_.push_back(line.points[k] + aside);
      seeds_.push_back(line.points[k] - aside);
    }
  }

  const CutMesh& mesh_;
  CutField field_;
  double spacing_;
  const std::function<bool(const Vector3&)>& is_inside_;
  DrawnPoints drawn_;
  std::deque<Vector3> seeds_;
  std::vector<CutLine> lines_;
};

}  // namespace

std::vector<CutLine> cut_lines(const CutMesh& mesh, std::span<const AxisNames> names, double spacing,
                               const std::function<bool(const Vector3&)>& is_inside) {
  return CutTracer(mesh, names, spacing, is_inside).lines();
}

}  // namespace crossgrain
