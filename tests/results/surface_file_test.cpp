// SPDX-License-Identifier: Apache-2.0
#include "results/surface_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "files/temporary_folder.hpp"
#include "results/sample_field.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

/// A tetrahedron with a vertex of no triangle, a crease of three points and a closed one.
SolvedSurface made_surface() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1.0 / 3, 0}, {1e5, 0.1, 7}, {0, 0, -1e-9}},
          {{0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}},
          {{{0, 0, 0}, {1, 0, 0}, {0, 1.0 / 3, 0}}, {{0, 0, -1e-9}, {0, 0, 0}, {1, 0, 0}, {0, 0, -1e-9}}}};
}

FieldData with_surface(SolvedSurface surface) {
  FieldData data = sample_data(Degree::kFour);
  data.surface = SurfaceSource(std::move(surface));
  return data;
}

void expect_same(const SolvedSurface& a, const SolvedSurface& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.creases, b.creases);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.interfaces, b.interfaces);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.interface_regions, b.interface_regions);
}

TEST(SurfaceFile, GivesTheSurfaceBackToTheBit) {
  const TemporaryFolder folder;
  write_field(field_of(with_surface(made_surface())), folder.path());
  const auto read = read_field(folder.path()).data().surface.get();
  ASSERT_NE(read, nullptr);
  expect_same(*read, made_surface());
}

TEST(SurfaceFile, KeepsTheSolidsAndTheFacesBetweenThem) {
  const TemporaryFolder folder;
  SolvedSurface surface = made_surface();
  surface.regions = {7, 7, -1, 0};
  surface.interfaces = {{0, 1, 3}, {1, 2, 3}};
  surface.interface_regions = {{7, -1}, {0, 7}};
  write_field(field_of(with_surface(surface)), folder.path());
  expect_same(*read_field(folder.path()).data().surface.get(), surface);
}

TEST(SurfaceFile, KeepsTheNumbersOfFaces) {
  const TemporaryFolder folder;
  SolvedSurface surface = made_surface();
  surface.faces = {3, -1, 0, 12};
  surface.regions = {7, 7, -1, 0};
  surface.interfaces = {{0, 1, 3}};
  surface.interface_regions = {{7, -1}};
  write_field(field_of(with_surface(surface)), folder.path());
  expect_same(*read_field(folder.path()).data().surface.get(), surface);
}

TEST(SurfaceFile, MayHaveNoCreases) {
  const TemporaryFolder folder;
  SolvedSurface surface = made_surface();
  surface.creases.clear();
  write_field(field_of(with_surface(surface)), folder.path());
  expect_same(*read_field(folder.path()).data().surface.get(), surface);
}

TEST(SurfaceFile, HasTrianglesAndThenPolylines) {
  const TemporaryFolder folder;
  write_field(field_of(with_surface(made_surface())), folder.path());
  const VtuFile file(folder.path() / "surface.vtu");
  EXPECT_EQ(file.points(), 5u + 3 + 4);
  EXPECT_EQ(file.read<std::uint8_t>(VtuSection::kCells, "types", 1),
            (std::vector<std::uint8_t>{5, 5, 5, 5, 4, 4}));
  EXPECT_EQ(file.read<std::int32_t>(VtuSection::kCells, "offsets", 1),
            (std::vector<std::int32_t>{3, 6, 9, 12, 15, 19}));
}

TEST(SurfaceFile, GoesOnFromAFieldThatWasReadEvenWhereItsFolderIsGone) {
  const TemporaryFolder folder;
  write_field(field_of(with_surface(made_surface())), folder.path() / "first");
  const FrameField field = read_field(folder.path() / "first");
  std::filesystem::remove_all(folder.path() / "first");
  write_field(field, folder.path() / "second");
  expect_same(*read_field(folder.path() / "second").data().surface.get(), made_surface());
}

TEST(SurfaceFile, IsRemovedByAFieldWithoutASurface) {
  const TemporaryFolder folder;
  write_field(field_of(with_surface(made_surface())), folder.path());
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "surface.vtu"));
  write_field(field_of(sample_data(Degree::kFour)), folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "surface.vtu"));
  EXPECT_EQ(read_field(folder.path()).data().surface.get(), nullptr);
}

TEST(SurfaceFile, OfAnotherKindIsRefusedWhenItIsAskedFor) {
  const TemporaryFolder folder;
  write_field(field_of(sample_data(Degree::kFour)), folder.path());
  std::filesystem::copy_file(folder.path() / "field.vtu", folder.path() / "surface.vtu");
  const FrameField field = read_field(folder.path());
  EXPECT_TRUE(field.sample({0, 0, 0}).frame.axes[0][0] < 2) << "no one has asked for the surface";
  try {
    field.data().surface.get();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(std::string(error.what()).find("surface.vtu"), std::string::npos) << error.what();
  }
}

TEST(SurfaceFile, HasTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    write_field(field_of(with_surface(made_surface())), folder.path() / std::to_string(threads));
  }
  EXPECT_TRUE(content_of(folder.path() / "1" / "surface.vtu") ==
              content_of(folder.path() / "3" / "surface.vtu"));
}

}  // namespace
}  // namespace crossgrain
