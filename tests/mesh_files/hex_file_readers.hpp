// SPDX-License-Identifier: Apache-2.0
// Readers of files of hexahedra for tests, line by line as their formats are defined, which stop at the first
// thing that they do not expect.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "crossgrain/types.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {

using HexCorners = std::array<std::uint32_t, 8>;
using QuadCorners = std::array<std::uint32_t, 4>;

/// What a file says, with indices from 0.
struct ReadHexFile {
  std::vector<Vector3> vertices;
  std::vector<HexCorners> hexahedra;
  std::vector<std::string> hex_groups;  ///< of each hexahedron: name of the group or reference number
  std::vector<QuadCorners> quads;
  std::vector<std::string> quad_groups;
};

class LinesOfFile {
 public:
  explicit LinesOfFile(const std::filesystem::path& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) lines_.push_back(line);
  }

  bool is_at_end() const { return next_ == lines_.size(); }
  const std::string& peek() const { return lines_.at(next_); }
  const std::string& take() { return lines_.at(next_++); }
  void expect(const std::string& line) {
    if (take() != line) throw std::runtime_error("expected '" + line + "', not '" + lines_[next_ - 1] + "'");
  }

  /// The numbers of a line, which has no others.
  template <class T>
  std::vector<T> numbers(std::size_t count, char separator = ' ') {
    std::string line = take();
    for (char& c : line)
      if (c == separator) c = ' ';
    std::istringstream words(line);
    std::vector<T> numbers;
    for (std::string word; words >> word;) {
      std::istringstream in(word);
      if constexpr (std::is_floating_point_v<T>) {
        numbers.push_back(std::strtod(word.c_str(), nullptr));  // also of subnormal numbers
      } else {
        T number;
        if (!(in >> number) || !in.eof()) throw std::runtime_error("no number: " + word);
        numbers.push_back(number);
      }
    }
    if (count > 0 && numbers.size() != count) throw std::runtime_error("wrong number of numbers: " + line);
    return numbers;
  }

 private:
  std::vector<std::string> lines_;
  std::size_t next_ = 0;
};

template <std::size_t N>
std::array<std::uint32_t, N> corners_from(const std::vector<std::int64_t>& numbers, std::size_t first) {
  std::array<std::uint32_t, N> corners;
  for (std::size_t k = 0; k < N; ++k) corners[k] = static_cast<std::uint32_t>(numbers.at(first + k) - 1);
  return corners;
}

inline ReadHexFile read_medit(const std::filesystem::path& path) {
  LinesOfFile lines(path);
  lines.expect("MeshVersionFormatted 2");
  ReadHexFile read;
  for (std::string keyword; keyword != "End";) {
    keyword = lines.take();
    if (keyword.empty() || keyword[0] == '#' || keyword == "Dimension 3" || keyword == "End") continue;
    for (auto count = lines.numbers<std::size_t>(1)[0]; count > 0; --count) {
      if (keyword == "Vertices") {
        const auto row = lines.numbers<double>(4);
        read.vertices.push_back({row[0], row[1], row[2]});
      } else if (keyword == "Quadrilaterals") {
        const auto row = lines.numbers<std::int64_t>(5);
        read.quads.push_back(corners_from<4>(row, 0));
        read.quad_groups.push_back(std::to_string(row[4]));
      } else if (keyword == "Hexahedra") {
        const auto row = lines.numbers<std::int64_t>(9);
        read.hexahedra.push_back(corners_from<8>(row, 0));
        read.hex_groups.push_back(std::to_string(row[8]));
      } else {
        throw std::runtime_error("unknown section " + keyword);
      }
    }
  }
  if (!lines.is_at_end()) throw std::runtime_error("lines after the end");
  return read;
}

/// A file of Gmsh 4.1 in text, with what only it has.
class GmshHexFile {
 public:
  struct Entity {
    std::array<double, 6> box;
    std::string group;
    std::vector<std::int32_t> boundary;
  };

  explicit GmshHexFile(const std::filesystem::path& path) : lines_(path) {
    lines_.expect("$MeshFormat");
    lines_.expect("4.1 0 8");
    lines_.expect("$EndMeshFormat");
    lines_.expect("$Comments");
    lines_.take();
    lines_.expect("$EndComments");
    read_names();
    read_entities();
    read_nodes();
    read_elements();
    if (!lines_.is_at_end()) throw std::runtime_error("lines after the end");
  }

  /// By dimension and number.
  std::map<std::pair<int, int>, Entity> entities;
  std::map<std::pair<int, int>, std::string> names;
  std::map<std::pair<int, int>, std::vector<std::uint32_t>> nodes;
  ReadHexFile read;

 private:
  void read_names() {
    lines_.expect("$PhysicalNames");
    for (auto count = lines_.numbers<int>(1)[0]; count > 0; --count) {
      std::istringstream line(lines_.take());
      int dimension, number;
      std::string name;
      line >> dimension >> number >> std::ws;
      std::getline(line, name);
      if (name.size() < 2 || name.front() != '"' || name.back() != '"' || names.contains({dimension, number}))
        throw std::runtime_error("bad name " + name);
      names[{dimension, number}] = name.substr(1, name.size() - 2);
    }
    lines_.expect("$EndPhysicalNames");
  }

  void read_entities() {
    lines_.expect("$Entities");
    const auto counts = lines_.numbers<int>(4);
    if (counts[0] != 0 || counts[1] != 0) throw std::runtime_error("points or curves");
    for (const int dimension : {2, 3})
      for (int k = 0; k < counts[static_cast<std::size_t>(dimension)]; ++k) {
        const auto row = lines_.numbers<double>(0);
        Entity entity;
        for (std::size_t a = 0; a < 6; ++a) entity.box[a] = row.at(1 + a);
        if (row.at(7) != 1) throw std::runtime_error("not one group");
        entity.group = names.at({dimension, static_cast<int>(row.at(8))});
        const auto bounds = static_cast<std::size_t>(row.at(9));
        for (std::size_t b = 0; b < bounds; ++b)
          entity.boundary.push_back(static_cast<std::int32_t>(row.at(10 + b)));
        if (row.size() != 10 + bounds) throw std::runtime_error("wrong number of surfaces");
        if (!entities.emplace(std::pair{dimension, static_cast<int>(row[0])}, entity).second)
          throw std::runtime_error("an entity twice");
      }
    lines_.expect("$EndEntities");
  }

  void read_nodes() {
    lines_.expect("$Nodes");
    const auto head = lines_.numbers<std::size_t>(4);
    read.vertices.resize(head[1]);
    std::set<std::size_t> seen;
    for (std::size_t block = 0; block < head[0]; ++block) {
      const auto row = lines_.numbers<int>(4);
      entities.at({row[0], row[1]});
      std::vector<std::size_t> numbers;
      for (int k = 0; k < row[3]; ++k) numbers.push_back(lines_.numbers<std::size_t>(1)[0]);
      for (const std::size_t number : numbers) {
        if (number < head[2] || number > head[3] || !seen.insert(number).second)
          throw std::runtime_error("wrong number of a node");
        const auto place = lines_.numbers<double>(3);
        read.vertices.at(number - 1) = {place[0], place[1], place[2]};
        nodes[{row[0], row[1]}].push_back(static_cast<std::uint32_t>(number - 1));
      }
    }
    if (seen.size() != head[1]) throw std::runtime_error("nodes are missing");
    lines_.expect("$EndNodes");
  }

  void read_elements() {
    lines_.expect("$Elements");
    const auto head = lines_.numbers<std::size_t>(4);
    std::map<std::int64_t, std::pair<QuadCorners, std::string>> quads;
    std::map<std::int64_t, std::pair<HexCorners, std::string>> hexahedra;
    for (std::size_t block = 0; block < head[0]; ++block) {
      const auto row = lines_.numbers<int>(4);
      const std::string& group = entities.at({row[0], row[1]}).group;
      if (row[2] != (row[0] == 2 ? 3 : 5)) throw std::runtime_error("wrong type of elements");
      for (int k = 0; k < row[3]; ++k) {
        if (row[0] == 2) {
          const auto element = lines_.numbers<std::int64_t>(5);
          quads[element[0]] = {corners_from<4>(element, 1), group};
        } else {
          const auto element = lines_.numbers<std::int64_t>(9);
          hexahedra[element[0]] = {corners_from<8>(element, 1), group};
        }
      }
    }
    for (const auto& [number, quad] : quads) {
      read.quads.push_back(quad.first);
      read.quad_groups.push_back(quad.second);
    }
    for (const auto& [number, hexahedron] : hexahedra) {
      if (quads.contains(number)) throw std::runtime_error("two elements of one number");
      read.hexahedra.push_back(hexahedron.first);
      read.hex_groups.push_back(hexahedron.second);
    }
    if (read.quads.size() + read.hexahedra.size() != head[1])
      throw std::runtime_error("elements are missing");
    lines_.expect("$EndElements");
  }

  LinesOfFile lines_;
};

/// A file of Abaqus; numbers from 1 as in the file.
struct AbaqusFile {
  explicit AbaqusFile(const std::filesystem::path& path) {
    LinesOfFile lines(path);
    while (!lines.is_at_end()) {
      const std::string keyword = lines.take();
      if (keyword.starts_with("**")) continue;
      if (keyword.size() < 2 || keyword[0] != '*') throw std::runtime_error("no keyword: " + keyword);
      while (!lines.is_at_end() && lines.peek()[0] != '*') read_line(keyword, lines);
    }
  }

  ReadHexFile read;
  std::map<std::string, std::vector<std::int64_t>> node_sets, element_sets;

  /// Element and label of a face.
  std::map<std::string, std::vector<std::pair<std::int64_t, int>>> surfaces;

 private:
  static std::string value_behind(const std::string& keyword, const std::string& begin) {
    return keyword.substr(begin.size(), keyword.find(',', begin.size()) - begin.size());
  }

  void read_line(const std::string& keyword, LinesOfFile& lines) {
    const std::string elements = "*ELSET, ELSET=", nodes = "*NSET, NSET=", surface = "*SURFACE, NAME=";
    if (keyword == "*NODE, NSET=ALL") {
      const auto row = lines.numbers<double>(4, ',');
      read.vertices.push_back({row[1], row[2], row[3]});
      if (row[0] != static_cast<double>(read.vertices.size())) throw std::runtime_error("number of a node");
    } else if (keyword == "*ELEMENT, TYPE=C3D8I, ELSET=ALL") {
      const auto row = lines.numbers<std::int64_t>(9, ',');
      read.hexahedra.push_back(corners_from<8>(row, 1));
      if (row[0] != static_cast<std::int64_t>(read.hexahedra.size()))
        throw std::runtime_error("number of an element");
    } else if (keyword.starts_with(elements) || keyword.starts_with(nodes)) {
      const auto row = lines.numbers<std::int64_t>(0, ',');
      if (row.size() > 16) throw std::runtime_error("more than 16 entries in a line");
      auto& set = keyword.starts_with(nodes) ? node_sets[value_behind(keyword, nodes)]
                                             : element_sets[value_behind(keyword, elements)];
      set.insert(set.end(), row.begin(), row.end());
    } else if (keyword.starts_with(surface) && keyword.ends_with(", TYPE=ELEMENT")) {
      const std::string line = lines.take();
      const std::size_t comma = line.find(",S");
      surfaces[value_behind(keyword, surface)].emplace_back(std::stoll(line.substr(0, comma)),
                                                            std::stoi(line.substr(comma + 2)));
    } else {
      throw std::runtime_error("unknown keyword: " + keyword);
    }
  }
};

inline ReadHexFile read_vtu_hexahedra(const VtuFile& file) {
  ReadHexFile read;
  read.vertices = file.read_points(1e300);
  const auto corners = file.read<std::int32_t>(VtuSection::kCells, "connectivity", 1);
  const auto ends = file.read<std::int32_t>(VtuSection::kCells, "offsets", 1);
  const auto types = file.read<std::uint8_t>(VtuSection::kCells, "types", 1);
  for (std::size_t h = 0; h < types.size(); ++h) {
    if (types[h] != 12 || static_cast<std::size_t>(ends.at(h)) != 8 * (h + 1))
      throw std::runtime_error("not a hexahedron");
    HexCorners hexahedron;
    for (std::size_t k = 0; k < 8; ++k) hexahedron[k] = static_cast<std::uint32_t>(corners.at(8 * h + k));
    read.hexahedra.push_back(hexahedron);
  }
  return read;
}

}  // namespace crossgrain
