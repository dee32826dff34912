// SPDX-License-Identifier: Apache-2.0
// Chooses LineEndOptions (docs/notes/pictures.md): how far from the true end of a singular line, as a field
// on a grid four times as fine has it, the end lies that is drawn.
//
//   line_end_sweep RESOLUTION FILE...
//
// For every end of a line on the surface that has one of the same index near it in the fine field, in cells
// of the coarse field: the distance between the two ends, and the angle between the last cells of the line
// and the straight line through the same length of the fine one. The first row is for the singular edges
// themselves.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <numbers>
#include <numeric>
#include <vector>

#include "crossgrain/reading.hpp"
#include "crossgrain/solve.hpp"
#include "display/cell_sizes.hpp"
#include "display/line_ends.hpp"
#include "display/shown_field.hpp"
#include "display/solid_rays.hpp"

using namespace crossgrain;

namespace {

constexpr int kFiner = 4;

/// Largest distance of an end from that of the same line in the fine field, in cells.
constexpr double kSameLine = 8;

/// An end of a singular line, and where it is in the fine field.
struct KnownEnd {
  std::size_t model;
  LineEnd line;
  double cell_size;
  Vector3 true_place;
  std::vector<Vector3> true_points;  ///< of the fine line, from its end inwards
};

/// Length of a line at its end whose direction counts, in cells.
constexpr double kDirectionLength = 3;

/// Direction of a line over a length at its end, outwards.
Vector3 direction_of(const std::vector<Vector3>& points, double length) {
  double along = 0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const double step = norm(points[k] - points[k - 1]);
    if (along + step >= length) {
      const Vector3 place = points[k - 1] + (length - along) / step * (points[k] - points[k - 1]);
      return normalised(points.front() - place);
    }
    along += step;
  }
  return normalised(points.front() - points.back());
}

/// Calls visit(arc, points and axes from the end inwards, place) for all ends of single lines on the surface.
template <class Visit>
void for_each_end(const SingularityGraph& graph, const Visit& visit) {
  for (const SingularityGraph::Arc& arc : graph.arcs) {
    if (!arc.nodes) continue;
    for (std::size_t side = 0; side < 2; ++side) {
      const SingularityGraph::Node& node = graph.nodes[(*arc.nodes)[side]];
      if (!node.on_boundary || node.degree() > 1) continue;
      LineEnd end{arc.points, arc.axes};
      if (side == 1) {
        std::reverse(end.points.begin(), end.points.end());
        std::reverse(end.axes.begin(), end.axes.end());
      }
      visit(arc, end);
    }
  }
}

void add_known_ends(const char* file, int resolution, std::size_t model, std::deque<SolidRays>& rays,
                    std::vector<KnownEnd>& ends) {
  SolveOptions options;
  options.resolution = resolution;
  const FrameField coarse = solve(read_surface(file), options);
  options.resolution = kFiner * resolution;
  const FrameField fine = solve(read_surface(file), options);
  const ShownField shown(coarse);
  rays.emplace_back(shown.searchable());
  const CellSizes sizes(shown);
  for_each_end(coarse.singularities(), [&](const SingularityGraph::Arc& arc, const LineEnd& end) {
    const double cell = sizes.at(end.points[std::min<std::size_t>(1, end.points.size() - 1)], -1);
    double nearest = kSameLine * cell;
    std::vector<Vector3> points;
    for_each_end(fine.singularities(), [&](const SingularityGraph::Arc& other, const LineEnd& there) {
      const double distance = norm(there.points.front() - end.points.front());
      if (other.index != arc.index || distance >= nearest) return;
      nearest = distance;
      points = there.points;
    });
    if (nearest < kSameLine * cell)
      ends.push_back({model, end, cell, rays.back().nearest(points.front()).place, points});
  });
  std::fprintf(stderr, "%s: %zu ends known\n", file, ends.size());
}

void print_row(const char* name, const std::vector<KnownEnd>& ends, const std::deque<SolidRays>& rays,
               const LineEndOptions* options) {
  std::vector<double> off, turned;
  for (const KnownEnd& end : ends) {
    std::vector<Vector3> points = end.line.points;
    if (options) {
      const StraightEnd drawn = straight_end(end.line, end.cell_size, rays[end.model], *options);
      points = drawn.points;
      points.insert(points.end(), end.line.points.begin() + static_cast<std::ptrdiff_t>(drawn.next),
                    end.line.points.end());
    }
    off.push_back(norm(rays[end.model].nearest(points.front()).place - end.true_place) / end.cell_size);
    const double length = kDirectionLength * end.cell_size;
    const double cosine = dot(direction_of(points, length), direction_of(end.true_points, length));
    turned.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi);
  }
  const auto print = [](const char* what, std::vector<double>& values, double limit) {
    std::sort(values.begin(), values.end());
    const auto above = values.end() - std::upper_bound(values.begin(), values.end(), limit);
    const auto count = static_cast<double>(values.size());
    std::printf("  %s: mean %5.2f  median %5.2f  p90 %5.2f  above %g: %4.1f %%", what,
                std::accumulate(values.begin(), values.end(), 0.0) / count, values[values.size() / 2],
                values[values.size() * 9 / 10], limit, 100.0 * static_cast<double>(above) / count);
  };
  std::printf("%-23s", name);
  print("cells", off, 2);
  print("degrees", turned, 30);
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return std::fputs("usage: line_end_sweep RESOLUTION FILE...\n", stderr), 2;
  std::deque<SolidRays> rays;
  std::vector<KnownEnd> ends;
  for (int k = 2; k < argc; ++k)
    add_known_ends(argv[k], std::atoi(argv[1]), static_cast<std::size_t>(k - 2), rays, ends);
  if (ends.empty()) return std::puts("no end is known"), 0;
  print_row("edges", ends, rays, nullptr);
  const LineEndOptions usual;
  print_row("default", ends, rays, &usual);
  struct Row {
    const char* name;
    double LineEndOptions::*member;
    std::vector<double> values;
  };
  const std::vector<Row> rows{{"most_replaced", &LineEndOptions::most_replaced, {0, 1, 2, 3, 4, 6, 10}},
                              {"direction_length", &LineEndOptions::direction_length, {1, 1.5, 2, 3, 4}},
                              {"most_ahead", &LineEndOptions::most_ahead, {1, 1.5, 2, 3, 4}},
                              {"surface_layer", &LineEndOptions::surface_layer, {1, 1.75, 2.25, 3, 4}},
                              {"along_cosine", &LineEndOptions::along_cosine, {0.5, 0.6, 0.71, 0.8, 0.9}},
                              {"steep_sine", &LineEndOptions::steep_sine, {0.25, 0.35, 0.5, 0.6, 0.71}},
                              {"facing_cosine", &LineEndOptions::facing_cosine, {-1, -0.87, -0.5, 0}},
                              {"straight_cosine", &LineEndOptions::straight_cosine, {0, 0.87, 0.94, 0.97}}};
  for (const Row& row : rows) {
    for (const double value : row.values) {
      LineEndOptions options;
      options.*row.member = value;
      char name[64];
      std::snprintf(name, sizeof name, "%s = %g", row.name, value);
      print_row(name, ends, rays, &options);
    }
  }
}
