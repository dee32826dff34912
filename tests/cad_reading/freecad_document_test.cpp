// SPDX-License-Identifier: Apache-2.0
// Which shapes of a document of FreeCAD are shown, and where.
#include "cad_reading/freecad_document.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "archives/archive_errors.hpp"
#include "archives/made_archives.hpp"
#include "cad_reading/made_cad_files.hpp"
#include "cad_reading/made_freecad_documents.hpp"
#include "cad_reading/placed_breps.hpp"
#include "mesh_files/surface_files.hpp"

namespace crossgrain {
namespace {

/// Shapes are their own names here.
const Members kShapes{{"a.brp", "shape a"}, {"b.brp", "shape b"}, {"c.brp", "shape c"}};

FreeCadShapes shapes_of(const std::vector<FreeCadText>& objects,
                        const std::vector<std::pair<std::string, bool>>& visible = {}) {
  Members members = kShapes;
  members.emplace_back("Document.xml", document_of(objects));
  if (!visible.empty()) members.emplace_back("GuiDocument.xml", gui_of(visible));
  const TemporaryFolder folder;
  return read_freecad_document(InputFile(folder.write("a.FCStd", zipped(members))));
}

std::vector<std::string> names_in(const FreeCadShapes& shapes) {
  std::vector<std::string> names;
  for (const PlacedBrep& shape : placed_breps_in(shapes.placed_breps).value()) names.push_back(shape.brep);
  return names;
}

using Names = std::vector<std::string>;

TEST(FreeCadDocument, ShowsWhatIsVisible) {
  const FreeCadText a{"Part::Box", "A", "a.brp"}, b{"Part::Cylinder", "B", "b.brp"};
  FreeCadText cut{"Part::Cut", "C", "c.brp"};
  cut.links = {{"Base", "A"}, {"Tool", "B"}};
  EXPECT_EQ(names_in(shapes_of({a, b, cut}, {{"A", false}, {"B", false}, {"C", true}})), Names{"shape c"});
  EXPECT_EQ(names_in(shapes_of({a, b, cut}, {{"A", true}, {"B", false}, {"C", true}})),
            (Names{"shape a", "shape c"}));
}

TEST(FreeCadDocument, WithoutAWindowShowsWhatNoOtherIsMadeOf) {
  const FreeCadText a{"Part::Box", "A", "a.brp"}, b{"Part::Cylinder", "B", "b.brp"};
  FreeCadText cut{"Part::Cut", "C", "c.brp"};
  cut.links = {{"Base", "A"}, {"Tool", "B"}};
  EXPECT_EQ(names_in(shapes_of({a, b, cut})), Names{"shape c"});
  // What an object is only attached to is no part of it.
  cut.links = {{"Base", "A"}, {"AttachmentSupport", "B"}};
  EXPECT_EQ(names_in(shapes_of({a, b, cut})), (Names{"shape b", "shape c"}));
}

TEST(FreeCadDocument, ShowsABodyInPlaceOfItsFeaturesAndNoHelpsToDrawIt) {
  FreeCadText body{"PartDesign::Body", "Body", "a.brp"};
  body.group = {"Sketch", "Pad", "Plane"};
  const FreeCadText sketch{"Sketcher::SketchObject", "Sketch", "b.brp"},
      pad{"PartDesign::Pad", "Pad", "a.brp"}, plane{"PartDesign::Plane", "Plane", "c.brp"},
      alone{"Sketcher::SketchObject", "Alone", "b.brp"};
  const std::vector<FreeCadText> objects{body, sketch, pad, plane, alone};
  EXPECT_EQ(names_in(shapes_of(objects)), Names{"shape a"});
  EXPECT_EQ(
      names_in(shapes_of(
          objects, {{"Body", true}, {"Sketch", true}, {"Pad", true}, {"Plane", true}, {"Alone", true}})),
      Names{"shape a"});
}

TEST(FreeCadDocument, PlacesWhatPartsHoldAndLinksShow) {
  const double half = std::sqrt(0.5);
  FreeCadText part{"App::Part", "Part", "", {10, 0, 0}, {0, 0, half, half}};  // a quarter turn about z
  part.group = {"A"};
  const FreeCadText a{"Part::Box", "A", "a.brp", {0, 0, 7}};
  FreeCadText link{"App::Link", "Link", "", {0, 5, 0}};
  link.linked = "A";
  FreeCadText keeping = link;
  keeping.name = "Keeping";
  keeping.other = property_text("LinkTransform", "Bool", "<Bool value=\"true\"/>");
  const auto shapes = placed_breps_in(shapes_of({part, a, link, keeping}).placed_breps).value();
  ASSERT_EQ(shapes.size(), 3u);
  for (const PlacedBrep& shape : shapes) EXPECT_EQ(shape.brep, "shape a");
  EXPECT_EQ(shapes[0].move, (std::array<double, 3>{10, 0, 0}));
  EXPECT_NEAR(shapes[0].turn[0], half, 1e-15);
  EXPECT_NEAR(shapes[0].turn[3], half, 1e-15);
  // The place of the link replaces that of the box, whose shape is stored 7 up.
  EXPECT_EQ(shapes[1].move, (std::array<double, 3>{0, 5, -7}));
  EXPECT_EQ(shapes[2].move, (std::array<double, 3>{0, 5, 0}));
}

TEST(FreeCadDocument, HidesWhatAPartHoldsWithIt) {
  FreeCadText part{"App::Part", "Part"};
  part.group = {"A"};
  const FreeCadText a{"Part::Box", "A", "a.brp"}, b{"Part::Box", "B", "b.brp"};
  EXPECT_EQ(names_in(shapes_of({part, a, b}, {{"Part", false}, {"A", true}, {"B", true}})), Names{"shape b"});
}

TEST(FreeCadDocument, WarnsOfLinksToOtherDocuments) {
  const FreeCadText a{"Part::Box", "A", "a.brp"};
  FreeCadText link{"App::Link", "Link"};
  link.other = property_text("LinkedObject", "XLink", "<XLink file=\"other.FCStd\" name=\"Body\"/>");
  const FreeCadShapes shapes = shapes_of({a, link});
  EXPECT_EQ(names_in(shapes), Names{"shape a"});
  ASSERT_EQ(shapes.warnings.size(), 1u);
  EXPECT_EQ(shapes.warnings[0].kind, WarningKind::kMissingParts);
}

TEST(FreeCadDocument, RefusesWhatShowsNothingAndLinksInThemselves) {
  const FreeCadText a{"Part::Box", "A", "a.brp"};
  EXPECT_NE(input_error([&] {
              shapes_of({a}, {{"A", false}});
            }).find("no object that is visible has a shape"),
            std::string::npos);
  FreeCadText link{"App::Link", "Link"};
  link.linked = "Link";
  EXPECT_NE(input_error([&] { shapes_of({a, link}); }).find("nested too deeply"), std::string::npos);
  FreeCadText lost = a;
  lost.shape = "none.brp";
  EXPECT_NE(input_error([&] { shapes_of({lost}); }).find("'none.brp': is missing"), std::string::npos);
  FreeCadText crooked = a;
  crooked.turn = {0, 0, 0, 0};
  EXPECT_NE(input_error([&] { shapes_of({crooked}); }).find("has no rotation"), std::string::npos);
}

#ifdef CROSSGRAIN_CAD_FILES

TEST(ReadCad, GivesTheShapesOfADocumentOfFreeCadInTheirPlaces) {
  Members members{{"box.brp", content_of(cad_files() / "box.brep")},
                  {"curve.brp", content_of(cad_files() / "curve.brep")}};
  const double half = std::sqrt(0.5);
  FreeCadText part{"App::Part", "Part", "", {10, 0, 0}, {0, 0, half, half}};
  part.group = {"A", "Curve"};
  const FreeCadText a{"Part::Box", "A", "box.brp"}, curve{"Part::Line", "Curve", "curve.brp"},
      b{"Part::Box", "B", "box.brp"};
  members.emplace_back("Document.xml", document_of({part, a, curve, b}));
  const TemporaryFolder folder;
  const TriangleMesh mesh = read_surface(folder.write("a.fcstd", zipped(members)));
  // Boxes of 1 by 2 by 3: one turned to reach from 8 to 10 along x.
  EXPECT_NEAR(volume_of(mesh), 12, 1e-9);
  EXPECT_EQ(std::set<std::int32_t>(mesh.solids.begin(), mesh.solids.end()).size(), 2u);
  double most = 0;
  for (const Vector3& vertex : mesh.vertices) most = std::max(most, vertex[0]);
  EXPECT_NEAR(most, 10, 1e-9);
  EXPECT_EQ(mesh.unit, "mm");
  EXPECT_EQ(mesh.file_unit, "mm");
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST(ReadCad, GivesFilesOfEveryFormatPackedByGzipAsTheyAre) {
  const TemporaryFolder folder;
  for (const char* name : {"plate.step", "plate.iges", "plate.brep", "plate.brp"}) {
    SCOPED_TRACE(name);
    expect_same(
        read_surface(folder.write(std::string(name) + ".gz", gzipped(content_of(cad_files() / name)))),
        read_made(name));
  }
}

#endif

}  // namespace
}  // namespace crossgrain
