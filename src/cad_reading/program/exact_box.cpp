// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/exact_box.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Nodes so far below the highest of all cannot be near its place: triangles are within a fortieth of the
/// longest side (`tessellate`).
constexpr double kReach = 0.05;

/// Gains below these shares of the longest side are rounding.
constexpr double kGain = 1e-12;

constexpr int kMostSteps = 40;

/// Highest nodes of a face that are climbed from: at a seam there are two of the same height.
constexpr std::size_t kMostStarts = 4;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Box kEmpty{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

/// One of the six directions along the axes.
struct Direction {
  std::size_t axis;
  double sign;

  double height(const gp_XYZ& point) const { return sign * point.Coord(static_cast<int>(axis) + 1); }
};

/// Height as a function of one or two parameters, with its derivatives per length along the parameters. A
/// parameter of a curve that is a point there does not count.
struct Height {
  double value = 0;
  std::array<double, 2> slope{}, length{};
  std::array<double, 3> bend{};  ///< second derivatives: first, mixed, second
};

double over(double value, double length) {
  return length > 0 ? value / length : 0;
}

/// The step from a Newton iteration for a maximum, in lengths: along each axis of curvature on its own, up
/// the slope, and none where both are flat, as along a cylinder.
std::array<double, 2> step_up(const Height& at, double size) {
  const auto [a, b, c] = at.bend;
  const double angle = 0.5 * std::atan2(2 * b, a - c), cosine = std::cos(angle), sine = std::sin(angle);
  const std::array<std::array<double, 2>, 2> axes{{{cosine, sine}, {-sine, cosine}}};
  std::array<double, 2> step{};
  for (const auto& [x, y] : axes) {
    const double slope = x * at.slope[0] + y * at.slope[1];
    const double bend = x * x * a + 2 * x * y * b + y * y * c;
    if (slope == 0 || std::abs(bend) * size < kGain) continue;
    const double length = std::clamp(slope / std::abs(bend), -size, size);
    step[0] += x * length;
    step[1] += y * length;
  }
  return step;
}

/// Climbs from parameters within limits. `height_at` returns a Height.
template <class HeightAt>
std::array<double, 2> climbed(std::array<double, 2> at, const std::array<std::array<double, 2>, 2>& limits,
                              double size, const HeightAt& height_at) {
  Height here = height_at(at);
  for (int step = 0; step < kMostSteps; ++step) {
    const std::array<double, 2> way = step_up(here, size);
    if (way[0] == 0 && way[1] == 0) break;
    double share = 1;
    Height there;
    std::array<double, 2> to{};
    for (int halving = 0; halving < kMostSteps; ++halving, share *= 0.5) {
      for (std::size_t k = 0; k < 2; ++k)
        to[k] = std::clamp(at[k] + share * over(way[k], here.length[k]), limits[k][0], limits[k][1]);
      there = height_at(to);
      if (there.value > here.value) break;
    }
    if (!(there.value > here.value)) break;
    const double gain = there.value - here.value;
    at = to;
    here = there;
    if (gain < 0.01 * kGain * size) break;
  }
  return at;
}

class BoxOfFaces {
 public:
  explicit BoxOfFaces(const Bodies& bodies) : bodies_(bodies) {
    for (int number = 1; number <= bodies.faces.Extent(); ++number) {
      of_nodes_.push_back(box_of_nodes(face(number)));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box_.low[axis] = std::min(box_.low[axis], of_nodes_.back().low[axis]);
        box_.high[axis] = std::max(box_.high[axis], of_nodes_.back().high[axis]);
      }
    }
    size_ = longest_side(box_);
  }

  /// Adds what the true faces and edges have beyond their nodes.
  void add_true_faces() {
    for (int number = 1; number <= bodies_.faces.Extent(); ++number) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
          const Direction up{axis, sign};
          if (!is_near_top(top_of(of_nodes_[static_cast<std::size_t>(number) - 1], up), up)) continue;
          add_edges(face(number), up);
          add_inside(face(number), up);
        }
      }
    }
  }

  const Box& box() const { return box_; }

 private:
  TopoDS_Face face(int number) const { return TopoDS::Face(bodies_.faces(number).Oriented(TopAbs_FORWARD)); }

  static double top_of(const Box& box, const Direction& up) {
    return up.sign > 0 ? box.high[up.axis] : -box.low[up.axis];
  }

  double highest(const Direction& up) const { return top_of(box_, up); }

  bool is_near_top(double height, const Direction& up) const { return height > highest(up) - kReach * size_; }

  void raise(double height, const Direction& up) {
    if (!(height > highest(up) + kGain * size_) || !std::isfinite(height)) return;
    (up.sign > 0 ? box_.high : box_.low)[up.axis] = up.sign * height;
  }

  static Box box_of_nodes(const TopoDS_Face& face) {
    Box box = kEmpty;
    TopLoc_Location location;
    const auto mesh = BRep_Tool::Triangulation(face, location);
    for (int node = 1; !mesh.IsNull() && node <= mesh->NbNodes(); ++node) {
      const gp_XYZ point = mesh->Node(node).Transformed(location).XYZ();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::min(box.low[axis], point.Coord(static_cast<int>(axis) + 1));
        box.high[axis] = std::max(box.high[axis], point.Coord(static_cast<int>(axis) + 1));
      }
    }
    return box;
  }

  void add_edges(const TopoDS_Face& face, const Direction& up) {
    TopLoc_Location location;
    const auto mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull()) return;
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
      const auto polygon = BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
      if (polygon.IsNull() || !polygon->HasParameters() || BRep_Tool::Degenerated(edge)) continue;
      std::vector<double> heights;
      for (int k = 1; k <= polygon->NbNodes(); ++k)
        heights.push_back(up.height(mesh->Node(polygon->Node(k)).Transformed(location).XYZ()));
      if (const auto starts = tops_of(heights, up); !starts.empty())
        add_edge(BRepAdaptor_Curve(edge), *polygon, starts, up);
    }
  }

  /// Nodes of a polyline that are higher than the one before and no lower than the next, where an edge may be
  /// highest; from 0.
  std::vector<int> tops_of(const std::vector<double>& heights, const Direction& up) const {
    std::vector<int> tops;
    for (std::size_t k = 0; k < heights.size(); ++k) {
      const double after = heights[std::min(k + 1, heights.size() - 1)];
      if (is_near_top(heights[k], up) && heights[k] >= after && (k == 0 || heights[k] > heights[k - 1]))
        tops.push_back(static_cast<int>(k));
    }
    return tops;
  }

  void add_edge(const BRepAdaptor_Curve& curve, const Poly_PolygonOnTriangulation& polygon,
                const std::vector<int>& starts, const Direction& up) {
    if (curve.GetType() == GeomAbs_Line) return;
    const auto height_at = [&](const std::array<double, 2>& at) {
      gp_Pnt point;
      gp_Vec first, second;
      curve.D2(at[0], point, first, second);
      const double length = first.Magnitude();
      return Height{up.height(point.XYZ()),
                    {over(up.height(first.XYZ()), length), 0},
                    {length, 0},
                    {over(up.height(second.XYZ()), length * length), 0, 0}};
    };
    for (const int k : starts) {
      const double from = polygon.Parameter(k + 1), left = polygon.Parameter(std::max(k, 1)),
                   right = polygon.Parameter(std::min(k + 2, polygon.NbNodes()));
      const std::array<std::array<double, 2>, 2> limits{
          {{std::min(left, right), std::max(left, right)}, {0, 0}}};
      raise(height_at(climbed({from, 0}, limits, size_, height_at)).value, up);
    }
  }

  /// Nodes of a triangulation that are as high as its highest one.
  std::vector<gp_Pnt2d> starts_in(const Poly_Triangulation& mesh, const TopLoc_Location& location,
                                  const Direction& up) const {
    double top = -std::numeric_limits<double>::infinity();
    std::vector<double> heights;
    for (int node = 1; node <= mesh.NbNodes(); ++node) {
      heights.push_back(up.height(mesh.Node(node).Transformed(location).XYZ()));
      top = std::max(top, heights.back());
    }
    std::vector<gp_Pnt2d> starts;
    if (!is_near_top(top, up)) return starts;
    for (int node = 1; node <= mesh.NbNodes() && starts.size() < kMostStarts; ++node)
      if (heights[static_cast<std::size_t>(node) - 1] > top - kGain * size_)
        starts.push_back(mesh.UVNode(node));
    return starts;
  }

  void add_inside(const TopoDS_Face& face, const Direction& up) {
    TopLoc_Location location;
    const auto mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull() || !mesh->HasUVNodes()) return;
    // The bounds of a face cost more than all else, and what is highest on them is found along its edges.
    const bool within_bounds = false;
    const BRepAdaptor_Surface surface(face, within_bounds);
    if (surface.GetType() == GeomAbs_Plane) return;
    const auto height_at = [&](const std::array<double, 2>& at) {
      gp_Pnt point;
      gp_Vec u, v, uu, vv, uv;
      surface.D2(at[0], at[1], point, u, v, uu, vv, uv);
      const double of_u = u.Magnitude(), of_v = v.Magnitude();
      return Height{up.height(point.XYZ()),
                    {over(up.height(u.XYZ()), of_u), over(up.height(v.XYZ()), of_v)},
                    {of_u, of_v},
                    {over(up.height(uu.XYZ()), of_u * of_u), over(up.height(uv.XYZ()), of_u * of_v),
                     over(up.height(vv.XYZ()), of_v * of_v)}};
    };
    for (const gp_Pnt2d& start : starts_in(*mesh, location, up)) {
      const auto at = climbed({start.X(), start.Y()}, limits_of(surface), size_, height_at);
      const double height = height_at(at).value;
      if (!(height > highest(up) + kGain * size_)) continue;
      // What is on the bounds is on an edge, and known better from there.
      const TopAbs_State state =
          BRepTopAdaptor_FClass2d(face, Precision::PConfusion()).Perform({at[0], at[1]});
      if (state == TopAbs_IN) raise(height, up);
    }
  }

  /// Of periodic parameters none.
  static std::array<std::array<double, 2>, 2> limits_of(const BRepAdaptor_Surface& surface) {
    std::array<std::array<double, 2>, 2> limits{{{-kInfinity, kInfinity}, {-kInfinity, kInfinity}}};
    if (!surface.IsUPeriodic()) limits[0] = {surface.FirstUParameter(), surface.LastUParameter()};
    if (!surface.IsVPeriodic()) limits[1] = {surface.FirstVParameter(), surface.LastVParameter()};
    return limits;
  }

  const Bodies& bodies_;
  Box box_ = kEmpty;
  std::vector<Box> of_nodes_;  ///< of each face
  double size_ = 0;
};

}  // namespace

Box exact_box(const Bodies& bodies) {
  BoxOfFaces faces(bodies);
  try {
    faces.add_true_faces();
  } catch (const Standard_Failure&) {
    // A face or edge that cannot be evaluated: what is known so far is on the faces.
  }
  return faces.box();
}

}  // namespace crossgrain
