// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening.h"

#include "FlagNames.h"
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

int schemeValue(const std::string& name)
{
  if (name == "progressive")
  {
    return vtkWireWarpingFilter::PROGRESSIVE;
  }
  if (name == "isometric")
  {
    return vtkWireWarpingFilter::ISOMETRIC;
  }
  return name == "lscm" ? vtkWireWarpingFilter::LEAST_SQUARES_CONFORMAL
                        : vtkWireWarpingFilter::GLOBAL;
}

int interiorValue(const std::string& name)
{
  if (name == "laplacian")
  {
    return vtkWireWarpingFilter::LAPLACIAN;
  }
  return name == "relaxation" ? vtkWireWarpingFilter::RELAXATION
                              : vtkWireWarpingFilter::AS_RIGID_AS_POSSIBLE;
}

void configure(vtkWireWarpingFilter* filter, const Options& options)
{
  filter->CachingOff(); // it runs once
  filter->SetScheme(schemeValue(options.scheme));
  filter->SetSolver(options.solver == "sequential" ? vtkWireWarpingFilter::SEQUENTIAL
                                                   : vtkWireWarpingFilter::NEWTON);
  filter->SetInterior(interiorValue(options.interior));
  filter->SetReleaseKeys(options.releaseKeys);
  filter->SetCloseCuts(options.closeCuts);
  filter->SetSkipClosed(options.skipClosed);
  filter->SetDistortionEnergy(options.energy == "dirichlet"
      ? vtkWireWarpingFilter::SYMMETRIC_DIRICHLET
      : vtkWireWarpingFilter::RIGID);
  filter->SetAreaBias(options.areaBias);
  filter->SetAngleWeight(options.angleWeight);
  filter->SetIsometricMaximumIterations(options.isometricMaximumIterations);
  filter->SetIsometricTolerance(options.isometricTolerance);
  filter->SetMaximumIterations(options.maximumIterations);
  filter->SetClosureTolerance(options.closureTolerance);
  filter->SetOptimalityTolerance(options.optimalityTolerance);
  filter->SetRelaxationFactor(options.relaxationFactor);
  filter->SetRelaxationMovement(options.relaxationMovement);
  filter->SetRelaxationMinimumIterations(options.relaxationMinimumIterations);
  filter->SetRelaxationMaximumIterations(options.relaxationMaximumIterations);
  filter->SetRigidEnergyTolerance(options.rigidTolerance);
  filter->SetRigidMaximumIterations(options.rigidMaximumIterations);
  filter->SetConformalPins(options.pins[0], options.pins[1]);
  filter->SetSplitTriangles(options.split);
  filter->SetImprintTolerance(options.imprintTolerance);
  filter->SetSnapTolerance(options.snapTolerance);
  filter->SetArrange(options.arrange);
  filter->SetSpacing(options.spacing);
  filter->SetMaximumLengthError(options.maximumLengthError);
}

void readInput(const Options& options, vtkWireWarpingFilter* filter)
{
  const vtkSmartPointer<vtkPolyData> surface = readSurface(options.surface);
  filter->SetInputData(surface);
  for (const std::string& path : options.curves)
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(readCurves(path, surface));
    filter->AddCurvesConnection(producer->GetOutputPort());
  }
  for (const auto& [curve, tolerance] : options.tolerances)
  {
    filter->AddCurveTolerance(curve, tolerance);
  }
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
  result.status = filter->GetStatusName();
  result.message = withFlags(filter->GetStatusMessage());
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
Flattening flattenOne(const Options& options)
{
  Flattening result;
  const Clock::time_point start = Clock::now();
  try
  {
    vtkNew<vtkWireWarpingFilter> filter;
    configure(filter, options);
    readInput(options, filter);
    result.secondsRead = secondsSince(start);
    run(filter, options.quiet, result);
    if (result.refused())
    {
      const int curves = filter->GetStatusConnection();
      const std::string& file = curves < 0 ? options.surface : options.curves[curves];
      result.message = file + ": " + result.message;
    }
  }
  catch (const InputError& error)
  {
    result.exitCode = InputRefused;
    result.status = "UnreadableInput";
    result.message = error.what();
  }
  result.secondsTotal = secondsSince(start);
  return result;
}
}
