// SPDX-License-Identifier: BSD-3-Clause
#include "Report/SurfaceRun.h"

#include "Base/LengthUnit.h"
#include "Input/StatusWords.h"
#include "Report/PieceSizes.h"
#include "Report/ReportKeys.h"

#include <utility>

namespace flattening
{
SurfaceRun::SurfaceRun(DataSet given, const std::vector<DataSet>& lines, Status defect)
  : surface(std::move(given))
  , arrays(this->surface, this->source.warnings)
  , Defect(std::move(defect))
{
  this->read(this->surface, 0);
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    this->read(lines[k], static_cast<int>(k) + 1);
  }
}

bool SurfaceRun::load(const OptionStructures& options,
  const std::map<std::string, double>& tolerances, const std::string& weightArray,
  const Execution& execution)
{
  SurfaceTriangles triangles;
  triangles.outcome = this->Defect;
  triangles = this->Defect.ok() ? readTriangles(this->surface) : triangles;
  return this->run.load(
           std::move(triangles), std::move(this->curves), options, tolerances, execution) &&
    this->run.weigh(this->arrays.cells, weightArray);
}

void SurfaceRun::read(const DataSet& data, int number)
{
  if (this->curves.outcome.ok())
  {
    readCurves(data, number, this->curves);
  }
  const Column* const stated = findColumn(data.fieldArrays, "LengthUnit");
  const Unit known = stated && stated->rows() > 0 ? unitNamed(stated->text(0)) : Unit::Unspecified;
  if (this->unit.empty() && known != Unit::Unspecified)
  {
    this->unit = unitName(known);
    this->unitStated = true;
  }
}

namespace
{
void setField(Columns& fields, const char* name, const std::string& text)
{
  setColumn(fields, { name, std::vector<std::string>{ text } });
}
}

FlatteningReport reportFlattening(
  SurfaceRun& source, const FlatteningResult& result, const FlatteningOptions& options)
{
  FlatteningRun& run = source.run;
  FlatteningReport report;
  FlatteningData& data = report.data;
  data = flatteningData(source.arrays, run.source, result, options);
  const Column* const names = findColumn(data.flat.cellArrays, "PieceName");
  report.tables = ReportTables(run.source, result, source.unit,
    names && names->isText() ? std::get<std::vector<std::string>>(names->values)
                             : std::vector<std::string>());
  report.seconds = result.seconds;
  const std::string size = sizeWarning(pieceSizes(result), source.unit);
  setField(data.flat.fieldArrays, "RunStatus", statusName(run.status.code));
  setField(data.flat.fieldArrays, "RunStatusMessage", inWords(run.status));
  if (source.unitStated)
  {
    run.warn(size.empty() ? std::vector<std::string>() : std::vector<std::string>{ size });
    for (DataSet* const part : { &data.flat, &data.wires, &data.cut })
    {
      setField(part->fieldArrays, "LengthUnit", source.unit);
    }
  }
  return report;
}

ReportObject objectOf(const FlatteningReport& report)
{
  const StageSeconds& seconds = report.seconds;
  return {
    { "pieces", { pieceReports(report.tables) } },
    { "curves", { reportRows(report.tables.curves, reportKeys("CurveReport")) } },
    { "left_out", { reportRows(report.tables.leftOutPieces, reportKeys("LeftOut")) } },
    { "seconds",
      { ReportObject{ { "wires", { seconds.wires } }, { "interior", { seconds.interior } },
        { "quality", { seconds.quality } }, { "core", { seconds.total } },
        { "total", { seconds.total } } } } },
  };
}
}
