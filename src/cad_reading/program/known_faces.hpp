// SPDX-License-Identifier: Apache-2.0
// Which faces are there already, as the same shape or as a copy of it.
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <Bnd_Box.hxx>
#include <IntTools_Context.hxx>
#include <NCollection_UBTree.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace crossgrain {

/// Faces of bodies, to find others that lie on them: copies of them, in either orientation, whole or in
/// parts, cut into faces in the same way or in another.
class KnownFaces {
 public:
  /// Faces lie on others where they are at most `tolerance` apart, model units.
  explicit KnownFaces(double tolerance) : tolerance_(tolerance), context_(new IntTools_Context) {}

  void add(const TopoDS_Shape& body);

  /// Whether all faces of a body lie on known ones, as far as points of them tell.
  bool hold(const TopoDS_Shape& body) const;

 private:
  using BoxTree = NCollection_UBTree<int, Bnd_Box>;
  class FacesAt;

  bool hold_face(const TopoDS_Face& face) const;
  bool hold_point(const gp_Pnt& point) const;
  std::vector<gp_Pnt> points_of(const TopoDS_Face& face) const;

  double tolerance_;
  Handle(IntTools_Context) context_;  ///< keeps what projections onto faces need
  TopTools_MapOfShape shapes_;        ///< faces whatever their orientation
  std::vector<TopoDS_Face> faces_;
  BoxTree boxes_;  ///< of the faces, by their place
};

}  // namespace crossgrain
