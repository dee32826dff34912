// SPDX-License-Identifier: Apache-2.0
// Writes small CAD files, whose measures are known, to a folder: make_cad_files FOLDER
#include <BOPAlgo_Builder.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

TopoDS_Shape box(const gp_Pnt& low, const gp_Pnt& high) {
  return BRepPrimAPI_MakeBox(low, high).Shape();
}

/// 40 by 30 by 10 with a hole of radius 5 through it.
TopoDS_Shape plate() {
  const gp_Ax2 axis(gp_Pnt(20, 15, -1), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(box({0, 0, 0}, {40, 30, 10}), BRepPrimAPI_MakeCylinder(axis, 5, 12).Shape()).Shape();
}

/// 40 by 30 by 12 with a chamfer of .4 along an edge of its top.
TopoDS_Shape chamfered_block() {
  const TopoDS_Shape sharp = box({0, 0, 0}, {40, 30, 12});
  BRepFilletAPI_MakeChamfer chamfer(sharp);
  for (TopExp_Explorer edges(sharp, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
    const gp_Pnt middle = BRepAdaptor_Curve(edge).Value(15);
    if (middle.Distance({0, 15, 12}) > 1e-6) continue;
    chamfer.Add(0.4, edge);
    break;
  }
  return chamfer.Shape();
}

/// 20 by 20 by 20, all edges rounded with radius 3.
TopoDS_Shape rounded_box() {
  const TopoDS_Shape sharp = box({0, 0, 0}, {20, 20, 20});
  BRepFilletAPI_MakeFillet fillet(sharp);
  for (TopExp_Explorer edges(sharp, TopAbs_EDGE); edges.More(); edges.Next())
    fillet.Add(3, TopoDS::Edge(edges.Current()));
  return fillet.Shape();
}

/// Boxes of 10 by 10 by 10 and 5 by 10 by 10 with one face in common, which both of them have.
TopoDS_Shape glued_boxes() {
  BOPAlgo_Builder builder;
  builder.AddArgument(box({0, 0, 0}, {10, 10, 10}));
  builder.AddArgument(box({10, 0, 0}, {15, 10, 10}));
  builder.Perform();
  return builder.Shape();
}

/// A core of radius 3 in a sleeve of radius 6, both 10 high, with their faces in common.
TopoDS_Shape core_in_sleeve() {
  const gp_Ax2 axis(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 2));
  BOPAlgo_Builder builder;
  builder.AddArgument(BRepPrimAPI_MakeCylinder(axis, 6, 10).Shape());
  builder.AddArgument(BRepPrimAPI_MakeCylinder(axis, 3, 10).Shape());
  builder.Perform();
  return builder.Shape();
}

TopoDS_Shape together(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  builder.Add(compound, a);
  builder.Add(compound, b);
  return compound;
}

/// A small box on the middle of a large one, with nothing in common.
TopoDS_Shape stacked_boxes() {
  return together(box({0, 0, 0}, {20, 20, 10}), box({6, 7, 10}, {13, 13, 15}));
}

/// Two boxes of which half a face each touches: 50 of 100.
TopoDS_Shape offset_boxes() {
  return together(box({0, 0, 0}, {10, 10, 10}), box({10, 5, 0}, {20, 15, 10}));
}

/// A box of 4 by 4 by 6 in a pocket of its size, flush with the top of a box of 10 by 10 by 10.
TopoDS_Shape box_in_a_pocket() {
  const TopoDS_Shape inner = box({3, 3, 4}, {7, 7, 10});
  return together(BRepAlgoAPI_Cut(box({0, 0, 0}, {10, 10, 10}), inner).Shape(), inner);
}

/// The plate with a pin of radius 5 in its hole, which stands out by 5 above and below.
TopoDS_Shape plate_with_pin() {
  const gp_Ax2 axis(gp_Pnt(20, 15, -5), gp_Dir(0, 0, 1));
  return together(plate(), BRepPrimAPI_MakeCylinder(axis, 5, 20).Shape());
}

/// A box of 1000 and one of 360, of which 180 are in both.
TopoDS_Shape overlapping_boxes() {
  return together(box({0, 0, 0}, {10, 10, 10}), box({5, 2, 2}, {15, 8, 8}));
}

TopoDS_Shape copy_of(const TopoDS_Shape& shape) {
  return BRepBuilderAPI_Copy(shape).Shape();
}

TopoDS_Shape shell_of(const TopoDS_Shape& solid) {
  return TopExp_Explorer(solid, TopAbs_SHELL).Current();
}

TopoDS_Shape ball(const gp_Dir& axis) {
  return BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(1, 2, 3), axis), 5).Shape();
}

/// Some faces of a shape, each a copy that looks the other way.
TopoDS_Shape faces_turned(const TopoDS_Shape& shape, int count) {
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More() && count-- > 0; faces.Next())
    builder.Add(compound, copy_of(faces.Current()).Reversed());
  return compound;
}

/// A cube of 10 with a void of 4 by 4 by 4 in its middle, and a cube that fills the void.
TopoDS_Shape filled_void() {
  const TopoDS_Shape core = box({3, 3, 3}, {7, 7, 7});
  return together(BRepAlgoAPI_Cut(box({0, 0, 0}, {10, 10, 10}), core).Shape(), copy_of(core));
}

/// A solid between two others that are like it.
TopoDS_Shape bricks() {
  const TopoDS_Shape outer = together(box({0, 0, 0}, {1, 2, 3}), box({2, 0, 0}, {3, 2, 3}));
  return together(outer, box({1, 0, 0}, {2, 2, 3}));
}

/// The same box twice, once as it is and once turned by a right angle about z and moved by 100 along x: from
/// 90 to 100 along x.
TopoDS_Shape assembly() {
  const TopoDS_Shape part = box({0, 0, 0}, {20, 10, 5});
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), M_PI / 2);
  move.SetTranslation(gp_Vec(100, 0, 0));
  return together(part, part.Moved(TopLoc_Location(move * turn)));
}

/// A solid whose faces look inwards.
TopoDS_Shape inside_out() {
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  for (TopExp_Explorer shells(box({0, 0, 0}, {1, 2, 3}), TopAbs_SHELL); shells.More(); shells.Next())
    builder.Add(solid, shells.Current().Reversed());
  return solid;
}

/// A disc, which is open.
TopoDS_Shape disc(const gp_Pnt& centre) {
  const gp_Circ circle(gp_Ax2(centre, gp_Dir(0, 0, 1)), 5);
  return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle))).Shape();
}

/// The faces of a box, all but the first `missing`, as a shell or each by itself.
TopoDS_Shape faces_of_box(int missing, bool as_shell) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  TopoDS_Compound compound;
  builder.MakeShell(shell);
  builder.MakeCompound(compound);
  for (TopExp_Explorer faces(box({0, 0, 0}, {1, 2, 3}), TopAbs_FACE); faces.More(); faces.Next()) {
    if (missing-- > 0) continue;
    builder.Add(as_shell ? static_cast<TopoDS_Shape&>(shell) : compound, faces.Current());
  }
  return as_shell ? static_cast<TopoDS_Shape>(shell) : compound;
}

class Folder {
 public:
  explicit Folder(std::string path) : path_(std::move(path)) {}

  void brep(const TopoDS_Shape& shape, const char* name) const {
    check(BRepTools::Write(shape, (path_ + name).c_str()), name);
  }
  void binary_brep(const TopoDS_Shape& shape, const char* name) const {
    check(BinTools::Write(shape, (path_ + name).c_str()), name);
  }
  void step(const TopoDS_Shape& shape, const char* name, const char* unit) const {
    // The writer looks at its settings when it is made, and there are none before that.
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("write.step.unit", unit);
    STEPControl_Writer writer;
    check(writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone, name);
    check(writer.Write((path_ + name).c_str()) == IFSelect_RetDone, name);
  }
  void iges(const TopoDS_Shape& shape, const char* name, const char* unit, bool as_solids) const {
    IGESControl_Writer writer(unit, as_solids ? 1 : 0);
    check(writer.AddShape(shape), name);
    check(writer.Write((path_ + name).c_str()), name);
  }

 private:
  static void check(bool done, const char* name) {
    if (!done) throw std::runtime_error(std::string(name) + " could not be written");
  }
  std::string path_;
};

void write_all(const Folder& folder) {
  folder.step(plate(), "plate.step", "MM");
  folder.step(plate(), "inch.stp", "INCH");
  folder.iges(plate(), "plate.iges", "MM", true);
  folder.iges(plate(), "inch.igs", "IN", true);
  folder.iges(plate(), "faces.iges", "MM", false);
  folder.brep(plate(), "plate.brep");
  folder.binary_brep(plate(), "plate.brp");
  const gp_Ax2 axis(gp_Pnt(3, 4, 5), gp_Dir(0, 0, 1));
  folder.brep(box({0, 0, 0}, {1, 2, 3}), "box.brep");
  folder.brep(BRepPrimAPI_MakeCylinder(axis, 5, 20).Shape(), "cylinder.brep");
  folder.step(BRepPrimAPI_MakeCylinder(axis, 5, 20).Shape(), "cylinder.step", "MM");
  folder.brep(BRepPrimAPI_MakeCone(axis, 5, 0, 10).Shape(), "cone.brep");
  folder.brep(BRepPrimAPI_MakeSphere(axis, 5).Shape(), "sphere.brep");
  const gp_Ax2 oblique(gp_Pnt(1, 2, 3), gp_Dir(1, 2, 3));
  const TopoDS_Shape turned[] = {
      BRepPrimAPI_MakeSphere(oblique, 5).Shape(), BRepPrimAPI_MakeCylinder(oblique, 5, 20).Shape(),
      BRepPrimAPI_MakeCone(oblique, 5, 0, 20).Shape(), BRepPrimAPI_MakeTorus(oblique, 10, 2).Shape()};
  const char* const names[] = {"sphere", "cylinder", "cone", "torus"};
  for (int k = 0; k < 4; ++k) {
    folder.brep(turned[k], (std::string("oblique_") + names[k] + ".brep").c_str());
    folder.brep(BRepBuilderAPI_NurbsConvert(turned[k]).Shape(),
                (std::string("spline_") + names[k] + ".brep").c_str());
  }
  folder.step(chamfered_block(), "chamfered.step", "MM");
  folder.brep(rounded_box(), "rounded.brep");
  folder.brep(glued_boxes(), "glued.brep");
  folder.step(glued_boxes(), "glued.step", "MM");
  folder.brep(core_in_sleeve(), "sleeve.brep");
  folder.step(core_in_sleeve(), "sleeve.step", "MM");
  folder.brep(stacked_boxes(), "stacked.brep");
  folder.brep(offset_boxes(), "offset.brep");
  folder.step(box_in_a_pocket(), "pocket.step", "MM");
  folder.step(plate_with_pin(), "pin.step", "MM");
  folder.brep(overlapping_boxes(), "overlapping.brep");
  folder.brep(assembly(), "assembly.brep");
  folder.brep(together(shell_of(plate()), plate()), "copied_shell.brep");
  const TopoDS_Shape solid = ball({0, 0, 1});
  folder.brep(together(shell_of(solid), solid), "own_shell.brep");
  folder.brep(together(solid, shell_of(ball({1, 1, 0})).Reversed()), "turned_shell.brep");
  folder.brep(together(plate(), faces_turned(plate(), 7)), "copied_faces.brep");
  folder.brep(together(plate(), faces_turned(plate(), 3)), "some_faces.brep");
  folder.step(together(plate(), plate()), "twice.step", "MM");
  folder.iges(together(plate(), copy_of(plate())), "doubled.iges", "MM", false);
  folder.brep(filled_void(), "filled_void.brep");
  folder.brep(bricks(), "bricks.brep");
  folder.brep(together(box({0, 0, 0}, {1, 2, 3}), shell_of(box({1, 0, 0}, {3, 2, 3}))), "shell_beside.brep");
  folder.step(assembly(), "assembly.step", "MM");
  folder.brep(inside_out(), "inside_out.brep");
  folder.brep(faces_of_box(0, true), "shell.brep");
  folder.brep(faces_of_box(0, false), "loose.brep");
  folder.brep(faces_of_box(1, true), "open.brep");
  folder.brep(disc({0, 0, 0}), "face.brep");
  folder.brep(together(disc({0, 0, 0}), disc({0, 0, 20})), "faces_apart.brep");
  folder.brep(BRepBuilderAPI_MakeFace(gp_Pln()).Shape(), "endless.brep");
  folder.brep(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Shape(), "curve.brep");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  write_all(Folder(std::string(argv[1]) + "/"));
  return 0;
}
