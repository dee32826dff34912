// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

struct Wording {
  Remedy remedy;
  const char* name;
  const char* words;
};

constexpr Wording kWordings[] = {
    {Remedy::kNone, "none", ""},
    {Remedy::kCheckPath, "check_path", "check the path"},
    {Remedy::kCheckDisk, "check_disk", "check the path and the disk"},
    {Remedy::kAllowReading, "allow_reading", "make it readable (chmod +r)"},
    {Remedy::kGiveFile, "give_file", "give a regular file"},
    {Remedy::kCopyAgain, "copy_again", "copy or export it again"},
    {Remedy::kRepairFile, "repair_file", "repair it or export it again"},
    {Remedy::kExportAgain, "export_again", "export it again"},
    {Remedy::kGivePartFiles, "give_part_files", "give one of these, or export all as one file"},
    {Remedy::kCorrectLine, "correct_line", "correct that line"},
    {Remedy::kRename, "rename", "rename it to match what it holds"},
    {Remedy::kConvertFile, "convert_file", "export it in a format that can be read"},
    {Remedy::kTriangulate, "triangulate", "triangulate the surface where it was made"},
    {Remedy::kCutIntoTets, "cut_into_tets", "cut the solid into tets and export it again"},
    {Remedy::kSimplify, "simplify", "simplify it"},
    {Remedy::kSimplifyOrAllowMemory, "simplify_or_allow_memory", "simplify it, or allow more memory"},
    {Remedy::kAllowMemory, "allow_memory", "allow more memory"},
    {Remedy::kFreeMemory, "free_memory", "close other programs, or simplify it"},
    {Remedy::kAllowReadTime, "allow_read_time", "repair it and export it again, or allow more time"},
    {Remedy::kReadUnglued, "read_unglued", "repair them, or read them without gluing"},
    {Remedy::kInstallCadReader, "install_cad_reader",
     "install the package crossgrain-cad, or build Crossgrain again with libocct-data-exchange-dev and "
     "libocct-modeling-algorithms-dev, or export the model as STL"},
    {Remedy::kInstallOpenCascade, "install_opencascade",
     "install libocct-data-exchange-7.6, or build Crossgrain again where another version of OpenCASCADE is "
     "installed"},
    {Remedy::kReinstall, "reinstall", "install Crossgrain again as a whole"},
    {Remedy::kSolveAgain, "solve_again", "solve again"},
    {Remedy::kCopyOrSolveAgain, "copy_or_solve_again", "copy it again, or solve again"},
    {Remedy::kGiveFieldFolder, "give_field_folder", "give a folder that a field was written to"},
    {Remedy::kGiveModel, "give_model", "give the mesh or surface itself"},
    {Remedy::kTraceStreamlines, "trace_streamlines", "trace streamlines and write them to it"},
    {Remedy::kMakeHexahedra, "make_hexahedra", "make hexahedra of its model and write them to it"},
    {Remedy::kFitHexahedra, "fit_hexahedra", "put them onto a model as they are"},
    {Remedy::kContinueSolve, "continue_solve", "a solve that starts from this field goes on from here"},
    {Remedy::kSolveAnew, "solve_anew", "solve anew, without it"},
    {Remedy::kGiveCheckpoint, "give_checkpoint", "give the folder of a checkpoint"},
    {Remedy::kGiveSameModel, "give_same_model", "give the same model and options"},
    {Remedy::kUseWrittenMesh, "use_written_mesh", "take the mesh from onto.vtu"},
    {Remedy::kCloseSurface, "close_surface", "close it, or give it thickness"},
    {Remedy::kRescale, "rescale", "rescale it"},
    {Remedy::kMoveToOrigin, "move_to_origin", "move it to the origin"},
    {Remedy::kMatchUnits, "match_units", "give both in the same unit and place"},
    {Remedy::kRemoveElement, "remove_element", "remove it, or export the mesh again"},
    {Remedy::kRemoveOverlaps, "remove_overlaps", "remove the tets that overlap others"},
    {Remedy::kMergeVertices, "merge_vertices", "merge equal vertices to join the parts"},
    {Remedy::kGlueSolids, "glue_solids", "glue the solids, in the mesher if it is a mesh"},
    {Remedy::kSeparateSolids, "separate_solids", "cut one from the other, or glue them"},
    {Remedy::kSplitTets, "split_tets", "split the tets around it"},
    {Remedy::kKeepTags, "keep_tags", "keep all tags to follow them"},
    {Remedy::kGiveSolvedSurface, "give_solved_surface", "give the one that the field was solved for"},
    {Remedy::kCloseHoles, "close_holes", "close these holes first"},
    {Remedy::kUniteParts, "unite_parts", "unite its parts, so that no triangle crosses another"},
    {Remedy::kInstallTetMaker, "install_tet_maker", "install gmsh, or the package crossgrain-netgen"},
    {Remedy::kAllowTetTime, "allow_tet_time", "take larger tets, or allow more time"},
    {Remedy::kChangeTetSize, "change_tet_size", "take tets of another size"},
    {Remedy::kTakeLargerTets, "take_larger_tets", "take larger tets"},
    {Remedy::kGiveTetSize, "give_tet_size", "give another size of tets"},
    {Remedy::kFreeTemporarySpace, "free_temporary_space",
     "free some space there, or name another folder in TMPDIR"},
    {Remedy::kGiveHexSize, "give_hex_size", "give another size of hexahedra"},
    {Remedy::kUseHexSize, "use_hex_size", "use hexahedra of another size"},
    {Remedy::kTakeLargerHexahedra, "take_larger_hexahedra", "take larger hexahedra"},
    {Remedy::kTakeFewerHexahedra, "take_fewer_hexahedra", "take larger hexahedra, or allow more memory"},
    {Remedy::kRaiseResolution, "raise_resolution", "raise the resolution, or take smaller cells"},
    {Remedy::kLowerResolution, "lower_resolution", "lower the resolution, or take larger cells"},
    {Remedy::kUseLessMemory, "use_less_memory",
     "lower the resolution, take larger cells or allow more memory"},
    {Remedy::kUseCreaseAngle, "use_crease_angle", "follow such edges by a smaller crease angle"},
    {Remedy::kGiveCellSize, "give_cell_size", "give another size of cells"},
    {Remedy::kTurnView, "turn_view", "choose another view or cut"},
    {Remedy::kRoundEdge, "round_edge", "give the edge a fillet or a chamfer"},
    {Remedy::kCutCorner, "cut_corner", "cut the corner off, or end the face that runs out in it"},
    {Remedy::kChangeAngles, "change_angles", "use smaller cells there, or change the angles"},
    {Remedy::kCutTip, "cut_tip", "use smaller cells, or cut a tip off"},
    {Remedy::kTryOtherCells, "try_other_cells", "try other cells, or split the part where the line turns"},
    {Remedy::kUseResolution, "use_resolution", "use another resolution"},
    {Remedy::kUseEdgeLength, "use_edge_length", "mesh it with other edges"},
    {Remedy::kLetFinish, "let_finish", "let it finish"},
    {Remedy::kMeshAgain, "mesh_again", "mesh the part again"},
    {Remedy::kNameOutput, "name_output", "name one"},
    {Remedy::kChooseWritablePlace, "choose_writable_place", "choose a place you may write to"},
    {Remedy::kFreeSpace, "free_space", "free some space, or choose another disk"},
    {Remedy::kMoveCheckpoint, "move_checkpoint", "free some space, or keep checkpoints elsewhere"},
    {Remedy::kMakeFolder, "make_folder", "make that folder, or choose another"},
    {Remedy::kCheckOutputDisk, "check_output_disk", "check the disk, or choose another place"},
    {Remedy::kClearPlace, "clear_place", "remove it, or choose another place"},
    {Remedy::kChooseFolder, "choose_folder", "choose another folder, or allow writing beside and over them"},
    {Remedy::kAwaitSolve, "await_solve", "wait for its end"},
    {Remedy::kReportModel, "report_model", "please report the model that brought it about"},
};

constexpr bool has_all_in_order() {
  for (std::size_t k = 0; k < std::size(kWordings); ++k)
    if (kWordings[k].remedy != static_cast<Remedy>(k)) return false;
  return kWordings[std::size(kWordings) - 1].remedy == Remedy::kReportModel;
}
static_assert(has_all_in_order());

/// Null for numbers that are no Remedy.
const Wording* wording_of(Remedy remedy) {
  const auto index = static_cast<std::size_t>(remedy);
  return index < std::size(kWordings) ? &kWordings[index] : nullptr;
}

}  // namespace

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many.empty() ? one + "s" : many);
}

const char* words_of(Remedy remedy) {
  const Wording* const wording = wording_of(remedy);
  return wording == nullptr ? "" : wording->words;
}

std::string words_of(Remedy remedy, double number) {
  if (remedy == Remedy::kUseResolution) return fmt::format("use a resolution of {:.0f}", number);
  if (remedy == Remedy::kUseEdgeLength) return fmt::format("take tets with edges of {:.3g}", number);
  if (remedy == Remedy::kUseHexSize) return fmt::format("use hexahedra of {:.3g}", number);
  if (remedy == Remedy::kGiveHexSize) return fmt::format("try hexahedra of {:.3g}", number);
  if (remedy == Remedy::kGiveTetSize) return fmt::format("try tets of {:.3g}", number);
  if (remedy == Remedy::kGiveCellSize) return fmt::format("try cells of {:.3g}", number);
  if (remedy == Remedy::kUseCreaseAngle) return fmt::format("use a crease angle of {:.0f} degrees", number);
  return words_of(remedy);
}

const char* name_of(Remedy remedy) {
  const Wording* const wording = wording_of(remedy);
  return wording == nullptr ? "" : wording->name;
}

std::string sentence_of(const Message& message) {
  return sentence_of(message, words_of(message.remedy, message.remedy_number));
}

std::string sentence_of(const Message& message, const std::string& remedy_words) {
  std::string sentence;
  for (const std::string* part : {&message.file, &message.place})
    if (!part->empty()) sentence += *part + ": ";
  sentence += message.text;
  if (!remedy_words.empty()) sentence += "; " + remedy_words;
  return sentence;
}

Error Error::with_file(std::string file) const {
  Message message = message_;
  message.file = std::move(file);
  return {kind_, std::move(message)};
}

}  // namespace crossgrain
