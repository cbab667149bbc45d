// SPDX-License-Identifier: BSD-3-Clause
#include "Files.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace figures
{
//------------------------------------------------------------------------------
void silence(vtkObject* object)
{
  vtkNew<vtkCallbackCommand> listener;
  listener->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  object->AddObserver(vtkCommand::WarningEvent, listener);
  object->AddObserver(vtkCommand::ErrorEvent, listener);
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
}
