// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tet_making/netgen_messages.hpp"

namespace crossgrain {

/// What Netgen cannot do, in one line. It is not thrown out of the program.
struct NetgenFault {
  std::string text;
};

/// Does the work of a request. Throws NetgenFault, and whatever Netgen throws.
TetMesh netgen_tets_for(const NetgenRequest& request);

}  // namespace crossgrain
