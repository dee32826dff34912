// SPDX-License-Identifier: Apache-2.0
// A locale in which numbers have a decimal comma, for the thread that runs a test. It is compiled on the
// spot, so that none needs to be installed.
#pragma once

#include <fmt/format.h>
#include <locale.h>
#include <stdlib.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "files/temporary_folder.hpp"

namespace crossgrain {

/// In force as long as it lives, where it could be made.
class CommaLocale {
 public:
  CommaLocale() {
    folder_.write("numbers",
                  "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \"\"\ngrouping -1\nEND LC_NUMERIC\n");
    folder_.write("characters",
                  "<code_set_name> TWO\n<escape_char> /\n<mb_cur_min> 1\n<mb_cur_max> 1\n"
                  "CHARMAP\n<U002C> /x2c COMMA\n<U002E> /x2e FULL STOP\nEND CHARMAP\n");
    // It complains of all the categories that are not there, and makes the one that is.
    const std::string command =
        fmt::format("cd '{}' && localedef -c -i ./numbers -f ./characters ./comma >complaints 2>&1",
                    folder_.path().string());
    if (std::system(command.c_str()) == -1) return;
    ::setenv("LOCPATH", folder_.path().c_str(), 1);
    locale_ = ::newlocale(LC_NUMERIC_MASK, "comma", nullptr);
    ::unsetenv("LOCPATH");
    if (locale_) before_ = ::uselocale(locale_);
  }
  ~CommaLocale() {
    if (!locale_) return;
    ::uselocale(before_);
    ::freelocale(locale_);
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  bool made() const { return locale_ != nullptr; }

  /// What localedef said, for a test that has to be left out.
  std::string complaints() const { return content_of(folder_.path() / "complaints"); }

 private:
  TemporaryFolder folder_;
  locale_t locale_ = nullptr;
  locale_t before_ = nullptr;
};

}  // namespace crossgrain
