// SPDX-License-Identifier: Apache-2.0
// Files of every format, packed by gzip.
#include "archives/made_archives.hpp"
#include "fuzz/made_inputs.hpp"
#include "mesh_files/gmsh_files.hpp"
#include "mesh_files/made_3mf.hpp"
#include "mesh_files/medit_files.hpp"
#include "mesh_files/vtk_files.hpp"

namespace crossgrain {
namespace {

TEST(PackedModels, OfEverySurfaceAreReadAsTheyAre) {
  const TemporaryFolder folder;
  const std::string document =
      made_3mf(part_of_3mf(object_of_3mf("1", mesh_of_3mf()), "<item objectid=\"1\"/>"));
  for (const auto& [extension, contents] : {std::pair{"stl", made_stl()},
                                            {"obj", made_obj()},
                                            {"ply", made_ply()},
                                            {"off", made_off()},
                                            {"3mf", std::vector{document}}}) {
    for (const std::string& content : contents) {
      const TriangleMesh plain = read_surface(folder.write(std::string("a.") + extension, content));
      const TriangleMesh packed =
          read_surface(folder.write(std::string("b.") + extension + ".GZ", gzipped(content)));
      EXPECT_EQ(packed.vertices, plain.vertices) << extension;
      EXPECT_EQ(packed.triangles, plain.triangles) << extension;
    }
  }
}

TEST(PackedModels, OfTetsAreReadAsTheyAre) {
  const TemporaryFolder folder;
  const TetMesh mesh = made_tet_mesh();
  for (const auto& files : {medit_files(mesh), gmsh_files(mesh), vtk_files(mesh), vtu_files(mesh)}) {
    for (const MadeFile& file : files)
      expect_same_mesh(read_tets(folder.write("a" + file.extension + ".gz", gzipped(file.content))),
                       read_made(file));
  }
}

TEST(PackedModels, AreOfTheKindThatTheirNameSaysInEitherCase) {
  for (const char* name : {"a.step.gz", "a.STP.GZ", "a.igs.gz", "a.brep.gz", "a.FCStd", "a.fcstd.gz"})
    EXPECT_TRUE(is_cad_file(name)) << name;
  for (const char* name : {"a.mesh.gz", "a.MESHB.gz", "a.msh.GZ", "a.vtk.gz", "a.vtu.gz"})
    EXPECT_TRUE(is_tet_file(name)) << name;
  for (const char* name : {"a.stl.gz", "a.3mf", "a.gz", "a"}) {
    EXPECT_FALSE(is_cad_file(name)) << name;
    EXPECT_FALSE(is_tet_file(name)) << name;
  }
  EXPECT_EQ(stem_of_model("b/part.step.gz"), "part");
  EXPECT_EQ(stem_of_model("b/part.step"), "part");
}

TEST(PackedModels, GiveTheErrorsOfWhatTheyHold) {
  EXPECT_NE(input_error_as("a.obj.gz", gzipped("v 0 0 x\n")).find("a.obj.gz: line 1: "), std::string::npos);
  EXPECT_NE(input_error_as("a.stl.gz", gzipped("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))
                .find("begins like an OFF file"),
            std::string::npos);
  EXPECT_NE(input_error_as("a.xyz.gz", gzipped("1 2 3")).find("no reader for '.xyz' files"),
            std::string::npos);
  EXPECT_NE(input_error_as("a.gz", gzipped("solid a\n")).find("no extension, but it begins like an STL file"),
            std::string::npos);
  EXPECT_NE(input_error_as("a.stl.gz.gz", gzipped(gzipped("solid a\n"))).find("packed by gzip twice"),
            std::string::npos);
  EXPECT_NE(input_error_as("a.stl", gzipped("solid a\n")).find("begins like a gzip archive (.gz); rename it"),
            std::string::npos);
}

}  // namespace
}  // namespace crossgrain
