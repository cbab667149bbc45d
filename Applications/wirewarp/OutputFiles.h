// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FolderLock.h"

#include <vtkPolyData.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wirewarp
{
/// Files of one folder that appear all together or not at all: each is written aside, and publish()
/// renames them. What was not published is removed again. The file that is added last stands for
/// the whole set: it is there only where the others are.
class OutputFiles
{
public:
  /// Makes the folder. Throws InputError where it cannot be made or written to.
  /// \param option the option of the command that names the folder
  explicit OutputFiles(const std::string& folder, const std::string& option = "--output");
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Keeps other runs out of the folder, so that no file of theirs comes among these. Throws
  /// InputError where another run has it.
  void claim();
  /// Throws InputError where a folder stands where a file is to be put.
  void demandPlace(const std::string& name) const;
  /// Throw InputError where the file cannot be written.
  void add(const std::string& name, vtkPolyData* data);
  void add(const std::string& name, const std::string& text);
  /// Leaves a file out that cannot be written.
  /// \param write writes to a path and returns what went wrong, or nothing
  /// \return what it returned
  std::string add(
    const std::string& name, const std::function<std::string(const std::string&)>& write);
  /// Where publish() puts a file.
  std::string path(const std::string& name) const { return (this->Folder / name).string(); }
  void publish();
  /// Removes what is not published, as does the end.
  void abandon();
  /// Lets publish() remove an earlier result of this name.
  void discard(const std::string& name);

private:
  struct Entry
  {
    std::filesystem::path aside;
    std::filesystem::path final;
  };
  std::filesystem::path addEntry(const std::string& name);

  std::filesystem::path Folder;
  std::string SuggestedRemedy;
  std::optional<FolderLock> Lock;
  std::vector<Entry> Entries;
  std::vector<std::filesystem::path> Outdated;
};
}
