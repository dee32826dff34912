// SPDX-License-Identifier: Apache-2.0
#include "page/page_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/page.hpp"
#include "crossgrain/solve.hpp"
#include "field/solved_surface.hpp"
#include "measure/made_tets.hpp"
#include "mesh_files/made_bricks.hpp"
#include "page/scene_hexahedra.hpp"
#include "page/scene_tets.hpp"
#include "singularity/axis_names.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// Frames on rings around a line of index 1/4, with links around the rings and between them.
struct Rings {
  std::vector<Quaternion> frames;
  std::vector<FrameLink> links;
};

Rings rings_of_a_quarter() {
  constexpr std::uint32_t kAround = 24, kRings = 4;
  Rings rings;
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t k = 0; k < kAround; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5) / kAround, turn = 0.25 * angle / 2;
      rings.frames.push_back({std::cos(turn), 0, 0, std::sin(turn)});
      const std::uint32_t here = ring * kAround + k;
      const double arc = 2 * std::numbers::pi * (ring + 1) / kAround;
      rings.links.push_back({here, ring * kAround + (k + 1) % kAround, arc, 1});
      if (ring > 0) rings.links.push_back({here - kAround, here, 1, arc});
    }
  }
  return rings;
}

TEST(AxisNames, HaveTheSeamsThatThePageFinds) {
  // viewer/tests/cut.test.mjs has the same.
  const auto [frames, links] = rings_of_a_quarter();
  const std::vector<AxisNames> names = name_axes(frames, links, 0);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> seams;
  for (const std::uint32_t k : seams_of(names, frames, links)) seams.emplace_back(links[k].a, links[k].b);
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> expected{{11, 12}, {35, 36}, {59, 60}, {83, 84}};
  EXPECT_EQ(seams, expected);
}

TetFrameField field_on_tets(TetMesh mesh = tet_box({3, 3, 3})) {
  SolveOptions options;
  options.resolution = 8;
  return solve_onto(TetDomain(std::move(mesh)), options);
}

nlohmann::json header_of(const std::string& bytes) {
  std::uint32_t length = 0;
  std::copy_n(bytes.data() + 8, sizeof length, reinterpret_cast<char*>(&length));
  return nlohmann::json::parse(bytes.substr(12, length));
}

TEST(PageScene, OfTetsHasAllOfThemWhereThereAreFew) {
  const TetFrameField field = field_on_tets();
  SceneWriter scene;
  EXPECT_TRUE(add_tets(ShownField(field), {0, 0, 0}, 6 * 27, 1000, {}, scene));
  const nlohmann::json header = header_of(scene.bytes());
  EXPECT_EQ(header["tets"]["shown"], 6 * 27);
  EXPECT_EQ(header["arrays"]["tet_corners"]["shape"][0], 6 * 27);
  EXPECT_EQ(header["arrays"]["tet_points"]["shape"][0], 4 * 4 * 4);
}

TEST(PageScene, OfTooManyTetsHasCellsThatCoverTheSolid) {
  const TetFrameField field = field_on_tets();
  for (const std::size_t most : {300u, 3000u}) {
    SceneWriter scene;
    EXPECT_FALSE(add_tets(ShownField(field), {0, 0, 0}, 6 * 27 - 1, most, {}, scene));
    const nlohmann::json header = header_of(scene.bytes());
    EXPECT_EQ(header["tets"]["total"], 6 * 27);
    EXPECT_EQ(header["tets"]["shown"], 0);
    const auto cells = header["cells"]["shown"].get<double>();
    EXPECT_LE(cells, static_cast<double>(most));
    const double volume = cells * std::pow(header["cells"]["unit"].get<double>(), 3);
    const Box& box = field.domain().data().box;
    double solid = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) solid *= box.high[axis] - box.low[axis];
    EXPECT_GE(volume, 0.9 * solid);
    EXPECT_LE(volume, 1.6 * solid);
  }
}

TEST(PageScene, HasTheFacesBetweenRegionsOfTetsAndOfTheGrid) {
  TetMesh mesh = tet_box({2, 2, 2});
  for (const auto& tet : mesh.tets) {
    double middle = 0;
    for (const std::uint32_t vertex : tet) middle += mesh.vertices[vertex][0] / 4;
    mesh.regions.push_back(middle < 1 ? 1 : 2);
  }
  const nlohmann::json arrays = header_of(page_scene(field_on_tets(std::move(mesh))))["arrays"];
  EXPECT_EQ(arrays["interface_triangles"]["shape"][0], 4 * 2);
  EXPECT_EQ(arrays["interface_vertices"]["shape"][0], 3 * 3);
  EXPECT_GE(arrays["grid_interface_triangles"]["shape"][0], 4 * 2);
  EXPECT_FALSE(header_of(page_scene(field_on_tets()))["arrays"].contains("interface_triangles"));
}

/// What follows the header of a scene.
const char* data_of(const std::string& bytes) {
  std::uint32_t length = 0;
  std::copy_n(bytes.data() + 8, sizeof length, reinterpret_cast<char*>(&length));
  return bytes.data() + 12 + length;
}

/// A u32 array of a scene.
std::vector<std::uint32_t> numbers_in(const std::string& bytes, const char* name) {
  const nlohmann::json array = header_of(bytes)["arrays"][name];
  std::vector<std::uint32_t> numbers(array["shape"][0].get<std::size_t>());
  std::memcpy(numbers.data(), data_of(bytes) + array["offset"].get<std::size_t>(),
              numbers.size() * sizeof numbers[0]);
  return numbers;
}

TEST(PageScene, TellsTheFaceOfEachTriangle) {
  SolveOptions options;
  options.resolution = 8;
  const FrameField field = solve(make_box({1, 1, 1}), options);
  const std::vector<std::uint32_t> faces = numbers_in(page_scene(field), "surface_face");
  ASSERT_EQ(faces.size(), field.data().surface.get()->triangles.size());
  EXPECT_EQ(std::set<std::uint32_t>(faces.begin(), faces.end()), (std::set<std::uint32_t>{1, 2, 3, 4, 5, 6}));
}

TEST(PageScene, TellsTheFacesOfHexahedra) {
  HexMesh mesh = made_bricks({1, 1, 2}, {1, 1, 2});
  SceneWriter scene;
  add_hexahedra(mesh, {0, 0, 0}, 2, scene);
  const nlohmann::json array = header_of(scene.bytes())["arrays"]["hex_face"];
  EXPECT_EQ(array["shape"], (nlohmann::json{2, 6}));
  EXPECT_EQ(array["type"], "u32");
  // Bottom, top, -y, +x, +y, -x of the lower one, then the bottom of the upper one.
  std::vector<std::uint32_t> faces(7);
  std::memcpy(faces.data(), data_of(scene.bytes()) + array["offset"].get<std::size_t>(), 7 * sizeof faces[0]);
  EXPECT_EQ(faces, (std::vector<std::uint32_t>{15, 0, 13, 12, 14, 11, 0}));
  for (HexMesh::Face& face : mesh.boundary) face.tag = 0;
  SceneWriter untagged;
  add_hexahedra(mesh, {0, 0, 0}, 2, untagged);
  EXPECT_EQ(header_of(untagged.bytes())["arrays"]["hex_face"]["shape"][0], 0);
}

TEST(PageScene, TellsTheRegionsOfHexahedraWhereThereAreSeveral) {
  HexMesh mesh = made_bricks({1, 1, 3}, {1, 1, 3});
  const auto header_with = [&](std::vector<std::int32_t> regions) {
    mesh.regions = std::move(regions);
    SceneWriter scene;
    add_hexahedra(mesh, {0, 0, 0}, 3, scene);
    return header_of(scene.bytes());
  };
  const nlohmann::json header = header_with({8, 3, 8});
  EXPECT_EQ(header["hex_regions"], (nlohmann::json{3, 8}));
  EXPECT_EQ(header["arrays"]["hex_region"]["shape"][0], 3);
  EXPECT_EQ(header["arrays"]["hex_region"]["type"], "u16");
  SceneWriter scene;
  add_hexahedra(mesh, {0, 0, 0}, 3, scene);
  const std::string bytes = scene.bytes();
  std::vector<std::uint16_t> places(3);
  std::memcpy(places.data(), data_of(bytes) + header["arrays"]["hex_region"]["offset"].get<std::size_t>(),
              3 * sizeof places[0]);
  EXPECT_EQ(places, (std::vector<std::uint16_t>{1, 0, 1}));
  EXPECT_FALSE(header_with({3, 3, 3}).contains("hex_regions"));
  EXPECT_FALSE(header_with({}).contains("hex_regions"));
}

TEST(PageScene, HasAllHexahedraWhereThereAreFew) {
  const HexMesh mesh = made_bricks({4, 3, 2}, {4, 3, 2});
  SceneWriter scene;
  add_hexahedra(mesh, {0, 0, 0}, 24, scene);
  const nlohmann::json header = header_of(scene.bytes());
  EXPECT_EQ(header["hexahedra"],
            (nlohmann::json{{"total", 24}, {"shown", 24}, {"inverted", 0}, {"mean", 1.0}}));
  EXPECT_EQ(header["arrays"]["hex_corners"]["shape"], (nlohmann::json{24, 8}));
  EXPECT_EQ(header["arrays"]["hex_points"]["shape"], (nlohmann::json{60, 3}));
  EXPECT_FALSE(header["arrays"].contains("hex_number"));
}

TEST(PageScene, HasOfManyHexahedraThoseAtTheSurfaceThenTheWorst) {
  HexMesh mesh = made_bricks({6, 6, 6}, {6, 6, 6});
  // A vertex in the middle moves: the eight hexahedra around it are inside and the worst.
  const std::uint32_t moved = 3 + 7 * (3 + 7 * 3);
  mesh.vertices[moved][0] += 0.4;
  std::vector<std::uint32_t> expected;
  for (std::uint32_t h = 0; h < mesh.hexahedra.size(); ++h) {
    const auto at = [&](std::uint32_t axis) { return h / (axis == 0 ? 1 : axis == 1 ? 6 : 36) % 6; };
    const auto is_edge = [&](std::uint32_t axis) { return at(axis) == 0 || at(axis) == 5; };
    const bool is_around = std::ranges::count(mesh.hexahedra[h], moved) > 0;
    if (is_edge(0) || is_edge(1) || is_edge(2) || is_around) expected.push_back(h);
  }
  ASSERT_EQ(expected.size(), 216u - 64 + 8);
  SceneWriter scene;
  add_hexahedra(mesh, {0, 0, 0}, expected.size(), scene);
  EXPECT_EQ(numbers_in(scene.bytes(), "hex_number"), expected);
  EXPECT_EQ(header_of(scene.bytes())["hexahedra"]["total"], 216);
}

TEST(PageScene, HasHexahedraBesideTheirFieldAndElseNothingOfThem) {
  const HexMesh mesh = made_bricks({3, 3, 3}, {3, 3, 3});
  EXPECT_TRUE(header_of(page_scene(field_on_tets(), &mesh)).contains("hexahedra"));
  EXPECT_FALSE(header_of(page_scene(field_on_tets())).contains("hexahedra"));
  const HexMesh none;
  EXPECT_FALSE(header_of(page_scene(field_on_tets(), &none)).contains("hexahedra"));
}

/// Bricks in a box of 2 x 2 x 4, with its surface.
FittedHexahedra bricks_in_a_box() {
  TriangleMesh box = make_box({2, 2, 4});
  FittedHexahedra fitted{made_bricks({2, 2, 4}, {2, 2, 4}), {}, {}};
  fitted.report.model.bounding_box = {{0, 0, 0}, {2, 2, 4}};
  SolvedSurface surface{box.vertices, box.triangles, {{{0, 0, 0}, {2, 0, 0}}}};
  for (std::size_t k = 0; k < box.triangles.size(); ++k)
    surface.faces.push_back(static_cast<std::int32_t>(k / 2 + 1));
  fitted.surface = std::make_shared<const SolvedSurface>(std::move(surface));
  return fitted;
}

TEST(PageScene, OfHexahedraWithoutAFieldHasTheSurfaceOfTheirModelAndNoCells) {
  const std::string bytes = page_scene(bricks_in_a_box());
  const nlohmann::json header = header_of(bytes);
  for (const char* name : {"cells", "tets", "regions"}) EXPECT_FALSE(header.contains(name)) << name;
  for (const char* name : {"cell_corner", "tet_corners", "arc_points", "streamline_points", "form_cell"})
    EXPECT_FALSE(header["arrays"].contains(name)) << name;
  EXPECT_EQ(header["hexahedra"]["total"], 16);
  EXPECT_EQ(header["origin"], (nlohmann::json{1, 1, 2}));
  EXPECT_EQ(header["surface"]["triangles_shown"], 12);
  EXPECT_EQ(header["arrays"]["crease_starts"]["shape"][0], 2);
  EXPECT_EQ(numbers_in(bytes, "surface_face"),
            (std::vector<std::uint32_t>{1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6}));
}

TEST(PageScene, OfHexahedraBeginsWithTheCutThatShowsMost) {
  EXPECT_EQ(header_of(page_scene(bricks_in_a_box()))["first_cut"], "y");
  FittedHexahedra flat{made_bricks({4, 4, 1}, {4, 4, 1}), {}, bricks_in_a_box().surface};
  flat.report.model.bounding_box = {{0, 0, 0}, {4, 4, 1}};
  EXPECT_EQ(header_of(page_scene(flat))["first_cut"], "z");
}

TEST(PageScene, OfHexahedraNeedsTheSurfaceOfTheirModel) {
  FittedHexahedra fitted = bricks_in_a_box();
  EXPECT_EQ(page_of(fitted).name, kPageFile);
  fitted.surface.reset();
  EXPECT_THROW(page_of(fitted), Error);
}

TEST(PageScene, OfTetsIsTheSameForTheSameField) {
  EXPECT_EQ(page_scene(field_on_tets()), page_scene(field_on_tets()));
}

}  // namespace
}  // namespace crossgrain
