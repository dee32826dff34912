// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/solve.hpp"
#include "files/temporary_folder.hpp"
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
    EXPECT_EQ(read.arcs[i].turning_points, expected.arcs[i].turning_points);
    const std::vector<Vector3>&axes = read.arcs[i].axes, &axes_before = expected.arcs[i].axes;
    ASSERT_EQ(axes.size(), axes_before.size());
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const bool is_end = read.arcs[i].nodes && (k == 0 || k + 1 == axes.size());
      const bool is_shared = is_end && read.nodes[(*read.arcs[i].nodes)[k == 0 ? 0 : 1]].degree() > 1;
      EXPECT_EQ(axes[k], is_shared ? (Vector3{0, 0, 0}) : axes_before[k]);
    }
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
