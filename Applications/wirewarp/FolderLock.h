// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace wirewarp
{
/// Keeps other runs out of a folder while it lives. Its end, whatever the cause, frees the folder,
/// and no file is left in it. On a file system without locks it keeps nobody out.
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
}
