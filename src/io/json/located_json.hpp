// SPDX-License-Identifier: Apache-2.0
// JSON that knows on which line of its file every value stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_file.hpp"

namespace crossgrain {

/// The values of a file in the order of the file, a container before what it holds. Plain numbers take 24
/// bytes.
class LocatedJson {
 public:
  enum class Kind : std::uint8_t { kNull, kBoolean, kNumber, kText, kArray, kObject };

  /// A value; for a member of an object its key is known too.
  class Value;

  /// Throws Error(kInput) naming the line for what is no JSON, numbers beyond double precision, more than
  /// kDeepest levels of nesting, keys that an object has twice, and files of more than kMostBytes. The file
  /// must outlive it.
  explicit LocatedJson(const InputFile& file);

  Value root() const;
  const InputFile& file() const { return *file_; }

  /// Levels of nesting; what is read with it needs fewer, and what is damaged or hostile may have millions.
  static constexpr std::size_t kDeepest = 32;

  /// A number and a comma make a node: memory stays below a dozen times this.
  static constexpr std::size_t kMostBytes = std::size_t{1} << 30;

 private:
  friend class LocatedJsonBuilder;

  struct Node {
    std::uint32_t line;
    std::uint32_t end;  ///< the node after the last one inside
    double number;      ///< of texts their place in texts_
    std::uint32_t key;  ///< place in texts_; only of members of objects
    Kind kind;
  };

  const InputFile* file_;
  std::vector<Node> nodes_;
  std::vector<std::string> texts_;
};

class LocatedJson::Value {
 public:
  Kind kind() const { return node().kind; }
  bool is(Kind kind) const { return node().kind == kind; }
  std::size_t line() const { return node().line; }

  /// Of a number, a text, and a member of an object, each.
  double number() const { return node().number; }
  const std::string& text() const { return json_->texts_[static_cast<std::size_t>(node().number)]; }
  const std::string& key() const { return json_->texts_[node().key]; }

  /// What an array or an object holds, in the order of the file.
  std::vector<Value> values() const;

  /// Throws Error(kInput) that names this line.
  [[noreturn]] void fail(const std::string& text) const;

 private:
  friend class LocatedJson;
  Value(const LocatedJson& json, std::size_t index) : json_(&json), index_(index) {}
  const Node& node() const { return json_->nodes_[index_]; }

  const LocatedJson* json_;
  std::size_t index_;
};

}  // namespace crossgrain
