// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "mesh_files/surface_files.hpp"

namespace crossgrain {
namespace {

std::string ascii_tetrahedron(const std::string& end_of_line = "\n") {
  std::string text = "solid corner" + end_of_line;
  for (const auto& triangle : tetrahedron()) {
    text += "  facet normal 0 0 0" + end_of_line + "    outer loop" + end_of_line;
    for (const Vector3& p : triangle)
      text += fmt::format("      vertex {:e} {:e} {:e}", p[0], p[1], p[2]) + end_of_line;
    text += "    endloop" + end_of_line + "  endfacet" + end_of_line;
  }
  return text + "endsolid corner" + end_of_line;
}

std::string binary_tetrahedron(const std::string& header_text = "made by a test") {
  std::string bytes = header_text;
  bytes.resize(80, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(tetrahedron().size()));
  for (const auto& triangle : tetrahedron()) {
    bytes.append(12, '\0');
    for (const Vector3& p : triangle)
      for (const double x : p) append_bytes(bytes, static_cast<float>(x));
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST(StlReader, ReadsAsciiAndWeldsItsCorners) {
  expect_tetrahedron(read_as("a.stl", ascii_tetrahedron()));
}

TEST(StlReader, ReadsBinary) {
  expect_tetrahedron(read_as("a.stl", binary_tetrahedron()));
}

TEST(StlReader, TakesTheExtensionInEitherCase) {
  expect_tetrahedron(read_as("a.STL", binary_tetrahedron()));
}

TEST(StlReader, NumbersVerticesByTheirFirstUseWithZeroAndMinusZeroEqual) {
  std::string bytes(80, ' ');
  append_bytes(bytes, std::uint32_t{2});
  const std::vector<float> corners = {5, 0, 0, 1, 0, 0, 0, 1, -0.0f, 0, 1, 0, 1, -0.0f, 0, 9, 9, 9};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 9 == 0) bytes.append(i == 0 ? 12 : 14, '\0');
    append_bytes(bytes, corners[i]);
  }
  const TriangleMesh mesh = read_as("a.stl", bytes + "ab");
  EXPECT_EQ(mesh.vertices, (std::vector<Vector3>{{5, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {2, 1, 3}}));
}

TEST(StlReader, ReadsBinaryThatBeginsWithSolid) {
  expect_tetrahedron(read_as("a.stl", binary_tetrahedron("solid corner facet normal")));
}

TEST(StlReader, ReadsBinaryFollowedByOtherBytes) {
  expect_tetrahedron(read_as("a.stl", binary_tetrahedron() + "trailer"));
}

TEST(StlReader, ReadsLinesThatEndTheDosWayAndTheOldMacWay) {
  expect_tetrahedron(read_as("a.stl", ascii_tetrahedron("\r\n")));
  expect_tetrahedron(read_as("a.stl", ascii_tetrahedron("\r")));
}

TEST(StlReader, ReadsUpperCaseKeywords) {
  std::string text = ascii_tetrahedron();
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  expect_tetrahedron(read_as("a.stl", text));
}

TEST(StlReader, DoesWithoutEndsolid) {
  const std::string text = ascii_tetrahedron();
  expect_tetrahedron(read_as("a.stl", text.substr(0, text.find("endsolid"))));
}

TEST(StlReader, JoinsSeveralSolids) {
  std::string shifted = ascii_tetrahedron();
  for (std::size_t at = 0; (at = shifted.find("vertex 0.", at)) != std::string::npos; at += 8)
    shifted.replace(at, 9, "vertex 5.");
  EXPECT_EQ(read_as("a.stl", ascii_tetrahedron() + shifted).triangles.size(), 8u);
}

TEST(StlReader, NamesTheLineOfAWordThatIsNoNumber) {
  std::string text = ascii_tetrahedron();
  text.replace(text.find("1.000000e+00"), 4, "1,00");
  const std::string message = input_error_as("a.stl", text);
  EXPECT_NE(message.find("a.stl: line 5: '1,00"), std::string::npos) << message;
}

TEST(StlReader, NamesTheLineOfACoordinateThatIsNotFinite) {
  for (const char* word : {"nan         ", "-inf        ", "1e999       "}) {
    std::string text = ascii_tetrahedron();
    text.replace(text.find("0.000000e+00"), 12, word);
    const std::string message = input_error_as("a.stl", text);
    EXPECT_NE(message.find("a.stl: line 4: a coordinate is"), std::string::npos) << message;
  }
}

TEST(StlReader, NamesTheTriangleOfABinaryCoordinateThatIsNotFinite) {
  std::string bytes = binary_tetrahedron();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + 84 + 2 * 50 + 12, &nan, sizeof nan);
  const std::string message = input_error_as("a.stl", bytes);
  EXPECT_NE(message.find("a.stl: triangle 2: a coordinate is nan"), std::string::npos) << message;
}

TEST(StlReader, RefusesABinaryFileThatIsCutShort) {
  const std::string bytes = binary_tetrahedron();
  const std::string message = input_error_as("a.stl", bytes.substr(0, bytes.size() - 1));
  EXPECT_NE(message.find("announces 4 triangles, of which the file has 3"), std::string::npos) << message;
}

TEST(StlReader, RefusesABinaryFileWithoutTriangles) {
  const std::string message = input_error_as("a.stl", std::string(84, '\0'));
  EXPECT_NE(message.find("no triangles"), std::string::npos) << message;
}

TEST(StlReader, RefusesAnAsciiFileThatEndsInsideAFacet) {
  const std::string text = ascii_tetrahedron();
  input_error_as("a.stl", text.substr(0, text.rfind("endfacet")));
  input_error_as("a.stl", text.substr(0, text.rfind("vertex") + 12));
}

TEST(StlReader, RefusesAFacetOfFourCorners) {
  std::string text = ascii_tetrahedron();
  text.insert(text.find("    endloop"), "vertex 1 1 1\n");
  const std::string message = input_error_as("a.stl", text);
  EXPECT_NE(message.find("a.stl: line 9: a facet of 4 corners"), std::string::npos) << message;
}

TEST(StlReader, RefusesEveryBeginningOfAnAsciiFileOrReadsWholeFacets) {
  const std::string text = ascii_tetrahedron();
  const TemporaryFolder folder;
  for (std::size_t length = 1; length < text.size(); ++length) {
    const auto path = folder.write("a.stl", text.substr(0, length));
    try {
      // A file that ends between two facets cannot be told from a smaller one.
      EXPECT_LE(read_surface(path).triangles.size(), 4u);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
    }
  }
}

}  // namespace
}  // namespace crossgrain
