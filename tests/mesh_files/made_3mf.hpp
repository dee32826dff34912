// SPDX-License-Identifier: Apache-2.0
// Documents of 3MF made on the spot.
#pragma once

#include <fmt/format.h>

#include <string>

#include "archives/made_archives.hpp"
#include "mesh_files/surface_files.hpp"

namespace crossgrain {

inline const std::string k3mfRelationships =
    R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship )"
    R"(Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)"
    "</Relationships>";

/// <mesh> of tetrahedron().
inline std::string mesh_of_3mf() {
  std::string vertices, triangles;
  int next = 0;
  for (const auto& corners : tetrahedron()) {
    for (const auto& [x, y, z] : corners)
      vertices += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", x, y, z);
    triangles += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", next, next + 1, next + 2);
    next += 3;
  }
  return "<mesh><vertices>\n" + vertices + "</vertices><triangles>\n" + triangles + "</triangles></mesh>";
}

inline std::string object_of_3mf(const std::string& id, const std::string& content,
                                 const std::string& type = "model") {
  return fmt::format("<object id=\"{}\" type=\"{}\">{}</object>\n", id, type, content);
}

/// A part of a document with these objects, and items if it is the first one.
inline std::string part_of_3mf(const std::string& objects, const std::string& items,
                               const std::string& attributes = "unit=\"millimeter\"") {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model {} "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
      "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">\n"
      "<resources>\n{}</resources>\n<build>{}</build></model>\n",
      attributes, objects, items);
}

inline std::string made_3mf(const std::string& part, Members others = {}) {
  others.insert(others.begin(), {{"_rels/.rels", k3mfRelationships}, {"3D/3dmodel.model", part}});
  return zipped(others);
}

}  // namespace crossgrain
