// SPDX-License-Identifier: BSD-3-Clause
// wirewarp-read PARENT SECONDS BYTES FILE: reads FILE with VTK's readers for readVtk() of a
// program.
#include "DataSetBytes.h"
#include "GuardedProcess.h"
#include "InputError.h"
#include "PolyDataOutput.h"
#include "ReadVtk.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include <vtkAppendPolyData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkErrorCode.h>
#include <vtkGLTFReader.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSMPTools.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using namespace wirewarp;

constexpr const char* tooMuchMemory =
  "says that it holds more than memory can; it is damaged or too large, write it again";

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
  return packDataSet(dataSetOf(reader->GetOutput()));
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

/// An extension that a glTF file requires for its meshes, as for compression: VTK's reader has
/// none, and crashes on Draco's.
std::string requiredOfMeshes(const std::string& content)
{
  const std::size_t begin = std::min(content.find("\"extensionsRequired\""), content.size());
  const std::string names = content.substr(begin, content.find(']', begin) - begin);
  const std::size_t place = names.find("mesh");
  if (place == std::string::npos)
  {
    return "";
  }
  const std::size_t first = names.rfind('"', place) + 1;
  return names.substr(first, names.find('"', place) - first);
}

/// The meshes of a scene in their places, as one.
std::string readGltf(const std::string& path)
{
  if (const std::string extension = requiredOfMeshes(readWholeFile(path)); !extension.empty())
  {
    throw InputError("stores meshes by the extension " + extension +
      ", which is not read; export it without, or as .obj or .ply");
  }
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
  return packDataSet(dataSetOf(scene->GetOutput()));
}

std::string answerOf(const std::string& path)
{
  try
  {
    vtkSMPTools::SetBackend("Sequential"); // threads would take addresses within the limit
    const std::string extension = lowerCaseExtension(path);
    return vtkAnswerData +
      (extension == ".vtp"                              ? readXml(path)
          : extension == ".glb" || extension == ".gltf" ? readGltf(path)
                                                        : readLegacy(path));
  }
  catch (const std::bad_alloc&)
  {
    return vtkAnswerRefusal + std::string(tooMuchMemory);
  }
  catch (const std::length_error&)
  {
    return vtkAnswerRefusal + std::string(tooMuchMemory); // more than a container may ever hold
  }
  catch (const std::exception& error)
  {
    return vtkAnswerRefusal + std::string(error.what());
  }
}
}

int main(int argc, char** argv)
{
  return answerGuarded(argc, argv, [](const std::vector<std::string>& arguments) {
    return answerOf(arguments.empty() ? std::string() : arguments.front());
  });
}
