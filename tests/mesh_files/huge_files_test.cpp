// SPDX-License-Identifier: Apache-2.0
// Files larger than memory, and numbers larger than 32 bits.
#include <filesystem>

#include "base/system_memory.hpp"
#include "mesh_files/surface_files.hpp"

namespace crossgrain {
namespace {

/// A file that takes no room on the disk but at its beginning.
std::filesystem::path sparse_file(const TemporaryFolder& folder, const std::string& name,
                                  const std::string& beginning, std::uintmax_t size) {
  const std::filesystem::path path = folder.write(name, beginning);
  std::filesystem::resize_file(path, size);
  return path;
}

void expect_refused_unread(const std::filesystem::path& path, const ReadOptions& options) {
  const std::size_t before = peak_memory_bytes();
  try {
    read_surface(path, options);
    ADD_FAILURE() << path;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kLimit);
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
    EXPECT_NE(message.find("GB are allowed"), std::string::npos) << message;
  }
  EXPECT_LT(peak_memory_bytes(), before + 100'000'000);
}

TEST(HugeFiles, BeyondTheMemoryAllowedAreRefusedBeforeTheyAreRead) {
  const TemporaryFolder folder;
  std::string header(80, ' ');
  append_bytes(header, std::uint32_t{60'000'000});
  ReadOptions options;
  options.max_memory_bytes = 1'000'000'000;
  expect_refused_unread(sparse_file(folder, "a.stl", header, 84 + 50 * std::uintmax_t{60'000'000}), options);
  for (const char* name : {"a.obj", "a.ply", "a.off", "a.step", "a.iges", "a.brep"})
    expect_refused_unread(sparse_file(folder, name, "some text", 3'000'000'000), options);
}

TEST(HugeFiles, BeyondTheMachineAreRefusedBeforeTheyAreRead) {
  if (memory_limit_bytes() == 0) GTEST_SKIP() << "the system does not tell how much memory it has";
  const TemporaryFolder folder;
  const auto path = sparse_file(folder, "a.stl", "solid", 2 * memory_limit_bytes());
  expect_refused_unread(path, {});
  std::filesystem::rename(path, folder.path() / "a.mesh");
  try {
    read_tets(folder.path() / "a.mesh");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kLimit) << error.what();
  }
}

TEST(HugeFiles, NumbersOfVerticesDoNotWrapAt32Bits) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  for (const char* far : {"4294967299", "-4294967293", "9223372036854775807", "-9223372036854775808"})
    EXPECT_NE(input_error_as("a.obj", obj + "f 1 2 " + far + "\n").find("refers to vertex"),
              std::string::npos);
  EXPECT_NE(input_error_as("a.off", off + "3 0 1 4294967298\n").find("refers to vertex 4294967298"),
            std::string::npos);
}

TEST(HugeFiles, ClaimsOfAHeaderNeedBytesBehindThem) {
  const std::size_t before = peak_memory_bytes();
  std::string stl(80, ' ');
  append_bytes(stl, UINT32_MAX);
  input_error_as("a.stl", stl + std::string(50, '\0'));
  input_error_as("a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n");
  for (const char* kind : {"ascii", "binary_little_endian", "binary_big_endian"})
    input_error_as("a.ply", std::string("ply\nformat ") + kind +
                                " 1.0\nelement vertex 18446744073709551615\nproperty float x\nproperty float "
                                "y\nproperty float z\nelement face 1\nproperty list int int vertex_indices\n"
                                "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_LT(peak_memory_bytes(), before + 100'000'000);
}

}  // namespace
}  // namespace crossgrain
