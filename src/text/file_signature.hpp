// SPDX-License-Identifier: Apache-2.0
// Recognises file formats by their first bytes. Only used to explain a failure, since several formats have no
// fixed beginning.
#pragma once

#include <string>
#include <string_view>

#include "files/input_file.hpp"

namespace crossgrain {

struct FileSignature {
  std::string_view beginning;
  std::string_view kind;       ///< "an STL file"
  std::string_view extension;  ///< of the reader for this format; empty if there is none
};

/// Returns the signature that matches, or null.
const FileSignature* signature_of(std::string_view bytes);

/// Description such as "an STL file (.stl)".
std::string kind_of(const FileSignature& signature);

/// Remedy for a file of this format with the wrong extension.
Remedy remedy_for(const FileSignature& signature);

/// Throws Error(kInput) if a file named with `extension` begins like a file of another format.
void fail_if_misnamed(const InputFile& file, std::string_view extension);

}  // namespace crossgrain
