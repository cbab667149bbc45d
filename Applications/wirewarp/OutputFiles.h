// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/DataSet.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace wirewarp
{
/// Keeps other runs out of a folder while it lives. Its end, whatever the cause, frees the folder,
/// and no file is left in it. A file system without locks gives no protection.
class FolderLock
{
public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// False where another run has the folder.
  bool held() const { return this->Held; }

private:
  int Folder;
  bool Held;
};

/// Files that appear all together or not at all: each is written aside, and publish() renames them.
/// What was not published is removed again. The file that is added last stands for the whole set:
/// it is there only where the others are.
class OutputFiles
{
public:
  OutputFiles() = default;
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Makes the folder. Throws InputError where it cannot be made or written to.
  void demandFolder(const std::filesystem::path& folder);
  /// Keeps other runs out of a folder, so that no file of theirs comes among these. Throws
  /// InputError where another run has it.
  void claim(const std::filesystem::path& folder);
  /// Throws InputError where a folder stands where a file is to be put.
  void demandPlace(const std::filesystem::path& file) const;
  /// Throw InputError where the file cannot be written.
  void add(const std::filesystem::path& file, const flattening::DataSet& data);
  void add(const std::filesystem::path& file, const std::string& text);
  /// Leaves a file out that cannot be written.
  /// \param write writes to a path and returns what went wrong, or nothing
  /// \return what it returned
  std::string add(
    const std::filesystem::path& file, const std::function<std::string(const std::string&)>& write);
  void publish();
  /// Removes what is not published, as does the end.
  void abandon();
  /// Lets publish() remove earlier results of these names.
  void discard(const std::vector<std::filesystem::path>& files);

private:
  struct Entry
  {
    std::filesystem::path aside;
    std::filesystem::path final;
  };
  std::filesystem::path addEntry(const std::filesystem::path& file);

  std::optional<FolderLock> Lock;
  std::vector<Entry> Entries;
  std::vector<std::filesystem::path> Outdated;
};

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
