// SPDX-License-Identifier: Apache-2.0
#include "fit/embedding_update.hpp"

#include <gtest/gtest.h>

#include "fit/hex_lattice.hpp"

namespace crossgrain {
namespace {

TEST(EmbeddingUpdate, LeavesNoPathWhereTheSurfaceHasNoEdgesForIt) {
  const HexMesh whole = testing::lattice_mesh({3, 1, 1}, [](int, int, int) { return 1; });
  HexMesh parts = whole;
  parts.hexahedra.erase(parts.hexahedra.begin() + 1);
  parts.regions.pop_back();
  const QuadComplex before(whole), after(parts);
  const auto along = [&](double y) {
    std::vector<std::uint32_t> path(4);
    for (std::uint32_t v = 0; v < whole.vertices.size(); ++v)
      if (whole.vertices[v][1] == y && whole.vertices[v][2] == 0)
        path[static_cast<std::size_t>(whole.vertices[v][0])] = v;
    return path;
  };
  Embedding embedding;
  embedding.face_of_quad.assign(before.quads().size(), 0);
  const std::vector<std::uint32_t> all = along(0), first(all.begin(), all.begin() + 2);
  embedding.path_of_curve = {all, first, {}};
  update_embedding(before, after, {}, embedding);
  EXPECT_EQ(embedding.path_of_curve, (std::vector<std::vector<std::uint32_t>>{{}, first, {}}));
}

}  // namespace
}  // namespace crossgrain
