// SPDX-License-Identifier: BSD-3-Clause
#include "Files.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLPolyDataWriter.h>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <unistd.h>
#endif

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace figures
{
namespace
{
/// Waits until the bytes of a file are on the disk, so that a power cut between this and its
/// renaming leaves the earlier file whole.
bool bringToDisk(const std::string& path)
{
#if defined(__unix__) || defined(__APPLE__)
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  // EINVAL: a file system that cannot.
  const bool done = file >= 0 && (fsync(file) == 0 || errno == EINVAL);
  if (file >= 0)
  {
    close(file);
  }
  return done;
#else
  return !path.empty();
#endif
}
}

void silence(vtkObject* object)
{
  vtkNew<vtkCallbackCommand> listener;
  listener->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  object->AddObserver(vtkCommand::WarningEvent, listener);
  object->AddObserver(vtkCommand::ErrorEvent, listener);
}

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
  if (!written || !file || !bringToDisk(aside) || std::rename(aside.c_str(), path.c_str()) != 0)
  {
    std::remove(aside.c_str());
    throw std::runtime_error("cannot write " + path);
  }
}

void writePng(vtkRenderWindow* window, const std::string& path)
{
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  // By way of memory: libpng would tell of a full disk on its own.
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
  file.close();
  if (!file)
  {
    throw std::runtime_error("cannot write " + path);
  }
}
}
