// SPDX-License-Identifier: Apache-2.0
#include "distributed/kept_solve.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <numeric>
#include <system_error>
#include <utility>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

constexpr std::array<char, 24> kStartMagic{"crossgrain start 1\n"};
constexpr std::array<char, 24> kSeenMagic{"crossgrain seen 1\n"};
constexpr const char* kStartName = "start-";
constexpr const char* kSeenName = "seen-";
constexpr std::array<char, 24> kSweepsMagic{"crossgrain sweeps 1\n"};
constexpr const char* kSweepsName = "sweeps-";
constexpr const char* kUnfinished = ".part";

std::filesystem::path path_of(const std::string& folder, const char* name, int depth) {
  return std::filesystem::path(folder) / (name + std::to_string(depth));
}

struct SeenHeader {
  std::array<char, 24> magic;
  std::uint64_t identity, bytes;
};

}  // namespace

/// Where the lists of a start begin.
struct KeptSolve::Offsets {
  std::uint64_t levels, addresses, windings, piece_ends, pieces, frames, end;

  explicit Offsets(const Header& header) {
    levels = sizeof(Header);
    addresses = levels + header.levels * sizeof(LevelStatistics);
    windings = addresses + header.leaves * sizeof(CellAddress);
    piece_ends = windings + header.leaves;
    pieces = piece_ends + header.leaves * sizeof(std::uint64_t);
    frames = pieces + header.pieces * sizeof(SurfacePiece);
    end = frames + header.leaves * sizeof(StoredQuaternion);
  }
};

void KeptSolve::keep_seen(int depth, const Bytes& seen) const {
  const std::string path = path_of(keep_, kSeenName, depth).string(), unfinished = path + kUnfinished;
  const SeenHeader header{kSeenMagic, identity_, seen.size()};
  const std::array parts{part_at(0, std::span(&header, 1)), part_at(sizeof header, std::span(seen))};
  std::error_code error;
  std::filesystem::create_directories(keep_, error);
  if (error) fail_to_keep(keep_, error.value());
  int failure = made_empty(unfinished);
  if (failure == 0) failure = written(unfinished, parts);
  if (failure == 0 && std::rename(unfinished.c_str(), path.c_str()) != 0) failure = errno;
  if (failure == 0) return;
  std::filesystem::remove(unfinished, error);
  fail_to_keep(path, failure);
}

KeptSolve::Header KeptSolve::header_of(const LevelStart& start, const GridLevel& level,
                                       std::uint64_t pieces) const {
  Header header{};
  header.magic = kStartMagic;
  header.identity = identity_;
  header.leaves = level.share().of_all;
  header.pieces = pieces;
  header.levels = start.levels.size();
  header.examined_leaves = level.examined_leaves;
  header.start = start;
  header.root = level.tree.root();
  return header;
}

void KeptSolve::keep_start(const LevelStart& start, const GridLevel& level,
                           std::span<const StoredQuaternion> frames) {
  const std::string path = path_of(keep_, kStartName, start.depth).string();
  if (is_one_folder_ && start.depth == found_.start.depth) return;  // it is there
  const Share share = level.share();
  const std::uint64_t own_pieces = level.piece_begin[share.end] - level.piece_begin[share.begin];
  const auto pieces = gathered_value(exchange_, own_pieces);
  const std::uint64_t pieces_before =
      std::accumulate(pieces.begin(), pieces.begin() + exchange_.rank(), std::uint64_t{0});
  const Header header =
      header_of(start, level, std::accumulate(pieces.begin(), pieces.end(), std::uint64_t{0}));
  const Offsets offsets(header);
  std::vector<std::uint64_t> piece_ends;
  for (CellIndex leaf = share.begin; leaf < share.end; ++leaf)
    piece_ends.push_back(pieces_before + level.piece_begin[leaf + 1] - level.piece_begin[share.begin]);
  const auto own = [&]<class T>(std::uint64_t offset, std::span<const T> values) {
    return part_at(offset + share.before * sizeof(T), values.subspan(share.begin, share.size()));
  };
  std::vector<SharedFiles::Part> parts{
      own(offsets.addresses, std::span(level.tree.leaves())),
      own(offsets.windings, std::span(level.centre_winding)), own(offsets.frames, frames),
      part_at(offsets.piece_ends + share.before * sizeof(std::uint64_t),
              std::span<const std::uint64_t>(piece_ends)),
      part_at(offsets.pieces + pieces_before * sizeof(SurfacePiece),
              std::span(level.pieces).subspan(level.piece_begin[share.begin], own_pieces))};
  if (exchange_.rank() == 0) {
    parts.push_back(part_at(0, std::span<const Header>(&header, 1)));
    parts.push_back(part_at(offsets.levels, std::span(start.levels)));
  }
  write_together(path, parts);
  if (exchange_.rank() != 0) return;
  for (const int depth : numbers_of_files(keep_, kStartName)) {
    std::error_code error;
    if (depth != start.depth) std::filesystem::remove(path_of(keep_, kStartName, depth), error);
  }
  for (const int depth : numbers_of_files(keep_, kSweepsName)) {
    std::error_code error;
    std::filesystem::remove(path_of(keep_, kSweepsName, depth), error);
  }
}

struct KeptSolve::SweepHeader {
  std::array<char, 24> magic;
  std::uint64_t identity, leaves, blocks;
  std::int64_t sweeps;
  double energy;
};

std::uint64_t KeptSolve::end_of_lists(const SweepHeader& header, std::span<const LeafValues> lists) {
  std::uint64_t end = sizeof header + header.blocks * sizeof(double);
  for (const LeafValues& list : lists) end += header.leaves * list.size;
  return end;
}

void KeptSolve::enter(int depth, const Share& share) {
  depth_ = depth;
  share_ = share;
  last_kept_ = std::chrono::steady_clock::now();
}

bool KeptSolve::is_due() {
  if (!keeps()) return false;
  const auto since = std::chrono::duration<double>(std::chrono::steady_clock::now() - last_kept_);
  return gathered_value<char>(exchange_, since.count() >= seconds_ ? 1 : 0).front() != 0;
}

void KeptSolve::keep(const SweepsSoFar& sweeps, std::span<const LeafValues> lists) {
  const SweepHeader header{kSweepsMagic,  identity_,    share_.of_all, sweeps.decreases.size(),
                           sweeps.sweeps, sweeps.energy};
  std::vector<SharedFiles::Part> parts;
  if (exchange_.rank() == 0) {
    parts.push_back(part_at(0, std::span<const SweepHeader>(&header, 1)));
    parts.push_back(part_at(sizeof header, std::span(sweeps.decreases)));
  }
  for (std::size_t k = 0; k < lists.size(); ++k) {
    const auto& [bytes, size] = lists[k];
    parts.push_back({end_of_lists(header, lists.first(k)) + share_.before * size,
                     bytes.subspan(share_.begin * size, share_.size() * size)});
  }
  write_together(path_of(keep_, kSweepsName, depth_).string(), parts);
  last_kept_ = std::chrono::steady_clock::now();
}

std::optional<SweepsSoFar> KeptSolve::resumed(std::span<const LeafValues> lists) {
  if (found_path_.empty() || found_.start.depth != depth_) return std::nullopt;
  const std::string path = path_of(resume_, kSweepsName, depth_).string();
  std::error_code error;
  // The first process says whether there are any.
  const char exists = std::filesystem::exists(path, error) ? 1 : 0;
  if (gathered_value(exchange_, exists).front() == 0) return std::nullopt;
  const SweepHeader header = read_at<SweepHeader>(path, 0, 1).front();
  if (header.magic != kSweepsMagic || header.identity != identity_ || header.leaves != share_.of_all ||
      std::filesystem::file_size(path, error) != end_of_lists(header, lists))
    refuse_checkpoint(path, "is cut short or of another solve");
  for (std::size_t k = 0; k < lists.size(); ++k) {
    const auto& [bytes, size] = lists[k];
    read_bytes(path, end_of_lists(header, lists.first(k)) + share_.before * size,
               bytes.subspan(share_.begin * size, share_.size() * size));
  }
  return SweepsSoFar{static_cast<int>(header.sweeps), header.energy,
                     read_at<double>(path, sizeof header, header.blocks)};
}

/// Writes a file that comes under its name when it is complete. Throws Error(kOutput) in all processes.
void KeptSolve::write_together(const std::string& path, std::span<const SharedFiles::Part> parts) {
  const std::string unfinished = path + kUnfinished;
  const bool is_first = exchange_.rank() == 0;
  std::error_code error;
  int failure = 0;
  if (is_first) {
    std::filesystem::create_directories(keep_, error);
    failure = made_empty(unfinished);
  }
  if (any(exchange_, failure != 0)) fail_to_keep(unfinished, failure != 0 ? failure : EIO);
  const bool is_written = files_.write(unfinished, parts);
  if (any(exchange_, !is_written)) {
    if (is_first) std::filesystem::remove(unfinished, error);
    throw Error(ErrorKind::kOutput,
                {path, "", "cannot be written by all processes", Remedy::kMoveCheckpoint});
  }
  if (is_first && std::rename(unfinished.c_str(), path.c_str()) != 0) {
    failure = errno;
    std::filesystem::remove(unfinished, error);
  }
  if (any(exchange_, failure != 0)) fail_to_keep(path, failure != 0 ? failure : EIO);
}

/// Sets found_ and found_path_.
std::optional<LevelStart> KeptSolve::read_start(const std::string& path) {
  found_path_ = path;
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error || size < sizeof(Header)) refuse_checkpoint(path, "is cut short");
  found_ = read_at<Header>(path, 0, 1).front();
  if (found_.magic != kStartMagic) refuse_checkpoint(path, "is no checkpoint of this version");
  if (found_.identity != identity_)
    refuse_checkpoint(path, "belongs to a solve of another model or with other options",
                      Remedy::kGiveSameModel);
  const Offsets offsets(found_);
  if (size != offsets.end) refuse_checkpoint(path, "is cut short");
  return LevelStart{found_.start, read_at<LevelStatistics>(path, offsets.levels, found_.levels)};
}

std::optional<LevelStart> KeptSolve::begin(std::uint64_t identity) {
  identity_ = identity;
  if (resume_.empty()) return std::nullopt;
  // File systems of several hosts may differ for a while: the first process says which file it is.
  int depth = -1;
  std::exception_ptr failure;
  if (exchange_.rank() == 0) {
    try {
      const std::vector<int> depths = numbers_of_files(resume_, kStartName);
      if (!depths.empty()) depth = depths.back();
    } catch (...) {
      failure = std::current_exception();
    }
    std::error_code error;
    is_one_folder_ = std::filesystem::equivalent(keep_, resume_, error);
  }
  depth = gathered_value(exchange_, depth).front();
  is_one_folder_ = gathered_value<char>(exchange_, is_one_folder_ ? 1 : 0).front() != 0;
  std::optional<LevelStart> start;
  if (!failure && depth >= 0) {
    try {
      start = read_start(path_of(resume_, kStartName, depth).string());
    } catch (...) {
      failure = std::current_exception();
    }
  }
  const bool fails = any(exchange_, failure != nullptr);
  if (failure) std::rethrow_exception(failure);
  if (fails) refuse_checkpoint(resume_, "cannot be read by all processes", Remedy::kGiveCheckpoint);
  return start;
}

LeafRecords KeptSolve::leaves_between(std::uint64_t begin, std::uint64_t end) const {
  LeafRecords records;
  records.frames.resize(1);
  if (begin == end) return records;
  const Offsets offsets(found_);
  const std::uint64_t count = end - begin;
  records.addresses =
      read_at<CellAddress>(found_path_, offsets.addresses + begin * sizeof(CellAddress), count);
  records.centre_winding = read_at<std::int8_t>(found_path_, offsets.windings + begin, count);
  const std::uint64_t ends = offsets.piece_ends + begin * sizeof(std::uint64_t);
  std::uint64_t before = 0;
  if (begin > 0) before = read_at<std::uint64_t>(found_path_, ends - sizeof(std::uint64_t), 1).front();
  const auto piece_ends = read_at<std::uint64_t>(found_path_, ends, count);
  records.pieces = read_at<SurfacePiece>(found_path_, offsets.pieces + before * sizeof(SurfacePiece),
                                         piece_ends.back() - before);
  for (const std::uint64_t piece_end : piece_ends)
    records.piece_counts.push_back(static_cast<std::uint32_t>(piece_end - std::exchange(before, piece_end)));
  records.frames[0] =
      read_at<StoredQuaternion>(found_path_, offsets.frames + begin * sizeof(StoredQuaternion), count);
  return records;
}

void KeptSolve::revisit(LevelVisitor& visitor) const {
  for (int depth = found_.start.coarsest_depth; depth < found_.start.depth; ++depth) {
    const std::string path = path_of(resume_, kSeenName, depth).string();
    const SeenHeader header = read_at<SeenHeader>(path, 0, 1).front();
    if (header.magic != kSeenMagic || header.identity != found_.identity ||
        std::filesystem::file_size(path) != sizeof header + header.bytes)
      refuse_checkpoint(path, "is cut short or of another solve");
    const auto seen = read_at<std::byte>(path, sizeof header, header.bytes);
    visitor.revisit(depth, seen);
    if (keeps() && !is_one_folder_) keep_seen(depth, seen);
  }
}

}  // namespace crossgrain
