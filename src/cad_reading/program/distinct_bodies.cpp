// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/distinct_bodies.hpp"

#include <fmt/format.h>

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "cad_reading/program/known_faces.hpp"

namespace crossgrain {
namespace {

/// Largest relative difference of volume and area of a solid and its copy: above what integration over other
/// faces does, below a lost face.
constexpr double kSameMeasure = 1e-4;

/// Tells a solid from others with faces in the same places, such as one that fills a void of another.
struct Measures {
  double volume = 0, area = 0;
  gp_Pnt middle;

  explicit Measures(const TopoDS_Shape& solid) {
    GProp_GProps of_volume, of_area;
    BRepGProp::VolumeProperties(solid, of_volume);
    BRepGProp::SurfaceProperties(solid, of_area);
    volume = std::abs(of_volume.Mass());
    area = of_area.Mass();
    middle = of_volume.CentreOfMass();
  }

  bool are_of(const Measures& other) const {
    return std::abs(volume - other.volume) <= kSameMeasure * volume &&
           std::abs(area - other.area) <= kSameMeasure * area &&
           middle.Distance(other.middle) <= kSameMeasure * std::sqrt(area);
  }
};

/// A solid in the place of another: their numbers.
struct RepeatedSolid {
  std::int32_t number, original;
};

/// Finds copies among the bodies that it is given one after the other.
class Copies {
 public:
  explicit Copies(double tolerance) : known_(tolerance) {}

  /// Returns the earlier solid in whose place a solid is.
  std::optional<std::int32_t> original_of(const Body& solid) {
    if (!known_.hold(solid.shape)) return std::nullopt;
    const Measures measures(solid.shape);
    for (const Body& other : solids_)
      if (measures_of(other).are_of(measures)) return other.solid;
    return std::nullopt;
  }

  void keep(const Body& body) {
    known_.add(body.shape);
    if (body.shape.ShapeType() == TopAbs_SOLID) solids_.push_back(body);
  }

  const KnownFaces& known() const { return known_; }

 private:
  const Measures& measures_of(const Body& solid) {
    return measures_.try_emplace(solid.solid, solid.shape).first->second;
  }

  KnownFaces known_;
  std::vector<Body> solids_;
  std::map<std::int32_t, Measures> measures_;  ///< by Body::solid, as far as they were needed
};

void warn_of_solids(const std::vector<RepeatedSolid>& left_out, std::vector<Warning>& warnings) {
  if (left_out.empty()) return;
  const auto& [number, original] = left_out.front();
  warnings.emplace_back(
      WarningKind::kRepeatedBodies,
      fmt::format(
          "solids in the place of another one, left out: {}; the first is solid {}, in the place of solid {}",
          left_out.size(), number + 1, original + 1));
}

void warn_of_shells(std::size_t left_out, std::vector<Warning>& warnings) {
  if (left_out == 0) return;
  warnings.emplace_back(
      WarningKind::kRepeatedBodies,
      fmt::format("shells of faces that bound another body already, left out: {}", left_out));
}

}  // namespace

DistinctBodies distinct_bodies(const std::vector<TopoDS_Shape>& solids,
                               const std::vector<TopoDS_Shape>& shells, double tolerance) {
  DistinctBodies result;
  Copies copies(tolerance);
  std::vector<RepeatedSolid> repeated_solids;
  std::int32_t number = 0;
  for (const TopoDS_Shape& solid : solids) {
    const Body body{solid, true, number++};
    if (const auto original = copies.original_of(body)) {
      repeated_solids.push_back({body.solid, *original});
      continue;
    }
    copies.keep(body);
    result.solids.push_back(body);
  }
  for (const TopoDS_Shape& shell : shells)
    result.shells.push_back({shell, static_cast<bool>(BRep_Tool::IsClosed(shell)), number++});
  const auto is_known = [&](const Body& shell) {
    if (copies.known().hold(shell.shape)) return true;
    copies.keep(shell);
    return false;
  };
  // A closed shell is a body; an open one may be a part of it.
  std::erase_if(result.shells, [&](const Body& shell) { return shell.closed && is_known(shell); });
  std::erase_if(result.shells, [&](const Body& shell) { return !shell.closed && is_known(shell); });
  warn_of_solids(repeated_solids, result.warnings);
  warn_of_shells(shells.size() - result.shells.size(), result.warnings);
  return result;
}

}  // namespace crossgrain
