// SPDX-License-Identifier: Apache-2.0
// JSON values with the line of the file where each stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "files/input_file.hpp"

namespace crossgrain {

/// The values of a file in their order, a container before its contents. Plain numbers take 24 bytes.
class LocatedJson {
 public:
  enum class Kind : std::uint8_t { kNull, kBoolean, kNumber, kText, kArray, kObject };

  /// A value; a member of an object also has its key.
  class Value;

  /// Parses a file. Throws Error(kInput) naming the line if it is not JSON, has numbers beyond double
  /// precision, nesting deeper than kDeepest, an object with a repeated key, or more than kMostBytes. The
  /// file must outlive the object.
  explicit LocatedJson(const InputFile& file);

  Value root() const;
  const InputFile& file() const { return *file_; }

  /// Maximum nesting. Valid input needs much less; damaged or hostile files may have millions of levels.
  static constexpr std::size_t kDeepest = 32;

  /// Maximum size. A number and a comma make a node, so memory stays below twelve times this.
  static constexpr std::size_t kMostBytes = std::size_t{1} << 30;

 private:
  friend class LocatedJsonBuilder;

  struct Node {
    std::uint32_t line;
    std::uint32_t end;  ///< the node after the last one inside
    double number;      ///< of texts the index into texts_
    std::uint32_t key;  ///< index into texts_; only for members of objects
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

  /// Returns the number, the text, and the key of a member.
  double number() const { return node().number; }
  const std::string& text() const { return json_->texts_[static_cast<std::size_t>(node().number)]; }
  const std::string& key() const { return json_->texts_[node().key]; }

  /// Returns the elements of an array or the members of an object, in the order of the file.
  std::vector<Value> values() const;

  /// Throws Error(kInput) that names the line of the value.
  [[noreturn]] void fail(const std::string& text) const;

 private:
  friend class LocatedJson;
  Value(const LocatedJson& json, std::size_t index) : json_(&json), index_(index) {}
  const Node& node() const { return json_->nodes_[index_]; }

  const LocatedJson* json_;
  std::size_t index_;
};

}  // namespace crossgrain
