// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/hex_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/system_memory.hpp"
#include "base/vector3.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/thread_limit.hpp"
#include "hex/hex_making.hpp"
#include "hex/lattice_trials.hpp"
#include "hex/model_fit.hpp"
#include "meshing/asked_hexahedra.hpp"
#include "meshing/read_model.hpp"
#include "meshing/shown_surface.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {
namespace {

HexFitOptions reading_of(const HexMeshingOptions& options) {
  HexFitOptions reading;
  reading.crease_angle_deg = options.tets.crease_angle_deg;
  reading.tags = options.tags;
  reading.read_seconds = options.tets.read_seconds;
  reading.glue = options.tets.glue;
  reading.defeature = options.tets.defeature;
  reading.unit = options.tets.unit;
  reading.max_memory_bytes = options.solve.max_memory_bytes;
  return reading;
}

/// Throws Error(kUsage) for sizes out of range or that do not suit the model.
void check(const HexMeshingOptions& options, const FittingModel& model) {
  HexMeshingOptions of_size;
  of_size.hexahedra = options.hexahedra;
  of_size.on_warning = options.on_warning;
  Surface surface = outer_surface(model.features);
  surface.mesh.unit = model.solid.mesh.unit;
  AskedHexahedra(of_size).check(SearchableSurface(std::move(surface)));
}

/// Warns of parts of the surface that a lattice has joined.
void warn_of_joined(std::size_t solids, std::vector<Warning>& warnings) {
  const std::string parts = solids > 1 ? fmt::format("{} of the model", counted(solids, "solid"))
                                       : std::string("closed parts of the surface");
  warnings.emplace_back(WarningKind::kTouchingSolids,
                        parts + " touch or overlap, and share no faces: a lattice makes them one",
                        solids > 1 ? Remedy::kGlueSolids : Remedy::kSeparateSolids);
}

/// Sets HexOutcome::kApproximate, with the reason, where solids that share faces have become one.
void judge_solids_of_lattice(std::size_t solids, HexReport& report) {
  if (solids <= report.bodies || report.hexahedra == 0 || is_partial(report.outcome)) return;
  report.outcome = HexOutcome::kApproximate;
  report.reason += fmt::format("{}its {} are meshed as {}, without faces between them, which only maps have",
                               report.reason.empty() ? "" : "; ", counted(solids, "solid"),
                               report.bodies == 1 ? "one" : counted(report.bodies, "body", "bodies"));
}

template <class Read>
FittedHexahedra made_by_lattice(const Read& read, const HexMeshingOptions& options, const Monitor& monitor) {
  const ThreadLimit threads(options.hexahedra.threads > 0 ? options.hexahedra.threads
                                                          : options.solve.threads);
  const ReadLimits limits(monitor, options.solve.max_memory_bytes);
  const WatchedLoops watched(monitor, Stops::kIgnored, options.solve.max_memory_bytes);
  check_options(options.hexahedra);
  Stopwatch stopwatch;
  monitor.report({Phase::kRead, 0, 0, 0, 0});
  ReadModel model = read();
  if (options.on_warning)
    for (const Warning& warning : model.warnings) options.on_warning(warning);
  check(options, model.model);
  FittedHexahedra made;
  SolveReport& report = made.report;
  report.seconds.read = stopwatch.restart();
  const double size = options.hexahedra.size > 0
                          ? options.hexahedra.size
                          : longest_side(model.description.bounding_box) / options.hexahedra.cells;
  LatticeListeners listeners{.on_expected = {}, .on_end = options.on_attempt_end};
  if (options.on_expected)
    listeners.on_expected = [&](double first_size, double hexahedra) {
      options.on_expected({.tets = 0, .size = first_size, .hexahedra = hexahedra, .tet_size = {}});
    };
  LatticeHexahedra found = lattice_hexahedra(model.model, size, monitor, listeners);
  made.surface = shown_surface(model.model.features);
  report.model = std::move(model.description);
  report.faces = std::move(model.faces);
  report.warnings = std::move(model.warnings);
  report.warnings.insert(report.warnings.end(), found.warnings.begin(), found.warnings.end());
  made.mesh = std::move(found.mesh);
  made.mesh.unit = report.model.unit;
  report.hexahedra = std::move(found.report);
  if (found.has_joined) warn_of_joined(model.solids, report.warnings);
  judge_solids_of_lattice(model.solids, *report.hexahedra);
  count_quads(made.mesh, report.faces);
  for (auto& warning : {faces_without_quads(report.faces, model.model.solid, *report.hexahedra),
                        faces_off(report.faces, *report.hexahedra)})
    if (warning) report.warnings.push_back(*warning);
  report.answer.is_meshed = true;
  report.seconds.total = report.seconds.read + stopwatch.restart();
  report.peak_memory_bytes = peak_memory_bytes();
  return made;
}

/// Whether an error says that no tets can be made of a model.
bool is_of_tets(const Error& error) {
  constexpr std::array kRemedies{Remedy::kUniteParts, Remedy::kCloseHoles, Remedy::kCloseSurface,
                                 Remedy::kInstallTetMaker, Remedy::kChangeTetSize};
  if (error.kind() == ErrorKind::kLimit) return error.remedy() == Remedy::kAllowTetTime;
  return error.kind() == ErrorKind::kInput && std::ranges::find(kRemedies, error.remedy()) != kRemedies.end();
}

template <class Model>
FittedHexahedra made_without_tets(const Error& error, const Model& model, const HexMeshingOptions& options,
                                  const Monitor& monitor) {
  if (!is_of_tets(error) || options.hexahedra.preference == HexPreference::kMapOnly) throw Error(error);
  const Warning warning(
      WarningKind::kTetMaker,
      fmt::format("no tets can be made of it, and so no field and no map, but a lattice: {}", error.text()),
      error.message().remedy);
  // Once the model is read: one that cannot be gives its error alone.
  HexMeshingOptions heard = options;
  heard.on_expected = [&](const HexExpectation& expected) {
    if (options.on_warning) options.on_warning(warning);
    if (options.on_expected) options.on_expected(expected);
  };
  try {
    FittedHexahedra made = lattice_hexahedra(model, heard, monitor);
    made.report.warnings.insert(made.report.warnings.begin(), warning);
    return made;
  } catch (const Error& other) {
    if (other.kind() != ErrorKind::kInput) throw;
    throw Error(error);
  }
}

}  // namespace

FittedHexahedra lattice_hexahedra(const std::filesystem::path& model, const HexMeshingOptions& options,
                                  const Monitor& monitor) {
  try {
    FittedHexahedra made =
        made_by_lattice([&] { return read_model(model, reading_of(options), monitor); }, options, monitor);
    made.report.model.path = model.string();
    return made;
  } catch (const Error& error) {
    throw named(error, model);
  }
}

FittedHexahedra lattice_hexahedra(const TriangleMesh& surface, const HexMeshingOptions& options,
                                  const Monitor& monitor) {
  return made_by_lattice([&] { return model_of(surface, reading_of(options)); }, options, monitor);
}

FittedHexahedra lattice_without_tets(const Error& error, const std::filesystem::path& model,
                                     const HexMeshingOptions& options, const Monitor& monitor) {
  return made_without_tets(error, model, options, monitor);
}

FittedHexahedra lattice_without_tets(const Error& error, const TriangleMesh& surface,
                                     const HexMeshingOptions& options, const Monitor& monitor) {
  return made_without_tets(error, surface, options, monitor);
}

}  // namespace crossgrain
