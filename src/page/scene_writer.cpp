// SPDX-License-Identifier: Apache-2.0
#include "page/scene_writer.hpp"

#include <bit>
#include <cstring>
#include <type_traits>

namespace crossgrain {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

constexpr std::size_t kAlignment = 8;
constexpr const char* kMagic = "CGSCENE1";

void pad(std::string& bytes, char with, std::size_t before = 0) {
  while ((bytes.size() + before) % kAlignment != 0) bytes.push_back(with);
}

template <class T>
constexpr const char* name_of_type() {
  if constexpr (std::is_same_v<T, float>) return "f32";
  if constexpr (std::is_same_v<T, std::uint32_t>) return "u32";
  if constexpr (std::is_same_v<T, std::uint16_t>) return "u16";
  if constexpr (std::is_same_v<T, std::int16_t>) return "i16";
  return "u8";
}

}  // namespace

template <class T>
void SceneWriter::add(const std::string& name, std::size_t components, const std::vector<T>& values) {
  nlohmann::ordered_json shape = nlohmann::ordered_json::array({values.size() / components});
  if (components > 1) shape.push_back(components);
  arrays_[name] = {{"type", name_of_type<T>()}, {"offset", data_.size()}, {"shape", std::move(shape)}};
  data_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  pad(data_, '\0');
}

template void SceneWriter::add(const std::string&, std::size_t, const std::vector<float>&);
template void SceneWriter::add(const std::string&, std::size_t, const std::vector<std::uint32_t>&);
template void SceneWriter::add(const std::string&, std::size_t, const std::vector<std::uint16_t>&);
template void SceneWriter::add(const std::string&, std::size_t, const std::vector<std::int16_t>&);
template void SceneWriter::add(const std::string&, std::size_t, const std::vector<std::uint8_t>&);

std::string SceneWriter::bytes() const {
  nlohmann::ordered_json whole = {{"schema", 2}};
  whole.update(header);
  whole["arrays"] = arrays_;
  std::string text = whole.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  pad(text, ' ', std::strlen(kMagic) + sizeof(std::uint32_t));
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string result = kMagic;
  result.append(reinterpret_cast<const char*>(&length), sizeof length);
  return result + text + data_;
}

std::uint16_t to_bfloat16(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return static_cast<std::uint16_t>((bits + 0x7fff + (bits >> 16 & 1)) >> 16);
}

}  // namespace crossgrain
