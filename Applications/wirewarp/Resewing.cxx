// SPDX-License-Identifier: BSD-3-Clause
#include "Resewing.h"

#include "FieldRows.h"
#include "Flattening.h"
#include "NumberOptions.h"
#include "Progress.h"
#include "ReadSurface.h"
#include "VtkMessages.h"

#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkSewnShape.h>

#include <CLI/CLI.hpp>

#include <iomanip>
#include <limits>
#include <sstream>

namespace wirewarp
{
//------------------------------------------------------------------------------
ResewingRequest::ResewingRequest()
{
  const vtkNew<vtkSewnShape> sewn;
  this->thickness = sewn->GetThickness();
  this->maximumIterations = sewn->GetMaximumIterations();
  this->pressure = sewn->GetPressure();
  this->gravity.assign(sewn->GetGravity(), sewn->GetGravity() + 3);
  this->secondStart = sewn->GetSecondStart();
}

//------------------------------------------------------------------------------
void addResewing(CLI::App& app, ResewingRequest& request)
{
  app
    .add_option("--mode", request.test,
      "panel (each piece, its boundary held) or product (all that is sewn together, hems free)")
    ->transform(CLI::IsMember({ "panel", "product" }, CLI::ignore_case).description(""))
    ->type_name("MODE")
    ->default_str("panel");
  app
    .add_option("--gravity", request.gravity,
      "Weight of the cloth and where it pulls, such as 0 0 -0.0002 where z is up. Per area, times "
      "its size over its stiffness; a product needs a --body to lie on")
    ->check(number(-1.0, 1.0, "[-1, 1]"))
    ->expected(3)
    ->type_name("X Y Z");
  app
    .add_option("--pressure", request.pressure,
      "Pressure behind the cloth. Times its size over its stiffness; a product must be closed")
    ->check(number(-1.0, 1.0, "[-1, 1]"))
    ->type_name("P")
    ->capture_default_str();
  app
    .add_option("--thickness", request.thickness,
      "Thickness of a plate that bends as the cloth does, over the size of a piece")
    ->check(number(0.0, 1.0, "[0, 1]"))
    ->type_name("T")
    ->capture_default_str();
  app.add_flag_callback(
    "--once", [&request]() { request.secondStart = false; },
    "Sew from one start, in half the time. Other shapes at rest are not looked for");
  app
    .add_option("--sewing-iterations", request.maximumIterations,
      "Most iterations until the cloth is at rest")
    ->check(wholeNumber(1, std::numeric_limits<int>::max(), "from 1"))
    ->capture_default_str();
}

//------------------------------------------------------------------------------
void sewAgain(const ResewingRequest& request, const std::string& body, const std::string& material,
  bool quiet, Flattening& result)
{
  if (!request.any() || result.refused())
  {
    return;
  }
  const vtkNew<vtkSewnShape> sewn;
  sewn->SetInputData(result.flat);
  sewn->SetDesignData(result.cut);
  sewn->SetTest(request.test == "product" ? vtkSewnShape::PRODUCT : vtkSewnShape::PANEL);
  sewn->SetThickness(request.thickness);
  sewn->SetMaximumIterations(request.maximumIterations);
  sewn->SetPressure(request.pressure);
  sewn->SetGravity(request.gravity.data());
  sewn->SetMaterial(material.c_str());
  sewn->SetSecondStart(request.secondStart);
  if (!body.empty())
  {
    sewn->SetBodyData(readSurface(body).surface);
  }
  {
    const VtkMessages messages;
    const Progress progress(sewn, quiet);
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
    return;
  }
  result.sewn = sewn->GetOutput(0);
  const FieldRows field(result.sewn);
  for (vtkIdType row = 0; row < field.count("RunWarnings"); ++row)
  {
    result.notes.push_back(field.text("RunWarnings", row));
  }
}

//------------------------------------------------------------------------------
std::string resewingTable(const ResewingRequest& request, const Flattening& result)
{
  if (!result.sewn)
  {
    return "";
  }
  const FieldRows field(result.sewn);
  const vtkIdType shapes = field.count("DistanceMean");
  std::ostringstream text;
  text << std::setprecision(2) << '\n';
  for (vtkIdType row = 0; row < shapes; ++row)
  {
    const auto percent = [&](const char* array) { return 100.0 * field.number(array, row); };
    const bool product = request.test == "product";
    text << (product ? "product" : "piece");
    if (!product || shapes > 1)
    {
      text << ' ' << row + 1;
    }
    text << " sewn again: " << field.number("DistanceMean", row) << ' ' << result.unit
         << " from the surface in the mean (" << percent("RelativeDistanceMean")
         << " % of its size), " << field.number("DistanceP95", row) << " on 95 %, "
         << field.number("DistanceMax", row) << " at most; strained by " << percent("StrainP95")
         << " % on 95 %, " << percent("CompressedArea") << " % of it compressed\n";
  }
  return text.str();
}
}
