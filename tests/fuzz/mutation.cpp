// SPDX-License-Identifier: Apache-2.0
#include "fuzz/mutation.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace crossgrain {
namespace {

using namespace std::string_view_literals;

constexpr std::array kNumberWords = {"0"sv,
                                     "-1"sv,
                                     "1"sv,
                                     "4"sv,
                                     "255"sv,
                                     "65536"sv,
                                     "2147483647"sv,
                                     "-2147483648"sv,
                                     "4294967295"sv,
                                     "4294967296"sv,
                                     "9223372036854775807"sv,
                                     "-9223372036854775808"sv,
                                     "18446744073709551615"sv,
                                     "99999999999999999999"sv,
                                     "1e308"sv,
                                     "-1e-320"sv,
                                     "1e999"sv,
                                     "nan"sv,
                                     "inf"sv,
                                     "0x10"sv,
                                     "1.5"sv,
                                     ""sv,
                                     "-"sv,
                                     "+"sv};

constexpr std::array<std::uint64_t, 14> kNumbers = {0,
                                                    1,
                                                    2,
                                                    3,
                                                    0x7f,
                                                    0x80,
                                                    0xff,
                                                    0xffff,
                                                    0x7fffffff,
                                                    0x80000000,
                                                    0xffffffff,
                                                    0x7fffffffffffffff,
                                                    0x8000000000000000,
                                                    0xffffffffffffffff};

constexpr std::string_view kBytes = "\0\xff\x7f\x80\n\r \t-+.#/\\\"'<>&$_0123456789eE"sv;

/// Not std::uniform_int_distribution, of which every library has its own.
std::size_t below(std::size_t count, std::mt19937& random) {
  return count == 0 ? 0 : random() % count;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

void change_a_byte(std::string& bytes, std::mt19937& random) {
  if (bytes.empty()) return;
  char& byte = bytes[below(bytes.size(), random)];
  if (random() % 2 == 0)
    byte = kBytes[below(kBytes.size(), random)];
  else
    byte = static_cast<char>(byte ^ (1 << below(8, random)));
}

void remove_some(std::string& bytes, std::mt19937& random) {
  const std::size_t at = below(bytes.size() + 1, random);
  bytes.erase(at, 1 + below(16, random));
}

void repeat_some(std::string& bytes, std::mt19937& random) {
  const std::size_t at = below(bytes.size() + 1, random);
  const std::string some = bytes.substr(at, 1 + below(40, random));
  for (std::size_t times = 1 + below(3, random); times > 0; --times) bytes.insert(at, some);
}

void put_in_some(std::string& bytes, std::mt19937& random) {
  const std::size_t at = below(bytes.size() + 1, random);
  bytes.insert(at, 1 + below(4, random), kBytes[below(kBytes.size(), random)]);
}

/// A run of digits, the one at or behind a random place, becomes another number.
void replace_a_word(std::string& bytes, std::mt19937& random) {
  const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size() + 1, random));
  const auto begin = std::find_if(from, bytes.end(), is_digit);
  const auto end = std::find_if_not(begin, bytes.end(), is_digit);
  if (begin != end) bytes.replace(begin, end, kNumberWords[below(kNumberWords.size(), random)]);
}

void overwrite_a_number(std::string& bytes, std::mt19937& random) {
  std::array<char, 8> raw;
  const std::uint64_t number = kNumbers[below(kNumbers.size(), random)];
  for (std::size_t i = 0; i < raw.size(); ++i) raw[i] = static_cast<char>(number >> 8 * i);
  const std::size_t size = std::size_t{1} << below(4, random);
  if (random() % 2 == 0) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
  if (bytes.size() < size) return;
  std::copy_n(raw.begin(), size,
              bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size() - size + 1, random)));
}

void cut_short(std::string& bytes, std::mt19937& random) {
  bytes.resize(below(bytes.size() + 1, random));
}

}  // namespace

std::string mutated(std::span<const std::string> seeds, std::mt19937& random) {
  constexpr std::array kDamages = {change_a_byte, change_a_byte,  remove_some,        repeat_some,
                                   put_in_some,   replace_a_word, overwrite_a_number, cut_short};
  std::string bytes = seeds[below(seeds.size(), random)];
  for (std::size_t damages = 1 + below(4, random); damages > 0; --damages) {
    const std::size_t kind = below(kDamages.size() + 1, random);
    if (kind < kDamages.size()) {
      kDamages[kind](bytes, random);
      continue;
    }
    const std::string& other = seeds[below(seeds.size(), random)];
    bytes.resize(below(bytes.size() + 1, random));
    bytes += other.substr(below(other.size() + 1, random));
  }
  return bytes;
}

}  // namespace crossgrain
