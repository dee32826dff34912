// SPDX-License-Identifier: Apache-2.0
// Document.xml lists the objects and their properties, GuiDocument.xml what is visible of them; shapes are
// members of their own. The shape of an object lies where its own placement says, and a part moves what it
// holds.
#include "cad_reading/freecad_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "archives/xml_elements.hpp"
#include "archives/zip_archive.hpp"
#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "cad_reading/placed_breps.hpp"
#include "crossgrain/error.hpp"
#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

constexpr std::string_view kDocument = "Document.xml", kGui = "GuiDocument.xml";

/// Links to links and parts in parts; documents have a few. And objects that are shown, since links to links
/// multiply them.
constexpr int kDeepestLinks = 50;
constexpr std::size_t kMostShown = 100'000;

/// A rotation, then a translation.
struct Placement {
  Quaternion turn;
  Vector3 move{};
};

Placement operator*(const Placement& outer, const Placement& inner) {
  return {outer.turn * inner.turn, outer.move + rotate(outer.turn, inner.move)};
}

Placement inverse(const Placement& place) {
  const Quaternion back = conjugate(place.turn);
  return {back, -rotate(back, place.move)};
}

struct Object {
  std::string type;
  std::string shape;  ///< member of the archive; empty if it has none
  std::string linked;
  Placement place;
  std::vector<std::string> group;
  std::set<std::string> made_of;  ///< objects that properties name, but for what it is attached to
  bool is_visible = true;
  bool is_place_of_group = false;  ///< moves its group
  bool links_other_file = false;
  bool is_array_of_links = false;
  bool keeps_place_of_linked = false;
};

bool is_body(const Object& object) {
  return object.type.starts_with("PartDesign::Body");
}

/// Returns whether an object has a shape that is part of what is drawn, not a help to draw it.
bool has_shape(const Object& object) {
  constexpr std::array<std::string_view, 9> kHelps = {"Sketcher::",
                                                      "PartDesign::Plane",
                                                      "PartDesign::Line",
                                                      "PartDesign::Point",
                                                      "PartDesign::CoordinateSystem",
                                                      "PartDesign::ShapeBinder",
                                                      "PartDesign::SubShapeBinder",
                                                      "Part::Datum",
                                                      "Part::LocalCoordinateSystem"};
  return !object.shape.empty() && std::ranges::none_of(kHelps, [&object](std::string_view type) {
    return object.type.starts_with(type);
  });
}

class DocumentReader {
 public:
  DocumentReader(const InputFile& file, const ZipArchive& archive) : file_(file) {
    read_xml(file, kDocument, archive.read(kDocument),
             {[this](const XmlElement& element) { begin(element); },
              [this](std::string_view, std::string_view name) { end(name); }});
    has_gui_ = archive.holds(kGui);
    if (has_gui_)
      read_xml(file, kGui, archive.read(kGui),
               {[this](const XmlElement& element) { begin_of_view(element); },
                [this](std::string_view, std::string_view name) { end(name); }});
  }

  const std::map<std::string, Object>& objects() const { return objects_; }
  const std::vector<std::string>& order() const { return order_; }
  bool has_gui() const { return has_gui_; }

 private:
  void begin(const XmlElement& element) {
    if (element.name == "Object") return begin_object(element);
    if (current_ == nullptr) return;
    if (element.name == "Property") property_ = element.value("name");
    if (element.name == "Extension" && element.value("type").ends_with("GroupExtension"))
      current_->is_place_of_group |= element.value("type") != "App::GroupExtension";
    if (property_.empty()) return;
    if (element.name == "PropertyPlacement" && (property_ == "Placement" || property_ == "LinkPlacement"))
      current_->place = placement_of(element);
    if (property_ == "Shape" && !element.value("file").empty()) current_->shape = element.value("file");
    if (element.name == "Bool") take_flag(element);
    if (property_ == "ElementCount" && element.name == "Integer")
      current_->is_array_of_links = element.value("value") != "0";
    if (element.name == "Link" || element.name == "LinkSub") take_link(element.value("value"));
    if (element.name == "XLink" || element.name == "XLinkSub") {
      if (property_ == "LinkedObject") current_->links_other_file = !element.value("file").empty();
      take_link(element.value("name"));
    }
  }

  /// Objects are listed with their types first, then again with their properties.
  void begin_object(const XmlElement& element) {
    const std::string name(element.value("name"));
    const auto [place, is_new] = objects_.try_emplace(name);
    if (is_new) order_.push_back(name);
    if (!element.value("type").empty()) place->second.type = element.value("type");
    current_ = &place->second;
  }

  void begin_of_view(const XmlElement& element) {
    if (element.name == "ViewProvider") {
      const auto found = objects_.find(std::string(element.value("name")));
      current_ = found == objects_.end() ? nullptr : &found->second;
    } else if (current_ != nullptr && element.name == "Property") {
      property_ = element.value("name");
    } else if (current_ != nullptr && element.name == "Bool") {
      take_flag(element);
    }
  }

  void end(std::string_view name) {
    if (name == "Property") property_.clear();
    if (name == "Object" || name == "ViewProvider") current_ = nullptr;
  }

  void take_flag(const XmlElement& element) {
    const bool is_set = element.value("value") == "true";
    if (property_ == "Visibility") current_->is_visible = is_set;
    if (property_ == "LinkTransform") current_->keeps_place_of_linked = is_set;
  }

  void take_link(std::string_view name) {
    constexpr std::array<std::string_view, 4> kNoParts = {"AttachmentSupport", "Support", "Origin", "Tip"};
    if (name.empty()) return;
    if (property_ == "Group") {
      current_->group.emplace_back(name);
    } else if (property_ == "LinkedObject") {
      current_->linked = name;
    } else if (std::ranges::find(kNoParts, property_) == kNoParts.end()) {
      current_->made_of.emplace(name);
    }
  }

  Placement placement_of(const XmlElement& element) const {
    const auto number = [&](std::string_view attribute) {
      const std::string_view text = element.value(attribute);
      double value = 0;
      const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (code != std::errc() || stop != text.data() + text.size() || !std::isfinite(value))
        fail_in_part(file_, kDocument, element.line,
                     fmt::format("{} in a placement instead of a number", in_quotes(text)));
      return value;
    };
    const Quaternion turn{number("Q3"), number("Q0"), number("Q1"), number("Q2")};
    const double square = turn.w * turn.w + turn.x * turn.x + turn.y * turn.y + turn.z * turn.z;
    if (!(square > 0) || !std::isfinite(square))
      fail_in_part(file_, kDocument, element.line, "a placement has no rotation");
    return {normalised(turn), {number("Px"), number("Py"), number("Pz")}};
  }

  const InputFile& file_;
  std::map<std::string, Object> objects_;
  std::vector<std::string> order_;
  bool has_gui_ = false;
  Object* current_ = nullptr;
  std::string property_;  ///< of the current object; empty between properties
};

/// Collects the shapes of what is shown.
class ShownShapes {
 public:
  ShownShapes(const DocumentReader& document, const ZipArchive& archive)
      : document_(document), archive_(archive) {
    for (const auto& [name, object] : document.objects()) {
      if (object.is_place_of_group) held_.insert(object.group.begin(), object.group.end());
      if (has_shape(object)) parts_.insert(object.made_of.begin(), object.made_of.end());
    }
    for (const std::string& name : document.order())
      if (!held_.contains(name) && is_shown(name)) add(name, {}, true, 0);
  }

  FreeCadShapes result() && {
    if (shapes_.placed_breps.empty())
      throw Error(
          ErrorKind::kInput,
          {archive_.file().name(), "",
           "shows nothing: no object that is visible has a shape; make the part visible in FreeCAD, and "
           "save it"});
    if (missing_ > 0)
      shapes_.warnings.emplace_back(
          WarningKind::kMissingParts,
          fmt::format(
              "links to other documents and arrays of links, which are not read, so they are missing: {}; "
              "export the document as STEP in FreeCAD to have them",
              missing_));
    return std::move(shapes_);
  }

 private:
  bool is_shown(const std::string& name) const {
    const auto found = document_.objects().find(name);
    if (found == document_.objects().end()) return false;
    return document_.has_gui() ? found->second.is_visible : !parts_.contains(name);
  }

  /// Adds what an object shows. `keeps_place`: whether its own placement counts.
  void add(const std::string& name, const Placement& outer, bool keeps_place, int depth) {
    const auto found = document_.objects().find(name);
    if (found == document_.objects().end()) return;
    if (depth > kDeepestLinks || ++shown_ > kMostShown)
      throw Error(ErrorKind::kInput,
                  {archive_.file().name(), in_quotes(name),
                   "shows parts and links nested too deeply, or too many", Remedy::kExportAgain});
    const Object& object = found->second;
    if (!object.linked.empty()) {
      if (object.links_other_file || object.is_array_of_links) {
        ++missing_;
        return;
      }
      add(object.linked, outer * object.place, object.keeps_place_of_linked, depth + 1);
    } else if (object.is_place_of_group && !is_body(object)) {
      const Placement place = keeps_place ? outer * object.place : outer;
      for (const std::string& member : object.group)
        if (is_shown(member)) add(member, place, true, depth + 1);
    } else if (has_shape(object)) {
      add_shape(object.shape, keeps_place ? outer : outer * inverse(object.place));
    }
  }

  void add_shape(const std::string& member, const Placement& place) {
    PlacedBrep shape{
        {place.turn.w, place.turn.x, place.turn.y, place.turn.z}, place.move, archive_.read(member)};
    if (shape.brep.empty()) return;
    const double bytes = static_cast<double>(shapes_.placed_breps.size() + shape.brep.size());
    require_read_memory(archive_.file().name(), 2 * bytes);
    append_brep(shapes_.placed_breps, shape);
  }

  const DocumentReader& document_;
  const ZipArchive& archive_;
  std::set<std::string> held_;   ///< by objects that move them, or are made of them
  std::set<std::string> parts_;  ///< what shapes are made of
  std::size_t shown_ = 0, missing_ = 0;
  FreeCadShapes shapes_;
};

}  // namespace

FreeCadShapes read_freecad_document(const InputFile& file) {
  const ZipArchive archive(file);
  return ShownShapes(DocumentReader(file, archive), archive).result();
}

}  // namespace crossgrain
