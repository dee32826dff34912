// SPDX-License-Identifier: Apache-2.0
// Samples a field from C++, for bench/python_sampling.py: prints the seconds of sampling.
//
//   sampling_time FIELD POINTS THREADS     POINTS holds three doubles each
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

#include "crossgrain/crossgrain.hpp"

int main(int argc, char** argv) {
  using namespace crossgrain;
  using Clock = std::chrono::steady_clock;
  if (argc != 4) return 2;
  const FrameField field = read_field(argv[1]);
  std::ifstream file(argv[2], std::ios::binary | std::ios::ate);
  std::vector<Vector3> points(static_cast<std::size_t>(file.tellg()) / sizeof(Vector3));
  file.seekg(0).read(reinterpret_cast<char*>(points.data()),
                     static_cast<std::streamsize>(points.size() * sizeof(Vector3)));
  const ThreadLimit limit(std::atoi(argv[3]));
  static_cast<void>(field.sample(points.front()));  // prepares the field
  std::vector<FrameField::Sample> samples(points.size());
  const auto start = Clock::now();
  field.sample(points, samples);
  std::printf("%.4f\n", std::chrono::duration<double>(Clock::now() - start).count());
}
