// SPDX-License-Identifier: Apache-2.0
// The two names that crossgrain_cad.so exports.
#include "io/cad_module.hpp"

#include <fmt/format.h>

#include <Standard_Failure.hxx>
#include <algorithm>
#include <mutex>

#include "crossgrain/version.hpp"
#include "io/cad/bodies.hpp"
#include "io/cad/fault.hpp"
#include "io/cad/quiet_open_cascade.hpp"
#include "io/cad/shape_file.hpp"
#include "io/cad/tessellation.hpp"

namespace crossgrain {
namespace {

TriangleMesh read(const CadRequest& request) {
  const CadShape file = read_shape(request.path, request.format);
  const Bodies bodies = find_bodies(file.shape);
  TriangleMesh mesh = tessellate(bodies, request.options);
  mesh.unit = file.unit;
  mesh.file_unit = file.file_unit;
  mesh.warnings.insert(mesh.warnings.begin(), bodies.warnings.begin(), bodies.warnings.end());
  mesh.warnings.insert(mesh.warnings.begin(), file.warnings.begin(), file.warnings.end());
  return mesh;
}

/// Errors are one line, whatever OpenCASCADE says.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

std::string given_up(const char* reason) {
  return fmt::format("OpenCASCADE gives up on it ({}); repair it or export it again",
                     reason == nullptr || *reason == '\0' ? "for no reason given" : one_line(reason));
}

}  // namespace
}  // namespace crossgrain

extern "C" {

__attribute__((visibility("default"))) const char* crossgrain_cad_version = crossgrain::kVersion;

__attribute__((visibility("default"))) void crossgrain_read_cad(const crossgrain::CadRequest& request,
                                                                crossgrain::CadAnswer& answer) {
  // The readers keep their settings and what they have read in global variables.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const crossgrain::QuietOpenCascade quiet;
  try {
    answer.mesh = crossgrain::read(request);
  } catch (const crossgrain::Fault& fault) {
    answer.fault = crossgrain::one_line(fault.what());
  } catch (const Standard_Failure& failure) {
    answer.fault = crossgrain::given_up(failure.GetMessageString());
  } catch (const std::exception& exception) {
    answer.fault = crossgrain::given_up(exception.what());
  }
}

}  // extern "C"
