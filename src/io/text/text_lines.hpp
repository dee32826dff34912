// SPDX-License-Identifier: Apache-2.0
// Lines of numbers, made in parallel and written in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "crossgrain/monitor.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// What put_number takes at most, with the character behind it: sign, 17 digits, point, an exponent such as
/// e-308.
inline constexpr std::size_t kNumberBytes = 25;

/// What put_integer takes at most, with the character behind it.
inline constexpr std::size_t kIntegerBytes = 21;

/// A number with 17 significant digits, which read back as the same bits, and a blank or the like behind it.
/// Returns where the next one goes.
char* put_number(char* out, double number, char behind);
char* put_integer(char* out, std::int64_t number, char behind);

/// Writes the text of `items` items, one after the other. put(item, out) makes that of one, of at most
/// `most_bytes` bytes, and returns its end; it is called from several threads at once. Holds some 10 MB of
/// text at a time. Throws Error(kInterrupted).
void write_text_lines(OutputFile& file, std::size_t items, std::size_t most_bytes,
                      const std::function<char*(std::size_t item, char* out)>& put,
                      const Monitor& monitor = {});

}  // namespace crossgrain
