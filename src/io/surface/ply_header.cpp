// SPDX-License-Identifier: Apache-2.0
#include "io/surface/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/text/text_scanner.hpp"

namespace crossgrain {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array kTypeNames = {
    TypeName{"char", PlyType::kInt8},      TypeName{"int8", PlyType::kInt8},
    TypeName{"uchar", PlyType::kUint8},    TypeName{"uint8", PlyType::kUint8},
    TypeName{"short", PlyType::kInt16},    TypeName{"int16", PlyType::kInt16},
    TypeName{"ushort", PlyType::kUint16},  TypeName{"uint16", PlyType::kUint16},
    TypeName{"int", PlyType::kInt32},      TypeName{"int32", PlyType::kInt32},
    TypeName{"uint", PlyType::kUint32},    TypeName{"uint32", PlyType::kUint32},
    TypeName{"float", PlyType::kFloat32},  TypeName{"float32", PlyType::kFloat32},
    TypeName{"double", PlyType::kFloat64}, TypeName{"float64", PlyType::kFloat64},
};

PlyType parse_type(const TextScanner& scanner, std::string_view word) {
  for (const TypeName& entry : kTypeNames) {
    if (entry.name == word) return entry.type;
  }
  scanner.fail(in_quotes(word) + " is no type of PLY");
}

PlyEncoding parse_encoding(const TextScanner& scanner, std::string_view word) {
  if (word == "ascii") return PlyEncoding::kAscii;
  if (word == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (word == "binary_big_endian") return PlyEncoding::kBigEndian;
  scanner.fail(in_quotes(word) + " is no format of PLY: ascii, binary_little_endian or binary_big_endian");
}

PlyElement parse_element(TextScanner& scanner) {
  PlyElement element;
  element.name = scanner.word();
  const std::int64_t count = scanner.integer(scanner.word(), "the number of elements");
  if (count < 0) scanner.fail(fmt::format("{} elements", count));
  element.count = static_cast<std::uint64_t>(count);
  return element;
}

PlyProperty parse_property(TextScanner& scanner) {
  PlyProperty property;
  std::string_view word = scanner.word();
  if (word == "list") {
    property.is_list = true;
    property.count_type = parse_type(scanner, scanner.word());
    if (property.count_type == PlyType::kFloat32 || property.count_type == PlyType::kFloat64)
      scanner.fail("a list whose length is no whole number");
    word = scanner.word();
  }
  property.type = parse_type(scanner, word);
  property.name = scanner.word();
  return property;
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32:
      return 4;
    case PlyType::kFloat64:
      return 8;
  }
  return 0;
}

std::size_t PlyElement::least_row_bytes() const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes += size_of(property.is_list ? property.count_type : property.type);
  return bytes;
}

bool PlyElement::has_list() const {
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& p) { return p.is_list; });
}

PlyHeader read_ply_header(const InputFile& file) {
  TextScanner scanner(file, {});
  if (scanner.word() != "ply")
    scanner.fail("the first line is not 'ply': this is no PLY file", Remedy::kExportAgain);
  PlyHeader header;
  bool has_format = false;
  for (;;) {
    if (!scanner.next_line()) scanner.fail("the header has no end_header", Remedy::kCopyAgain);
    const std::string_view keyword = scanner.word();
    if (keyword == "end_header") break;
    if (keyword == "format") {
      header.encoding = parse_encoding(scanner, scanner.word());
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(parse_element(scanner));
    } else if (keyword == "property") {
      if (header.elements.empty()) scanner.fail("a property of no element");
      header.elements.back().properties.push_back(parse_property(scanner));
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
      scanner.fail(in_quotes(keyword) + " is no word of a PLY header");
    }
  }
  if (!has_format) scanner.fail("the header names no format, such as 'format ascii 1.0'");
  scanner.next_line();
  header.body_begin = scanner.position();
  header.body_line = scanner.line();
  return header;
}

}  // namespace crossgrain
