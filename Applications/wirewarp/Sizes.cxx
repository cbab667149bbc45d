// SPDX-License-Identifier: BSD-3-Clause
#include "Sizes.h"

#include "FlagWords.h"
#include "Seconds.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include <vtkPatternGrading.h>

#include <algorithm>
#include <chrono>

namespace wirewarp
{
namespace
{
/// The options for another surface, of which flat pieces and wires are asked for alone.
Options optionsOf(const Options& options, const std::string& surface)
{
  Options one = options;
  one.surface = surface;
  one.picture = {};
  one.resewing = {};
  one.pattern = {};
  one.quiet = true;
  return one;
}

void refuse(Flattening& result, const std::string& status, const std::string& message)
{
  const double seconds = result.secondsTotal;
  result = Flattening();
  result.exitCode = InputRefused;
  result.status = status;
  result.message = message;
  result.secondsTotal = seconds;
}

int unitValue(const std::string& unit)
{
  return unit == "mm" ? vtkPatternGrading::MILLIMETRE
    : unit == "m"     ? vtkPatternGrading::METRE
    : unit == "inch"  ? vtkPatternGrading::INCH
                      : vtkPatternGrading::CENTIMETRE;
}
}

//------------------------------------------------------------------------------
void gradeSizes(const Options& options, Flattening& result)
{
  const auto start = std::chrono::steady_clock::now();
  const vtkNew<vtkPatternGrading> grading;
  grading->SetBaseSize(options.pattern.size);
  grading->SetAlignmentCurve(options.sizes.alignment);
  grading->SetUnit(unitValue(result.unit));
  for (const SizeSurface& size : options.sizes.all(options.pattern.size))
  {
    if (size.surface.empty())
    {
      grading->AddSize(size.name, result.flat, result.wires);
      continue;
    }
    const Flattening other = flattenOne(optionsOf(options, size.surface), options.surface);
    if (other.refused())
    {
      refuse(result, other.status, "size " + inQuotes(size.name) + ": " + other.message);
      return;
    }
    if (other.exitCode != Done)
    {
      result.notes.push_back("size " + inQuotes(size.name) + ": " + other.message);
      result.exitCode = std::max(result.exitCode, other.exitCode);
    }
    if (other.unit != result.unit)
    {
      refuse(result, "UnreadableInput",
        "size " + inQuotes(size.name) + ": " + size.surface + " is in " + other.unit + " and " +
          options.surface + " in " + result.unit + "; state one unit with --unit");
      return;
    }
    grading->AddSize(size.name, other.flat, other.wires);
  }
  const VtkMessages messages;
  grading->Update();
  if (grading->IsRefused())
  {
    refuse(
      result, grading->GetStatusName(), messageOf(grading->GetStatusDefect(), remediesOf(grading)));
    return;
  }
  result.grading = grading->GetOutput();
  result.secondsTotal += secondsSince(start);
}
}
