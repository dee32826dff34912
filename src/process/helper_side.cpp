// SPDX-License-Identifier: Apache-2.0
#include "process/helper_side.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace crossgrain {

void serve_only(pid_t asking_process, [[maybe_unused]] std::size_t max_memory_bytes) {
#ifndef __SANITIZE_ADDRESS__  // which reserves terabytes
  const rlimit memory{max_memory_bytes, max_memory_bytes};
  ::setrlimit(RLIMIT_DATA, &memory);
#endif
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // The parent may have ended before.
  if (::getppid() != asking_process) ::_exit(kNotAsked);
}

}  // namespace crossgrain
