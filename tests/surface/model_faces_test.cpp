// SPDX-License-Identifier: Apache-2.0
#include "surface/model_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/vector3.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

TEST(ModelFaces, OfABoxAreItsSixSides) {
  const Surface surface = prepare_surface(make_box({4, 2, 3}));
  const std::vector<std::int32_t> numbers = face_numbers(surface, {});
  const auto faces = listed_faces(surface.mesh.vertices, surface.mesh.triangles, numbers, FaceKind::kPatch);
  ASSERT_EQ(faces.size(), 6u);
  double area = 0;
  Vector3 sum{0, 0, 0};
  for (std::size_t k = 0; k < faces.size(); ++k) {
    EXPECT_EQ(faces[k].number, static_cast<std::int64_t>(k + 1));
    EXPECT_EQ(faces[k].kind, FaceKind::kPatch);
    area += faces[k].area;
    sum += (1.0 / 6) * faces[k].centre;
  }
  EXPECT_NEAR(area, 52, 1e-12);
  const Box box = box_of_solid_triangles(surface.mesh);
  EXPECT_LT(norm(sum - 0.5 * (box.low + box.high)), 1e-12);
}

TEST(ModelFaces, KeepTheNumbersOfAMeshThatHasThem) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.faces.assign(mesh.triangles.size(), 0);
  mesh.faces[0] = mesh.faces[1] = -7;
  const Surface surface = prepare_surface(mesh);
  const auto faces =
      listed_faces(mesh.vertices, mesh.triangles, face_numbers(surface, {}), FaceKind::kTagged);
  ASSERT_EQ(faces.size(), 1u);  // 0 is no face
  EXPECT_EQ(faces[0].number, -7);
}

TEST(ModelFaces, OfASoupAreNotListed) {
  TriangleMesh soup;
  for (std::uint32_t k = 0; k <= kMostListedFaces; ++k) {
    const double x = k;
    soup.vertices.insert(soup.vertices.end(), {{x, 0, 0}, {x + 0.5, 0, 0}, {x, 0.5, 0}});
    soup.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  const Surface surface = prepare_surface(soup);
  const std::vector<std::int32_t> numbers = face_numbers(surface, {});
  EXPECT_EQ(numbers, std::vector<std::int32_t>(soup.triangles.size(), 0));
}

TEST(ModelFaces, ABoxHasItsVolumeAndAreaAnywhere) {
  const ModelSize size = size_of({{1e6, 0, 0}, {1e6 + 1, 0, 0}, {1e6, 1, 0}, {1e6, 0, 1}},
                                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  EXPECT_NEAR(size.volume, 1.0 / 6, 1e-12);
  EXPECT_NEAR(size.area, 1.5 + std::sqrt(3.0) / 2, 1e-9);
}

}  // namespace
}  // namespace crossgrain
