// SPDX-License-Identifier: Apache-2.0
#include "surface/mending.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "crossgrain/error.hpp"
#include "surface/bvh.hpp"
#include "surface/damage.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {
namespace {

std::size_t count_of(const MendedSurface& mended, FindingKind kind) {
  const Finding* finding = find(mended.findings, kind);
  return finding == nullptr ? 0 : finding->count;
}

/// Share of random points in the box of `clean` that the mended surface puts on the other side than `clean`.
double misplaced_share(const MendedSurface& mended, const TriangleMesh& clean, std::mt19937& random) {
  const Surface surface = prepare_surface(clean);
  const TriangleBvh bvh(surface), mended_bvh(mended.surface);
  const WindingNumber winding(bvh), mended_winding(mended_bvh);
  const Vector3 size = surface.box.high - surface.box.low;
  constexpr int kPoints = 4000;
  int misplaced = 0;
  for (int k = 0; k < kPoints; ++k) {
    Vector3 p = surface.box.low;
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] += size[axis] * std::uniform_real_distribution<double>()(random);
    misplaced += winding.inside(p) != mended_winding.inside(p);
  }
  return static_cast<double>(misplaced) / kPoints;
}

std::string refusal_of(const TriangleMesh& mesh) {
  try {
    mend_surface(mesh);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    return error.what();
  }
  return "";
}

/// A sphere with a spherical void.
TriangleMesh make_shell() {
  return join_meshes(make_sphere(1, 3), flip_mesh(make_sphere(0.6, 2)));
}

TEST(Mending, LeavesAClosedSurfaceAsItIs) {
  std::mt19937 random(1);
  for (const TriangleMesh& mesh :
       {make_bracket(24), make_shell(), make_plates(0.1), flip_mesh(make_torus(0.6, 0.25, 24, 12))}) {
    const TriangleMesh placed = put_anywhere(mesh, random);
    const MendedSurface mended = mend_surface(placed);
    EXPECT_EQ(mended.surface.mesh.vertices, placed.vertices);
    EXPECT_EQ(mended.surface.mesh.triangles, placed.triangles);
    EXPECT_TRUE(mended.closed);
  }
}

TEST(Mending, FindsNothingWrongWithSoundParts) {
  for (const TriangleMesh& mesh : {make_bracket(24), make_shell(), make_plates(0.1), make_box_with_hole(20)})
    EXPECT_TRUE(mend_surface(mesh).findings.empty());
}

TEST(Mending, TurnsFlippedFacetsAndCountsThem) {
  std::mt19937 random(2);
  for (const TriangleMesh& mesh : {make_bracket(24), make_shell(), make_cylinder(0.5, 0.7, 24, 6)}) {
    std::size_t turned = 0;
    const TriangleMesh placed = put_anywhere(mesh, random);
    const MendedSurface mended = mend_surface(with_flips(placed, 0.1, random, turned));
    EXPECT_EQ(count_of(mended, FindingKind::kFlippedFacet), turned);
    EXPECT_EQ(mended.findings.size(), 1u);
    EXPECT_TRUE(mended.closed);
    EXPECT_FALSE(mended.topology.watertight);
    EXPECT_EQ(misplaced_share(mended, placed, random), 0);
  }
}

TEST(Mending, FindsTheInsideOfASurfaceFlippedAtRandom) {
  std::mt19937 random(3);
  for (const TriangleMesh& mesh : {make_bracket(24), make_shell()}) {
    std::size_t turned = 0;
    const MendedSurface mended = mend_surface(with_flips(mesh, 0.5, random, turned));
    EXPECT_EQ(misplaced_share(mended, mesh, random), 0);
  }
}

TEST(Mending, TurnsNormalsAtCornersWithTheirTriangle) {
  TriangleMesh mesh = make_sphere(1, 2);
  for (const auto& [a, b, c] : mesh.triangles)
    mesh.corner_normals.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  turn_triangle(mesh, 5);
  const Surface surface = mend_surface(mesh).surface;
  for (std::size_t t = 0; t < surface.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_GT(dot(surface.mesh.corner_normals[t][k], surface.mesh.vertices[surface.mesh.triangles[t][k]]),
                0.9);
  }
}

TEST(Mending, TurnsAPartThatIsInsideOutBesideOthers) {
  std::mt19937 random(4);
  const TriangleMesh left = make_box({1, 1, 1}), right = translate_mesh(make_box({1, 1, 1.1}), {1.5, 0, 0});
  const MendedSurface mended = mend_surface(join_meshes(flip_mesh(left), right));
  EXPECT_EQ(count_of(mended, FindingKind::kInsideOutPart), 1u);
  EXPECT_EQ(misplaced_share(mended, join_meshes(left, right), random), 0);
}

TEST(Mending, TellsOfASurfaceThatIsInsideOutAsAWholeAndKeepsItsVoids) {
  std::mt19937 random(5);
  const MendedSurface mended = mend_surface(flip_mesh(make_shell()));
  EXPECT_EQ(count_of(mended, FindingKind::kInsideOutPart), 2u);
  EXPECT_EQ(misplaced_share(mended, make_shell(), random), 0);
}

TEST(Mending, KeepsASolidInsideASolidAsAUnion) {
  std::mt19937 random(6);
  const TriangleMesh nested = join_meshes(make_sphere(1, 3), make_sphere(0.5, 2));
  EXPECT_EQ(misplaced_share(mend_surface(nested), make_sphere(1, 3), random), 0);
}

TEST(Mending, ClosesHolesAndCountsThem) {
  std::mt19937 random(7);
  const TriangleMesh placed = put_anywhere(make_sphere(1, 4), random);
  TriangleMesh holed = placed;
  for (const std::size_t t : {2000u, 1000u, 17u})
    holed.triangles.erase(holed.triangles.begin() + static_cast<std::ptrdiff_t>(t));
  const MendedSurface mended = mend_surface(holed);
  EXPECT_EQ(count_of(mended, FindingKind::kHole), 3u);
  EXPECT_GT(*find(mended.findings, FindingKind::kHole)->length, 0);
  EXPECT_FALSE(mended.closed);
  EXPECT_LT(misplaced_share(mended, placed, random), 0.002);
}

TEST(Mending, SaysWhereAHoleIs) {
  TriangleMesh mesh = make_sphere(1, 4);
  const auto [a, b, c] = mesh.triangles[700];
  mesh.triangles.erase(mesh.triangles.begin() + 700);
  const MendedSurface mended = mend_surface(mesh);
  const Finding* hole = find(mended.findings, FindingKind::kHole);
  ASSERT_NE(hole, nullptr);
  const Vector3 middle = (1.0 / 3) * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]);
  EXPECT_LT(norm(hole->place - middle), 1e-12);
}

TEST(Mending, JoinsASoupWhoseCornersAreEqual) {
  const MendedSurface mended = mend_surface(to_soup(make_bracket(24)));
  EXPECT_TRUE(mended.findings.empty());
  EXPECT_TRUE(mended.topology.watertight);
}

TEST(Mending, FollowsASoupWhoseCornersAreNearlyEqualEvenWithFlips) {
  std::mt19937 random(8);
  const TriangleMesh part = make_cylinder(0.5, 0.7, 24, 6);
  const TriangleMesh soup = jittered_soup(part, 1e-5, random);
  for (const double share : {0.0, 0.1}) {
    std::size_t turned = 0;
    const MendedSurface mended = mend_surface(with_flips(soup, share, random, turned));
    EXPECT_EQ(count_of(mended, FindingKind::kTriangleSoup), part.triangles.size());
    EXPECT_EQ(count_of(mended, FindingKind::kFlippedFacet), turned);
    EXPECT_GT(count_of(mended, FindingKind::kCrack), 0u);
    EXPECT_EQ(count_of(mended, FindingKind::kHole), 0u);
    EXPECT_LT(misplaced_share(mended, part, random), 0.001);
  }
}

TEST(Mending, CountsTheEdgesOfACrackWithAVertexOnOneSideOnly) {
  // A tetrahedron with a vertex in the middle of an edge, off by a little, on one side of it only.
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {.5, 1e-5, 0}},
                          {{0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const MendedSurface mended = mend_surface(mesh);
  EXPECT_EQ(count_of(mended, FindingKind::kCrack), 3u);
  EXPECT_EQ(count_of(mended, FindingKind::kHole), 0u);
  EXPECT_LT(*find(mended.findings, FindingKind::kCrack)->length, 1.1e-5);
}

TEST(Mending, DropsDuplicatesHoweverTheyAreTurned) {
  std::mt19937 random(9);
  const TriangleMesh part = make_bracket(24);
  for (const double share : {0.0, 0.1, 0.5}) {
    std::size_t turned = 0;
    const MendedSurface mended = mend_surface(with_flips(join_meshes(part, part), share, random, turned));
    EXPECT_EQ(count_of(mended, FindingKind::kDuplicatedTriangle), part.triangles.size());
    EXPECT_EQ(mended.surface.size(), part.triangles.size());
    EXPECT_TRUE(mended.closed);
    EXPECT_EQ(misplaced_share(mended, part, random), 0);
  }
}

TEST(Mending, KeepsTheWallBetweenTwoPartsThatTouch) {
  std::mt19937 random(10);
  const TriangleMesh box = make_box({1, 1, 1});
  TriangleMesh mirrored = box;
  for (Vector3& p : mirrored.vertices) p[0] = 1 - p[0];
  const MendedSurface mended = mend_surface(join_meshes(box, flip_mesh(mirrored)));
  EXPECT_EQ(count_of(mended, FindingKind::kInternalSheet), 2u);
  EXPECT_EQ(count_of(mended, FindingKind::kDuplicatedTriangle), 0u);
  EXPECT_EQ(mended.surface.size(), 24u);
  EXPECT_TRUE(mended.closed);
  EXPECT_EQ(misplaced_share(mended, translate_mesh(make_box({2, 1, 1}), {0.5, 0, 0}), random), 0);
}

TEST(Mending, LeavesOutWhatBoundsNothing) {
  std::mt19937 random(11);
  const TriangleMesh box = make_box({1, 1, 1});
  TriangleMesh fin = box;
  fin.vertices.push_back({0.9, 0.1, 0.9});
  fin.triangles.push_back(
      {box.triangles[0][0], box.triangles[0][1], static_cast<std::uint32_t>(box.vertices.size())});
  TriangleMesh fin_from_both_sides = fin;
  fin_from_both_sides.triangles.push_back(fin.triangles.back());
  turn_triangle(fin_from_both_sides, fin_from_both_sides.triangles.size() - 1);
  for (const TriangleMesh& mesh : {fin, fin_from_both_sides}) {
    const MendedSurface mended = mend_surface(put_anywhere(mesh, random));
    EXPECT_EQ(count_of(mended, FindingKind::kStrayFacet), 1u);
    EXPECT_EQ(mended.surface.size(), 12u);
    EXPECT_TRUE(mended.closed);
  }
  for (const double distance : {0.1, 1.7}) {  // inside and beside
    const MendedSurface mended = mend_surface(
        put_anywhere(join_meshes(box, translate_mesh(make_sheet(0.5, 4), {0, 0, distance})), random));
    EXPECT_EQ(count_of(mended, FindingKind::kOpenSheet), 1u);
    EXPECT_EQ(count_of(mended, FindingKind::kHole), 0u);
    EXPECT_EQ(mended.surface.size(), 12u);
  }
}

TEST(Mending, KeepsSolidsInOnePlaceHoweverTheirFacesAreCut) {
  std::mt19937 random(13);
  const TriangleMesh box = make_box({1, 1, 1});
  // Each triangle of the box in three.
  TriangleMesh finer = box;
  finer.vertices.clear();
  finer.triangles.clear();
  for (const auto& triangle : box.triangles) {
    const auto [a, b, c] = corners_of(triangle, box.vertices);
    const auto first = static_cast<std::uint32_t>(finer.vertices.size());
    finer.vertices.insert(finer.vertices.end(), {a, b, c, (1.0 / 3) * (a + b + c)});
    for (std::uint32_t k = 0; k < 3; ++k)
      finer.triangles.push_back({first + k, first + (k + 1) % 3, first + 3});
  }
  const MendedSurface mended = mend_surface(put_anywhere(join_meshes(box, finer), random));
  EXPECT_EQ(count_of(mended, FindingKind::kStrayFacet), 0u);
  EXPECT_EQ(mended.surface.size(), 48u);
  EXPECT_TRUE(mended.closed);
}

TEST(Mending, LeavesOutAMoebiusBandBesideABox) {
  std::mt19937 random(12);
  const TriangleMesh mesh =
      join_meshes(make_box({1, 1, 1}), translate_mesh(make_moebius_band(40, 0.5, 0.15), {1.5, 0, 0}));
  const MendedSurface mended = mend_surface(put_anywhere(mesh, random));
  EXPECT_EQ(count_of(mended, FindingKind::kOneSidedSheet), 1u);
  EXPECT_EQ(count_of(mended, FindingKind::kFlippedFacet), 0u);
  EXPECT_EQ(mended.surface.size(), 12u);
}

TEST(Mending, RefusesWhatHasNoInsideAndSaysWhatItIs) {
  std::mt19937 random(13);
  EXPECT_NE(
      refusal_of(put_anywhere(make_moebius_band(40, 1, 0.3), random)).find("one-sided sheet of 80 triangles"),
      std::string::npos);
  EXPECT_NE(
      refusal_of(put_anywhere(make_sheet(1, 8), random)).find("open sheet of 128 triangles, open along "),
      std::string::npos);
  EXPECT_NE(refusal_of({{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
                        {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}})
                .find("meet at edges"),
            std::string::npos);
  EXPECT_NE(refusal_of(make_box({1, 1, 1e-13})).find("flat"), std::string::npos);
  TriangleMesh soup;
  std::normal_distribution<double> normal;
  for (std::uint32_t t = 0; t < 200; ++t) {
    const Vector3 centre{normal(random), normal(random), normal(random)};
    for (int k = 0; k < 3; ++k)
      soup.vertices.push_back(centre + 0.3 * Vector3{normal(random), normal(random), normal(random)});
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  EXPECT_NE(refusal_of(soup).find("soup of 200 triangles"), std::string::npos);
}

TEST(Mending, CountsEdgesOfMoreThanTwoTrianglesAndKeepsBothSolids) {
  std::mt19937 random(14);
  const TriangleMesh two = join_meshes(make_box({1, 1, 1}), translate_mesh(make_box({1, 1, 1}), {1, 1, 0}));
  const MendedSurface mended = mend_surface(two);
  EXPECT_EQ(count_of(mended, FindingKind::kNonmanifoldEdge), 1u);
  EXPECT_TRUE(mended.closed);
  EXPECT_EQ(misplaced_share(mended, two, random), 0);
}

TEST(Mending, CountsTrianglesWithoutArea) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.triangles.push_back({0, 0, 1});
  const MendedSurface mended = mend_surface(mesh);
  EXPECT_EQ(count_of(mended, FindingKind::kDegenerateTriangle), 1u);
  EXPECT_EQ(mended.surface.degenerate_triangles, 1u);
  EXPECT_TRUE(mended.closed);
}

}  // namespace
}  // namespace crossgrain
