// SPDX-License-Identifier: Apache-2.0
// What the library and the module crossgrain_cad.so say to each other. The module has OpenCASCADE in it, some
// 40 shared libraries, and is loaded when a CAD file is opened: other runs pay neither its start-up nor its
// memory.
#pragma once

#include <string>

#include "crossgrain/io.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

enum class CadFormat { kStep, kIges, kBrep };

struct CadRequest {
  std::string path;
  CadFormat format;
  ReadOptions options;
};

struct CadAnswer {
  TriangleMesh mesh;  ///< vertices shared by neighbouring triangles
  std::string fault;  ///< what is wrong with the file, and the mend; empty where nothing is
};

/// Throws nothing. Safe to call from any thread.
using CadReadFunction = void(const CadRequest& request, CadAnswer& answer);

/// The names under which the module exports a CadReadFunction, and kVersion as a `const char*`: both sides
/// must be of the same build.
inline constexpr const char* kCadReadName = "crossgrain_read_cad";
inline constexpr const char* kCadVersionName = "crossgrain_cad_version";

}  // namespace crossgrain
