// SPDX-License-Identifier: Apache-2.0
// What one core of this machine can do at most: kernels are measured against it, in the same process.
#pragma once

namespace crossgrain::bench {

struct MachineLimits {
  double bytes_per_second;  ///< read and written together, by a copy far larger than any cache
  double flops_per_second;  ///< of double precision, by multiply-adds in the widest vectors there are
};

/// Measured at the first call, which takes a second.
const MachineLimits& machine_limits();

}  // namespace crossgrain::bench
