// SPDX-License-Identifier: Apache-2.0
#include "text/file_signature.hpp"

#include <fmt/format.h>

#include <array>

namespace crossgrain {
namespace {

using namespace std::string_view_literals;

constexpr FileSignature kVtkXml = {"<VTKFile", "a VTK XML file", ".vtu"};

constexpr std::array kSignatures = {
    FileSignature{"solid ", "an STL file", ".stl"},
    FileSignature{"ply\n", "a PLY file", ".ply"},
    FileSignature{"ply\r", "a PLY file", ".ply"},
    FileSignature{"OFF", "an OFF file", ".off"},
    FileSignature{"COFF", "an OFF file", ".off"},
    FileSignature{"NOFF", "an OFF file", ".off"},
    FileSignature{"STOFF", "an OFF file", ".off"},
    FileSignature{"ISO-10303-21", "a STEP file", ".step"},
    FileSignature{"DBRep_DrawableShape", "a BREP file", ".brep"},
    FileSignature{"MeshVersionFormatted", "a Medit mesh", ".mesh"},
    FileSignature{"\x01\0\0\0\x01\0\0\0"sv, "a Medit mesh in binary", ".meshb"},
    FileSignature{"\x01\0\0\0\x02\0\0\0"sv, "a Medit mesh in binary", ".meshb"},
    FileSignature{"\x01\0\0\0\x03\0\0\0"sv, "a Medit mesh in binary", ".meshb"},
    FileSignature{"\x01\0\0\0\x04\0\0\0"sv, "a Medit mesh in binary", ".meshb"},
    FileSignature{"$MeshFormat", "a Gmsh mesh", ".msh"},
    FileSignature{"# vtk DataFile", "a VTK file", ".vtk"},
    kVtkXml,
    FileSignature{"<?xml", "an XML file", ""},
    FileSignature{"glTF", "a glTF file", ""},
    FileSignature{"PK\x03\x04", "a ZIP archive", ""},
    FileSignature{"\x1f\x8b", "a gzip archive", ""},
    FileSignature{"\x89HDF", "an HDF5 file", ""},
};

}  // namespace

const FileSignature* signature_of(std::string_view bytes) {
  // Declarations and comments of any length may precede the first tag.
  constexpr std::size_t kLongestPrologue = 1000;
  if (bytes.starts_with("<?xml") &&
      bytes.substr(0, kLongestPrologue).find(kVtkXml.beginning) != std::string_view::npos)
    return &kVtkXml;
  for (const FileSignature& signature : kSignatures) {
    if (bytes.starts_with(signature.beginning)) return &signature;
  }
  return nullptr;
}

std::string kind_of(const FileSignature& signature) {
  if (signature.extension.empty()) return std::string(signature.kind);
  return fmt::format("{} ({})", signature.kind, signature.extension);
}

Remedy remedy_for(const FileSignature& signature) {
  return signature.extension.empty() ? Remedy::kConvertFile : Remedy::kRename;
}

void fail_if_misnamed(const InputFile& file, std::string_view extension) {
  const FileSignature* signature = signature_of(file.bytes());
  if (signature == nullptr || signature->extension == extension) return;
  fail_input(file, {}, fmt::format("is named {} but begins like {}", extension, kind_of(*signature)),
             remedy_for(*signature));
}

}  // namespace crossgrain
