// SPDX-License-Identifier: Apache-2.0
#include "picture/renderer.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

constexpr Colour kWhite{1, 1, 1};

/// A box of 2 x 2 x 2 about the origin, seen from the front, its faces 100 pixels wide in the middle of 200 x
/// 200.
struct Scene {
  Drawing drawing;
  Camera camera{{-90, 0}, std::vector<Vector3>{{-2, 0, -2}, {2, 0, 2}}, {0, 0, 200, 200}, 0};
  RenderOptions options{kWhite, 0, 0.5f};

  explicit Scene(float opacity) {
    const TriangleMesh box = make_box({2, 2, 2});
    Vector3 middle{0, 0, 0};
    for (const Vector3& vertex : box.vertices) middle += 1.0 / 8 * vertex;
    DrawnMesh mesh;
    for (const Vector3& vertex : box.vertices) mesh.vertices.push_back(vertex - middle);
    mesh.triangles = box.triangles;
    mesh.colour = {0.2f, 0.4f, 0.8f};
    mesh.opacity = mesh.grazing_opacity = opacity;
    mesh.bounds_solid = true;
    drawing.meshes.push_back(mesh);
  }

  void add_rod(RodLook look = RodLook::kSolid) {
    drawing.rods.push_back({look, {{{-1.5, 0, 0}, {1.5, 0, 0}, 0.2, {1, 0, 0}}}, {}, false});
  }

  Image image() const {
    Image out(200, 200, pixel_of(kWhite));
    render(drawing, camera, options, out, {});
    return out;
  }
};

bool is_red(const Colour& colour) {
  return colour.r > colour.g + 0.2f && colour.r > colour.b + 0.1f;
}

TEST(Renderer, LeavesTheBackgroundWhereNothingIs) {
  const Image image = Scene(1).image();
  EXPECT_EQ(image.at(20, 100).colour, kWhite);
  EXPECT_EQ(image.at(100, 20).colour, kWhite);
  EXPECT_NE(image.at(100, 100).colour, kWhite);
}

TEST(Renderer, IsOpaqueOnlyWhereSomethingIs) {
  const Scene scene(1);
  Image image(200, 200);
  render(scene.drawing, scene.camera, scene.options, image, {});
  EXPECT_EQ(image.at(20, 100).opacity, 0);
  EXPECT_NEAR(image.at(100, 100).opacity, 1, 1e-6);
}

TEST(Renderer, ShowsALineThroughATranslucentPartAndNotThroughAnOpaqueOne) {
  Scene translucent(0.2f), opaque(1);
  translucent.add_rod();
  opaque.add_rod();
  EXPECT_TRUE(is_red(translucent.image().at(100, 100).colour));
  EXPECT_FALSE(is_red(opaque.image().at(100, 100).colour));
  EXPECT_TRUE(is_red(opaque.image().at(35, 100).colour)) << "it stands out of the part there";
}

TEST(Renderer, DimsASolidLineByAsMuchAsIsAllowedAndInkByAllThatIsInFront) {
  Scene solid(0.9f), ink(0.9f);
  solid.add_rod(RodLook::kSolid);
  ink.add_rod(RodLook::kInk);
  const Colour seen = ink.image().at(100, 100).colour, part = Scene(0.9f).image().at(100, 80).colour;
  EXPECT_TRUE(is_red(solid.image().at(100, 100).colour));
  EXPECT_NEAR(static_cast<double>(seen.b), 0.9 * static_cast<double>(part.b) / (1 - 0.1 * 0.1), 0.05);
}

TEST(Renderer, HasShadesBetweenAtEdges) {
  // The box's edge is at pixel 50: turned a little it runs through pixels.
  Scene scene(1);
  scene.camera = Camera({-90, 0}, std::vector<Vector3>{{-2.013, 0, -2}, {2, 0, 2}}, {0, 0, 200, 200}, 0);
  const Image image = scene.image();
  int between = 0;
  for (int x = 40; x < 60; ++x) {
    const float blue = image.at(x, 100).colour.r;
    between += blue > image.at(100, 100).colour.r + 0.02f && blue < 0.98f;
  }
  EXPECT_EQ(between, 1);
}

TEST(Renderer, SectionTakesAwayWhatIsBeforeItAndShowsTheSolid) {
  Scene scene(0.2f);
  scene.add_rod();
  Section section;
  section.normal = {0, -1, 0};
  section.offset = -0.5;  // y = 0.5, behind the rod
  section.colour_at = [](const Vector3& point, const auto& is_enclosed) -> std::optional<Colour> {
    EXPECT_NEAR(point[1], 0.5, 1e-6);
    return is_enclosed() ? std::optional<Colour>({0, 1, 0}) : std::nullopt;
  };
  scene.drawing.section = section;
  const Image image = scene.image();
  EXPECT_EQ(image.at(100, 100).colour, (Colour{0, 1, 0}));
  EXPECT_EQ(image.at(35, 100).colour, kWhite) << "the rod is before the plane";
  EXPECT_EQ(image.at(20, 20).colour, kWhite);
}

TEST(Renderer, GivesTheSameImageOnAnyNumberOfThreads) {
  Scene scene(0.3f);
  scene.add_rod();
  scene.camera = Camera({-50, 20}, std::vector<Vector3>{{-2, -2, -2}, {2, 2, 2}}, {0, 0, 200, 200}, 0);
  const auto image_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return scene.image();
  };
  const Image one = image_on(1), many = image_on(4);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) ASSERT_EQ(std::memcmp(&one.at(x, y), &many.at(x, y), sizeof(Pixel)), 0);
}

TEST(Renderer, CountsAnEdgeThatTwoTrianglesShareOnce) {
  // The diagonal of the box's front face runs through the middle: no darker than beside it.
  const Image image = Scene(0.5f).image();
  EXPECT_NEAR(static_cast<double>(image.at(100, 100).colour.r),
              static_cast<double>(image.at(90, 100).colour.r), 1e-3);
  EXPECT_NEAR(static_cast<double>(image.at(99, 99).colour.r), static_cast<double>(image.at(90, 100).colour.r),
              1e-3);
}

TEST(Renderer, EndsWhereItIsCancelled) {
  Monitor monitor;
  monitor.cancel();
  const Scene scene(1);
  Image image(200, 200);
  EXPECT_THROW(render(scene.drawing, scene.camera, scene.options, image, monitor), Error);
}

}  // namespace
}  // namespace crossgrain
