// SPDX-License-Identifier: BSD-3-Clause
#include "ReadVtk.h"

#include "GuardedProcess.h"
#include "InputError.h"
#include "PolyDataBytes.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include <vtkAppendPolyData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkErrorCode.h>
#include <vtkGLTFReader.h>
#include <vtkPolyDataReader.h>
#include <vtkSMPTools.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>

namespace wirewarp
{
namespace
{
constexpr std::size_t megabyte = std::size_t(1) << 20;

constexpr const char* tooMuchMemory =
  "says that it holds more than memory can; it is damaged or too large, write it again";

/// Far above what files that are whole take: VTK reads some 20 MB of text a second, and its data
/// take some ten times the bytes of a file, more only where it is packed well.
ProcessLimits limitsFor(std::size_t fileSize)
{
  const auto megabytes = static_cast<long long>(fileSize / megabyte);
  ProcessLimits limits;
  limits.cpu = std::chrono::seconds(4 + megabytes);
  limits.wall = std::chrono::seconds(60 + 4 * megabytes);
  limits.memory = 1024 * megabyte + 200 * fileSize;
  return limits;
}

/// VTK's legacy reader calls it a warning when data end too early.
bool isFailure(const std::string& warning)
{
  return warning.find("Error reading") != std::string::npos;
}

/// The first failure that says more than that there was one.
std::string reasonOf(const VtkMessages& messages)
{
  for (const std::string& error : messages.errors())
  {
    if (error.rfind("Algorithm vtk", 0) != 0)
    {
      return error;
    }
  }
  const auto warning =
    std::find_if(messages.warnings().begin(), messages.warnings().end(), isFailure);
  return warning == messages.warnings().end() ? "" : *warning;
}

/// Runs one of VTK's readers; any failure that it reports is a refusal.
template <typename Reader>
std::string runReader(const std::string& path, Reader* reader)
{
  const VtkMessages messages;
  reader->SetFileName(path.c_str());
  errno = 0;
  reader->Update();
  if (reader->GetErrorCode() == vtkErrorCode::CannotOpenFileError)
  {
    throw InputError("cannot be opened " + systemReason(errno, "check its permissions"));
  }
  const std::string reason = reasonOf(messages);
  if (!reason.empty() || !messages.errors().empty() || reader->GetErrorCode() != 0)
  {
    throw InputError("is damaged, truncated or of another format" +
      (reason.empty() ? "" : " (" + reason + ")") + "; write the file again");
  }
  return packPolyData(reader->GetOutput());
}

/// A binary STL says how many triangles it has, but VTK's reader is content with fewer.
void checkStlSize(const std::string& path)
{
  const std::string bytes = readWholeFile(path);
  const std::size_t headerSize = 84;
  const std::size_t facetSize = 50;
  const bool text = bytes.compare(0, 5, "solid") == 0 && bytes.find("facet") != std::string::npos;
  if (text)
  {
    if (bytes.find("endsolid") == std::string::npos)
    {
      throw InputError("has no 'endsolid' line; the file is truncated, write it again");
    }
    return;
  }
  std::uint64_t facets = 0;
  for (std::size_t k = 0; k < 4 && bytes.size() >= headerSize; ++k)
  {
    facets |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[80 + k])) << (8 * k);
  }
  if (bytes.size() < headerSize || bytes.size() < headerSize + facetSize * facets)
  {
    throw InputError("is shorter than its header says; the file is truncated, write it again");
  }
}

std::string readXml(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  return runReader(path, reader.Get());
}

std::string readLegacy(const std::string& path)
{
  vtkNew<vtkPolyDataReader> reader;
  {
    const VtkMessages messages;
    reader->SetFileName(path.c_str());
    if (reader->IsFilePolyData() == 0)
    {
      throw InputError("holds no polydata; save the surface or the curves as vtkPolyData");
    }
  }
  return runReader(path, reader.Get());
}

std::string readStl(const std::string& path)
{
  checkStlSize(path);
  vtkNew<vtkSTLReader> reader;
  return runReader(path, reader.Get());
}

/// The meshes of a scene in their places, as one.
std::string readGltf(const std::string& path)
{
  vtkNew<vtkGLTFReader> reader;
  const VtkMessages messages;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkNew<vtkAppendPolyData> scene;
  scene->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  if (auto* const blocks = vtkCompositeDataSet::SafeDownCast(reader->GetOutputDataObject(0)))
  {
    const auto block = vtk::TakeSmartPointer(blocks->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      auto* const mesh = vtkPolyData::SafeDownCast(block->GetCurrentDataObject());
      if (mesh && mesh->GetNumberOfPolys() > 0)
      {
        vtkNew<vtkPolyData> bare; // materials differ in their arrays
        bare->SetPoints(mesh->GetPoints());
        bare->SetPolys(mesh->GetPolys());
        scene->AddInputData(bare);
      }
    }
  }
  if (scene->GetNumberOfInputConnections(0) == 0)
  {
    const std::string reason = reasonOf(messages);
    throw InputError("holds no triangles, or is damaged" +
      (reason.empty() ? "" : " (" + reason + ")") + "; export the surface again");
  }
  scene->Update();
  return packPolyData(scene->GetOutput());
}

/// What the process of the reader answers: a letter, then the packed data or what to say.
constexpr char isData = 'd';
constexpr char isRefusal = 'r';

std::string answer(const std::string& path)
{
  try
  {
    // Threads do not come along into a new process.
    vtkSMPTools::SetBackend("Sequential");
    const std::string extension = lowerCaseExtension(path);
    return isData +
      (extension == ".vtp"                              ? readXml(path)
          : extension == ".stl"                         ? readStl(path)
          : extension == ".glb" || extension == ".gltf" ? readGltf(path)
                                                        : readLegacy(path));
  }
  catch (const std::bad_alloc&)
  {
    return isRefusal + std::string(tooMuchMemory);
  }
  catch (const std::length_error&)
  {
    return isRefusal + std::string(tooMuchMemory); // more than a container may ever hold
  }
  catch (const std::exception& error)
  {
    return isRefusal + std::string(error.what());
  }
}

std::string failure(const ProcessAnswer& answer, const ProcessLimits& limits)
{
  const std::string writeAgain = "; write the file again";
  const std::string damaged = "is damaged: VTK's reader ";
  if (answer.end == ProcessEnd::TooLong)
  {
    const auto seconds = answer.signal != 0 ? limits.cpu : limits.wall;
    return damaged + "came to no end within " + std::to_string(seconds.count()) + " s" + writeAgain;
  }
  if (answer.end == ProcessEnd::Signal)
  {
    return damaged + "ended by signal " + std::to_string(answer.signal) + " (" +
      strsignal(answer.signal) + ")" +
      (answer.signal == SIGKILL ? "; if memory ran out, try a smaller file" : writeAgain);
  }
  return damaged + "gave no answer" + writeAgain;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> readVtk(const std::string& path)
{
  const ProcessLimits limits = limitsFor(checkedFileSize(path));
  ProcessAnswer result;
  try
  {
    result = runGuarded(limits, [&path]() { return answer(path); });
  }
  catch (const std::runtime_error& error)
  {
    throw InputError(path, error.what());
  }
  if (result.end != ProcessEnd::Answered || result.bytes.empty())
  {
    throw InputError(path, failure(result, limits));
  }
  const std::string_view content = std::string_view(result.bytes).substr(1);
  if (result.bytes.front() != isData)
  {
    throw InputError(path, std::string(content));
  }
  try
  {
    const VtkMessages messages; // of data that a reader has damaged
    return unpackPolyData(content);
  }
  catch (const std::runtime_error& error)
  {
    throw InputError(path, error.what() + std::string("; write the file again"));
  }
}
}
