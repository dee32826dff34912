// SPDX-License-Identifier: Apache-2.0
#include "results/field_arrays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "vtu/array_names.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

/// Tolerance of the squared norm of a frame's quaternion in single precision.
constexpr double kUnitTolerance = 1e-5;

[[noreturn]] void refuse_damaged(const std::string& file) {
  throw Error(ErrorKind::kInput, {file, "", "its arrays do not form a field", Remedy::kCopyOrSolveAgain});
}

/// Reads the arrays of one file.
class FieldArraysReader {
 public:
  explicit FieldArraysReader(const std::filesystem::path& path) : file_(path) {}

  FieldData read() const {
    using namespace field_arrays;
    if (!file_.find(VtuSection::kFieldData, kSchema)) fail("holds no frame field", Remedy::kGiveFieldFolder);
    const std::uint32_t schema = one(values<std::uint32_t>(VtuSection::kFieldData, kSchema));
    if (schema != kSchemaNumber)
      fail(fmt::format("has schema {} and this program reads {}", schema, kSchemaNumber),
           Remedy::kSolveAgain);
    FieldData data;
    data.degree = degree();
    data.tree = tree();
    data.frames = frames();
    data.open_faces = values<std::uint8_t>(VtuSection::kFieldData, kOpenFaces);
    data.on_boundary = values<std::uint8_t>(VtuSection::kCellData, kOnBoundary);
    data.energy_density = values<float>(VtuSection::kCellData, kEnergyDensity);
    data.alignment_deg = values<float>(VtuSection::kCellData, kAlignment);
    if (file_.find(VtuSection::kCellData, kConstraint)) data.constraints = constraints();
    if (file_.find(VtuSection::kCellData, kRegion))
      data.regions = values<std::int32_t>(VtuSection::kCellData, kRegion);
    check_sizes(data);
    return data;
  }

 private:
  template <class T>
  std::vector<T> values(VtuSection section, const char* name, std::size_t components = 1) const {
    return file_.read<T>(section, name, components);
  }

  std::uint32_t one(const std::vector<std::uint32_t>& values) const {
    if (values.size() != 1) fail_damaged();
    return values[0];
  }

  Degree degree() const {
    const std::uint32_t degree = one(values<std::uint32_t>(VtuSection::kFieldData, field_arrays::kDegree));
    if (degree != 3 && degree != 4) fail_damaged();
    return static_cast<Degree>(degree);
  }

  Octree tree() const {
    const auto root = values<double>(VtuSection::kFieldData, field_arrays::kRootCube, 4);
    if (root.size() != 4 || !(root[3] > 1 / kLargestLength) ||
        !std::ranges::all_of(root, [](double x) { return std::abs(x) < kLargestLength; }))
      fail_damaged();
    const auto packed = values<std::uint64_t>(VtuSection::kFieldData, field_arrays::kCellAddress);
    if (packed.empty() || packed.size() >= kNoCell) fail_damaged();
    std::vector<CellAddress> leaves(packed.size());
    for (std::size_t i = 0; i < packed.size(); ++i) {
      leaves[i] = CellAddress::from_packed(packed[i]);
      if (!is_address(leaves[i])) fail_damaged();
      if (i > 0 && (leaves[i] <= leaves[i - 1] || leaves[i - 1].contains(leaves[i]))) fail_damaged();
    }
    return {{{root[0], root[1], root[2]}, root[3]}, std::move(leaves)};
  }

  static bool is_address(CellAddress cell) {
    constexpr int kUnusedBits = 62;
    if (cell.packed() >> kUnusedBits != 0 || cell.depth() > kMaxDepth) return false;
    return std::ranges::all_of(cell.corner(), [&](std::int32_t x) { return x % cell.width() == 0; });
  }

  std::vector<StoredQuaternion> frames() const {
    const auto parts = values<float>(VtuSection::kFieldData, field_arrays::kFrame, 4);
    std::vector<StoredQuaternion> frames(parts.size() / 4);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const float *q = &parts[4 * i], norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
      if (!(std::abs(norm - 1) < kUnitTolerance)) fail_damaged();
      frames[i] = {q[0], q[1], q[2], q[3]};
    }
    return frames;
  }

  std::vector<CellConstraint> constraints() const {
    const auto codes = values<std::uint8_t>(VtuSection::kCellData, field_arrays::kConstraint);
    std::vector<CellConstraint> constraints(codes.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
      if (codes[i] >= kCellConstraintCount) fail_damaged();
      constraints[i] = static_cast<CellConstraint>(codes[i]);
    }
    return constraints;
  }

  void check_sizes(const FieldData& data) const {
    const std::size_t count = data.tree.size();
    for (const std::size_t size : {data.frames.size(), data.open_faces.size(), data.on_boundary.size(),
                                   data.energy_density.size(), data.alignment_deg.size()}) {
      if (size != count) fail_damaged();
    }
    if (!data.constraints.empty() && data.constraints.size() != count) fail_damaged();
    if (!data.regions.empty() && data.regions.size() != count) fail_damaged();
  }

  [[noreturn]] void fail(const std::string& text, Remedy remedy) const {
    throw Error(ErrorKind::kInput, {file_.name(), "", text, remedy});
  }
  [[noreturn]] void fail_damaged() const { refuse_damaged(file_.name()); }

  VtuFile file_;
};

/// Returns whether one field may have the leaves of both, those of `first` before those of `next`.
bool may_follow(const FieldData& first, const FieldData& next) {
  const RootCube &a = first.tree.root(), &b = next.tree.root();
  const CellAddress last = first.tree.leaves().back();
  return first.degree == next.degree && a.origin == b.origin && a.size == b.size && last < next.tree[0] &&
         !last.contains(next.tree[0]) && first.constraints.empty() == next.constraints.empty() &&
         first.regions.empty() == next.regions.empty();
}

template <class T>
void append(std::vector<T>& to, std::vector<T>&& more) {
  to.insert(to.end(), more.begin(), more.end());
  more = std::vector<T>();
}

void append(FieldData& to, FieldData more) {
  std::vector<CellAddress> leaves = to.tree.leaves();
  append(leaves, std::vector(more.tree.leaves()));
  to.tree = Octree(more.tree.root(), std::move(leaves));
  append(to.frames, std::move(more.frames));
  append(to.open_faces, std::move(more.open_faces));
  append(to.on_boundary, std::move(more.on_boundary));
  append(to.energy_density, std::move(more.energy_density));
  append(to.alignment_deg, std::move(more.alignment_deg));
  append(to.constraints, std::move(more.constraints));
  append(to.regions, std::move(more.regions));
}

/// Returns what later code relies on; without it, that code would read out of range.
bool is_sound(const FieldData& data) {
  if (!is_balanced(data.tree)) return false;
  std::atomic<bool> sound = true;
  parallel_for(data.tree.size(), [&](std::size_t i) {
    if (data.open_faces[i] >> kFaceCount != 0) sound = false;
    for (int face = 0; face < kFaceCount; ++face) {
      const bool open = data.open_faces[i] >> face & 1;
      if (open && data.tree.neighbour(static_cast<CellIndex>(i), face) == kNoCell) sound = false;
    }
  });
  return sound;
}

}  // namespace

FieldData read_field_arrays(const std::vector<std::filesystem::path>& files) {
  FieldData data = FieldArraysReader(files.front()).read();
  for (std::size_t k = 1; k < files.size(); ++k) {
    FieldData next = FieldArraysReader(files[k]).read();
    if (!may_follow(data, next)) refuse_damaged(files[k].string());
    if (data.tree.size() + next.tree.size() >= kNoCell)
      throw Error(ErrorKind::kLimit, {files[k].string(), "", "the field has more than 4 billion cells"});
    append(data, std::move(next));
  }
  if (!is_sound(data)) refuse_damaged(files.front().string());
  return data;
}

}  // namespace crossgrain
