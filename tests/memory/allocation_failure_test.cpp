// SPDX-License-Identifier: Apache-2.0
// Allocations of a solve fail one after the other: each failure is an exception, and the next solve is as
// before. CROSSGRAIN_ALLOCATION_STEP sets how many are passed over between two that fail; 1 takes all.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <new>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/solve.hpp"
#include "field/field_data.hpp"
#include "support/allocation_watch.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

std::vector<std::array<float, 4>> frames_of(const FrameField& field) {
  std::vector<std::array<float, 4>> frames;
  for (const auto& frame : field.data().frames) frames.push_back(std::bit_cast<std::array<float, 4>>(frame));
  return frames;
}

/// Solves with all kinds of work: creases, several levels, a hole that is mended.
FrameField solve_small(const TriangleMesh& mesh) {
  SolveOptions options;
  options.resolution = 12;
  options.threads = 1;
  return solve(mesh, options);
}

TEST(AllocationFailure, OfAnyNumberIsAnExceptionAndTheNextSolveIsAsBefore) {
  TriangleMesh mesh = make_cylinder(0.5, 1.0, 24);
  mesh.triangles.pop_back();
  const auto expected = frames_of(solve_small(mesh));
  watch_allocations();
  solve_small(mesh);
  const long count = allocation_count();
  const char* const text = std::getenv("CROSSGRAIN_ALLOCATION_STEP");
  const long step = text != nullptr ? std::atol(text) : std::max(1L, count / 100);
  long failures = 0, passed = 0;
  for (long number = 0; number < count; number += step) {
    try {
      watch_allocations(number);
      const FrameField field = solve_small(mesh);
      watch_allocations();
      // Work that may fail, such as a buffer to sort in, is done another way.
      ++passed;
      ASSERT_EQ(frames_of(field), expected) << number;
    } catch (const std::bad_alloc&) {
      ++failures;
    }
  }
  watch_allocations();
  EXPECT_EQ(frames_of(solve_small(mesh)), expected);
  EXPECT_GT(failures, 9 * passed);
}

}  // namespace
}  // namespace crossgrain
