// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "crossgrain/error.hpp"
#include "crossgrain/reading.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {
namespace {

class ConstraintsReader : public ::testing::Test {
 protected:
  Constraints read(const std::string& text) const { return read_constraints(folder_.write("c.json", text)); }

  /// The message without the folder: "c.json: line LINE: ...".
  std::string fault_of(const std::string& text) const {
    try {
      read(text);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      const std::string message = error.what();
      EXPECT_EQ(message.find('\n'), message.npos);
      return message.substr(message.find("c.json"));
    }
    return "";
  }

  void expect_fault(const std::string& text, const std::string& place, const std::string& words) const {
    const std::string fault = fault_of(text);
    EXPECT_TRUE(fault.starts_with("c.json: " + (place.empty() ? "" : place + ": "))) << fault;
    EXPECT_NE(fault.find(words), fault.npos) << fault;
  }

  /// One point, the members of which stand on line 3.
  static std::string with_point(const std::string& members) {
    return "{\"schema\": 1,\n\"points\": [\n{" + members + "}\n]}";
  }

  TemporaryFolder folder_;
};

TEST_F(ConstraintsReader, ReadsEveryKind) {
  const Constraints constraints = read(R"({
  "schema": 1,
  "points": [
    {"at": [1, 2, 3], "axis": [0, 0, 2], "weight": 2.5},
    {"at": [[4, 5, 6],
            [7, 8, 9]], "frame": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "weight": [3, 4]}
  ],
  "polylines": [
    {"points": [[0, 0, 0], [1, 0, 0]], "axis": "tangent"},
    {"points": [[0, 0, 0], [1, 0, 0]], "axis": [0, 1, 0], "weight": 5}
  ],
  "faces": [
    {"face": [3, -7], "axis": "normal"},
    {"face": 9, "axis": [0, 0, 1], "weight": 6}
  ],
  "stresses": [
    {"at": [1, 1, 1], "stress": [1, 2, 3, 4, 5, 6]},
    {"at": [[2, 2, 2], [3, 3, 3]], "stress": [[1, 0, 0, 0, 0, 0], [0, 1e3, 0, 0, 0, 0]], "weight": 7}
  ]
})");
  ASSERT_EQ(constraints.points.size(), 3u);
  EXPECT_EQ(constraints.points[0].at, (Vector3{1, 2, 3}));
  EXPECT_EQ(constraints.points[0].axes, (std::vector<Vector3>{{0, 0, 2}}));
  EXPECT_EQ(constraints.points[0].weight, 2.5);
  EXPECT_EQ(constraints.points[0].line, 4u);
  EXPECT_EQ(constraints.points[1].axes.size(), 3u);
  EXPECT_EQ(constraints.points[1].weight, 3);
  EXPECT_EQ(constraints.points[2].at, (Vector3{7, 8, 9}));
  EXPECT_EQ(constraints.points[2].weight, 4);
  EXPECT_EQ(constraints.points[2].line, 6u);
  ASSERT_EQ(constraints.polylines.size(), 2u);
  EXPECT_TRUE(constraints.polylines[0].axes.empty());
  EXPECT_EQ(constraints.polylines[0].weight, 1);
  EXPECT_EQ(constraints.polylines[1].axes, (std::vector<Vector3>{{0, 1, 0}}));
  EXPECT_EQ(constraints.polylines[1].line, 10u);
  ASSERT_EQ(constraints.faces.size(), 3u);
  EXPECT_EQ(constraints.faces[1].face, -7);
  EXPECT_TRUE(constraints.faces[1].axes.empty());
  EXPECT_EQ(constraints.faces[2].weight, 6);
  ASSERT_EQ(constraints.stresses.size(), 3u);
  EXPECT_EQ(constraints.stresses[0].tensor, (std::array<double, 6>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(constraints.stresses[2].tensor[1], 1e3);
  EXPECT_EQ(constraints.stresses[2].weight, 7);
  EXPECT_TRUE(constraints.source.ends_with("c.json"));
  EXPECT_NO_THROW(check_constraints(constraints));
}

TEST_F(ConstraintsReader, NamesTheLineOfWhatIsNoJson) {
  expect_fault("{\"schema\": 1,\n\"points\": [\n{]\n}", "line 3", "is not JSON at column 2");
  expect_fault("{\"schema\": 1\n\"points\": []}", "line 2", "is not JSON");
  expect_fault("{\"schema\": 1,\r\n\r\n!}", "line 3", "column 1");
  expect_fault("{\"schema\": 1,\r\r!}", "line 3", "column 1");
  expect_fault("{\"schema\": 1,\n\"points\": [\n", "line 2", "unexpected end of input");
  expect_fault("{\"schema\": 1} 2", "line 1", "expected end of input");
  expect_fault("{\"schema\": NaN}", "line 1", "invalid literal");
  expect_fault("\xff\xfe{", "line 1", "is not JSON");
  expect_fault("\n\n{\"a\xff\": 1}", "line 3", "UTF-8");
  expect_fault("{\n\"a\": \"b\n\"}", "line 2", "control character");
  expect_fault(with_point("\"at\": [0, 0, 1e999]"), "line 3", "'1e999' is too large");
}

TEST_F(ConstraintsReader, NamesTheLineOfANumberThatEndsItsLine) {
  expect_fault("{\"schema\":\n2\n\n}", "line 2", "'schema' must be 1");
}

TEST_F(ConstraintsReader, RefusesWhatNestsDeeply) {
  expect_fault("{\"schema\": 1,\n\"points\": " + std::string(100000, '['), "line 2",
               "nested more than 32 deep");
}

TEST_F(ConstraintsReader, RefusesKeysThatAreThereTwice) {
  expect_fault("{\"schema\": 1,\n\"points\": [],\n\n\"points\": []}", "line 4", "repeated, first on line 2");
  expect_fault(with_point("\"at\": [0, 0, 0], \"at\": [0, 0, 0]"), "line 3", "'at' is repeated");
}

TEST_F(ConstraintsReader, RefusesUnknownKeys) {
  expect_fault("{\"schema\": 1,\n\"point\": []}", "line 2",
               "'point' is not a key of the file, which may have");
  expect_fault(with_point("\"at\": [0, 0, 0],\n\"axes\": [1, 0, 0]"), "line 4",
               "'axes' is not a key of a point");
}

TEST_F(ConstraintsReader, RefusesAnotherSchema) {
  expect_fault("{\n\"points\": []}", "line 1", "'schema' is missing");
  expect_fault("{\n\"schema\": 2}", "line 2", "must be 1");
  expect_fault("{\n\"schema\": \"1\"}", "line 2", "must be 1");
  expect_fault("[1]", "line 1", "must be an object");
  expect_fault("\n3", "line 2", "must be an object");
}

TEST_F(ConstraintsReader, RefusesFilesWithoutConstraints) {
  expect_fault("{\"schema\": 1}", "line 1", "no constraints");
  expect_fault("{\"schema\": 1, \"points\": []}", "line 1", "no constraints");
  expect_fault("{\"schema\": 1,\n\"points\": {}}", "line 2", "'points' must be a list");
}

TEST_F(ConstraintsReader, NamesTheLineOfAFaultyPoint) {
  const std::string at = "\"at\": [0, 0, 0],\n", axis = "\"axis\": [1, 0, 0]";
  expect_fault(with_point(axis), "line 3", "'at' is missing");
  expect_fault(with_point("\n\n\"at\": [0, 0], " + axis), "line 5", "'at' must be three numbers");
  expect_fault(with_point("\"at\": [0, 0, \"0\"], " + axis), "line 3", "'at' must be three numbers");
  expect_fault(with_point("\"at\": [], " + axis), "line 3", "'at' must be three numbers");
  expect_fault(with_point("\"at\": [[0, 0, 0],\n[1, 1]], " + axis), "line 4", "'at' must be three numbers");
  expect_fault(with_point("\"at\": [1e101, 0, 0], " + axis), "line 3", "below 1e100");
  expect_fault(with_point("\"at\": [0, 0, 0]"), "line 3", "either 'axis' or 'frame'");
  expect_fault(with_point(at + axis + ", \"frame\": []"), "line 3", "either 'axis' or 'frame'");
  expect_fault(with_point(at + "\"axis\": [0, 0, 0]"), "line 4", "must not be zero");
  expect_fault(with_point(at + "\"axis\": \"tangent\""), "line 4", "'axis' must be three numbers");
  expect_fault(with_point(at + "\"axis\": null"), "line 4", "'axis' must be three numbers");
  for (const char* weight : {"0", "-1", "10001", "\"1\"", "true", "null", "[1]"})
    expect_fault(with_point(at + axis + ",\n\"weight\": " + weight), "line 5", "positive number");
  expect_fault(with_point("\"at\": [[0, 0, 0]], \n\"weight\": [1, 2], " + axis), "line 4",
               "2 numbers for 1 place");
  expect_fault(with_point("\"at\": [[0, 0, 0]], \n\"weight\": [\n0], " + axis), "line 5", "positive number");
}

TEST_F(ConstraintsReader, NamesTheLineOfAFaultyFrame) {
  const std::string begin = "\"at\": [0, 0, 0],\n\"frame\": ";
  expect_fault(with_point(begin + "[1, 0, 0]"), "line 4", "'frame' must be three axes");
  expect_fault(with_point(begin + "[[1, 0, 0], [0, 1, 0]]"), "line 4", "'frame' must be three axes");
  expect_fault(with_point(begin + "[[1, 0, 0],\n[0, 0, 0], [0, 0, 1]]"), "line 5", "must not be zero");
  expect_fault(with_point(begin + "[[1, 0, 0],\n[0.1, 1, 0], [0, 0, 1]]"), "line 4", "at right angles");
  EXPECT_EQ(fault_of(with_point(begin + "[[1, 0.01, 0], [0, 1, 0], [0, 0, -1]]")), "");
}

TEST_F(ConstraintsReader, NamesTheLineOfAFaultyPolylineFaceOrStress) {
  const auto with = [](const char* kind, const char* members) {
    return std::string("{\"schema\": 1, \"") + kind + "\": [\n{" + members + "}]}";
  };
  expect_fault(with("polylines", "\"points\":\n[0, 0, 0], \"axis\": \"tangent\""), "line 3",
               "list of places");
  expect_fault(with("polylines", "\"points\":\n[[0, 0, 0]], \"axis\": \"tangent\""), "line 3", "two points");
  expect_fault(with("polylines", "\"points\": [[0, 0, 0], [0, 0, 0]], \"axis\": \"tangent\""), "line 2",
               "at one place");
  expect_fault(with("polylines", "\"points\": [[0, 0, 0], [1, 0, 0]],\n\"axis\": \"normal\""), "line 3",
               "\"tangent\"");
  expect_fault(with("polylines", "\"points\": [[0, 0, 0], [1, 0, 0]]"), "line 2", "either 'axis' or 'frame'");
  for (const char* face : {"1.5", "\"1\"", "[]", "3000000000", "[1, [2]]"})
    expect_fault(with("faces", ("\"axis\": \"normal\", \"face\":\n" + std::string(face)).c_str()), "line 3",
                 "'face' must be a whole number");
  expect_fault(with("faces", "\"face\": 1, \"axis\":\n\"tangent\""), "line 3", "\"normal\"");
  expect_fault(with("stresses", "\"at\": [0, 0, 0], \"stress\":\n[1, 2, 3]"), "line 3", "six numbers");
  expect_fault(with("stresses", "\"at\": [[0, 0, 0]], \"stress\":\n[[1, 2, 3, 4, 5, 6], [1, 2, 3, 4, 5, 6]]"),
               "line 3", "2 tensors for 1 place");
  expect_fault(with("stresses", "\"at\": [0, 0, 0]"), "line 2", "'stress' is missing");
  expect_fault(with("stresses", "\"at\": [0, 0, 0], \"stress\": [1, 2, 3, 4, 5, 6], \"axis\":\n[1, 0, 0]"),
               "line 3", "not a key of a stress");
}

TEST_F(ConstraintsReader, ReadsManyStresses) {
  std::string at, stress;
  constexpr int kMany = 50000;
  for (int k = 0; k < kMany; ++k) {
    at += (k ? ",\n[" : "[") + std::to_string(k) + ", 0.25, -1e-3]";
    stress += (k ? ",\n[" : "[") + std::to_string(k) + ", 1, 2, 3, 4, 5]";
  }
  const Constraints constraints =
      read("{\"schema\": 1, \"stresses\": [{\"at\": [" + at + "],\n\"stress\": [" + stress + "]}]}");
  ASSERT_EQ(constraints.stresses.size(), static_cast<std::size_t>(kMany));
  EXPECT_EQ(constraints.stresses.back().at[0], kMany - 1);
  EXPECT_EQ(constraints.stresses.back().line, static_cast<std::size_t>(kMany));
}

TEST_F(ConstraintsReader, RefusesFilesThatAreMissingOrEmpty) {
  EXPECT_THROW(read_constraints(folder_.path() / "none.json"), Error);
  expect_fault("", "", "empty");
}

}  // namespace
}  // namespace crossgrain
