// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/FileAside.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>

namespace flattening::pattern
{
FileAside::FileAside(const std::string& path)
  : Path(path)
{
  const std::filesystem::path file = std::filesystem::u8path(path);
  std::random_device random; // two runs may write to one folder
  const std::string name =
    "." + file.filename().string() + "." + std::to_string(random()) + ".part";
  this->Aside = (file.parent_path() / std::filesystem::u8path(name)).string();
}

FileAside::~FileAside()
{
  std::error_code ignored;
  std::filesystem::remove(std::filesystem::u8path(this->Aside), ignored);
}

Status FileAside::write(const std::string& content) const
{
  errno = 0;
  std::ofstream file(std::filesystem::u8path(this->Aside), std::ios::binary);
  file << content;
  file.close();
  return file ? Status() : this->failure(errno != 0 ? std::strerror(errno) : "");
}

Status FileAside::publish()
{
  std::error_code error;
  if (std::filesystem::is_directory(std::filesystem::u8path(this->Path), error))
  {
    return this->failure("a folder of this name is in the way");
  }
  std::filesystem::rename(
    std::filesystem::u8path(this->Aside), std::filesystem::u8path(this->Path), error);
  return error ? this->failure(error.message()) : Status();
}

Status FileAside::failure(const std::string& reason) const
{
  return { StatusCode::FileNotWritten,
    this->Path + " cannot be written" + (reason.empty() ? "" : " (" + reason + ")"), {},
    { Remedy::NameAnotherFile } };
}
}
