// SPDX-License-Identifier: Apache-2.0
// Formats of meshes that are chosen by the name of the file.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/monitor.hpp"
#include "files/file_seal.hpp"
#include "files/output_file.hpp"
#include "files/output_name.hpp"

namespace crossgrain {

/// How a Mesh is written to files with an extension.
template <class Mesh>
struct MeshFormat {
  std::string_view extension;
  void (*write)(OutputFile& file, const Mesh& mesh, const Monitor& monitor);

  /// Of formats that commands write under names that nobody gave: a file that was changed is not replaced.
  std::optional<SealForm> seal = {};
};

/// Returns the format of a file. Throws Error(kUsage) if it is none of these; `what` is in the file, such as
/// "a tet mesh".
template <class Mesh>
const MeshFormat<Mesh>& format_of(const std::filesystem::path& path,
                                  std::span<const MeshFormat<Mesh>> formats, const char* what) {
  std::vector<std::string_view> extensions;
  for (const MeshFormat<Mesh>& format : formats) {
    if (has_extension(path, format.extension)) return format;
    extensions.push_back(format.extension);
  }
  refuse_name(path, what, extensions);
}

/// Writes a mesh in its format. The file appears complete or not at all. Throws Error(kOutput) and
/// Error(kInterrupted).
template <class Mesh>
void write_mesh(const MeshFormat<Mesh>& format, const Mesh& mesh, const std::filesystem::path& path,
                const Monitor& monitor) {
  OutputFile file(path);
  format.write(file, mesh, monitor);
  if (format.seal) write_seal(file, *format.seal);
  file.commit();
}

}  // namespace crossgrain
