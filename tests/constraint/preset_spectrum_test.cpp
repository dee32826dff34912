// SPDX-License-Identifier: Apache-2.0
// The matrices, spectra and null spaces of the note (arXiv 2309.13477), from the program's own forms.
#include <cmath>

#include "crossgrain/error.hpp"
#include "crossgrain/spectrum.hpp"
#include "gtest/gtest.h"

namespace crossgrain {
namespace {

constexpr double kTolerance = 1e-12;
using Rows = std::vector<std::vector<double>>;

void expect_vector(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], kTolerance) << "entry " << i;
}

void expect_rows(const Rows& found, const Rows& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    SCOPED_TRACE("row " + std::to_string(i));
    expect_vector(found[i], expected[i]);
  }
}

Rows diagonal(const std::vector<double>& entries) {
  Rows rows(entries.size(), std::vector<double>(entries.size(), 0.0));
  for (std::size_t i = 0; i < entries.size(); ++i) rows[i][i] = entries[i];
  return rows;
}

std::vector<double> unit(std::size_t size, std::size_t index, double length = 1) {
  std::vector<double> v(size, 0.0);
  v[index] = length;
  return v;
}

std::vector<double> over(std::vector<double> entries, double divisor) {
  for (double& entry : entries) entry /= divisor;
  return entries;
}

TEST(PlanePreset, OfDegreeThreeKeepsTheTwoHarmonicsOfOrderTwo) {
  const SpectrumReport report = spectrum_of_preset("plane", Degree::kThree);
  expect_rows(report.matrix, diagonal({1, 0, 1, 1, 1, 0, 1}));
  expect_vector(report.eigenvalues, {0, 0, 1, 1, 1, 1, 1});
  expect_rows(report.null_space, {unit(7, 1), unit(7, 5)});
}

TEST(PlanePreset, OfDegreeFourHasTheAffineNullSetOfFramesAboutZ) {
  const SpectrumReport report = spectrum_of_preset("plane", Degree::kFour);
  expect_rows(report.matrix, diagonal({0, 1, 1, 1, 1, 1, 1, 1, 0}));
  expect_vector(report.linear, unit(9, 4, std::sqrt(7.0 / 12)));
  EXPECT_NEAR(report.constant, 7.0 / 12, kTolerance);
  expect_rows(report.null_space, {unit(9, 4, std::sqrt(7.0 / 12)), unit(9, 0), unit(9, 8)});
}

TEST(CubePreset, OfDegreeThreeHasTheMatrixOfTheNote) {
  // 3 I minus the projectors onto x y z (three times), z (x^2 - y^2), x (y^2 - z^2), y (z^2 - x^2).
  const double a = std::sqrt(15.0) / 8;
  Rows expected = diagonal({21.0 / 8, 0, 19.0 / 8, 3, 19.0 / 8, 2, 21.0 / 8});
  expected[0][2] = expected[2][0] = a;
  expected[4][6] = expected[6][4] = -a;
  expect_rows(spectrum_of_preset("cube", Degree::kThree).matrix, expected);
}

TEST(CubePreset, OfDegreeThreeHasTheCubeAsItsNullSpace) {
  const SpectrumReport report = spectrum_of_preset("cube", Degree::kThree);
  expect_vector(report.eigenvalues, {0, 2, 2, 2, 3, 3, 3});
  expect_rows(report.null_space, {unit(7, 1)});
  expect_vector(report.linear, std::vector<double>(7, 0.0));
  EXPECT_EQ(report.constant, 0);
}

TEST(CubePreset, OfDegreeFourHasTheMatrixOfTheNote) {
  // 3 I minus the projectors onto x y (x^2 - y^2), x^4 - 6 x^2 y^2 + y^4 and the same with axes exchanged.
  const double a = std::sqrt(7.0) / 8, b = std::sqrt(35.0) / 32;
  Rows expected = diagonal({2, 23.0 / 8, 3, 17.0 / 8, 61.0 / 32, 17.0 / 8, 17.0 / 8, 23.0 / 8, 63.0 / 32});
  expected[1][3] = expected[3][1] = -a;
  expected[5][7] = expected[7][5] = a;
  expected[4][8] = expected[8][4] = -b;
  const SpectrumReport report = spectrum_of_preset("cube", Degree::kFour);
  expect_rows(report.matrix, expected);
  std::vector<double> linear = unit(9, 4, std::sqrt(7.0 / 12) * 7 / 4);
  linear[8] = std::sqrt(7.0 / 12) * std::sqrt(35.0) / 4;
  expect_vector(report.linear, linear);
  EXPECT_NEAR(report.constant, 7.0 / 4, kTolerance);
}

TEST(CubePreset, OfDegreeFourIsMinimisedByTheReferenceFrameAlone) {
  const SpectrumReport report = spectrum_of_preset("cube", Degree::kFour);
  expect_vector(report.eigenvalues, {1.75, 2, 2, 2, 2.125, 2.125, 3, 3, 3});
  std::vector<double> frame = unit(9, 4, std::sqrt(7.0 / 12));
  frame[8] = std::sqrt(5.0 / 12);
  expect_rows(report.null_space, {frame});
}

TEST(CylinderPreset, OfDegreeThreeHasTheMatrixOfTheNote) {
  const SpectrumReport report = spectrum_of_preset("cylinder", Degree::kThree);
  expect_rows(report.matrix, diagonal(over({13, 8, 11, 16, 11, 8, 13}, 16)));
  expect_vector(report.eigenvalues, over({8, 8, 11, 11, 13, 13, 16}, 16));
}

TEST(CylinderPreset, OfDegreeThreeLeavesTheFramesAboutItsAxis) {
  expect_rows(spectrum_of_preset("cylinder", Degree::kThree).null_space, {unit(7, 1), unit(7, 5)});
}

TEST(CylinderPreset, OfDegreeFourHasTheMatrixOfTheNote) {
  const SpectrumReport report = spectrum_of_preset("cylinder", Degree::kFour);
  expect_rows(report.matrix, diagonal(over({127, 120, 100, 72, 58, 72, 100, 120, 127}, 128)));
  expect_vector(report.linear, unit(9, 4, 3.0 / 8 * std::sqrt(7.0 / 12)));
  EXPECT_NEAR(report.constant, 7.0 / 12, kTolerance);
}

TEST(CylinderPreset, OfDegreeFourLeavesTheFramesAboutItsAxis) {
  expect_rows(spectrum_of_preset("cylinder", Degree::kFour).null_space,
              {unit(9, 4, std::sqrt(7.0 / 12)), unit(9, 0), unit(9, 8)});
}

TEST(SpherePreset, OfDegreeThreeIsFiveSeventhsOfTheIdentity) {
  const SpectrumReport report = spectrum_of_preset("sphere", Degree::kThree);
  expect_rows(report.matrix, diagonal(std::vector<double>(7, 5.0 / 7)));
  EXPECT_EQ(report.null_space.size(), 7u);
}

TEST(SpherePreset, OfDegreeFourIsSevenNinthsOfTheIdentityAndLeavesEverything) {
  const SpectrumReport report = spectrum_of_preset("sphere", Degree::kFour);
  expect_rows(report.matrix, diagonal(std::vector<double>(9, 7.0 / 9)));
  expect_vector(report.linear, std::vector<double>(9, 0.0));
  ASSERT_EQ(report.null_space.size(), 10u);
  expect_vector(report.null_space[0], std::vector<double>(9, 0.0));
}

TEST(SpectrumOfNormals, TakesNormalsOfAnyLength) {
  const std::vector<WeightedNormal> normals{{{0, 0, 5}, 1}, {{0, -0.1, 0}, 1}, {{1e-200, 0, 0}, 1}};
  expect_rows(spectrum_of_normals(normals, Degree::kThree).matrix,
              spectrum_of_preset("cube", Degree::kThree).matrix);
}

TEST(SpectrumOfNormals, GivesEigenvaluesOfTheWeightedSum) {
  const std::vector<WeightedNormal> normals{{{0, 0, 1}, 2.5}};
  expect_vector(spectrum_of_normals(normals, Degree::kThree).eigenvalues, {0, 0, 2.5, 2.5, 2.5, 2.5, 2.5});
}

TEST(SpectrumOfNormals, RefusesWhatIsNoNormal) {
  const double nan = std::nan("");
  EXPECT_THROW(spectrum_of_normals({}, Degree::kThree), Error);
  for (const WeightedNormal& bad : {WeightedNormal{{0, 0, 0}, 1},
                                    {{1, nan, 0}, 1},
                                    {{0, 0, INFINITY}, 1},
                                    {{0, 0, 1}, 0},
                                    {{0, 0, 1}, -1},
                                    {{0, 0, 1}, nan},
                                    {{0, 0, 1}, INFINITY}}) {
    EXPECT_THROW(spectrum_of_normals(std::vector{bad}, Degree::kFour), Error);
  }
}

TEST(SpectrumOfPreset, RefusesOtherNamesAsWrongUsage) {
  try {
    spectrum_of_preset("teapot", Degree::kThree);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_NE(std::string(error.what()).find("teapot"), std::string::npos);
  }
}

}  // namespace
}  // namespace crossgrain
