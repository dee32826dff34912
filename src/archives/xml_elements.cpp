// SPDX-License-Identifier: Apache-2.0
#include "archives/xml_elements.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <utility>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

/// Between namespace and name: no character of a URI.
constexpr char kBetween = '|';

std::pair<std::string_view, std::string_view> space_and_name(std::string_view both) {
  const std::size_t at = both.rfind(kBetween);
  if (at == std::string_view::npos) return {{}, both};
  return {both.substr(0, at), both.substr(at + 1)};
}

class Reader {
 public:
  explicit Reader(const XmlUse& use)
      : use_(use), parser_(XML_ParserCreateNS(nullptr, kBetween), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(),
        [](void* self, const char* name, const char** attributes) {
          static_cast<Reader*>(self)->begin(name, attributes);
        },
        [](void* self, const char* name) { static_cast<Reader*>(self)->end(name); });
    XML_SetStartDoctypeDeclHandler(parser_.get(), [](void* self, const char*, const char*, const char*, int) {
      static_cast<Reader*>(self)->refuse_type();
    });
  }

  /// Returns what is wrong; empty if nothing is.
  std::string read(std::string_view text) {
    constexpr std::size_t kPiece = 1 << 20;
    bool is_last = false;
    while (!is_last) {
      check_watched();
      const std::size_t count = std::min(kPiece, text.size());
      is_last = count == text.size();
      const auto status = XML_Parse(parser_.get(), text.data(), static_cast<int>(count), is_last);
      if (thrown_) std::rethrow_exception(thrown_);
      if (has_type_) return "declares the type of its document";
      if (status != XML_STATUS_OK)
        return fmt::format("is no sound XML: {}", XML_ErrorString(XML_GetErrorCode(parser_.get())));
      text.remove_prefix(count);
    }
    return "";
  }

  std::size_t line() const { return XML_GetCurrentLineNumber(parser_.get()); }

 private:
  /// Exceptions must not pass through expat, which is C.
  template <class Body>
  void keep_exceptions(const Body& body) {
    if (thrown_ || has_type_) return;
    try {
      body();
    } catch (...) {
      thrown_ = std::current_exception();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }

  void begin(const char* name, const char** attributes) {
    keep_exceptions([&] {
      const auto [space, local] = space_and_name(name);
      use_.begin({space, local, attributes, line()});
    });
  }

  void end(const char* name) {
    if (!use_.end) return;
    keep_exceptions([&] {
      const auto [space, local] = space_and_name(name);
      use_.end(space, local);
    });
  }

  void refuse_type() {
    has_type_ = true;
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  const XmlUse& use_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::exception_ptr thrown_;
  bool has_type_ = false;
};

}  // namespace

std::string_view XmlElement::value(std::string_view attribute, std::string_view of_space) const {
  for (const char** pair = attributes; *pair != nullptr; pair += 2) {
    const auto [its_space, its_name] = space_and_name(*pair);
    if (its_name == attribute && its_space == of_space) return pair[1];
  }
  return {};
}

void fail_in_part(const InputFile& file, std::string_view part, std::size_t line, const std::string& text) {
  throw Error(ErrorKind::kInput,
              {file.name(), fmt::format("{}, line {}", in_quotes(part), line), text, Remedy::kExportAgain});
}

void read_xml(const InputFile& file, std::string_view part, std::string_view text, const XmlUse& use) {
  Reader reader(use);
  const std::string fault = reader.read(text);
  if (!fault.empty()) fail_in_part(file, part, reader.line(), fault);
}

}  // namespace crossgrain
