// SPDX-License-Identifier: Apache-2.0
// The rows of a sweep, which change options one at a time.
#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "solve/tuned_solve.hpp"

namespace crossgrain {

struct Variant {
  std::string name;
  std::function<void(SolveTuning&)> apply;
};

/// Returns one row for each value of a member of `section`, a part of SolveTuning.
template <class Section, class Value>
void add(std::vector<Variant>& variants, const char* name, Section SolveTuning::*section,
         Value Section::*member, std::vector<Value> values) {
  for (const Value value : values) {
    char text[80];
    std::snprintf(text, sizeof text, "%s = %g", name, static_cast<double>(value));
    variants.push_back({text, [=](SolveTuning& options) { options.*section.*member = value; }});
  }
}

}  // namespace crossgrain
