// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "base/parallel.hpp"
#include "crossgrain/io.hpp"
#include "io/output_file.hpp"

namespace crossgrain {
namespace {

/// Points sampled between two writes: enough to keep many threads busy, and little memory.
constexpr std::size_t kPointsAtOnce = 1 << 16;

void append_numbers(std::string& text, std::span<const double> numbers) {
  // 17 significant digits read back as the same bits.
  for (const double number : numbers) fmt::format_to(std::back_inserter(text), "{:.17g} ", number);
}

std::string line_of(const Frame& frame) {
  std::string line;
  for (const Vector3& axis : frame.axes) append_numbers(line, axis);
  line.back() = '\n';
  return line;
}

std::string line_of(const Vector3& point) {
  std::string line;
  append_numbers(line, point);
  line.back() = '\n';
  return line;
}

/// A file, or standard output for "-".
class Sink {
 public:
  explicit Sink(const std::filesystem::path& path) {
    if (path == "-")
      file_.reset(new OutputFile(OutputFile::standard_output()));
    else
      file_ = std::make_unique<OutputFile>(path);
  }
  OutputFile* operator->() { return file_.get(); }

 private:
  std::unique_ptr<OutputFile> file_;
};

}  // namespace

std::size_t write_samples(const FrameField& field, std::span<const Vector3> points, const SampleFiles& files,
                          const Monitor& monitor) {
  Sink frames(files.frames);
  std::optional<Sink> outside;
  if (!files.outside.empty()) outside.emplace(files.outside);

  // The first sample prepares the field for all others, in a parallel loop of its own: not to be met within
  // ours.
  if (!points.empty()) field.sample(points.front());

  std::size_t outside_count = 0;
  std::vector<FrameField::Sample> samples;
  for (std::size_t begin = 0; begin < points.size(); begin += kPointsAtOnce) {
    monitor.check();
    const auto batch = points.subspan(begin, std::min(kPointsAtOnce, points.size() - begin));
    samples.resize(batch.size());
    parallel_for(batch.size(), [&](std::size_t i) { samples[i] = field.sample(batch[i]); });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      frames->write(line_of(samples[i].frame));
      if (samples[i].in_active_cell) continue;
      ++outside_count;
      if (outside) (*outside)->write(line_of(batch[i]));
    }
  }
  frames->finish();
  if (outside) (*outside)->finish();
  frames->commit();
  if (outside) (*outside)->commit();
  return outside_count;
}

}  // namespace crossgrain
