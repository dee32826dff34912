// SPDX-License-Identifier: Apache-2.0
#include "files/output_folder.hpp"

#include <algorithm>

namespace crossgrain {

OutputFile& OutputFolder::create(const std::string& name) {
  files_.push_back({name, reservation_->create(name)});
  names_.push_back(name);
  OutputFile& file = *files_.back().file;
  file.set_solve(solve_);
  return file;
}

std::vector<ResultInventory::File> OutputFolder::created() const {
  std::vector<ResultInventory::File> list;
  for (const auto& [name, file] : files_) list.push_back({name, file->position(), file->crc().text()});
  return list;
}

void OutputFolder::expect(const std::string& name) {
  reservation_->check_names({name});
  names_.push_back(name);
}

OutputFolder::~OutputFolder() {
  files_.clear();
  reservation_->discard(names_);
}

void OutputFolder::commit() {
  for (const Created& created : files_) created.file->finish();
  std::erase_if(outdated_, [&](const std::string& name) {
    return std::find(names_.begin(), names_.end(), name) != names_.end();
  });
  reservation_->publish(names_, outdated_);
  names_.clear();
}

std::shared_ptr<FolderReservation> reserve_writable(const std::filesystem::path& folder,
                                                    const std::vector<std::string>& names) {
  auto reservation = std::make_shared<FolderReservation>(folder);
  reservation->check_names(names);
  return reservation;
}

}  // namespace crossgrain
