// SPDX-License-Identifier: Apache-2.0
#include "results/foreign_files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "crossgrain/error.hpp"
#include "files/file_mark.hpp"
#include "files/temporary_folder.hpp"
#include "measure/made_tets.hpp"
#include "mesh_files/made_bricks.hpp"
#include "mesh_files/made_map.hpp"
#include "results/onto_files.hpp"
#include "results/report_file.hpp"
#include "results/result_files.hpp"
#include "results/sample_field.hpp"
#include "results/tet_files.hpp"

namespace crossgrain {
namespace {

FrameField made_field() {
  return field_of(sample_data(Degree::kFour));
}

/// The message of the refusal; empty if the folder is written.
std::string refusal(const std::filesystem::path& folder, const OutputOptions& options = {}) {
  try {
    write_field(made_field(), folder, {}, options);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kOutput);
    EXPECT_EQ(error.remedy(), Remedy::kChooseFolder);
    return error.what();
  }
}

std::map<std::string, std::string> contents_of(const TemporaryFolder& folder) {
  std::map<std::string, std::string> contents;
  for (const std::string& name : folder.names()) contents[name] = content_of(folder.path() / name);
  return contents;
}

CompanionFile notes() {
  return {"notes.txt", [](const Monitor&) -> CompanionFile::Writer {
            return [](const SolveReport&, const ByteSink& write) { write("text"); };
          }};
}

void write_every_format(const std::filesystem::path& folder) {
  const TetSolid solid = solid_of(tet_box({2, 2, 2}, 0.2));
  TetField onto;
  onto.vertex_frames = scattered_frames(solid.mesh.vertices.size(), 0.5);
  onto.tet_frames = tet_frames_of(solid.mesh, onto.vertex_frames);
  const HexMap map = made_map(solid.mesh);
  OutputOptions options;
  options.hexahedra = std::make_shared<HexMesh>(made_bricks({2, 1, 1}, {2, 1, 1}));
  options.companion = notes();
  for (const OutputFormat& format : output_formats()) options.formats.push_back(format.name);
  write_field_onto(made_field(), sample_report(), {solid, onto, {}, 1, &map}, folder, {}, options);
}

TEST(ForeignFiles, OfAnyKindAreNamedAndNothingIsWritten) {
  for (const char* name : {"notes.txt", ".gitignore", "field.vtu", "report.json", "onto.fra", "a.part"}) {
    const TemporaryFolder folder;
    folder.write(name, "mine");
    EXPECT_NE(refusal(folder.path()).find("'" + std::string(name) + "'"), std::string::npos) << name;
    EXPECT_THROW(check_field_folder(folder.path()), Error) << name;
    EXPECT_THROW(check_onto_folder(folder.path()), Error) << name;
    EXPECT_EQ(contents_of(folder), (std::map<std::string, std::string>{{name, "mine"}}));
  }
}

TEST(ForeignFiles, AreFoldersPipesAndBrokenLinksToo) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "a");
  EXPECT_NE(refusal(folder.path()).find("'a'"), std::string::npos);
  std::filesystem::remove(folder.path() / "a");
  std::filesystem::create_symlink(folder.path() / "nowhere", folder.path() / "field.vtu");
  EXPECT_NE(refusal(folder.path()).find("'field.vtu'"), std::string::npos);
  std::filesystem::remove(folder.path() / "field.vtu");
  ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  EXPECT_NE(refusal(folder.path()).find("'pipe'"), std::string::npos);
}

TEST(ForeignFiles, ThatWouldBeLostAreNamedFirst) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b", "onto.perm"}) folder.write(name, "mine");
  EXPECT_NE(refusal(folder.path()).find("holds 'onto.perm' and 2 other files,"), std::string::npos);
}

TEST(ForeignFiles, AreNoneOfAnEarlierField) {
  const TemporaryFolder folder;
  write_every_format(folder.path());
  EXPECT_EQ(folder.names().size(), 8 + tet_files().size());
  EXPECT_EQ(refusal(folder.path()), "");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"field.vtu", "report.json", "singularities.vtu"}));
}

TEST(ForeignFiles, AreAllThatWereChangedSinceTheyWereWritten) {
  const TemporaryFolder folder;
  write_every_format(folder.path());
  const std::map<std::string, std::string> written = contents_of(folder);
  OutputOptions keep;
  keep.foreign_files = ForeignFiles::kKeep;
  for (const auto& [name, content] : written) {
    std::string in_place = content;
    in_place[content.size() / 2] ^= 1;
    for (const std::string& changed : {content + "\n", content.substr(0, content.size() - 1), in_place}) {
      folder.write(name, changed);
      for (const OutputOptions& options : {OutputOptions(), keep})
        EXPECT_EQ(refusal(folder.path(), options), folder.path().string() + ": holds '" + name +
                                                       "', which was changed since Crossgrain wrote it; " +
                                                       words_of(Remedy::kChooseFolder));
      EXPECT_EQ(content_of(folder.path() / name), changed);
    }
    folder.write(name, content);
  }
  EXPECT_EQ(contents_of(folder), written);
  EXPECT_EQ(refusal(folder.path()), "");
}

TEST(ForeignFiles, AreThoseThatWereChangedAfterAFirstCheckToo) {
  const TemporaryFolder folder;
  write_every_format(folder.path());
  OutputOptions options;
  options.reservation = check_field_folder(folder.path());
  std::string content = content_of(folder.path() / "hexahedra.inp");
  content[content.size() / 2] ^= 1;
  folder.write("hexahedra.inp", content);
  EXPECT_NE(refusal(folder.path(), options).find("hexahedra.inp"), std::string::npos);
}

TEST(ForeignFiles, AreResultsWithoutTheirReport) {
  const TemporaryFolder folder;
  write_every_format(folder.path());
  const std::size_t files = folder.names().size();
  std::filesystem::remove(folder.path() / "report.json");
  EXPECT_NE(refusal(folder.path()).find("which Crossgrain did not write"), std::string::npos);
  for (const TetFile& file : tet_files())
    if (!is_own_file(folder.path() / file.name)) std::filesystem::remove(folder.path() / file.name);
  EXPECT_LT(folder.names().size(), files - 5);
  EXPECT_NE(refusal(folder.path()).find("which no report.json lists"), std::string::npos);
}

TEST(ForeignFiles, AreNoneThatWereDeleted) {
  const TemporaryFolder folder;
  write_every_format(folder.path());
  for (const char* name : {"field.vtu", "hexahedra.inp", "onto.fra", "notes.txt"})
    std::filesystem::remove(folder.path() / name);
  EXPECT_EQ(refusal(folder.path()), "");
}

TEST(ForeignFiles, AreNotWhatDesktopsAndKilledRunsLeave) {
  const TemporaryFolder folder;
  const std::vector<std::string> left{".DS_Store", ".field.vtu.4711-0.part", "Thumbs.db", "desktop.ini"};
  for (const std::string& name : left) folder.write(name, "litter");
  EXPECT_EQ(refusal(folder.path()), "");
  for (const std::string& name : left) EXPECT_EQ(content_of(folder.path() / name), "litter") << name;
}

TEST(ForeignFiles, AreNotWhatALinkToAnOwnFileLeadsTo) {
  const TemporaryFolder other, folder;
  write_field(made_field(), folder.path());
  std::filesystem::rename(folder.path() / "field.vtu", other.path() / "field.vtu");
  std::filesystem::create_symlink(other.path() / "field.vtu", folder.path() / "field.vtu");
  EXPECT_EQ(refusal(folder.path()), "");
}

TEST(ForeignFiles, MayBeKeptIfNoneIsLost) {
  const TemporaryFolder folder;
  folder.write("notes.txt", "mine");
  OutputOptions options;
  options.foreign_files = ForeignFiles::kKeep;
  EXPECT_EQ(refusal(folder.path(), options), "");
  EXPECT_EQ(content_of(folder.path() / "notes.txt"), "mine");
  folder.write("onto.fra", "mine");
  EXPECT_NE(refusal(folder.path(), options).find("'onto.fra', which"), std::string::npos);
  EXPECT_EQ(content_of(folder.path() / "onto.fra"), "mine");
}

TEST(ForeignFiles, AreReplacedOnlyOnRequest) {
  const TemporaryFolder folder;
  for (const char* name : {"notes.txt", "field.vtu", "onto.fra"}) folder.write(name, "mine");
  OutputOptions options;
  options.foreign_files = ForeignFiles::kReplace;
  EXPECT_EQ(refusal(folder.path(), options), "");
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{"field.vtu", "notes.txt", "report.json", "singularities.vtu"}));
  EXPECT_EQ(content_of(folder.path() / "notes.txt"), "mine");
  EXPECT_TRUE(is_own_file(folder.path() / "field.vtu"));
}

TEST(ForeignFiles, AreNoCompanions) {
  const TemporaryFolder folder;
  OutputOptions options;
  options.companion = notes();
  EXPECT_EQ(refusal(folder.path(), options), "");
  EXPECT_EQ(refusal(folder.path(), options), "");
  EXPECT_EQ(content_of(folder.path() / "notes.txt"), "text");
  EXPECT_EQ(refusal(folder.path()), "") << "without the companion, which goes";
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "notes.txt"));
}

TEST(ForeignFiles, AreNotReachedByAListThatLeavesTheFolder) {
  const TemporaryFolder folder;
  const auto field = folder.path() / "field";
  folder.write("notes.txt", "");
  write_field(made_field(), field);
  SolveReport report = read_report(field / "report.json");
  report.files.push_back({"../notes.txt", 0, "00000000"});
  folder.write("field/report.json", sealed_report_json(report));
  EXPECT_EQ(refusal(field), "");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "notes.txt"));
}

TEST(FileMark, CountsOnlyNearTheBeginning) {
  const TemporaryFolder folder;
  const std::string mark(kXmlMark);
  EXPECT_TRUE(has_mark(folder.write("a", std::string(kMarkedBytes - mark.size(), ' ') + mark)));
  EXPECT_FALSE(has_mark(folder.write("b", std::string(kMarkedBytes - mark.size() + 1, ' ') + mark)));
  EXPECT_FALSE(has_mark(folder.path() / "missing"));
  EXPECT_FALSE(has_mark(folder.path()));
}

TEST(ModelOfResult, IsThePathInTheReport) {
  const TemporaryFolder folder;
  EXPECT_EQ(model_of_result(folder.path()), std::nullopt);
  SolveReport report = sample_report();
  report.model.path = "part.step";
  write_field(made_field(), report, folder.path());
  EXPECT_EQ(model_of_result(folder.path()), "part.step");
  folder.write("report.json", "{");
  EXPECT_EQ(model_of_result(folder.path()), std::nullopt);
}

}  // namespace
}  // namespace crossgrain
