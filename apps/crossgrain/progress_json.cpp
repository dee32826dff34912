// SPDX-License-Identifier: Apache-2.0
#include "progress_json.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace crossgrain::app {
namespace {

using Json = nlohmann::ordered_json;

Json event(const char* name, double seconds) {
  return {{"event", name}, {"seconds", seconds}};
}

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string json_line(const Progress& progress, double seconds) {
  Json json = event("progress", seconds);
  json["phase"] = name_of(progress.phase);
  // What is not known is left out.
  if (progress.share >= 0) json["share"] = progress.share;
  if (progress.level > 0) json["level"] = progress.level;
  if (progress.levels > 0) json["levels"] = progress.levels;
  if (progress.cells > 0) json["cells"] = progress.cells;
  if (progress.attempt > 0) {
    json["attempt"] = progress.attempt;
    json["tets"] = progress.tets;
    json["most_tets"] = progress.most_tets;
  }
  if (progress.fitted > 0) json["fitted"] = progress.fitted;
  if (progress.hexahedra > 0)
    json["best"] = {{"hexahedra", progress.hexahedra}, {"outcome", name_of(progress.outcome)}};
  return line_of(json);
}

std::string json_line(const ModelSummary& model, double seconds) {
  Json json = event("model", seconds);
  json["bounding_box"] = {{"low", model.bounding_box.low}, {"high", model.bounding_box.high}};
  for (const auto& [name, value] : {std::pair("unit", &model.unit), {"file_unit", &model.file_unit}})
    if (!value->empty()) json[name] = *value;
  for (const auto& [name, count] : {std::pair("triangles", model.triangles),
                                    {"tets", model.tets},
                                    {"faces", model.faces},
                                    {"solids", model.solids}})
    if (count > 0) json[name] = count;
  return line_of(json);
}

std::string json_line(const Expectation& expected, double seconds) {
  Json json = event("expected", seconds);
  json["cells"] = expected.active_cells;
  json["peak_memory_bytes"] = expected.peak_memory_bytes;
  json["total_seconds"] = expected.seconds;
  return line_of(json);
}

std::string json_line(const HexExpectation& expected, double seconds) {
  Json json = event("expected", seconds);
  json["hexahedra"] = expected.hexahedra;
  json["size"] = expected.size;
  json["tets"] = expected.tets;
  return line_of(json);
}

std::string json_line(const HexAttemptEnd& end, double seconds) {
  Json json = event("attempt", seconds);
  json["attempt"] = end.attempt;
  json["tets"] = end.tets;
  json["most_tets"] = end.most_tets;
  json["outcome"] = name_of(end.outcome);
  json["hexahedra"] = end.hexahedra;
  json["text"] = end.text;
  json["fault"] = end.fault;
  json["next"] = end.next;
  json["over"] = end.over;
  json["attempt_seconds"] = end.seconds;
  return line_of(json);
}

}  // namespace crossgrain::app
