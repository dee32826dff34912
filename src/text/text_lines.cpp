// SPDX-License-Identifier: Apache-2.0
#include "text/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Maximum text made by one task.
constexpr std::size_t kTaskBytes = 1 << 18;

/// Tasks between two queries of the monitor: enough to keep many threads busy.
constexpr std::size_t kTasksAtOnce = 64;

constexpr int kDigitsThatRestore = 17;

}  // namespace

char* put_number(char* out, double number, char behind) {
  out = std::to_chars(out, out + kNumberBytes, number, std::chars_format::general, kDigitsThatRestore).ptr;
  *out++ = behind;
  return out;
}

char* put_integer(char* out, std::int64_t number, char behind) {
  out = std::to_chars(out, out + kIntegerBytes, number).ptr;
  *out++ = behind;
  return out;
}

char* put_shortest(char* out, double number, char behind) {
  out = fmt::format_to(out, "{}", number);
  *out++ = behind;
  return out;
}

void write_text_lines(OutputFile& file, std::size_t items, std::size_t most_bytes,
                      const std::function<char*(std::size_t item, char* out)>& put, const Monitor& monitor) {
  const std::size_t task_items = std::max<std::size_t>(1, kTaskBytes / most_bytes);
  std::vector<std::string> texts(kTasksAtOnce);
  for (std::size_t first = 0; first < items; first += kTasksAtOnce * task_items) {
    monitor.check();
    const std::size_t count = std::min(items - first, kTasksAtOnce * task_items);
    parallel_for_chunks(count, task_items, [&](std::size_t begin, std::size_t end) {
      std::string& text = texts[begin / task_items];
      text.resize((end - begin) * most_bytes);
      char* out = text.data();
      for (std::size_t i = begin; i < end; ++i) out = put(first + i, out);
      text.resize(static_cast<std::size_t>(out - text.data()));
    });
    for (std::size_t task = 0; task * task_items < count; ++task) file.write(texts[task]);
  }
}

}  // namespace crossgrain
