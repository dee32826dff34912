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
    FileSignature{"\x1f\x8b", "a gzip archive", ".gz"},
    FileSignature{"\x89HDF", "an HDF5 file", ""},
};

constexpr std::string_view kZip = "PK\x03\x04";
constexpr FileSignature kFreeCad = {kZip, "a document of FreeCAD", ".FCStd"};
constexpr FileSignature k3mf = {kZip, "a 3MF file", ".3mf"};
constexpr FileSignature kArchive = {kZip, "a ZIP archive", ""};

/// By the names of members, which stand in the directory at the end.
const FileSignature* zip_signature_of(std::string_view bytes) {
  const auto names = [bytes](std::string_view name) { return bytes.rfind(name) != std::string_view::npos; };
  return names(".model") ? &k3mf : names("Document.xml") ? &kFreeCad : &kArchive;
}

}  // namespace

const FileSignature* signature_of(std::string_view bytes) {
  // Declarations and comments of any length may precede the first tag.
  constexpr std::size_t kLongestPrologue = 1000;
  if (bytes.starts_with("<?xml") &&
      bytes.substr(0, kLongestPrologue).find(kVtkXml.beginning) != std::string_view::npos)
    return &kVtkXml;
  if (bytes.starts_with(kZip)) return zip_signature_of(bytes);
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
