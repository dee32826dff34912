// SPDX-License-Identifier: Apache-2.0
// What the library and the program crossgrain_cad say to each other. That program has OpenCASCADE in it,
// which crashes on some damaged files and is never done with others: in a process of its own that ends no
// more than that process. It gets a request as its arguments and writes an answer to kAnswerDescriptor.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/io.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

enum class CadFormat { kStep, kIges, kBrep };

struct CadRequest {
  std::string path;
  CadFormat format;
  ReadOptions options;   ///< those of CAD files; max_memory_bytes is for the program alone
  pid_t asking_process;  ///< the answer is of no use without it
};

enum class CadEnd : std::uint8_t {
  kMesh,         ///< the file is read
  kFault,        ///< it cannot be
  kOutOfMemory,  ///< not within CadRequest::options.max_memory_bytes
};

/// What is wrong with a file, as in Message.
struct CadFault {
  std::string text;
  Remedy remedy = Remedy::kNone;
};

struct CadAnswer {
  CadEnd end = CadEnd::kMesh;
  TriangleMesh mesh;  ///< vertices shared by neighbouring triangles; all indices in range
  CadFault fault;
};

/// The request as the arguments of the program, and back; nothing where they are none.
std::vector<std::string> arguments_of(const CadRequest& request);
std::optional<CadRequest> cad_request_of(const std::vector<std::string>& arguments);

/// Begins an answer. Names this version, for library and program must be of the same build.
void write_cad_greeting(std::FILE* out);

/// What follows the greeting. False where it could not be written.
bool write_cad_answer(std::FILE* out, const CadAnswer& answer);

/// Whether all that the program wrote begins as an answer of this version does.
bool is_cad_greeting(std::string_view written);

/// The answer in all that the program wrote; nothing where it is incomplete or contradicts itself, as after a
/// crash. Allocates no more than is there.
std::optional<CadAnswer> cad_answer_in(std::string_view written);

}  // namespace crossgrain
