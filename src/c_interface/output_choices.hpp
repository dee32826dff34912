// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/result_folder.hpp"

namespace crossgrain {

/// OutputOptions as the C interface offers them.
struct OutputChoices : OutputOptions {
  bool page = false;  ///< whether the page is written with the field (page_of)
};

}  // namespace crossgrain
