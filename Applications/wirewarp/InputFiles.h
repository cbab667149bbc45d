// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace wirewarp
{
/// The files that a run reads, so that it replaces or removes none of them.
class InputFiles
{
public:
  void add(const std::string& path);
  /// Throws InputError where the file is an input.
  /// \param option the option of the command that names it
  void refuseToReplace(const std::filesystem::path& file, const std::string& option) const;

private:
  std::set<std::filesystem::path> Files;
};
}
