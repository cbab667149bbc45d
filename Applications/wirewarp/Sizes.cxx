// SPDX-License-Identifier: BSD-3-Clause
#include "Sizes.h"

#include "FlagWords.h"
#include "Flattening.h"
#include "Options.h"
#include "Seconds.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include <vtkPatternGrading.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <set>

namespace wirewarp
{
namespace
{
/// The options for another surface, of which flat pieces and wires are asked for alone.
Options optionsOf(const Options& options, const std::string& surface, const Flattening& base)
{
  Options one = options;
  one.unitOtherwise = base.unit;
  one.surface = surface;
  one.picture = {};
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
    const Flattening other = flattenOne(optionsOf(options, size.surface, result), options.surface);
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

//------------------------------------------------------------------------------
std::vector<SizeSurface> SizeRequest::all(const std::string& base) const
{
  std::vector<SizeSurface> sizes;
  for (const std::string& text : this->texts)
  {
    const std::size_t sign = std::min(text.find('='), text.size());
    sizes.push_back(
      { text.substr(0, sign), sign < text.size() ? text.substr(sign + 1) : std::string() });
  }
  const bool placed = std::any_of(
    sizes.begin(), sizes.end(), [](const SizeSurface& size) { return size.surface.empty(); });
  if (!placed)
  {
    sizes.insert(sizes.begin(), { base, "" });
  }
  return sizes;
}

//------------------------------------------------------------------------------
std::string SizeRequest::fault(const std::string& base) const
{
  if (base.empty())
  {
    return "a size has no name; write SIZE=SURFACE";
  }
  std::set<std::string> names;
  const std::vector<SizeSurface> sizes = this->all(base);
  for (const SizeSurface& size : sizes)
  {
    if (size.name.empty() || (size.surface.empty() && size.name != base))
    {
      return inQuotes(size.name) + " is not a size; write SIZE=SURFACE";
    }
    if (!names.insert(size.name).second)
    {
      return "the size " + inQuotes(size.name) + " is named twice; leave one of them out";
    }
  }
  return "";
}

//------------------------------------------------------------------------------
void addSizes(
  CLI::App& app, std::vector<std::string>& words, SizeRequest& request, std::string& base)
{
  app
    .add_option("SIZE=SURFACE", words,
      "Surfaces of one connectivity by the names of their sizes, in order, and files of curves, "
      "which are of the base")
    ->type_name("...");
  app.add_option("--base", base, "The size whose curves are given (default: the first)")
    ->type_name("SIZE");
  app
    .add_option("--at", request.alignment,
      "Lay sizes on each other at the first point of this curve and along it (default: the first "
      "key curve within each piece; where there is none, as they fit the base best)")
    ->type_name("NAME");
}
}
