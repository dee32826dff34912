// SPDX-License-Identifier: Apache-2.0
#include "picture/font.hpp"

#include <gtest/gtest.h>

namespace crossgrain {
namespace {

TEST(Font, IsAsWideAsItsTextIsLong) {
  const Font& font = Font::sans();
  EXPECT_NEAR(font.width("nnnn", 20), 4 * font.width("n", 20), 1e-4);
  EXPECT_NEAR(font.width("n", 40), 2 * font.width("n", 20), 1e-4);
  EXPECT_EQ(font.width("", 20), 0);
}

TEST(Font, TakesLettersOfSeveralBytesForOne) {
  const Font& font = Font::sans();
  EXPECT_LT(font.width("−", 20), font.width("mm", 20));
  EXPECT_GT(font.width("⁻²", 20), 0);
}

TEST(Font, CoversPixelsBetweenBaselineAndCapitalHeightForACapital) {
  const Font& font = Font::sans();
  double most = 0;
  int top = 1000, bottom = -1000;
  font.draw("H", 10, 50, 40, [&](int, int y, float coverage) {
    most += static_cast<double>(coverage);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  });
  EXPECT_GT(most, 100);
  EXPECT_EQ(bottom, 49);
  EXPECT_NEAR(top, 50 - font.capital_height(40), 1);
}

TEST(Font, TakesAnyBytes) {
  Font::sans().draw("\xff\xc3\xe2\x88", 0, 0, 20, [](int, int, float) {});
}

}  // namespace
}  // namespace crossgrain
