// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "crossgrain/error.hpp"

namespace crossgrain {

/// The one line of the Error(kInput) that `read` throws; empty, with a failure of the test, where there is
/// none.
template <class Read>
std::string input_error(const Read& read) {
  try {
    read();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

}  // namespace crossgrain
