// SPDX-License-Identifier: BSD-3-Clause
#include "Resewing.h"

#include "Flattening.h"
#include "Input/ClothInput.h"
#include "Input/MappedSurface.h"
#include "Input/StatusWords.h"
#include "Options.h"
#include "Options/OptionStructures.h"
#include "Progress.h"
#include "ReadSurface.h"
#include "Report/FlatteningData.h"
#include "Report/SewingReport.h"
#include "Sewing/PieceSewing.h"
#include "TableOptions.h"

#include <iomanip>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

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
  flattening::OptionStructures structures;
  takeOptions(options.resewing, flattening::OptionOwner::Sewing, structures);
  flattening::SewingOptions& sewing = structures.sewing;
  const std::string material = options.values.text("Material");
  if (!material.empty())
  {
    sewing.material = flattening::readCloth(material).material;
  }
  const flattening::LoadedBody body = loadedBody(options.body);
  sewing.body = body.get();
  const DataSet& design = *result.cut;
  const flattening::SewnInput input =
    flattening::makeSewnInput(flattening::loadMappedSurface(design, result.flat.get(), nullptr),
      findColumn(result.flat->fieldArrays, "SeamPairs"));
  flattening::Status status = input.outcome.ok() ? body.outcome : input.outcome;
  flattening::SewingResult sewn;
  if (!status.refused())
  {
    Progress progress(options.quiet);
    sewn = flattening::sewPieces(
      input.cut, input.map.positions, sewing, progress.execution(options.threads));
    status = flattening::inInput(sewn.status, input.map.surface.input.cellOfTriangle);
  }
  if (status.refused() || (!status.ok() && result.exitCode == Done))
  {
    result.conclude(status);
  }
  if (result.refused())
  {
    result.flat = result.wires = result.cut = nullptr;
    result.tables = {};
    return;
  }
  const flattening::SewnArrays arrays = flattening::sewnArrays(*design.points, input, sewn);
  std::vector<std::string> warnings;
  const flattening::SurfaceArrays kept(design, warnings);
  DataSet data;
  data.points = std::make_shared<const Points3>(arrays.points);
  for (const flattening::Triangle& t : input.map.surface.input.triangles)
  {
    data.faces.add(t);
  }
  data.pointArrays = kept.points;
  dropNormals(data);
  setColumn(data.pointArrays, arrays.distance);
  data.cellArrays = copiedRows(kept.cells, input.map.surface.input.cellOfTriangle);
  setColumn(data.cellArrays, { "vtkOriginalCellIds", input.map.surface.input.cellOfTriangle });
  setColumns(data.cellArrays, arrays.cellArrays);
  data.fieldArrays = arrays.fieldArrays;
  setUnit(data, result.unitStated ? result.unit : std::string());
  result.sewn = std::make_shared<const DataSet>(std::move(data));
  result.sewnShapes = arrays.shapes;
  result.warnings.insert(result.warnings.end(), warnings.begin(), warnings.end());
  result.warnings.insert(result.warnings.end(), arrays.warnings.begin(), arrays.warnings.end());
}

std::string resewingTable(bool product, const Flattening& result)
{
  if (!result.sewn)
  {
    return "";
  }
  const std::size_t shapes = rowsOf(result.sewnShapes);
  std::ostringstream text;
  text << std::setprecision(2) << '\n';
  for (std::size_t row = 0; row < shapes; ++row)
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

flattening::LoadedBody loadedBody(const std::string& file)
{
  return file.empty() ? flattening::LoadedBody()
                      : flattening::loadBody(readTriangles(readSurface(file).surface));
}

std::string reshapingTable(const Flattening& result)
{
  const Table& measures = result.shiftMeasures;
  if (rowsOf(measures) == 0)
  {
    return "";
  }
  const auto number = [&measures](const char* name) { return numberIn(measures, 0, name); };
  std::ostringstream text;
  text << std::setprecision(3) << "\nsurface moved by " << number("ShiftMean") << ' ' << result.unit
       << " in the mean (" << 100.0 * number("RelativeShiftMean") << " % of its size), "
       << number("ShiftMax") << " at most: strain_p95 " << number("StrainBefore") << " -> "
       << number("StrainAfter") << '\n';
  return text.str();
}
}
