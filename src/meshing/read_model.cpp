// SPDX-License-Identifier: Apache-2.0
#include "meshing/read_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include "archives/gzip.hpp"
#include "base/required_memory.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/model_summary.hpp"
#include "crossgrain/reading.hpp"
#include "hex/feature_judgement.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "solve/tet_domain_data.hpp"
#include "surface/model_faces.hpp"
#include "surface/topology.hpp"
#include "tet_making/given_model.hpp"

namespace crossgrain {
namespace {

/// What a triangle of a model takes until hexahedra are on it, once it is read. Peaks of fits and lattices of
/// spheres of 25,000, 102,000 and 408,000 triangles grow by 920 bytes a triangle, reading included.
constexpr double kBytesOfTriangle = 900;

void require_memory_of(const TriangleMesh& surface) {
  const std::size_t count = surface.triangles.size();
  require_memory(kBytesOfTriangle * static_cast<double>(count),
                 fmt::format("putting hexahedra onto {}", counted(count, "triangle", "triangles")),
                 Remedy::kAllowMemory);
}

TetMakingTuning reading_of(const HexFitOptions& options) {
  TetMakingTuning reading;
  reading.crease_angle_deg = options.crease_angle_deg;
  reading.read_seconds = options.read_seconds;
  reading.glue = options.glue;
  reading.defeature = options.defeature;
  reading.unit = options.unit;
  reading.max_memory_bytes = options.max_memory_bytes;
  return reading;
}

SolveReport::Model description_of(const TriangleMesh& surface, const Box& exact_box) {
  const SurfaceTopology topology = analyse_topology(surface);
  SolveReport::Model model;
  model.triangles = surface.triangles.size();
  model.bounding_box = longest_side(exact_box) > 0 ? exact_box : box_of(surface.vertices);
  model.watertight = topology.watertight;
  model.components = topology.components;
  return model;
}

ReadModel read_given(GivenModel given, const TriangleMesh& as_read, std::vector<Warning> warnings) {
  ReadModel read;
  read.description = description_of(given.surface, as_read.exact_box);
  read.description.unit = as_read.unit;
  read.description.file_unit = as_read.file_unit;
  read.faces = given.faces;
  read.warnings = std::move(warnings);
  read.model = fitting_model(std::move(given));
  return read;
}

/// How many numbers of solids or regions there are; 1 without.
std::size_t count_numbers(const std::vector<std::int32_t>& numbers) {
  return std::max<std::size_t>(1, std::set<std::int32_t>(numbers.begin(), numbers.end()).size());
}

ReadModel tet_model(TetMesh mesh, const HexFitOptions& options, const Monitor& monitor) {
  if (options.unit != LengthUnit::kUnknown) mesh.unit = name_of(options.unit);
  monitor.tell(summary_of(mesh));
  const TetDomain domain(std::move(mesh), options.tags);
  ReadModel read;
  read.model.solid = domain.data().solid;
  const TriangleMesh boundary = domain.boundary();
  read.model.features = features_of_surface(boundary, {.least_deg = options.crease_angle_deg});
  read.description = description_of(boundary, {});
  read.description.unit = boundary.unit;
  read.description.file_unit = boundary.file_unit;
  read.faces = model_faces(domain.data().solid, domain.data().walls);
  read.warnings = domain.warnings();
  read.solids = count_numbers(domain.mesh().regions);
  return read;
}

ReadModel read_file(const std::filesystem::path& path, const HexFitOptions& options, const Monitor& monitor) {
  if (is_tet_file(path)) check_no_defeature(options.defeature);
  if (is_tet_file(path)) return tet_model(read_tets(path), options, monitor);
  if (const auto format = cad_format_of(path)) {
    CadModel model = read_open_solids(read_unpacked(path), *format, reading_of(options), monitor);
    if (has_open_solids(model) || options.defeature > 0) return model_of(std::move(model.mesh), options);
    require_memory_of(model.mesh);
    ReadModel read =
        read_given(given_cad(model.mesh, options.crease_angle_deg), model.mesh, model.mesh.warnings);
    read.solids = count_numbers(model.mesh.solids);
    return read;
  }
  ReadOptions reading;
  reading.unit = options.unit;
  return model_of(read_surface(path, reading, monitor), options);
}

}  // namespace

void check_no_defeature(double size) {
  if (size > 0)
    throw Error(ErrorKind::kUsage,
                {"", "defeature", "nothing can be left out of a mesh of tets: give its surface or CAD file"});
}

ReadModel model_of(TriangleMesh surface, const HexFitOptions& options) {
  if (!(options.defeature >= 0))
    throw Error(ErrorKind::kUsage, {"", "defeature", "must be a size, or 0 for none"});
  require_memory_of(surface);
  TriangleMesh units;
  units.unit = surface.unit;
  units.file_unit = surface.file_unit;
  const ClosedModel model(std::move(surface), options.crease_angle_deg, options.defeature);
  return read_given(model.given(model.patches()), units, model.warnings());
}

ReadModel read_model(const std::filesystem::path& path, const HexFitOptions& options,
                     const Monitor& monitor) {
  try {
    return read_file(path, options, monitor);
  } catch (const Error& error) {
    throw named(error, path);
  }
}

Error named(const Error& error, const std::filesystem::path& model) {
  // Usage: of sizes that do not suit the model.
  const bool is_of_model = error.kind() == ErrorKind::kInput || error.kind() == ErrorKind::kLimit ||
                           error.kind() == ErrorKind::kUsage;
  return is_of_model && error.file().empty() ? error.with_file(model.string()) : error;
}

}  // namespace crossgrain
