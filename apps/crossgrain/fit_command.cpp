// SPDX-License-Identifier: Apache-2.0
#include "fit_command.hpp"

#include "crossgrain/error.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/result_folder.hpp"
#include "messages.hpp"

namespace crossgrain::app {

FittedHexahedra fitted_mesh(const SolveArguments& arguments, const std::function<void(const Warning&)>& warn,
                            const Monitor& monitor) {
  HexMesh mesh;
  {
    const ReadLimits limits(monitor, arguments.options.max_memory_bytes);
    mesh = read_hexahedra(arguments.mesh);
  }
  for (const Warning& warning : mesh.warnings) warn(warning);
  HexFitOptions options;
  options.crease_angle_deg = arguments.options.crease_angle_deg;
  options.tags = arguments.tags;
  options.read_seconds = arguments.read_seconds;
  options.glue = arguments.glue;
  options.unit = arguments.unit;
  options.max_memory_bytes = arguments.options.max_memory_bytes;
  options.threads = arguments.options.threads;
  options.on_warning = warn;
  try {
    return naming(arguments.mesh, [&] {
      return fit_hexahedra(mesh, std::filesystem::path(arguments.model), options, monitor);
    });
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kInterrupted || monitor.cancelled()) throw;
    throw Error(ErrorKind::kInterrupted, "interrupted before there was a mesh; nothing is written");
  }
}

}  // namespace crossgrain::app
