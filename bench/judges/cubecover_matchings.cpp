// SPDX-License-Identifier: Apache-2.0
// Prints what CubeCover makes of a field, for matchings.py: its own matchings of the frames, a line `face A B
// P1 P2 P3` for each inner face, and the singular edges, a line `own A B` of vertices by these matchings and
// `given A B` by the .perm file.
//
//     cubecover_matchings MESH FRA PERM
//
// build.sh links it with CubeCover; it is no part of the project's build.

#include <iostream>
#include <memory>

#include "FrameField.h"
#include "ReadFrameField.h"
#include "TetMeshConnectivity.h"
#include "readMeshFixed.h"

namespace {

void print_singular_edges(const CubeCover::TetMeshConnectivity& tets, const CubeCover::FrameField& field,
                          const char* name) {
  for (int i = 0; i < field.nSingularEdges(); ++i) {
    const int edge = field.singularEdge(i);
    std::cout << name << ' ' << tets.edgeVertex(edge, 0) << ' ' << tets.edgeVertex(edge, 1) << '\n';
  }
}

void print_matchings(const CubeCover::TetMeshConnectivity& tets, const CubeCover::FrameField& field) {
  for (int face = 0; face < tets.nFaces(); ++face) {
    if (tets.isBoundaryFace(face)) continue;
    std::cout << "face " << tets.faceTet(face, 0) << ' ' << tets.faceTet(face, 1);
    const CubeCover::AssignmentGroup& matching = field.faceAssignment(face);
    for (int axis = 0; axis < 3; ++axis)
      std::cout << ' ' << matching.targetSign(axis) * (matching.targetVector(axis) + 1);
    std::cout << '\n';
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::cerr << "usage: cubecover_matchings MESH FRA PERM\n";
    return 2;
  }
  Eigen::MatrixXd points, frames;
  Eigen::MatrixXi corners, triangles, rows;
  if (!CubeCover::readMESH(arguments[1], points, corners, triangles)) return 1;
  if (!CubeCover::readFrameField(arguments[2], arguments[3], corners, frames, rows, true)) return 1;
  const CubeCover::TetMeshConnectivity tets(corners);
  if (!tets.isManifold(true) || !tets.isFaceConnected()) return 1;
  const std::unique_ptr<CubeCover::FrameField> field(fromFramesAndAssignments(tets, frames, rows, true));
  if (!field) return 1;
  print_singular_edges(tets, *field, "given");
  field->computeLocalAssignments();
  print_matchings(tets, *field);
  print_singular_edges(tets, *field, "own");
  return 0;
}
