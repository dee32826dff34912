// SPDX-License-Identifier: Apache-2.0
// The program crossgrain_netgen: makes tets with Netgen for the library that runs it.
#include <unistd.h>

#include <cstdio>
#include <new>

#include "process/answer_stream.hpp"
#include "process/helper_process.hpp"
#include "process/helper_program.hpp"
#include "process/helper_side.hpp"
#include "tet_making/netgen_messages.hpp"
#include "tet_making/netgen_program/netgen_work.hpp"

namespace crossgrain {
namespace {

NetgenAnswer answer_to(const NetgenRequest& request) {
  try {
    return {NetgenEnd::kTets, {}, netgen_tets_for(request)};
  } catch (const NetgenFault& fault) {
    return {NetgenEnd::kFault, fault.text, {}};
  } catch (const std::bad_alloc&) {
    return {NetgenEnd::kOutOfMemory, {}, {}};
  } catch (...) {
    // Netgen's own exceptions are in no header of Debian's package.
    return {NetgenEnd::kFault, "Netgen gives up on it", {}};
  }
}

int run(const std::vector<std::string>& arguments) {
  std::FILE* const out = ::fdopen(kAnswerDescriptor, "wb");
  if (out == nullptr) {
    std::fputs("crossgrain_netgen is run by Crossgrain, to make tets; run 'crossgrain tets' instead\n",
               stderr);
    return kNotAsked;
  }
  write_greeting(out, kNetgenProgramName);
  const std::optional<NetgenRequest> request = netgen_request_of(arguments);
  if (!request) return kNotAsked;
  serve_only(request->asking_process, request->max_memory_bytes);
  return write_netgen_answer(out, answer_to(*request)) ? 0 : 1;
}

}  // namespace
}  // namespace crossgrain

int main(int argc, char** argv) {
  const int status = crossgrain::run({argv + 1, argv + argc});
  // The answer is complete; what Netgen does at its end is not needed.
  ::_exit(status);
}
