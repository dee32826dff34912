// SPDX-License-Identifier: Apache-2.0
#include "measure/fault_words.hpp"

#include <gtest/gtest.h>

namespace crossgrain {
namespace {

using Corner = FieldAnalysis::Singularity::Corner;
using Node = FieldAnalysis::Singularity::Node;

TEST(WordsOfFaces, AreTheirNumbersEachOnce) {
  EXPECT_EQ(words_of_faces({}, kFaceNoun), "");
  EXPECT_EQ(words_of_faces({7, 7}, kFaceNoun), "face 7");
  EXPECT_EQ(words_of_faces({3, 5, 3, 9}, kFaceNoun), "faces 3, 5 and 9");
  EXPECT_EQ(words_of_faces({1, 2, 3, 4, 5, 6}, kFaceNoun), "faces 1, 2, 3, 4 and 2 others");
}

TEST(WordsOfFaces, LeaveOutThoseWithoutANumber) {
  EXPECT_EQ(words_of_faces({0}, kFaceNoun), "");
  EXPECT_EQ(words_of_faces({0, 4}, kFaceNoun), "face 4");
  FieldAnalysis::Singularity::Corner corner;
  corner.narrowest_deg = 60;
  corner.faces = {0};
  corner.creases = {1, 1, 1, 1};
  EXPECT_EQ(fault_of(corner, kFaceNoun), "no hexahedra fit in a corner where 4 convex edges meet");
  corner.narrowest_deg = 2;
  corner.faces = {4, 0, 5};
  EXPECT_EQ(fault_of(corner, kFaceNoun), "face 4 tapers to nothing");
  corner.faces = {0, 4, 5};
  EXPECT_EQ(fault_of(corner, kFaceNoun), "a face tapers to nothing");
}

TEST(WordsOfFaces, CallThoseOfASurfaceOfTrianglesPatches) {
  EXPECT_EQ(words_of_faces({7}, noun_of({{.number = 7, .kind = FaceKind::kPatch}})), "patch 7");
  EXPECT_EQ(words_of_faces({7, 8}, noun_of({{.number = 7, .kind = FaceKind::kPatch}})), "patches 7 and 8");
  EXPECT_EQ(words_of_faces({7}, noun_of({{.number = 7, .kind = FaceKind::kPlane}})), "face 7");
  EXPECT_EQ(words_of_faces({7}, noun_of({})), "face 7");
  EXPECT_EQ(between({7, 8}, kPatchNoun), " between patches 7 and 8");
}

TEST(FaultOfACorner, NamesTheFaceThatTapersAndThoseBesideIt) {
  Corner corner;
  corner.creases = {1, 3};
  corner.faces = {9, 12, 17};
  corner.narrowest_deg = 8;
  EXPECT_EQ(fault_of(corner, kFaceNoun), "face 9 tapers to nothing between faces 17 and 12");
  corner.faces = {};
  EXPECT_EQ(fault_of(corner, kFaceNoun), "a face tapers to nothing");
}

TEST(FaultOfACorner, TellsItsEdges) {
  Corner corner;
  corner.creases = {1, 1, 1, 3};
  corner.faces = {1, 2, 3, 4};
  corner.narrowest_deg = 60;
  EXPECT_EQ(
      fault_of(corner, kFaceNoun),
      "no hexahedra fit in a corner of faces 1, 2, 3 and 4 where 3 convex edges and 1 concave edge meet");
}

TEST(FaultOfACorner, OfOneEdgeIsItsEnd) {
  Corner corner;
  corner.creases = {3};
  corner.faces = {12};
  corner.narrowest_deg = 270;
  EXPECT_EQ(fault_of(corner, kFaceNoun), "no hexahedra fit at a point of the surface of face 12")
      << "the edge is one of coarse tets, none of the model";
  EXPECT_EQ(fault_of(corner, kPatchNoun), "no hexahedra fit at the end of a sharp edge of patch 12");
  corner.faces = {12, 14};
  EXPECT_EQ(fault_of(corner, kFaceNoun), "no hexahedra fit at the end of a sharp edge of faces 12 and 14");
}

TEST(PlacesOfFaults, AreListedOnceEach) {
  FieldAnalysis::Singularity graph;
  graph.corner_list.resize(3);
  graph.arc_list.resize(1);
  for (Corner& corner : graph.corner_list) corner.verdict = Verdict::kNotMeshable;
  graph.corner_list[0].place = graph.corner_list[1].place = {1, 2, 3};
  graph.corner_list[2].verdict = Verdict::kMeshable;
  graph.arc_list[0].verdict = Verdict::kNotMeshable;
  EXPECT_EQ(places_of_faults(graph), (std::vector<Vector3>{{1, 2, 3}, {0, 0, 0}}));
}

TEST(FaultOfANode, OfOneLineIsItsEnd) {
  Node node;
  node.arcs = {4};
  EXPECT_EQ(fault_of(node), "a singular line ends where hexahedra cannot end it");
}

}  // namespace
}  // namespace crossgrain
