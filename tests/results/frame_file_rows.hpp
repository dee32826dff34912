// SPDX-License-Identifier: Apache-2.0
// Readers of the files of frames, from what docs/formats.md says of each and with nothing of the library.
// Each takes a file only where it is complete and has nothing else in it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace frame_files {

using Row = std::vector<double>;

/// Where axis k of a frame goes in another: as its axis |p_k|, counted from 1, times the sign of p_k.
using Permutation = std::array<int, 3>;

struct PermFile {
  std::size_t tets = 0;

  /// In the order of the file.
  std::vector<std::pair<std::array<std::uint32_t, 2>, Permutation>> rows;
};

inline std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  std::string text = content.str();
  if (!file || text.empty() || text.back() != '\n') throw std::runtime_error("no whole lines");
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The numbers of a line with one blank between each.
inline Row numbers_of(const std::string& line, std::size_t count) {
  Row numbers;
  const char* at = line.c_str();
  while (true) {
    char* end = nullptr;
    numbers.push_back(std::strtod(at, &end));
    if (end == at) throw std::runtime_error("no number: " + line);
    at = end;
    if (*at == '\0') break;
    if (*at++ != ' ' || *at == ' ' || *at == '\0') throw std::runtime_error("blanks: " + line);
  }
  if (numbers.size() != count) throw std::runtime_error("another number of numbers: " + line);
  return numbers;
}

inline void expect(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

/// Lines of `count` numbers, from line `first` to before the last `after`.
inline std::vector<Row> rows_of(const std::vector<std::string>& lines, std::size_t first, std::size_t after,
                                std::size_t count) {
  std::vector<Row> rows;
  for (std::size_t i = first; i + after < lines.size(); ++i) rows.push_back(numbers_of(lines[i], count));
  return rows;
}

/// Nine numbers a tet, axis by axis.
inline std::vector<Row> read_fra(const std::filesystem::path& path) {
  const std::vector<std::string> lines = lines_of(path);
  expect(lines.size() >= 2 && lines[0] == "FRA 1", "no FRA 1");
  const Row header = numbers_of(lines[1], 3);
  expect(header[1] == 3 && header[2] == 1, "not three axes");
  const std::vector<Row> axes = rows_of(lines, 2, 0, 3);
  expect(static_cast<double>(axes.size()) == 3 * header[0], "another number of rows");
  std::vector<Row> frames(axes.size() / 3);
  for (std::size_t i = 0; i < axes.size(); ++i)
    frames[i / 3].insert(frames[i / 3].end(), axes[i].begin(), axes[i].end());
  return frames;
}

struct MeditFile {
  std::vector<Row> vertices;  ///< x y z, reference
  std::vector<Row> tets;      ///< four vertices, counted from 1, and the reference
};

/// A Medit mesh of vertices and tets with nothing else.
inline MeditFile read_medit(const std::filesystem::path& path) {
  const std::vector<std::string> lines = lines_of(path);
  expect(lines.size() > 7 && lines[0] == "MeshVersionFormatted 2" && lines[1] == "Dimension 3" &&
             lines[2] == "Vertices" && lines.back() == "End",
         "no Medit mesh");
  MeditFile file;
  const auto vertices = static_cast<std::size_t>(numbers_of(lines[3], 1)[0]);
  expect(lines.at(4 + vertices) == "Tetrahedra", "no Tetrahedra behind the vertices");
  file.vertices = rows_of(lines, 4, lines.size() - 4 - vertices, 4);
  file.tets = rows_of(lines, 6 + vertices, 1, 5);
  expect(numbers_of(lines[5 + vertices], 1)[0] == static_cast<double>(file.tets.size()),
         "another number of tets");
  return file;
}

inline std::vector<Row> read_frame(const std::filesystem::path& path) {
  const std::vector<std::string> lines = lines_of(path);
  expect(lines.size() >= 3 && lines.front() == "FRAME" && lines.back() == "END", "no FRAME and END");
  std::vector<Row> frames = rows_of(lines, 2, 1, 9);
  expect(numbers_of(lines[1], 1)[0] == static_cast<double>(frames.size()), "another number of frames");
  return frames;
}

inline std::vector<Row> read_quaternions(const std::filesystem::path& path) {
  return rows_of(lines_of(path), 0, 0, 4);
}

inline PermFile read_perm(const std::filesystem::path& path) {
  const std::vector<std::string> lines = lines_of(path);
  expect(lines.size() >= 2 && lines[0] == "PERM 1", "no PERM 1");
  const Row header = numbers_of(lines[1], 3);
  expect(header[2] == 3, "not three axes");
  PermFile file;
  file.tets = static_cast<std::size_t>(header[0]);
  for (const Row& row : rows_of(lines, 2, 0, 5)) {
    for (const double number : row)
      expect(number == static_cast<double>(static_cast<long>(number)), "no integer");
    expect(row[0] >= 0 && row[1] >= 0 && row[0] < header[0] && row[1] < header[0], "no such tet");
    file.rows.push_back({{static_cast<std::uint32_t>(row[0]), static_cast<std::uint32_t>(row[1])},
                         {static_cast<int>(row[2]), static_cast<int>(row[3]), static_cast<int>(row[4])}});
  }
  expect(static_cast<double>(file.rows.size()) == header[1], "another number of faces");
  return file;
}

}  // namespace frame_files
