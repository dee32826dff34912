// SPDX-License-Identifier: Apache-2.0
// The version, and rows of numbers.
#include "c_interface/handles.hpp"
#include "crossgrain/version.hpp"

int crossgrain_c_version(void) {
  return CROSSGRAIN_C_VERSION;
}

const char* crossgrain_version(void) {
  return crossgrain::kVersion;
}

size_t crossgrain_numbers_rows(const crossgrain_numbers* numbers) {
  if (numbers == nullptr) return 0;
  return numbers->columns == 0 ? 0 : numbers->values.size() / numbers->columns;
}

size_t crossgrain_numbers_columns(const crossgrain_numbers* numbers) {
  return numbers == nullptr ? 0 : numbers->columns;
}

const double* crossgrain_numbers_data(const crossgrain_numbers* numbers) {
  return numbers == nullptr ? nullptr : crossgrain::data_or_null(numbers->values);
}

void crossgrain_numbers_free(crossgrain_numbers* numbers) {
  delete numbers;
}
