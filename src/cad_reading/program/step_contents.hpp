// SPDX-License-Identifier: Apache-2.0
// What a STEP file holds, as far as OpenCASCADE could read it.
#pragma once

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Standard_Transient.hxx>
#include <StepRepr_Representation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <string>
#include <vector>

namespace crossgrain {

/// The entities of a STEP file and their references. Files of sound solids often hold entities that
/// OpenCASCADE cannot read, such as annotations of unknown types or '$' in place of a name.
class StepContents {
 public:
  /// The graph must outlive this object.
  explicit StepContents(const Interface_Graph& graph);

  /// Throws Fault naming the first entity that could not be read and that faces or their places need:
  /// OpenCASCADE would crash on null pointers, or read less than the file holds. Takes other such entities,
  /// and what refers to them, out of the representations.
  void keep_sound_shapes() const;

  /// Returns whether faces belong to a root for transfer, such as a product. Documents have none.
  bool holds_faces(const Handle(Standard_Transient) & root) const;

  /// Returns the units of length in the contexts of representations that hold faces or solids, each once, in
  /// the order of the file: "mm", "inch", or whatever name the file gives one. STEPControl_Reader::FileUnits
  /// finds none where a unit is converted by a plain MEASURE_WITH_UNIT, as in files of AP242.
  std::vector<std::string> length_units() const;

  /// Returns the names of other files that hold parts of the model.
  std::vector<std::string> other_files() const;

 private:
  /// Of entities, by their numbers from 1.
  using Marks = std::vector<bool>;

  void mark_damaged();
  void mark_spoiled();
  void mark_shapes();
  Marks needed() const;
  Interface_EntityIterator shapes_in(const StepShape_ShapeRepresentation& representation) const;
  void leave_out_spoiled(StepRepr_Representation& representation) const;
  bool loses_shapes(int representation) const;
  bool is_shape_representation(int number) const;

  int count() const { return graph_.Size(); }

  const Interface_Graph& graph_;
  Marks damaged_;  ///< more than a name could not be read
  Marks spoiled_;  ///< damaged, or refers to what is
  Marks shapes_;   ///< faces, shells, solids, and shapes that refer to them
};

}  // namespace crossgrain
