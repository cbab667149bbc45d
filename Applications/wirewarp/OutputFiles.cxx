// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFiles.h"

#include "InputError.h"
#include "WriteData.h"

#ifndef _WIN32
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

#include <cerrno>
#include <fstream>
#include <random>
#include <system_error>

namespace wirewarp
{
namespace
{
constexpr const char* otherPlace = "; name another with --output";

[[noreturn]] void cannotBeWritten(const std::filesystem::path& file, const std::string& reason)
{
  throw InputError(
    file.string(), "cannot be written" + (reason.empty() ? "" : " (" + reason + ")") + otherPlace);
}
}

void OutputFiles::demandFolder(const std::filesystem::path& folder)
{
  const std::filesystem::path place = folder.empty() ? "." : folder;
  std::error_code error;
  std::filesystem::create_directories(place, error);
  std::error_code ignored;
  if (!std::filesystem::is_directory(place, ignored))
  {
    const std::string reason = error ? error.message() : "a file of this name is in the way";
    throw InputError(place.string(), "cannot make the output folder (" + reason + ")" + otherPlace);
  }
  const std::filesystem::path probe = this->addEntry(place / "probe");
  std::ofstream(probe, std::ios::binary).put('\n');
  const bool writable = std::filesystem::file_size(probe, error) == 1;
  std::filesystem::remove(probe, error);
  this->Entries.pop_back();
  if (!writable)
  {
    throw InputError(place.string(), std::string("cannot write to the output folder") + otherPlace);
  }
}

OutputFiles::~OutputFiles()
{
  this->abandon();
}

void OutputFiles::abandon()
{
  std::error_code ignored;
  for (const Entry& entry : this->Entries)
  {
    std::filesystem::remove(entry.aside, ignored);
  }
  this->Entries.clear();
}

void OutputFiles::claim(const std::filesystem::path& folder)
{
  this->Lock.emplace(folder);
  if (!this->Lock->held())
  {
    throw InputError(folder.string(),
      "another run is writing to this folder; wait for its end, or name another with --output");
  }
}

void OutputFiles::demandPlace(const std::filesystem::path& file) const
{
  std::error_code ignored;
  if (std::filesystem::is_directory(std::filesystem::symlink_status(file, ignored)))
  {
    cannotBeWritten(file, "a folder of this name is in the way");
  }
}

std::filesystem::path OutputFiles::addEntry(const std::filesystem::path& file)
{
  std::random_device random; // where folders cannot be claimed two runs may write to one
  const std::string aside =
    "." + file.filename().string() + "." + std::to_string(random()) + ".part";
  this->Entries.push_back({ file.parent_path() / std::filesystem::u8path(aside), file });
  return this->Entries.back().aside;
}

void OutputFiles::add(const std::filesystem::path& file, const flattening::DataSet& data)
{
  this->add(file, bytesOf({ { file.string(), &data } }, {}).front());
}

void OutputFiles::add(const std::filesystem::path& file, const std::string& text)
{
  errno = 0;
  std::ofstream stream(this->addEntry(file), std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
  {
    cannotBeWritten(file, errno != 0 ? std::generic_category().message(errno) : "");
  }
}

std::string OutputFiles::add(
  const std::filesystem::path& file, const std::function<std::string(const std::string&)>& write)
{
  std::string problem = write(this->addEntry(file).string());
  if (!problem.empty())
  {
    std::error_code ignored;
    std::filesystem::remove(this->Entries.back().aside, ignored);
    this->Entries.pop_back();
  }
  return problem;
}

void OutputFiles::discard(const std::vector<std::filesystem::path>& files)
{
  this->Outdated.insert(this->Outdated.end(), files.begin(), files.end());
}

void OutputFiles::publish()
{
  for (const Entry& entry : this->Entries)
  {
    // Before any file is in place, so that none is where another is missing.
    this->demandPlace(entry.final);
  }
  std::error_code error;
  if (this->Entries.size() > 1)
  {
    std::filesystem::remove(this->Entries.back().final, error);
  }
  for (const std::filesystem::path& file : this->Outdated)
  {
    std::filesystem::remove(file, error);
  }
  this->Outdated.clear();
  for (const Entry& entry : this->Entries)
  {
    std::filesystem::rename(entry.aside, entry.final, error);
    if (error)
    {
      cannotBeWritten(entry.final, error.message());
    }
  }
  this->Entries.clear();
}

#ifdef _WIN32
FolderLock::FolderLock(const std::filesystem::path&)
  : Folder(-1)
  , Held(true)
{
}

FolderLock::~FolderLock() = default;
#else
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
#endif

void InputFiles::add(const std::string& path)
{
  std::error_code error; // whoever reads the file tells of it
  std::filesystem::path file = std::filesystem::canonical(std::filesystem::u8path(path), error);
  if (!error)
  {
    this->Files.insert(std::move(file));
  }
}

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
