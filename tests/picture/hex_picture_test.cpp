// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/picture.hpp"
#include "files/temporary_folder.hpp"
#include "measure/hex_quality.hpp"
#include "mesh_files/made_bricks.hpp"
#include "picture/camera.hpp"
#include "picture/hex_drawing.hpp"
#include "picture/read_png.hpp"

namespace crossgrain {
namespace {

/// Bricks of which each has a shape of its own; none is inverted.
HexMesh crooked_bricks() {
  HexMesh mesh = made_bricks({6, 5, 4}, {6, 5, 4});
  std::mt19937 random(5);
  for (Vector3& vertex : mesh.vertices)
    for (double& x : vertex) x += 0.3 * static_cast<double>(random()) / 4294967296.0;
  return mesh;
}

/// The same with its first hexahedron turned inside out.
HexMesh inverted_bricks() {
  HexMesh mesh = crooked_bricks();
  for (std::size_t k = 0; k < 4; ++k) std::swap(mesh.hexahedra[0][k], mesh.hexahedra[0][k + 4]);
  return mesh;
}

const Vector3 kFromTheFront{0, -1, 0};

class HexPicture : public testing::Test {
 protected:
  HexPicture() { options.size = {200, 150}; }

  std::filesystem::path drawn(const HexMesh& mesh, const HexReport* report = nullptr) {
    render_picture(mesh, folder.path() / "a.png", options, report);
    return folder.path() / "a.png";
  }

  /// The kind and the words of the error; fails if there is none, or a file.
  std::pair<ErrorKind, std::string> error(const HexMesh& mesh) {
    try {
      render_picture(mesh, folder.path() / "none.png", options);
    } catch (const Error& error) {
      EXPECT_EQ(folder.names(), std::vector<std::string>{});
      return {error.kind(), error.what()};
    }
    ADD_FAILURE() << "no error";
    return {};
  }

  /// The legend as text.
  std::string legend(const HexMesh& mesh, const HexReport* report = nullptr) {
    return text_of(ShownHexahedra(mesh, options, kFromTheFront).legend(report));
  }

  TemporaryFolder folder;
  PictureOptions options;
};

TEST_F(HexPicture, HasTheSameBytesOnAnyNumberOfThreads) {
  options.cut = PictureOptions::Cut{1, std::nullopt};
  options.quality_below = 0.8;
  const HexMesh mesh = inverted_bricks();
  std::set<std::string> contents;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    contents.insert(content_of(drawn(mesh)));
  }
  EXPECT_EQ(contents.size(), 1u);
}

TEST_F(HexPicture, IsAnotherForEveryOption) {
  const HexMesh mesh = crooked_bricks();
  std::set<std::string> contents{content_of(drawn(mesh))};
  const auto with = [&](const auto& change) {
    const PictureOptions before = options;
    change();
    contents.insert(content_of(drawn(mesh)));
    options = before;
  };
  with([&] { options.cut = PictureOptions::Cut{0, std::nullopt}; });
  with([&] { options.cut = PictureOptions::Cut{0, 1.2}; });
  with([&] { options.quality_below = 0.8; });
  with([&] { options.up_axis = 1; });
  with([&] { options.view = view_named("back"); });
  with([&] { options.background = PictureBackground::kDark; });
  contents.insert(content_of(drawn(inverted_bricks())));
  EXPECT_EQ(contents.size(), 8u);
}

TEST_F(HexPicture, ByFaceHasTheColoursAndNumbersOfTheModelsFaces) {
  HexMesh mesh = made_bricks({4, 3, 2}, {4, 3, 2});
  std::set<std::string> contents{content_of(drawn(mesh))};
  options.colour = PictureColour::kFace;
  EXPECT_EQ(legend(mesh).find("Scaled Jacobian"), std::string::npos);
  EXPECT_NE(legend(mesh).find("Faces (6)"), std::string::npos) << legend(mesh);
  contents.insert(content_of(drawn(mesh)));
  for (HexMesh::Face& face : mesh.boundary) face.tag = 3;
  contents.insert(content_of(drawn(mesh)));
  EXPECT_EQ(contents.size(), 3u);
}

TEST_F(HexPicture, ByFaceNeedsTagsOfFaces) {
  HexMesh mesh = made_bricks({4, 3, 2}, {4, 3, 2});
  for (HexMesh::Face& face : mesh.boundary) face.tag = 0;
  options.colour = PictureColour::kFace;
  EXPECT_EQ(error(mesh).first, ErrorKind::kInput);
}

/// Hexahedra behind the plane as seen, counted from their corners.
std::size_t count_behind(const HexMesh& mesh, std::size_t axis, double position, bool keeps_high) {
  std::size_t count = 0;
  for (const auto& hexahedron : mesh.hexahedra) {
    double sum = 0;
    for (const std::uint32_t vertex : hexahedron) sum += mesh.vertices[vertex][axis];
    count += keeps_high ? sum / 8 > position : sum / 8 < position;
  }
  return count;
}

TEST_F(HexPicture, KeepsTheHexahedraWhoseCentresAreBehindTheCut) {
  const HexMesh mesh = crooked_bricks();
  options.cut.emplace();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      for (const double position : {1.3, 2.6, 3.2}) {
        options.cut = PictureOptions::Cut{axis, position};
        Vector3 towards{0.1, 0.1, 0.1};
        towards[static_cast<std::size_t>(axis)] = sign;
        const std::size_t expected = count_behind(mesh, static_cast<std::size_t>(axis), position, sign < 0);
        const std::string text = text_of(ShownHexahedra(mesh, options, normalised(towards)).legend(nullptr));
        EXPECT_NE(text.find("\n" + counted(expected, "hexahedron", "hexahedra") + " shown"),
                  std::string::npos)
            << text;
      }
    }
  }
}

TEST_F(HexPicture, RemovesALayerThatThePlaneHalves) {
  // The plane in the middle of five bricks goes through the centres of the third ones.
  options.cut = PictureOptions::Cut{1, std::nullopt};
  EXPECT_NE(legend(made_bricks({6, 5, 4}, {6, 5, 4})).find("\n48 hexahedra shown"), std::string::npos);
}

TEST_F(HexPicture, DrawsTheHexahedraBelowALimit) {
  const HexMesh mesh = crooked_bricks();
  options.quality_below = 0.8;
  std::size_t expected = 0;
  for (const double shape : scaled_jacobians(mesh)) expected += shape < 0.8;
  EXPECT_GT(expected, 1u);
  EXPECT_LT(expected, mesh.hexahedra.size());
  EXPECT_NE(legend(mesh).find("\n" + std::to_string(expected) + " hexahedra shown, below 0.8"),
            std::string::npos);
  drawn(mesh);
}

TEST_F(HexPicture, SaysInItsLegendWhatTheMeshIsAndHowGood) {
  const HexMesh mesh = crooked_bricks();
  const std::vector<double> shapes = scaled_jacobians(mesh);
  const std::string worst = fmt::format("worst {:.2g}", *std::min_element(shapes.begin(), shapes.end()));
  EXPECT_EQ(legend(mesh), "120 hexahedra\nScaled Jacobian\n  0 to 1\n  " + worst + "\n");
  HexReport report;
  report.outcome = HexOutcome::kAllHex;
  EXPECT_EQ(legend(mesh, &report).substr(0, 24), "All-hex: 120 hexahedra\nS");
  report.outcome = HexOutcome::kApproximate;
  EXPECT_EQ(legend(mesh, &report).substr(0, 33), "Approximate mesh: 120 hexahedra\nS");
  report.outcome = HexOutcome::kPartial;
  report.reason = "no map: 2 tets stay inverted";
  EXPECT_EQ(legend(mesh, &report).substr(0, 60),
            "Partial mesh: 120 hexahedra\n  no map: 2 tets stay inverted\nS");
  report.left_out = 9;
  report.left_out_place = {19.4, 9.13, 7.2};
  report.model_volume = 1000;
  EXPECT_NE(legend(mesh, &report).find("tets stay inverted\n  9 cells left out near 19.4 9.13 7.2\nS"),
            std::string::npos);
  EXPECT_NE(legend(inverted_bricks()).find("\n  inverted (1)\n"), std::string::npos);
}

/// Whether any pixel is of about this colour, light or dark.
bool has_hue(const ReadPng& picture, double red, double green, double blue) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto pixel = picture.at(x, y);
      const double size = pixel[0] + pixel[1] + pixel[2], wanted = red + green + blue;
      if (size < 120) continue;
      if (std::abs(pixel[0] / size - red / wanted) < 0.03 &&
          std::abs(pixel[1] / size - green / wanted) < 0.03)
        return true;
    }
  }
  return false;
}

TEST_F(HexPicture, HasAColourThatOnlyInvertedHexahedraHave) {
  options.without = {PicturePart::kLegend};
  options.view = PictureOptions::View{-130, 20};  // towards the first brick
  EXPECT_FALSE(has_hue(read_png(drawn(crooked_bricks())), 0xd9, 0x16, 0xd3));
  EXPECT_TRUE(has_hue(read_png(drawn(inverted_bricks())), 0xd9, 0x16, 0xd3));
}

TEST_F(HexPicture, OfWrongOptionsAndMeshesIsRefused) {
  const HexMesh mesh = crooked_bricks();
  options.colour = PictureColour::kEnergy;
  EXPECT_EQ(error(mesh).first, ErrorKind::kUsage);
  options.colour = PictureColour::kNone;
  options.quality_below = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error(mesh).first, ErrorKind::kUsage);
  options.quality_below.reset();
  options.cut = PictureOptions::Cut{0, 30};
  EXPECT_NE(error(mesh).second.find("the cut at x = 30 is outside the part"), std::string::npos);
  options.cut = PictureOptions::Cut{0, 0.31};
  options.view = PictureOptions::View{20, 10};
  EXPECT_EQ(error(mesh).second, "the cut at x = 0.31 leaves no hexahedron");
  options.cut.reset();
  EXPECT_EQ(error({}).first, ErrorKind::kInput);
  HexMesh broken = mesh;
  broken.hexahedra[7][2] = 210;
  EXPECT_EQ(error(broken).second,
            "hexahedron 7 (counted from 0): has a corner that is no vertex of the mesh");
  broken = mesh;
  broken.vertices[broken.hexahedra[0][0]][1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error(broken).first, ErrorKind::kUsage);
}

TEST_F(HexPicture, CanBeInterrupted) {
  Monitor monitor;
  monitor.cancel();
  EXPECT_THROW(render_picture(crooked_bricks(), folder.path() / "a.png", options, nullptr, monitor), Error);
  EXPECT_TRUE(folder.names().empty());
}

TEST_F(HexPicture, NamesTheRegionsWhereThereAreSeveral) {
  HexMesh mesh = crooked_bricks();
  mesh.regions.clear();
  options.colour = PictureColour::kRegion;
  EXPECT_EQ(error(mesh).first, ErrorKind::kUsage);
  mesh.regions.assign(mesh.hexahedra.size(), 4);
  EXPECT_NE(error(mesh).second.find("only one region"), std::string::npos);
  mesh.regions.back() = 7;
  EXPECT_NE(legend(mesh).find("Regions (2)"), std::string::npos) << legend(mesh);
}

TEST_F(HexPicture, OfNothingIsAnErrorThatTellsTheWorst) {
  options.quality_below = 0.1;
  const HexMesh cubes = made_bricks({2, 2, 2}, {2, 2, 2});
  EXPECT_EQ(error(cubes).second, "no hexahedron has a scaled Jacobian below 0.1: the worst has 1");
}

}  // namespace
}  // namespace crossgrain
