// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "crossgrain/report.hpp"
#include "files/folder_reservation.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// A folder that receives several files, all or none. Without `commit`, it stays as it was.
class OutputFolder {
 public:
  explicit OutputFolder(const std::filesystem::path& folder)
      : OutputFolder(std::make_shared<FolderReservation>(folder)) {}

  explicit OutputFolder(std::shared_ptr<FolderReservation> reservation)
      : reservation_(std::move(reservation)) {}

  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The folder as it was given, and the place where its new files are until `commit`.
  const std::string& name() const { return reservation_->name(); }
  std::filesystem::path place() { return reservation_->staging_place(); }

  /// Creates a file in the folder. The folder owns it.
  OutputFile& create(const std::string& name);

  /// Returns the files that have been created, in this order, as they are now.
  std::vector<ResultInventory::File> created() const;

  /// Makes a file that another process writes to `place` a file of the folder. Throws Error(kOutput) if it
  /// cannot have this name.
  void expect(const std::string& name);

  /// Sets OutputFile::solve of the files created from now on.
  void set_solve(std::string solve) { solve_ = std::move(solve); }
  const std::string& solve() const { return solve_; }

  /// Removes an earlier file or link of this name at `commit`. Anything else of this name stays.
  void remove_at_commit(const std::string& name) { outdated_.push_back(name); }

  /// Finishes all files; only then replaces the earlier ones (FolderReservation::publish).
  void commit();

 private:
  std::shared_ptr<FolderReservation> reservation_;
  struct Created {
    std::string name;
    std::unique_ptr<OutputFile> file;
  };
  std::vector<Created> files_;
  std::vector<std::string> names_, outdated_;
  std::string solve_;
};

/// Reserves a folder in which such files could be written. Throws Error(kOutput) if they could not. Call
/// before a long computation to fail early.
std::shared_ptr<FolderReservation> reserve_writable(const std::filesystem::path& folder,
                                                    const std::vector<std::string>& names);

}  // namespace crossgrain
