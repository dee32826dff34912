// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/samples.hpp"
#include "files/file_mark.hpp"
#include "files/output_file.hpp"
#include "files/output_name.hpp"
#include "results/frame_files.hpp"

namespace crossgrain {
namespace {

/// Points sampled between two writes: enough to keep many threads busy with little memory.
constexpr std::size_t kPointsAtOnce = 1 << 16;

std::string line_of(const Vector3& point) {
  // 17 significant digits restore the same bits.
  return fmt::format("{:.17g} {:.17g} {:.17g}\n", point[0], point[1], point[2]);
}

/// Names of text with numbers between blanks, besides those without an extension.
constexpr std::array<std::string_view, 2> kTextExtensions{".txt", ".dat"};

/// Opens a file, or standard output for "-".
class Sink {
 public:
  explicit Sink(const std::filesystem::path& path) {
    if (path == "-")
      file_.reset(new OutputFile(OutputFile::standard_output()));
    else
      file_ = std::make_unique<OutputFile>(path);
  }
  OutputFile* operator->() { return file_.get(); }
  OutputFile& operator*() { return *file_; }

 private:
  std::unique_ptr<OutputFile> file_;
};

}  // namespace

void check_sample_names(const SampleFiles& files) {
  check_extension(files.frames, "a file of frames", kTextExtensions);
  check_extension(files.outside, "a file of points", kTextExtensions);
}

std::size_t write_samples(const FrameField& field, std::span<const Vector3> points, const SampleFiles& files,
                          const Monitor& monitor) {
  check_sample_names(files);
  Sink frames(files.frames);
  std::optional<Sink> outside;
  if (!files.outside.empty()) outside.emplace(files.outside);

  frames->write(std::string(kTextMark) + "ux uy uz vx vy vz wx wy wz\n");
  if (outside) (*outside)->write(std::string(kTextMark) + "x y z\n");
  std::size_t outside_count = 0;
  std::vector<FrameField::Sample> samples(std::min(kPointsAtOnce, points.size()));
  std::vector<Frame> batch_frames;
  for (std::size_t begin = 0; begin < points.size(); begin += kPointsAtOnce) {
    monitor.check();
    const auto batch = points.subspan(begin, std::min(kPointsAtOnce, points.size() - begin));
    const auto answers = std::span(samples).first(batch.size());
    field.sample(batch, answers);
    batch_frames.clear();
    for (const FrameField::Sample& sample : answers) batch_frames.push_back(sample.frame);
    write_frame_lines(*frames, batch_frames);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (answers[i].in_active_cell) continue;
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
