// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "fuzz/made_inputs.hpp"
#include "mesh_files/surface_files.hpp"

namespace crossgrain {
namespace {

constexpr const char* kCorners[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};

std::string binary_stl() {
  std::string out(80, ' ');
  append_bytes(out, static_cast<std::uint32_t>(tetrahedron().size()));
  for (const auto& triangle : tetrahedron()) {
    for (int i = 0; i < 3; ++i) append_bytes(out, 0.0f);
    for (const Vector3& corner : triangle)
      for (const double x : corner) append_bytes(out, static_cast<float>(x));
    append_bytes(out, std::uint16_t{0});
  }
  return out;
}

std::string text_stl() {
  std::string out = "solid a\n";
  for (const auto& triangle : tetrahedron()) {
    out += "facet normal 0 0 1\n outer loop\n";
    for (const auto& [x, y, z] : triangle) out += fmt::format("  vertex {} {} {:e}\n", x, y, z);
    out += " endloop\nendfacet\n";
  }
  return out + "endsolid a\n";
}

template <class Index>
std::string binary_ply(bool swapped) {
  std::string out = fmt::format(
      "ply\nformat binary_{}_endian 1.0\ncomment made\nelement vertex 4\nproperty double x\nproperty float "
      "y\n"
      "property int z\nproperty list uchar short w\nelement face 3\nproperty uchar red\n"
      "property list {} vertex_indices\nelement edge 1\nproperty ushort a\nend_header\n",
      swapped ? "big" : "little", sizeof(Index) == 1 ? "char uchar" : "uint int");
  for (int i = 0; i < 4; ++i) {
    append_bytes(out, i == 1 ? 1.0 : 0.0, swapped);
    append_bytes(out, i == 2 ? 1.0f : 0.0f, swapped);
    append_bytes(out, std::int32_t{i == 3}, swapped);
    append_bytes(out, static_cast<std::uint8_t>(i % 2));
    if (i % 2 == 1) append_bytes(out, std::int16_t{-1}, swapped);
  }
  for (const std::vector<int>& face : {std::vector{0, 1, 2, 3}, {0, 3, 2}, {1, 2, 3}}) {
    append_bytes(out, std::uint8_t{9});
    append_bytes(out, static_cast<Index>(face.size()), swapped);
    for (const int corner : face) append_bytes(out, static_cast<Index>(corner), swapped);
  }
  append_bytes(out, std::uint16_t{7}, swapped);
  return out;
}

}  // namespace

std::vector<std::string> made_stl() {
  return {text_stl(), binary_stl()};
}

std::vector<std::string> made_obj() {
  std::string corners;
  for (const char* corner : kCorners) corners += fmt::format("v {}\n", corner);
  return {corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
          "# made\nmtllib a.mtl\n" + corners +
              "vt 0 1\nvn 0 0 1\ng b\nf -4/1/1 -2//1 -3/1 \\\n 4\ns off\nl 1 2\n",
          // A polygon that is not convex, before its corners, and one that folds back on itself.
          "f 1 2 3 4 5\nv 0 0 0\nv 4 0 0\nv 4 4 0 1 0 0\nv 2 1 0\nv 0 4 0\nf 1 2 1 2 3\nf 1 3 2 5 4 1\n"};
}

std::vector<std::string> made_ply() {
  std::string text =
      "ply\nformat ascii 1.0\nobj_info b\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "float z\n"
      "property uchar red\nelement face 2\nproperty list uchar int vertex_index\nend_header\n";
  for (const char* corner : kCorners) text += fmt::format("{} 7\n", corner);
  return {text + "3 0 1 2\n4 0 1 2 3\n", binary_ply<std::uint8_t>(false), binary_ply<std::int32_t>(false),
          binary_ply<std::uint8_t>(true), binary_ply<std::int32_t>(true)};
}

std::vector<std::string> made_off() {
  std::string vertices, coloured;
  for (const char* corner : kCorners) {
    vertices += fmt::format("{}\n", corner);
    coloured += fmt::format("{} 0.5 0.5 0.5 1\n", corner);
  }
  return {"OFF\n4 2 0\n" + vertices + "3 0 1 2\n4 0 1 2 3\n",
          "COFF # made\n\n4 2\n" + coloured + "3 0 1 2 255 0 0\n3 0 2 3\n", "4 1 0\n" + vertices + "3 1 2 3",
          "OFF4 1 0\n" + vertices + "5 0 1 2 1 3\n"};
}

}  // namespace crossgrain
