// SPDX-License-Identifier: Apache-2.0
#include "results/solve_id.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <thread>
#include <type_traits>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/version.hpp"
#include "files/checksum.hpp"
#include "files/crc32.hpp"
#include "files/file_mark.hpp"
#include "files/folder_reservation.hpp"
#include "results/field_pieces.hpp"
#include "results/result_files.hpp"

namespace crossgrain {
namespace {

namespace fs = std::filesystem;

/// Bytes of a part that is summed up by itself.
constexpr std::size_t kPartBytes = 1 << 18;

constexpr int kLooks = 3;
constexpr std::chrono::milliseconds kBetweenLooks{20};

template <class T>
std::string_view bytes_of(const T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(values), count * sizeof(T)};
}

/// Sums up arrays in turn; their lengths count too.
class ContentSum {
 public:
  template <class T>
  void add(const std::vector<T>& values) {
    add_value(values.size());
    add_sums(sums_of_parts(values, std::max<std::size_t>(1, kPartBytes / sizeof(T))));
  }

  /// Adds values of the leaves of all processes, in the first.
  template <class T>
  void add(const std::vector<T>& values, const Share& share) {
    std::uint64_t size = values.size();
    add_up(share, std::span(&size, 1));
    add_value(size);
    // A number of leaves at which shares are cut.
    add_sums(on_first(share, sums_of_parts(values, kShareUnit)));
  }

  template <class T>
  void add_value(const T& value) {
    sum_.add(bytes_of(&value, 1));
  }

  void add_text(std::string_view text) { sum_.add(text); }

  std::string text() const { return fmt::format("{:016x}", sum_.value()); }

 private:
  /// Sums of so many values each, so that several processors and processes can.
  template <class T>
  static std::vector<std::uint64_t> sums_of_parts(const std::vector<T>& values, std::size_t count) {
    std::vector<std::uint64_t> sums((values.size() + count - 1) / count);
    const auto sum_part = [&](std::size_t part) {
      const std::size_t first = part * count;
      Checksum sum;
      sum.add(bytes_of(values.data() + first, std::min(count, values.size() - first)));
      sums[part] = sum.value();
    };
    parallel_for(sums.size(), sum_part, 1);
    return sums;
  }

  void add_sums(const std::vector<std::uint64_t>& sums) { sum_.add(bytes_of(sums.data(), sums.size())); }

  Checksum sum_;
};

void add_field(const FieldData& data, ContentSum& sum) {
  sum.add_value(data.degree);
  const RootCube& root = data.tree.root();
  for (const double x : {root.origin[0], root.origin[1], root.origin[2], root.size}) sum.add_value(x);
  const Share share = data.share();
  sum.add(data.tree.leaves(), share);
  sum.add(data.frames, share);
  sum.add(data.open_faces, share);
  sum.add(data.on_boundary, share);
  sum.add(data.energy_density, share);
  sum.add(data.alignment_deg, share);
  sum.add(data.constraints, share);
  sum.add(data.regions, share);
}

void add_surface(const SolvedSurface& surface, ContentSum& sum) {
  sum.add(surface.vertices);
  sum.add(surface.triangles);
  for (const std::vector<Vector3>& crease : surface.creases) sum.add(crease);
  sum.add(surface.interfaces);
  sum.add(surface.regions);
  sum.add(surface.interface_regions);
}

void add_options(const OutputOptions& options, ContentSum& sum) {
  sum.add_value(options.level.value_or(-1));
  if (options.hexahedra) {
    sum.add(options.hexahedra->vertices);
    sum.add(options.hexahedra->hexahedra);
  }
  if (options.hex_map) {
    sum.add(options.hex_map->seamless);
    sum.add(options.hex_map->integer_grid);
  }
  if (!options.clip) return;
  for (const Vector3& corner : {options.clip->low, options.clip->high})
    for (const double x : corner) sum.add_value(x);
}

[[noreturn]] void refuse_other_solve(const fs::path& path, const fs::path& other) {
  throw Error(ErrorKind::kInput,
              {path.string(), "", "is of another solve than " + other.string(), Remedy::kCopyOrSolveAgain});
}

[[noreturn]] void refuse_unlisted(const fs::path& path) {
  refuse_other_solve(path, path.parent_path() / kReportFile);
}

/// The solve that the files of a folder name; empty if they name none.
std::string named_solve(const fs::path& folder) {
  complete_folder(folder);
  std::vector<std::string> names = all_result_files();
  const std::vector<std::string> pieces = listed_pieces(folder);
  names.insert(names.end(), pieces.begin(), pieces.end());
  // The report is what the others are compared with.
  std::stable_partition(names.begin(), names.end(), [](const auto& name) { return name == kReportFile; });
  std::optional<std::string> solve;
  fs::path first;
  for (const std::string& name : names) {
    const std::optional<std::string> found = marked_solve(folder / name);
    if (!found) continue;
    if (!solve) first = folder / name;
    if (solve.value_or(*found) != *found) refuse_other_solve(folder / name, first);
    solve = found;
  }
  return solve.value_or("");
}

}  // namespace

std::string solve_id(const FieldData& data, const OutputOptions& options, const TetOutput* tets) {
  ContentSum sum;
  sum.add_text(kVersion);
  add_options(options, sum);
  add_field(data, sum);
  if (const auto surface = data.surface.get()) add_surface(*surface, sum);
  if (tets != nullptr) {
    sum.add(tets->solid.mesh.vertices);
    sum.add(tets->solid.mesh.tets);
    sum.add(tets->solid.mesh.regions);
    sum.add(tets->field.vertex_frames);
    if (tets->field.is_repaired()) {
      sum.add(tets->field.tet_frames);
      sum.add(tets->field.matchings);
    }
  }
  return sum.text();
}

std::string solve_id(const OutputOptions& options) {
  ContentSum sum;
  sum.add_text(kVersion);
  add_options(options, sum);
  return sum.text();
}

bool is_solve_id(const std::string& text) {
  return text.size() == kSolveBytes && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

void check_listed_sizes(const fs::path& folder, const ResultInventory& report) {
  for (const ResultInventory::File& listed : report.files) {
    if (fs::path(listed.name).has_parent_path()) continue;
    std::error_code unknown;
    const auto bytes = fs::file_size(folder / listed.name, unknown);
    if (!unknown && bytes != listed.bytes && !has_mark(folder / listed.name))
      refuse_unlisted(folder / listed.name);
  }
}

void check_listed_bytes(const fs::path& path, std::string_view bytes, const ResultInventory& report) {
  const auto& files = report.files;
  const auto listed = std::find_if(files.begin(), files.end(),
                                   [&](const auto& file) { return file.name == path.filename(); });
  if (listed == files.end()) return;
  Crc32 crc;
  crc.add(bytes);
  if (crc.text() != listed->checksum) refuse_unlisted(path);
}

std::string solve_of_result(const fs::path& folder) {
  check_is_folder(folder);
  // A folder that is being replaced may look like a mix once, but not again.
  for (int looks = kLooks; looks > 1; --looks) {
    try {
      return named_solve(folder);
    } catch (const Error&) {
      std::this_thread::sleep_for(kBetweenLooks);
    }
  }
  return named_solve(folder);
}

}  // namespace crossgrain
