// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "grid/octree.hpp"
#include "grid/share.hpp"

namespace crossgrain {

/// Returns the greatest depth, up to `deepest`, at which at most `most` cells remain if all deeper leaves are
/// merged into their ancestors of that depth; 0 if there is none. Of a field whose leaves processes share,
/// this one has those of `tree`; a cell counts once for each process that has leaves of it.
int merged_depth(const Octree& tree, std::size_t most, int deepest = kMaxDepth, const Share& part = {});

}  // namespace crossgrain
