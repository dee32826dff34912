// SPDX-License-Identifier: Apache-2.0
// The list, in a complete new folder, of the names that it replaces in the old one. It is written before the
// new files come into place and removed after the old ones are gone, so that whoever finds the folder in
// between knows which files of the old one are to go.
#pragma once

#include <string>
#include <vector>

namespace crossgrain {

/// Name of the list.
inline constexpr const char* kReplacedNames = ".crossgrain-replaces";

/// Writes the list into a folder, through to the disk. Throws Error(kOutput) naming the folder `shown`.
void write_replaced_names(int folder, const std::vector<std::string>& names, const std::string& shown);

/// Returns the list in a folder, sorted; empty if there is none. Throws Error(kOutput).
std::vector<std::string> read_replaced_names(int folder, const std::string& shown);

/// Throws Error(kOutput) if the system does not tell.
bool has_replaced_names(int folder, const std::string& shown);

/// Removes the list if there is one. Throws nothing: the next run tries again.
void remove_replaced_names(int folder) noexcept;

}  // namespace crossgrain
