// SPDX-License-Identifier: Apache-2.0
// Reads constraints from JSON (docs/constraints.md).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>

#include "crossgrain/reading.hpp"
#include "surface/constraint_faults.hpp"
#include "text/located_json.hpp"

namespace crossgrain {
namespace {

using Value = LocatedJson::Value;
using Kind = LocatedJson::Kind;

constexpr double kConstraintsSchema = 1;

void demand(const Value& value, const std::string& fault) {
  if (!fault.empty()) value.fail(fault);
}

/// Whether a value is an array of arrays.
bool is_list(const Value& value) {
  if (!value.is(Kind::kArray)) return false;
  const std::vector<Value> values = value.values();
  return !values.empty() && values[0].is(Kind::kArray);
}

/// An array of N numbers.
template <std::size_t N>
std::array<double, N> numbers(const Value& value, const char* key) {
  const std::vector<Value> values = value.is(Kind::kArray) ? value.values() : std::vector<Value>{};
  if (values.size() != N ||
      !std::all_of(values.begin(), values.end(), [](const Value& v) { return v.is(Kind::kNumber); }))
    value.fail(fmt::format("'{}' must be {} numbers in brackets", key, N == 3 ? "three" : "six"));
  std::array<double, N> result;
  for (std::size_t k = 0; k < N; ++k) result[k] = values[k].number();
  return result;
}

Vector3 place(const Value& value, const char* key) {
  const Vector3 result = numbers<3>(value, key);
  demand(value, fault_of_place(result));
  return result;
}

Vector3 direction(const Value& value, const char* key) {
  const Vector3 result = numbers<3>(value, key);
  demand(value, fault_of_direction(result));
  return result;
}

double weight(const Value& value) {
  if (!value.is(Kind::kNumber)) value.fail("'weight' must be a positive number");
  demand(value, fault_of_weight(value.number()));
  return value.number();
}

/// An object with a fixed set of allowed keys.
class Members {
 public:
  Members(const Value& object, const char* what, std::initializer_list<const char*> keys) : object_(object) {
    if (!object.is(Kind::kObject)) object.fail(fmt::format("{} must be an object in braces", what));
    for (const Value& value : object.values()) {
      if (std::find(keys.begin(), keys.end(), value.key()) == keys.end())
        value.fail(fmt::format("{} is not a key of {}, which may have '{}'", in_quotes(value.key()), what,
                               fmt::join(keys, "', '")));
      values_.push_back(value);
    }
  }

  std::optional<Value> find(const char* key) const {
    for (const Value& value : values_)
      if (value.key() == key) return value;
    return std::nullopt;
  }

  Value at(const char* key) const {
    const std::optional<Value> value = find(key);
    if (!value) object_.fail(fmt::format("'{}' is missing", key));
    return *value;
  }

  /// Returns the objects of an optional list.
  std::vector<Value> list(const char* key) const {
    const std::optional<Value> value = find(key);
    if (!value) return {};
    if (!value->is(Kind::kArray)) value->fail(fmt::format("'{}' must be a list in brackets", key));
    return value->values();
  }

  std::size_t line() const { return object_.line(); }
  [[noreturn]] void fail(const std::string& message) const { object_.fail(message); }

 private:
  Value object_;
  std::vector<Value> values_;
};

/// Returns the directions of 'axis' or 'frame'; empty if 'axis' is `word`, which may be null.
std::vector<Vector3> axes(const Members& members, const char* word) {
  const std::optional<Value> axis = members.find("axis"), frame = members.find("frame");
  if (axis.has_value() == frame.has_value()) members.fail("either 'axis' or 'frame' is needed");
  if (axis) {
    if (word != nullptr && axis->is(Kind::kText)) {
      if (axis->text() != word)
        axis->fail(fmt::format("'axis' must be \"{}\" or three numbers in brackets", word));
      return {};
    }
    return {direction(*axis, "axis")};
  }
  const std::vector<Value> values = frame->is(Kind::kArray) ? frame->values() : std::vector<Value>{};
  if (values.size() != 3 || !is_list(*frame))
    frame->fail("'frame' must be three axes in brackets, each of three numbers in brackets");
  std::vector<Vector3> result;
  for (const Value& value : values) result.push_back(direction(value, "frame"));
  demand(*frame, fault_of_axes(result));
  return result;
}

double weight_of(const Members& members) {
  const std::optional<Value> value = members.find("weight");
  return value ? weight(*value) : 1;
}

/// Reads one value for all `count` places, or one for each.
std::vector<double> weights_of(const Members& members, std::size_t count, bool of_list) {
  const std::optional<Value> value = members.find("weight");
  if (!value) return std::vector<double>(count, 1.0);
  if (!of_list || !value->is(Kind::kArray)) return std::vector<double>(count, weight(*value));
  std::vector<double> result;
  for (const Value& each : value->values()) result.push_back(weight(each));
  if (result.size() != count)
    value->fail(
        fmt::format("'weight' has {} for {}", counted(result.size(), "number"), counted(count, "place")));
  return result;
}

/// Reads 'at': one place, or a list of them.
struct Places {
  std::vector<Value> values;
  bool is_list;
};

Places places_of(const Members& members) {
  const Value at = members.at("at");
  if (is_list(at)) return {at.values(), true};
  return {{at}, false};
}

void read_points(const Value& value, Constraints& constraints) {
  const Members members(value, "a point", {"at", "axis", "frame", "weight"});
  const Places places = places_of(members);
  const std::vector<Vector3> asked = axes(members, nullptr);
  const std::vector<double> weights = weights_of(members, places.values.size(), places.is_list);
  for (std::size_t k = 0; k < places.values.size(); ++k) {
    constraints.points.push_back({place(places.values[k], "at"), asked, weights[k], places.values[k].line()});
  }
}

void read_polyline(const Value& value, Constraints& constraints) {
  const Members members(value, "a polyline", {"points", "axis", "frame", "weight"});
  const Value points = members.at("points");
  if (!is_list(points)) points.fail("'points' must be a list of places, each of three numbers in brackets");
  Constraints::Polyline polyline;
  for (const Value& point : points.values()) polyline.points.push_back(place(point, "points"));
  demand(points, fault_of_polyline(polyline.points));
  polyline.axes = axes(members, "tangent");
  polyline.weight = weight_of(members);
  polyline.line = members.line();
  constraints.polylines.push_back(std::move(polyline));
}

std::int32_t face_number(const Value& value) {
  using Limits = std::numeric_limits<std::int32_t>;
  const bool fits = value.is(Kind::kNumber) && value.number() == std::floor(value.number()) &&
                    value.number() >= Limits::min() && value.number() <= Limits::max();
  if (!fits) value.fail("'face' must be a whole number, or a list of them");
  return static_cast<std::int32_t>(value.number());
}

void read_faces(const Value& value, Constraints& constraints) {
  const Members members(value, "a face", {"face", "axis", "frame", "weight"});
  const Value face = members.at("face");
  const std::vector<Value> faces = face.is(Kind::kArray) ? face.values() : std::vector<Value>{face};
  if (faces.empty()) face.fail("'face' must be a whole number, or a list of them");
  const std::vector<Vector3> asked = axes(members, "normal");
  const double weight = weight_of(members);
  for (const Value& each : faces)
    constraints.faces.push_back({face_number(each), asked, weight, each.line()});
}

void read_stresses(const Value& value, Constraints& constraints) {
  const Members members(value, "a stress", {"at", "stress", "weight"});
  const Places places = places_of(members);
  const Value stress = members.at("stress");
  const std::vector<Value> tensors =
      places.is_list && is_list(stress) ? stress.values() : std::vector{stress};
  if (tensors.size() != places.values.size())
    stress.fail(fmt::format("'stress' has {} for {}", counted(tensors.size(), "tensor"),
                            counted(places.values.size(), "place")));
  const std::vector<double> weights = weights_of(members, tensors.size(), places.is_list);
  for (std::size_t k = 0; k < tensors.size(); ++k) {
    const std::array<double, 6> tensor = numbers<6>(tensors[k], "stress");
    constraints.stresses.push_back(
        {place(places.values[k], "at"), tensor, weights[k], places.values[k].line()});
  }
}

void check_schema(const Members& members) {
  const Value schema = members.at("schema");
  if (!schema.is(Kind::kNumber) || schema.number() != kConstraintsSchema)
    schema.fail(fmt::format("'schema' must be {}, the only one that this program reads", kConstraintsSchema));
}

}  // namespace

Constraints read_constraints(const std::filesystem::path& path) {
  const InputFile file(path);
  const LocatedJson json(file);
  const Members members(json.root(), "the file", {"schema", "points", "polylines", "faces", "stresses"});
  check_schema(members);
  Constraints constraints;
  constraints.source = file.name();
  for (const Value& value : members.list("points")) read_points(value, constraints);
  for (const Value& value : members.list("polylines")) read_polyline(value, constraints);
  for (const Value& value : members.list("faces")) read_faces(value, constraints);
  for (const Value& value : members.list("stresses")) read_stresses(value, constraints);
  if (constraints.empty())
    members.fail("has no constraints under 'points', 'polylines', 'faces' or 'stresses'");
  return constraints;
}

}  // namespace crossgrain
