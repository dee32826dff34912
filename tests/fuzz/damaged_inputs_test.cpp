// SPDX-License-Identifier: Apache-2.0
// Every reader given damaged inputs: those that once broke it, and some hundreds made anew.
#include <gtest/gtest.h>

#include <filesystem>

#include "files/temporary_folder.hpp"
#include "fuzz/made_inputs.hpp"
#include "fuzz/mutation.hpp"
#include "fuzz/reader_checks.hpp"
#include "support/allocation_watch.hpp"
#include "support/nightly.hpp"

namespace crossgrain {
namespace {

/// A computation takes a hundred times as long as a reader.
int mutations_of(const ReaderUnderTest& reader) {
  if (reader.computes) return is_nightly() ? 1000 : 10;
  return is_nightly() ? 3000 : 100;
}

class EveryReader : public testing::TestWithParam<ReaderUnderTest> {
 protected:
  /// How the reader broke its promise; empty where it kept it, having taken or refused the bytes.
  static std::string fault(std::string_view bytes, bool must_take = false) {
    watch_allocations();
    try {
      if (!GetParam().check(bytes) && must_take) return "refused";
    } catch (const std::exception& exception) {
      return exception.what();
    }
    if (!GetParam().computes && largest_allocation() > most_allocated_at_once(bytes))
      return "takes " + std::to_string(largest_allocation()) + " bytes at once for a file of " +
             std::to_string(bytes.size());
    return "";
  }
};

/// Bytes as a string of C++, to make a failure again from.
std::string shown(std::string_view bytes) {
  std::string out;
  for (const char c : bytes) {
    constexpr const char* kDigits = "01234567";
    const auto code = static_cast<unsigned char>(c);
    if (c >= ' ' && c <= '~' && c != '"' && c != '\\' && c != '?')
      out += c;
    else
      for (const int shift : {6, 3, 0}) (out += shift == 6 ? "\\" : "") += kDigits[code >> shift & 7];
  }
  return "\"" + out + "\"";
}

TEST_P(EveryReader, ReadsWhatIsMadeForIt) {
  for (const std::string& input : made_inputs(GetParam().name))
    EXPECT_EQ(fault(input, true), "") << shown(input);
}

TEST_P(EveryReader, ReadsOrRefusesDamagedInputs) {
  const std::vector<std::string> seeds = made_inputs(GetParam().name);
  std::mt19937 random(1);
  for (int i = 0; i < mutations_of(GetParam()); ++i) {
    const std::string input = mutated(seeds, random);
    ASSERT_EQ(fault(input), "") << shown(input);
  }
}

TEST_P(EveryReader, RefusesNothingAtAll) {
  EXPECT_EQ(fault(""), "");
}

std::string name_of(const testing::TestParamInfo<ReaderUnderTest>& tested) {
  return std::string(tested.param.name);
}

INSTANTIATE_TEST_SUITE_P(All, EveryReader,
                         testing::ValuesIn(readers_under_test().begin(), readers_under_test().end()),
                         name_of);

std::filesystem::path regression_inputs(const ReaderUnderTest& reader) {
  return std::filesystem::path(CROSSGRAIN_REGRESSION_INPUTS) / reader.name;
}

std::vector<ReaderUnderTest> readers_once_broken() {
  std::vector<ReaderUnderTest> broken;
  for (const ReaderUnderTest& reader : readers_under_test())
    if (std::filesystem::exists(regression_inputs(reader))) broken.push_back(reader);
  return broken;
}

class ReaderOnceBroken : public EveryReader {};

TEST_P(ReaderOnceBroken, ReadsOrRefusesWhatBrokeIt) {
  for (const auto& entry : std::filesystem::directory_iterator(regression_inputs(GetParam())))
    EXPECT_EQ(fault(content_of(entry.path())), "") << entry.path();
}

INSTANTIATE_TEST_SUITE_P(All, ReaderOnceBroken, testing::ValuesIn(readers_once_broken()), name_of);

}  // namespace
}  // namespace crossgrain
