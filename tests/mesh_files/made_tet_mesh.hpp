// SPDX-License-Identifier: Apache-2.0
// A tet mesh that tests write in every format, and the bytes they write it with.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/reading.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {

/// A whole file, and what to call it.
struct MadeFile {
  std::string what;  ///< for messages: format and encoding
  std::string extension;
  std::string content;
};

/// Indices at random, which no reader minds, in the order that formats with blocks for each tag keep.
/// Coordinates are exact in single precision and in few digits.
inline TetMesh made_tet_mesh(std::size_t vertices = 12, std::size_t tets = 30) {
  std::mt19937 random(11);
  const auto corner = [&] { return static_cast<std::uint32_t>(random() % vertices); };
  TetMesh mesh;
  for (std::size_t i = 0; i < vertices; ++i) {
    Vector3 position;
    for (double& x : position) x = (static_cast<double>(random() % 4001) - 2000) / 8;
    mesh.vertices.push_back(position);
  }
  for (std::size_t i = 0; i < tets; ++i) {
    mesh.tets.push_back({corner(), corner(), corner(), corner()});
    mesh.regions.push_back(static_cast<std::int32_t>(1 + 3 * i / tets));
  }
  for (const std::int32_t tag : {5, 5, 9}) mesh.feature_edges.push_back({{corner(), corner()}, tag});
  for (const std::int32_t tag : {1, 1, 4, 70000})
    mesh.feature_faces.push_back({{corner(), corner(), corner()}, tag});
  return mesh;
}

inline TetMesh read_made(const MadeFile& file) {
  const TemporaryFolder folder;
  return read_tets(folder.write("a" + file.extension, file.content));
}

/// The message of the Error(kInput) that reading gives, from behind the name of the file and a colon; empty
/// where it went well.
inline std::string error_of_reading_tets(const std::filesystem::path& path) {
  try {
    for (const auto& tet : read_tets(path).tets)
      for (const std::uint32_t corner : tet) EXPECT_LT(corner, 1'000'000u);
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::kInput) << message;
    EXPECT_TRUE(message.starts_with(path.string())) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message.substr(path.string().size() + 1);
  }
  return "";
}

inline std::string error_of_reading_tets(const MadeFile& file) {
  const TemporaryFolder folder;
  return error_of_reading_tets(folder.write("a" + file.extension, file.content));
}

inline void expect_tet_error(const MadeFile& file, const std::string& part) {
  const std::string message = error_of_reading_tets(file);
  EXPECT_NE(message.find(part), std::string::npos)
      << file.what << ": '" << message << "' has no '" << part << "'";
}

inline void expect_same_mesh(const TetMesh& mesh, const TetMesh& expected) {
  EXPECT_EQ(mesh.vertices, expected.vertices);
  EXPECT_EQ(mesh.tets, expected.tets);
  EXPECT_EQ(mesh.regions, expected.regions);
  const auto rows = [](const auto& features) {
    std::vector<std::pair<decltype(features[0].vertices), std::int32_t>> out;
    for (const auto& feature : features) out.emplace_back(feature.vertices, feature.tag);
    return out;
  };
  EXPECT_EQ(rows(mesh.feature_edges), rows(expected.feature_edges));
  EXPECT_EQ(rows(mesh.feature_faces), rows(expected.feature_faces));
}

/// Numbers as raw bytes, in the order of this machine or the other.
class ByteWriter {
 public:
  explicit ByteWriter(bool swapped = false) : swapped_(swapped) {}

  template <class T>
  void put(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (swapped_) std::reverse(raw, raw + sizeof(T));
    bytes_.append(raw, sizeof(T));
  }

  void text(std::string_view words) { bytes_ += words; }

  std::size_t size() const { return bytes_.size(); }
  const std::string& bytes() const { return bytes_; }

 private:
  bool swapped_;
  std::string bytes_;
};

}  // namespace crossgrain
