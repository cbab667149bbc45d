// SPDX-License-Identifier: BSD-3-Clause
#include "EditorFiles.h"

#include <vtkCallbackCommand.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPatternWriter.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace editor
{
namespace
{
void silence(vtkObject* object)
{
  vtkNew<vtkCallbackCommand> listener;
  listener->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  object->AddObserver(vtkCommand::WarningEvent, listener);
  object->AddObserver(vtkCommand::ErrorEvent, listener);
}

template <typename Reader>
figures::PolyData readBy(const std::string& path)
{
  vtkNew<Reader> reader;
  silence(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

std::string extensionOf(const std::string& path)
{
  const std::size_t dot = path.find_last_of("./");
  std::string extension = dot == std::string::npos || path[dot] != '.' ? "" : path.substr(dot);
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}
}

//------------------------------------------------------------------------------
figures::PolyData readPolyData(const std::string& path)
{
  if (!std::ifstream(path))
  {
    throw std::runtime_error("cannot read " + path);
  }
  const std::string extension = extensionOf(path);
  figures::PolyData data = extension == ".vtp" ? readBy<vtkXMLPolyDataReader>(path)
    : extension == ".vtk"                      ? readBy<vtkPolyDataReader>(path)
    : extension == ".obj"                      ? readBy<vtkOBJReader>(path)
    : extension == ".ply"                      ? readBy<vtkPLYReader>(path)
    : extension == ".stl"                      ? readBy<vtkSTLReader>(path)
                                               : nullptr;
  if (!data)
  {
    throw std::runtime_error(path + " is no .vtp, .vtk, .obj, .ply or .stl");
  }
  if (data->GetNumberOfCells() == 0)
  {
    throw std::runtime_error(path + " holds nothing, or not what its name says");
  }
  return data;
}

//------------------------------------------------------------------------------
void writePolyData(const std::string& path, vtkPolyData* data)
{
  const std::string aside = path + ".part";
  // By way of memory: on a full disk VTK's writer of files crashes.
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  silence(writer);
  writer->SetInputData(data);
  const bool written = writer->Write() == 1;
  std::ofstream file(aside, std::ios::binary);
  file << writer->GetOutputString();
  file.close();
  if (!written || !file || std::rename(aside.c_str(), path.c_str()) != 0)
  {
    std::remove(aside.c_str());
    throw std::runtime_error("cannot write " + path);
  }
}

//------------------------------------------------------------------------------
void writePattern(const std::string& path, const figures::FlatPiece& piece, const std::string& unit,
  const std::string& name)
{
  vtkNew<vtkPatternWriter> writer;
  silence(writer);
  writer->SetUnitByName(unit);
  writer->SetPatternName(name);
  writer->SetInputData(0, piece.flat);
  writer->SetInputData(1, piece.wires);
  writer->SetInputData(2, piece.cut);
  writer->SetFileName(path.c_str());
  if (writer->Write() != 1)
  {
    throw std::runtime_error(writer->GetErrorMessage());
  }
}

//------------------------------------------------------------------------------
std::string stemOf(const std::string& path)
{
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.substr(0, file.rfind('.'));
}
}
