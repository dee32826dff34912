// SPDX-License-Identifier: Apache-2.0
#include "picture/face_labels.hpp"

#include <gtest/gtest.h>

#include <set>

#include "base/vector3.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

constexpr std::array<int, 2> kSize{400, 300};
constexpr double kTextSize = 12;

/// A box of 2 by 1 by 1 whose sides have the numbers 1 (-x), 2 (+x), 3, 4 (-y, +y), 5, 6 (-z, +z).
struct NumberedBox {
  TriangleMesh mesh = make_box({2, 1, 1});
  std::vector<std::int32_t> faces;

  NumberedBox() {
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vector3 normal =
          normalised(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
      for (int axis = 0; axis < 3; ++axis) {
        const double along = normal[static_cast<std::size_t>(axis)];
        if (std::abs(along) > 0.5) faces.push_back(2 * axis + (along > 0 ? 2 : 1));
      }
    }
  }

  std::vector<Label> labels(const ViewDirection& direction, const Section* section = nullptr) const {
    const Camera camera(direction, mesh.vertices, {0, 0, double{kSize[0]}, double{kSize[1]}});
    return face_labels(mesh.vertices, mesh.triangles, faces, camera, kSize, kTextSize, section);
  }
};

std::set<std::string> texts_of(const std::vector<Label>& labels) {
  std::set<std::string> texts;
  for (const Label& label : labels) texts.insert(label.text);
  return texts;
}

TEST(FaceLabels, StandOnTheFacesThatAreSeen) {
  const NumberedBox box;
  const std::vector<Label> labels = box.labels({-55, 28});
  EXPECT_EQ(texts_of(labels), (std::set<std::string>{"2", "3", "6"}));
  for (const Label& label : labels) {
    if (label.text != "3") continue;
    EXPECT_NEAR(label.place[1], -0.5, 1e-6);
    EXPECT_LT(std::abs(label.place[0]), 0.55);  // half a height from the ends
    EXPECT_NEAR(label.place[2], 0, 0.1);
  }
  EXPECT_EQ(texts_of(box.labels({90, 0})), (std::set<std::string>{"4"}));
}

TEST(FaceLabels, AreNotOnWhatACutRemovesNorOnTheInside) {
  const NumberedBox box;
  const Section section{{0, -1, 0}, 0, {}};  // removes y < 0
  EXPECT_EQ(texts_of(box.labels({-55, 28}, &section)), (std::set<std::string>{"2", "6"}));
}

TEST(FaceLabels, AreNotOnFacesTooSmallForThem) {
  NumberedBox box;
  for (Vector3& vertex : box.mesh.vertices) vertex[2] *= 0.05;
  EXPECT_EQ(texts_of(box.labels({-90, 0})), std::set<std::string>{});
}

TEST(FaceLabels, AreNotOnTrianglesOfNoFace) {
  NumberedBox box;
  std::fill(box.faces.begin(), box.faces.end(), 0);
  EXPECT_TRUE(box.labels({-55, 28}).empty());
}

TEST(FaceColours, DifferForNumbersBesideEachOther) {
  for (std::int32_t number = 1; number < 40; ++number)
    EXPECT_FALSE(colour_of_face(number) == colour_of_face(number + 1));
}

}  // namespace
}  // namespace crossgrain
