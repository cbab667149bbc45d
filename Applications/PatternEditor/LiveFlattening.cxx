// SPDX-License-Identifier: BSD-3-Clause
#include "LiveFlattening.h"

#include <vtkCallbackCommand.h>

#include <chrono>

namespace editor
{
LiveFlattening::LiveFlattening()
{
  // What the filter says is shown in the window, by its status.
  vtkNew<vtkCallbackCommand> listener;
  listener->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  this->Filter->AddObserver(vtkCommand::WarningEvent, listener);
  this->Filter->AddObserver(vtkCommand::ErrorEvent, listener);
  this->Filter->CachingOn();
}

//------------------------------------------------------------------------------
void LiveFlattening::setSurface(vtkPolyData* surface)
{
  this->Filter->SetInputData(surface);
  this->Result = {};
  this->Message.clear();
  this->Seconds = 0.0;
}

//------------------------------------------------------------------------------
bool LiveFlattening::run(vtkPolyData* curves)
{
  const auto start = std::chrono::steady_clock::now();
  this->Filter->SetCurvesData(curves);
  this->Filter->Update();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  this->Seconds = passed.count();
  this->Message = this->Filter->GetStatusMessage();
  if (this->Filter->IsRefused())
  {
    return false;
  }
  for (auto [piece, port] : { std::pair(&this->Result.flat, 0), std::pair(&this->Result.wires, 1),
         std::pair(&this->Result.cut, 2) })
  {
    *piece = figures::PolyData::New();
    (*piece)->ShallowCopy(this->Filter->GetOutput(port));
  }
  return true;
}
}
