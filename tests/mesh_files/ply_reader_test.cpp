// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "mesh_files/surface_files.hpp"

namespace crossgrain {
namespace {

const std::string kHeader =
    "ply\nformat ascii 1.0\ncomment made by a test\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kBody = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  text.replace(text.find(what), what.size(), by);
  return text;
}

/// The tetrahedron with properties in an odd order, of odd types and in the midst of others.
std::string binary_tetrahedron(bool big_endian) {
  std::string bytes =
      std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
      "_endian 1.0\nelement camera 2\nproperty double focus\nproperty list ushort short path\n"
      "element vertex 4\nproperty uchar red\nproperty double z\nproperty short x\n"
      "property list char float weights\nproperty float32 y\nelement face 4\n"
      "property list uint8 double uv\nproperty list int32 uint16 vertex_index\nproperty char flag\n"
      "end_header\n";
  const bool swapped = big_endian;  // the test runs on a little-endian machine, as the program does
  for (std::uint16_t length : {0, 3}) {
    append_bytes(bytes, 35.0, swapped);
    append_bytes(bytes, length, swapped);
    bytes.append(2u * length, 'x');
  }
  for (const Vector3& p : {Vector3{0, 0, 0}, Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
    append_bytes(bytes, std::uint8_t{255});
    append_bytes(bytes, p[2], swapped);
    append_bytes(bytes, static_cast<std::int16_t>(p[0]), swapped);
    append_bytes(bytes, std::int8_t{1});
    append_bytes(bytes, 0.5f, swapped);
    append_bytes(bytes, static_cast<float>(p[1]), swapped);
  }
  for (const auto& face :
       {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{0, 3, 2}, std::array{1, 2, 3}}) {
    append_bytes(bytes, std::uint8_t{1});
    append_bytes(bytes, 0.25, swapped);
    append_bytes(bytes, std::int32_t{3}, swapped);
    for (const int corner : face) append_bytes(bytes, static_cast<std::uint16_t>(corner), swapped);
    append_bytes(bytes, std::int8_t{-1});
  }
  return bytes;
}

TEST(PlyReader, ReadsAscii) {
  expect_tetrahedron(read_as("a.ply", kHeader + kBody));
}

TEST(PlyReader, ReadsAsciiWithDosLineEnds) {
  std::string text;
  for (const char c : kHeader + kBody) {
    if (c == '\n') text += '\r';
    text += c;
  }
  expect_tetrahedron(read_as("a.ply", text));
}

TEST(PlyReader, ReadsBinaryOfEitherByteOrderWithOtherPropertiesAndElements) {
  expect_tetrahedron(read_as("a.ply", binary_tetrahedron(/*big_endian=*/false)));
  expect_tetrahedron(read_as("a.ply", binary_tetrahedron(/*big_endian=*/true)));
}

TEST(PlyReader, SkipsOtherValuesOfAsciiThatAreNoNumbers) {
  const std::string header = replaced(kHeader, "property float z\n", "property float z\nproperty float nx\n");
  expect_tetrahedron(read_as(
      "a.ply", header + "0 0 0 nan\n1 0 0 -1.#IND\n0 1 0 0\n0 0 1 0\n" + kBody.substr(kBody.find("3 0 2"))));
}

TEST(PlyReader, CutsPolygons) {
  const std::string header = replaced(kHeader, "face 4", "face 1");
  const TriangleMesh mesh = read_as("a.ply", header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_DOUBLE_EQ(area_of(mesh), 1);
}

TEST(PlyReader, RefusesCountsThatTheFileCannotHold) {
  for (const char* count : {"353535235358", "9223372036854775807", "99999999999999999999", "-1"}) {
    for (const char* element : {"vertex 4", "face 4"}) {
      const std::string claim = std::string(element).substr(0, std::string(element).size() - 1) + count;
      input_error_as("a.ply", replaced(kHeader + kBody, element, claim));
      input_error_as("a.ply", replaced(binary_tetrahedron(false), element, claim));
    }
  }
}

TEST(PlyReader, IsNotHeldUpByAHugeNumberOfEmptyElements) {
  expect_tetrahedron(read_as(
      "a.ply", replaced(kHeader, "element face", "element void 9223372036854775807\nelement face") + kBody));
}

TEST(PlyReader, RefusesAListThatTheFileCannotHold) {
  const std::string header = replaced(kHeader, "list uchar", "list uint");
  input_error_as("a.ply", header + replaced(kBody, "3 1 2 3", "4000000000 1 2 3"));
  std::string bytes = replaced(binary_tetrahedron(false), "list uint8 double uv", "list uint8 double vv");
  const std::int32_t huge = 2'000'000'000;
  std::memcpy(bytes.data() + bytes.size() - 11, &huge, sizeof huge);
  const std::string message = input_error_as("a.ply", bytes);
  EXPECT_NE(message.find("face 3: the file ends here"), std::string::npos) << message;
}

TEST(PlyReader, RefusesEveryBeginningOfABinaryFile) {
  const std::string bytes = binary_tetrahedron(false);
  const TemporaryFolder folder;
  for (std::size_t length = 1; length < bytes.size(); ++length)
    input_error_of(folder.write("a.ply", bytes.substr(0, length)));
}

TEST(PlyReader, NamesTheVertexOfACoordinateThatIsNotFinite) {
  const std::string message = input_error_as("a.ply", kHeader + replaced(kBody, "0 1 0", "0 inf 0"));
  EXPECT_NE(message.find("a.ply: line 13: "), std::string::npos) << message;
  std::string bytes = binary_tetrahedron(false);
  const double infinity = std::numeric_limits<double>::infinity();
  const std::size_t first_vertex = bytes.find("end_header\n") + 11 + 2 * 10 + 6;
  std::memcpy(bytes.data() + first_vertex + 20 + 1, &infinity, sizeof infinity);
  const std::string binary_message = input_error_as("a.ply", bytes);
  EXPECT_NE(binary_message.find("a.ply: vertex 1: a coordinate is inf"), std::string::npos) << binary_message;
}

TEST(PlyReader, NamesTheFaceOfAnIndexOutOfRange) {
  const std::string message = input_error_as("a.ply", kHeader + replaced(kBody, "3 0 3 2", "3 0 4 2"));
  EXPECT_NE(message.find("a.ply: line 17: a face refers to vertex 4"), std::string::npos) << message;
  input_error_as("a.ply", kHeader + replaced(kBody, "3 0 3 2", "3 0 -1 2"));
}

TEST(PlyReader, RefusesAHeaderThatLacksSomething) {
  for (const char* needed : {"ply\n", "format ascii 1.0\n", "property float y\n", "element face 4\n",
                             "property list uchar int vertex_indices\n", "end_header\n"})
    input_error_as("a.ply", replaced(kHeader, needed, "") + kBody);
}

TEST(PlyReader, NamesTheLineOfAWrongHeader) {
  const std::string message = input_error_as("a.ply", replaced(kHeader, "float y", "real y") + kBody);
  EXPECT_NE(message.find("a.ply: line 6: 'real' is not a PLY type"), std::string::npos) << message;
}

}  // namespace
}  // namespace crossgrain
