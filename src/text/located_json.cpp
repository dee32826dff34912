// SPDX-License-Identifier: Apache-2.0
#include "text/located_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "base/parallel.hpp"
#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

/// Position of the parser in the text. The parser does not report lines, so its iterator tracks them.
class ReadPosition {
 public:
  explicit ReadPosition(std::string_view bytes) : bytes_(bytes) {}

  void advance() {
    ++read_;
    checkpoint_.pass();
  }

  /// Returns the 1-based line of the last token. To find the end of a number the parser has read one
  /// character more, possibly a line end; no token ends with one.
  std::size_t line() {
    for (const std::size_t end = read_ > 0 ? read_ - 1 : 0; counted_ < end; ++counted_) {
      const bool is_end =
          bytes_[counted_] == '\n' ||
          (bytes_[counted_] == '\r' && (counted_ + 1 == bytes_.size() || bytes_[counted_ + 1] != '\n'));
      if (!is_end) continue;
      ++line_;
      line_begin_ = counted_ + 1;
    }
    return line_;
  }

  /// Returns the 1-based column of the last character read.
  std::size_t column() { return line(), std::max<std::size_t>(read_, line_begin_ + 1) - line_begin_; }

 private:
  std::string_view bytes_;
  Checkpoint checkpoint_;
  std::size_t read_ = 0, counted_ = 0, line_ = 1, line_begin_ = 0;
};

/// Iterator over bytes that reports each advance to a ReadPosition.
class WatchedBytes {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  WatchedBytes(const char* at, ReadPosition* position) : at_(at), position_(position) {}

  reference operator*() const { return *at_; }
  WatchedBytes& operator++() {
    ++at_;
    position_->advance();
    return *this;
  }
  bool operator==(const WatchedBytes& other) const { return at_ == other.at_; }
  bool operator!=(const WatchedBytes& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  ReadPosition* position_;
};

/// The parser's message, without the position and its name for the exception.
std::string complaint_of(const nlohmann::json::exception& error) {
  std::string text = error.what();
  const std::size_t place = text.find(": syntax error"), detail = text.find(" - ");
  if (place != text.npos && detail != text.npos) text = text.substr(detail + 3);
  text = text.substr(0, text.find("; last read"));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return text;
}

}  // namespace

/// Receives the parser's events.
class LocatedJsonBuilder {
 public:
  LocatedJsonBuilder(LocatedJson& json, ReadPosition& position) : json_(json), position_(position) {}

  bool null() { return add(LocatedJson::Kind::kNull); }
  bool boolean(bool value) { return add(LocatedJson::Kind::kBoolean, value); }
  bool number_integer(std::int64_t value) {
    return add(LocatedJson::Kind::kNumber, static_cast<double>(value));
  }
  bool number_unsigned(std::uint64_t value) {
    return add(LocatedJson::Kind::kNumber, static_cast<double>(value));
  }
  bool number_float(double value, const std::string&) { return add(LocatedJson::Kind::kNumber, value); }
  bool string(std::string& value) { return add(LocatedJson::Kind::kText, place_of(value)); }
  bool binary(nlohmann::json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(LocatedJson::Kind::kObject); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(LocatedJson::Kind::kArray); }
  bool end_array() { return close(); }

  bool key(std::string& value) {
    const std::size_t line = position_.line();
    const auto [before, is_new] = open_.back().keys.emplace(value, line);
    if (!is_new)
      fail(fmt::format("the key {} is repeated, first on line {}", in_quotes(value), before->second));
    key_ = place_of(value);
    return true;
  }

  bool parse_error(std::size_t, const std::string& token, const nlohmann::json::exception& error) {
    constexpr int kNumberOverflow = 406;
    if (error.id == kNumberOverflow) fail("the number " + in_quotes(token) + " is too large");
    fail(fmt::format("is not JSON at column {}: {}", position_.column(), complaint_of(error)));
  }

 private:
  struct OpenContainer {
    std::size_t node;
    std::map<std::string, std::size_t> keys;  ///< keys with their lines
  };

  bool add(LocatedJson::Kind kind, double number = 0) {
    const auto next = static_cast<std::uint32_t>(json_.nodes_.size() + 1);
    append_within_memory(json_.file_->name(), json_.nodes_,
                         {static_cast<std::uint32_t>(position_.line()), next, number, key_, kind});
    return true;
  }

  bool open(LocatedJson::Kind kind) {
    if (open_.size() == LocatedJson::kDeepest)
      fail(fmt::format("brackets are nested more than {} deep", LocatedJson::kDeepest));
    open_.push_back({json_.nodes_.size(), {}});
    return add(kind);
  }

  bool close() {
    json_.nodes_[open_.back().node].end = static_cast<std::uint32_t>(json_.nodes_.size());
    open_.pop_back();
    return true;
  }

  /// Returns the index of a text in texts_; each text is stored once, since keys repeat.
  std::uint32_t place_of(const std::string& text) {
    const auto [found, is_new] = places_.emplace(text, static_cast<std::uint32_t>(json_.texts_.size()));
    if (is_new) append_within_memory(json_.file_->name(), json_.texts_, text);
    return found->second;
  }

  [[noreturn]] void fail(const std::string& text) {
    fail_input(*json_.file_, at_line(position_.line()), text, Remedy::kNone);
  }

  LocatedJson& json_;
  ReadPosition& position_;
  std::vector<OpenContainer> open_;
  std::unordered_map<std::string, std::uint32_t> places_;
  std::uint32_t key_ = 0;
};

LocatedJson::LocatedJson(const InputFile& file) : file_(&file) {
  const std::string_view bytes = file.bytes();
  if (bytes.size() > kMostBytes) fail_input(file, {}, "is larger than 1 GiB", Remedy::kSimplify);
  ReadPosition position(bytes);
  LocatedJsonBuilder builder(*this, position);
  nlohmann::json::sax_parse(WatchedBytes(bytes.data(), &position),
                            WatchedBytes(bytes.data() + bytes.size(), &position), &builder);
}

LocatedJson::Value LocatedJson::root() const {
  return {*this, 0};
}

std::vector<LocatedJson::Value> LocatedJson::Value::values() const {
  std::vector<Value> result;
  for (std::size_t i = index_ + 1; i < node().end; i = json_->nodes_[i].end) result.push_back({*json_, i});
  return result;
}

void LocatedJson::Value::fail(const std::string& text) const {
  fail_input(json_->file(), at_line(line()), text, Remedy::kNone);
}

}  // namespace crossgrain
