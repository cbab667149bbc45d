// SPDX-License-Identifier: BSD-3-Clause
#include "Resewing.h"

#include "Flattening.h"
#include "Options.h"
#include "Progress.h"
#include "ReadSurface.h"
#include "TableOptions.h"
#include "VtkMessages.h"

#include <vtkIdTypeArray.h>
#include <vtkMakeFlattenable.h>
#include <vtkNew.h>
#include <vtkSewnShape.h>

#include <iomanip>
#include <sstream>

namespace wirewarp
{
void addResewing(CLI::App& app, flattening::OptionValues& values)
{
  addOptions(app, { "Sewing Simulation", { "AreaBias", "Material" } }, values);
}

void sewAgain(const Options& options, Flattening& result)
{
  if (options.command != "sew" || result.refused())
  {
    return;
  }
  const vtkNew<vtkSewnShape> sewn;
  sewn->SetInputData(result.flat);
  sewn->SetDesignData(result.cut);
  sewn->SetOptions(options.resewing);
  sewn->SetMaterial(options.values.text("Material").c_str());
  if (!options.body.empty())
  {
    sewn->SetBodyData(readSurface(options.body).surface);
  }
  {
    const VtkMessages messages;
    const Progress progress(sewn, options.quiet);
    sewn->Update();
  }
  if (sewn->IsRefused() || (sewn->GetStatusCode() != vtkSewnShape::OK && result.exitCode == Done))
  {
    result.exitCode = sewn->IsRefused() ? InputRefused : Flawed;
    result.status = sewn->GetStatusName();
    result.remedies = remediesOf(sewn);
    result.message = messageOf(sewn->GetStatusDefect(), result.remedies);
    result.idKind = sewn->GetStatusIdKind();
    vtkIdTypeArray* const ids = sewn->GetStatusIds();
    result.ids.assign(ids->GetPointer(0), ids->GetPointer(ids->GetNumberOfValues()));
  }
  if (result.refused())
  {
    result.flat = result.wires = result.cut = result.curves = nullptr;
    result.flattenable = result.flattenableCurves = result.flatBefore = nullptr;
    result.tables = result.tablesBefore = PieceTables();
    result.curveTable = result.leftOutPieces = result.leftOutLines = noTable();
    result.shiftMeasures = noTable();
    return;
  }
  result.sewn = sewn->GetOutput(0);
  result.sewnShapes = sewn->GetShapes();
  const std::vector<std::string> warnings = textsOf(sewn->GetStatusWarnings());
  result.notes.insert(result.notes.end(), warnings.begin(), warnings.end());
}

std::string resewingTable(bool product, const Flattening& result)
{
  if (!result.sewn)
  {
    return "";
  }
  const vtkIdType shapes = result.sewnShapes->GetNumberOfRows();
  std::ostringstream text;
  text << std::setprecision(2) << '\n';
  for (vtkIdType row = 0; row < shapes; ++row)
  {
    const auto number = [&](const char* name) { return numberIn(result.sewnShapes, row, name); };
    const auto percent = [&](const char* name) { return 100.0 * number(name); };
    text << (product ? "product" : "piece");
    if (!product || shapes > 1)
    {
      text << ' ' << row + 1;
    }
    text << " sewn again: " << number("DistanceMean") << ' ' << result.unit
         << " from the surface in the mean (" << percent("RelativeDistanceMean")
         << " % of its size), " << number("DistanceP95") << " on 95 %, " << number("DistanceMax")
         << " at most; strained by " << percent("StrainP95") << " % on 95 %, "
         << percent("CompressedArea") << " % of it compressed\n";
  }
  return text.str();
}

void addReshaping(CLI::App& app, flattening::OptionValues& values)
{
  addOptions(app, { "Moving the Surface", { "Thickness" } }, values);
}

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

void setBody(const std::string& body, vtkFlatPieceAlgorithm* filter)
{
  auto* const reshaping = vtkMakeFlattenable::SafeDownCast(filter);
  if (reshaping && !body.empty())
  {
    reshaping->SetBodyData(readSurface(body).surface);
  }
}

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
