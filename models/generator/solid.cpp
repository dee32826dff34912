// SPDX-License-Identifier: Apache-2.0
#include "solid.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <stdexcept>
#include <string>

namespace crossgrain::models {
namespace {

/// Lines of less than a millionth of a radian between them are parallel.
constexpr double kAngularTolerance = 1e-6;

TopTools_ListOfShape list_of(const std::vector<TopoDS_Shape>& shapes) {
  TopTools_ListOfShape list;
  for (const TopoDS_Shape& shape : shapes) list.Append(shape);
  return list;
}

/// Merges faces and edges that a boolean operation has left split.
TopoDS_Shape unified(const TopoDS_Shape& shape) {
  ShapeUpgrade_UnifySameDomain unify(shape);
  unify.Build();
  return unify.Shape();
}

template <class Operation>
TopoDS_Shape boolean(const std::vector<TopoDS_Shape>& arguments, const std::vector<TopoDS_Shape>& tools) {
  Operation operation;
  operation.SetArguments(list_of(arguments));
  operation.SetTools(list_of(tools));
  operation.Build();
  if (!operation.IsDone() || operation.HasErrors()) throw std::runtime_error("a boolean operation failed");
  return unified(operation.Shape());
}

std::vector<TopoDS_Edge> chosen_edges(const TopoDS_Shape& solid, const char* what,
                                      const std::function<bool(const EdgeFacts&)>& choice) {
  std::vector<TopoDS_Edge> edges = edges_of(solid, choice);
  if (edges.empty()) throw std::runtime_error(std::string("no edge to round or chamfer: ") + what);
  return edges;
}

/// Runs MakeFillet or MakeChamfer on edges that were added to it.
template <class Operation>
TopoDS_Shape built(Operation& operation, const char* what) {
  operation.Build();
  if (!operation.IsDone()) throw std::runtime_error(std::string("OpenCASCADE could not make ") + what);
  return operation.Shape();
}

}  // namespace

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high) {
  return BRepPrimAPI_MakeBox(low, high).Shape();
}

TopoDS_Shape cylinder(const gp_Pnt& base, const gp_Dir& direction, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(base, direction), radius, height).Shape();
}

TopoDS_Shape cone(const gp_Pnt& base, const gp_Dir& direction, double base_radius, double top_radius,
                  double height) {
  return BRepPrimAPI_MakeCone(gp_Ax2(base, direction), base_radius, top_radius, height).Shape();
}

TopoDS_Shape prism(const std::vector<gp_Pnt>& corners, const gp_Vec& sweep) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const gp_Pnt& corner : corners) polygon.Add(corner);
  polygon.Close();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), sweep).Shape();
}

TopoDS_Shape fuse(const std::vector<TopoDS_Shape>& solids) {
  return boolean<BRepAlgoAPI_Fuse>({solids.front()}, {solids.begin() + 1, solids.end()});
}

TopoDS_Shape cut(const TopoDS_Shape& solid, const std::vector<TopoDS_Shape>& tools) {
  return boolean<BRepAlgoAPI_Cut>({solid}, tools);
}

bool EdgeFacts::along(const gp_Dir& direction) const {
  return straight && gp_Dir(gp_Vec(start, end)).IsParallel(direction, kAngularTolerance);
}

std::vector<TopoDS_Edge> edges_of(const TopoDS_Shape& solid,
                                  const std::function<bool(const EdgeFacts&)>& choice) {
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(solid, TopAbs_EDGE, all);
  std::vector<TopoDS_Edge> edges;
  for (int i = 1; i <= all.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(all(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    const EdgeFacts facts{curve.Value(first), curve.Value((first + last) / 2), curve.Value(last),
                          curve.GetType() == GeomAbs_Line};
    if (choice(facts)) edges.push_back(edge);
  }
  return edges;
}

TopoDS_Shape fillet(const TopoDS_Shape& solid, double radius, const char* what,
                    const std::function<bool(const EdgeFacts&)>& choice) {
  BRepFilletAPI_MakeFillet operation(solid);
  for (const TopoDS_Edge& edge : chosen_edges(solid, what, choice)) operation.Add(radius, edge);
  return built(operation, what);
}

TopoDS_Shape chamfer(const TopoDS_Shape& solid, double distance, const char* what,
                     const std::function<bool(const EdgeFacts&)>& choice) {
  BRepFilletAPI_MakeChamfer operation(solid);
  for (const TopoDS_Edge& edge : chosen_edges(solid, what, choice)) operation.Add(distance, edge);
  return built(operation, what);
}

}  // namespace crossgrain::models
