// SPDX-License-Identifier: Apache-2.0
#include "text/text_scanner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "crossgrain/error.hpp"
#include "files/temporary_folder.hpp"
#include "text/comma_locale.hpp"

namespace crossgrain {
namespace {

/// The number that a file holds.
double number_in(const std::string& text) {
  const TemporaryFolder folder;
  const InputFile file(folder.write("a.txt", text));
  TextScanner scanner(file, {});
  return scanner.number(scanner.word(), "a coordinate");
}

/// What is wrong with it; empty where nothing is.
std::string complaint_about(const std::string& text) {
  try {
    number_in(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

const std::vector<std::string> kTooLarge = {"1e309",
                                            "-1.8e308",
                                            "+1.5E+400",
                                            "1e99999999999999999999",
                                            "0.001e312",
                                            "1" + std::string(400, '0'),
                                            "0." + std::string(400, '0') + "1e9223372036854775807"};

const std::vector<std::string> kTooSmall = {"2e-324",
                                            "-2.4e-324",
                                            "+1.5E-400",
                                            "1e-99999999999999999999",
                                            "1000e-328",
                                            "0." + std::string(400, '0') + "1",
                                            "1" + std::string(400, '0') + "e-9223372036854775808"};

void expect_numbers_out_of_range_are_told_apart() {
  for (const std::string& text : kTooLarge)
    EXPECT_NE(complaint_about(text).find("not a finite number"), std::string::npos) << text;
  for (const std::string& text : kTooSmall) {
    EXPECT_EQ(number_in(text), 0) << text;
    EXPECT_EQ(std::signbit(number_in(text)), text[0] == '-') << text;
  }
}

TEST(TextScanner, RefusesNumbersBeyondDoublesAndTakesThoseBelowForZero) {
  expect_numbers_out_of_range_are_told_apart();
}

TEST(TextScanner, RoundsNumbersAtBothEndsOfTheRangeToTheNearestDouble) {
  EXPECT_EQ(number_in("1.7976931348623158e308"), 1.7976931348623157e308);
  EXPECT_EQ(number_in("-1e-310"), -1e-310);
  EXPECT_EQ(number_in("2.5e-324"), 5e-324);
}

TEST(TextScanner, ReadsTheSameNumbersWhereTheProgramHasADecimalComma) {
  const CommaLocale locale;
  if (!locale.made()) GTEST_SKIP() << "no locale could be made: " << locale.complaints();
  ASSERT_EQ(std::strtod("1,5", nullptr), 1.5) << "the locale is not in force";
  EXPECT_EQ(number_in("1.5"), 1.5);
  expect_numbers_out_of_range_are_told_apart();
  EXPECT_NE(complaint_about("1,5"), "");
}

}  // namespace
}  // namespace crossgrain
