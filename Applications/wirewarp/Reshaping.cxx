// SPDX-License-Identifier: BSD-3-Clause
#include "Reshaping.h"

#include "Flattening.h"
#include "ReadSurface.h"
#include "TableOptions.h"

#include <vtkMakeFlattenable.h>

#include <iomanip>
#include <sstream>

namespace wirewarp
{
//------------------------------------------------------------------------------
void addReshaping(CLI::App& app, flattening::OptionValues& values)
{
  addOptions(app, { "Moving the Surface", { "Thickness" } }, values);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFlatPieceAlgorithm> makeReshapingFilter(const flattening::OptionValues& values)
{
  const auto filter = vtkSmartPointer<vtkMakeFlattenable>::New();
  filter->SetOptions(values);
  for (const std::string& curve : values.list("KeptCurves"))
  {
    filter->AddKeptCurve(curve);
  }
  return filter;
}

//------------------------------------------------------------------------------
void setBody(const std::string& body, vtkFlatPieceAlgorithm* filter)
{
  auto* const reshaping = vtkMakeFlattenable::SafeDownCast(filter);
  if (reshaping && !body.empty())
  {
    reshaping->SetBodyData(readSurface(body).surface);
  }
}

//------------------------------------------------------------------------------
void takeReshaped(vtkFlatPieceAlgorithm* filter, Flattening& result)
{
  if (auto* const reshaping = vtkMakeFlattenable::SafeDownCast(filter))
  {
    result.flattenable = filter->GetOutput(5);
    result.flattenableCurves = filter->GetOutput(6);
    result.flatBefore = filter->GetOutput(7);
    result.tablesBefore.pieces = vtkTable::SafeDownCast(filter->GetOutputDataObject(8));
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
