// SPDX-License-Identifier: Apache-2.0
// Measures the best time of five to read a surface file, and the peak memory of the process relative to the
// size of the file and of the mesh. Each file gets its own process, since the peak never decreases.
//
//   bench/make_surface.py 707 /tmp/torus.stl && build/release/bench/read_surfaces /tmp/torus.stl
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "base/system_memory.hpp"
#include "crossgrain/reading.hpp"

namespace {

void measure(const char* path) {
  double best = 1e9;
  std::size_t triangles = 0, mesh_bytes = 0;
  for (int trial = 0; trial < 5; ++trial) {
    const auto start = std::chrono::steady_clock::now();
    const crossgrain::TriangleMesh mesh = crossgrain::read_surface(path);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    best = std::min(best, seconds.count());
    triangles = mesh.triangles.size();
    mesh_bytes = sizeof mesh.triangles[0] * triangles + sizeof mesh.vertices[0] * mesh.vertices.size();
  }
  const double file = static_cast<double>(std::filesystem::file_size(path)),
               peak = static_cast<double>(crossgrain::peak_memory_bytes());
  fmt::print(
      "{}: {} triangles, {:.3f} s, file of {:.1f} MB, mesh of {:.1f} MB, peak memory {:.1f} MB: {:.2f} times "
      "the file\n",
      path, triangles, best, file / 1e6, static_cast<double>(mesh_bytes) / 1e6, peak / 1e6, peak / file);
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const pid_t process = ::fork();
    if (process == 0) {
      measure(argv[i]);
      return 0;
    }
    ::waitpid(process, nullptr, 0);
  }
}
