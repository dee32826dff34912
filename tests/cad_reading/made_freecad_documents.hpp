// SPDX-License-Identifier: Apache-2.0
// Documents of FreeCAD as text, like those that version 0.20 saves.
#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain {

struct FreeCadText {
  std::string type, name;
  std::string shape = {};  ///< its member; none if empty
  std::array<double, 3> move = {};
  std::array<double, 4> turn = {0, 0, 0, 1};  ///< x, y, z, w
  std::vector<std::string> group = {};
  std::string linked = {};
  std::vector<std::pair<std::string, std::string>> links = {};  ///< properties, and what they name
  std::string other = {};                                       ///< properties as text
};

inline std::string property_text(const std::string& name, const std::string& type, const std::string& value) {
  return fmt::format("<Property name=\"{}\" type=\"App::Property{}\">{}</Property>\n", name, type, value);
}

inline std::string object_text(const FreeCadText& object) {
  std::string text = fmt::format("<Object name=\"{}\">\n", object.name);
  if (object.type == "App::Part" || object.type == "PartDesign::Body")
    text +=
        "<Extensions Count=\"1\"><Extension type=\"App::OriginGroupExtension\" name=\"a\"/></Extensions>\n";
  text += "<Properties Count=\"1\">\n";
  const auto& [x, y, z] = object.move;
  const auto& [q0, q1, q2, q3] = object.turn;
  text += property_text(
      object.linked.empty() ? "Placement" : "LinkPlacement", "Placement",
      fmt::format(
          "<PropertyPlacement Px=\"{}\" Py=\"{}\" Pz=\"{}\" Q0=\"{}\" Q1=\"{}\" Q2=\"{}\" Q3=\"{}\"/>", x, y,
          z, q0, q1, q2, q3));
  if (!object.shape.empty())
    text += fmt::format(
        "<Property name=\"Shape\" type=\"Part::PropertyPartShape\"><Part file=\"{}\"/></Property>\n",
        object.shape);
  if (!object.linked.empty())
    text +=
        property_text("LinkedObject", "XLink", fmt::format("<XLink file=\"\" name=\"{}\"/>", object.linked));
  for (const auto& [property, name] : object.links)
    text += property_text(property, "Link", fmt::format("<Link value=\"{}\"/>", name));
  std::string members;
  for (const std::string& member : object.group) members += fmt::format("<Link value=\"{}\"/>", member);
  if (!members.empty())
    text += property_text("Group", "LinkList", fmt::format("<LinkList count=\"1\">{}</LinkList>", members));
  return text + object.other + "</Properties></Object>\n";
}

/// Document.xml.
inline std::string document_of(const std::vector<FreeCadText>& objects) {
  std::string list, data;
  for (const FreeCadText& object : objects) {
    list += fmt::format("<Object type=\"{}\" name=\"{}\" id=\"1\" />\n", object.type, object.name);
    data += object_text(object);
  }
  return "<?xml version='1.0' encoding='utf-8'?>\n<!-- FreeCAD Document -->\n<Document SchemaVersion=\"4\">\n"
         "<Objects Count=\"1\">\n" +
         list + "</Objects>\n<ObjectData Count=\"1\">\n" + data + "</ObjectData>\n</Document>\n";
}

/// GuiDocument.xml: which objects are visible.
inline std::string gui_of(const std::vector<std::pair<std::string, bool>>& objects) {
  std::string text =
      "<?xml version='1.0' encoding='utf-8'?>\n<Document SchemaVersion=\"1\"><ViewProviderData>\n";
  for (const auto& [name, is_visible] : objects)
    text += fmt::format("<ViewProvider name=\"{}\"><Properties>{}{}</Properties></ViewProvider>\n", name,
                        property_text("Selectable", "Bool", "<Bool value=\"true\"/>"),
                        property_text("Visibility", "Bool", fmt::format("<Bool value=\"{}\"/>", is_visible)));
  return text + "</ViewProviderData></Document>\n";
}

}  // namespace crossgrain
