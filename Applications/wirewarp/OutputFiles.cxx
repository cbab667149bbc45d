// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFiles.h"

#include "InputError.h"
#include "VtkMessages.h"

#include <vtkXMLPolyDataWriter.h>

#include <cerrno>
#include <fstream>
#include <random>
#include <system_error>

namespace wirewarp
{
//------------------------------------------------------------------------------
OutputFiles::OutputFiles(const std::string& folder, const std::string& option)
  : Folder(folder)
  , SuggestedRemedy("; name another folder with " + option)
{
  std::error_code error;
  std::filesystem::create_directories(this->Folder, error);
  std::error_code ignored;
  if (!std::filesystem::is_directory(this->Folder, ignored))
  {
    const std::string reason = error ? error.message() : "a file of this name is in the way";
    throw InputError(
      folder, "cannot make the output folder (" + reason + ")" + this->SuggestedRemedy);
  }
  const std::filesystem::path probe = this->addEntry("probe");
  std::ofstream(probe).put('\n');
  const bool writable = std::filesystem::file_size(probe, error) == 1;
  std::filesystem::remove(probe, error);
  this->Entries.clear();
  if (!writable)
  {
    throw InputError(folder, "cannot write to the output folder" + this->SuggestedRemedy);
  }
}

OutputFiles::~OutputFiles()
{
  this->abandon();
}

//------------------------------------------------------------------------------
void OutputFiles::abandon()
{
  std::error_code ignored;
  for (const Entry& entry : this->Entries)
  {
    std::filesystem::remove(entry.aside, ignored);
  }
  this->Entries.clear();
}

//------------------------------------------------------------------------------
void OutputFiles::claim()
{
  this->Lock.emplace(this->Folder);
  if (!this->Lock->held())
  {
    throw InputError(this->Folder.string(),
      "another run is writing to this folder; wait for its end, or" +
        this->SuggestedRemedy.substr(1));
  }
}

//------------------------------------------------------------------------------
void OutputFiles::demandPlace(const std::string& name) const
{
  const std::filesystem::path file = this->Folder / name;
  std::error_code ignored;
  if (std::filesystem::is_directory(std::filesystem::symlink_status(file, ignored)))
  {
    throw InputError(file.string(),
      "cannot be written (a folder of this name is in the way)" + this->SuggestedRemedy);
  }
}

//------------------------------------------------------------------------------
std::filesystem::path OutputFiles::addEntry(const std::string& name)
{
  std::random_device random; // where folders cannot be claimed two runs may write to one
  const std::string aside = "." + name + "." + std::to_string(random()) + ".part";
  this->Entries.push_back({ this->Folder / aside, this->Folder / name });
  return this->Entries.back().aside;
}

//------------------------------------------------------------------------------
void OutputFiles::add(const std::string& name, vtkPolyData* data)
{
  // By way of memory: on a full disk VTK's writer of files crashes.
  std::string text;
  {
    const VtkMessages messages;
    vtkNew<vtkXMLPolyDataWriter> writer;
    // With the Expat of Debian 12's security updates ParaView 5.11 refuses appended data.
    writer->SetDataModeToBinary();
    // Zlib takes three times as long to make files of seven tenths of the size.
    writer->SetCompressorTypeToLZ4();
    writer->WriteToOutputStringOn();
    writer->SetInputData(data);
    if (writer->Write() != 1 || !messages.errors().empty())
    {
      const std::string reason = messages.firstError();
      throw InputError((this->Folder / name).string(),
        "cannot be written" + (reason.empty() ? "" : " (" + reason + ")") + this->SuggestedRemedy);
    }
    text = writer->GetOutputString();
  }
  this->add(name, text);
}

//------------------------------------------------------------------------------
void OutputFiles::add(const std::string& name, const std::string& text)
{
  errno = 0;
  std::ofstream file(this->addEntry(name), std::ios::binary);
  file << text;
  file.close();
  if (!file)
  {
    const std::string reason = errno != 0 ? std::generic_category().message(errno) : "";
    throw InputError((this->Folder / name).string(),
      "cannot be written" + (reason.empty() ? "" : " (" + reason + ")") + this->SuggestedRemedy);
  }
}

//------------------------------------------------------------------------------
std::string OutputFiles::add(
  const std::string& name, const std::function<std::string(const std::string&)>& write)
{
  std::string problem = write(this->addEntry(name).string());
  if (!problem.empty())
  {
    std::error_code ignored;
    std::filesystem::remove(this->Entries.back().aside, ignored);
    this->Entries.pop_back();
  }
  return problem;
}

//------------------------------------------------------------------------------
void OutputFiles::publish()
{
  for (const Entry& entry : this->Entries)
  {
    // Before any file is in place, so that none is where another is missing.
    this->demandPlace(entry.final.filename().string());
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
      throw InputError(entry.final.string(),
        "cannot be written (" + error.message() + ")" + this->SuggestedRemedy);
    }
  }
  this->Entries.clear();
}

//------------------------------------------------------------------------------
void OutputFiles::discard(const std::string& name)
{
  this->Outdated.push_back(this->Folder / name);
}
}
