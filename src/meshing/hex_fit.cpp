// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/hex_fit.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "archives/gzip.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/system_memory.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/model_summary.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/thread_limit.hpp"
#include "hex/feature_judgement.hpp"
#include "hex/model_fit.hpp"
#include "hex/model_fitting.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "solve/tet_domain_data.hpp"
#include "surface/model_faces.hpp"
#include "tet_making/given_model.hpp"

namespace crossgrain {
namespace {

/// A model with what a report says of it.
struct ReadModel {
  FittingModel model;
  SolveReport::Model description;
  std::vector<ModelFace> faces;
  std::vector<Warning> warnings;
};

TetMakingTuning reading_of(const HexFitOptions& options) {
  TetMakingTuning reading;
  reading.crease_angle_deg = options.crease_angle_deg;
  reading.read_seconds = options.read_seconds;
  reading.glue = options.glue;
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

ReadModel closed_model(TriangleMesh surface, const HexFitOptions& options) {
  TriangleMesh units;
  units.unit = surface.unit;
  units.file_unit = surface.file_unit;
  const ClosedModel model(std::move(surface));
  return read_given(model.given(model.patches(options.crease_angle_deg), options.crease_angle_deg), units,
                    model.warnings());
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
  return read;
}

ReadModel read_model(const std::filesystem::path& path, const HexFitOptions& options,
                     const Monitor& monitor) {
  if (is_tet_file(path)) return tet_model(read_tets(path), options, monitor);
  if (const auto format = cad_format_of(path)) {
    const CadModel model = read_solids(read_unpacked(path), *format, reading_of(options), monitor);
    return read_given(given_cad(model.mesh, options.crease_angle_deg), model.mesh, model.mesh.warnings);
  }
  ReadOptions reading;
  reading.unit = options.unit;
  return closed_model(read_surface(path, reading, monitor), options);
}

/// Says so of faces between regions that have moved.
std::optional<Warning> moved_interfaces(const HexMesh& mesh, const HexReport& report) {
  const std::set<std::int32_t> regions(mesh.regions.begin(), mesh.regions.end());
  if (regions.size() < 2 || report.best_fit == 0) return std::nullopt;
  return Warning(
      WarningKind::kCrossedInterfaces,
      fmt::format("faces between the {} regions of the mesh have moved with the vertices inside, and "
                  "lie on no face of the model",
                  regions.size()));
}

template <class Read>
FittedHexahedra fitted_to(const HexMesh& mesh, const Read& read, const HexFitOptions& options,
                          const Monitor& monitor) {
  const ThreadLimit threads(options.threads);
  const ReadLimits limits(monitor, options.max_memory_bytes);
  const WatchedLoops watched(monitor, Stops::kIgnored, options.max_memory_bytes);
  Stopwatch stopwatch;
  check_fittable(mesh);
  monitor.report({Phase::kRead, 0, 0, 0, 0});
  ReadModel model = read();
  if (options.on_warning)
    for (const Warning& warning : model.warnings) options.on_warning(warning);
  check_same_place(mesh, model.model);
  FittedHexahedra fitted{mesh, {}};
  SolveReport& report = fitted.report;
  report.model = std::move(model.description);
  report.faces = std::move(model.faces);
  report.warnings = mesh.warnings;
  report.warnings.insert(report.warnings.end(), model.warnings.begin(), model.warnings.end());
  report.seconds.read = stopwatch.restart();
  fitted.mesh.unit = report.model.unit;
  fitted.mesh.warnings.clear();
  report.hexahedra = fit_to_model(model.model, monitor, fitted.mesh, report.warnings);
  count_quads(fitted.mesh, report.faces);
  if (auto moved = moved_interfaces(fitted.mesh, *report.hexahedra))
    report.warnings.push_back(*std::move(moved));
  report.answer.is_meshed = true;
  report.seconds.total = report.seconds.read + stopwatch.restart();
  report.peak_memory_bytes = peak_memory_bytes();
  return fitted;
}

}  // namespace

FittedHexahedra fit_hexahedra(const HexMesh& mesh, const std::filesystem::path& model,
                              const HexFitOptions& options, const Monitor& monitor) {
  const auto read = [&] {
    try {
      return read_model(model, options, monitor);
    } catch (const Error& error) {
      const bool is_of_model = error.kind() == ErrorKind::kInput || error.kind() == ErrorKind::kLimit;
      throw is_of_model && error.file().empty() ? error.with_file(model.string()) : error;
    }
  };
  FittedHexahedra fitted = fitted_to(mesh, read, options, monitor);
  fitted.report.model.path = model.string();
  return fitted;
}

FittedHexahedra fit_hexahedra(const HexMesh& mesh, const TriangleMesh& surface, const HexFitOptions& options,
                              const Monitor& monitor) {
  return fitted_to(
      mesh, [&] { return closed_model(surface, options); }, options, monitor);
}

}  // namespace crossgrain
