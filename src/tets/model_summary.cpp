// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/model_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "base/names.hpp"
#include "base/vector3.hpp"
#include "crossgrain/message.hpp"

namespace crossgrain {
namespace {

/// Coordinates closer to 0 than this, relative to the longest side, are rounding errors of CAD programs.
constexpr double kNoise = 1e-9;

template <class Element>
Box box_of(const std::vector<Vector3>& vertices, const std::vector<Element>& elements) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (const Element& element : elements) {
    for (const std::uint32_t v : element) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::min(box.low[axis], vertices[v][axis]);
        box.high[axis] = std::max(box.high[axis], vertices[v][axis]);
      }
    }
  }
  return box;
}

std::size_t distinct(const std::vector<std::int32_t>& numbers) {
  return std::set<std::int32_t>(numbers.begin(), numbers.end()).size();
}

std::string parts_of(const ModelSummary& model) {
  if (model.tets > 0)
    return counted(model.tets, "tet") + (model.solids > 0 ? ", " + counted(model.solids, "region") : "");
  return (model.faces > 0 ? counted(model.faces, "face") : counted(model.triangles, "triangle")) +
         (model.solids > 0 ? ", " + counted(model.solids, "solid") : "");
}

std::string unit_of(const ModelSummary& model) {
  if (model.unit.empty()) return " (no unit)";
  const bool is_converted = !model.file_unit.empty() && model.file_unit != model.unit;
  return " " + model.unit + (is_converted ? " (in the file: " + model.file_unit + ")" : "");
}

}  // namespace

const char* name_of(LengthUnit unit) {
  // Those of files as their reader names them.
  constexpr std::array kNames{"none", "um", "mm", "cm", "m", "inch", "foot"};
  return name_among<LengthUnit::kFoot>(kNames, unit);
}

ModelSummary summary_of(const TriangleMesh& mesh) {
  const bool has_exact = longest_side(mesh.exact_box) > 0;
  ModelSummary model{has_exact ? mesh.exact_box : box_of(mesh.vertices, mesh.triangles), mesh.unit,
                     mesh.file_unit};
  model.triangles = mesh.triangles.size();
  model.faces = distinct(mesh.faces);
  model.solids = distinct(mesh.solids);
  return model;
}

ModelSummary summary_of(const TetMesh& mesh) {
  ModelSummary model{box_of(mesh.vertices, mesh.tets), mesh.unit, mesh.file_unit};
  model.tets = mesh.tets.size();
  model.solids = distinct(mesh.regions);
  return model;
}

std::string sentence_of(const ModelSummary& model) {
  const auto& [low, high] = model.bounding_box;
  const double noise = kNoise * longest_side(model.bounding_box);
  const auto shown = [noise](double number) { return std::abs(number) <= noise ? 0.0 : number; };
  return fmt::format("{:.5g} x {:.5g} x {:.5g}{} from {:.5g} {:.5g} {:.5g}; {}", shown(high[0] - low[0]),
                     shown(high[1] - low[1]), shown(high[2] - low[2]), unit_of(model), shown(low[0]),
                     shown(low[1]), shown(low[2]), parts_of(model));
}

}  // namespace crossgrain
