// SPDX-License-Identifier: Apache-2.0
// Compiled into both the library and the program crossgrain_netgen.
#include "tet_making/netgen_messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "crossgrain/version.hpp"
#include "process/answer_stream.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kMostFaultBytes = 1000;

const std::string& netgen_greeting() {
  static const std::string text = fmt::format("crossgrain_netgen {}\n", kVersion);
  return text;
}

/// Tagged edges and triangles as they are sent: without padding, and without flags that may be invalid.
template <std::size_t N>
struct Tagged {
  std::array<std::uint32_t, N> vertices;
  std::int32_t tag;
};

struct Content {
  NetgenEnd end = NetgenEnd::kTets;
  std::string fault;
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<std::int32_t> regions;
  std::vector<Tagged<2>> edges;
  std::vector<Tagged<3>> faces;
};

/// Defines the contents of an answer and their order, for reading and writing.
template <class Stream, class AContent>
void exchange_netgen(Stream& stream, AContent& content) {
  stream.value(content.end);
  stream.items(content.fault);
  stream.items(content.vertices);
  stream.items(content.tets);
  stream.items(content.regions);
  stream.items(content.edges);
  stream.items(content.faces);
}

template <class Items, class VerticesOf>
bool are_in_range(const Items& items, std::size_t vertices, const VerticesOf& vertices_of) {
  return std::all_of(items.begin(), items.end(), [&](const auto& item) {
    const auto& of = vertices_of(item);
    return std::all_of(of.begin(), of.end(), [&](std::uint32_t v) { return v < vertices; });
  });
}

bool is_consistent(const Content& content) {
  const std::size_t vertices = content.vertices.size();
  const auto itself = [](const auto& item) -> const auto& {
    return item;
  };
  const auto of_tagged = [](const auto& item) -> const auto& {
    return item.vertices;
  };
  const bool is_line = content.fault.size() <= kMostFaultBytes &&
                       std::none_of(content.fault.begin(), content.fault.end(),
                                    [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  return content.end <= NetgenEnd::kOutOfMemory && is_line && are_finite(content.vertices) &&
         are_in_range(content.tets, vertices, itself) && are_in_range(content.edges, vertices, of_tagged) &&
         are_in_range(content.faces, vertices, of_tagged) &&
         (content.regions.empty() || content.regions.size() == content.tets.size());
}

}  // namespace

std::vector<std::string> arguments_of(const NetgenRequest& request) {
  return {kVersion,
          fmt::to_string(request.asking_process),
          fmt::to_string(static_cast<int>(request.work)),
          fmt::format("{}", request.size),
          fmt::format("{}", request.curvature.edges_per_circle),
          fmt::format("{}", request.curvature.smallest_share),
          fmt::to_string(request.max_memory_bytes),
          request.folder};
}

std::optional<NetgenRequest> netgen_request_of(const std::vector<std::string>& arguments) {
  constexpr std::size_t kCount = 8;
  if (arguments.size() != kCount || arguments[0] != kVersion) return std::nullopt;
  NetgenRequest request{};
  int work = 0;
  const bool is_sound = parse_number(arguments[1], request.asking_process) &&
                        parse_number(arguments[2], work) && parse_number(arguments[3], request.size) &&
                        parse_number(arguments[4], request.curvature.edges_per_circle) &&
                        parse_number(arguments[5], request.curvature.smallest_share) &&
                        parse_number(arguments[6], request.max_memory_bytes);
  if (!is_sound || work < 0 || work > static_cast<int>(NetgenWork::kCut)) return std::nullopt;
  request.work = static_cast<NetgenWork>(work);
  request.folder = arguments[7];
  return request;
}

std::string netgen_surface_bytes(const NetgenSurface& surface) {
  char* bytes = nullptr;
  std::size_t size = 0;
  std::FILE* file = ::open_memstream(&bytes, &size);
  if (file == nullptr) throw std::bad_alloc();
  AnswerWriter writer(file);
  writer.items(surface.vertices);
  writer.items(surface.triangles);
  std::fclose(file);
  std::string copy(bytes, size);
  std::free(bytes);
  return copy;
}

std::optional<NetgenSurface> netgen_surface_in(std::string_view bytes) {
  AnswerReader reader(bytes);
  NetgenSurface surface;
  reader.items(surface.vertices);
  reader.items(surface.triangles);
  const auto itself = [](const auto& item) -> const auto& {
    return item;
  };
  const bool is_sound = reader.sound() && reader.rest().empty() && are_finite(surface.vertices) &&
                        are_in_range(surface.triangles, surface.vertices.size(), itself);
  return is_sound ? std::optional(std::move(surface)) : std::nullopt;
}

void write_netgen_greeting(std::FILE* out) {
  std::fputs(netgen_greeting().c_str(), out);
  std::fflush(out);
}

bool write_netgen_answer(std::FILE* out, const NetgenAnswer& answer) {
  const TetMesh& mesh = answer.mesh;
  Content content{answer.end, answer.fault, mesh.vertices, mesh.tets, mesh.regions, {}, {}};
  for (const TetMesh::Edge& edge : mesh.feature_edges) content.edges.push_back({edge.vertices, edge.tag});
  for (const TetMesh::Face& face : mesh.feature_faces) content.faces.push_back({face.vertices, face.tag});
  AnswerWriter writer(out);
  exchange_netgen(writer, content);
  writer.bytes(kAnswerTrailer.data(), kAnswerTrailer.size());
  return writer.flush();
}

bool is_netgen_greeting(std::string_view written) {
  return written.starts_with(netgen_greeting());
}

std::optional<NetgenAnswer> netgen_answer_in(std::string_view written) {
  if (!is_netgen_greeting(written)) return std::nullopt;
  AnswerReader reader(written.substr(netgen_greeting().size()));
  Content content;
  exchange_netgen(reader, content);
  if (!reader.sound() || reader.rest() != kAnswerTrailer || !is_consistent(content)) return std::nullopt;
  NetgenAnswer answer{content.end, std::move(content.fault), {}};
  answer.mesh.vertices = std::move(content.vertices);
  answer.mesh.tets = std::move(content.tets);
  answer.mesh.regions = std::move(content.regions);
  for (const auto& [vertices, tag] : content.edges)
    answer.mesh.feature_edges.push_back({vertices, tag, false});
  for (const auto& [vertices, tag] : content.faces) answer.mesh.feature_faces.push_back({vertices, tag});
  return answer;
}

}  // namespace crossgrain
