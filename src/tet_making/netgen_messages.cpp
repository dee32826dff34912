// SPDX-License-Identifier: Apache-2.0
// Compiled into both the library and the program crossgrain_netgen.
#include "tet_making/netgen_messages.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdlib>

#include "process/answer_stream.hpp"
#include "process/helper_program.hpp"

namespace crossgrain {
namespace {

/// Tagged edges and triangles as they are sent: without padding, and without flags that may be invalid.
template <std::size_t N>
struct Tagged {
  std::array<std::uint32_t, N> vertices;
  std::int32_t tag;

  auto begin() const { return vertices.begin(); }
  auto end() const { return vertices.end(); }
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

bool is_consistent(const Content& content) {
  const std::size_t vertices = content.vertices.size();
  return content.end <= NetgenEnd::kOutOfMemory && is_line(content.fault) && are_finite(content.vertices) &&
         are_in_range(content.tets, vertices) && are_in_range(content.edges, vertices) &&
         are_in_range(content.faces, vertices) &&
         (content.regions.empty() || content.regions.size() == content.tets.size());
}

}  // namespace

std::vector<std::string> arguments_of(const NetgenRequest& request) {
  return {kVersion,
          fmt::to_string(request.asking_process),
          fmt::to_string(static_cast<int>(request.work)),
          fmt::format("{}", request.sizes.size),
          fmt::format("{}", request.sizes.edges_per_circle),
          fmt::format("{}", request.sizes.smallest_share),
          fmt::to_string(request.max_memory_bytes),
          request.folder};
}

std::optional<NetgenRequest> netgen_request_of(const std::vector<std::string>& arguments) {
  constexpr std::size_t kCount = 8;
  if (arguments.size() != kCount || arguments[0] != kVersion) return std::nullopt;
  NetgenRequest request{};
  int work = 0;
  const bool is_sound = parse_number(arguments[1], request.asking_process) &&
                        parse_number(arguments[2], work) && parse_number(arguments[3], request.sizes.size) &&
                        parse_number(arguments[4], request.sizes.edges_per_circle) &&
                        parse_number(arguments[5], request.sizes.smallest_share) &&
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
  const bool is_sound = reader.ends_with("") && are_finite(surface.vertices) &&
                        are_in_range(surface.triangles, surface.vertices.size());
  return is_sound ? std::optional(std::move(surface)) : std::nullopt;
}

bool write_netgen_answer(std::FILE* out, const NetgenAnswer& answer) {
  const TetMesh& mesh = answer.mesh;
  Content content{answer.end, answer.fault, mesh.vertices, mesh.tets, mesh.regions, {}, {}};
  for (const TetMesh::Edge& edge : mesh.feature_edges) content.edges.push_back({edge.vertices, edge.tag});
  for (const TetMesh::Face& face : mesh.feature_faces) content.faces.push_back({face.vertices, face.tag});
  AnswerWriter writer(out);
  exchange_netgen(writer, content);
  return writer.end();
}

std::optional<NetgenAnswer> netgen_answer_in(std::string_view written) {
  const std::string greeting = greeting_of(kNetgenProgramName);
  if (!written.starts_with(greeting)) return std::nullopt;
  AnswerReader reader(written.substr(greeting.size()));
  Content content;
  exchange_netgen(reader, content);
  if (!reader.ends_with(kAnswerTrailer) || !is_consistent(content)) return std::nullopt;
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
