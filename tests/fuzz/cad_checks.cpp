// SPDX-License-Identifier: Apache-2.0
#include "io/cad/cad_checks.hpp"

#include "fuzz/input_folder.hpp"
#include "fuzz/reader_checks.hpp"

namespace crossgrain {

bool check_cad(std::string_view bytes) {
  const auto path = as_file("input.cad", bytes);
  bool passed = false;
  for (auto* check : {check_step_file, check_iges_file, check_brep_file})
    passed |= succeeds([&] { check(InputFile(path)); });
  return passed;
}

}  // namespace crossgrain
