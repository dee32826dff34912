// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "crossgrain/error.hpp"
#include "crossgrain/io.hpp"
#include "crossgrain/solve.hpp"
#include "files/temporary_folder.hpp"
#include "io/result/singularity_file.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

TEST(SingularityFile, GivesArcsAndNodesBack) {
  SolveOptions options;
  options.resolution = 16;
  const FrameField field = solve(make_sphere(1, 2), options);
  const TemporaryFolder folder;
  write_field(field, folder.path());
  const SingularityGraph expected = field.singularities(),
                         read = read_singularities(folder.path() / "singularities.vtu");
  ASSERT_EQ(read.arcs.size(), expected.arcs.size());
  ASSERT_EQ(read.nodes.size(), expected.nodes.size());
  EXPECT_GT(read.arcs.size(), 0u);
  for (std::size_t i = 0; i < read.arcs.size(); ++i) {
    EXPECT_EQ(read.arcs[i].points, expected.arcs[i].points);
    EXPECT_EQ(read.arcs[i].index, expected.arcs[i].index);
    EXPECT_EQ(read.arcs[i].type, expected.arcs[i].type);
    EXPECT_EQ(read.arcs[i].verdict, expected.arcs[i].verdict);
    EXPECT_EQ(read.arcs[i].nodes, expected.arcs[i].nodes);
  }
  for (std::size_t i = 0; i < read.nodes.size(); ++i) {
    EXPECT_EQ(read.nodes[i].place, expected.nodes[i].place);
    EXPECT_EQ(read.nodes[i].verdict, expected.nodes[i].verdict);
    EXPECT_EQ(read.nodes[i].arcs, expected.nodes[i].arcs);
  }
  EXPECT_THROW(read_singularities(folder.path() / "surface.vtu"), Error);
}

}  // namespace
}  // namespace crossgrain
