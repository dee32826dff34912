// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "crossgrain/constraints.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/samples.hpp"
#include "crossgrain/spectrum.hpp"
#include "crossgrain/writing.hpp"
#include "fuzz/input_folder.hpp"
#include "fuzz/mesh_promises.hpp"
#include "fuzz/reader_checks.hpp"

namespace crossgrain {

bool check_points(std::string_view bytes) {
  const auto path = as_file("input.txt", bytes);
  std::vector<Vector3> points;
  if (!succeeds([&] { points = read_points(path); })) return false;
  require(!points.empty(), "no points and no error");
  require_finite(points);
  return true;
}

bool check_normals(std::string_view bytes) {
  const auto path = as_file("input.txt", bytes);
  std::vector<WeightedNormal> normals;
  if (!succeeds([&] { normals = read_normals(path); })) return false;
  require(!normals.empty(), "no normals and no error");
  for (const auto& [normal, weight] : normals) {
    require_finite({normal});
    require(weight > 0 && std::isfinite(weight), "a weight that is not positive");
  }
  for (const Degree degree : {Degree::kThree, Degree::kFour})
    succeeds([&] { spectrum_json(spectrum_of_normals(normals, degree)); });
  return true;
}

bool check_constraints(std::string_view bytes) {
  const auto path = as_file("input.json", bytes);
  Constraints constraints;
  if (!succeeds([&] { constraints = read_constraints(path); })) return false;
  require(!constraints.empty(), "no constraints and no error");
  require(succeeds([&] { check_constraints(constraints); }), "constraints that a solve refuses");
  return true;
}

}  // namespace crossgrain
