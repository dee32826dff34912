// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/glued_solids.hpp"

#include <fmt/format.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_ListOfShape.hxx>
#include <algorithm>
#include <cmath>

#include "cad_reading/program/fault.hpp"

namespace crossgrain {
namespace {

/// Largest relative change of a solid's volume: far above what gaps and rounding do, far below a lost face.
constexpr double kVolumeTolerance = 1e-3;

double volume_of(const TopoDS_Shape& solid) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  return std::abs(properties.Mass());
}

}  // namespace

GluedSolids::GluedSolids(const std::vector<TopoDS_Shape>& solids, double gap) {
  for (const TopoDS_Shape& solid : solids) builder_.AddArgument(solid);
  builder_.SetNonDestructive(true);
  builder_.SetRunParallel(false);
  builder_.SetFuzzyValue(gap);
  builder_.Perform();
  if (builder_.HasErrors()) throw Fault("has solids that OpenCASCADE cannot glue", Remedy::kReadUnglued);

  TopTools_DataMapOfShapeInteger places;
  std::vector<double> volumes;  // of the solids that the pieces belong to
  for (std::size_t number = 0; number < solids.size(); ++number) {
    const double volume = volume_of(solids[number]);
    double volume_of_parts = 0;
    for (const TopoDS_Shape& part : parts_of(solids[number])) {
      volume_of_parts += volume_of(part);
      if (!places.IsBound(part)) {
        places.Bind(part, static_cast<int>(pieces_.size()));
        pieces_.push_back({part, number});
        volumes.push_back(volume);
      } else if (const auto place = static_cast<std::size_t>(places(part)); volume < volumes[place]) {
        pieces_[place].number = number;
        volumes[place] = volume;
      }
    }
    if (!(std::abs(volume_of_parts - volume) <= kVolumeTolerance * volume))
      throw Fault(fmt::format("has solids that OpenCASCADE cannot glue: it makes {:.6g} of the volume {:.6g} "
                              "of solid {}",
                              volume_of_parts, volume, number),
                  Remedy::kReadUnglued);
  }
  std::stable_sort(pieces_.begin(), pieces_.end(),
                   [](const Piece& a, const Piece& b) { return a.number < b.number; });
}

std::vector<TopoDS_Shape> GluedSolids::parts_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> parts;
  if (builder_.IsDeleted(shape)) return parts;
  const TopTools_ListOfShape& modified = builder_.Modified(shape);
  for (const TopoDS_Shape& part : modified) parts.push_back(part);
  if (parts.empty()) parts.push_back(shape);
  return parts;
}

}  // namespace crossgrain
