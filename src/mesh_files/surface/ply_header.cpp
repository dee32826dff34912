// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/surface/ply_header.hpp"

#include <fmt/format.h>

#include <array>

#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

constexpr std::array kPlyTypeNames = {
    NumberTypeName{"char", NumberType::kInt8},      NumberTypeName{"int8", NumberType::kInt8},
    NumberTypeName{"uchar", NumberType::kUint8},    NumberTypeName{"uint8", NumberType::kUint8},
    NumberTypeName{"short", NumberType::kInt16},    NumberTypeName{"int16", NumberType::kInt16},
    NumberTypeName{"ushort", NumberType::kUint16},  NumberTypeName{"uint16", NumberType::kUint16},
    NumberTypeName{"int", NumberType::kInt32},      NumberTypeName{"int32", NumberType::kInt32},
    NumberTypeName{"uint", NumberType::kUint32},    NumberTypeName{"uint32", NumberType::kUint32},
    NumberTypeName{"float", NumberType::kFloat32},  NumberTypeName{"float32", NumberType::kFloat32},
    NumberTypeName{"double", NumberType::kFloat64}, NumberTypeName{"float64", NumberType::kFloat64},
};

NumberType parse_type(const TextScanner& scanner, std::string_view word) {
  if (const auto type = type_named(kPlyTypeNames, word)) return *type;
  scanner.fail(in_quotes(word) + " is not a PLY type");
}

PlyEncoding parse_encoding(const TextScanner& scanner, std::string_view word) {
  if (word == "ascii") return PlyEncoding::kAscii;
  if (word == "binary_little_endian") return PlyEncoding::kLittleEndian;
  if (word == "binary_big_endian") return PlyEncoding::kBigEndian;
  scanner.fail(in_quotes(word) +
               " is not a PLY format: choose ascii, binary_little_endian or binary_big_endian");
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
    if (!is_integer(property.count_type)) scanner.fail("a list whose length is not a whole number");
    word = scanner.word();
  }
  property.type = parse_type(scanner, word);
  property.name = scanner.word();
  return property;
}

}  // namespace

std::size_t PlyElement::least_row_bytes() const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes += size_of(property.is_list ? property.count_type : property.type);
  return bytes;
}

PlyHeader read_ply_header(const InputFile& file) {
  TextScanner scanner(file, {});
  if (scanner.word() != "ply")
    scanner.fail("the first line is not 'ply': this is not a PLY file", Remedy::kExportAgain);
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
      scanner.fail(in_quotes(keyword) + " is not a keyword of a PLY header");
    }
  }
  if (!has_format) scanner.fail("the header names no format, such as 'format ascii 1.0'");
  scanner.next_line();
  header.body_begin = scanner.position();
  header.body_line = scanner.line();
  return header;
}

}  // namespace crossgrain
