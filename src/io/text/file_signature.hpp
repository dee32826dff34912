// SPDX-License-Identifier: Apache-2.0
// How files of a kind begin. Only used to explain a failure: several formats begin in no certain way.
#pragma once

#include <string>
#include <string_view>

#include "files/input_file.hpp"

namespace crossgrain {

struct FileSignature {
  std::string_view beginning;
  std::string_view kind;       ///< "an STL file"
  std::string_view extension;  ///< of the reader that takes it; empty where there is none
};

/// Null where a file begins in no way that is known.
const FileSignature* signature_of(std::string_view bytes);

/// "an STL file (.stl)".
std::string kind_of(const FileSignature& signature);

/// What to do with such a file that has another name.
Remedy remedy_for(const FileSignature& signature);

/// Throws Error(kInput) where a file, whose name ends in `extension`, begins like one of another kind.
void fail_if_misnamed(const InputFile& file, std::string_view extension);

}  // namespace crossgrain
