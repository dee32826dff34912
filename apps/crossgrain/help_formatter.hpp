// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <string>

#include "help_text.hpp"
#include "terminal_width.hpp"

namespace crossgrain::app {

/// Makes the help of programs and commands for CLI11, in the width of the terminal.
class HelpFormatter : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode /*mode*/) const override {
    const std::size_t width = terminal_width(STDOUT_FILENO);
    return app->get_parent() == nullptr ? help_text(describe(*app), width)
                                        : help_text(describe_command(*app), name, width);
  }
};

}  // namespace crossgrain::app
