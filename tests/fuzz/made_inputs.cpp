// SPDX-License-Identifier: Apache-2.0
#include "fuzz/made_inputs.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/writing.hpp"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

#include "archives/made_archives.hpp"
#include "cad_reading/made_cad_answers.hpp"
#include "cad_reading/made_freecad_documents.hpp"
#include "fuzz/reader_checks.hpp"
#include "mesh_files/gmsh_files.hpp"
#include "mesh_files/made_3mf.hpp"
#include "mesh_files/made_bricks.hpp"
#include "mesh_files/medit_files.hpp"
#include "mesh_files/vtk_files.hpp"
#include "results/axes_behind_faces.hpp"
#include "results/report_file.hpp"
#include "results/sample_field.hpp"
#include "singularity/cube_group.hpp"
#include "singularity/tet_matchings.hpp"
#include "tet_making/made_netgen_answers.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

/// Small enough for a mutation to hit what matters.
TetMesh small_tet_mesh() {
  return made_tet_mesh(5, 3);
}

std::vector<std::string> contents(const std::vector<MadeFile>& files) {
  std::vector<std::string> out;
  for (const MadeFile& file : files) out.push_back(file.content);
  return out;
}

std::vector<std::string> made_medit() {
  const std::string text = medit_text(small_tet_mesh()).content;
  // Cells before the vertices, Ridges, and what is passed over.
  return {
      text,
      "Dimension\n3\n# made\nTetrahedra 1\n1 2 3 4 7\nHexahedra 0\nVertices\n4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n"
      "0 0 1 1\nEdges 2\n1 2 5\n2 3 5\nRidges 1\n2\nCorners 1\n1\nBounds 1 2\nEnd\n",
      "MeshVersionFormatted 1\nVertices 10\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n.5 0 0 1\n0 .5 0 1\n"
      "0 0 .5 1\n.5 .5 0 1\n0 .5 .5 1\n.5 0 .5 1\nTetrahedraP2 1\n1 2 3 4 5 6 7 8 9 10 -3\n"};
}

std::vector<std::string> made_medit_binary() {
  std::vector<std::string> out;
  for (const int version : {1, 2, 3, 4})
    for (const bool swapped : {false, true})
      out.push_back(medit_binary(small_tet_mesh(), version, swapped).content);
  return out;
}

/// A mesh as `write_hexahedra` writes it, and one of another program.
std::vector<std::string> made_hexahedra(const char* name, std::string other) {
  const TemporaryFolder folder;
  write_hexahedra(made_bricks({2, 2, 1}, {2, 2, 1}), folder.path() / name);
  return {content_of(folder.path() / name), std::move(other)};
}

constexpr const char* kCubePoints = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\n";

std::vector<std::string> made_abaqus() {
  return made_hexahedra(
      "a.inp",
      "*HEADING\nmade\n*NODE\n1,0,0,0\n2,1\n3,1,1\n4,0,1\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n"
      "*ELEMENT, TYPE=C3D20, ELSET=A\n5, 1,2,3,4,5,6,7,8,\n1,2,3,4,5,6,7,8, 1,2,3,4\n"
      "*ELEMENT, TYPE=S4, ELSET=B\n6, 1,2,3,4\n*ELSET, ELSET=REGION_2, GENERATE\n1, 9, 2\n"
      "*SURFACE, NAME=FACE_MINUS_3, TYPE=ELEMENT\n5, S6\nA, S1\n*INSTANCE, NAME=a, PART=b\n1,0,0\n");
}

std::vector<std::string> made_hex_vtk() {
  const std::string begin =
      "# vtk DataFile Version 3.0\nmade\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n";
  return {begin + kCubePoints +
              "CELLS 2 14\n8 0 1 2 3 4 5 6 7\n4 0 1 2 3\nCELL_TYPES 2\n12 9\n"
              "CELL_DATA 2\nSCALARS tag int\nLOOKUP_TABLE default\n7 8\n",
          begin + kCubePoints + "CELLS 1 9\n8 0 1 3 2 4 5 7 6\nCELL_TYPES 1\n11\n"};
}

std::vector<std::string> made_hex_gmsh() {
  return made_hexahedra(
      "a.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
      "5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n$EndNodes\n$Elements\n2\n1 3 2 4 4 1 2 3 4\n"
      "2 5 2 3 3 5 6 7 8 1 2 3 4\n$EndElements\n");
}

std::vector<std::string> made_hex_medit() {
  return made_hexahedra(
      "a.mesh",
      "Hexahedra 1\n1 2 3 4 5 6 7 8 2\nQuadrilaterals 1\n1 2 3 4 9\nVertices 8\n0 0 0 0\n1 0 0 0\n"
      "1 1 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n1 1 1 0\n0 1 1 0\nEnd\n");
}

std::vector<std::string> made_vtu_data() {
  std::vector<std::string> out;
  const std::string raw = std::string(100, '\0') + "some bytes that do not repeat";
  for (unsigned flags = 0; flags < 16; ++flags) {
    const VtuEncoding encoding{(flags & VtuDataFlags::kBase64) != 0 ? "base64" : "raw",
                               (flags & VtuDataFlags::kCompressed) != 0, (flags & VtuDataFlags::kWide) != 0,
                               (flags & VtuDataFlags::kSwapped) != 0};
    out.push_back(static_cast<char>(flags) + packed_vtu_data(raw, encoding));
  }
  return out;
}

std::vector<std::string> made_fields() {
  std::vector<std::string> out;
  for (const Degree degree : {Degree::kThree, Degree::kFour}) {
    const TemporaryFolder folder;
    write_field(field_of(sample_data(degree, 0)), folder.path());
    out.push_back(content_of(folder.path() / "field.vtu"));
  }
  return out;
}

template <class T>
void append_array(std::string& out, const std::vector<T>& values) {
  const std::size_t bytes = values.size() * sizeof(T);
  out += static_cast<char>(bytes & 255);
  out += static_cast<char>(bytes >> 8);
  out.append(reinterpret_cast<const char*>(values.data()), bytes);
}

/// In the order of kFieldArrays (field_checks.cpp).
std::string array_bytes(const FieldData& data) {
  std::string out;
  append_array<std::uint32_t>(out, {1});
  append_array<std::uint32_t>(out, {static_cast<std::uint32_t>(data.degree)});
  const RootCube& root = data.tree.root();
  append_array<double>(out, {root.origin[0], root.origin[1], root.origin[2], root.size});
  std::vector<std::uint64_t> leaves;
  for (const CellAddress leaf : data.tree.leaves()) leaves.push_back(leaf.packed());
  append_array(out, leaves);
  append_array(out, data.frames);
  append_array(out, data.open_faces);
  append_array(out, data.energy_density);
  append_array(out, data.alignment_deg);
  append_array(out, data.on_boundary);
  return out;
}

/// Tets with frames that turn from each to the next, in the order of kOntoArrays (field_checks.cpp).
std::string onto_bytes() {
  const TetMesh mesh = TetBox{{2, 2, 1}}.mesh();
  std::string out;
  append_array(out, mesh.vertices);
  append_array(out, mesh.tets);
  std::array<std::vector<float>, 3> columns;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto axes = axes_of(from_rotation_vector({0.4 * static_cast<double>(t), 0.2, 0}));
    for (std::size_t k = 0; k < 3; ++k)
      for (const double x : axes[k]) columns[k].push_back(static_cast<float>(x));
  }
  for (const auto& column : columns) append_array(out, column);
  return out;
}

/// The same with any matchings, in the order of kRepairedArrays (field_checks.cpp).
std::vector<std::string> repaired_bytes() {
  std::vector<Warning> warnings;
  const TetSolid solid = prepare_tets(TetBox{{2, 2, 1}}.mesh(), warnings);
  std::vector<Quaternion> frames;
  for (std::size_t t = 0; t < solid.mesh.tets.size(); ++t)
    frames.push_back(from_rotation_vector({0.4 * static_cast<double>(t), 0.2, 0}));
  std::vector<std::string> out;
  std::mt19937 random(1);
  for (const std::uint32_t changed : {8u, 2u, 1u}) {
    std::vector<CubeRotation> matchings = tet_matchings(solid, frames);
    for (CubeRotation& matching : matchings)
      if (random() % changed == 0)
        matching = CubeGroup::instance()[static_cast<std::uint8_t>(random() % CubeGroup::kCount)];
    std::string bytes = onto_bytes();
    append_array(bytes, frames);
    append_array(bytes, axes_behind_faces(solid, matchings));
    out.push_back(bytes);
  }
  return out;
}

/// Two triangles and a crease of two points, in the order of kSurfaceArrays (field_checks.cpp).
std::string surface_bytes() {
  std::string out;
  append_array<std::uint32_t>(out, {1});
  append_array<Vector3>(out, {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {0, 0, 0}, {1, 0, 0}});
  append_array<std::int32_t>(out, {0, 1, 2, 0, 3, 1, 4, 5});
  append_array<std::int32_t>(out, {3, 6, 8});
  append_array<std::uint8_t>(out, {5, 5, 4});
  return out;
}

/// An arc of three points between two nodes and a closed one, in the order of kSingularityArrays
/// (field_checks.cpp).
std::string singularity_bytes() {
  std::string out;
  append_array<Vector3>(out, {{0, 0, 0}, {1, 0, 0}, {0.5, 2, 0}, {0, 0, 3}, {1, 1, 3}});
  append_array<std::int32_t>(out, {0, 1, -1, -1, -1});
  append_array<std::uint8_t>(out, {1, 0, 0, 0, 0});
  append_array<std::uint8_t>(out, {0, 2, 0, 0, 0});
  append_array<Vector3>(out, {{0, 0, 0}, {0, 0, 0}, {0.6, 0.8, 0}, {0, 0, 1}, {0, 0, 0}});
  append_array<std::uint8_t>(out, {0, 0, 1, 0, 0});
  append_array<std::int64_t>(out, {-1, -1, -1, -1, -1});
  append_array<std::int64_t>(out, {0, 2, 1, 3, 4, 3});
  append_array<std::int64_t>(out, {3, 6});
  append_array<double>(out, {0.25, -0.25});
  append_array<double>(out, {4, 3});
  append_array<std::uint8_t>(out, {0, 0});
  append_array<std::uint8_t>(out, {0, 1});
  append_array<std::uint8_t>(out, {0, 1});
  return out;
}

/// Two lines, in the order of kStreamlineArrays (field_checks.cpp).
std::string streamline_bytes() {
  std::string out;
  append_array<Vector3>(out, {{0, 0, 0}, {1, 0, 0}, {2, 0.5, 0}, {0, 0, 3}, {1, 1, 3}});
  append_array<std::int32_t>(out, {3, 5});
  append_array<std::uint8_t>(out, {0, 2});
  return out;
}

/// Two hexahedra, with and without a list of their boundary, in the order of kHexahedronArrays
/// (field_checks.cpp).
std::vector<std::string> hexahedron_bytes() {
  const HexMesh mesh = made_bricks({2, 1, 1}, {2, 1, 1});
  std::string out;
  append_array(out, mesh.vertices);
  append_array(out, mesh.hexahedra);
  append_array<std::int32_t>(out, {8, 16});
  append_array<std::uint8_t>(out, {12, 12});
  append_array(out, mesh.regions);
  std::vector<std::int32_t> corners, tags;
  for (const HexMesh::Face& face : mesh.boundary) {
    for (const std::uint32_t vertex : face.vertices) corners.push_back(static_cast<std::int32_t>(vertex));
    tags.push_back(face.tag);
  }
  std::string with_boundary = out;
  append_array(with_boundary, corners);
  append_array(with_boundary, tags);
  return {out, with_boundary};
}

std::vector<std::string> made_packed() {
  std::vector<std::string> out;
  for (const std::string& file : made_stl()) out.push_back(gzipped(file));
  return out;
}

std::vector<std::string> made_3mf_parts() {
  const std::string object = object_of_3mf("1", mesh_of_3mf());
  return {
      part_of_3mf(object, "<item objectid=\"1\"/>"),
      part_of_3mf(object + object_of_3mf("2",
                                         "<components><component objectid=\"1\" transform=\"2 0 0 0 2 0 0 "
                                         "0 -2 1 2 3\"/></components>"),
                  "<item objectid=\"2\" p:path=\"/3D/3dmodel.model\"/>", "unit=\"inch\"")};
}

std::vector<std::string> made_freecad_documents() {
  const FreeCadText box{"Part::Box", "Box", "a.brp"};
  FreeCadText part{"App::Part", "Part", "", {1, 2, 3}};
  part.group = {"Box", "Link"};
  FreeCadText link{"App::Link", "Link", "", {0, 0, 5}};
  link.linked = "Box";
  return {document_of({box}),
          document_of({part, box, link}) + '\0' + gui_of({{"Part", true}, {"Box", true}, {"Link", true}})};
}

std::vector<std::string> made_cad() {
  // Lines of 80 columns, of which the 73rd names the section.
  std::string iges;
  for (const char section : {'S', 'G', 'D', 'D', 'P', 'T'})
    iges += fmt::format("{:<72}{:>8}\n", "1H,,1H;", section + std::string("      1"));
  return {
      "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;"
      "\n",
      iges, "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nTShapes 1\nVe\n*\n+1 0\n",
      "\nOpen CASCADE Topology V3 (c)\nLocations 0\n"};
}

std::vector<std::string> made_cad_answers() {
  return {written(some_answer()), written({CadEnd::kFault, {}, {"is damaged", Remedy::kExportAgain}}),
          written({CadEnd::kOutOfMemory, {}, {}})};
}

std::vector<std::string> made_netgen_answers() {
  return {written(some_netgen_answer()),
          written(NetgenAnswer{NetgenEnd::kFault, "Netgen cannot mesh the faces", {}}),
          written(NetgenAnswer{NetgenEnd::kOutOfMemory, {}, {}})};
}

std::vector<std::string> made_constraints() {
  return {R"({"schema": 1,
 "points": [{"at": [30, 10, 10], "frame": [[1, 1, 0], [1, -1, 0], [0, 0, 1]]},
            {"at": [[5, 5, 5], [20, 20, 5]], "axis": [1, 2, 3], "weight": [1, 2]}],
 "polylines": [{"points": [[2, 2, 2], [60, 40, 20], [80, 40, 20]], "axis": "tangent", "weight": 3}]})",
          R"({"schema": 1, "faces": [{"face": [3, 7], "axis": [0, 0, 1]}, {"face": 2, "axis": "normal"}],
 "stresses": [{"at": [[40, 20, 10], [10, 10, 10]], "stress": [[1, 0, 0, 0, 0, 0.5], [4, 2, 2, 0, 0, 0]]},
              {"at": [1, 2, 3], "stress": [1, 2, 3, 4, 5, 6], "weight": 1e-3}]})"};
}

std::vector<std::string> made_reports() {
  SolveReport report = sample_report();
  HexReport& hexahedra = report.hexahedra.emplace();
  hexahedra.attempts.resize(2);
  hexahedra.best_attempt = hexahedra.attempts[1].number = 1;
  hexahedra.fit_tries.resize(2);
  hexahedra.best_fit = 1;
  hexahedra.features.emplace().lacking.resize(1);
  return {json_of(sample_report()).dump(1), json_of(report).dump(1)};
}

/// Each names what a mutation shall change.
std::vector<std::string> made_hex_options() {
  const std::string few = "solve.resolution 4\nhexahedra.cells 2\n";
  return {"model cube\nhexahedra.size 0.5\nsolve.resolution 4\n",
          "model cube\nscale 1e3\nhexahedra.size 500\nsolve.resolution 4\nsolve.degree 3\n",
          "model tet\nscale 1\n" + few + "hexahedra.threads 2\nsolve.threads 2\nsolve.seed 7\n",
          "model plate\nhexahedra.cells 3\nsolve.cell_size 0.75\nsolve.crease_angle_deg 35\n",
          "model cube\n" + few + "solve.max_memory_bytes 450000000\ntets.max_memory_bytes 450000000\n",
          "model cube\n" + few + "solve.unite_solids 1\nsolve.boundary 1\ntags.keep_all 1\ntets.unit 2\n",
          "model surface\n" + few + "tets.size 1\ntets.edges 2\ntets.edges_per_circle 18\n",
          "model surface\n" + few +
              "tets.edges 2\ntets.crease_angle_deg 35\ntets.seconds 60\n"
              "tets.maker 0\ntets.read_seconds 60\ntets.glue 1\n"};
}

}  // namespace

std::vector<std::string> made_inputs(std::string_view reader) {
  if (reader == "gzip") return made_packed();
  if (reader == "zip")
    return {zipped({{"a", "aaaa"}, {"b", ""}}), zipped({{"a", "aaaa"}, {"c/b", "c"}}, true)};
  if (reader == "threemf") return made_3mf_parts();
  if (reader == "freecad") return made_freecad_documents();
  if (reader == "stl") return made_stl();
  if (reader == "obj") return made_obj();
  if (reader == "ply") return made_ply();
  if (reader == "off") return made_off();
  if (reader == "medit") return made_medit();
  if (reader == "medit_binary") return made_medit_binary();
  if (reader == "gmsh") return contents(gmsh_files(small_tet_mesh()));
  if (reader == "vtk") return contents(vtk_files(small_tet_mesh()));
  if (reader == "vtu") return contents(vtu_files(small_tet_mesh()));
  if (reader == "vtu_data") return made_vtu_data();
  if (reader == "field") return made_fields();
  if (reader == "field_arrays")
    return {array_bytes(sample_data(Degree::kThree, 0)), array_bytes(sample_data(Degree::kFour, 1))};
  if (reader == "onto_arrays") return {onto_bytes()};
  if (reader == "repaired_arrays") return repaired_bytes();
  if (reader == "surface_arrays") return {surface_bytes()};
  if (reader == "singularity_arrays") return {singularity_bytes()};
  if (reader == "streamline_arrays") return {streamline_bytes()};
  if (reader == "hexahedron_arrays") return hexahedron_bytes();
  if (reader == "report") return made_reports();
  if (reader == "points") return {"0 0 0\n1.5 -2e3 .25 # a point\n\n# none\n3 4 5"};
  if (reader == "normals") return {"0 0 1\n1 0 0 2.5\n# none\n0.3 -4 1e-3 7\n"};
  if (reader == "constraints") return made_constraints();
  if (reader == "hex_medit") return made_hex_medit();
  if (reader == "hex_gmsh") return made_hex_gmsh();
  if (reader == "hex_vtk") return made_hex_vtk();
  if (reader == "abaqus") return made_abaqus();
  if (reader == "cad") return made_cad();
  if (reader == "cad_answer") return made_cad_answers();
  if (reader == "netgen_answer") return made_netgen_answers();
  if (reader == "hex_options") return made_hex_options();
  throw std::logic_error("no inputs for " + std::string(reader));
}

}  // namespace crossgrain
