// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/solid_text.hpp"

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <sstream>

#include "cad_reading/program/fault.hpp"

namespace crossgrain {
namespace {

TopoDS_Shape outward(const TopoDS_Shape& solid) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  return properties.Mass() < 0 ? solid.Reversed() : solid;
}

TopoDS_Shape solid_of(const TopoDS_Shape& body) {
  if (body.ShapeType() == TopAbs_SOLID) return outward(body);
  return outward(BRepBuilderAPI_MakeSolid(TopoDS::Shell(body)).Solid());
}

std::string text_of(const TopoDS_Shape& shape) {
  std::ostringstream text;
  const bool with_triangles = false, with_normals = false;
  BRepTools::Write(shape, text, with_triangles, with_normals, TopTools_FormatVersion_VERSION_1);
  return text.str();
}

}  // namespace

CadSolids solids_of(const Bodies& bodies) {
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  CadSolids result;
  for (const Body& body : bodies.bodies) {
    if (!body.closed) continue;
    builder.Add(compound, solid_of(body.shape));
    result.solid_numbers.push_back(body.solid);
  }
  TopTools_IndexedMapOfShape faces, edges;
  TopExp::MapShapes(compound, TopAbs_FACE, faces);
  TopExp::MapShapes(compound, TopAbs_EDGE, edges);
  for (int face = 1; face <= faces.Extent(); ++face) {
    const int place = bodies.faces.FindIndex(faces(face));
    result.face_numbers.push_back(bodies.face_numbers[static_cast<std::size_t>(place)]);
  }
  for (int edge = 1; edge <= edges.Extent(); ++edge)
    result.edge_numbers.push_back(bodies.edges.FindIndex(edges(edge)));
  if (!result.solid_numbers.empty()) result.brep = text_of(compound);
  return result;
}

}  // namespace crossgrain
