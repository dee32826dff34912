// SPDX-License-Identifier: Apache-2.0
// Solves for a cube with an installed Crossgrain: the headers, the library and all that it links must be
// there. With a FILE it says what reading that gives.
#include <cmath>
#include <crossgrain/crossgrain.hpp>
#include <cstdio>

namespace {

crossgrain::TriangleMesh cube() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
          {{0, 3, 1},
           {0, 2, 3},
           {4, 5, 7},
           {4, 7, 6},
           {0, 1, 5},
           {0, 5, 4},
           {2, 7, 3},
           {2, 6, 7},
           {0, 6, 2},
           {0, 4, 6},
           {1, 3, 7},
           {1, 7, 5}}};
}

/// Whether eight hexahedra fill the cube of tets.
bool fills_a_cube(const crossgrain::SolveOptions& solve) {
  const crossgrain::TetMesh tets{
      cube().vertices, {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
  crossgrain::HexMeshingOptions options;
  options.hexahedra.cells = 2;
  options.solve = solve;
  return crossgrain::make_hexahedra(crossgrain::TetDomain(tets), options).mesh.hexahedra.size() == 8;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) {
    try {
      std::printf("%zu triangles\n", crossgrain::read_surface(argv[1]).triangles.size());
    } catch (const crossgrain::Error& error) {
      std::printf("%s\n", error.what());
    }
    return 0;
  }
  crossgrain::SolveOptions options;
  options.resolution = 8;
  const crossgrain::FrameField field = crossgrain::solve(cube(), options);
  const crossgrain::Frame frame = field.sample({0.5, 0.5, 0.5}).frame;
  std::printf("crossgrain %s\n", crossgrain::kVersion);

  // In a cube every axis of every frame is one of x, y and z.
  for (const crossgrain::Vector3& axis : frame.axes) {
    if (std::fmax(std::fmax(std::fabs(axis[0]), std::fabs(axis[1])), std::fabs(axis[2])) < 0.999) return 1;
  }
  return fills_a_cube(options) ? 0 : 1;
}
