// SPDX-License-Identifier: Apache-2.0
#include "measure/body_contacts.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tets/several_tet_meshes.hpp"

namespace crossgrain {
namespace {

std::vector<BodyContact> contacts_of(const std::vector<TetMesh>& meshes) {
  return body_contacts(solid_of(together(meshes)));
}

TetMesh box(std::array<std::uint32_t, 3> cells) {
  return TetBox{cells}.mesh();
}

/// The one contact of meshes, of this kind.
BodyContact only_contact(const std::vector<TetMesh>& meshes, ContactKind kind) {
  const std::vector<BodyContact> contacts = contacts_of(meshes);
  EXPECT_EQ(contacts.size(), 1u);
  if (contacts.empty()) return {};
  EXPECT_EQ(contacts[0].kind, kind);
  EXPECT_EQ(contacts[0].bodies, (std::array<std::uint32_t, 2>{0, 1}));
  EXPECT_EQ(contacts[0].regions, (std::array<std::int32_t, 2>{1, 2}));
  return contacts[0];
}

TEST(BodyContacts, AreNoneInOneBodyAndBetweenBodiesApart) {
  EXPECT_TRUE(contacts_of({box({2, 2, 2})}).empty());
  EXPECT_TRUE(contacts_of({box({2, 2, 2}), moved(box({2, 2, 2}), {2.01, 0, 0})}).empty());
}

TEST(BodyContacts, HaveTheAreaWhereFacesLieOnEachOther) {
  EXPECT_NEAR(only_contact({box({4, 4, 4}), moved(box({4, 4, 4}), {4, 2, 0})}, ContactKind::kInFaces).area, 8,
              1e-9);
  const BodyContact contact =
      only_contact({moved(box({1, 1, 1}), {1.3, 1.2, 4}), box({4, 4, 4})}, ContactKind::kInFaces);
  EXPECT_NEAR(contact.area, 1, 0.4);  // as far as samples of the larger triangles tell
  EXPECT_NEAR(contact.place[2], 4, 1e-12);
}

TEST(BodyContacts, AreFoundOnAStripFarNarrowerThanTheTets) {
  only_contact({box({2, 2, 2}), moved(box({2, 2, 2}), {1.9, 0.1, 2})}, ContactKind::kInFaces);
}

TEST(BodyContacts, AlongEdgesAndAtCornersHaveNoArea) {
  const TetMesh whole = box({2, 2, 2});
  EXPECT_EQ(only_contact({whole, moved(whole, {2, 2, 0})}, ContactKind::kInEdge).place, (Vector3{2, 2, 0.5}));
  EXPECT_EQ(only_contact({whole, moved(whole, {2, 2, 2})}, ContactKind::kInPoint).place, (Vector3{2, 2, 2}));
  only_contact({whole, moved(whole, {2, 0.5, 2})}, ContactKind::kInEdge);
  // Also of bodies with common vertices there, which no face of tets joins.
  TetMesh joined = together({whole, moved(whole, {2, 2, 0})});
  for (auto& tet : joined.tets)
    for (std::uint32_t& v : tet)
      v = static_cast<std::uint32_t>(std::ranges::find(joined.vertices, joined.vertices[v]) -
                                     joined.vertices.begin());
  const std::vector<BodyContact> contacts = body_contacts(solid_of(joined));
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].kind, ContactKind::kInEdge);
  EXPECT_TRUE(warning_of(contacts).text.starts_with(
      "solids 1 and 2 meet only in an edge, where hexahedra of both share no vertices, at "));
}

TEST(BodyContacts, OfACylinderThatLiesOnAPlaneAreALine) {
  const std::vector<TetMesh> meshes{tet_cylinder(8), moved(box({2, 2, 2}), {1, -1, -1})};
  only_contact(meshes, ContactKind::kInEdge);
}

TEST(BodyContacts, OfAPinInItsHoleAreOnItsSideHoweverBothAreCut) {
  const BodyContact contact = only_contact({tet_cylinder(6), tet_pipe(20, 1, 2)}, ContactKind::kInFaces);
  EXPECT_NEAR(contact.area, 4 * std::numbers::pi, 0.3 * 4 * std::numbers::pi);
  EXPECT_TRUE(contacts_of({tet_cylinder(6), tet_pipe(20, 1.1, 2)}).empty());
}

TEST(BodyContacts, OfASolidInAVoidAreAllItsFaces) {
  TetMesh hollow = box({3, 3, 3});
  std::erase_if(hollow.tets, [&](const auto& tet) {
    Vector3 middle{0, 0, 0};
    for (const std::uint32_t v : tet) middle += 0.25 * hollow.vertices[v];
    return std::ranges::all_of(middle, [](double x) { return x > 1 && x < 2; });
  });
  EXPECT_NEAR(only_contact({hollow, moved(box({1, 1, 1}), {1, 1, 1})}, ContactKind::kInFaces).area, 6, 1e-9);
}

TEST(BodyContacts, TellBodiesThatOverlap) {
  only_contact({box({4, 4, 2}), moved(box({1, 1, 2}), {1.5, 1.5, 1})}, ContactKind::kOverlap);
  only_contact({box({4, 4, 4}), moved(box({1, 1, 1}), {1.5, 1.5, 1.5})}, ContactKind::kOverlap);
  only_contact({box({3, 3, 3}), box({3, 3, 3})}, ContactKind::kOverlap);
}

TEST(BodyContacts, AreSortedByKindAndArea) {
  const std::vector<BodyContact> contacts =
      contacts_of({box({4, 4, 2}), moved(box({1, 1, 1}), {0.2, 0.2, 2}), moved(box({2, 2, 1}), {1.5, 1.5, 2}),
                   moved(box({1, 1, 2}), {3.2, 0.3, 1})});
  ASSERT_EQ(contacts.size(), 3u);
  EXPECT_EQ(contacts[0].regions, (std::array<std::int32_t, 2>{1, 4}));
  EXPECT_EQ(contacts[1].regions, (std::array<std::int32_t, 2>{1, 3}));
  EXPECT_EQ(contacts[2].regions, (std::array<std::int32_t, 2>{1, 2}));
  EXPECT_TRUE(warning_of(contacts).text.starts_with(
      "solids 1 and 4 overlap, and both are meshed whole, one in the other, and 2 more pairs, at "));
}

TEST(BodyContacts, NameBodiesWhereRegionsDoNot) {
  TetMesh mesh = together({box({2, 2, 2}), moved(box({2, 2, 2}), {0.5, 0, 2})});
  mesh.regions = {};
  EXPECT_TRUE(
      warning_of(body_contacts(solid_of(mesh)))
          .text.starts_with("bodies 1 and 2 touch, but are meshed apart, without common vertices, at "));
}

}  // namespace
}  // namespace crossgrain
