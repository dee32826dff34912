// SPDX-License-Identifier: Apache-2.0
#include "fit_command.hpp"

#include "crossgrain/error.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/result_folder.hpp"
#include "messages.hpp"

namespace crossgrain::app {

namespace {

HexFitOptions fit_options(const SolveArguments& arguments, const std::function<void(const Warning&)>& warn) {
  HexFitOptions options;
  options.crease_angle_deg = arguments.options.crease_angle_deg;
  options.tags = arguments.tags;
  options.read_seconds = arguments.read_seconds;
  options.glue = arguments.glue;
  options.unit = arguments.unit;
  options.max_memory_bytes = arguments.options.max_memory_bytes;
  options.threads = arguments.options.threads;
  options.on_warning = warn;
  return options;
}

template <class Make>
FittedHexahedra unless_interrupted(const Make& make, const Monitor& monitor) {
  try {
    return make();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kInterrupted || monitor.cancelled()) throw;
    throw Error(ErrorKind::kInterrupted, "interrupted before there was a mesh; nothing is written");
  }
}

}  // namespace

HexMeshingOptions hex_options(const SolveArguments& arguments) {
  HexMeshingOptions options = *arguments.hexahedra;
  options.tags = arguments.tags;
  options.solve = arguments.options;
  options.solve.for_page = arguments.page;
  options.tets.crease_angle_deg = options.solve.crease_angle_deg;
  options.tets.max_memory_bytes = options.solve.max_memory_bytes;
  options.tets.read_seconds = arguments.read_seconds;
  options.tets.glue = arguments.glue;
  options.tets.unit = arguments.unit;
  return options;
}

FittedHexahedra fitted_mesh(const SolveArguments& arguments, const std::function<void(const Warning&)>& warn,
                            const Monitor& monitor) {
  HexMesh mesh;
  {
    const ReadLimits limits(monitor, arguments.options.max_memory_bytes);
    mesh = read_hexahedra(arguments.mesh);
  }
  for (const Warning& warning : mesh.warnings) warn(warning);
  return unless_interrupted(
      [&] {
        return naming(arguments.mesh, [&] {
          return fit_hexahedra(mesh, std::filesystem::path(arguments.model), fit_options(arguments, warn),
                               monitor);
        });
      },
      monitor);
}

FittedHexahedra lattice_mesh(const SolveArguments& arguments, const HexMeshingOptions& options,
                             const Monitor& monitor) {
  return unless_interrupted(
      [&] { return lattice_hexahedra(std::filesystem::path(arguments.model), options, monitor); }, monitor);
}

FittedHexahedra lattice_mesh_without_tets(const Error& error, const SolveArguments& arguments,
                                          const HexMeshingOptions& options, const Monitor& monitor) {
  return unless_interrupted(
      [&] { return lattice_without_tets(error, std::filesystem::path(arguments.model), options, monitor); },
      monitor);
}

}  // namespace crossgrain::app
