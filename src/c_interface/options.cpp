// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"
#include "c_interface/option_names.hpp"
#include "c_interface/option_value.hpp"
#include "c_interface/removed_options.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

using Values = decltype(crossgrain_options::values);

template <std::size_t... kinds>
Values defaults_of(std::size_t kind, std::index_sequence<kinds...> /*all*/) {
  Values values;
  const bool is_known = ((kinds == kind && (values.emplace<kinds>(), true)) || ...);
  if (!is_known) throw Error(ErrorKind::kUsage, fmt::format("there are no options of kind {}", kind));
  return values;
}

Values defaults_of(crossgrain_options_kind kind) {
  return defaults_of(static_cast<std::size_t>(kind), std::make_index_sequence<std::variant_size_v<Values>>());
}

struct NamedType {
  std::string name;
  crossgrain_option_type type;
};

/// The names and types of all options of a kind.
const std::vector<NamedType>& options_of(crossgrain_options_kind kind) {
  static const auto all = [] {
    std::vector<std::vector<NamedType>> lists(std::variant_size_v<Values>);
    for (std::size_t k = 0; k < lists.size(); ++k) {
      Values values = defaults_of(static_cast<crossgrain_options_kind>(k));
      const auto note = [&]<class T>(const char* name, const T&) {
        lists[k].push_back({name, kOptionType<T>});
      };
      std::visit([&](auto& options) { for_each_option(options, note); }, values);
    }
    return lists;
  }();
  static const std::vector<NamedType> none;
  const auto index = static_cast<std::size_t>(kind);
  return index < all.size() ? all[index] : none;
}

/// The number of characters to insert, remove or replace to get from one word to the other.
std::size_t edits_between(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t kept = diagonal + (from[i - 1] != to[j - 1]);
      diagonal = row[j];
      row[j] = std::min({kept, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

[[noreturn]] void refuse_name(const Values& values, const std::string& name) {
  const auto kind = static_cast<crossgrain_options_kind>(values.index());
  if (const std::string_view instead = replacement_of(kind, name); !instead.empty())
    throw Error(ErrorKind::kUsage, fmt::format("{} is no option any more; {}", name, instead));
  std::string nearest;
  std::size_t fewest = SIZE_MAX;
  for (const NamedType& option : options_of(kind)) {
    const std::size_t edits = edits_between(name, option.name);
    if (edits < fewest) nearest = option.name;
    fewest = std::min(fewest, edits);
  }
  throw Error(ErrorKind::kUsage,
              fmt::format("there is no option {}; the most similar one is {}", name, nearest));
}

/// Calls use(member) for the option of this name.
template <class AnyValues, class Use>
void with_option(AnyValues& values, const char* name, const Use& use) {
  const std::string wanted = &given(name, "name");
  bool is_found = false;
  const auto visit = [&](const char* its_name, auto& member) {
    if (is_found || wanted != its_name) return;
    is_found = true;
    use(member);
  };
  std::visit([&](auto& options) { for_each_option(options, visit); }, values);
  if (!is_found) refuse_name(values, wanted);
}

void set(crossgrain_options* options, const char* name, const OptionValue& value) {
  with_option(given(options, "options").values, name, [&](auto& member) {
    try {
      set_option(member, value);
    } catch (const std::invalid_argument& error) {
      throw Error(ErrorKind::kUsage, fmt::format("the option {} {}", name, error.what()));
    }
  });
}

template <class Part>
Part part_of(const crossgrain_options* options, const char* name) {
  // The members are only read; a copy serves the one function that names them.
  Values values = given(options, "options").values;
  OptionContent content;
  with_option(values, name, [&](const auto& member) { content = content_of(member); });
  auto* const part = std::get_if<Part>(&content);
  if (part == nullptr)
    throw Error(ErrorKind::kUsage, fmt::format("the option {} is {}", name,
                                               content.index() == 0 ? "no text but numbers" : "a text"));
  return std::move(*part);
}

SolveOptions& solve_options(crossgrain_options* options) {
  Values& values = given(options, "options").values;
  if (auto* const meshing = std::get_if<HexMeshingOptions>(&values)) return meshing->solve;
  auto* const found = std::get_if<SolveOptions>(&values);
  if (found == nullptr) throw Error(ErrorKind::kUsage, "the options are not those of a solve");
  return *found;
}

}  // namespace
}  // namespace crossgrain

using namespace crossgrain;

crossgrain_status crossgrain_options_new(crossgrain_options_kind kind, crossgrain_options** out,
                                         crossgrain_error** error) {
  return made(out, error, [&] { return new crossgrain_options{defaults_of(kind)}; });
}

void crossgrain_options_free(crossgrain_options* options) {
  delete options;
}

size_t crossgrain_options_count(crossgrain_options_kind kind) {
  return value_or<size_t>(0, [&] { return options_of(kind).size(); });
}

const char* crossgrain_options_name(crossgrain_options_kind kind, size_t index) {
  return value_or<const char*>(nullptr, [&] {
    const auto& all = options_of(kind);
    return index < all.size() ? all[index].name.c_str() : nullptr;
  });
}

crossgrain_option_type crossgrain_options_type(crossgrain_options_kind kind, size_t index) {
  return value_or(CROSSGRAIN_FLAG, [&] {
    const auto& all = options_of(kind);
    return index < all.size() ? all[index].type : CROSSGRAIN_FLAG;
  });
}

const char* crossgrain_options_replacement(crossgrain_options_kind kind, const char* name) {
  // The texts are literals, so each ends with a zero.
  return name == nullptr ? nullptr : replacement_of(kind, name).data();
}

crossgrain_status crossgrain_options_set_integer(crossgrain_options* options, const char* name, int64_t value,
                                                 crossgrain_error** error) {
  return guarded(error, [&] { set(options, name, value); });
}

crossgrain_status crossgrain_options_set_number(crossgrain_options* options, const char* name, double value,
                                                crossgrain_error** error) {
  return guarded(error, [&] { set(options, name, value); });
}

crossgrain_status crossgrain_options_set_numbers(crossgrain_options* options, const char* name,
                                                 const double* values, size_t count,
                                                 crossgrain_error** error) {
  return guarded(error, [&] {
    const auto numbers = elements(values, count, 1, "values");
    set(options, name, std::vector<double>(numbers.begin(), numbers.end()));
  });
}

crossgrain_status crossgrain_options_set_text(crossgrain_options* options, const char* name,
                                              const char* value, crossgrain_error** error) {
  return guarded(error, [&] { set(options, name, std::string(&given(value, "value"))); });
}

crossgrain_status crossgrain_options_get_numbers(const crossgrain_options* options, const char* name,
                                                 crossgrain_numbers** out, crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_numbers{1, part_of<std::vector<double>>(options, name)};
  });
}

crossgrain_status crossgrain_options_get_text(const crossgrain_options* options, const char* name, char** out,
                                              crossgrain_error** error) {
  return made(out, error, [&] { return copy_of(part_of<std::string>(options, name)); });
}

crossgrain_status crossgrain_options_set_constraints(crossgrain_options* options,
                                                     const crossgrain_constraints* constraints,
                                                     crossgrain_error** error) {
  return guarded(error,
                 [&] { solve_options(options).constraints = given(constraints, "constraints").constraints; });
}

crossgrain_status crossgrain_options_size_for(crossgrain_options* options, const crossgrain_domain* domain,
                                              crossgrain_error** error) {
  return guarded(error, [&] {
    SolveOptions& changed = solve_options(options);
    changed = sized_for(given(domain, "domain").domain, changed);
  });
}

crossgrain_status crossgrain_options_for_reading(const crossgrain_options* solve, crossgrain_options** out,
                                                 crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_options{read_options_for(options_or_defaults<SolveOptions>(solve))};
  });
}
