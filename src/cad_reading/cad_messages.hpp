// SPDX-License-Identifier: Apache-2.0
// Messages between the library and the program crossgrain_cad. The program contains OpenCASCADE, which
// crashes or hangs on some damaged files; in a separate process only that process is lost. It gets a request
// as its arguments and writes an answer to kAnswerDescriptor.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cad_reading/cad_reading.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// kFreeCad is a document to the library; the program gets its shapes (cad_reading/placed_breps.hpp).
enum class CadFormat { kStep, kIges, kBrep, kFreeCad };

struct CadRequest {
  std::string path;
  CadFormat format;
  CadReading options;        ///< those of CAD files; max_memory_bytes is for the program alone
  pid_t asking_process;      ///< the program ends when this process does
  bool with_solids = false;  ///< whether the answer has CadAnswer::solids
};

/// The solids of a model in OpenCASCADE's own format, for programs that mesh them. Closed shells are solids
/// too, open ones are left out. Numbers are those of the mesh of the same answer: entry k belongs to what
/// TopExp::MapShapes lists as number k + 1.
struct CadSolids {
  std::string brep;                         ///< a compound, in text of version 1, without triangles
  std::vector<std::int32_t> solid_numbers;  ///< TriangleMesh::solids
  std::vector<std::int32_t> face_numbers;   ///< TriangleMesh::faces
  std::vector<std::int32_t> edge_numbers;   ///< CreaseCurve::tag
};

enum class CadEnd : std::uint8_t {
  kMesh,         ///< the file was read
  kFault,        ///< the file cannot be read
  kOutOfMemory,  ///< CadRequest::options.max_memory_bytes does not suffice
};

/// Error in a file; members as in Message.
struct CadFault {
  std::string text;
  Remedy remedy = Remedy::kNone;
};

struct CadAnswer {
  CadEnd end = CadEnd::kMesh;
  TriangleMesh mesh;  ///< vertices shared by neighbouring triangles; all indices in range
  CadFault fault;
  CadSolids solids = {};  ///< empty unless they were asked for
};

/// Limit of an answer, besides those of its bytes and texts.
inline constexpr std::size_t kMostCadWarnings = 100;

/// Converts a request to the arguments of the program, and back; nothing if they are invalid.
std::vector<std::string> arguments_of(const CadRequest& request);
std::optional<CadRequest> cad_request_of(const std::vector<std::string>& arguments);

/// Writes the answer after the greeting. Returns false if it could not be written.
bool write_cad_answer(std::FILE* out, const CadAnswer& answer);

/// Returns the answer in the program's output; nothing if it is incomplete, inconsistent or beyond a limit,
/// as after a crash: texts are lines, numbers finite, indices in range. Takes at most four times the memory
/// of the output.
std::optional<CadAnswer> cad_answer_in(std::string_view written);

}  // namespace crossgrain
