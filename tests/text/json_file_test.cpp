// SPDX-License-Identifier: Apache-2.0
#include "text/json_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace crossgrain {
namespace {

TEST(JsonText, KeepsTheOrderOfMembers) {
  nlohmann::ordered_json value;
  value["zebra"] = 1;
  value["apple"] = {{"b", 2}, {"a", 3}};
  EXPECT_EQ(json_text(value), "{\n  \"zebra\": 1,\n  \"apple\": {\n    \"b\": 2,\n    \"a\": 3\n  }\n}\n");
}

TEST(JsonText, WritesDoublesThatReadBackAsTheSameBits) {
  const std::vector<double> numbers = {0.1,  1.0 / 3, 5e-324,       1.7976931348623157e308,
                                       -2.5, 58.26,   123456789.125};
  const nlohmann::ordered_json value = numbers;
  EXPECT_EQ(nlohmann::json::parse(json_text(value)).get<std::vector<double>>(), numbers);
  EXPECT_NE(json_text(value).find("58.26,"), std::string::npos);
}

TEST(JsonText, HasNullForNumbersThatAreNotFinite) {
  const nlohmann::ordered_json value = {NAN, INFINITY, -INFINITY, 1.5};
  EXPECT_EQ(json_text(value), "[\n  null,\n  null,\n  null,\n  1.5\n]\n");
}

TEST(NumbersNotFinite, AreNamedByTheirPlaces) {
  nlohmann::ordered_json value = {{"seconds", 1.5}, {"length", nullptr}};
  EXPECT_TRUE(numbers_not_finite(value).empty());
  value["energy"]["total"] = std::nan("");
  value["levels"] = {{{"energy", 1}}, {{"energy", INFINITY}}};
  value["boxes"] = {{0, 1}, {2, -INFINITY}};
  EXPECT_EQ(numbers_not_finite(value),
            (std::vector<std::string>{"energy.total", "levels[1].energy", "boxes[1][1]"}));
}

TEST(JsonText, ReplacesBytesThatAreNoUtf8) {
  const nlohmann::ordered_json value = {{"path", "part\xff.stl"}};
  EXPECT_NE(json_text(value).find("part\xEF\xBF\xBD.stl"), std::string::npos);
}

}  // namespace
}  // namespace crossgrain
