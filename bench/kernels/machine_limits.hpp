// SPDX-License-Identifier: Apache-2.0
// Limits of one core of this machine. Kernels are compared with them in the same process.
#pragma once

namespace crossgrain::bench {

struct MachineLimits {
  double bytes_per_second;  ///< reads plus writes of a copy far larger than any cache
  double flops_per_second;  ///< multiply-adds in double precision in the widest vectors
};

/// Returns the limits, which the first call measures in a second.
const MachineLimits& machine_limits();

}  // namespace crossgrain::bench
