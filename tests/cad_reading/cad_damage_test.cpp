// SPDX-License-Identifier: Apache-2.0
// Which damage to a CAD file is an error, and which is none: made on the spot from sound files.
#include "cad_reading/made_cad_files.hpp"
#include "mesh_files/surface_files.hpp"

#ifdef CROSSGRAIN_CAD_FILES

namespace crossgrain {
namespace {

TEST(ReadCad, RefusesFilesThatAreCutShortOrDamaged) {
  const TemporaryFolder folder;
  for (const char* name : {"plate.step", "plate.iges", "plate.brep"}) {
    SCOPED_TRACE(name);
    const std::string content = content_of(cad_files() / name);
    EXPECT_NE(
        input_error_of(folder.write(name, content.substr(0, content.size() / 2))).find("export it again"),
        std::string::npos);
    const std::string damaged =
        content.substr(0, 300) + std::string(2000, '?') + content.substr(content.size() - 90);
    EXPECT_NE(input_error_of(folder.write(name, damaged)).find("export it again"), std::string::npos);
  }
}

TEST(ReadCad, NamesAPieceOfGeometryThatDidNotLoad) {
  // OpenCASCADE by itself would crash on it.
  std::string content = content_of(cad_files() / "cylinder.step");
  const std::string vector = "VECTOR('',#";
  const std::size_t place = content.find(vector);
  ASSERT_NE(place, std::string::npos);
  content.insert(place + vector.size(), "9999");
  const TemporaryFolder folder;
  const std::string message = input_error_of(folder.write("a.step", content));
  EXPECT_NE(message.find("entity #"), std::string::npos) << message;
}

/// The text of plate.step, with `to` in place of the first `from`.
std::string plate_with(const std::string& from, const std::string& to) {
  std::string content = content_of(cad_files() / "plate.step");
  const std::size_t place = content.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return content.replace(place, from.size(), to);
}

/// Writes entities in place of the end of the data of a STEP file.
std::string with_entities(std::string content, const std::string& entities) {
  const std::string end = "ENDSEC;\nEND-ISO";
  return content.replace(content.find(end), 0, entities);
}

constexpr const char* kItems = "ADVANCED_BREP_SHAPE_REPRESENTATION('',(#11,#15)";

TEST(ReadCad, ReadsASolidBesideWhatOpenCascadeCannotRead) {
  const TemporaryFolder folder;
  std::string nameless = content_of(cad_files() / "plate.step");
  for (std::size_t at = 0; (at = nameless.find("_FACE('',", at)) != std::string::npos;)
    nameless.replace(at, 9, "_FACE($,");
  const std::string with_item = plate_with(kItems, "ADVANCED_BREP_SHAPE_REPRESENTATION($,(#90001,#11,#15)");
  const std::vector<std::pair<const char*, std::string>> files = {
      {"no names", nameless},
      {"an item of a wrong type", with_entities(with_item, "#90001=APPLICATION_CONTEXT('');\n")},
      {"an item of an unknown type", with_entities(with_item, "#90001=NOTE_ON_THE_PART('',#11);\n")},
      {"a damaged curve beside the solid",
       with_entities(with_item,
                     "#90001=GEOMETRIC_CURVE_SET('',(#90002));\n"
                     "#90002=LINE('',#12,#90003);\n#90003=VECTOR('',#90004,1.);\n")},
      {"a context that nothing needs",
       with_entities(content_of(cad_files() / "plate.step"),
                     "#90001=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#11))"
                     "REPRESENTATION_CONTEXT('',''));\n")}};
  const TriangleMesh sound = read_made("plate.step");
  for (const auto& [name, content] : files) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = read_surface(folder.write("a.step", content));
    expect_same(mesh, sound);
    EXPECT_TRUE(mesh.warnings.empty()) << sentence_of(mesh.warnings.front());
  }
}

TEST(ReadCad, RefusesASolidOfWhichAPartCannotBeRead) {
  const TemporaryFolder folder;
  for (const auto& [from, to] :
       {std::pair{"(#11,#15)", "(#11,#90001)"},                  // no such entity
        {"MANIFOLD_SOLID_BREP('',", "MANIFOLD_SOLID_DREP('',"},  // holds faces, of an unknown type
        {"MANIFOLD_SOLID_BREP('',#", "MANIFOLD_SOLID_BREP('',#9"},
        {"CLOSED_SHELL('',(#17,", "CLOSED_SHELL('',(#12,"},
        {"ADVANCED_FACE('',(#18)", "ADVANCED_FACE('',(#11)"},
        {"CARTESIAN_POINT('',(0.,0.,10.))", "CARTESIAN_POINT('',(0.,0.,*))"},
        {"LINE('',#39,#40)", "LINE('',#39,#90001)"}}) {
    SCOPED_TRACE(to);
    const std::string message = input_error_of(folder.write("a.step", plate_with(from, to)));
    EXPECT_NE(message.find("entity #"), std::string::npos) << message;
  }
}

TEST(ReadCad, ADocumentBesideThePartIsNoMissingPart) {
  const TemporaryFolder folder;
  const std::string document =
      "#90001=PRODUCT_DEFINITION('drawing','',#6,#9);\n"
      "#90002=PRODUCT_DEFINITION_SHAPE('','',#90001);\n"
      "#90003=SHAPE_DEFINITION_REPRESENTATION(#90002,#90004);\n"
      "#90004=SHAPE_REPRESENTATION('',(#11),#429);\n";
  const std::string content = with_entities(content_of(cad_files() / "plate.step"), document);
  const TriangleMesh mesh = read_surface(folder.write("a.step", content));
  EXPECT_TRUE(mesh.warnings.empty()) << sentence_of(mesh.warnings.front());
}

TEST(ReadCad, NamesTheOtherFilesThatHoldThePartsOfAnAssembly) {
  const TemporaryFolder folder;
  const std::string named =
      "#90001=APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT('lid.stp',#90002,#90003,(#5));\n"
      "#90002=IDENTIFICATION_ROLE('','');\n#90003=EXTERNAL_SOURCE(IDENTIFIER(''));\n";
  const std::string message = input_error_of(
      folder.write("a.step", with_entities(plate_with(kItems, "SHAPE_REPRESENTATION('',(#11)"), named)));
  EXPECT_NE(message.find("parts are in other files, lid.stp;"), std::string::npos) << message;
}

TEST(ReadCad, ReadsBrepFilesWithTextBehindTheShape) {
  const TemporaryFolder folder;
  const std::string content = content_of(cad_files() / "box.brep");
  const TriangleMesh box = read_made("box.brep");
  for (const char* text : {"\n0\n\n", "Surface Loop(1) = {35};\n", "\r\n0\r\n", "\n\nF = \"x * 2\";\n"}) {
    SCOPED_TRACE(text);
    expect_same(read_surface(folder.write("a.brep", content + text)), box);
  }
  for (const std::size_t missing : {4u, 10u, 60u, 400u}) {
    const std::string cut = content.substr(0, content.size() - missing) + "\n0\n";
    EXPECT_NE(input_error_of(folder.write("a.brep", cut)).find("cut short"), std::string::npos) << missing;
  }
}

}  // namespace
}  // namespace crossgrain

#endif
