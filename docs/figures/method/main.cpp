// SPDX-License-Identifier: Apache-2.0
// method_figures FOLDER: writes the figures of docs/method.md into a folder.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "method_figures.hpp"

int main(int argc, char** argv) {
  using namespace crossgrain::figures;
  if (argc != 2) {
    std::fputs("usage: method_figures FOLDER\n", stderr);
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    basis_figure().write(folder / "method-basis.png");
    frames_figure().write(folder / "method-frames.png");
    normal_figure().write(folder / "method-normal.png");
    spectra_figure().write(folder / "method-spectra.png");
    levels_figure().write(folder / "method-levels.png");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "method_figures: %s\n", error.what());
    return 1;
  }
  return 0;
}
