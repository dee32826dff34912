// SPDX-License-Identifier: Apache-2.0
// report.html: a page that shows a field in a browser, on its own.
#pragma once

#include <string>
#include <string_view>

#include "files/output_file.hpp"

namespace crossgrain {

inline constexpr const char* kPageFile = "report.html";

/// Bytes as gzip makes them, in base64, as pages hold a scene.
std::string packed_for_page(std::string_view bytes);

/// Writes the page of viewer/ with a report (the text of report.json) and a packed scene in it.
void write_page(OutputFile& file, std::string_view report_text, std::string_view packed_scene);

}  // namespace crossgrain
