// SPDX-License-Identifier: BSD-3-Clause
#include "FolderLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace wirewarp
{
FolderLock::FolderLock(const std::filesystem::path& folder)
  : Folder(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
  , Held(flock(this->Folder, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
{
}

FolderLock::~FolderLock()
{
  if (this->Folder >= 0)
  {
    close(this->Folder);
  }
}
}
