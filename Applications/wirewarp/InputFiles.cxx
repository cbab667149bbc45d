// SPDX-License-Identifier: BSD-3-Clause
#include "InputFiles.h"

#include "InputError.h"

#include <system_error>

namespace wirewarp
{
//------------------------------------------------------------------------------
void InputFiles::add(const std::string& path)
{
  std::error_code error; // whoever reads the file tells of it
  std::filesystem::path file = std::filesystem::canonical(path, error);
  if (!error)
  {
    this->Files.insert(std::move(file));
  }
}

//------------------------------------------------------------------------------
void InputFiles::refuseToReplace(const std::filesystem::path& file, const std::string& option) const
{
  // A link in place of the file itself would be replaced, not what it leads to.
  std::error_code error;
  const std::filesystem::path parent = file.parent_path();
  const std::filesystem::path folder =
    std::filesystem::canonical(parent.empty() ? "." : parent, error);
  if (!error && this->Files.count(folder / file.filename()) > 0)
  {
    throw InputError(
      file.string(), "is an input, which the result would replace; name another with " + option);
  }
}
}
