// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "mesh_files/made_3mf.hpp"

namespace crossgrain {
namespace {

TriangleMesh read_document(const std::string& part, const Members& others = {}) {
  return read_as("a.3mf", made_3mf(part, others));
}

std::string error_of_document(const std::string& part, const Members& others = {}) {
  return input_error_as("a.3mf", made_3mf(part, others));
}

Box box_of(const TriangleMesh& mesh) {
  Box box{mesh.vertices[0], mesh.vertices[0]};
  for (const Vector3& vertex : mesh.vertices)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], vertex[axis]);
      box.high[axis] = std::max(box.high[axis], vertex[axis]);
    }
  return box;
}

const std::string kOne = "<item objectid=\"1\"/>";

TEST(Read3mf, GivesTheMeshOfAnItem) {
  const TriangleMesh mesh = read_document(part_of_3mf(object_of_3mf("1", mesh_of_3mf()), kOne));
  expect_tetrahedron(mesh);
  EXPECT_EQ(mesh.unit, "mm");
  EXPECT_EQ(mesh.file_unit, "mm");
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST(Read3mf, ConvertsToMillimetres) {
  for (const auto& [name, short_name, size] : {std::tuple{"micron", "um", 1e-3},
                                               {"centimeter", "cm", 10.0},
                                               {"inch", "inch", 25.4},
                                               {"foot", "foot", 304.8},
                                               {"meter", "m", 1000.0}}) {
    const TriangleMesh mesh =
        read_document(part_of_3mf(object_of_3mf("1", mesh_of_3mf()), kOne, fmt::format("unit=\"{}\"", name)));
    EXPECT_EQ(mesh.file_unit, short_name);
    EXPECT_NEAR(volume_of(mesh), size * size * size / 6, 1e-12 * size * size * size);
  }
  expect_tetrahedron(read_document(part_of_3mf(object_of_3mf("1", mesh_of_3mf()), kOne, "")));
  EXPECT_NE(error_of_document(part_of_3mf("", kOne, "unit=\"yard\"")).find("'yard' is no unit"),
            std::string::npos);
}

TEST(Read3mf, PlacesItemsAndComponentsByTheirTransforms) {
  // Scaled by 2 and moved by 10 along x; within it a quarter turn about z, moved by 5 along y.
  const std::string objects =
      object_of_3mf("1", mesh_of_3mf()) +
      object_of_3mf("2",
                    "<components><component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 0 5 0\"/>"
                    "</components>");
  const TriangleMesh mesh = read_document(
      part_of_3mf(objects, "<item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 10 0 0\"/>", "unit=\"inch\""));
  EXPECT_NEAR(volume_of(mesh), 8 * std::pow(25.4, 3) / 6, 1e-6);
  const Box box = box_of(mesh);
  const Vector3 low{8 * 25.4, 10 * 25.4, 0}, high{10 * 25.4, 12 * 25.4, 2 * 25.4};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.low[axis], low[axis], 1e-9);
    EXPECT_NEAR(box.high[axis], high[axis], 1e-9);
  }
}

TEST(Read3mf, GivesAllItemsAndTurnsMirrorImagesOutward) {
  const TriangleMesh mesh =
      read_document(part_of_3mf(object_of_3mf("1", mesh_of_3mf()),
                                kOne + "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 -1 0 0\"/>"));
  EXPECT_EQ(mesh.triangles.size(), 8u);
  EXPECT_NEAR(volume_of(mesh), 2.0 / 6, 1e-12);
}

TEST(Read3mf, FollowsPathsToOtherParts) {
  const std::string first = part_of_3mf(
      object_of_3mf("8",
                    "<components><component p:path=\"/3D/Objects/b.model\" objectid=\"1\"/></components>"),
      "<item objectid=\"8\"/>");
  const std::string other = part_of_3mf(object_of_3mf("1", mesh_of_3mf()), kOne, "unit=\"millimeter\"");
  expect_tetrahedron(read_document(first, {{"3D/Objects/b.model", other}}));
  EXPECT_NE(error_of_document(first).find("'3D/Objects/b.model': is missing in the archive"),
            std::string::npos);
}

TEST(Read3mf, LeavesSupportsOutWithAWarning) {
  const std::string objects =
      object_of_3mf("1", mesh_of_3mf()) + object_of_3mf("2", mesh_of_3mf(), "support") +
      object_of_3mf("3", "<components><component objectid=\"1\"/><component objectid=\"2\"/></components>");
  const TriangleMesh mesh = read_document(part_of_3mf(objects, "<item objectid=\"3\"/>"));
  expect_tetrahedron(mesh);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_NE(mesh.warnings[0].text.find("left out: 1"), std::string::npos) << mesh.warnings[0].text;
}

TEST(Read3mf, PassesOverElementsOfOtherNamespaces) {
  const std::string slices =
      "<s:slicestack xmlns:s=\"u:s\"><s:vertices><s:vertex x=\"1\" y=\"2\"/></s:vertices></s:slicestack>";
  expect_tetrahedron(read_document(part_of_3mf(slices + object_of_3mf("1", mesh_of_3mf() + slices), kOne)));
}

TEST(Read3mf, NamesPartLineAndFault) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string part = part_of_3mf(object_of_3mf("1", mesh_of_3mf()), kOne);
    return error_of_document(part.replace(part.find(from), from.size(), to));
  };
  EXPECT_NE(with("x=\"0\"", "x=\"zero\"").find("'3D/3dmodel.model', line 5: 'zero' instead of a number"),
            std::string::npos);
  EXPECT_NE(with("v1=\"0\"", "v1=\"12\"").find("vertex 12 of 12"), std::string::npos);
  EXPECT_NE(with("v1=\"0\"", "v1=\"-1\"").find("instead of the number of a vertex"), std::string::npos);
  EXPECT_NE(with("<item objectid=\"1\"/>", "<item objectid=\"7\"/>").find("object '7' is missing"),
            std::string::npos);
  EXPECT_NE(with("<item objectid=\"1\"/>", "").find("no item to build"), std::string::npos);
  EXPECT_NE(
      with("<item objectid=\"1\"", "<item objectid=\"1\" transform=\"1 0 0\"").find("instead of a number"),
      std::string::npos);
  EXPECT_NE(with("<item objectid=\"1\"", "<item objectid=\"1\" transform=\"1 0 0 0 0 0 0 0 1 0 0 0\"")
                .find("leaves no volume"),
            std::string::npos);
  EXPECT_NE(with("</build>", "").find("no sound XML"), std::string::npos);
}

TEST(Read3mf, RefusesComponentsInThemselvesAndCountsThemBeforeItBuilds) {
  EXPECT_NE(error_of_document(
                part_of_3mf(object_of_3mf("1", "<components><component objectid=\"1\"/></components>"), kOne))
                .find("nested in themselves"),
            std::string::npos);
  // Each object ten times the one before: 4e13 triangles.
  std::string objects = object_of_3mf("0", mesh_of_3mf());
  for (int level = 1; level <= 13; ++level) {
    std::string ten;
    for (int i = 0; i < 10; ++i) ten += fmt::format("<component objectid=\"{}\"/>", level - 1);
    objects += object_of_3mf(std::to_string(level), "<components>" + ten + "</components>");
  }
  try {
    read_document(part_of_3mf(objects, "<item objectid=\"13\"/>"));
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kLimit) << error.what();
  }
}

TEST(Read3mf, SaysWhatIsMissingInTheArchive) {
  const auto expect = [](const std::string& archive, const std::string& words) {
    const std::string message = input_error_as("a.3mf", archive);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  // A member of this name makes it a 3MF file.
  const std::pair<std::string, std::string> other{"other.model", "b"};
  expect(zipped({other}), "'_rels/.rels': is missing");
  expect(zipped({other, {"_rels/.rels", "<a/>"}}), "names no model");
  expect(zipped({other, {"_rels/.rels", k3mfRelationships}}), "'3D/3dmodel.model': is missing");
  expect(zipped({{"a", "b"}}), "begins like a ZIP archive");
  expect("solid a", "begins like an STL file");
}

}  // namespace
}  // namespace crossgrain
