// SPDX-License-Identifier: Apache-2.0
// The features of CAD models against those that gmsh counts.
#include <gtest/gtest.h>

#include <algorithm>

#include "cad_reading/made_cad_answers.hpp"
#include "cad_reading/made_cad_files.hpp"
#include "surface/feature_complex.hpp"

#ifdef CROSSGRAIN_CAD_FILES

namespace crossgrain {
namespace {

struct FeatureCounts {
  const char* model;
  std::size_t corners, curves, soft, faces;
};

/// gmsh 4.8: getEntities and getAdjacencies without curves of one surface (seams) and of no length, two
/// curves joined where no other one ends; soft are those with less than 15 degrees between getNormal of both
/// surfaces on the mean of seven places.
constexpr FeatureCounts kCounts[] = {{"bracket", 42, 78, 28, 34},
                                     {"housing", 80, 146, 64, 68},
                                     {"pillow_block", 48, 78, 26, 31},
                                     {"pipe_branch", 4, 28, 8, 18},
                                     {"wedge", 20, 35, 6, 15}};

TEST(CadFeatures, OfTheProjectsPartsAreThoseThatGmshCounts) {
  for (const auto& [model, corners, curves, soft, faces] : kCounts) {
    SCOPED_TRACE(model);
    const auto path = std::filesystem::path(CROSSGRAIN_MODELS) / (std::string(model) + ".step");
    const FeatureComplex complex = feature_complex(prepare_surface(read_surface(path)));
    EXPECT_EQ(complex.corners.size(), corners);
    EXPECT_EQ(complex.curves.size(), curves);
    EXPECT_EQ(std::ranges::count_if(complex.curves, &FeatureComplex::Curve::is_soft),
              static_cast<std::ptrdiff_t>(soft));
    EXPECT_EQ(complex.faces.size(), faces);
  }
}

}  // namespace
}  // namespace crossgrain

#endif
