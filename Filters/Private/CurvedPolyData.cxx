// SPDX-License-Identifier: BSD-3-Clause
#include "CurvedPolyData.h"

#include "PolyDataSets.h"

#include "vtkPolyData.h"

#include <utility>

namespace flattening::bridge
{
namespace
{
/// Loads the surface of the data unless it has been.
void loadSurfaceAnew(
  vtkPolyData* data, CoincidentPoints coincident, Defects defects, CurvedPolyData& source)
{
  const SurfaceOrigin origin(data);
  if (source.origin.sameAs(origin) && source.coincident == coincident && source.defects == defects)
  {
    return;
  }
  source.imprintedBy.reset();
  source.origin = {};
  source.surface = loadSurface(data, coincident, defects);
  source.coincident = coincident;
  source.defects = defects;
  if (source.surface.outcome.ok())
  {
    source.origin = origin;
  }
}
}

SurfaceOrigin::SurfaceOrigin(vtkPolyData* data)
  : Time(data->GetMTime())
  , Points(data->GetPoints())
  , Cells{ data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() }
  , Ghosts(data->GetCellData()->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()))
{
}

bool SurfaceOrigin::sameAs(const SurfaceOrigin& other) const
{
  return this->Time != 0 && this->Time == other.Time && this->Points == other.Points &&
    this->Cells == other.Cells && this->Ghosts == other.Ghosts;
}

void readCurvesOf(vtkPolyData* data, int source, CurveInput& curves)
{
  if (data->GetNumberOfLines() == 0)
  {
    return;
  }
  if (data->GetLines()->IsValid())
  {
    readCurves(dataSetOf(data), source, curves);
    return;
  }
  curves.outcome = { StatusCode::InvalidPointId,
    "the lines of the curves do not fit the list of their points", {}, { Remedy::WriteAgain } };
  curves.blamed = source;
}

void loadCurvedSurface(vtkPolyData* surface, const std::vector<vtkPolyData*>& curves,
  CoincidentPoints coincident, Defects defects, const ImprintOptions& options,
  const Execution& execution, CurvedPolyData& source)
{
  source.sources = { surface };
  source.sources.insert(source.sources.end(), curves.begin(), curves.end());
  source.warnings.clear();
  source.pointArrays = wholePointArrays(surface, source.warnings);
  source.cellArrays = wholeCellArrays(surface, source.warnings);
  source.fieldData = fieldArrays(surface, source.warnings);
  source.blamed = -1;
  loadSurfaceAnew(surface, coincident, defects, source);
  const std::vector<std::string>& mendings = source.surface.mendings;
  source.warnings.insert(source.warnings.end(), mendings.begin(), mendings.end());
  source.outcome = source.surface.outcome;
  if (!source.outcome.ok())
  {
    return;
  }
  CurveInput read;
  for (std::size_t k = 0; k < source.sources.size() && read.outcome.ok(); ++k)
  {
    readCurvesOf(source.sources[k], static_cast<int>(k), read);
  }
  imprintInput(std::move(read), options, execution, source);
}
}
