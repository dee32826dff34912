// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mpi.h>

#include "distributed/checkpoint_files.hpp"

namespace crossgrain {

/// Writes through MPI-IO, which knows parallel file systems.
class MpiFiles : public SharedFiles {
 public:
  explicit MpiFiles(MPI_Comm communicator) : communicator_(communicator) {}
  bool write(const std::string& path, std::span<const Part> parts) override;

 private:
  MPI_Comm communicator_;
};

}  // namespace crossgrain
