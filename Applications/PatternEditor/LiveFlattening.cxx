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
  this->Filter->ReleaseTrialsOff(); // the window shows no advice
}

//------------------------------------------------------------------------------
void LiveFlattening::setSurface(vtkPolyData* surface)
{
  this->Filter->SetInputData(surface);
  this->Result = {};
  this->Message.clear();
  this->Seconds = {};
}

//------------------------------------------------------------------------------
bool LiveFlattening::run(vtkPolyData* curves, Care care)
{
  care == Care::Draft ? this->Filter->SetSchemeToGlobal() : this->Filter->SetSchemeToIsometric();
  const auto start = std::chrono::steady_clock::now();
  this->Filter->SetCurvesData(curves);
  this->Filter->Update();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  this->Seconds[static_cast<std::size_t>(care)] = passed.count();
  this->Message = this->Filter->GetStatusMessage();
  if (this->Filter->IsRefused())
  {
    return false;
  }
  this->ResultCare = care;
  for (auto [piece, port] : { std::pair(&this->Result.flat, 0), std::pair(&this->Result.wires, 1),
         std::pair(&this->Result.cut, 2) })
  {
    *piece = figures::PolyData::New();
    (*piece)->ShallowCopy(this->Filter->GetOutput(port));
  }
  return true;
}
}
