// SPDX-License-Identifier: Apache-2.0
// The sweep that chose FadingCreases (docs/notes/solver.md).
//
//   fading_creases MODEL[=TRUTH]...
//
// Compares the creases found on triangles alone with the true ones: those that the model states as a CAD
// file, or TRUTH, a CAD file or a finer mesh of the same part. Prints one line per model and one column per
// rule: curves, of these such as fade out, and in per cent of length how much of the true creases is found,
// and how much of what is found is true. After them come generated surfaces without creases, and ridges that
// fade out.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/tet_domain.hpp"
#include "support/curved_shapes.hpp"
#include "surface/creases.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"

namespace {

using namespace crossgrain;

/// A place of a curve counts as on another one if it is within this, in longest sides of the model.
constexpr double kTolerance = 0.005;

struct Rule {
  double sure_deg, least_radii;
};
constexpr std::array kRules{Rule{80, 0},  Rule{60, 10}, Rule{60, 50}, Rule{70, 50},
                            Rule{70, 80}, Rule{80, 50}, Rule{80, 80}, Rule{180, 1e9}};

struct Step {
  Vector3 middle;
  double length;
};

std::vector<Step> steps_of(const std::vector<CreaseCurve>& curves, double step) {
  std::vector<Step> steps;
  for (const CreaseCurve& curve : curves) {
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
      const Vector3 along = curve.points[k + 1] - curve.points[k];
      const int parts = std::max(1, static_cast<int>(std::ceil(norm(along) / step)));
      for (int p = 0; p < parts; ++p)
        steps.push_back({curve.points[k] + (p + 0.5) / parts * along, norm(along) / parts});
    }
  }
  return steps;
}

/// Share of the length of `of` that lies within the tolerance of `on`, in per cent.
double share_on(const std::vector<Step>& of, const std::vector<Step>& on, double tolerance) {
  double sum = 0, near = 0;
  for (const Step& step : of) {
    sum += step.length;
    near += std::any_of(on.begin(), on.end(),
                        [&](const Step& other) { return norm(other.middle - step.middle) < tolerance; })
                ? step.length
                : 0;
  }
  return sum > 0 ? 100 * near / sum : 100;
}

/// Ends of curves where no other curve is.
std::size_t fading_curves(const std::vector<CreaseCurve>& curves) {
  std::map<Vector3, int> ends;
  for (const CreaseCurve& curve : curves) ++ends[curve.points.front()], ++ends[curve.points.back()];
  return static_cast<std::size_t>(std::count_if(curves.begin(), curves.end(), [&](const CreaseCurve& curve) {
    return ends[curve.points.front()] == 1 || ends[curve.points.back()] == 1;
  }));
}

/// The model without the creases that a tet mesh tags.
TriangleMesh read_model(const std::string& file) {
  if (!is_tet_file(file)) return read_surface(file);
  TriangleMesh boundary = TetDomain(read_tets(file)).boundary();
  boundary.creases.clear();
  return boundary;
}

Surface welded(TriangleMesh mesh) {
  return prepare_surface(CheckedMesh::derived(weld(*CheckedMesh(std::move(mesh)))));
}

void print_row(const std::string& name, TriangleMesh mesh, const std::vector<CreaseCurve>* truth) {
  mesh.creases.clear();
  const Surface surface = welded(std::move(mesh));
  const Box& box = surface.box;
  const double size =
      std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
  const double tolerance = kTolerance * size;
  std::printf("%-28.28s", name.c_str());
  for (const auto& [sure_deg, least_radii] : kRules) {
    CreaseAngles angles;
    angles.fading = {sure_deg, least_radii};
    const std::vector<CreaseCurve> curves = sharp_curves(surface, angles);
    std::printf(" |%4zu %3zu", curves.size(), fading_curves(curves));
    if (truth == nullptr) continue;
    const auto found = steps_of(curves, tolerance / 2), true_ones = steps_of(*truth, tolerance / 2);
    std::printf(" %5.1f %5.1f", share_on(true_ones, found, tolerance), share_on(found, true_ones, tolerance));
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// Where the angle of a ridge falls below CreaseAngles::least_deg.
double end_of_ridge(double angle_deg) {
  const auto slope = [](double deg) { return std::tan(deg / 2 * std::numbers::pi / 180); };
  return 1.5 * (1 - slope(CreaseAngles{}.least_deg) / slope(angle_deg));
}

void print_file(const std::string& argument) {
  const std::size_t split = argument.find('=');
  const std::string file = argument.substr(0, split);
  TriangleMesh mesh = read_model(file);
  std::vector<CreaseCurve> truth = mesh.creases;
  if (split != std::string::npos) {
    TriangleMesh true_mesh = read_model(argument.substr(split + 1));
    truth = true_mesh.creases;
    if (truth.empty()) truth = sharp_curves(welded(std::move(true_mesh)), {});
  }
  print_row(file.substr(file.find_last_of('/') + 1), std::move(mesh), truth.empty() ? nullptr : &truth);
}

}  // namespace

int main(int argc, char** argv) {
  std::printf("%-28s", "sure_deg, least_radii");
  for (const auto& [sure_deg, least_radii] : kRules) std::printf(" | %g, %g", sure_deg, least_radii);
  std::printf("\n");
  for (int k = 1; k < argc; ++k) print_file(argv[k]);
  for (const int subdivisions : {3, 4}) {
    for (const auto& [knobs, noise] :
         {std::array{0.9, 0.0}, {0.5, 0.0}, {0.5, 0.01}, {0.0, 0.02}, {0.0, 0.03}}) {
      char name[64];
      std::snprintf(name, sizeof name, "knobs %g, noise %g, %d", knobs, noise, subdivisions);
      print_row(name, make_knobbly_sphere(subdivisions, knobs, noise, 1), nullptr);
    }
  }
  for (const int angle_deg : {60, 90}) {
    for (const int cells : {10, 40, 160}) {
      const std::vector<CreaseCurve> truth{{{{0, 0, 0}, {end_of_ridge(angle_deg), 0, 0}}, {}}};
      print_row("ridge " + std::to_string(angle_deg) + ", " + std::to_string(cells),
                make_fading_ridge(cells, angle_deg), &truth);
    }
  }
}
