// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

#include <string>

namespace flattening::pattern
{
/// A file that appears whole or not at all: it is written under another name in the same folder,
/// and publish() renames it. What was not published is removed.
class FileAside
{
public:
  explicit FileAside(const std::string& path);
  ~FileAside();
  FileAside(const FileAside&) = delete;
  FileAside& operator=(const FileAside&) = delete;

  /// Where to write.
  const std::string& aside() const { return this->Aside; }
  /// Writes a whole text.
  Status write(const std::string& content) const;
  Status publish();
  /// What to say where the file cannot be written.
  Status failure(const std::string& reason) const;

private:
  std::string Path;
  std::string Aside;
};
}
