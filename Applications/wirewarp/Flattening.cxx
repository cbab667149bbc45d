// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening.h"

#include "FilterOptions.h"
#include "InputError.h"
#include "Progress.h"
#include "ReadCurves.h"
#include "ReadSurface.h"
#include "VtkMessages.h"

#include <vtkIdTypeArray.h>
#include <vtkTrivialProducer.h>
#include <vtkWireWarpingFilter.h>

#include <chrono>

namespace wirewarp
{
namespace
{
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Returns the file of each connection of curves.
std::vector<std::string> readInput(const Options& options, vtkWireWarpingFilter* filter)
{
  const SurfaceContents contents = readSurface(options.surface);
  filter->SetInputData(contents.surface);
  std::vector<std::string> files;
  const auto connect = [&](const std::string& path, vtkPolyData* curves) {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(curves);
    filter->AddCurvesConnection(producer->GetOutputPort());
    files.push_back(path);
  };
  if (contents.curves)
  {
    connect(options.surface, contents.curves);
  }
  for (const std::string& path : options.curves)
  {
    connect(path, readCurves(path, contents.surface));
  }
  for (const auto& [curve, tolerance] : options.tolerances)
  {
    filter->AddCurveTolerance(curve, tolerance);
  }
  return files;
}

void run(vtkWireWarpingFilter* filter, bool quiet, Flattening& result)
{
  const VtkMessages messages;
  {
    const Progress progress(filter, quiet);
    filter->Update();
  }
  result.flat = filter->GetOutput(0);
  result.wires = filter->GetOutput(1);
  result.cut = filter->GetOutput(2);
  if (filter->GetNumberOfOutputPorts() > 3)
  {
    result.curves = filter->GetOutput(3);
  }
  result.status = filter->GetStatusName();
  result.remedies = remediesOf(filter);
  result.message = messageOf(filter->GetStatusDefect(), result.remedies);
  result.idKind = filter->GetStatusIdKind();
  vtkIdTypeArray* const ids = filter->GetStatusIds();
  for (vtkIdType k = 0; k < ids->GetNumberOfValues(); ++k)
  {
    result.ids.push_back(ids->GetValue(k));
  }
  if (filter->IsRefused())
  {
    result.exitCode = InputRefused;
  }
  else if (filter->GetStatusCode() != vtkWireWarpingFilter::OK)
  {
    result.exitCode = PromiseBroken;
  }
  else if (!messages.errors().empty())
  {
    throw InputError(messages.firstError());
  }
}
}

//------------------------------------------------------------------------------
Flattening outOfMemory(const std::string& surface)
{
  Flattening result;
  result.exitCode = InputRefused;
  result.status = "OutOfMemory";
  result.message = surface + ": memory ran out around the flattening; " + wayOutOfMemory;
  return result;
}

//------------------------------------------------------------------------------
Flattening flattenOne(const Options& options)
{
  Flattening result;
  const Clock::time_point start = Clock::now();
  try
  {
    const vtkSmartPointer<vtkWireWarpingFilter> filter = makeFilter(options);
    filter->CachingOff(); // it runs once
    setOptions(options, filter);
    const std::vector<std::string> curveFiles = readInput(options, filter);
    result.secondsRead = secondsSince(start);
    run(filter, options.quiet, result);
    if (result.refused())
    {
      const int curves = filter->GetStatusConnection();
      const std::string& file = curves < 0 ? options.surface : curveFiles[curves];
      result.message = file + ": " + result.message;
    }
  }
  catch (const InputError& error)
  {
    result.exitCode = InputRefused;
    result.status = "UnreadableInput";
    result.message = error.what();
  }
  catch (const std::bad_alloc&)
  {
    result = outOfMemory(options.surface);
  }
  catch (const std::runtime_error&) // of TBB: no memory for a thread
  {
    result = outOfMemory(options.surface);
  }
  result.secondsTotal = secondsSince(start);
  return result;
}
}
