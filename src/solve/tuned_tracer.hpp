// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/streamlines.hpp"
#include "sampling/streamline_tuning.hpp"

namespace crossgrain {

/// A tracer with all that the page, tests and sweeps set besides.
class TunedTracer : public StreamlineTracer {
 public:
  TunedTracer(const FrameField& field, const StreamlineOptions& options, const StreamlineTuning& tuning,
              const TriangleMesh* surface = nullptr);
  TunedTracer(const TetFrameField& field, const StreamlineOptions& options, const StreamlineTuning& tuning);
};

}  // namespace crossgrain
