// SPDX-License-Identifier: Apache-2.0
#include "job.hpp"

#include "messages.hpp"
#include "output_places.hpp"

namespace crossgrain::app {

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void announce_stop(const std::string& what_is_written) {
  print_message("interrupted: writing " + what_is_written + "; press Ctrl-C again to discard it");
}

void announce_replaced(const Job& job) {
  const auto replaced = replaced_model(job.arguments);
  if (!replaced || job.arguments.quiet) return;
  job.leave_line();
  print_message(job.arguments.output + ": the field of " + *replaced + " will be replaced");
}

OutputOptions output_options_for(const Job& job, const std::shared_ptr<FolderReservation>& reservation) {
  OutputOptions options = job.arguments.output_options;
  options.reservation = reservation;
  if (options.foreign_files == ForeignFiles::kRefuse) options.foreign_files = ForeignFiles::kKeep;
  return options;
}

}  // namespace crossgrain::app
