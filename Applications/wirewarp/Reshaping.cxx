// SPDX-License-Identifier: BSD-3-Clause
#include "Reshaping.h"

#include "Flattening.h"
#include "NumberOptions.h"
#include "ReadSurface.h"

#include <vtkMakeFlattenable.h>
#include <vtkNew.h>

#include <CLI/CLI.hpp>

#include <iomanip>
#include <sstream>

namespace wirewarp
{
//------------------------------------------------------------------------------
ReshapingRequest::ReshapingRequest()
{
  const vtkNew<vtkMakeFlattenable> filter;
  this->bound = filter->GetBound();
  this->keepBoundary = filter->GetKeepBoundary();
  this->outsideBias = filter->GetOutsideBias();
}

//------------------------------------------------------------------------------
void addReshaping(CLI::App& app, ReshapingRequest& request)
{
  app
    .add_option("--max-strain", request.bound,
      "The strain within which 95 % of each piece's area is to lie, as 0.02 or 2%")
    ->transform(percentage(1e-6, 0.99, "[1e-6, 0.99]"))
    ->type_name("STRAIN")
    ->capture_default_str();
  app.add_option("--keep", request.keep, "A curve that stays where it is; repeat it for the next")
    ->type_name("NAME")
    ->allow_extra_args(false);
  app.add_flag_callback(
    "--free-boundary", [&request]() { request.keepBoundary = false; }, "Move the boundary as well");
  app
    .add_option("--outward", request.outsideBias,
      "How much to move outward rather than inward; 0: both alike, 1: no point moves inward. "
      "Outward is where triangles turn counter-clockwise")
    ->check(number(0.0, 1.0, "[0, 1]"))
    ->type_name("SHARE")
    ->capture_default_str();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkWireWarpingFilter> makeReshapingFilter(const ReshapingRequest& request)
{
  const auto filter = vtkSmartPointer<vtkMakeFlattenable>::New();
  filter->SetBound(request.bound);
  filter->SetKeepBoundary(request.keepBoundary);
  filter->SetOutsideBias(request.outsideBias);
  for (const std::string& curve : request.keep)
  {
    filter->AddKeptCurve(curve);
  }
  return filter;
}

//------------------------------------------------------------------------------
void setBody(const std::string& body, vtkWireWarpingFilter* filter)
{
  auto* const reshaping = vtkMakeFlattenable::SafeDownCast(filter);
  if (reshaping && !body.empty())
  {
    reshaping->SetBodyData(readSurface(body).surface);
  }
}

//------------------------------------------------------------------------------
void takeReshaped(vtkWireWarpingFilter* filter, Flattening& result)
{
  if (auto* const reshaping = vtkMakeFlattenable::SafeDownCast(filter))
  {
    result.flattenable = filter->GetOutput(5);
    result.flattenableCurves = filter->GetOutput(6);
    result.flatBefore = filter->GetOutput(7);
    result.shiftMeasures = vtkTable::SafeDownCast(filter->GetOutputDataObject(9));
    result.shiftTrials = reshaping->GetTrials()->GetNumberOfRows();
  }
}

//------------------------------------------------------------------------------
std::string reshapingTable(const Flattening& result)
{
  vtkTable* const measures = result.shiftMeasures;
  if (measures->GetNumberOfRows() == 0)
  {
    return "";
  }
  const auto number = [measures](const char* name) { return numberIn(measures, 0, name); };
  std::ostringstream text;
  text << std::setprecision(3) << "\nsurface moved by " << number("ShiftMean") << ' ' << result.unit
       << " in the mean (" << 100.0 * number("RelativeShiftMean") << " % of its size), "
       << number("ShiftMax") << " at most: strain_p95 " << number("StrainBefore") << " -> "
       << number("StrainAfter") << '\n';
  return text.str();
}
}
