// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/step_contents.hpp"

#include <fmt/format.h>

#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_ReportEntity.hxx>
#include <StepAP214_AppliedExternalIdentificationAssignment.hxx>
#include <StepBasic_ConversionBasedUnitAndLengthUnit.hxx>
#include <StepBasic_SiUnitAndLengthUnit.hxx>
#include <StepData_UndefinedEntity.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_ItemDefinedTransformation.hxx>
#include <StepRepr_RepresentationContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_ShapeRepresentationRelationship.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_ContextDependentShapeRepresentation.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_FaceBasedSurfaceModel.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeDimensionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <StepShape_SolidModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "cad_reading/program/fault.hpp"
#include "cad_reading/program/unit_name.hpp"

namespace crossgrain {
namespace {

template <class Type>
bool is(const Handle(Standard_Transient) & entity) {
  return entity->IsKind(STANDARD_TYPE(Type));
}

bool begins(const Handle(Standard_Transient) & entity, std::string_view beginning) {
  return std::string_view(entity->DynamicType()->Name()).starts_with(beginning);
}

/// Returns whether a message of OpenCASCADE is about a parameter that no shape depends on: a text, or what
/// the file says of a spline besides its poles and knots.
bool is_harmless(std::string_view message) {
  constexpr std::array<std::string_view, 9> kParts = {
      "not a quoted String", "(closed_curve)", "(self_intersect)", "(u_closed)", "(v_closed)",
      "(curve_form)",        "(surface_form)", "(knot_spec)",      "(knot_type)"};
  return std::any_of(kParts.begin(), kParts.end(), [message](std::string_view part) {
    return message.find(part) != std::string_view::npos;
  });
}

/// Returns whether OpenCASCADE could not read something of an entity, by a message that is not `excused`.
template <class Excuse>
bool fails(const Handle(Interface_InterfaceModel) & model, int number, const Excuse& excused) {
  if (!model->IsErrorEntity(number)) return false;
  const Handle(Interface_Check) check = model->ReportEntity(number)->Check();
  for (int i = 1; i <= check->NbFails(); ++i) {
    if (!excused(std::string_view(check->CFail(i)))) return true;
  }
  return check->NbFails() == 0;
}

bool is_face_or_solid(const Handle(Standard_Transient) & entity) {
  return is<StepShape_Face>(entity) || is<StepShape_ConnectedFaceSet>(entity) ||
         is<StepShape_SolidModel>(entity) || is<StepShape_ShellBasedSurfaceModel>(entity) ||
         is<StepShape_FaceBasedSurfaceModel>(entity);
}

/// Returns whether an entity that refers to a face is part of the shape itself, unlike a style or a note.
/// Entities of unknown types may be.
bool is_of_shape(const Handle(Standard_Transient) & entity) {
  return begins(entity, "StepShape_") || begins(entity, "StepRepr_") || is<StepData_UndefinedEntity>(entity);
}

/// Returns whether an entity joins a shape to its product or puts it in its place.
bool is_joint(const Handle(Standard_Transient) & entity) {
  return is<StepShape_ShapeDefinitionRepresentation>(entity) ||
         is<StepShape_ContextDependentShapeRepresentation>(entity) ||
         is<StepRepr_ShapeRepresentationRelationship>(entity) ||
         is<StepRepr_ItemDefinedTransformation>(entity);
}

/// Marks everything that `step`(entity) leads to from what is marked.
template <class Step>
void spread(const Interface_Graph& graph, std::vector<bool>& marks, const Step& step) {
  std::vector<int> open;
  for (int i = 1; i <= graph.Size(); ++i) {
    if (marks[static_cast<std::size_t>(i)]) open.push_back(i);
  }
  while (!open.empty()) {
    const Handle(Standard_Transient) entity = graph.Entity(open.back());
    open.pop_back();
    for (Interface_EntityIterator next = step(entity); next.More(); next.Next()) {
      const int number = graph.EntityNumber(next.Value());
      if (number == 0 || marks[static_cast<std::size_t>(number)]) continue;
      marks[static_cast<std::size_t>(number)] = true;
      open.push_back(number);
    }
  }
}

/// Returns the name of a unit of length; empty for all else.
std::string length_unit(const Handle(Standard_Transient) & entity) {
  if (is<StepBasic_SiUnitAndLengthUnit>(entity)) {
    // In the order of StepBasic_SiPrefix.
    constexpr std::array kPrefixes = {"E", "P", "T", "G", "M", "k", "h", "da",
                                      "d", "c", "m", "u", "n", "p", "f", "a"};
    const auto si = Handle(StepBasic_SiUnitAndLengthUnit)::DownCast(entity);
    return si->HasPrefix() ? std::string(kPrefixes.at(static_cast<std::size_t>(si->Prefix()))) + "m" : "m";
  }
  if (!is<StepBasic_ConversionBasedUnitAndLengthUnit>(entity)) return "";
  const auto name = Handle(StepBasic_ConversionBasedUnitAndLengthUnit)::DownCast(entity)->Name();
  return name.IsNull() ? "" : short_unit(name->ToCString());
}

bool is_of_geometry(const Handle(Standard_Transient) & entity) {
  return begins(entity, "StepGeom_") || begins(entity, "StepShape_") || begins(entity, "StepRepr_");
}

}  // namespace

StepContents::StepContents(const Interface_Graph& graph) : graph_(graph) {
  const std::size_t size = static_cast<std::size_t>(count()) + 1;
  damaged_.resize(size);
  shapes_.resize(size);
  mark_damaged();
  mark_spoiled();
  mark_shapes();
}

void StepContents::mark_damaged() {
  for (int i = 1; i <= count(); ++i)
    damaged_[static_cast<std::size_t>(i)] = fails(graph_.Model(), i, is_harmless);
}

void StepContents::mark_spoiled() {
  spoiled_ = damaged_;
  spread(graph_, spoiled_, [&](const auto& entity) { return graph_.Sharings(entity); });
}

void StepContents::mark_shapes() {
  for (int i = 1; i <= count(); ++i)
    shapes_[static_cast<std::size_t>(i)] = is_face_or_solid(graph_.Entity(i));
  spread(graph_, shapes_, [&](const auto& entity) {
    Interface_EntityIterator shapes;
    for (Interface_EntityIterator all = graph_.Sharings(entity); all.More(); all.Next()) {
      if (is_of_shape(all.Value())) shapes.AddItem(all.Value());
    }
    return shapes;
  });
}

bool StepContents::is_shape_representation(int number) const {
  const Handle(Standard_Transient) entity = graph_.Entity(number);
  return is<StepShape_ShapeRepresentation>(entity) && !is<StepShape_ShapeDimensionRepresentation>(entity);
}

/// Returns whether items of a representation are missing that are, or may be, shapes. Items of other types,
/// such as notes, are no loss.
bool StepContents::loses_shapes(int representation) const {
  const auto excused = [](std::string_view message) {
    return is_harmless(message) || (message.find("Entity has illegal type") != std::string_view::npos &&
                                    message.find("context") == std::string_view::npos);
  };
  if (fails(graph_.Model(), representation, excused)) return true;
  const Handle(StepRepr_Representation) read =
      Handle(StepRepr_Representation)::DownCast(graph_.Entity(representation));
  for (Interface_EntityIterator named = graph_.Shareds(read); named.More(); named.Next()) {
    const int number = graph_.EntityNumber(named.Value());
    if (number == 0 || !shapes_[static_cast<std::size_t>(number)]) continue;
    bool found = false;
    for (int i = 1; i <= read->NbItems() && !found; ++i) found = read->ItemsValue(i) == named.Value();
    if (!found) return true;
  }
  return false;
}

/// Returns what faces and solids need of a representation.
Interface_EntityIterator StepContents::shapes_in(const StepShape_ShapeRepresentation& representation) const {
  Interface_EntityIterator parts;
  for (int i = 1; i <= representation.NbItems(); ++i) {
    const int number = graph_.EntityNumber(representation.ItemsValue(i));
    if (number != 0 && shapes_[static_cast<std::size_t>(number)]) parts.AddItem(graph_.Entity(number));
  }
  if (parts.NbEntities() > 0) parts.AddItem(representation.ContextOfItems());
  return parts;
}

/// Returns what faces and solids need, and what puts them in their places.
StepContents::Marks StepContents::needed() const {
  Marks marks(damaged_.size());
  for (int i = 1; i <= count(); ++i)
    marks[static_cast<std::size_t>(i)] = is_shape_representation(i) || is_joint(graph_.Entity(i));
  spread(graph_, marks, [&](const auto& entity) {
    const auto representation = Handle(StepShape_ShapeRepresentation)::DownCast(entity);
    if (!representation.IsNull()) return shapes_in(*representation);
    const bool is_product = is<StepShape_ShapeDefinitionRepresentation>(entity) ||
                            is<StepShape_ContextDependentShapeRepresentation>(entity);
    return is_product ? Interface_EntityIterator() : graph_.Shareds(entity);
  });
  return marks;
}

void StepContents::keep_sound_shapes() const {
  if (std::find(damaged_.begin(), damaged_.end(), true) == damaged_.end()) return;
  const Marks need = needed();
  for (int i = 1; i <= count(); ++i) {
    const auto place = static_cast<std::size_t>(i);
    if (!damaged_[place] || !need[place]) continue;
    const Handle(Standard_Transient) entity = graph_.Entity(i);
    const bool matters = is_shape_representation(i) ? loses_shapes(i) : is_of_geometry(entity);
    if (!matters) continue;
    const Handle(Interface_InterfaceModel) model = graph_.Model();
    throw Fault(fmt::format("entity {} is damaged", model->StringLabel(entity)->ToCString()));
  }
  for (int i = 1; i <= count(); ++i) {
    const auto all = Handle(StepRepr_Representation)::DownCast(graph_.Entity(i));
    if (!all.IsNull() && spoiled_[static_cast<std::size_t>(i)]) leave_out_spoiled(*all);
  }
}

/// Leaves in a representation the items that could be read, and all shapes.
void StepContents::leave_out_spoiled(StepRepr_Representation& representation) const {
  std::vector<Handle(StepRepr_RepresentationItem)> kept;
  for (int i = 1; i <= representation.NbItems(); ++i) {
    const auto place = static_cast<std::size_t>(graph_.EntityNumber(representation.ItemsValue(i)));
    if (place != 0 && (shapes_[place] || !spoiled_[place])) kept.push_back(representation.ItemsValue(i));
  }
  Handle(StepRepr_HArray1OfRepresentationItem) items;
  if (!kept.empty()) items = new StepRepr_HArray1OfRepresentationItem(1, static_cast<int>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) items->SetValue(static_cast<int>(i) + 1, kept[i]);
  representation.SetItems(items);
}

bool StepContents::holds_faces(const Handle(Standard_Transient) & root) const {
  // From a product over its definition, or its use in an assembly, to the relation to its shape.
  constexpr int kSteps = 3;
  std::vector<Handle(Standard_Transient)> here{root};
  for (int step = 0; step <= kSteps; ++step) {
    std::vector<Handle(Standard_Transient)> next;
    for (const Handle(Standard_Transient) & entity : here) {
      if (shapes_[static_cast<std::size_t>(graph_.EntityNumber(entity))]) return true;
      for (Interface_EntityIterator all = graph_.Sharings(entity); all.More(); all.Next())
        next.push_back(all.Value());
    }
    here = std::move(next);
  }
  return false;
}

std::vector<std::string> StepContents::length_units() const {
  std::vector<std::string> units;
  for (int i = 1; i <= count(); ++i) {
    if (!is_shape_representation(i) || !shapes_[static_cast<std::size_t>(i)]) continue;
    const auto read = Handle(StepRepr_Representation)::DownCast(graph_.Entity(i));
    if (graph_.EntityNumber(read->ContextOfItems()) == 0) continue;
    for (Interface_EntityIterator all = graph_.Shareds(read->ContextOfItems()); all.More(); all.Next()) {
      const std::string unit = length_unit(all.Value());
      if (!unit.empty() && std::ranges::find(units, unit) == units.end()) units.push_back(unit);
    }
  }
  return units;
}

std::vector<std::string> StepContents::other_files() const {
  std::vector<std::string> names;
  const auto add = [&names](const Handle(TCollection_HAsciiString) & name) {
    if (!name.IsNull() && !name->IsEmpty()) names.emplace_back(name->ToCString());
  };
  for (int i = 1; i <= count(); ++i) {
    const Handle(Standard_Transient) entity = graph_.Entity(i);
    if (is<StepAP214_AppliedExternalIdentificationAssignment>(entity))
      add(Handle(StepAP214_AppliedExternalIdentificationAssignment)::DownCast(entity)->AssignedId());
  }
  return names;
}

}  // namespace crossgrain
