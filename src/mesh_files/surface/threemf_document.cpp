// SPDX-License-Identifier: Apache-2.0
// 3MF Core Specification 1.3: an archive of parts in XML, of which _rels/.rels names the first one. The
// Production Extension lets components and items refer to objects of other parts (`path`).
#include "mesh_files/surface/threemf_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "archives/xml_elements.hpp"
#include "archives/zip_archive.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

constexpr std::string_view kRelationships = "_rels/.rels";
constexpr std::string_view kModelRelationship =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr std::string_view kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
constexpr std::string_view kProduction = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";

struct Unit {
  std::string_view name;
  const char* short_name;
  double millimetres;
};
constexpr std::array kUnits{Unit{"micron", "um", 1e-3},   Unit{"millimeter", "mm", 1},
                            Unit{"centimeter", "cm", 10}, Unit{"inch", "inch", 25.4},
                            Unit{"foot", "foot", 304.8},  Unit{"meter", "m", 1000}};

/// Names of parts begin with '/', members of the archive do not.
std::string member_of(std::string_view part) {
  return std::string(part.starts_with('/') ? part.substr(1) : part);
}

std::string first_part(const InputFile& file, const ZipArchive& archive) {
  std::string part;
  read_xml(
      file, kRelationships, archive.read(kRelationships), {[&part](const XmlElement& element) {
        if (element.name == "Relationship" && element.value("Type") == kModelRelationship && part.empty())
          part = member_of(element.value("Target"));
      }});
  if (part.empty())
    throw Error(ErrorKind::kInput,
                {file.name(), in_quotes(kRelationships), "names no model", Remedy::kExportAgain});
  return part;
}

/// Reads one part into the document.
class PartReader {
 public:
  PartReader(const InputFile& file, std::string part, bool is_first, ThreeMfDocument& document)
      : file_(file), part_(std::move(part)), is_first_(is_first), document_(document) {}

  /// Returns the other parts that this one refers to.
  std::set<std::string> read(const std::string& text) {
    read_xml(file_, part_, text,
             {[this](const XmlElement& element) { begin(element); },
              [this](std::string_view space, std::string_view name) { end(space, name); }});
    return std::move(others_);
  }

 private:
  void begin(const XmlElement& element) {
    if (element.space != kCore) return;
    if (element.name == "model") return begin_model(element);
    if (element.name == "object") return begin_object(element);
    if (element.name == "item" && is_first_) document_.items.push_back(placed(element));
    if (object_ == nullptr) return;
    if (element.name == "vertex") add_vertex(element);
    if (element.name == "triangle") add_triangle(element);
    if (element.name == "component") object_->components.push_back(placed(element));
  }

  void end(std::string_view space, std::string_view name) {
    if (space == kCore && name == "object") object_ = nullptr;
  }

  void begin_model(const XmlElement& element) {
    const std::string_view name = element.value("unit");
    if (name.empty() || !is_first_) return;
    for (const Unit& unit : kUnits) {
      if (unit.name != name) continue;
      document_.millimetres = unit.millimetres;
      document_.unit = unit.short_name;
      return;
    }
    fail(element, fmt::format("{} is no unit of the format", in_quotes(name)));
  }

  void begin_object(const XmlElement& element) {
    const auto [place, is_new] =
        document_.objects.try_emplace(ThreeMfName(part_, std::string(element.value("id"))));
    if (!is_new) fail(element, fmt::format("a second object {}", in_quotes(element.value("id"))));
    object_ = &place->second;
    const std::string_view type = element.value("type");
    object_->is_built = type != "support" && type != "other";
  }

  void add_vertex(const XmlElement& element) {
    append_within_memory(
        file_.name(), object_->vertices,
        Vector3{coordinate(element, "x"), coordinate(element, "y"), coordinate(element, "z")});
  }

  /// Vertices come before triangles.
  void add_triangle(const XmlElement& element) {
    std::array<std::uint32_t, 3> corners;
    constexpr std::array kNames{"v1", "v2", "v3"};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::string_view text = element.value(kNames[k]);
      const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), corners[k]);
      if (code != std::errc() || stop != text.data() + text.size())
        fail(element, fmt::format("{} instead of the number of a vertex", in_quotes(text)));
      if (corners[k] >= object_->vertices.size())
        fail(element, fmt::format("a triangle names vertex {} of {}", corners[k], object_->vertices.size()));
    }
    append_within_memory(file_.name(), object_->triangles, corners);
  }

  ThreeMfPlaced placed(const XmlElement& element) {
    ThreeMfPlaced result{{part_, std::string(element.value("objectid"))}, transform(element)};
    if (const std::string_view path = element.value("path", kProduction); !path.empty()) {
      result.object.first = member_of(path);
      others_.insert(result.object.first);
    }
    return result;
  }

  ThreeMfTransform transform(const XmlElement& element) const {
    ThreeMfTransform result;
    std::string_view text = element.value("transform");
    if (text.empty()) return result;
    for (Vector3& row : result.rows) {
      for (double& entry : row) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
        entry = number(element, word);
        text.remove_prefix(word.size());
      }
    }
    const double volume = result.determinant();
    if (volume == 0 || !std::isfinite(volume)) fail(element, "a transform that leaves no volume");
    return result;
  }

  double coordinate(const XmlElement& element, std::string_view axis) const {
    return number(element, element.value(axis));
  }

  double number(const XmlElement& element, std::string_view text) const {
    double value = 0;
    const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
    const auto [stop, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (code != std::errc() || stop != digits.data() + digits.size() || !std::isfinite(value))
      fail(element, fmt::format("{} instead of a number", in_quotes(text)));
    return value;
  }

  [[noreturn]] void fail(const XmlElement& element, const std::string& text) const {
    fail_in_part(file_, part_, element.line, text);
  }

  const InputFile& file_;
  std::string part_;
  bool is_first_;
  ThreeMfDocument& document_;
  ThreeMfObject* object_ = nullptr;
  std::set<std::string> others_;
};

}  // namespace

Vector3 ThreeMfTransform::operator()(const Vector3& point) const {
  return point[0] * rows[0] + point[1] * rows[1] + point[2] * rows[2] + rows[3];
}

ThreeMfTransform ThreeMfTransform::after(const ThreeMfTransform& first) const {
  ThreeMfTransform both;
  for (std::size_t k = 0; k < 3; ++k) both.rows[k] = (*this)(first.rows[k]) - rows[3];
  both.rows[3] = (*this)(first.rows[3]);
  return both;
}

double ThreeMfTransform::determinant() const {
  return dot(rows[0], cross(rows[1], rows[2]));
}

ThreeMfDocument read_3mf_document(const InputFile& file) {
  const ZipArchive archive(file);
  ThreeMfDocument document;
  const std::string first = first_part(file, archive);
  std::set<std::string> known{first},
      waiting = PartReader(file, first, true, document).read(archive.read(first));
  while (!waiting.empty()) {
    const std::string part = waiting.extract(waiting.begin()).value();
    if (!known.insert(part).second) continue;
    waiting.merge(PartReader(file, part, false, document).read(archive.read(part)));
  }
  return document;
}

}  // namespace crossgrain
