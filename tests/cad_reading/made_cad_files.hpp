// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "cad_reading/cad_reading.hpp"
#include "crossgrain/reading.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {

#ifdef CROSSGRAIN_CAD_FILES

/// A folder of CAD files, made once for all tests by tests/cad_reading/make_cad_files.cpp.
inline const std::filesystem::path& cad_files() {
  static const TemporaryFolder folder;
  static const int status =
      std::system(fmt::format("'{}' '{}' > /dev/null", CROSSGRAIN_CAD_FILES, folder.path().string()).c_str());
  if (status != 0) throw std::runtime_error("the CAD files could not be made");
  return folder.path();
}

inline TriangleMesh read_made(const std::string& name, const CadReading& options = {}) {
  return read_surface(cad_files() / name, options);
}

inline void expect_same(const TriangleMesh& a, const TriangleMesh& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.corner_normals, b.corner_normals);
  EXPECT_EQ(a.faces, b.faces);
  ASSERT_EQ(a.creases.size(), b.creases.size());
  for (std::size_t i = 0; i < a.creases.size(); ++i) {
    EXPECT_EQ(a.creases[i].points, b.creases[i].points);
    EXPECT_EQ(a.creases[i].tangents, b.creases[i].tangents);
  }
}

#endif

}  // namespace crossgrain
