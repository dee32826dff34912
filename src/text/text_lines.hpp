// SPDX-License-Identifier: Apache-2.0
// Lines of numbers, formatted in parallel and written in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "crossgrain/monitor.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// Maximum bytes of put_number with the separator: sign, 17 digits, point, an exponent such as e-308.
inline constexpr std::size_t kNumberBytes = 25;

/// Maximum bytes of put_integer with the separator.
inline constexpr std::size_t kIntegerBytes = 21;

/// Writes a number with 17 significant digits, which restore the same bits, and a separator. Returns the end
/// of the text.
char* put_number(char* out, double number, char behind);
char* put_integer(char* out, std::int64_t number, char behind);

/// Writes a number with the fewest digits that restore the same bits, and a separator: at most kNumberBytes.
char* put_shortest(char* out, double number, char behind);

/// Writes the text of `items` items in order. put(item, out) formats one item in at most `most_bytes` bytes
/// and returns its end; it is called from several threads at once. Uses about 10 MB at a time. Throws
/// Error(kInterrupted).
void write_text_lines(OutputFile& file, std::size_t items, std::size_t most_bytes,
                      const std::function<char*(std::size_t item, char* out)>& put,
                      const Monitor& monitor = {});

}  // namespace crossgrain
