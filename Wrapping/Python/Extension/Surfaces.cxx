// SPDX-License-Identifier: BSD-3-Clause
// Curves drawn on a surface, and measures of surfaces and of flat pieces.
#include "Pieces.h"

#include "Conversions.h"

#include "Editing/ControlledCurve.h"
#include "Input/MappedSurface.h"
#include "Quality/BoundaryOverlap.h"
#include "Report/QualityReport.h"

#include <utility>

namespace flattening::python
{
namespace
{
using pybind11::literals::operator""_a;

LoadedSurface loaded(const py::dict& surface)
{
  return loadSurface(readTriangles(dataSetOf(surface)), CoincidentPoints::Automatic, Defects::Heal);
}

/// Status, and the points of each curve.
py::tuple drawCurves(
  const py::dict& given, const py::list& controls, int kind, bool closed, bool tight, double offset)
{
  LoadedSurface surface = loaded(given);
  std::vector<Points3> points;
  for (const py::handle list : controls)
  {
    points.push_back(*dataSetOf(py::dict("points"_a = list)).points);
  }
  Status status = surface.outcome;
  std::vector<EditedCurve> curves;
  if (status.ok())
  {
    const py::gil_scoped_release free;
    CurveControl control;
    control.kind = static_cast<SegmentKind>(kind);
    control.closed = closed;
    control.tight = tight;
    control.offset = offset;
    status = drawControlledCurves(
      DrawingSurface(std::move(surface.prepared.mesh)), points, control, curves);
  }
  py::list places;
  for (const EditedCurve& curve : status.refused() ? std::vector<EditedCurve>() : curves)
  {
    places.append(arrayOf<double>(pointsAlong(curve.segments)));
  }
  return py::make_tuple(tupleOf(status), status.refused(), places);
}

/// Status, measures, arrays of the triangles, and overlaps.
py::tuple measure(const py::dict& surface, const py::dict& flat)
{
  const DataSet inSpace = dataSetOf(surface);
  const DataSet inPlane = dataSetOf(flat);
  QualityReport report;
  Status status;
  {
    const py::gil_scoped_release free;
    const MappedSurface map = loadMappedSurface(inSpace, &inPlane, nullptr);
    status = map.outcome;
    if (!status.refused())
    {
      report = reportQuality(map, mostListedOverlaps, Execution());
    }
  }
  report.overlapEdges.name = "OverlapEdges";
  std::vector<ReportKey> keys;
  for (const ReportKey& key : reportKeys("PieceReport"))
  {
    if (findColumn(report.measures, key.column))
    {
      keys.push_back(key);
    }
  }
  return py::make_tuple(tupleOf(status), status.refused(),
    objectOf({ reportRows(report.measures, keys) }), dictOf(std::move(report.cells)),
    dictOf(Columns{ std::move(report.overlapEdges) }));
}

/// Status and values of the points.
py::tuple developability(const py::dict& given)
{
  const LoadedSurface surface = loaded(given);
  Column values{ "Developability", std::vector<double>() };
  if (!surface.outcome.refused())
  {
    values = developabilityOfPoints(surface, Execution());
  }
  return py::make_tuple(
    tupleOf(surface.outcome), surface.outcome.refused(), dictOf(Columns{ std::move(values) }));
}
}

void defineSurfaces(py::module_& module)
{
  module.def("draw_curves", &drawCurves);
  module.def("measure", &measure);
  module.def("developability", &developability);
}
}
