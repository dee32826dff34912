// SPDX-License-Identifier: Apache-2.0
// Messages between the library and the program crossgrain_netgen. Netgen is in a program of its own because
// it brings libraries along that nothing else here needs, and may crash. It gets a request as its arguments,
// with files in a folder, and writes an answer to kAnswerDescriptor.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/tet_making.hpp"
#include "crossgrain/types.hpp"
#include "remeshing/remeshing_options.hpp"

namespace crossgrain {

enum class NetgenWork {
  kFill,  ///< fills the triangles in kNetgenSurface
  kCut    ///< cuts the solids in kNetgenSolids
};

/// Names of the files in the folder: triangles (`netgen_surface_bytes`), solids in BREP, and the program's
/// own.
inline constexpr const char *kNetgenSurface = "surface", *kNetgenSolids = "solids.brep",
                            *kNetgenMesh = "mesh.vol";

struct NetgenRequest {
  pid_t asking_process;  ///< the program ends when this process does
  NetgenWork work;
  Remeshing sizes;
  std::size_t max_memory_bytes;
  std::string folder;
};

enum class NetgenEnd : std::uint8_t { kTets, kFault, kOutOfMemory };

struct NetgenAnswer {
  NetgenEnd end = NetgenEnd::kTets;
  std::string fault;  ///< one line: "Netgen cannot mesh the faces"

  /// Regions and tags as in TetProgram::cut; after kFill without them, the given vertices first.
  TetMesh mesh;
};

/// Converts a request to the arguments of the program, and back; nothing if they are invalid.
std::vector<std::string> arguments_of(const NetgenRequest& request);
std::optional<NetgenRequest> netgen_request_of(const std::vector<std::string>& arguments);

/// Triangles around a solid as the bytes of a file, and back; nothing if they are damaged.
struct NetgenSurface {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
std::string netgen_surface_bytes(const NetgenSurface& surface);
std::optional<NetgenSurface> netgen_surface_in(std::string_view bytes);

/// Writes the answer after the greeting. Returns false if it could not be written.
bool write_netgen_answer(std::FILE* out, const NetgenAnswer& answer);

/// Returns the answer in the program's output; nothing if it is incomplete or inconsistent, as after a crash.
std::optional<NetgenAnswer> netgen_answer_in(std::string_view written);

}  // namespace crossgrain
