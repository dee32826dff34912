// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/bodies.hpp"

#include <fmt/format.h>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <optional>
#include <utility>

#include "cad_reading/program/distinct_bodies.hpp"
#include "cad_reading/program/fault.hpp"
#include "cad_reading/program/glued_solids.hpp"
#include "cad_reading/program/known_faces.hpp"

namespace crossgrain {
namespace {

/// Relative to the longest side: above the gaps of IGES files, below any practical cell size.
constexpr double kSewingTolerance = 1e-5;

/// Returns the distinct shapes of a kind in the order of TopExp::MapShapes, except those inside a shape of
/// `avoided`.
std::vector<TopoDS_Shape> shapes_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind,
                                    TopAbs_ShapeEnum avoided = TopAbs_SHAPE) {
  TopTools_IndexedMapOfShape seen;
  std::vector<TopoDS_Shape> found;
  for (TopExp_Explorer explorer(shape, kind, avoided); explorer.More(); explorer.Next()) {
    const int known = seen.Extent();
    if (seen.Add(explorer.Current()) > known) found.push_back(explorer.Current());
  }
  return found;
}

TopoDS_Shape compound_of(const std::vector<Body>& bodies) {
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const Body& body : bodies) builder.Add(compound, body.shape);
  return compound;
}

TopoDS_Shape shell_of(const TopoDS_Shape& face) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, face);
  return shell;
}

/// Joins the faces that belong to no solid into shells: closed shells stay as they are, all else is sewn.
/// Faces that lie on others are left out if these close up without them: otherwise they may bound a body
/// beside it.
class LooseFaces {
 public:
  LooseFaces(const TopoDS_Shape& shape, double longest_side) : tolerance_(kSewingTolerance * longest_side) {
    std::vector<TopoDS_Shape> to_sew = shapes_of(shape, TopAbs_FACE, TopAbs_SHELL);
    for (const TopoDS_Shape& shell : shapes_of(shape, TopAbs_SHELL, TopAbs_SOLID)) {
      (BRep_Tool::IsClosed(shell) ? shells_ : to_sew).push_back(shell);
    }
    if (to_sew.empty()) return;
    const auto [once, copies] = without_copies(to_sew);
    if (copies > 0) sew(once);
    if (copies > 0 && sewing_->NbFreeEdges() + sewing_->NbMultipleEdges() == 0)
      copies_ = copies;
    else
      sew(to_sew);
    collect_shells();
  }

  const std::vector<TopoDS_Shape>& shells() const { return shells_; }

  /// Number of faces that were left out.
  std::size_t copies() const { return copies_; }

  /// Returns what a face of the original shape has become.
  TopoDS_Shape now(const TopoDS_Shape& face) const {
    return sewing_ ? sewing_->ModifiedSubShape(face) : face;
  }

 private:
  /// Returns the faces of shapes that do not lie on earlier ones, and the number of the others.
  std::pair<std::vector<TopoDS_Shape>, std::size_t> without_copies(
      const std::vector<TopoDS_Shape>& shapes) const {
    KnownFaces known(tolerance_);
    std::vector<TopoDS_Shape> once;
    std::size_t copies = 0;
    for (const TopoDS_Shape& shape : shapes) {
      for (const TopoDS_Shape& face : shapes_of(shape, TopAbs_FACE)) {
        if (known.hold(face)) {
          ++copies;
          continue;
        }
        known.add(face);
        once.push_back(face);
      }
    }
    return {std::move(once), copies};
  }

  void sew(const std::vector<TopoDS_Shape>& parts) {
    sewing_.emplace(tolerance_);
    for (const TopoDS_Shape& part : parts) sewing_->Add(part);
    sewing_->Perform();
  }

  void collect_shells() {
    const TopoDS_Shape sewn = sewing_->SewedShape();
    if (sewn.IsNull()) return;
    for (const TopoDS_Shape& shell : shapes_of(sewn, TopAbs_SHELL)) shells_.push_back(shell);
    for (const TopoDS_Shape& face : shapes_of(sewn, TopAbs_FACE, TopAbs_SHELL))
      shells_.push_back(shell_of(face));
  }

  double tolerance_;
  std::optional<BRepBuilderAPI_Sewing> sewing_;
  std::vector<TopoDS_Shape> shells_;
  std::size_t copies_ = 0;
};

std::vector<TopoDS_Shape> shapes_in(const std::vector<Body>& bodies) {
  std::vector<TopoDS_Shape> shapes;
  for (const Body& body : bodies) shapes.push_back(body.shape);
  return shapes;
}

/// Returns the pieces that solids were cut into, with the numbers of these.
std::vector<Body> pieces_of(const GluedSolids& glued, const std::vector<Body>& solids) {
  std::vector<Body> pieces;
  for (const auto& [piece, place] : glued.pieces()) pieces.push_back({piece, true, solids[place].solid});
  return pieces;
}

/// Throws Fault if a file has nothing but open faces that meet no other.
void refuse_faces_alone(const std::vector<Body>& shells) {
  const auto is_alone = [](const Body& shell) {
    return !shell.closed && shapes_of(shell.shape, TopAbs_FACE).size() == 1;
  };
  if (!std::all_of(shells.begin(), shells.end(), is_alone)) return;
  throw Fault(shells.size() == 1
                  ? "has one open face and no solid, and encloses nothing"
                  : fmt::format("has {} open faces, none of which meets another, and encloses nothing",
                                shells.size()),
              Remedy::kCloseSurface);
}

Warning warning_of(std::size_t solids, const std::vector<Body>& shells) {
  const auto closed =
      std::count_if(shells.begin(), shells.end(), [](const Body& shell) { return shell.closed; });
  const std::string parts =
      fmt::format("{} closed and {} open, each solved as a separate solid", closed, shells.size() - closed);
  const char* const what = solids == 0 ? "the file has no solids, only faces, which form shells: "
                                       : "the file has faces that belong to no solid and form shells: ";
  return {WarningKind::kLooseFaces, what + parts};
}

}  // namespace

double longest_side_at_most(const TopoDS_Shape& shape) {
  Bnd_Box box;
  const bool use_triangulation = false;
  BRepBndLib::Add(shape, box, use_triangulation);
  if (box.IsVoid()) return 0;
  if (box.IsOpen()) throw Fault("has a face or curve without bounds", Remedy::kExportAgain);
  double low[3], high[3];
  box.Get(low[0], low[1], low[2], high[0], high[1], high[2]);
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

Bodies find_bodies(const TopoDS_Shape& shape, const CadReading& options) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  if (faces.IsEmpty()) throw Fault("has no faces, only curves or points", Remedy::kExportAgain);

  Bodies result;
  result.whole = shape;
  const std::vector<TopoDS_Shape> solids = shapes_of(shape, TopAbs_SOLID);
  const double longest_side = longest_side_at_most(shape);
  const LooseFaces loose(shape, longest_side);
  const DistinctBodies distinct = distinct_bodies(solids, loose.shells(), kSewingTolerance * longest_side);
  if (loose.copies() > 0)
    result.warnings.emplace_back(WarningKind::kRepeatedBodies,
                                 fmt::format("faces that lie on others, left out: {}", loose.copies()));
  result.warnings.insert(result.warnings.end(), distinct.warnings.begin(), distinct.warnings.end());
  std::optional<GluedSolids> glued;
  if (options.glue && distinct.solids.size() > 1)
    glued.emplace(shapes_in(distinct.solids), options.glue_gap * longest_side);
  result.bodies = glued ? pieces_of(*glued, distinct.solids) : distinct.solids;
  if (!distinct.shells.empty()) {
    if (solids.empty()) refuse_faces_alone(distinct.shells);
    result.warnings.push_back(warning_of(solids.size(), distinct.shells));
  }
  result.bodies.insert(result.bodies.end(), distinct.shells.begin(), distinct.shells.end());
  if (glued || !loose.shells().empty() || distinct.solids.size() < solids.size())
    result.whole = compound_of(result.bodies);

  TopExp::MapShapes(result.whole, TopAbs_FACE, result.faces);
  TopExp::MapShapes(result.whole, TopAbs_EDGE, result.edges);
  result.face_numbers.assign(static_cast<std::size_t>(result.faces.Extent()) + 1, 0);
  for (int number = 1; number <= faces.Extent(); ++number) {
    const TopoDS_Shape sewn = result.faces.Contains(faces(number)) ? faces(number) : loose.now(faces(number));
    for (const TopoDS_Shape& face : glued ? glued->parts_of(sewn) : std::vector<TopoDS_Shape>{sewn}) {
      std::int32_t& known = result.face_numbers[static_cast<std::size_t>(result.faces.FindIndex(face))];
      if (known == 0) known = number;
    }
  }
  return result;
}

}  // namespace crossgrain
