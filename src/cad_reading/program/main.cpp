// SPDX-License-Identifier: Apache-2.0
// The program crossgrain_cad, which the library runs to read a CAD file: cad_reading/cad_messages.hpp.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "cad_reading/cad_messages.hpp"
#include "cad_reading/program/bodies.hpp"
#include "cad_reading/program/confinement.hpp"
#include "cad_reading/program/exact_box.hpp"
#include "cad_reading/program/exact_faces.hpp"
#include "cad_reading/program/fault.hpp"
#include "cad_reading/program/shape_file.hpp"
#include "cad_reading/program/solid_text.hpp"
#include "cad_reading/program/tessellation.hpp"
#include "process/answer_stream.hpp"
#include "process/helper_process.hpp"
#include "process/helper_program.hpp"
#include "process/helper_side.hpp"

namespace crossgrain {
namespace {

CadAnswer read(const CadRequest& request) {
  const CadShape file = read_shape(request.path, request.format);
  const Bodies bodies = find_bodies(file.shape, request.options);
  CadAnswer answer;
  TriangleMesh& mesh = answer.mesh;
  mesh = tessellate(bodies, request.options);
  const ExactFaces exact = exact_faces(bodies);
  mesh.face_list = exact.faces;
  mesh.exact_size = exact.size;
  mesh.exact_box = exact_box(bodies);
  mesh.unit = file.unit;
  mesh.file_unit = one_line(file.file_unit);
  mesh.warnings.insert(mesh.warnings.begin(), bodies.warnings.begin(), bodies.warnings.end());
  mesh.warnings.insert(mesh.warnings.begin(), file.warnings.begin(), file.warnings.end());
  for (Warning& warning : mesh.warnings) warning.text = one_line(warning.text);
  if (request.with_solids) answer.solids = solids_of(bodies);
  return answer;
}

CadAnswer given_up(const char* reason) {
  return {CadEnd::kFault,
          {},
          {one_line(fmt::format("OpenCASCADE gives up on it ({})",
                                reason == nullptr || *reason == '\0' ? "for no reason given" : reason)),
           Remedy::kRepairFile}};
}

CadAnswer answer_to(const CadRequest& request) {
  try {
    return read(request);
  } catch (const Fault& fault) {
    return {CadEnd::kFault, {}, {one_line(fault.what()), fault.remedy()}};
  } catch (const Standard_OutOfMemory&) {
    return {CadEnd::kOutOfMemory, {}, {}};
  } catch (const Standard_Failure& failure) {
    return given_up(failure.GetMessageString());
  } catch (const std::exception& exception) {
    return given_up(exception.what());
  }
}

/// Set before anything can fail; its buffer exists from the greeting on.
std::FILE* answer_file = nullptr;

/// OpenCASCADE lets few exceptions through; its behaviour without memory is unpredictable.
void end_without_memory() {
  write_cad_answer(answer_file, {CadEnd::kOutOfMemory, {}, {}});
  ::_exit(0);
}

void end_with_uncaught_exception() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const Standard_OutOfMemory&) {
    end_without_memory();
  } catch (...) {
  }
  std::abort();
}

int run(const std::vector<std::string>& arguments) {
  answer_file = ::fdopen(kAnswerDescriptor, "wb");
  if (answer_file == nullptr) {
    std::fputs("crossgrain_cad is run by Crossgrain, to read a CAD file; run crossgrain instead\n", stderr);
    return kNotAsked;
  }
  write_greeting(answer_file, kCadProgramName);
  const std::optional<CadRequest> request = cad_request_of(arguments);
  if (!request) return kNotAsked;
  serve_only(request->asking_process, request->options.max_memory_bytes);
  confine_to_reading(request->path);
  std::set_new_handler(end_without_memory);
  std::set_terminate(end_with_uncaught_exception);
  return write_cad_answer(answer_file, answer_to(*request)) ? 0 : 1;
}

}  // namespace
}  // namespace crossgrain

int main(int argc, char** argv) {
  const int status = crossgrain::run({argv + 1, argv + argc});
  // The answer is complete. Destroying OpenCASCADE takes time and sometimes crashes.
  ::_exit(status);
}
