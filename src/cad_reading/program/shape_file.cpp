// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/program/shape_file.hpp"

#include <fmt/format.h>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <array>
#include <fstream>
#include <gp_Quaternion.hxx>
#include <gp_Trsf.hxx>
#include <iterator>
#include <sstream>
#include <string_view>

#include "cad_reading/placed_breps.hpp"
#include "cad_reading/program/fault.hpp"
#include "cad_reading/program/step_contents.hpp"
#include "cad_reading/program/unit_name.hpp"

namespace crossgrain {
namespace {

/// Unit to which OpenCASCADE converts, also its default.
constexpr const char* kUnit = "mm";

void ask_for_millimetres() {
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
}

/// Throws Fault if part of the geometry of an IGES file did not load: OpenCASCADE would go on with null
/// pointers and crash.
void refuse_damaged_geometry(const Handle(Interface_InterfaceModel) & model) {
  constexpr std::array<std::string_view, 2> kGeometry = {"IGESGeom_", "IGESSolid_"};
  for (int i = 1; i <= model->NbEntities(); ++i) {
    if (!model->IsErrorEntity(i)) continue;
    const Handle(Standard_Transient) entity = model->Value(i);
    const std::string_view type = entity->DynamicType()->Name();
    const auto begins = [type](std::string_view beginning) { return type.starts_with(beginning); };
    if (std::none_of(kGeometry.begin(), kGeometry.end(), begins)) continue;
    throw Fault(fmt::format("entity {} is damaged", model->StringLabel(entity)->ToCString()));
  }
}

void warn_without_unit(CadShape& result) {
  if (result.file_unit.empty())
    result.warnings.emplace_back(WarningKind::kUnknownUnit,
                                 "the file does not give a unit of length; millimetres are assumed");
}

/// Reads all parts, and warns of those with faces that could not be read.
void transfer_parts(STEPControl_Reader& reader, const StepContents& contents,
                    std::vector<Warning>& warnings) {
  const int roots = reader.NbRootsForTransfer();
  int parts = 0, missing = 0;
  for (int i = 1; i <= roots; ++i) {
    const bool has_faces = contents.holds_faces(reader.RootForTransfer(i));
    const bool read = reader.TransferRoot(i);
    parts += has_faces || read;
    missing += has_faces && !read;
  }
  if (missing > 0)
    warnings.emplace_back(
        WarningKind::kMissingParts,
        fmt::format("parts that OpenCASCADE could not read, so they are missing: {} of {}", missing, parts));
}

/// Throws Fault if the parts of an assembly are in other files.
void refuse_without_faces(const CadShape& result, const StepContents& contents) {
  if (!result.shape.IsNull() && TopExp_Explorer(result.shape, TopAbs_FACE).More()) return;
  const std::vector<std::string> files = contents.other_files();
  if (files.empty()) return;
  throw Fault(fmt::format("has no faces: its parts are in other files, {}{}", files.front(),
                          files.size() > 1 ? fmt::format(" and {} more", files.size() - 1) : ""),
              Remedy::kGivePartFiles);
}

CadShape read_step_shape(const std::string& path) {
  STEPControl_Reader reader;
  ask_for_millimetres();
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw Fault("is damaged, or not a STEP file that OpenCASCADE can read", Remedy::kExportAgain);
  const StepContents contents(reader.WS()->Graph());
  contents.keep_sound_shapes();
  CadShape result;
  result.unit = kUnit;
  result.file_unit = fmt::format("{}", fmt::join(contents.length_units(), ", "));
  warn_without_unit(result);
  transfer_parts(reader, contents, result.warnings);
  result.shape = reader.OneShape();
  refuse_without_faces(result, contents);
  return result;
}

/// Returns the unit by the flag of the global section (IGES 5.3, section 2.2.4.3.14); the unit's name is
/// optional.
std::string iges_unit(const IGESData_GlobalSection& section) {
  constexpr std::array kNames = {"",  "inch", "mm",  "",   "foot", "mile",
                                 "m", "km",   "mil", "um", "cm",   "microinch"};
  constexpr int kByName = 3;
  const int flag = section.UnitFlag();
  if (flag == kByName && !section.UnitName().IsNull()) return short_unit(section.UnitName()->ToCString());
  return flag > 0 && flag < static_cast<int>(kNames.size()) ? kNames[static_cast<std::size_t>(flag)] : "";
}

CadShape read_iges_shape(const std::string& path) {
  IGESControl_Reader reader;
  ask_for_millimetres();
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw Fault("is damaged, or not an IGES file that OpenCASCADE can read", Remedy::kExportAgain);
  refuse_damaged_geometry(reader.Model());
  CadShape result;
  result.unit = kUnit;
  result.file_unit = iges_unit(reader.IGESModel()->GlobalSection());
  warn_without_unit(result);
  reader.TransferRoots();
  result.shape = reader.OneShape();
  return result;
}

/// Returns whether a stream begins like a binary BREP file, and goes back to its beginning.
bool is_binary_brep(std::istream& stream) {
  std::array<char, 40> head{};
  stream.read(head.data(), head.size());
  stream.clear();
  stream.seekg(0);
  return std::string_view(head.data(), head.size()).find("Open CASCADE") != std::string_view::npos;
}

CadShape read_brep_shape(const std::string& path) {
  CadShape result;
  std::ifstream file(path, std::ios::binary);
  const bool done = is_binary_brep(file) ? BinTools::Read(result.shape, path.c_str())
                                         : BRepTools::Read(result.shape, path.c_str(), BRep_Builder());
  if (!done) throw Fault("is damaged, or not a BREP file that OpenCASCADE can read", Remedy::kExportAgain);
  return result;
}

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// FreeCAD's own unit is the millimetre. Shapes without faces, such as sketches, are left out.
CadShape read_placed_shapes(const std::string& path) {
  const auto shapes = placed_breps_in(content_of(path));
  if (!shapes) throw Fault("its shapes could not be handed on", Remedy::kReinstall);
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const auto& [turn, move, brep] : *shapes) {
    TopoDS_Shape shape;
    std::istringstream stream(brep);
    if (is_binary_brep(stream))
      BinTools::Read(shape, stream);
    else
      BRepTools::Read(shape, stream, BRep_Builder());
    if (shape.IsNull()) throw Fault("has a shape that OpenCASCADE cannot read", Remedy::kExportAgain);
    if (!TopExp_Explorer(shape, TopAbs_FACE).More()) continue;
    gp_Trsf place;
    place.SetRotation(gp_Quaternion(turn[1], turn[2], turn[3], turn[0]));
    place.SetTranslationPart(gp_Vec(move[0], move[1], move[2]));
    builder.Add(compound, shape.Moved(TopLoc_Location(place)));
  }
  CadShape result;
  result.shape = compound;
  result.unit = result.file_unit = kUnit;
  return result;
}

}  // namespace

CadShape read_shape(const std::string& path, CadFormat format) {
  CadShape result = format == CadFormat::kStep   ? read_step_shape(path)
                    : format == CadFormat::kIges ? read_iges_shape(path)
                    : format == CadFormat::kBrep ? read_brep_shape(path)
                                                 : read_placed_shapes(path);
  if (result.shape.IsNull()) throw Fault("has no shapes that could be read", Remedy::kExportAgain);
  return result;
}

}  // namespace crossgrain
