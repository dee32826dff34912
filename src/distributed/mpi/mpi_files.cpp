// SPDX-License-Identifier: Apache-2.0
#include "distributed/mpi/mpi_files.hpp"

#include <algorithm>

namespace crossgrain {

bool MpiFiles::write(const std::string& path, std::span<const Part> parts) {
  constexpr std::size_t kLongestPart = std::size_t{1} << 30;  // MPI counts in int
  MPI_File file;
  // Errors of files are returned by default, unlike those of messages.
  int is_open =
      MPI_File_open(communicator_, path.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &file) == MPI_SUCCESS;
  // Closing is for all or for none.
  MPI_Allreduce(MPI_IN_PLACE, &is_open, 1, MPI_INT, MPI_MIN, communicator_);
  if (!is_open) return false;
  bool is_written = true;
  for (const auto& [offset, bytes] : parts) {
    for (std::size_t done = 0; done < bytes.size() && is_written; done += kLongestPart) {
      const auto count = static_cast<int>(std::min(kLongestPart, bytes.size() - done));
      MPI_Status status;
      int written = 0;
      is_written = MPI_File_write_at(file, static_cast<MPI_Offset>(offset + done), bytes.data() + done, count,
                                     MPI_BYTE, &status) == MPI_SUCCESS &&
                   MPI_Get_count(&status, MPI_BYTE, &written) == MPI_SUCCESS && written == count;
    }
  }
  const bool is_on_disk = MPI_File_sync(file) == MPI_SUCCESS;
  return MPI_File_close(&file) == MPI_SUCCESS && is_on_disk && is_written;
}

}  // namespace crossgrain
