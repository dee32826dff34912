// SPDX-License-Identifier: Apache-2.0
#include "field/solved_surface.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/shapes.hpp"

namespace crossgrain {
namespace {

SolvedSurface box() {
  TriangleMesh mesh = make_box({1, 2, 3});
  SolvedSurface surface;
  surface.vertices = std::move(mesh.vertices);
  surface.triangles = std::move(mesh.triangles);
  return surface;
}

TEST(SurfaceSource, ReadsOnceAndAgainOnlyAfterAFailure) {
  int reads = 0;
  const SurfaceSource source([&] {
    if (++reads < 3) throw std::runtime_error("not now");
    return box();
  });
  EXPECT_THROW(source.get(), std::runtime_error);
  EXPECT_THROW(source.searchable(), std::runtime_error);
  const SurfaceSource copy = source;
  EXPECT_EQ(copy.searchable()->surface().size(), 12u);
  EXPECT_EQ(source.get(), copy.get());
  EXPECT_EQ(source.searchable(), copy.searchable());
  EXPECT_EQ(reads, 3);
}

TEST(SurfaceSource, WithoutTrianglesHasNothingToSearch) {
  EXPECT_EQ(SurfaceSource().get(), nullptr);
  EXPECT_EQ(SurfaceSource().searchable(), nullptr);
  EXPECT_EQ(SurfaceSource(SolvedSurface()).searchable(), nullptr);
}

}  // namespace
}  // namespace crossgrain
