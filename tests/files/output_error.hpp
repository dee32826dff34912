// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "crossgrain/error.hpp"

namespace crossgrain {

/// The message of the Error(kOutput) that `action` gives.
inline std::string output_error_of(const std::function<void()>& action) {
  try {
    action();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kOutput);
    return error.what();
  }
  return "";
}

}  // namespace crossgrain
