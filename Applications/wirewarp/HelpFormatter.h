// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace wirewarp
{
// Options without a group would have no name in messages.
constexpr const char* commonGroup = "Options";
constexpr const char* globalGroup = "Options of every command";

/// Options in common use with their first sentences, unless the help is whole, and everything
/// wrapped.
class HelpFormatter : public CLI::Formatter
{
public:
  explicit HelpFormatter(bool whole);
  std::string make_help(
    const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_group(
    std::string group, bool positional, std::vector<const CLI::Option*> options) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_option_opts(const CLI::Option* option) const override;

private:
  bool Whole;
};
}
