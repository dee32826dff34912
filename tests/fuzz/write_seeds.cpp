// SPDX-License-Identifier: Apache-2.0
// Writes the made inputs of each reader to FOLDER/READER/made-N, for run.py. Usage: crossgrain_fuzz_seeds
// FOLDER
#include <filesystem>
#include <fstream>
#include <string>

#include "fuzz/made_inputs.hpp"
#include "fuzz/reader_checks.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  for (const crossgrain::ReaderUnderTest& reader : crossgrain::readers_under_test()) {
    const std::filesystem::path folder = std::filesystem::path(argv[1]) / reader.name;
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& input : crossgrain::made_inputs(reader.name))
      std::ofstream(folder / ("made-" + std::to_string(number++)), std::ios::binary) << input;
  }
}
