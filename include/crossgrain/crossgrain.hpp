// SPDX-License-Identifier: Apache-2.0
// Everything that the library offers.
#pragma once

#include "crossgrain/constraints.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/finding.hpp"
#include "crossgrain/frame_field.hpp"
#include "crossgrain/io.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/page.hpp"
#include "crossgrain/picture.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/spectrum.hpp"
#include "crossgrain/tet_domain.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "crossgrain/thread_limit.hpp"
#include "crossgrain/types.hpp"
#include "crossgrain/version.hpp"
#include "crossgrain/warning.hpp"
