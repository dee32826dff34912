// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <type_traits>

#include "c_interface/option_names.hpp"
#include "crossgrain/hex_meshing.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/writing.hpp"
#include "fuzz/mesh_promises.hpp"
#include "fuzz/reader_checks.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

/// Numbers that make no sense end at once; those that ask for much work end here. Long enough for the seeds.
constexpr std::chrono::milliseconds kTime{1000};

/// Beyond what the process holds, a sanitizer's shadow included.
constexpr std::size_t kMostMemory = 450'000'000;

/// Cancels a monitor after a time, unless it is destroyed before.
class Deadline {
 public:
  explicit Deadline(Monitor& monitor)
      : thread_([this, &monitor] {
          std::unique_lock lock(mutex_);
          if (!over_.wait_for(lock, kTime, [this] { return is_over_; })) monitor.cancel();
        }) {}
  ~Deadline() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    over_.notify_one();
    thread_.join();
  }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable over_;
  bool is_over_ = false;
  std::thread thread_;
};

/// Any value of the type that the text is, also of an enumeration that has no such value; else none.
template <class T>
void assign(T& option, const std::string& text) {
  const char* const end = text.data() + text.size();
  if constexpr (std::is_enum_v<T>) {
    std::underlying_type_t<T> value{};
    if (std::from_chars(text.data(), end, value).ec == std::errc()) option = static_cast<T>(value);
  } else if constexpr (std::is_same_v<T, bool>) {
    option = text != "0";
  } else {
    T value{};
    if (std::from_chars(text.data(), end, value).ec == std::errc()) option = value;
  }
}

/// What a text of lines `NAME VALUE` asks for: the options by their names in docs/options.md, "model" and its
/// "scale". Other lines are passed over.
struct AskedMeshing {
  HexMeshingOptions options;
  std::string model = "none";
  double scale = 1;
};

AskedMeshing asked_in(std::string_view bytes) {
  AskedMeshing asked;
  std::istringstream lines{std::string(bytes)};
  for (std::string name, value; lines >> name >> value;) {
    if (name == "model") asked.model = value;
    if (name == "scale") assign(asked.scale, value);
    for_each_option(asked.options, [&](const std::string& option, auto& member) {
      if (name == option) assign(member, value);
    });
  }
  for (std::size_t* memory : {&asked.options.solve.max_memory_bytes, &asked.options.tets.max_memory_bytes})
    if (*memory == 0 || *memory > kMostMemory) *memory = kMostMemory;
  return asked;
}

TetMesh tets_of(const AskedMeshing& asked) {
  TetMesh mesh = asked.model == "tet"     ? corner_tet()
                 : asked.model == "plate" ? TetBox{{3, 3, 1}}.mesh()
                                          : TetBox{{1, 1, 1}}.mesh();
  for (Vector3& vertex : mesh.vertices) {
    if (asked.model == "plate") vertex[2] *= 1e-3;
    vertex = asked.scale * vertex;
  }
  return mesh;
}

Hexahedra made_as(const AskedMeshing& asked, const Monitor& monitor) {
  const TetDomain domain(tets_of(asked), asked.options.tags);
  return asked.model == "surface" ? make_hexahedra(domain.boundary(), asked.options, monitor)
                                  : make_hexahedra(domain, asked.options, monitor);
}

void require_hexahedra(const Hexahedra& made) {
  require_finite(made.mesh.vertices);
  for (const auto& corners : made.mesh.hexahedra) require_in_range(corners, made.mesh.vertices.size());
  for (const HexMesh::Face& face : made.mesh.boundary)
    require_in_range(face.vertices, made.mesh.vertices.size());
  require(made.report().hexahedra == made.mesh.hexahedra.size(), "a report of another mesh");
  require_one_line(sentence_of(made.report()));
  for (const Warning& warning : made.field.report().warnings) require_one_line(sentence_of(warning));
  report_json(made.field.report());
}

}  // namespace

bool check_hex_options(std::string_view bytes) {
  const AskedMeshing asked = asked_in(bytes);
  if (asked.model == "none") return false;
  Monitor monitor;
  const Deadline deadline(monitor);
  try {
    require_hexahedra(made_as(asked, monitor));
    return true;
  } catch (const Error& error) {
    require_one_line(error.what());
    return false;
  }
}

}  // namespace crossgrain
