// SPDX-License-Identifier: Apache-2.0
// Measures the best time of five to read a tet mesh, and the peak memory of the process.
//
//   bench/make_tets.py 55 /tmp/cube.mesh && build/release/bench/read_tets /tmp/cube.mesh
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "base/system_memory.hpp"
#include "crossgrain/reading.hpp"

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    double best = 1e9;
    std::size_t tets = 0;
    for (int trial = 0; trial < 5; ++trial) {
      const auto start = std::chrono::steady_clock::now();
      tets = crossgrain::read_tets(argv[i]).tets.size();
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      best = std::min(best, seconds.count());
    }
    fmt::print("{}: {} tets, {:.3f} s, file of {:.1f} MB, peak memory {:.1f} MB\n", argv[i], tets, best,
               static_cast<double>(std::filesystem::file_size(argv[i])) / 1e6,
               static_cast<double>(crossgrain::peak_memory_bytes()) / 1e6);
  }
}
